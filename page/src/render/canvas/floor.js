// The ground on Canvas 2D: a soft disc and a grid that fades out.

import { plus } from "../../view/vector.js";
import { css } from "../../view/colours.js";

/** @typedef {import("../../view/camera.js").Camera} Camera */
/** @typedef {import("../view.js").Ground} Ground */
/** @typedef {import("../view.js").Theme} Theme */

const HALF = 14;
const PIECES = 8;

/** @param {CanvasRenderingContext2D} context @param {Camera} camera @param {Ground} ground
 * @param {Theme} theme */
export function drawFloor(context, camera, ground, theme) {
  for (const [part, alpha] of [
    [1, 0.25],
    [0.75, 0.35],
    [0.5, 0.5],
  ]) {
    const radius = ground.spacing * HALF * part;
    context.beginPath();
    for (let i = 0; i < 48; i++) {
      const angle = (2 * Math.PI * i) / 48;
      const across = plus(ground.center, camera.first, radius * Math.cos(angle));
      const [x, y, depth] = camera.project(
        ...plus(across, camera.second, radius * Math.sin(angle)),
      );
      if (depth > 0.02 * camera.pose.distance) context.lineTo(x, y);
    }
    context.fillStyle = css(theme.ground, alpha);
    context.fill();
  }
}

/** @param {CanvasRenderingContext2D} context @param {Camera} camera @param {Ground} ground
 * @param {Theme} theme */
export function drawGrid(context, camera, ground, theme) {
  context.lineWidth = 1;
  /** @type {number[][]} segments by how strong they are */
  const strengths = [[], [], []];
  for (const [over, along] of [
    [camera.first, camera.second],
    [camera.second, camera.first],
  ]) {
    for (let line = -HALF; line <= HALF; line++) {
      const start = plus(ground.center, over, line * ground.spacing);
      for (let piece = 0; piece < PIECES; piece++) {
        const [a, b] = [piece, piece + 1].map((k) => ((2 * k) / PIECES - 1) * HALF);
        const away = Math.hypot(line, (a + b) / 2) / HALF;
        if (away > 0.95) continue;
        const p = camera.project(...plus(start, along, a * ground.spacing));
        const q = camera.project(...plus(start, along, b * ground.spacing));
        if (p[2] <= 0.02 * camera.pose.distance || q[2] <= 0.02 * camera.pose.distance) continue;
        strengths[away < 0.45 ? 0 : away < 0.7 ? 1 : 2].push(p[0], p[1], q[0], q[1]);
      }
    }
  }
  strengths.forEach((ends, k) => {
    context.strokeStyle = css(theme.grid, [0.8, 0.5, 0.2][k]);
    context.beginPath();
    for (let i = 0; i < ends.length; i += 4) {
      context.moveTo(ends[i], ends[i + 1]);
      context.lineTo(ends[i + 2], ends[i + 3]);
    }
    context.stroke();
  });
}
