// What lies under the pointer and can be seen: an anchor, else the nearest place on a rope.

import { hides, meets } from "../view/solids.js";
import { length, minus, plus, times, vector } from "../view/vector.js";

/** @typedef {import("../viewport.js").Viewport} Viewport */
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

/** @param {Viewport} viewport @param {number} px @param {number} py @param {number} reach pixels
 * @returns {Hit | null} */
export function pick(viewport, px, py, reach) {
  const hit = pickAnchor(viewport, px, py, reach * 1.3) ?? pickNode(viewport, px, py, reach);
  return hit && { ...hit, ...tied(viewport, hit, px, py, reach) };
}

/** The joint under the pointer, where what was hit is tied by one: its node is then the hit's.
 * @param {Viewport} viewport @param {Hit} hit @param {number} px @param {number} py @param {number} reach */
function tied(viewport, hit, px, py, reach) {
  const joints = viewport.session.layout?.variants[hit.variant].joints ?? [];
  for (const node of [hit.node, hit.segment, hit.segment + 1]) {
    const joint = joints.find(({ nodes }) => nodes.includes(node));
    if (!joint) continue;
    const { x, y, depth } = viewport.screenOf(node, hit.variant);
    if (depth > 0 && Math.hypot(x - px, y - py) < reach)
      return hit.kind === "node" ? { joint: joint.name, node } : { joint: joint.name };
  }
  return {};
}

/** Whether a body is before a place that is drawn so thick, at least. @param {Viewport} viewport
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

/** @param {Viewport} viewport @param {number} px @param {number} py @param {number} reach
 * @returns {AnchorHit | null} */
function pickAnchor(viewport, px, py, reach) {
  const { layout, frame } = viewport.session;
  if (!layout || !frame) return null;
  /** @type {AnchorHit | null} */
  let best = null;
  let nearest = reach;
  let at = 0;
  layout.variants.forEach((variant, v) => {
    variant.anchors.forEach((anchor, a) => {
      const place = vector(viewport.anchors.shown.subarray(at, at + 3));
      at += 3;
      if (frame.parts[v].anchors[10 * a + 9] < 0.5) return;
      const [x, y, depth] = viewport.camera.project(...place);
      const away = Math.hypot(x - px, y - py);
      if (depth <= 0 || away >= nearest || covered(viewport, place, depth, EYE)) return;
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

/** @param {Viewport} viewport @param {number} px @param {number} py @param {number} reach
 * @returns {NodeHit | null} */
function pickNode(viewport, px, py, reach) {
  const { layout } = viewport.session;
  if (!layout) return null;
  const { shown } = viewport.nodes;
  const half = viewport.leastWidth / 2;
  /** @type {NodeHit | null} */
  let best = null;
  let [nearest, front] = [reach, Infinity];
  layout.variants.forEach((variant, v) => {
    for (const rope of variant.ropes) {
      const gone = viewport.gaps.now[v] ?? [];
      let [x0, y0, z0] = [0, 0, 0]; // depth, of the node before
      for (let i = rope.first; i < rope.first + rope.nodes; i++) {
        const at = 4 * (viewport.starts[v] + i);
        const [x1, y1, z1] = viewport.camera.project(shown[at], shown[at + 1], shown[at + 2]);
        if (i > rope.first && z0 > 0 && z1 > 0 && !gone.includes(i - 1)) {
          const [off, part] = distance(px, py, x0, y0, x1, y1);
          const depth = z0 + part * (z1 - z0);
          const drawn = Math.max(half, (rope.diameter / 2) * (viewport.camera.focal / depth));
          const away = Math.max(off - drawn, 0) + half; // on what is drawn: then the one in front
          if (away < reach && (away < nearest || (away === nearest && depth < front))) {
            const [a, b] = [
              vector(shown.subarray(at - 4, at - 1)),
              vector(shown.subarray(at, at + 3)),
            ];
            const here = plus(times(a, 1 - part), times(b, part));
            if (!covered(viewport, here, depth, half, rope.diameter / 2)) {
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

/** Where what was hit is now. @param {Viewport} viewport @param {Hit | BodyHit} hit
 * @returns {Vector | null} null if it is gone */
export function placeOf(viewport, hit) {
  if (hit.kind === "obstacle") return viewport.solids.named(hit.obstacle)?.center ?? null;
  const variant = viewport.session.layout?.variants[hit.variant];
  if (!variant || hit.node >= variant.nodes) return null;
  const at = 4 * (viewport.starts[hit.variant] + hit.node);
  return vector(viewport.nodes.shown.subarray(at, at + 3));
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
