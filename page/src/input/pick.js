// What lies under the pointer and can be seen: an anchor, else the nearest place on a rope.

import { hides, meets } from "../view/solids.js";
import { length, minus, plus, times, vector } from "../view/vector.js";

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

const EYE = 9; // half of an anchor's eye [CSS pixels]

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

/** Whether a body is before a place that is drawn so thick, at least. @param {Stage} stage
 * @param {Vector} place @param {number} depth [m] @param {number} pixels half its width @param {number} [radius] [m] */
function covered({ camera, solids }, place, depth, pixels, radius = 0) {
  const slack = Math.max(radius, (pixels * depth) / camera.focal);
  const way = minus(place, camera.eye);
  const far = length(way);
  return solids.all.some((one) =>
    one.surface
      ? (meets(one, camera.eye, times(way, 1 / far)) ?? Infinity) < far - slack
      : hides(one, camera.eye, place, slack),
  );
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
      if (depth <= 0 || away >= nearest || covered(stage, place, depth, EYE)) return;
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
  const half = stage.leastWidth / 2;
  /** @type {NodeHit | null} */
  let best = null;
  let [nearest, front] = [reach, Infinity];
  layout.variants.forEach((variant, v) => {
    for (const rope of variant.ropes) {
      const gone = stage.gaps.now[v] ?? [];
      let [x0, y0, z0] = [0, 0, 0]; // depth, of the node before
      for (let i = rope.first; i < rope.first + rope.nodes; i++) {
        const at = 4 * (stage.starts[v] + i);
        const [x1, y1, z1] = stage.camera.project(shown[at], shown[at + 1], shown[at + 2]);
        if (i > rope.first && z0 > 0 && z1 > 0 && !gone.includes(i - 1)) {
          const [off, part] = distance(px, py, x0, y0, x1, y1);
          const depth = z0 + part * (z1 - z0);
          const drawn = Math.max(half, (rope.diameter / 2) * (stage.camera.focal / depth));
          const away = Math.max(off - drawn, 0) + half; // on what is drawn: then the one in front
          if (away < reach && (away < nearest || (away === nearest && depth < front))) {
            const [a, b] = [
              vector(shown.subarray(at - 4, at - 1)),
              vector(shown.subarray(at, at + 3)),
            ];
            const here = plus(times(a, 1 - part), times(b, part));
            if (!covered(stage, here, depth, half, rope.diameter / 2)) {
              [nearest, front] = [away, depth];
              const [node, place] = part > 0.5 ? [i, b] : [i - 1, a];
              best = { kind: "node", variant: v, rope: rope.name, node, segment: i - 1, place };
            }
          }
        }
        [x0, y0, z0] = [x1, y1, z1];
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
