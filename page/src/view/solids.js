// The bodies that ropes touch, as they are drawn: how far a place is from their surface, how far they have turned,
// and what a picture of them must hold.

import { struck, surfaceOf } from "./surface.js";
import { cross, dot, minus, plus, rotated, times, unit } from "./vector.js";

/** @typedef {import("./vector.js").Vector} Vector */
/** @typedef {import("../source/protocol.js").Obstacle} Obstacle */
/** @typedef {import("../source/protocol.js").Motion} Motion */
/** @typedef {"plane" | "sphere" | "cylinder" | "capsule" | "box" | "torus" | "half-pipe" | "mesh"} Kind */

/** One body of one copy. `size` as in the layout message; `zero`: across the axis, where turns are counted from, of a
 * box its first edge; `axle`: about which it turns, through its centre less `middle`, with `hub` [m]; `sweeps`: not
 * round about that; `reach`: no part of it is farther from its centre [m].
 * @typedef {{name: string, kind: Kind, number: number, center: Vector, axis: Vector, size: number[], zero: Vector,
 *   axle: Vector, hub: Vector, sweeps: boolean, middle: Vector, reach: number, spin: [number, number, number] | null,
 *   turns: number[][] | null, wheel: number | null, motion: (Motion & {origin: Vector}) | null,
 *   surface: import("./surface.js").Surface | null}} Solid */

/** In the order of the shaders. @type {Kind[]} */
export const KINDS = [
  "plane",
  "sphere",
  "cylinder",
  "capsule",
  "box",
  "torus",
  "half-pipe",
  "mesh",
];
export const MOST_SOLIDS = 200; // that are drawn
const BEVEL = 0.04; // of a cylinder's radius or half length: how far its edges are drawn rounded
const LARGEST = 1e9; // m, m/s, rad/s: beyond that nothing can be drawn
const ENDLESS = 1e30; // half a length
export const RIM = 0.35; // radii of a half-pipe, to which its upright walls are drawn above the axis

/** The bodies of a layout, once for each shift; what no picture can show is left out.
 * @param {Obstacle[]} obstacles @param {number[][]} shifts [m] @returns {Solid[]} */
export function solidsOf(obstacles, shifts) {
  const apart = shifts.filter((shift, i) => shifts.findIndex((one) => same(one, shift)) === i);
  return apart
    .flatMap((shift) => obstacles.map((one) => solidOf(one, shift)))
    .filter((one) => one !== null)
    .slice(0, MOST_SOLIDS);
}

/** @param {number[]} a @param {number[]} b */
const same = (a, b) => a.every((value, k) => value === b[k]);

/** @param {Obstacle} obstacle @param {number[]} shift @returns {Solid | null} */
function solidOf(obstacle, shift) {
  const { name, center, axis, axle, hub, first, size, spin, turns, motion, wheel } = obstacle;
  const kind = obstacle.kind === "sdf" ? "mesh" : obstacle.kind;
  const number = KINDS.indexOf(/** @type {Kind} */ (kind));
  const { vertices, faces } = obstacle;
  const surface = vertices && faces ? surfaceOf(vertices, faces) : null;
  const middle = surface?.middle ?? [0, 0, 0];
  if (kind === "mesh" && !surface) return null;
  const long = kind === "cylinder" && size[1] === null ? ENDLESS : (size[1] ?? NaN);
  const sizes = surface
    ? [...surface.half, 0]
    : [size[0] ?? NaN, long, size[2] ?? NaN, size[3] ?? NaN];
  const drawable = (/** @type {number} */ value) => Math.abs(value) < LARGEST;
  const known = [...center, ...axis, ...sizes.map((one) => (one === ENDLESS ? 0 : one))];
  if (number < 0 || !known.every(drawable) || !(Math.hypot(...axis) > 0)) return null;
  const turning = spin && drawable(spin[0]) && drawable(spin[1]);
  const along = unit(axis);
  const across = Math.abs(along[2]) < 0.9 ? [0, 0, 1] : [1, 0, 0];
  return {
    name,
    kind: /** @type {Kind} */ (kind),
    number,
    center: plus(plus(center, shift), middle),
    axis: along,
    size: sizes,
    zero: first ? vector(first) : unit(minus(across, times(along, dot(across, along)))),
    axle: unit(axle ?? axis),
    hub: hub ? minus(vector(hub), vector(center)) : [0, 0, 0],
    sweeps: axle !== undefined,
    middle,
    reach: reachOf(/** @type {Kind} */ (kind), sizes),
    spin: turning ? [spin[0], spin[1], spin[2] ?? Infinity] : null,
    turns: turns ?? null,
    wheel: wheel ?? null,
    motion: motion ? { ...motion, origin: vector(center) } : null,
    surface,
  };
}

