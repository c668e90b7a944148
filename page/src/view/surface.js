// Bodies of triangles, as they are drawn: corners with the normals that light falls on, about the middle.

import { cross, dot, minus, plus, times, unit } from "./vector.js";

/** @typedef {import("./vector.js").Vector} Vector */

/** `half` is half the size of the box around it; `places`, from its middle, and `normals` have three numbers for each
 * of a triangle's corners.
 * @typedef {{middle: Vector, half: Vector, reach: number, places: Float32Array, normals: Float32Array}} Surface */

const SMOOTH = Math.cos(0.6); // of the angle [rad] up to which an edge between triangles is drawn round

/** @param {number[]} vertices three numbers each [m] @param {number[]} faces three vertices each
 * @returns {Surface | null} */
export function surfaceOf(vertices, faces) {
  const count = vertices.length / 3;
  if (!faces.length || !faces.every((one) => Number.isInteger(one) && one >= 0 && one < count))
    return null;
  const corners = Array.from({ length: count }, (_, k) => vector(vertices, k));
  const low = corners.reduce((a, b) => lesser(a, b));
  const high = corners.reduce((a, b) => times(lesser(times(a, -1), times(b, -1)), -1));
  const middle = times(plus(low, high), 0.5);
  const triangles = Array.from({ length: faces.length / 3 }, (_, k) =>
    faces.slice(3 * k, 3 * k + 3).map((corner) => minus(corners[corner], middle)),
  );
  const flat = triangles.map(([a, b, c]) => unit(cross(minus(b, a), minus(c, a))));
  /** @type {number[][]} */
  const around = corners.map(() => []);
  faces.forEach((corner, k) => around[corner].push(Math.floor(k / 3)));
  const places = new Float32Array(3 * faces.length);
  const normals = new Float32Array(3 * faces.length);
  faces.forEach((corner, k) => {
    const own = flat[Math.floor(k / 3)];
    const soft = around[corner].map((face) => flat[face]).filter((one) => dot(one, own) > SMOOTH);
    places.set(triangles[Math.floor(k / 3)][k % 3], 3 * k);
    normals.set(unit(soft.reduce((sum, one) => plus(sum, one))), 3 * k);
  });
  const half = times(minus(high, low), 0.5);
  return { middle, half, reach: Math.hypot(...half), places, normals };
}

/** How far along a way from a place, which is counted from the middle, the first triangle is [m];
 * Infinity: the way meets none (Möller and Trumbore 1997).
 * @param {Surface} surface @param {Vector} from @param {Vector} way of length 1 */
export function struck({ places, reach }, from, way) {
  const nearest = times(way, -dot(from, way));
  if (Math.hypot(...plus(from, nearest)) > reach) return Infinity;
  let best = Infinity;
  for (let k = 0; k < places.length / 3; k += 3) {
    const a = vector(places, k);
    const [ab, ac] = [minus(vector(places, k + 1), a), minus(vector(places, k + 2), a)];
    const p = cross(way, ac);
    const size = dot(ab, p);
    if (size === 0) continue;
    const t = minus(from, a);
    const u = dot(t, p) / size;
    if (!(u >= 0 && u <= 1)) continue;
    const q = cross(t, ab);
    const v = dot(way, q) / size;
    const far = dot(ac, q) / size;
    if (v >= 0 && u + v <= 1 && far >= 0 && far < best) best = far;
  }
  return best;
}

/** @param {ArrayLike<number>} values @param {number} k @returns {Vector} */
export const vector = (values, k) => [values[3 * k], values[3 * k + 1], values[3 * k + 2]];

/** @param {Vector} a @param {Vector} b @returns {Vector} */
const lesser = (a, b) => [Math.min(a[0], b[0]), Math.min(a[1], b[1]), Math.min(a[2], b[2])];
