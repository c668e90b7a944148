// The values that a visitor changes: by slider, by number, back by one, and back to the scene's own.

import { METHODS } from "./kernel.js";
import { saidOf } from "./typed.js";

/** @typedef {import("./kernel.js").Scene} Scene */
/** @typedef {import("./kernel.js").Rope} Rope */
/** @typedef {import("./kernel.js").Method} Method */
/** @typedef {"k" | "c" | "m" | "step" | "g" | "mu"} Name */
/** @typedef {{k: number, c: number, m: number, step: number, g: number, mu: number, method: Method}} Set in N/m,
 *   N s/m, kg (of all), s and m/s²; mu is of the first post */

const NAMES = /** @type {Name[]} */ (["k", "c", "m", "step", "g", "mu"]);
const PLAIN = ["g", "mu"]; // whose slider has the value itself, not its power of ten
const SHOWN = { k: 1, c: 1, m: 1, step: 1e3, g: 1, mu: 1 }; // a step is told in milliseconds
const FIGURES = 3; // to which a slider goes, so that what is shown is what holds
const SLIGHT = 0.01; // of the critical friction: what the slider's middle is where a scene has none

/** A scene's own value when the first one of its kind, which the slider has, goes from `own` to `now`: in proportion,
 * where they are equal to the last bit. Where the first is zero, those that are go with it, and the others stay.
 * @param {number} value @param {number} own @param {number} now */
export const scaled = (value, own, now) =>
  value === own ? now : own > 0 ? (now / own) * value : value;

export class Values {
  /** @param {(id: string) => HTMLElement} find @param {import("./typed.js").Typed} typed
   * @param {() => void} changed called when a value has changed */
  constructor(find, typed, changed) {
    this.find = find;
    this.typed = typed;
    this.changed = changed;
    /** @type {Set[]} */ this.before = []; // what Undo goes back to, the newest last
    /** @type {Set} */ this.own = { k: 1, c: 0, m: 1, step: 1, g: 0, mu: 0, method: METHODS[0] }; // the scene's
    this.now = { ...this.own };
    this.last = { ...this.own }; // what Undo will go back to when something changes
    this.unit = { k: 1, c: 1, m: 1, step: 1, g: 1, mu: 1 }; // the values in the sliders' middle
    for (const name of NAMES) {
      this.#slider(name).oninput = () => this.#slide(name);
      this.#field(name).onchange = () => this.#type(name);
      this.#slider(name).onchange = () => this.#commit();
    }
    this.#method().onchange = () => {
      this.now.method = /** @type {Method} */ (this.#method().value);
      this.#take();
    };
    find("undo").onclick = () => this.undo();
    find("own").onclick = () => this.set({ ...this.own });
  }

  /** @param {Name} name */
  #slider = (name) => /** @type {HTMLInputElement} */ (this.find(name));
  /** @param {Name} name */
  #field = (name) => /** @type {HTMLInputElement} */ (this.find(`${name}-shown`));
  #method = () => /** @type {HTMLSelectElement} */ (this.find("method"));

  /** Begin with a scene's own values. @param {Scene} scene @param {Rope} base the rope as it has them */
  choose(scene, base) {
    const live = base.stiffness.findIndex((value) => value > 0);
    const [stiff, mass] = [base.stiffness[live] ?? 0, Math.max(...base.mass)];
    const rubs = (base.vector[live] ?? 0) + (base.axial[live] ?? 0);
    const slight = Number((SLIGHT * 2 * Math.sqrt(stiff * mass)).toPrecision(1));
    const whole = base.mass.reduce((sum, one) => sum + one, 0);
    this.unit = { k: stiff, c: rubs || slight, m: whole, step: 1, g: 1, mu: 1 };
    this.own = {
      k: stiff,
      c: rubs,
      m: whole,
      step: scene.step,
      g: Math.hypot(...scene.gravity),
      mu: scene.posts[0]?.friction ?? 0,
      method: METHODS.find((method) => method === scene.method) ?? METHODS[0],
    };
    this.now = { ...this.own };
    this.last = { ...this.own };
    this.before = [];
    this.show();
  }

  /** Take new values, all at once. @param {Partial<Set>} values */
  set(values) {
    Object.assign(this.now, values);
    this.#take();
  }

  undo() {
    const back = this.before.pop();
    if (!back) return;
    this.now = { ...back };
    this.last = { ...back };
    this.#renew();
  }

  #take() {
    this.#commit();
    this.#renew();
  }

  #renew() {
    this.show();
    this.changed();
  }

  /** Keep what was, so that Undo finds it. */
  #commit() {
    const { now, last } = this;
    if (same(now, last)) return;
    this.before.push(last);
    this.last = { ...now };
    this.show();
  }

  /** @param {Name} name the slider that moves */
  #slide(name) {
    const place = Number(this.#slider(name).value);
    const none = name === "c" && this.#slider(name).value === this.#slider(name).min;
    if (PLAIN.includes(name)) this.now[name] = place;
    else if (none) this.now.c = 0;
    else {
      const unit = this.unit[name];
      const own = place === 0 && name !== "step"; // the middle is the scene's own, to the last bit
      this.now[name] = own ? unit : Number((10 ** place * unit).toPrecision(FIGURES));
    }
    this.#renew();
  }

  /** @param {Name} name the field in which a number was written */
  #type(name) {
    const [field, slider, scale] = [this.#field(name), this.#slider(name), SHOWN[name]];
    const { valueAsNumber: written, parentElement: beside } = field;
    const [low, high] = [slider.min, slider.max].map((end) =>
      PLAIN.includes(name) ? Number(end) : 10 ** Number(end) * this.unit[name],
    );
    const least = name === "c" ? 0 : low;
    const [what, unit] = [slider.ariaLabel ?? name, beside?.textContent?.trim() ?? ""];
    const said = saidOf(what, written, scale * least, scale * high, scale * this.now[name], unit);
    if (Number.isFinite(written)) this.now[name] = Math.min(Math.max(written / scale, least), high);
    this.#take();
    this.typed.say(field, said);
  }

  /** Bring sliders, fields and buttons to the values. */
  show() {
    this.typed.clear();
    const { now, own, before, unit } = this;
    for (const name of NAMES) {
      const value = now[name];
      const slider = this.#slider(name);
      const place = PLAIN.includes(name)
        ? value
        : value > 0
          ? Math.log10(value / unit[name])
          : slider.min;
      slider.value = String(place);
      this.#field(name).value = String(Number((SHOWN[name] * value).toPrecision(6)));
    }
    this.#method().value = now.method;
    /** @type {HTMLButtonElement} */ (this.find("undo")).disabled = before.length === 0;
    /** @type {HTMLButtonElement} */ (this.find("own")).disabled = same(now, own);
  }
}

/** @param {Set} a @param {Set} b */
function same(a, b) {
  return a.method === b.method && NAMES.every((name) => a[name] === b[name]);
}