/** Whether it is a box, or is taken for the one around it. @param {Kind} kind */
const boxed = (kind) => kind === "box" || kind === "mesh";

/** The directions of its edges, of a round body about its axis. @param {Solid} solid @returns {Vector[]} */
export const axesOf = ({ axis, zero }) => [zero, cross(axis, zero), axis];

/** @param {Kind} kind @param {number[]} size */
function reachOf(kind, [a, b, c, d]) {
  if (kind === "plane" || kind === "half-pipe" || b === ENDLESS) return Infinity;
  if (kind === "sphere") return a;
  if (kind === "cylinder") return Math.hypot(a, b);
  if (boxed(kind)) return Math.hypot(a, b, c) + d;
  return a + b;
}

/** How far its edges are drawn rounded [m]. @param {Solid} solid */
export const bevelOf = ({ kind, size }) =>
  kind === "cylinder" ? BEVEL * Math.min(size[0], size[1]) : 0;

/** How far a body has turned about its axis [rad]. @param {Solid} solid @param {number} time [s]
 * @param {number[]} wheels how far those have that turn freely [rad] */
export function turnOf({ spin, turns, wheel }, time, wheels = []) {
  if (wheel !== null) return wheels[wheel] || 0;
  if (turns) return onTable(turns, time)[0];
  if (!spin) return 0;
  const [rate, start, stop] = spin;
  return rate * Math.max(0, Math.min(time, stop) - start);
}

/** Whether its surface goes along itself as it turns: marks on it show that. @param {Solid} solid */
export const slides = (solid) =>
  !solid.sweeps && Boolean(solid.spin || solid.turns || solid.wheel !== null);

/** Whether it is drawn elsewhere at another time. @param {Solid} solid */
export const leaves = (solid) =>
  Boolean(solid.motion || (solid.sweeps && (solid.spin || solid.turns || solid.wheel !== null)));

/** A body where it is at a time. @param {Solid} solid @param {number} time [s]
 * @param {number[]} wheels as for `turnOf` @returns {Solid} */
export function placed(solid, time, wheels = []) {
  const found = solid.sweeps ? turned(solid, turnOf(solid, time, wheels)) : solid;
  if (!solid.motion) return found;
  const way = minus(whereabouts(solid.motion, time), solid.motion.origin);
  return way.every((one) => Math.abs(one) < LARGEST)
    ? { ...found, center: plus(found.center, way) }
    : found;
}

/** A body that has turned about its axle. @param {Solid} solid @param {number} angle [rad] @returns {Solid} */
function turned(solid, angle) {
  if (!angle || !Number.isFinite(angle)) return solid;
  const { axle, axis, zero, size, center } = solid;
  const turn = (/** @type {Vector} */ one) => rotated(one, axle, angle);
  const base = minus(center, solid.middle);
  const pivot = plus(base, solid.hub);
  const found = plus(pivot, turn(minus(center, pivot)));
  return {
    ...solid,
    axis: turn(axis),
    zero: turn(zero),
    size: solid.kind === "half-pipe" ? [size[0], ...turn(vector(size.slice(1)))] : size,
    middle: minus(found, base),
    center: found,
  };
}

/** Where what moves is, as the engine has it. @param {Motion} motion @param {number} time [s] @returns {Vector} */
export function whereabouts({ kind, params: p, table }, time) {
  const [from, way, axis] = [vector(p), vector(p.slice(3)), vector(p.slice(6))];
  if (kind === "table") return onTable(table, time);
  if (kind === "velocity") {
    const start = Number(p[6]);
    const elapsed = Math.min(Math.max(time - start, 0), (p[7] ?? Infinity) - start);
    return plus(from, times(way, elapsed));
  }
  if (kind === "shake") {
    const phase = Number(p[7]);
    const offset = Math.sin(2 * Math.PI * Number(p[6]) * time + phase) - Math.sin(phase);
    return plus(from, times(way, offset));
  }
  if (kind !== "orbit") return from;
  const angle = 2 * Math.PI * Number(p[9]) * time;
  return plus(way, rotated(minus(from, way), axis, angle));
}

/** The place on a table: a row has its time, then four coefficients for each of x, y and z.
 * @param {number[][]} table @param {number} time [s] @returns {Vector} */
function onTable(table, time) {
  let low = 0;
  let high = table.length - 1;
  if (time >= table[high][0]) low = high;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (table[middle][0] <= time) low = middle;
    else high = middle;
  }
  const row = table[low];
  const s = low === table.length - 1 ? 0 : Math.max(time - row[0], 0);
  const along = (/** @type {number} */ c) =>
    row[c] + s * (row[c + 1] + s * (row[c + 2] + s * row[c + 3]));
  return [along(1), along(5), along(9)];
}

