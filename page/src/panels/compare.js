// Comparing copies of a scene with other constants, overlaid or side by side.

import { css } from "../view/colours.js";
import { colourOf } from "../view/copies.js";
import { PLAYING, scalar } from "../source/frame.js";
import { quantity, unitText } from "../view/range.js";
import { dialog, h } from "./dom.js";
import { fieldText, noNumber, readNumber } from "./scale.js";
import { placeOn } from "../view/cards.js";

/** @typedef {import("../viewport.js").Viewport} Viewport */
/** @typedef {import("../source/protocol.js").Parameter} Parameter */
/** `fault`: what is wrong with what was typed. @typedef {{name: string, value: any, fault?: string}} Change */

const IDEAS = ["bdf2", "rk4"]; // methods worth a first comparison
const MOST = 3; // copies besides the scene itself

export class Compare {
  /** @param {Viewport} viewport @param {HTMLElement} host dialogs @param {HTMLElement} scene cards
   * @param {(plain: boolean) => void} colours */
  constructor(viewport, host, scene, colours) {
    this.viewport = viewport;
    this.colours = colours;
    /** @type {Change[]} */ this.changes = [];
    this.rows = h("div", { className: "compare-rows" });
    this.fault = h("p", { className: "fault", hidden: true, role: "alert" });
    this.add = h(
      "button",
      { type: "button", className: "second", onclick: () => this.addRow() },
      "One more copy",
    );
    this.apart = h(
      "select",
      {
        id: "compare-way",
        "aria-label": "How copies are shown",
        onchange: () => this.viewport.setApart(this.apart.value === "apart"),
      },
      h("option", { value: "over" }, "overlaid"),
      h("option", { value: "apart" }, "side by side"),
    );
    this.stop = h(
      "button",
      { type: "button", className: "second", id: "compare-end", onclick: () => this.end() },
      "End the comparison",
    );
    this.window = dialog(
      "Compare",
      "compare",
      h(
        "p",
        {},
        "Copies of this scene run beside it with one constant changed, moved by the same hand.",
      ),
      this.rows,
      this.fault,
      h(
        "div",
        { className: "row" },
        this.add,
        h("span", { className: "gap" }),
        this.stop,
        h(
          "button",
          { type: "button", className: "main", id: "compare-start", onclick: () => this.start() },
          "Compare",
        ),
      ),
    );
    host.append(this.window);
    this.lines = h("div", {});
    this.card = h(
      "div",
      { className: "card difference", hidden: true, id: "difference" },
      h(
        "div",
        { className: "row" },
        h("strong", {}, "Copies"),
        this.apart,
        h(
          "button",
          { type: "button", className: "second small", onclick: () => this.end() },
          "End",
        ),
      ),
      this.lines,
    );
    scene.append(this.card);
    viewport.card = () => this.place();
    this.lastShown = 0;
    this.wasMany = false;
    this.fresh = false; // the card has come and may lie over a rope
    viewport.session.on("layout", () => this.layout());
    viewport.session.on("frame", () => this.show());
  }

  open() {
    const known = new Set(this.choices.map(({ name }) => name)); // another scene has others
    this.changes = this.changes.filter(({ name }) => known.has(name));
    if (!this.changes.length) this.changes = this.suggested();
    this.fill();
    this.stop.hidden = !this.wasMany;
    this.window.showModal();
  }

  /** A first idea: another method that bears the step, or half the step. @returns {Change[]} */
  suggested() {
    const { parameters, status, stability } = this.viewport.session;
    const method = parameters.find((p) => p.name === "method");
    const steps = stability[0]?.steps ?? {};
    const others = (method?.choices ?? []).map(({ value }) => value);
    const bears = (/** @type {string} */ value) => (steps[value] ?? Infinity) > (status?.dt ?? 0);
    const other = IDEAS.find((value) => value !== method?.value && others.includes(value));
    if (other && bears(other)) return [{ name: "method", value: other }];
    return status ? [{ name: "time_step", value: status.dt / 2 }] : [];
  }

  get choices() {
    return this.viewport.session.parameters.filter((p) => p.kind !== "vector" && p.enabled);
  }

  addRow() {
    const { status } = this.viewport.session;
    this.changes.push({ name: "time_step", value: status ? status.dt / 2 : 0.001 });
    this.fill();
  }

  fill() {
    this.add.disabled = this.changes.length >= MOST;
    this.rows.replaceChildren(...this.changes.map((change, i) => this.row(change, i)));
  }

