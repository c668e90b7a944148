// The camera follows the ropes, calmly: it moves only when they leave the picture's middle or have become small in
// it, and then slowly.

import { dot } from "./vector.js";

/** @typedef {import("./camera.js").Camera} Camera */
/** @typedef {import("./bound.js").Piece} Piece */
/** @typedef {{low: number[], high: number[]}} Edges [m] */
/** @typedef {import("./camera.js").Pose} Pose */
/** @typedef {import("./vector.js").Vector} Vector */
/** @typedef {import("./camera.js").Strips} Strips */

const WINDOW = 2; // s, in which the envelope forgets
const LEAD = 0.5; // s, by which it goes before what moves outwards: the camera comes that much later
const LEADING = 0.3; // of what the ropes take up, at most
const SMOOTH = 0.1; // s, over which that speed is taken
const ROOMS = 4; // radii of the scene
const HELD = 400; // of what is held: a winch may let out far more than was there at first
const LOOKED_AT = 300; // nodes, at most
const OUTER = 0.95; // of the picture's half: what leaves this is followed
const SMALL = 0.75; // of the distance: nearer than this the ropes would fit as well

export class Follow {
  constructor() {
    /** Least and greatest of the places to the right, to the top and towards the eye [m]. */
    this.low = [Infinity, Infinity, Infinity];
    this.high = [-Infinity, -Infinity, -Infinity];
    this.angles = "";
    this.clock = 0; // s
    /** Where the ropes were in the last seconds. @type {(Edges & {time: number})[]} */
    this.past = [];
    /** Of the lower and the upper edges, outwards [m/s]. */
    this.speeds = { low: [0, 0, 0], high: [0, 0, 0] };
  }

  /** Forget all places. */
  clear() {
    this.low.fill(Infinity);
    this.high.fill(-Infinity);
    this.past = [];
    this.speeds = { low: [0, 0, 0], high: [0, 0, 0] };
  }

  /** Take over where the ropes are now: the envelope holds where they were in the last seconds, and goes before them.
   * @param {Camera} camera @param {Float32Array} nodes x, y, z, value @param {Piece[]} pieces
   * @param {number} seconds since the last time @param {{center: number[], radius: number}} room what is far
   * outside of it is not followed: it breaks, or was cut off and falls */
  take(camera, nodes, pieces, seconds, room) {
    const angles = `${camera.pose.azimuth} ${camera.pose.elevation}`;
    if (angles !== this.angles) this.clear();
    this.angles = angles;
    const { low, high } = extent(camera, nodes, pieces, room);
    this.clock += seconds;
    const before = this.past.at(-1);
    this.past = this.past.filter(({ time }) => this.clock - time < WINDOW);
    if (![...low, ...high].every(Number.isFinite)) {
      if (!this.past.length) this.clear(); // all of it has gone
      return;
    }
    if (before && seconds > 0) this.learn(before, { low, high }, seconds);
    this.past.push({ time: this.clock, low, high });
    const most = LEADING * Math.max(...high.map((value, k) => value - low[k]));
    const ahead = (/** @type {number} */ speed) => Math.min(most, LEAD * Math.max(0, speed));
    for (let k = 0; k < 3; k++) {
      const least = Math.min(...this.past.map((one) => one.low[k]));
      const greatest = Math.max(...this.past.map((one) => one.high[k]));
      // only onto new ground: what swings to and fro comes back by itself
      this.low[k] = least - (low[k] > least ? 0 : ahead(this.speeds.low[k]));
      this.high[k] = greatest + (high[k] < greatest ? 0 : ahead(this.speeds.high[k]));
    }
  }

  /** How fast the edges move outwards. @param {Edges} before @param {Edges} now @param {number} seconds */
  learn(before, now, seconds) {
    const ease = Math.min(1, seconds / SMOOTH);
    const { low, high } = this.speeds;
    for (let k = 0; k < 3; k++) {
      low[k] += ease * ((before.low[k] - now.low[k]) / seconds - low[k]);
      high[k] += ease * ((now.high[k] - before.high[k]) / seconds - high[k]);
    }
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
    const wanted = this.goal(camera, room);
    if (!wanted) return null;
    const small = wanted.distance < SMALL * camera.pose.distance;
    return small || this.leaves(camera, strips) ? wanted : null;
  }

  /** The pose that shows the envelope, whether the camera has to move or not. @param {Camera} camera
   * @param {Strips} room @returns {Pose | null} */
  goal(camera, room) {
    return this.low.every(Number.isFinite) ? camera.framed(this.corners(camera), {}, room) : null;
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

/** What the ropes take up now along the axes of the view. @param {Camera} camera @param {Float32Array} nodes
 * @param {Piece[]} pieces @param {{center: number[], radius: number}} room */
function extent({ right, top, toward }, nodes, pieces, { center, radius }) {
  const count = pieces.reduce((sum, piece) => sum + piece.nodes, 0);
  const every = Math.max(1, Math.ceil(count / LOOKED_AT));
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  [right, top, toward].forEach(([x, y, z], k) => {
    const middle = center[0] * x + center[1] * y + center[2] * z;
    for (const { first, nodes: many, held } of pieces) {
      const reach = (held ? HELD : ROOMS) * radius;
      for (let i = first; i < first + many; i += every) {
        const value = nodes[4 * i] * x + nodes[4 * i + 1] * y + nodes[4 * i + 2] * z;
        if (!(Math.abs(value - middle) <= reach)) continue;
        if (value < low[k]) low[k] = value;
        if (value > high[k]) high[k] = value;
      }
    }
  });
  return { low, high };
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
