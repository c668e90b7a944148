// Posts on the canvas: round where they are seen along their axis, else as wide and as long as they are; and what is
// read of the one that a rope goes round.

import { told } from "./measures.js";
import { toldAngle, toldRatio } from "./posts.js";

/** @typedef {import("./solids.js").Post} Post */
/** @typedef {{pen: CanvasRenderingContext2D, canvas: HTMLCanvasElement, scale: number, tall: number, across: number[],
 *   up: number[], shown(place: [number, number]): [number, number]}} Sheet what is drawn on */

const ALONG = 0.9; // cosine between an axis and the way that one looks
const FAR = 1e4; // metres: beyond every drawing

/** @param {number[]} a @param {number[]} b */
const dot = (a, b) => a.reduce((sum, one, k) => sum + one * b[k], 0);

/** Draw the posts. @param {Sheet} sheet @param {Post[]} posts @param {string} fill @param {string} rim
 * @param {number} ratio pixels of the canvas for one of the page */
export function drawPosts(sheet, posts, fill, rim, ratio) {
  const { pen } = sheet;
  pen.fillStyle = fill;
  pen.strokeStyle = rim;
  pen.lineWidth = 1.5 * ratio;
  for (const post of posts) {
    pen.beginPath();
    if (post.kind === "plane") half(sheet, post);
    else if (post.kind === "sphere" || isSeenAlong(sheet, post)) disc(sheet, post, ratio);
    else bar(sheet, post);
    pen.fill();
    pen.stroke();
  }
}

/** Write the tensions beside a post, and their ratio and the angle on it. @param {Sheet} sheet
 * @param {import("./posts.js").Reading | null} reading @param {[number, number][]} places of the nodes [px]
 * @param {string} ink @param {number} ratio */
export function drawReading(sheet, reading, places, ink, ratio) {
  if (!reading || !(reading.post.kind === "sphere" || isSeenAlong(sheet, reading.post))) return;
  const { pen, scale } = sheet;
  const [x, y] = seen(sheet, reading.post.center);
  pen.fillStyle = ink;
  pen.font = `${13 * ratio}px system-ui, sans-serif`;
  for (const [k, node] of reading.nodes.entries()) {
    const [px, py] = places[node];
    pen.textAlign = px < x ? "right" : "left";
    pen.fillText(told(reading.sides[k], "N"), px + (px < x ? -12 : 12) * ratio, py + 5 * ratio);
  }
  pen.textAlign = "center";
  if (scale * reading.post.radius > 30 * ratio) {
    if (reading.ratio) pen.fillText(`${toldRatio(reading.ratio)} : 1`, x, y - 8 * ratio);
    pen.fillText(toldAngle(reading.angle), x, y + 18 * ratio);
  }
  pen.textAlign = "start";
}

/** @param {Sheet} sheet @param {Post} post */
function isSeenAlong({ across, up }, { axis }) {
  return Math.hypot(dot(axis, across), dot(axis, up)) < Math.sqrt(1 - ALONG ** 2);
}

/** @param {Sheet} sheet @param {number[]} place @returns {[number, number]} */
const seen = (sheet, place) => sheet.shown([dot(place, sheet.across), dot(place, sheet.up)]);

/** @param {Sheet} sheet @param {Post} post @param {number} ratio */
function disc(sheet, { center, radius }, ratio) {
  const { pen, scale, tall } = sheet;
  const [x, y] = seen(sheet, center);
  pen.ellipse(x, y, scale * radius, tall * scale * radius, 0, 0, 2 * Math.PI);
  pen.moveTo(x + 3 * ratio, y);
  pen.arc(x, y, 3 * ratio, 0, 2 * Math.PI); // its axis
}

/** @param {Sheet} sheet @param {Post} post */
function bar(sheet, { center, axis, radius, half: long }) {
  const way = [dot(axis, sheet.across), dot(axis, sheet.up)];
  const size = Math.hypot(...way);
  const side = [(-radius * way[1]) / size, (radius * way[0]) / size];
  const reach = Math.min(long ?? FAR, FAR);
  const middle = [dot(center, sheet.across), dot(center, sheet.up)];
  outline(
    sheet,
    [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([a, b]) =>
      middle.map((one, k) => one + a * reach * way[k] + b * side[k]),
    ),
  ); // prettier-ignore
}

/** All below a plane. @param {Sheet} sheet @param {Post} post */
function half(sheet, { center, axis }) {
  const way = [dot(axis, sheet.across), dot(axis, sheet.up)];
  const size = Math.hypot(...way);
  if (!(size > 0.1)) return; // it is seen from above
  const out = way.map((one) => one / size);
  const middle = [dot(center, sheet.across), dot(center, sheet.up)];
  outline(
    sheet,
    [[-1, 0], [1, 0], [1, -1], [-1, -1]].map(([a, b]) => [
      middle[0] + FAR * (a * out[1] + b * out[0]),
      middle[1] + FAR * (b * out[1] - a * out[0]),
    ]),
  ); // prettier-ignore
}

/** @param {Sheet} sheet @param {number[][]} corners */
function outline(sheet, corners) {
  for (const [i, corner] of corners.entries()) {
    const [x, y] = sheet.shown([corner[0], corner[1]]);
    if (i) sheet.pen.lineTo(x, y);
    else sheet.pen.moveTo(x, y);
  }
  sheet.pen.closePath();
}
