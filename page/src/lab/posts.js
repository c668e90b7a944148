// What a class reads of a post: the tensions on both sides of it, their ratio, and how far round it the rope goes.

import { LITTLE, told } from "./measures.js";
import { turnAt } from "./polygon.js";
import { probe } from "./solids.js";

/** @typedef {import("./kernel.js").Rope} Rope */
/** @typedef {{sides: [number, number], nodes: [number, number], post: import("./solids.js").Post, ratio: number,
 *   angle: number}} Reading tensions of the segments beside the nodes that touch [N], the nodes at their other ends,
 *   the larger over the smaller, NaN where one does not pull, and by how much the rope turns between them [rad] */

const NOTHING = 1e-6; // of the other side: one that pulls less does not pull
const found = new Float64Array(9);

/** The reading of the post round which a rope turns farthest; null where it lies round none.
 * @param {Rope} rope @param {Float64Array} tension of the segments @returns {Reading | null} */
export function readPosts(rope, tension) {
  /** @type {Reading | null} */ let best = null;
  for (const hold of rope.contact?.holds ?? [])
    for (const [first, last] of rope.ropes) {
      let [begin, end, angle] = [-1, -1, 0];
      for (let i = first; i <= last; i++) {
        if (!(hold.push[i] > 0)) continue;
        if (begin < 0) begin = i;
        end = i;
      }
      if (begin <= first || end >= last) continue; // an end lies on it, or nothing does
      for (let i = begin; i <= end; i++) {
        probe(hold.post, rope.x[0][i], rope.x[1][i], rope.x[2][i], found);
        angle += turnAt(rope, i, found);
      }
      if (!(angle > (best?.angle ?? 0))) continue;
      const sides = /** @type {[number, number]} */ ([tension[begin - 1], tension[end]]);
      const nodes = /** @type {[number, number]} */ ([begin - 1, end + 1]);
      const [least, most] = [Math.min(...sides), Math.max(...sides)];
      const ratio = least > Math.max(LITTLE, NOTHING * most) ? most / least : NaN;
      best = { sides, nodes, post: hold.post, ratio, angle };
    }
  return best;
}

/** What posts have taken so far [J], by friction, by the damper of contacts and into the springs that friction is while
 * it sticks: what they have done, less what their surfaces have stored. @param {Rope} rope */
export const takenByPosts = (rope) =>
  rope.contact ? -rope.contact.work - rope.contact.stored() + rope.contact.first : 0;

/** @param {number} ratio */
export const toldRatio = (ratio) => (ratio ? ratio.toFixed(2) : "none");
/** @param {number} angle [rad] */
export const toldAngle = (angle) => `${Math.round((180 / Math.PI) * angle)}°`;

/** What is told of posts, names and values; nothing of them where the rope is broken. @param {Rope} rope
 * @param {Reading | null} now @param {boolean} broken @returns {[string, string][]} */
export function postRows(rope, now, broken) {
  if (!rope.contact) return [];
  const several = rope.contact.holds.length > 1 ? "s" : "";
  /** @param {string} value */
  const whole = (value) => (broken ? "none" : value);
  return [
    ["tensions at the post", now ? now.sides.map((one) => told(one, "N")).join(", ") : "none"],
    ["their ratio", toldRatio(now?.ratio ?? NaN)],
    ["angle round the post", whole(toldAngle(now?.angle ?? 0))],
    [`taken by the post${several}`, whole(told(takenByPosts(rope), "J"))],
  ];
}
