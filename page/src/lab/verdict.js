// Whether a rope is broken, as the Python verdict has it: not finite, stretched beyond reason, deep in a post,
// or with energy that nothing gave it.

import { energies, size } from "./measures.js";

/** @typedef {import("./kernel.js").Rope} Rope */
/** @typedef {"" | "far" | "energy" | "through"} Break "": it is whole */

const LONGEST = 10; // a segment stretched more than this, and than its weight explains, is a broken simulation
const WEIGHTS = 3; // times what all weight stretches the softest segment by come on top
const MADE_UP = 3; // energy that nothing gave, over all that there can honestly be
const FURTHEST = 1e154; // the square of a longer one is infinite [m]

/** What of a rope's energy can turn over by its weight, and a little without [J]. @param {Rope} rope */
function turnover(rope) {
  let [mass, length, elastic] = [0, 0, 0];
  for (const one of rope.mass) mass += one;
  for (const [j, one] of rope.length.entries()) {
    length += one;
    elastic += 0.5 * rope.stiffness[j] * one * one;
  }
  return Math.hypot(...rope.gravity) * mass * length + 1e-6 * elastic;
}

/** How many times its length a segment may be. @param {Rope} rope */
export function longest(rope) {
  const softest = Math.min(
    ...rope.stiffness.map((k, j) => k * rope.length[j] || Infinity), // not the gap between ropes
  );
  const mass = rope.mass.reduce((sum, one) => sum + one, 0);
  return LONGEST + (WEIGHTS * Math.hypot(...rope.gravity) * mass) / softest;
}

/** @param {Rope} rope */
const total = (rope) => {
  const { kinetic, elastic, gravity } = energies(rope);
  return kinetic + elastic + gravity;
};

export class Verdict {
  /** @param {Rope} rope as it begins */
  constructor(rope) {
    const { kinetic, elastic } = energies(rope);
    this.zero = total(rope); // from which gains count [J]
    this.honest = kinetic + elastic; // what there can honestly be, weight apart [J]
    const rows = rope.anchors.length + 1; // the hand last
    this.work = new Float64Array(rows); // what each has done so far [J]
    this.most = new Float64Array(rows); // and at its most: at a period's end it is zero again
    this.before = Array.from({ length: rows }, () => new Float64Array(6)); // place and velocity
  }

  /** Count as given what somebody changes about a rope. @param {Rope} rope @param {() => void} change */
  allow(rope, change) {
    const before = total(rope);
    change();
    const more = total(rope) - before;
    this.zero += more;
    this.honest += Math.abs(more);
  }

  /** Let a rope take a step, and book what anchors and the hand do in it.
   * @param {Rope} rope @param {() => void} step */
  watch(rope, step) {
    const led = [
      ...rope.anchors.map(({ node, held }) => (held ? node : -1)),
      rope.hand?.node ?? -1,
    ];
    for (const [row, node] of led.entries()) {
      if (node < 0) continue;
      for (let k = 0; k < 3; k++) {
        this.before[row][k] = rope.x[k][node];
        this.before[row][3 + k] = rope.v[k][node];
      }
    }
    step();
    for (const [row, node] of led.entries()) {
      if (node < 0 || rope.inverse[node] > 0) continue; // let go within the step
      for (let k = 0; k < 3; k++) {
        const [moved, speed] = [rope.x[k][node] - this.before[row][k], rope.v[k][node]];
        const against = rope.force(node, k) + rope.mass[node] * rope.gravity[k];
        this.work[row] -= against * moved;
        this.work[row] += 0.5 * rope.mass[node] * (speed ** 2 - this.before[row][3 + k] ** 2);
      }
      this.most[row] = Math.max(this.most[row], Math.abs(this.work[row]));
    }
  }

  /** What is broken about a rope, if something is. @param {Rope} rope @returns {Break} */
  judge(rope) {
    const most = longest(rope);
    for (let j = 0; j < rope.n - 1; j++) {
      const live = rope.length[j] > 0 && rope.stiffness[j] > 0;
      if (!(size(rope, j) <= (live ? most * rope.length[j] : FURTHEST))) return "far";
    }
    if (rope.v.some((row) => row.some((value) => !Number.isFinite(value)))) return "far";
    if (rope.contact?.through()) return "through";
    const given = this.most.reduce((sum, one) => sum + one, this.honest + turnover(rope));
    return this.gain(rope) <= MADE_UP * given ? "" : "energy";
  }

  /** What a rope has more than it began with, and than was given by changes [J]. @param {Rope} rope */
  gain(rope) {
    return total(rope) - this.zero;
  }
}
