// The camera follows the ropes, calmly: it moves only when they leave the picture's middle or have become small in
// it, and then slowly.

import { dot, minus, plus, times, vector } from "./vector.js";

/** @typedef {import("./camera.js").Camera} Camera */
/** @typedef {import("./bound.js").Piece} Piece */
/** Where ropes are along the axes of a view, and the mean of it.
 * @typedef {{low: number[], high: number[], middle: number[]}} Edges [m] */
/** @typedef {import("./camera.js").Pose} Pose */
/** @typedef {import("./vector.js").Vector} Vector */
/** @typedef {import("./camera.js").Strips} Strips */

const WINDOW = 2; // s, in which the envelope forgets
const LEAD = 0.5; // s, by which it goes before what moves outwards: the camera comes that much later
const LEADING = 0.3; // of what the ropes take up, at most
const SMOOTH = 0.1; // s, over which that speed is taken
const ROOMS = 4; // radii of the scene
const HELD = 5000; // of what is held: a winch may let out far more than was there at first, what falls goes far
const LOOKED_AT = 300; // nodes, at most
const OUTER = 0.95; // of the picture's half: what leaves this is followed
const SMALL = 0.75; // of the distance: nearer than this the ropes would fit as well
const RESTS = 0.92; // and of what rests: there is no swing that brings it back
const STEADY = 3; // s, after which what swings evenly counts as what rests
const BINS = 48; // of the window: ropes that swing round fill less than the box around all of it
const WIDER = 1.05; // of a distance: so much farther is a zoom out
const PATIENCE = 16; // s, at most: what becomes large and small again and again is not zoomed in on
const ROUNDS = 6; // in which ropes are brought into the picture
const REST = 0.02; // of their size, by which ropes that rest have moved in that time
const CALM = 0.3; // of their size in a second: the camera goes along with what is adrift and faster

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
    /** Where the ropes are now. @type {Edges | null} */ this.now = null;
    this.along = 0; // part of their way that the camera goes with them
    /** The middle of what was drawn. @type {Vector | null} */ this.drawn = null;
    /** Still places that are kept in the picture, too. @type {Vector[]} */ this.still = [];
    /** What the envelope holds beyond where the ropes were [m]. */
    this.beyond = { low: [0, 0, 0], high: [0, 0, 0] };
    this.patience = 0; // s, for which ropes must have been small before the camera comes nearer
    this.large = 0; // s, of the clock: when they were not small last
    this.nearer = false; // whether the camera has come nearer since it went back last
  }

  /** Forget all places. */
  clear() {
    this.low.fill(Infinity);
    this.high.fill(-Infinity);
    this.past = [];
    this.speeds = { low: [0, 0, 0], high: [0, 0, 0] };
    this.now = null;
    this.along = 0;
    this.drawn = null;
    this.still = [];
    this.patience = this.large = 0;
    this.nearer = false;
  }

  /** Take over where the ropes are now: the envelope holds where they were in the last seconds, and goes before them.
   * @param {Camera} camera @param {Float32Array} nodes x, y, z, value @param {Piece[]} pieces
   * @param {number} seconds since the last time @param {{center: number[], radius: number}} room what is far
   * outside of it is not followed: it breaks, or was cut off and falls */
  take(camera, nodes, pieces, seconds, room) {
    const angles = `${camera.pose.azimuth} ${camera.pose.elevation}`;
    if (angles !== this.angles) this.clear();
    this.angles = angles;
    const now = extent(camera, nodes, pieces, room);
    const { low, high } = now;
    this.clock += seconds;
    const before = this.past.at(-1);
    this.past = this.past.filter(({ time }) => this.clock - time < WINDOW);
    if (![...low, ...high].every(Number.isFinite)) {
      if (!this.past.length) this.clear(); // all of it has gone
      return;
    }
    if (before && seconds > 0) this.learn(before, now, seconds);
    this.past.push({ time: this.clock, ...now });
    this.now = { ...now, low: [...low], high: [...high] };
    const along = this.goAlong(pieces[0]?.adrift ?? false, before, now);
    const most = LEADING * this.size;
    const ahead = (/** @type {number} */ speed) => Math.min(most, LEAD * Math.max(0, speed));
    for (let k = 0; k < 3; k++) {
      const least = Math.min(...this.past.map((one) => one.low[k]));
      const greatest = Math.max(...this.past.map((one) => one.high[k]));
      // only onto new ground: what swings to and fro comes back by itself
      this.beyond.low[k] = -(low[k] > least ? 0 : ahead(this.speeds.low[k] + along[k]));
      this.beyond.high[k] = high[k] < greatest ? 0 : ahead(this.speeds.high[k] - along[k]);
      this.low[k] = least + this.beyond.low[k];
      this.high[k] = greatest + this.beyond.high[k];
    }
    this.still = [];
    if (this.drawn) this.stayBehind(camera, this.drawn, now);
  }

  /** What is drawn comes one frame later than what is known: the camera goes along with what is drawn.
   * @param {Camera} camera @param {Vector} drawn @param {Edges} now */
  stayBehind({ right, top, toward }, drawn, now) {
    [right, top, toward].forEach((axis, k) => {
      const by = this.along * (dot(drawn, axis) - now.middle[k]);
      for (const { low, high } of [this, this.beyond]) {
        low[k] += by;
        high[k] += by;
      }
    });
  }

  /** The greatest of the ropes' extents now [m]. @returns {number} */
  get size() {
    const { low, high } = this.now ?? this;
    return Math.max(...high.map((value, k) => value - low[k]));
  }

  /** Go along with what is adrift, but for as much of its speed as it can have in the picture: where it was is where
   * a camera that goes along would have seen it. @param {boolean} adrift @param {Edges | undefined} before
   * @param {Edges} now @returns {number[]} speeds along the axes of the view [m/s] */
  goAlong(adrift, before, now) {
    const { low, high } = this.speeds;
    const speeds = high.map((speed, k) => (speed - low[k]) / 2);
    const speed = Math.hypot(...speeds);
    this.along = adrift && speed > 0 ? Math.max(0, 1 - (CALM * this.size) / speed) : 0;
    const steps = now.middle.map((value, k) => this.along * (value - (before ?? now).middle[k]));
    for (const one of this.past)
      if (one !== this.past.at(-1))
        for (const side of [one.low, one.high]) steps.forEach((by, k) => (side[k] += by));
    return speeds.map((one) => this.along * one);
  }

  /** How far the camera goes with the ropes since it was asked last. @param {Camera} camera
   * @param {Float32Array} nodes as they are drawn now @param {Piece[]} pieces
   * @param {{center: number[], radius: number}} room @returns {Vector} [m] */
  goes(camera, nodes, pieces, room) {
    const { right, top, toward } = camera;
    const before = this.drawn;
    this.drawn = null;
    if (!this.along) return [0, 0, 0];
    const now = extent(camera, nodes, pieces, room);
    const [r, t, n] = now.middle;
    if (!Number.isFinite(r + t + n)) return [0, 0, 0]; // all of it has gone
    this.now = now;
    this.drawn = plus(plus(times(right, r), top, t), toward, n);
    return before ? times(minus(this.drawn, before), this.along) : [0, 0, 0];
  }

  /** Whether the ropes have been at rest all the time that is remembered. */
  get rests() {
    const { past, size } = this;
    const moves = (/** @type {"low" | "high"} */ side) =>
      [0, 1, 2].some((k) => {
        const values = past.map((one) => one[side][k]);
        return Math.max(...values) - Math.min(...values) > REST * size;
      });
    const long = past.length > 0 && this.clock - past[0].time > 0.8 * WINDOW;
    return long && !moves("low") && !moves("high");
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
    this.still = places;
    [right, top, toward].forEach((axis, k) => {
      for (const place of places) {
        const value = dot(place, axis);
        this.low[k] = Math.min(this.low[k], value);
        this.high[k] = Math.max(this.high[k], value);
      }
    });
  }

  /** The box of what the envelope holds, along the axes of the scene. @param {Camera} camera
   * @returns {import("./camera.js").Box} */
  box(camera) {
    const corners = this.corners(camera);
    const [low, high] = [Math.min, Math.max].map((most) =>
      vector([0, 1, 2].map((k) => most(...corners.map((corner) => corner[k])))),
    );
    return { low, high };
  }

  /** The pose the camera should fly to, or null where it may stay. @param {Camera} camera
   * @param {Strips} strips kept free @param {Strips} [room] that a pose leaves above and below the ropes
   * @returns {Pose | null} */
  wanted(camera, strips, room = strips) {
    const wanted = this.goal(camera, room);
    if (!wanted) return null;
    const { distance } = camera.pose;
    const calm = this.calm(wanted, distance);
    return calm.distance < distance || this.leaves(camera, strips) ? calm : null;
  }

  /** A goal that comes no nearer than a distance before the ropes have been small for a while, each time longer when
   * they became large again: a zoom that goes to and fro is worse than ropes that are small for a moment.
   * @param {Pose} goal @param {number} distance [m] @returns {Pose} */
  calm(goal, distance) {
    if (goal.distance >= RESTS * distance) this.large = this.clock;
    if (goal.distance > WIDER * distance && this.nearer) {
      this.patience = Math.min(PATIENCE, Math.max(WINDOW, 2 * this.patience));
      this.nearer = false;
    }
    if (goal.distance >= distance) return goal;
    const waited = this.clock - this.large - this.patience;
    const small = goal.distance < SMALL * distance || this.rests || waited >= STEADY;
    if (!small || waited < 0 || this.large === this.clock) return { ...goal, distance };
    this.nearer = true;
    return goal;
  }

  /** The pose that shows the envelope, whether the camera has to move or not. @param {Camera} camera
   * @param {Strips} room @returns {Pose | null} */
  goal(camera, room) {
    return this.low.every(Number.isFinite) ? camera.framed(this.outline(camera), {}, room) : null;
  }

  /** @param {Camera} camera @param {Strips} strips */
  leaves(camera, strips) {
    return outside(camera, this.outline(camera), strips) > OUTER;
  }

  /** Corners of what the envelope holds: where the ropes were, time by time, and what does not move. Ropes that swing
   * round fill less of the picture's depth than one box around it all. @param {Camera} camera @returns {Vector[]} */
  outline(camera) {
    /** @type {Map<number, {low: number[], high: number[]}>} */ const boxes = new Map();
    for (const { time, low, high } of this.past) {
      const bin = Math.floor((time * BINS) / WINDOW);
      const box = boxes.get(bin) ?? { low, high };
      boxes.set(bin, {
        low: low.map((value, k) => Math.min(value, box.low[k])),
        high: high.map((value, k) => Math.max(value, box.high[k])),
      });
    }
    const found = [...this.still];
    for (const { low, high } of boxes.values())
      found.push(
        ...this.corners(camera, {
          low: low.map((value, k) => value + this.beyond.low[k]),
          high: high.map((value, k) => value + this.beyond.high[k]),
        }),
      );
    return found;
  }

  /** The pose, or one with the ropes as they are now in the picture: a damped camera comes late where they are fast.
   * @param {Camera} camera @param {Pose} pose @param {Strips} strips @returns {Pose} */
  keep(camera, pose, strips) {
    if (!this.now) return pose;
    const corners = this.corners(camera, this.now);
    let kept = pose;
    for (let round = 0; round < ROUNDS; round++) {
      const probe = camera.at(kept);
      if (outside(probe, corners, strips) <= OUTER + 1e-3) return kept;
      kept = moved(probe, corners, strips);
    }
    return kept;
  }

  /** @param {Camera} camera @param {{low: number[], high: number[]}} [edges]
   * @returns {Vector[]} */
  corners({ right, top, toward }, { low, high } = this) {
    return Array.from({ length: 8 }, (_, corner) => {
      const [r, t, n] = [0, 1, 2].map((k) => ((corner >> k) & 1 ? high[k] : low[k]));
      return /** @type {Vector} */ (
        [0, 1, 2].map((k) => r * right[k] + t * top[k] + n * toward[k])
      );
    });
  }
}

