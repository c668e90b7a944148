// Controllers of the panel beyond lil-gui's own: quantities with a slider and unit, and vectors.

import { Controller } from "lil-gui";

import { unitText } from "../view/range.js";
import { h } from "./dom.js";
import { fieldText, noNumber, placeOf, readNumber, valueAt } from "./scale.js";

/** @typedef {import("lil-gui").GUI} GUI */
/** @typedef {import("../source/protocol.js").Parameter} Parameter */

const NOTCHES = 1000;
const THIRD = 9; // letters that fit into one of three fields

// lil-gui's types leave out the constructor that its own controllers use.
const Base = /** @type {any} */ (Controller);

/** A number: a slider over the sensible range and a field for any allowed value. */
export class QuantityController extends Base {
  /** @param {GUI} parent @param {{value: number | null}} object @param {Parameter} parameter */
  constructor(parent, object, parameter) {
    super(parent, object, "value", "quantity");
    this.parameter = parameter;
    this.refused = (/** @type {string} */ fault) => {}; // told what is wrong with what was typed, "" for nothing
    this.sliding = false;
    this.slider = h("input", {
      type: "range",
      min: "0",
      max: String(NOTCHES),
      step: "1",
      "aria-label": parameter.label,
      oninput: () => {
        this.sliding = true;
        this.setValue(valueAt(this.scale, Number(this.slider.value) / NOTCHES));
      },
      onchange: () => {
        this.sliding = false;
        this._callOnFinishChange();
      },
    });
    this.field = h("input", {
      type: "text",
      inputMode: "decimal",
      spellcheck: false,
      autocomplete: "off",
      "aria-label": `${parameter.label} [${parameter.unit}]`,
      onchange: () => this.commit(),
      onblur: () => this.updateDisplay(),
      onkeydown: (/** @type {KeyboardEvent} */ event) => {
        if (event.key === "Enter") this.commit();
      },
    });
    this.$widget.append(this.slider, this.field);
    this.updateDisplay();
  }

  get scale() {
    const { low, high, scale, kind } = /** @type {Parameter} */ (this.parameter);
    return { low, high, scale, whole: kind === "whole" };
  }

  commit() {
    const now = this.getValue();
    const shown = now !== null && this.field.value === fieldText(now); // rounded, so not taken for a wish
    const value = shown ? now : readNumber(this.field.value);
    if (Number.isFinite(value) && value !== now) {
      this.setValue(value);
      return;
    }
    this.refused(shown ? "" : noNumber(this.field.value, unitText(this.parameter.unit)));
    this.updateDisplay();
  }

  updateDisplay() {
    const value = this.getValue();
    if (!this.sliding)
      this.slider.value = String(value === null ? 0 : NOTCHES * placeOf(this.scale, value));
    const text = value === null ? "" : fieldText(value);
    if (document.activeElement !== this.field || this.sliding) {
      this.field.value = text;
      this.field.placeholder = value === null ? "differ" : "";
    }
    const whole = value === null ? "" : String(value);
    this.field.toggleAttribute("title", text !== whole); // without one it has that of its row
    if (text !== whole) this.field.title = whole;
    return this;
  }

  /** @param {boolean} on */
  disable(on = true) {
    this.slider.disabled = this.field.disabled = on;
    return super.disable(on);
  }
}

/** Three numbers, as for gravity and wind. */
export class VectorController extends Base {
  /** @param {GUI} parent @param {{value: number[]}} object @param {Parameter} parameter */
  constructor(parent, object, parameter) {
    super(parent, object, "value", "vector");
    this.refused = (/** @type {string} */ fault) => {}; // told as that of one number is
    this.unit = unitText(parameter.unit);
    this.fields = ["x", "y", "z"].map((axis) =>
      h("input", {
        type: "text",
        inputMode: "decimal",
        spellcheck: false,
        autocomplete: "off",
        "aria-label": `${parameter.label} ${axis} [${parameter.unit}]`,
        onchange: () => this.commit(),
        onblur: () => this.updateDisplay(),
        onkeydown: (/** @type {KeyboardEvent} */ event) => {
          if (event.key === "Enter") this.commit();
        },
      }),
    );
    this.$widget.append(...this.fields);
    this.updateDisplay();
  }

  commit() {
    const now = this.getValue() ?? [];
    const values = this.fields.map(
      (/** @type {HTMLInputElement} */ { value }, /** @type {number} */ i) =>
        value === this.text(now[i]) ? now[i] : readNumber(value),
    );
    if (values.every(Number.isFinite)) {
      this.setValue(values);
      return;
    }
    const typed = this.fields.map((/** @type {HTMLInputElement} */ { value }) => value);
    const faults = typed.map((/** @type {string} */ one) => noNumber(one, this.unit));
    this.refused(faults.find(Boolean) ?? "");
    this.updateDisplay();
  }

  updateDisplay() {
    const value = this.getValue() ?? ["", "", ""];
    this.fields.forEach((/** @type {HTMLInputElement} */ field, /** @type {number} */ i) => {
      if (document.activeElement === field) return;
      field.value = this.text(value[i]);
      field.title = `${"xyz"[i]}: ${value[i]}`;
    });
    return this;
  }

  /** @param {any} value */
  text(value) {
    return typeof value === "number" ? fieldText(value, THIRD) : "";
  }

  /** @param {boolean} on */
  disable(on = true) {
    for (const field of this.fields) field.disabled = on;
    return super.disable(on);
  }
}

/** A switch; neither on nor off where ropes differ. @param {GUI} parent
 * @param {{value: boolean | null}} holder */
export function addFlag(parent, holder) {
  const { value } = holder;
  holder.value = value ?? false; // lil-gui takes no switch without a value
  /** @type {any} */ const controller = parent.add(holder, "value");
  const display = controller.updateDisplay.bind(controller);
  controller.updateDisplay = () => {
    display();
    controller.$input.indeterminate = holder.value === null;
    return controller;
  };
  holder.value = value;
  return controller;
}
