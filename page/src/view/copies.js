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

/** What the renderers draw. @param {Layout} layout @returns {Shape} */
export function shapeOf(layout) {
  const first = starts(layout);
  /** @type {Shape["ropes"]} */
  const ropes = [];
  layout.variants.forEach((variant, v) => {
    variant.ropes.forEach((rope, r) => {
      ropes.push({
        name: rope.name,
        first: first[v] + rope.first,
        count: rope.nodes,
        radius: rope.diameter / 2,
        spacing: rope.length / Math.max(1, rope.segments),
        colour: colourOf(layout, v, r),
      });
    });
  });
  return { nodes: nodesOf(layout), ropes };
}

/** Shifts of the copies [m]: none, or side by side along a level direction.
 * @param {Layout} layout @param {boolean} apart @param {ArrayLike<number>} direction
 * @param {number} width [m] */
export function shiftsOf(layout, apart, direction, width) {
  return layout.variants.map((_, v) => times(direction, apart ? v * width : 0));
}