  /** @param {Change} change @param {number} i */
  row(change, i) {
    const chosen = this.choices.find((p) => p.name === change.name) ?? this.choices[0];
    const which = h(
      "select",
      {
        "aria-label": `What copy ${i + 1} changes`,
        onchange: () => {
          const parameter = this.choices.find((p) => p.name === which.value);
          this.changes[i] = { name: which.value, value: parameter?.value };
          this.fill();
        },
      },
      ...this.choices.map((p) => h("option", { value: p.name, selected: p === chosen }, p.label)),
    );
    const remove = h(
      "button",
      {
        type: "button",
        className: "second small",
        "aria-label": `Remove copy ${i + 1}`,
        onclick: () => {
          this.changes.splice(i, 1);
          this.fill();
        },
      },
      "Remove",
    );
    return h("div", { className: "row" }, which, this.valueField(chosen, change), remove);
  }

  /** @param {Parameter} parameter @param {Change} change */
  valueField(parameter, change) {
    if (parameter.kind === "choice" || parameter.kind === "flag") {
      const choices =
        parameter.choices ?? [true, false].map((value) => ({ value, label: value ? "yes" : "no" }));
      const select = h(
        "select",
        {
          "aria-label": parameter.label,
          onchange: () => (change.value = choices[select.selectedIndex].value),
        },
        ...choices.map(({ value, label }) =>
          h("option", { selected: value === change.value }, label),
        ),
      );
      if (select.selectedIndex >= 0) change.value = choices[select.selectedIndex].value;
      return select;
    }
    const field = h("input", {
      type: "text",
      inputMode: "decimal",
      "aria-label": parameter.label,
      value: typeof change.value === "number" ? fieldText(change.value) : "",
      oninput: () => {
        change.value = readNumber(field.value);
        change.fault = noNumber(field.value, unitText(parameter.unit));
      },
    });
    return h("label", {}, field, unitText(parameter.unit));
  }

  /** @param {Change} change */
  label({ name, value }) {
    const parameter = this.viewport.session.parameters.find((p) => p.name === name);
    if (parameter?.kind === "choice" || typeof value !== "number") return String(value);
    return `${parameter?.label ?? name} ${quantity(value, parameter?.unit)}`;
  }

  async start() {
    const variants = this.changes.map((change) => ({
      label: this.label(change),
      changes: { [change.name]: change.value },
    }));
    try {
      const typed = this.changes.find(({ fault }) => fault);
      if (typed) throw { text: typed.fault };
      await this.viewport.session.ask({ type: "compare", variants });
      this.fault.hidden = true;
      this.window.close();
    } catch (fault) {
      this.fault.textContent = /** @type {{text: string}} */ (fault).text;
      this.fault.hidden = false;
    }
  }

  async end() {
    this.window.close();
    await this.viewport.session.tell({ type: "compare", variants: [] });
  }

  layout() {
    const layout = /** @type {import("../source/protocol.js").Layout} */ (
      this.viewport.session.layout
    );
    const many = layout.variants.length > 1;
    this.card.hidden = !many;
    if (many !== this.wasMany) this.colours(many);
    if (many && !this.wasMany) this.fresh = true;
    this.wasMany = many;
    this.lastShown = -Infinity; // the lines are empty
    this.lines.replaceChildren(
      ...layout.variants.map((variant, v) => {
        const dot = h("i", {});
        dot.style.background = css(colourOf(layout, v, 0));
        return h("div", { className: "line" }, dot, h("span", {}, variant.label), h("output", {}));
      }),
    );
  }

  /** Where the card lies in the scene, if it is there. @returns {DOMRect | null} */
  place() {
    return placeOn(this.card, this.viewport.renderer.canvas);
  }

  show() {
    const { layout, frame } = this.viewport.session;
    const now = performance.now();
    if (!layout || !frame || this.card.hidden) return;
    const playing = frame.flags & PLAYING; // else no further frame may come
    if (playing && now - this.lastShown < 200 && !this.fresh) return;
    this.lastShown = now;
    frame.parts.forEach((part, v) => {
      const output = this.lines.children[v]?.querySelector("output");
      if (!output || v === 0) return;
      const rms = quantity(scalar(layout, part, "difference"), "m");
      const most = quantity(scalar(layout, part, "difference_max"), "m");
      output.textContent = `differs by ${rms} rms, ${most} at most`;
    });
    if (this.fresh) this.viewport.uncover();
    this.fresh = false;
  }
}
