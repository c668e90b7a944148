// The room around the ropes: the first look at a scene, boxes to fit, the ground and its grid.

import { cross, dot, plus, times, vector } from "./vector.js";
import { round } from "./range.js";

/** @typedef {import("./camera.js").Camera} Camera */
/** @typedef {import("./camera.js").Box} Box */
/** @typedef {import("./vector.js").Vector} Vector */
/** @typedef {import("../source/protocol.js").Layout} Layout */
/** @typedef {import("../render/view.js").Ground} Ground */

/** @typedef {Layout["view"]} Surroundings */

const ASIDE = 0.28; // rad, so that a flat scene has depth
const FAR = 1e4; // radii of a scene beyond which nothing of a rope is shown: it broke

/** The value of a node that is nowhere: no rope is drawn to it. */
export const GONE = 3e38;

/** Put nodes that are nowhere (NaN), or absurdly far away, where the one before them is (or the next one), and
 * mark them, so that nothing is drawn to them. @param {Float32Array} nodes x, y, z, value, written in place
 * @param {number} count @param {Surroundings} view */
export function tame(nodes, count, { center, radius }) {
  const [cx, cy, cz] = center;
  const reach = FAR * radius;
  const wild = (/** @type {number} */ q) =>
    !(
      Math.abs(nodes[q] - cx) < reach &&
      Math.abs(nodes[q + 1] - cy) < reach &&
      Math.abs(nodes[q + 2] - cz) < reach
    );
  /** @type {ArrayLike<number> | null} */ let before = null;
  for (let i = 0, q = 0; i < count; i++, q += 4) {
    if (!wild(q)) {
      if (!Number.isFinite(nodes[q + 3])) nodes[q + 3] = 0;
      continue;
    }
    if (i > 0) before = nodes.subarray(q - 4, q - 1);
    else {
      let next = 0;
      while (next < count && wild(4 * next)) next++;
      before = next < count ? nodes.slice(4 * next, 4 * next + 3) : center;
    }
    nodes.set(before, q);
    nodes[q + 3] = GONE;
  }
}

/** The box of all nodes. @param {Float32Array} nodes x, y, z, value @param {number} count @returns {Box} */
export function boxOf(nodes, count) {
  /** @type {Box} */
  const box = { low: [Infinity, Infinity, Infinity], high: [-Infinity, -Infinity, -Infinity] };
  for (let i = 0; i < count; i++) {
    for (let k = 0; k < 3; k++) {
      const value = nodes[4 * i + k];
      if (value < box.low[k]) box.low[k] = value;
      if (value > box.high[k]) box.high[k] = value;
    }
  }
  return box;
}

/** The axis of a scene that lies in one plane (0, 1, 2), else -1.
 * @param {Box} box @param {ArrayLike<number>} up @param {number} radius */
export function flatAxis(box, up, radius) {
  const thin = [0, 1, 2].filter((k) => box.high[k] - box.low[k] < 1e-4 * radius);
  if (!thin.length) return -1;
  const level = thin.filter((k) => Math.abs(up[k]) < 0.9);
  if (level.length > 1) return level.includes(1) ? 1 : level[level.length - 1]; // a straight rope
  return level.length ? level[0] : thin[0];
}

/** Whether a flat scene lies on its back and can sag: it is not looked at from straight above.
 * @param {number} axis of a flat scene, or -1 @param {ArrayLike<number>} up @param {number[]} gravity */
export const lies = (axis, up, gravity) =>
  axis >= 0 && Math.abs(up[axis]) > 0.9 && gravity.some((value) => value !== 0);

/** The angles of the first look: at a flat scene a little from the side and above, else more so.
 * @param {Camera} camera @param {number} axis of a flat scene, or -1 @param {boolean} [solid] whether there are
 * bodies in it @param {boolean} [lying] whether all of it lies */
export function firstAngles(camera, axis, solid = false, lying = false) {
  if (axis < 0) return { azimuth: -Math.PI / 2 + 0.55, elevation: lying ? 0.62 : 0.3 };
  if (Math.abs(camera.up[axis]) > 0.9) return { azimuth: -Math.PI / 2, elevation: Math.PI / 2 };
  const normal = vector([0, 0, 0]);
  normal[axis] = 1;
  const sign = dot(cross(camera.up, normal), [1, 1, 1]) >= 0 ? 1 : -1; // x to the right
  const { azimuth } = camera.along(/** @type {0 | 1 | 2} */ (axis), sign);
  return { azimuth: azimuth - (solid ? 1.6 : 1) * ASIDE, elevation: solid ? 0.24 : 0.14 };
}

/** The ground under the scene, or a grid below it where it has none.
 * @param {Camera} camera @param {{level: number, given: number | null}} floor [m]
 * @returns {Ground} */
export function groundOf(camera, { level: height, given }) {
  const spacing = round((camera.pose.distance * 0.28) / 5);
  const { target } = camera.pose;
  const a = Math.round(dot(target, camera.first) / spacing) * spacing;
  const b = Math.round(dot(target, camera.second) / spacing) * spacing;
  const center = plus(plus(times(camera.first, a), camera.second, b), camera.up, height);
  return { height, solid: given !== null, spacing, radius: 14 * spacing, center };
}
