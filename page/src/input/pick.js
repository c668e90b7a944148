// What lies under the pointer: an anchor, else the nearest place on a rope.

import { vector } from "../view/vector.js";

/** @typedef {import("../stage.js").Stage} Stage */
/** @typedef {import("../view/vector.js").Vector} Vector */
/** @typedef {{kind: "anchor", variant: number, anchor: string, node: number, segment: number,
 *   place: Vector}} AnchorHit */
/** @typedef {{kind: "node", variant: number, rope: string, node: number, segment: number,
 *   place: Vector}} NodeHit */
/** @typedef {{kind: "obstacle", variant: number, obstacle: string, node: number, segment: number,
 *   place: Vector, joint?: undefined}} BodyHit */
/** The name of a joint that ties the node. @typedef {{joint?: string}} Tied */
/** @typedef {(AnchorHit | NodeHit) & Tied} Hit node and segment are indices in the variant */

/** @param {Stage} stage @param {number} px @param {number} py @param {number} reach pixels
 * @returns {Hit | null} */
export function pick(stage, px, py, reach) {
  const hit = pickAnchor(stage, px, py, reach * 1.3) ?? pickNode(stage, px, py, reach);
  return hit && { ...hit, ...tied(stage, hit, px, py, reach) };
}

/** The joint under the pointer, where what was hit is tied by one: its node is then the hit's.
 * @param {Stage} stage @param {Hit} hit @param {number} px @param {number} py @param {number} reach */
function tied(stage, hit, px, py, reach) {
  const joints = stage.session.layout?.variants[hit.variant].joints ?? [];
  for (const node of [hit.node, hit.segment, hit.segment + 1]) {
    const joint = joints.find(({ nodes }) => nodes.includes(node));
    if (!joint) continue;
    const { x, y, depth } = stage.screenOf(node, hit.variant);
    if (depth > 0 && Math.hypot(x - px, y - py) < reach)
      return hit.kind === "node" ? { joint: joint.name, node } : { joint: joint.name };
  }
  return {};
}

/** @param {Stage} stage @param {number} px @param {number} py @param {number} reach
 * @returns {AnchorHit | null} */
function pickAnchor(stage, px, py, reach) {
  const { layout, frame } = stage.session;
  if (!layout || !frame) return null;
  /** @type {AnchorHit | null} */
  let best = null;
  let nearest = reach;
  let at = 0;
  layout.variants.forEach((variant, v) => {
    variant.anchors.forEach((anchor, a) => {
      const place = vector(stage.anchors.shown.subarray(at, at + 3));
      at += 3;
      if (frame.parts[v].anchors[10 * a + 9] < 0.5) return;
      const [x, y, depth] = stage.camera.project(...place);
      const away = Math.hypot(x - px, y - py);
      if (depth <= 0 || away >= nearest) return;
      nearest = away;
      const segment = Math.min(anchor.index, variant.nodes - 2);
      best = {
        kind: "anchor",
        variant: v,
        anchor: anchor.name,
        node: anchor.index,
        segment,
        place,
      };
    });
  });
  return best;
}

/** @param {Stage} stage @param {number} px @param {number} py @param {number} reach
 * @returns {NodeHit | null} */
function pickNode(stage, px, py, reach) {
  const { layout } = stage.session;
  if (!layout) return null;
  const { shown } = stage.nodes;
  /** @type {NodeHit | null} */
  let best = null;
  let nearest = reach;
  layout.variants.forEach((variant, v) => {
    for (const rope of variant.ropes) {
      const gone = stage.gaps.now[v] ?? [];
      let [x0, y0, behind] = [0, 0, true];
      for (let i = rope.first; i < rope.first + rope.nodes; i++) {
        const at = 4 * (stage.starts[v] + i);
        const [x1, y1, depth] = stage.camera.project(shown[at], shown[at + 1], shown[at + 2]);
        if (i > rope.first && !behind && depth > 0 && !gone.includes(i - 1)) {
          const [away, part] = distance(px, py, x0, y0, x1, y1);
          if (away < nearest) {
            nearest = away;
            const node = part > 0.5 ? i : i - 1;
            const q = 4 * (stage.starts[v] + node);
            const place = vector(shown.subarray(q, q + 3));
            best = { kind: "node", variant: v, rope: rope.name, node, segment: i - 1, place };
          }
        }
        [x0, y0, behind] = [x1, y1, depth <= 0];
      }
    }
  });
  return best;
}

/** Where what was hit is now. @param {Stage} stage @param {Hit | BodyHit} hit
 * @returns {Vector | null} null if it is gone */
export function placeOf(stage, hit) {
  if (hit.kind === "obstacle") return stage.solids.named(hit.obstacle)?.center ?? null;
  const variant = stage.session.layout?.variants[hit.variant];
  if (!variant || hit.node >= variant.nodes) return null;
  const at = 4 * (stage.starts[hit.variant] + hit.node);
  return vector(stage.nodes.shown.subarray(at, at + 3));
}

/** Distance of a point from a segment, and where along it (0 to 1) the nearest point is.
 * @param {number} px @param {number} py @param {number} x0 @param {number} y0 @param {number} x1
 * @param {number} y1
 * @returns {[number, number]} */
export function distance(px, py, x0, y0, x1, y1) {
  const [dx, dy] = [x1 - x0, y1 - y0];
  const size = dx * dx + dy * dy;
  const part = size > 0 ? Math.min(1, Math.max(0, ((px - x0) * dx + (py - y0) * dy) / size)) : 0;
  return [Math.hypot(px - x0 - part * dx, py - y0 - part * dy), part];
}
