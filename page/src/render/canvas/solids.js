// The bodies that ropes touch on Canvas 2D: their outlines in a few shades, and the marks of those that turn.

import { css } from "../../view/colours.js";
import { drawSurface } from "./surface.js";
import { RIM, axesOf, slides } from "../../view/solids.js";
import { cross, dot, plus, times, unit, minus } from "../../view/vector.js";

/** @typedef {import("../../view/camera.js").Camera} Camera */
/** @typedef {import("../../view/solids.js").Solid} Solid */
/** @typedef {import("../../view/vector.js").Vector} Vector */
/** @typedef {import("../../view/colours.js").Colour} Colour */
/** @typedef {import("../view.js").View} View */
/** @typedef {import("../view.js").Theme} Theme */

const ROUND = 36; // corners of a circle
const MARKS = 6; // of a body that turns
const STRIPS = 12; // of half a pipe
const PIECES = 8; // of each, either way from the middle of the scene
const LONG = 20; // radii of the scene, half of what is endless

/** Draw all bodies, the nearer later. @param {CanvasRenderingContext2D} context @param {View} view
 * @param {Theme} theme */
export function drawSolids(context, view, theme) {
  const { camera, solids, turns, room } = view;
  const depth = (/** @type {Solid} */ one) => camera.project(...one.center)[2];
  const order = solids.map((solid, k) => ({ solid, turn: turns[k], depth: depth(solid) }));
  order.sort((a, b) => b.depth - a.depth);
  for (const { solid, turn } of order) {
    if (solid.kind === "plane") drawPlane(context, camera, solid, room.radius, theme);
    else if (solid.kind === "mesh") drawSurface(context, camera, solid, theme);
    else if (solid.kind === "torus") drawRing(context, camera, solid, theme);
    else if (solid.kind === "half-pipe") drawTrough(context, camera, solid, room, theme);
    else drawBody(context, camera, solid, room.radius, theme);
    if (slides(solid)) drawMarks(context, camera, solid, turn, room.radius, theme);
  }
}

/** @param {Theme} theme @param {number} light */
const shade = (theme, light) =>
  css(/** @type {Colour} */ (theme.body.map((one) => Math.min(1, light * one))));

/** A circle around an axis. @param {Vector} centre @param {Vector} axis @param {number} radius */
function circle(centre, axis, radius) {
  const first = unit(cross(axis, Math.abs(axis[2]) < 0.9 ? [0, 0, 1] : [1, 0, 0]));
  const second = cross(axis, first);
  return Array.from({ length: ROUND }, (_, k) => {
    const angle = (2 * Math.PI * k) / ROUND;
    return plus(plus(centre, first, radius * Math.cos(angle)), second, radius * Math.sin(angle));
  });
}

/** The ends of what lies along a line. @param {Solid} solid @param {number} radius of the scene */
function endsOf({ center, axis, size }, radius) {
  const half = Math.min(size[1], LONG * radius);
  return [plus(center, axis, -half), plus(center, axis, half)];
}

/** Places whose outline is the body's. @param {Camera} camera @param {Solid} solid @param {number} radius */
function outline(camera, solid, radius) {
  const { kind, center, axis, size } = solid;
  const edges = axesOf(solid);
  const ball = (/** @type {Vector} */ at, /** @type {number} */ r) =>
    circle(at, unit(minus(camera.eye, at)), r);
  if (kind === "sphere") return ball(center, size[0]);
  const ends = endsOf(solid, radius);
  if (kind === "cylinder") return ends.flatMap((end) => circle(end, axis, size[0]));
  if (kind === "capsule") return ends.flatMap((end) => ball(end, size[0]));
  return Array.from({ length: 8 }, (_, corner) =>
    ball(
      edges.reduce(
        (place, edge, k) => plus(place, edge, (corner >> k) & 1 ? size[k] : -size[k]),
        center,
      ),
      size[3],
    ),
  ).flat();
}

