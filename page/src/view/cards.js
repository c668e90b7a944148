// Cards that lie over the scene: whether one covers a rope, and what to keep free because of it.

import { vector } from "./vector.js";

/** @typedef {import("./camera.js").Camera} Camera */

const TOOLS = 60; // height of the tool bars where they lie in a row, above a card [CSS pixels]
const ROOMY = 400; // width that must be left beside a card [CSS pixels]
const LOW = 400; // height of a scene in which they always do [CSS pixels]
const BETWEEN = 0.3; // of a scene's width: what ropes need between tools
const NARROW = 430; // width of a scene in which they do, too [CSS pixels]

/** Whether a card lies over a rope. @param {Camera} camera @param {Float32Array} nodes x, y, z, value
 * @param {number} count @param {DOMRect | null} card */
export function covers(camera, nodes, count, card) {
  if (!card) return false;
  for (let i = 0; i < count; i++) {
    const [x, y] = camera.project(...vector(nodes.subarray(4 * i, 4 * i + 3)));
    if (x > card.left && x < card.right && y > card.top && y < card.bottom) return true;
  }
  return false;
}

/** What a card takes of the scene's height, at the top or at the bottom [CSS pixels].
 * @param {DOMRect | null} card @param {{width: number, height: number}} scene [CSS pixels] */
export function stripsBeside(card, { width, height }) {
  const row = height > 3 * TOOLS && (height < LOW || width <= NARROW);
  if (!card) return { top: row ? TOOLS : 0, bottom: 0 };
  const below = height - card.top;
  return card.bottom < below ? { top: card.bottom, bottom: 0 } : { top: TOOLS, bottom: below };
}

/** What a card at the left takes of the scene's width; null where it is none, or would leave too little.
 * @param {DOMRect | null} card @param {{width: number, height: number}} scene [CSS pixels] */
export function stripAside(card, { width, height }) {
  return card && width - card.right > ROOMY
    ? { ...stripsBeside(null, { width, height }), left: card.right }
    : null;
}

/** What tools at both sides take of the width of a scene that has no height to spare for them.
 * @param {{left: number, right: number}[]} bars [CSS pixels] @param {{width: number, height: number}} scene */
export function stripsBetween(bars, { width, height }) {
  if (height > 3 * TOOLS) return {};
  const middle = (/** @type {{left: number, right: number}} */ bar) => (bar.left + bar.right) / 2;
  const left = Math.max(
    0,
    ...bars.filter((bar) => middle(bar) < width / 2).map((bar) => bar.right),
  );
  const first = Math.min(
    width,
    ...bars.filter((bar) => middle(bar) >= width / 2).map((bar) => bar.left),
  );
  return first - left > BETWEEN * width ? { left, right: width - first } : {};
}

/** Where a card lies in the scene; null: it is not shown. @param {HTMLElement} card @param {HTMLElement} canvas */
export function placeOn(card, canvas) {
  if (!card.getClientRects().length) return null;
  const { x, y, width, height } = card.getBoundingClientRect();
  const scene = canvas.getBoundingClientRect();
  return new DOMRect(x - scene.x, y - scene.y, width, height);
}
