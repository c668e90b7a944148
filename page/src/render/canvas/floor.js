// The surroundings on Canvas 2D: sky, floor, and a grid that fades out.

import { plus } from "../../view/vector.js";
import { css } from "../../view/colours.js";

/** @typedef {import("../../view/camera.js").Camera} Camera */
/** @typedef {import("../view.js").Ground} Ground */
/** @typedef {import("../view.js").Theme} Theme */

const HALF = 14;
const PIECES = 8;

/** Sky and floor, which meet at the horizon. @param {CanvasRenderingContext2D} context @param {Camera} camera
 * @param {Theme} theme */
export function drawSky(context, camera, theme) {
  const { width, height, focal } = camera;
  const level = height / 2 - focal * Math.tan(Math.min(1.5, camera.pose.elevation));
  const at = (/** @type {number} */ y) => Math.min(1, Math.max(0, y / height));
  const sheet = context.createLinearGradient(0, 0, 0, height);
  sheet.addColorStop(0, css(level > 0 ? theme.background : theme.ground));
  sheet.addColorStop(at(level), css(level > 0 ? theme.horizon : theme.ground));
  sheet.addColorStop(at(level + 0.35 * height), css(theme.ground));
  context.fillStyle = sheet;
  context.fillRect(0, 0, width, height);
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
