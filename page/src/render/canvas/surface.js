// A body of triangles on Canvas 2D: those that face the eye, the farther first.

import { css } from "../../view/colours.js";
import { axesOf } from "../../view/solids.js";
import { vector } from "../../view/surface.js";
import { dot, minus, plus, times } from "../../view/vector.js";

/** @typedef {import("../../view/colours.js").Colour} Colour */

const MOST = 20_000; // triangles; of more every so many

/** @param {CanvasRenderingContext2D} context @param {import("../../view/camera.js").Camera} camera
 * @param {import("../../view/solids.js").Solid} solid @param {import("../view.js").Theme} theme */
export function drawSurface(context, camera, solid, theme) {
  const { surface, center } = solid;
  if (!surface) return;
  const [first, second, third] = axesOf(solid);
  const lie = (/** @type {import("../../view/vector.js").Vector} */ [x, y, z]) =>
    plus(plus(times(first, x), second, y), third, z);
  const count = surface.places.length / 9;
  const seen = [];
  for (let face = 0; face < count; face += Math.ceil(count / MOST)) {
    const places = [0, 1, 2].map((k) => plus(center, lie(vector(surface.places, 3 * face + k))));
    const normals = [0, 1, 2].map((k) => lie(vector(surface.normals, 3 * face + k)));
    const normal = times(plus(plus(normals[0], normals[1]), normals[2]), 1 / 3);
    if (dot(normal, minus(camera.eye, places[0])) <= 0) continue;
    const flat = places.map((place) => camera.project(...place));
    if (flat.some(([, , depth]) => depth < 0.02 * camera.pose.distance)) continue;
    const wrapped = Math.max(dot(normal, camera.light) + 0.2, 0) / 1.2;
    const light = 0.6 + 0.2 * dot(normal, camera.up) + 0.35 * wrapped * wrapped;
    seen.push({ flat, light, depth: flat.reduce((sum, one) => sum + one[2], 0) });
  }
  seen.sort((a, b) => b.depth - a.depth);
  context.lineWidth = 0.7; // closes the seams
  for (const { flat, light } of seen) {
    const paint = css(/** @type {Colour} */ (theme.body.map((one) => Math.min(1, light * one))));
    context.fillStyle = context.strokeStyle = paint;
    context.beginPath();
    for (const [x, y] of flat) context.lineTo(x, y);
    context.closePath();
    context.fill();
    context.stroke();
  }
}