/** @param {CanvasRenderingContext2D} context @param {Camera} camera @param {Solid} solid @param {number} radius
 * @param {Theme} theme */
function drawBody(context, camera, solid, radius, theme) {
  const hull = hullOf(flat(camera, outline(camera, solid, radius)));
  if (hull.length < 3) return;
  const [low, high] = [Math.min, Math.max].map((pick) => pick(...hull.map(([, y]) => y)));
  const paint = context.createLinearGradient(0, low, 0, high);
  paint.addColorStop(0, shade(theme, 1.15));
  paint.addColorStop(1, shade(theme, 0.68));
  context.fillStyle = paint;
  fill(context, hull);
  if (solid.kind !== "cylinder") return;
  for (const [k, end] of endsOf(solid, radius).entries()) {
    const out = times(solid.axis, k ? 1 : -1);
    const towards = minus(camera.eye, end).reduce((sum, value, i) => sum + value * out[i], 0);
    const face = towards > 0 ? flat(camera, circle(end, solid.axis, solid.size[0])) : [];
    context.fillStyle = shade(theme, 0.92);
    if (face.length === ROUND) fill(context, face);
  }
}

/** @param {CanvasRenderingContext2D} context @param {Camera} camera @param {Solid} solid @param {Theme} theme */
function drawRing(context, camera, { center, axis, size }, theme) {
  const ring = flat(camera, circle(center, axis, size[0]));
  if (ring.length < ROUND) return;
  const wide = (2 * size[1] * camera.focal) / camera.project(...center)[2];
  for (const [part, light] of [
    [1, 0.75],
    [0.55, 1.05],
  ]) {
    context.lineWidth = part * wide;
    context.strokeStyle = shade(theme, light);
    context.beginPath();
    for (const [x, y] of ring) context.lineTo(x, y);
    context.closePath();
    context.stroke();
  }
}

/** @param {CanvasRenderingContext2D} context @param {Camera} camera @param {Solid} solid @param {number} radius
 * @param {Theme} theme */
function drawPlane(context, camera, { center, axis }, radius, theme) {
  const sheet = flat(camera, circle(center, axis, 2.2 * radius));
  if (sheet.length < ROUND) return;
  context.fillStyle = css(theme.body, 0.55);
  fill(context, sheet);
}

/** What is seen of the inside of a half-pipe, in pieces; the near wall is cut away.
 * @param {CanvasRenderingContext2D} context @param {Camera} camera @param {Solid} solid
 * @param {{center: ArrayLike<number>, radius: number}} room @param {Theme} theme */
function drawTrough(context, camera, { center, axis, size }, room, theme) {
  const above = /** @type {Vector} */ (size.slice(1));
  const beside = cross(above, axis);
  const middle = plus(center, axis, dot(minus(room.center, center), axis));
  const edge = (/** @type {number} */ k) => {
    const angle = (Math.PI * Math.min(Math.max(k, 0), STRIPS)) / STRIPS;
    const at = plus(middle, beside, size[0] * Math.cos(angle));
    const high = k < 0 || k > STRIPS ? RIM * size[0] : -size[0] * Math.sin(angle);
    return plus(at, above, high);
  };
  for (let i = 0; i < STRIPS + 2; i++) {
    const [from, to] = [edge(i - 1), edge(i)];
    const half = times(plus(from, to), 0.5);
    const inward = unit(cross(axis, minus(to, from)));
    const facing =
      dot(inward, minus(camera.eye, half)) *
      dot(inward, minus(plus(middle, above, 0.1 * size[0]), half));
    if (facing <= 0) continue;
    context.fillStyle = shade(theme, 0.75 + 0.35 * Math.sin((Math.PI * (i + 0.5)) / (STRIPS + 2)));
    for (let piece = -PIECES; piece < PIECES; piece++) {
      const [a, b] = [piece, piece + 1].map((k) => (2.2 * k * room.radius) / PIECES);
      const corners = [
        plus(from, axis, a),
        plus(from, axis, b),
        plus(to, axis, b),
        plus(to, axis, a),
      ];
      const seen = flat(camera, corners);
      if (seen.length === 4) fill(context, seen);
    }
  }
}

