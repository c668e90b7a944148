// How far the energy is off, where it is: the step is too long for the motion, whatever its largest stable one.

import { scalar } from "../source/frame.js";
import { figures, quantity } from "../view/range.js";
import { h } from "./dom.js";

/** @typedef {import("../session.js").Session} Session */

const TOLD = 0.05; // of the energy turned over, as in the table of a run
const REFRESH = 250; // ms between two changes of the number: faster ones cannot be read

/** The largest error of a variant since its step was chosen, of the energy turned over since its begin: the server
 * counts both, so that a page opened late tells what others do. @param {number} off
 * @param {number} turned [J] */
export const shareOf = (off, turned) => (off > 0 && turned > 0 ? off / turned : 0);

/** @param {number} share @param {string} of a copy, or none */
export const balanceText = (share, of) =>
  `energy${of && ` of ${of}`} off by up to ${figures(100 * share)} %`;

export class BalanceNote {
  /** @param {Session} session */
  constructor(session) {
    this.session = session;
    this.host = h("div", { className: "numbers balance", id: "balance", hidden: true });
    this.written = -Infinity;
    session.on("frame", (frame) => this.show(frame));
  }

  /** @param {import("../source/frame.js").Frame} frame */
  show({ parts }) {
    const { layout } = this.session;
    if (!layout || parts.length !== layout.variants.length) return;
    if (performance.now() - this.written < REFRESH) return;
    this.written = performance.now();
    const known = parts.map((part, v) => {
      const off = scalar(layout, part, "energy_off");
      return { v, off, share: shareOf(off, scalar(layout, part, "energy_turned")) };
    });
    const worst = known.reduce((a, b) => (b.share > a.share ? b : a));
    const { label } = layout.variants[worst.v];
    const text = worst.share > TOLD ? balanceText(worst.share, parts.length > 1 ? label : "") : "";
    this.host.title =
      `${quantity(worst.off, "J")}, that part of the energy turned over, is in no law's work: the error of ` +
      "steps. Forces and places are as doubtful. Take a shorter step.";
    this.host.hidden = !text;
    if (this.host.textContent !== text) this.host.textContent = text;
  }
}