/** The picture without strips. @param {Camera} camera @param {Strips} strips [CSS pixels] */
const free = ({ width, height }, { top, bottom, left = 0, right = 0 }) => ({
  x: (left + width - right) / 2,
  y: (top + height - bottom) / 2,
  across: Math.max(1, (width - left - right) / 2),
  up: Math.max(1, (height - top - bottom) / 2),
});

/** How far points are from the middle of what is free of a picture, one where they are at its edge.
 * @param {Camera} camera @param {Vector[]} points @param {Strips} strips */
function outside(camera, points, strips) {
  const { x, y, across, up } = free(camera, strips);
  return Math.max(
    ...points.map((point) => {
      const [px, py, depth] = camera.project(...point);
      return depth > 0 ? Math.max(Math.abs(px - x) / across, Math.abs(py - y) / up) : Infinity;
    }),
  );
}

/** The pose moved by as little as brings points in from the picture's edge. @param {Camera} camera
 * @param {Vector[]} points @param {Strips} strips @returns {Pose} */
function moved(camera, points, strips) {
  const { pose } = camera;
  const seen = points.map((point) => camera.project(...point));
  if (seen.some(([, , depth]) => depth <= 0)) return { ...pose, distance: 2 * pose.distance };
  const { x, y, across, up } = free(camera, strips);
  const side = (
    /** @type {number} */ k,
    /** @type {number} */ middle,
    /** @type {number} */ half,
  ) => {
    const values = seen.map((place) => place[k] - middle);
    const [least, most] = [Math.min(...values), Math.max(...values)];
    const over = Math.max(0, most - half) + Math.min(0, least + half);
    return { over, tight: (most - least) / (2 * half) };
  };
  const [flat, high] = [side(0, x, OUTER * across), side(1, y, OUTER * up)];
  const tight = Math.max(flat.tight, high.tight);
  if (tight > 1) return { ...pose, distance: pose.distance * tight };
  const scale = pose.distance / camera.focal;
  const target = plus(
    plus(pose.target, camera.right, flat.over * scale),
    camera.top,
    -high.over * scale,
  );
  return { ...pose, target };
}

/** What the ropes take up now along the axes of the view. @param {Camera} camera @param {Float32Array} nodes
 * @param {Piece[]} pieces @param {{center: number[], radius: number}} room @returns {Edges} */
function extent({ right, top, toward }, nodes, pieces, { center, radius }) {
  const count = pieces.reduce((sum, piece) => sum + piece.nodes, 0);
  const every = Math.max(1, Math.ceil(count / LOOKED_AT));
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  const middle = [0, 0, 0];
  [right, top, toward].forEach(([x, y, z], k) => {
    const heart = center[0] * x + center[1] * y + center[2] * z;
    let seen = 0;
    for (const { first, nodes: many, held } of pieces) {
      const reach = (held ? HELD : ROOMS) * radius;
      for (let i = first; i < first + many; i += every) {
        const value = nodes[4 * i] * x + nodes[4 * i + 1] * y + nodes[4 * i + 2] * z;
        if (!(Math.abs(value - heart) <= reach)) continue;
        if (value < low[k]) low[k] = value;
        if (value > high[k]) high[k] = value;
        middle[k] += value;
        seen++;
      }
    }
    middle[k] /= seen;
  });
  return { low, high, middle };
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
