// What anchors hold: the forces behind their arrows, and the room that these need in a picture.

import { plus, vector } from "./view/vector.js";

/** @typedef {import("./stage.js").Stage} Stage */
/** @typedef {import("./source/protocol.js").Layout} Layout */
/** @typedef {import("./source/frame.js").Frame} Frame */
/** @typedef {import("./view/camera.js").Camera} Camera */
/** @typedef {import("./view/vector.js").Vector} Vector */
/** An anchor that holds: its force now, the size of that, and the greatest since the frame before [N].
 * @typedef {{variant: number, a: number, anchor: Layout["variants"][0]["anchors"][0], place: Vector, force: Vector,
 *   size: number, peak: number}} Holding */

export const REACTION = 84; // length of the longest arrow [CSS pixels]
export const LEAST = 0.1; // of the strongest, below which there is neither arrow nor label: the eye hides it
const CHIP = 34; // that a label takes beyond its arrow's tip [CSS pixels]
const MOST = 0.12; // of the height that is free, which arrows may take at one side

/** The anchors that hold, where they are. @param {Stage} stage @param {Float32Array} places @returns {Holding[]} */
export function holding({ session }, places) {
  const layout = /** @type {Layout} */ (session.layout);
  const frame = /** @type {Frame} */ (session.frame);
  /** @type {Holding[]} */ const found = [];
  let at = 0;
  layout.variants.forEach((copy, variant) => {
    const part = frame.parts[variant];
    copy.anchors.forEach((anchor, a) => {
      const place = vector(places.subarray(at, at + 3));
      at += 3;
      if (part.anchors[10 * a + 9] < 0.5) return; // it has let go
      if (!place.every(Number.isFinite)) return; // a recorded run may go on after its break
      const force = vector(part.anchors.subarray(10 * a + 6, 10 * a + 9));
      const size = Math.hypot(...force);
      const seen = part.seen.greatestForce[a];
      const peak = Number.isFinite(seen) ? Math.max(size, seen) : size;
      found.push({ variant, a, anchor, place, force, size, peak });
    });
  });
  return found;
}

/** The force of the longest arrow [N]. @param {Holding[]} held */
export const strongestOf = (held) =>
  Math.max(0, ...held.map(({ peak }) => peak).filter(Number.isFinite));

/** The longest arrow [CSS pixels]. @param {Camera} camera */
export const longest = ({ width, height }) => Math.min(REACTION, 0.14 * width, 0.17 * height);

/** What a picture must keep free above and below its ropes, so that arrows and their labels are in it, too: the
 * strips, or more. @param {Stage} stage @param {Camera} camera @param {import("./view/camera.js").Strips} strips */
export function roomFor(stage, camera, strips) {
  const { session, anchors, marks } = stage;
  if (!session.frame || !marks.reactions) return strips;
  const held = holding(stage, anchors.to);
  const strongest = Math.max(strongestOf(held), marks.strongest);
  const per = (longest(camera) * camera.pose.distance) / camera.focal / strongest;
  let [top, bottom] = [0, 0];
  for (const { place, force, size, peak } of held) {
    if (!(peak >= LEAST * strongest) || !(size > 1e-9)) continue;
    const [, y, depth] = camera.project(...plus(place, force, (peak / size) * per));
    if (!(depth > 0)) continue;
    top = Math.max(top, strips.top + CHIP - y);
    bottom = Math.max(bottom, y + CHIP + strips.bottom - camera.height);
  }
  const most = MOST * (camera.height - strips.top - strips.bottom);
  return {
    ...strips,
    top: strips.top + Math.min(most, top),
    bottom: strips.bottom + Math.min(most, bottom),
  };
}

/** Whether a loose end hangs from a held node, along its rope: nothing else holds that end.
 * @param {{anchors: {index: number}[], joints?: {nodes: number[]}[], ropes: {first: number, nodes: number}[]}} copy
 * @param {number} index of the node */
export function hasTail({ anchors, joints, ropes }, index) {
  const rope = ropes.find(({ first, nodes }) => index >= first && index < first + nodes);
  if (!rope) return false;
  const last = rope.first + rope.nodes - 1;
  const tied = (joints ?? []).flatMap(({ nodes }) => nodes);
  const held = [...anchors.map((anchor) => anchor.index), ...tied];
  const loose = (/** @type {number} */ from, /** @type {number} */ to) =>
    from <= to && !held.some((node) => node >= from && node <= to);
  return loose(rope.first, index - 1) || loose(index + 1, last);
}
