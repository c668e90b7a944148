// Small vectors as plain arrays of three numbers [m].

/** @typedef {[number, number, number]} Vector */

/** Three numbers as a vector. @type {(a: ArrayLike<number>) => Vector} */
export const vector = (a) => [a[0], a[1], a[2]];

/** @type {(a: ArrayLike<number>, b: ArrayLike<number>) => number} */
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

/** @type {(a: ArrayLike<number>, b: ArrayLike<number>) => Vector} */
export const cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

/** @type {(a: ArrayLike<number>, b: ArrayLike<number>) => Vector} */
export const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];

/** a + s b. @type {(a: ArrayLike<number>, b: ArrayLike<number>, s?: number) => Vector} */
export const plus = (a, b, s = 1) => [a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]];

/** @type {(a: ArrayLike<number>, s: number) => Vector} */
export const times = (a, s) => [a[0] * s, a[1] * s, a[2] * s];

/** @type {(a: ArrayLike<number>) => number} */
export const length = (a) => Math.hypot(a[0], a[1], a[2]);

/** A vector turned about an axis of length 1 by an angle [rad] (Rodrigues' formula).
 * @type {(a: ArrayLike<number>, axis: Vector, angle: number) => Vector} */
export function rotated(a, axis, angle) {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  return plus(plus(times(a, c), cross(axis, a), s), axis, dot(axis, a) * (1 - c));
}

/** The unit vector along `a`, or `fallback` where `a` is zero.
 * @param {ArrayLike<number>} a @param {Vector} [fallback] @returns {Vector} */
export function unit(a, fallback = [0, 0, 1]) {
  const size = length(a);
  return size > 0 ? times(a, 1 / size) : fallback;
}