/** @param {CanvasRenderingContext2D} context @param {Camera} camera @param {Solid} solid @param {number} turn
 * @param {number} radius of the scene @param {Theme} theme */
function drawMarks(context, camera, solid, turn, radius, theme) {
  const { kind, center, axis, zero, size } = solid;
  const second = cross(axis, zero);
  context.strokeStyle = shade(theme, 0.5);
  for (let mark = 0; mark < MARKS; mark++) {
    const angle = turn + (2 * Math.PI * mark) / MARKS;
    const out = plus(times(zero, Math.cos(angle)), second, Math.sin(angle));
    const ways = waysOf(kind, out, solid, radius).map(({ way, normal }) => ({
      seen: flat(camera, way),
      facing: minus(camera.eye, plus(center, out, size[0])).reduce(
        (sum, value, k) => sum + value * normal[k],
        0,
      ),
      whole: way.length,
    }));
    context.lineWidth = mark ? 2 : 4;
    for (const { seen, facing, whole } of ways) {
      if (facing <= 0 || seen.length < whole) continue;
      context.beginPath();
      for (const [x, y] of seen) context.lineTo(x, y);
      context.stroke();
    }
  }
}

/** The lines of a mark on a body, each with the direction it looks to. @param {Solid["kind"]} kind
 * @param {Vector} out @param {Solid} solid @param {number} radius of the scene
 * @returns {{way: Vector[], normal: Vector}[]} */
function waysOf(kind, out, solid, radius) {
  const { center, axis, size } = solid;
  if (kind === "plane") return [{ way: [center, plus(center, out, 2 * radius)], normal: axis }];
  if (kind === "sphere") return [{ way: arc(solid, out, center, size[0]), normal: out }];
  if (kind === "torus")
    return [{ way: arc(solid, out, plus(center, out, size[0]), size[1]), normal: out }];
  const ends = endsOf(solid, radius);
  const rims = ends.map((end) => plus(end, out, size[0]));
  const faces = ends.map((end, k) => ({ way: [end, rims[k]], normal: times(axis, k ? 1 : -1) }));
  return [{ way: rims, normal: out }, ...(kind === "cylinder" ? faces : [])];
}

/** Half a circle through the axis, on the side of `out`. @param {Solid} solid @param {Vector} out
 * @param {Vector} middle @param {number} radius @returns {Vector[]} */
function arc({ axis }, out, middle, radius) {
  return Array.from({ length: 13 }, (_, k) => {
    const angle = Math.PI * (k / 12 - 0.5);
    const along = plus(middle, axis, radius * Math.sin(angle));
    return plus(along, out, radius * Math.cos(angle));
  });
}

/** @param {Camera} camera @param {Vector[]} places those before the eye @returns {[number, number][]} */
function flat(camera, places) {
  return places
    .map((place) => camera.project(...place))
    .filter(([, , depth]) => depth > 0.02 * camera.pose.distance)
    .map(([x, y]) => [x, y]);
}

/** @param {CanvasRenderingContext2D} context @param {[number, number][]} places */
function fill(context, places) {
  context.beginPath();
  for (const [x, y] of places) context.lineTo(x, y);
  context.fill();
}

/** The convex hull (Andrew's chains). @param {[number, number][]} places @returns {[number, number][]} */
export function hullOf(places) {
  const sorted = [...places].sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  const half = (/** @type {[number, number][]} */ row) => {
    /** @type {[number, number][]} */ const found = [];
    for (const p of row) {
      while (found.length > 1) {
        const [a, b] = found.slice(-2);
        if ((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]) > 0) break;
        found.pop();
      }
      found.push(p);
    }
    return found.slice(0, -1);
  };
  return [...half(sorted), ...half(sorted.reverse())];
}
