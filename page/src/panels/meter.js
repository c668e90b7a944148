// The stability meter: how near the step is to the largest stable one, always in sight.

import { figures, quantity } from "../view/range.js";
import { h } from "./dom.js";

/** @typedef {import("../session.js").Session} Session */
/** @typedef {import("../source/protocol.js").Stability} Stability */

const END = 1.25; // ratio at the bar's right end

export class Meter {
  /** @param {Session} session @param {HTMLElement} host */
  constructor(session, host) {
    this.session = session;
    this.host = host;
    session.on("stability", (variants) => this.show(variants));
    session.on("layout", () => this.show(session.stability));
  }

  /** @param {Stability[]} variants */
  show(variants) {
    const many = variants.length > 1;
    this.host.hidden = variants.length === 0;
    this.host.classList.toggle("many", many);
    this.host.replaceChildren(...variants.map((one, v) => this.row(one, v, many)));
  }

  /** @param {Stability} one @param {number} v @param {boolean} many */
  row(one, v, many) {
    const { ratio, zone } = one;
    const unbounded = one.bound === null;
    const label = this.session.layout?.variants[v]?.label;
    const fill = h("div", { className: "fill" });
    fill.style.width = `${100 * Math.min(1, (ratio ?? END) / END)}%`;
    const tick = h("div", { className: "tick" });
    tick.style.left = `${100 / END}%`;
    const amber = h("div", { className: "amber-zone" });
    amber.style.left = `${90 / END}%`;
    amber.style.width = `${10 / END}%`;
    const red = h("div", { className: "red-zone" });
    red.style.left = `${100 / END}%`;
    const bar = h(
      "div",
      {
        className: "meter-bar",
        role: "meter",
        "aria-label": "Step as a part of the largest stable step",
        "aria-valuemin": "0",
        "aria-valuemax": "1.25",
        "aria-valuenow": String(ratio ?? (unbounded ? 0 : END)),
        "aria-valuetext": one.verdict,
      },
      ...(unbounded ? [] : [fill, amber, red, tick]), // no bound, no red zone
    );
    /** @type {[string, string][]} */ const facts = [];
    if (one.bound === null) facts.push([one.verdict, "why"]);
    else if (one.bound > 0) facts.push([`largest step ${quantity(one.bound, "s")}`, "step"]);
    if (one.largest_spring_constant !== null) {
      facts.push([`largest spring constant ${quantity(one.largest_spring_constant, "N/m")}`, "k"]);
    } else if (one.largest_axial_stiffness !== null) {
      facts.push([`largest EA ${quantity(one.largest_axial_stiffness, "N")}`, "k"]);
    }
    return h(
      "div",
      { className: `meter-row ${zone}`, title: one.verdict, data: { zone } },
      h("span", { className: "meter-name" }, many && label ? label : "Stability"),
      bar,
      h(
        "strong",
        { className: "meter-ratio" },
        unbounded ? "no bound" : ratio === null ? "no stable step" : percent(ratio),
      ),
      ...facts.map(([fact, kind]) => h("span", { className: `meter-fact ${kind}` }, fact)),
    );
  }
}

/** @param {number} ratio */
function percent(ratio) {
  if (ratio >= 10) return `${figures(ratio)} times the bound`;
  return `${figures(100 * ratio)} % of the bound`;
}
