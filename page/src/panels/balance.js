// How far the energy is off, where it is: the step is too long for the motion, whatever its largest stable one.

import { scalar } from "../source/frame.js";
import { figures, quantity } from "../view/range.js";
import { h } from "./dom.js";

/** @typedef {import("../session.js").Session} Session */

const TOLD = 0.05; // of what has changed most, much as in the table of a run
const ROUNDING = 1e-4; // of the largest energy there is: below that nothing is said
const FORMS = ["kinetic", "gravity", "rubbed"]; // nothing at the session's begin
const REFRESH = 250; // ms between two changes of the number: faster ones cannot be read

/** @returns {Map<string, [number, number]>} */
const nothing = () => new Map(FORMS.map((name) => [name, [0, 0]]));

/** The energies of one variant since its begin, or since time went back: works of other laws than surfaces'
 * are not counted, as a false ledger of them is large itself. */
export class Balance {
  constructor() {
    this.time = -Infinity;
    this.error = 0; // [J] the largest
    this.last = this.base = 0; // [J] the error now, and when the step was chosen
    this.ranges = nothing();
  }

  /** Count from now on: another step has been chosen. */
  again() {
    this.base = this.last;
    this.error = 0;
  }

  /** @param {number} time @param {(name: string) => number} value of a scalar [J] */
  take(time, value) {
    if (time < this.time) Object.assign(this, { error: 0, base: 0, ranges: nothing() });
    this.time = time;
    for (const name of [...FORMS, "elastic"]) {
      const now = value(name);
      const [low, high] = this.ranges.get(name) ?? [now, now];
      if (Number.isFinite(now)) this.ranges.set(name, [Math.min(low, now), Math.max(high, now)]);
    }
    const now = value("energy_error");
    if (Number.isFinite(now)) this.error = Math.max(this.error, Math.abs(now - this.base));
    if (Number.isFinite(now)) this.last = now;
  }

  /** The largest error, of the largest change of one energy; 0 where it is rounding. */
  get share() {
    const ranges = [...this.ranges.values()];
    const turned = Math.max(...ranges.map(([low, high]) => high - low));
    const largest = Math.max(...ranges.flat().map(Math.abs));
    return turned > 0 && this.error > ROUNDING * largest ? this.error / turned : 0;
  }
}

/** @param {number} share @param {string} of a copy, or none */
export const balanceText = (share, of) =>
  `energy${of && ` of ${of}`} off by up to ${figures(100 * share)} %`;

export class BalanceNote {
  /** @param {Session} session */
  constructor(session) {
    this.session = session;
    this.host = h("div", { className: "numbers balance", id: "balance", hidden: true });
    /** @type {Balance[]} */ this.balances = [];
    this.written = -Infinity;
    session.on("layout", () => this.begin());
    session.on("stability", () => this.balances.forEach((one) => one.again()));
    session.on("frame", (frame) => this.show(frame));
  }

  begin() {
    const { layout } = this.session;
    const count = layout?.variants.length ?? 0;
    if (count !== this.balances.length)
      this.balances = Array.from({ length: count }, () => new Balance());
  }

  /** @param {import("../source/frame.js").Frame} frame */
  show({ time, parts }) {
    const { layout } = this.session;
    if (!layout || parts.length !== this.balances.length) return;
    parts.forEach((part, v) => {
      const rubbed = part.frictionWork.reduce((sum, work) => sum + Math.abs(work), 0);
      const value = (/** @type {string} */ name) => scalar(layout, part, name);
      this.balances[v].take(time, (name) => (name === "rubbed" ? rubbed : value(name)));
    });
    if (performance.now() - this.written < REFRESH) return;
    this.written = performance.now();
    const worst = this.balances.reduce((a, b) => (b.share > a.share ? b : a));
    const { label } = layout.variants[this.balances.indexOf(worst)];
    const text = worst.share > TOLD ? balanceText(worst.share, parts.length > 1 ? label : "") : "";
    this.host.title =
      `${quantity(worst.error, "J")}, that part of what has changed most, is in no law's work: the error of ` +
      "steps. Forces and places are as doubtful. Take a shorter step.";
    this.host.hidden = !text;
    if (this.host.textContent !== text) this.host.textContent = text;
  }
}
