// The camera follows the ropes, calmly: it moves only when they leave the picture's middle or have become small in
// it, and then slowly.

import { dot } from "./vector.js";

/** @typedef {import("./camera.js").Camera} Camera */
/** @typedef {import("./camera.js").Pose} Pose */
/** @typedef {import("./vector.js").Vector} Vector */
/** @typedef {import("./camera.js").Strips} Strips */

const SHRINK = 4; // s in which the envelope forgets
const ROOMS = 4; // radii of the scene
const LOOKED_AT = 300; // nodes, at most
const OUTER = 0.95; // of the picture's half: what leaves this is followed
const SMALL = 0.75; // of the distance: nearer than this the ropes would fit as well

export class Follow {
  constructor() {
    /** Least and greatest of the places to the right, to the top and towards the eye [m]. */
    this.low = [Infinity, Infinity, Infinity];
    this.high = [-Infinity, -Infinity, -Infinity];
    this.angles = "";
  }

  /** Forget all places. */
  clear() {
    this.low.fill(Infinity);
    this.high.fill(-Infinity);
  }

  /** Take over where the ropes are now: the envelope grows at once and shrinks slowly.
   * @param {Camera} camera @param {Float32Array} nodes x, y, z, value @param {number} count
   * @param {number} seconds since the last time @param {{center: number[], radius: number}} room what is far
   * outside of it is not followed: it breaks, or was cut off and falls */
  take(camera, nodes, count, seconds, { center, radius }) {
    const angles = `${camera.pose.azimuth} ${camera.pose.elevation}`;
    if (angles !== this.angles) this.clear();
    this.angles = angles;
    const axes = [camera.right, camera.top, camera.toward];
    const every = Math.max(1, Math.ceil(count / LOOKED_AT));
    const ease = 1 - Math.exp(-seconds / SHRINK);
    axes.forEach(([x, y, z], k) => {
      const middle = center[0] * x + center[1] * y + center[2] * z;
      let [low, high] = [Infinity, -Infinity];
      for (let i = 0; i < count; i += every) {
        const value = nodes[4 * i] * x + nodes[4 * i + 1] * y + nodes[4 * i + 2] * z;
        if (Math.abs(value - middle) > ROOMS * radius) continue;
        if (value < low) low = value;
        if (value > high) high = value;
      }
      if (!Number.isFinite(low + high)) return;
      this.low[k] = low < this.low[k] ? low : this.low[k] + ease * (low - this.low[k]);
      this.high[k] = high > this.high[k] ? high : this.high[k] + ease * (high - this.high[k]);
    });
  }

  /** Keep still places in the picture, too. @param {Camera} camera @param {Vector[]} places */
  hold({ right, top, toward }, places) {
    [right, top, toward].forEach((axis, k) => {
      for (const place of places) {
        const value = dot(place, axis);
        this.low[k] = Math.min(this.low[k], value);
        this.high[k] = Math.max(this.high[k], value);
      }
    });
  }

  /** The pose the camera should fly to, or null where it may stay. @param {Camera} camera
   * @param {Strips} strips kept free @param {Strips} [room] that a pose leaves above and below the ropes
   * @returns {Pose | null} */
  wanted(camera, strips, room = strips) {
    if (!this.low.every(Number.isFinite)) return null;
    const wanted = camera.framed(this.corners(camera), {}, room);
    const small = wanted.distance < SMALL * camera.pose.distance;
    return small || this.leaves(camera, strips) ? wanted : null;
  }

  /** @param {Camera} camera @param {Strips} strips */
  leaves(camera, { top, bottom, left = 0 }) {
    const { width, height } = camera;
    return this.corners(camera).some((corner) => {
      const [x, y, depth] = camera.project(...corner);
      const across = Math.abs(x - (left + width) / 2) / ((width - left) / 2);
      const middle = (top + height - bottom) / 2;
      const up = Math.abs(y - middle) / ((height - top - bottom) / 2);
      return depth <= 0 || across > OUTER || up > OUTER;
    });
  }

  /** @param {Camera} camera @returns {Vector[]} */
  corners({ right, top, toward }) {
    const { low, high } = this;
    return Array.from({ length: 8 }, (_, corner) => {
      const [r, t, n] = [0, 1, 2].map((k) => ((corner >> k) & 1 ? high[k] : low[k]));
      return /** @type {Vector} */ (
        [0, 1, 2].map((k) => r * right[k] + t * top[k] + n * toward[k])
      );
    });
  }
}

/** How low ropes can come while what holds them stays: two held nodes with a length of rope between them let it down
 * to where it makes a V, a loose end to its whole length.
 * @param {{index: number}[]} held @param {{first: number, nodes: number, length: number,
 * segments: number}} rope @param {(index: number) => Vector} placeOf @param {Vector} up */
export function lowest(held, rope, placeOf, up) {
  const last = rope.first + rope.nodes - 1;
  const inside = held
    .map(({ index }) => index)
    .filter((index) => index >= rope.first && index <= last)
    .sort((a, b) => a - b);
  const spacing = rope.length / Math.max(1, rope.segments);
  let found = Infinity;
  inside.forEach((index, i) => {
    const place = placeOf(index);
    const level = dot(place, up);
    const next = inside[i + 1];
    if (i === 0) found = Math.min(found, level - (index - rope.first) * spacing);
    if (next === undefined) {
      found = Math.min(found, level - (last - index) * spacing);
      return;
    }
    const other = placeOf(next);
    const length = (next - index) * spacing;
    const fall = level - dot(other, up);
    const apart2 = Math.max(
      0,
      place.reduce((sum, value, k) => sum + (value - other[k]) ** 2, 0) - fall * fall,
    );
    const deep = Math.sqrt(Math.max(0, length * length - apart2));
    found = Math.min(found, level, level - (fall + deep) / 2);
  });
  return found;
}
