// Which pieces of rope something holds: the camera goes with these, and lets others fall out of the picture.

/** @typedef {import("../source/protocol.js").Layout} Layout */
/** Nodes in a row, in the arrays that are drawn. @typedef {{first: number, nodes: number, held: boolean}} Piece */

/** @param {Layout} layout @param {{ropes: {first: number, count: number}[]}} shape as it is drawn, in pieces
 * @param {number[]} starts first node of each variant
 * @param {(variant: number, anchor: number) => boolean} holds whether an anchor has not let go
 * @returns {Piece[]} */
export function piecesHeld(layout, { ropes }, starts, holds) {
  const pieces = ropes.map(({ first, count }) => ({ first, nodes: count, held: false }));
  const at = (/** @type {number} */ node) =>
    pieces.find(({ first, nodes }) => node >= first && node < first + nodes);
  layout.variants.forEach(({ anchors, joints }, v) => {
    anchors.forEach(({ index }, a) => {
      const piece = at(starts[v] + index);
      if (piece && holds(v, a)) piece.held = true;
    });
    const ties = (joints ?? []).map(({ nodes }) => nodes.map((node) => at(starts[v] + node)));
    for (let changed = true; changed;) {
      changed = false;
      for (const tied of ties) {
        if (!tied.some((piece) => piece?.held) || tied.every((piece) => piece?.held)) continue;
        for (const piece of tied) if (piece) piece.held = changed = true;
      }
    }
  });
  // where nothing holds any, and there is nothing else to look at, the flight is the scene
  const nothing =
    !layout.obstacles?.length && !layout.variants.some(({ anchors }) => anchors.length);
  return nothing ? pieces.map((piece) => ({ ...piece, held: true })) : pieces;
}
