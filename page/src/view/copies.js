// Where the nodes of several copies of a scene lie in the arrays that are drawn, and side by side or not.

import { times } from "./vector.js";
import { ROPES, fromHex } from "./colours.js";

/** @typedef {import("../source/protocol.js").Layout} Layout */
/** @typedef {import("../render/view.js").Shape} Shape */

/** First node of each variant in the drawn arrays. @param {Layout} layout */
export function starts(layout) {
  const list = [];
  let at = 0;
  for (const variant of layout.variants) {
    list.push(at);
    at += variant.nodes;
  }
  return list;
}

/** @param {Layout} layout */
export const nodesOf = (layout) => layout.variants.reduce((sum, variant) => sum + variant.nodes, 0);

/** Which colour a rope of a copy has: its own, or the copy's where several are compared.
 * @param {Layout} layout @param {number} variant @param {number} rope */
export function colourOf(layout, variant, rope) {
  const index = layout.variants.length > 1 ? variant : layout.variants[variant].ropes[rope].color;
  return fromHex(ROPES[index % ROPES.length]);
}

/** What the renderers draw: a rope that has parted in as many pieces. @param {Layout} layout
 * @param {number[][]} [gaps] segments of each variant that have parted @returns {Shape} */
export function shapeOf(layout, gaps = []) {
  const first = starts(layout);
  /** @type {Shape["ropes"]} */
  const ropes = [];
  layout.variants.forEach((variant, v) => {
    variant.ropes.forEach((rope, r) => {
      for (const piece of piecesOf(rope, gaps[v] ?? [])) {
        ropes.push({
          name: rope.name,
          first: first[v] + piece.first,
          count: piece.nodes,
          radius: rope.diameter / 2,
          spacing: rope.length / Math.max(1, rope.segments),
          colour: colourOf(layout, v, r),
          loose: looseEnds(variant, piece),
        });
      }
    });
  });
  return { nodes: nodesOf(layout), ropes };
}

/** The nodes of a rope between its gaps. @param {{first: number, nodes: number}} rope
 * @param {number[]} gaps */
function piecesOf({ first, nodes }, gaps) {
  const last = first + nodes - 1;
  const inside = gaps.filter((j) => j >= first && j < last).sort((a, b) => a - b);
  return [...inside, last].map((end, i) => {
    const begin = i === 0 ? first : inside[i - 1] + 1;
    return { first: begin, nodes: end - begin + 1 };
  });
}

/** The segments of each variant that have parted by a time [s]. @param {Layout} layout @param {number} time */
export const gapsAt = (layout, time) =>
  layout.variants.map(({ gaps }) =>
    (gaps ?? []).filter((gap) => gap.time <= time).map(({ index }) => index),
  );

/** Whether the first and the last node of a rope hang free. @param {Layout["variants"][0]} variant
 * @param {{first: number, nodes: number}} rope @returns {[boolean, boolean]} */
function looseEnds({ anchors, loads, joints }, { first, nodes }) {
  const held = new Set([...anchors, ...loads].map(({ index }) => index));
  for (const joint of joints ?? []) for (const node of joint.nodes) held.add(node);
  return [!held.has(first), !held.has(first + nodes - 1)];
}

/** Where a rope may have a kink: at what holds it, at loads and joints. @param {Layout} layout */
export function cornersOf(layout) {
  const first = starts(layout);
  const corners = new Uint8Array(nodesOf(layout));
  layout.variants.forEach(({ anchors, loads, joints }, v) => {
    for (const { index } of [...anchors, ...loads]) corners[first[v] + index] = 1;
    for (const joint of joints ?? []) for (const node of joint.nodes) corners[first[v] + node] = 1;
  });
  return corners;
}

/** Shifts of the copies [m]: none, or side by side along a level direction.
 * @param {Layout} layout @param {boolean} apart @param {ArrayLike<number>} direction
 * @param {number} width [m] */
export function shiftsOf(layout, apart, direction, width) {
  return layout.variants.map((_, v) => times(direction, apart ? v * width : 0));
}
