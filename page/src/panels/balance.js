// How far the energy is off, where it is: the step is too long for the motion, whatever its largest stable one.

import { scalar } from "../source/frame.js";
import { figures, quantity } from "../view/range.js";
import { h } from "./dom.js";

/** @typedef {import("../session.js").Session} Session */

const TOLD = 0.05; // of the energy turned over, as in the table of a run
const ROUNDING = 1e-4; // of the largest energy there is: below that nothing is said
const FORMS = ["kinetic", "gravity", "lost", "put_in"]; // nothing at the session's begin
const REFRESH = 250; // ms between two changes of the number: faster ones cannot be read

/** @returns {Map<string, [number, number]>} */
const nothing = () => new Map(FORMS.map((name) => [name, [0, 0]]));

/** The energies of one variant since its begin, or since time went back. */
export class Balance {
  constructor() {
    this.time = -Infinity;
    this.error = 0; // [J] the largest
    this.ranges = nothing();
  }

  /** @param {number} time @param {(name: string) => number} value of a scalar [J] */
  take(time, value) {
    if (time < this.time) Object.assign(this, { error: 0, ranges: nothing() });
    this.time = time;
    for (const name of [...FORMS, "elastic"]) {
      const now = value(name);
      const [low, high] = this.ranges.get(name) ?? [now, now];
      if (Number.isFinite(now)) this.ranges.set(name, [Math.min(low, now), Math.max(high, now)]);
    }
    const error = Math.abs(value("energy_error"));
    if (Number.isFinite(error) && error > this.error) this.error = error;
  }

  /** The largest error, of the largest change of one energy; 0 where it is rounding. */
  get share() {
    const ranges = [...this.ranges.values()];
    const turned = Math.max(...ranges.map(([low, high]) => high - low));
    const largest = Math.max(...ranges.flat().map(Math.abs));
    return turned > 0 && this.error > ROUNDING * largest ? this.error / turned : 0;
  }
}

/** @param {number} error [J] @param {number} share */
export const balanceText = (error, share) =>
  `energy off by up to ${quantity(error, "J")}, ${figures(100 * share)} % of what has changed: forces and places are ` +
  "as doubtful, take a shorter step";

export class BalanceNote {
  /** @param {Session} session */
  constructor(session) {
    this.session = session;
    this.host = h("div", { className: "numbers balance", id: "balance", hidden: true });
    this.host.title = "What no law accounts for: the error of method and step";
    /** @type {Balance[]} */ this.balances = [];
    this.written = -Infinity;
    session.on("layout", () => this.begin());
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
    parts.forEach((part, v) => this.balances[v].take(time, (name) => scalar(layout, part, name)));
    if (performance.now() - this.written < REFRESH) return;
    this.written = performance.now();
    const many = layout.variants.length > 1;
    const text = this.balances
      .map(({ error, share }, v) =>
        share > TOLD
          ? `${many ? `${layout.variants[v].label}: ` : ""}${balanceText(error, share)}`
          : "",
      )
      .filter(Boolean)
      .join("\n");
    this.host.hidden = !text;
    if (this.host.textContent !== text) this.host.textContent = text;
  }
}
