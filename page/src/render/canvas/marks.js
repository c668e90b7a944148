// Balls, eye bolts, rings and arrows on Canvas 2D.

import { css } from "../../view/colours.js";

/** @typedef {import("../../view/camera.js").Camera} Camera */
/** @typedef {import("../view.js").Marker} Marker */
/** @typedef {import("../view.js").Arrow} Arrow */

/** @param {CanvasRenderingContext2D} context @param {Camera} camera @param {Marker} marker */
export function drawMarker(context, camera, marker) {
  const [x, y, depth] = camera.project(marker.x, marker.y, marker.z);
  if (depth <= 0) return;
  const radius = 0.5 * Math.max(marker.pixels, (marker.size * camera.focal) / depth);
  const dark = /** @type {[number, number, number]} */ (marker.colour.map((c) => 0.72 * c));
  context.beginPath();
  if (marker.kind === "ring") {
    context.arc(x, y, radius - 1.2, 0, 2 * Math.PI);
    context.lineWidth = 2.4;
    context.strokeStyle = css(marker.colour);
    context.stroke();
    return;
  }
  if (marker.kind === "eye") {
    context.arc(x, y, 0.7 * radius, 0, 2 * Math.PI);
    for (const [width, colour] of /** @type {const} */ ([
      [0.65, dark],
      [0.4, marker.colour],
    ])) {
      context.lineWidth = width * radius;
      context.strokeStyle = css(colour);
      context.stroke();
    }
    return;
  }
  context.arc(x, y, radius, 0, 2 * Math.PI);
  context.fillStyle = css(marker.colour);
  context.fill();
  context.lineWidth = 1.5;
  context.strokeStyle = css(dark);
  if (marker.kind === "knot") {
    const half = 0.6 * radius;
    context.moveTo(x - half, y + half);
    context.lineTo(x + half, y - half);
    context.moveTo(x - half, y - half);
    context.lineTo(x + half, y + half);
  }
  context.stroke();
}

/** @param {CanvasRenderingContext2D} context @param {Camera} camera @param {Arrow} arrow */
export function drawArrow(context, camera, arrow) {
  const [x, y, near] = camera.project(arrow.from[0], arrow.from[1], arrow.from[2]);
  const [u, v, far] = camera.project(arrow.to[0], arrow.to[1], arrow.to[2]);
  if (near <= 0 || far <= 0) return;
  const size = Math.hypot(u - x, v - y);
  if (size < 1) return;
  const [dx, dy] = [(u - x) / size, (v - y) / size];
  const tip = arrow.head ? Math.min(0.5 * size, 5.5 * arrow.pixels) : 0;
  context.lineCap = "butt";
  context.lineWidth = arrow.pixels;
  context.strokeStyle = context.fillStyle = css(arrow.colour);
  context.beginPath();
  context.moveTo(x, y);
  context.lineTo(u - tip * dx, v - tip * dy);
  context.stroke();
  context.lineCap = "round";
  if (!tip) return;
  const wide = 2.2 * arrow.pixels;
  context.beginPath();
  context.moveTo(u, v);
  context.lineTo(u - tip * dx - wide * dy, v - tip * dy + wide * dx);
  context.lineTo(u - tip * dx + wide * dy, v - tip * dy - wide * dx);
  context.fill();
}