/** The first three of some numbers. @param {(number | null)[]} values @returns {Vector} */
const vector = ([x, y, z]) => [Number(x), Number(y), Number(z)];

/** How far a place in a trough is from its surface, negative in what is solid [m]. @param {Solid} solid
 * @param {Vector} p from a point of its axis */
function inTrough({ axis, size }, p) {
  const across = minus(p, times(axis, dot(p, axis)));
  const above = vector(size.slice(1));
  const high = dot(across, above) > 0;
  return size[0] - (high ? Math.abs(dot(across, cross(above, axis))) : Math.hypot(...across));
}

/** How far a place is from the surface, of triangles from the box around them, negative inside [m].
 * @param {Solid} solid @param {ArrayLike<number>} place */
export function distanceTo(solid, place) {
  const { kind, center, axis, size } = solid;
  const p = minus(place, center);
  const along = dot(p, axis);
  if (kind === "plane") return along;
  if (kind === "half-pipe") return inTrough(solid, p);
  if (kind === "sphere") return Math.hypot(...p) - size[0];
  if (boxed(kind)) {
    const q = axesOf(solid).map((edge, k) => Math.abs(dot(p, edge)) - size[k]);
    const out = Math.hypot(...q.map((value) => Math.max(value, 0)));
    return out + Math.min(Math.max(...q), 0) - size[3];
  }
  const out = Math.hypot(...minus(p, times(axis, along))) - size[0];
  if (kind === "torus") return Math.hypot(out, along) - size[1];
  const beyond = Math.abs(along) - size[1];
  if (kind === "capsule") return beyond > 0 ? Math.hypot(out + size[0], beyond) - size[0] : out;
  return Math.hypot(Math.max(out, 0), Math.max(beyond, 0)) + Math.min(Math.max(out, beyond), 0);
}

/** How far it extends along a direction from its centre [m]. @param {Solid} solid @param {Vector} direction */
export function extent(solid, direction) {
  const { kind, axis, size } = solid;
  const along = Math.abs(dot(axis, direction));
  const across = Math.sqrt(Math.max(0, 1 - along * along));
  if (kind === "sphere") return size[0];
  if (boxed(kind))
    return axesOf(solid).reduce(
      (sum, edge, k) => sum + Math.abs(dot(direction, edge)) * size[k],
      size[3],
    );
  if (kind === "torus") return size[0] * across + size[1];
  return size[1] * along + size[0] * (kind === "cylinder" ? across : 1);
}

/** Corners of the box around it, in its own directions. @param {Solid} solid @returns {Vector[]} */
export function cornersOf(solid) {
  const axes = axesOf(solid);
  const sizes = axes.map((one) => extent(solid, one));
  return Array.from({ length: 8 }, (_, corner) =>
    axes.reduce(
      (place, one, k) => plus(place, one, (corner >> k) & 1 ? sizes[k] : -sizes[k]),
      solid.center,
    ),
  );
}

/** How far along a way from the eye a body's surface is [m]; null: the way goes past it.
 * @param {Solid} solid @param {Vector} eye @param {Vector} way of length 1 */
export function meets(solid, eye, way) {
  const from = minus(solid.center, eye);
  if (solid.surface) {
    const axes = axesOf(solid);
    const own = (/** @type {Vector} */ one) => vector(axes.map((axis) => dot(axis, one)));
    const far = struck(solid.surface, own(times(from, -1)), own(way));
    return Number.isFinite(far) ? far : null;
  }
  const towards = dot(from, way);
  if (Math.hypot(...minus(from, times(way, towards))) > solid.reach) return null;
  let at = Math.max(0, towards - solid.reach);
  for (let step = 0; step < 80 && at < towards + solid.reach; step++) {
    const away = distanceTo(solid, plus(eye, way, at));
    if (away < 1e-3 * solid.reach) return at;
    at += away;
  }
  return null;
}

/** Whether a body hides a place from the eye: the way to it goes through the body.
 * @param {Solid} solid @param {Vector} eye @param {ArrayLike<number>} place @param {number} slack how far it may
 * lie inside [m] */
export function hides(solid, eye, place, slack) {
  if (solid.kind === "half-pipe") return false; // of a trough the near wall is cut away
  if (solid.kind === "mesh") return false; // only the box around it is known here
  const way = minus(place, eye);
  const far = Math.hypot(...way);
  const ray = times(way, 1 / Math.max(far, 1e-12));
  let at = Number.isFinite(solid.reach)
    ? Math.max(0, Math.hypot(...minus(solid.center, eye)) - solid.reach)
    : 0;
  for (let step = 0; step < 60 && at < far; step++) {
    const away = distanceTo(solid, plus(eye, ray, at)) + slack;
    if (away <= 0) return true;
    at += Math.max(away, 1e-4 * far);
  }
  return false;
}
