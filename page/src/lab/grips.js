// How stiff contacts are: as stiff as the rope asks for, stiffer the deeper, as the Python `obstacle` and
// `hardening` have it.

/** @typedef {import("./kernel.js").Rope} Rope */
/** @typedef {import("./solids.js").Post} Post */
/** @typedef {{first: number, last: number, own: number, whole: number, diameter: number, thickness: number,
 *   segment: number, loads: [number, number][]}} Line what contacts ask of a rope: its nodes, their own mass and that
 *   of all [kg], half of what it is thick where it counts, the segments' length [m], nodes and masses of loads */
/** @typedef {{stiff: Float64Array, damp: Float64Array, hard: Float64Array}} Grip of every node, and what the
 *   stiffness grows by where it is pressed deep [N/m], [N s/m] */

const FRAME = 1 / 60; // [s]
const FIRM = 0.005; // depth over the diameter under the whole weight, at most
const SHARP = 2; // what a node presses with, over the tension, where the rope turns back
const SHARE = 0.15; // compliance of a contact over the rope's own at a node
export const SKIN = 0.005; // depth over the diameter from which contacts get stiffer
export const HARD = 0.3; // damping ratio of contacts that are pressed farther

/** @param {number} k of a segment @param {number} mass of a node @param {number} whole of the rope */
function shownStiffness(k, mass, whole) {
  const [inert, all] = [mass / FRAME ** 2, whole / FRAME ** 2];
  const shown = Math.sqrt(inert ** 2 + 4 * k * inert);
  return Math.min(Math.min(shown, all) / SHARE, Math.max(k, mass / FRAME ** 2));
}

/** What the contacts of a post are like, with the values that the rope has now.
 * @param {Rope} rope @param {Post} post @param {Line[]} lines @returns {Grip} */
export function gripOf(rope, post, lines) {
  const [stiff, damp, hard] = [0, 0, 0].map(() => new Float64Array(rope.n));
  const gravity = Math.hypot(...rope.gravity);
  const round = post.kind === "plane" ? Infinity : post.radius;
  for (const line of lines) {
    const { first, last, own, whole, diameter, segment } = line;
    const k = rope.stiffness[first];
    const turn = Math.min(segment / (round + 0.5 * diameter), SHARP);
    const firm = Math.min((gravity * whole * turn) / (FIRM * diameter), mostStiffness(k, own));
    /** @type {Map<number, number>} */ const loads = new Map();
    for (const [node, mass] of line.loads) loads.set(node, (loads.get(node) ?? 0) + mass);
    for (let i = first; i <= last; i++) {
      const mass = own + (loads.get(i) ?? 0);
      const asked = shownStiffness(k, mass, whole);
      stiff[i] = post.compliance === null ? Math.max(asked, firm) : 1 / post.compliance;
      if (post.compliance === null) hard[i] = Math.max(mostStiffness(k, mass) - stiff[i], 0);
      damp[i] = 2 * Math.sqrt(stiff[i] * mass);
    }
  }
  return { stiff, damp, hard };
}

/** @param {number} k of a segment @param {number} mass of a node */
const mostStiffness = (k, mass) => Math.max(k, mass / FRAME ** 2);

/** Write force, slope and energy of a node that is pressed by a depth [N], [N/m], [J]; negative where it is off, but
 * for energy. @param {number} k @param {number} hard @param {number} skin [m] @param {number} depth
 * @param {Float64Array} out */
export function squeeze(k, hard, skin, depth, out) {
  if (hard === 0 || depth <= skin) {
    out[0] = k * depth;
    out[1] = k;
    out[2] = 0.5 * k * depth * Math.max(depth, 0);
    return;
  }
  [out[0], out[1], out[2]] = [k * skin, k, 0.5 * k * skin * skin];
  deeper(Math.min(depth - skin, skin), hard / skin, out);
  deeper(depth - 2 * skin, 0, out);
}

/** Add so much more depth, with a slope that grows. @param {number} depth @param {number} rate
 * @param {Float64Array} out */
function deeper(depth, rate, out) {
  const e = Math.max(depth, 0);
  const [force, slope] = [out[0], out[1]];
  out[0] = force + (slope + 0.5 * rate * e) * e;
  out[1] = slope + rate * e;
  out[2] += (force + (0.5 * slope + (rate * e) / 6) * e) * e;
}
