// Which pieces of rope something holds: the camera goes with these, and lets others fall out of the picture.

/** @typedef {import("../source/protocol.js").Layout} Layout */
/** Nodes in a row, in the arrays that are drawn. @typedef {{first: number, nodes: number, held: boolean,
 *   adrift?: boolean}} Piece `adrift`: nothing holds this one or any other */

export class Pieces {
  /** @param {Layout} layout @param {import("../render/view.js").Shape} shape as it is drawn, in pieces
   * @param {number[]} starts first node of each variant */
  constructor(layout, shape, starts) {
    this.shape = shape;
    const of = new Int32Array(shape.nodes); // the piece of each node
    shape.ropes.forEach(({ first, count }, i) => of.fill(i, first, first + count));
    /** Of each piece: the one that stands for all that are tied together. */
    this.groups = shape.ropes.map((_, i) => i);
    /** The piece of each anchor of each variant. */
    this.anchored = layout.variants.map(({ anchors }, v) =>
      anchors.map(({ index }) => of[starts[v] + index]),
    );
    layout.variants.forEach(({ joints }, v) => {
      for (const { nodes } of joints ?? []) this.tie(nodes.map((node) => of[starts[v] + node]));
    });
  }

  /** @param {number[]} pieces */
  tie([first, ...others]) {
    for (const other of others) this.groups[this.group(other)] = this.group(first);
  }

  /** @param {number} piece @returns {number} */
  group(piece) {
    while (this.groups[piece] !== piece) piece = this.groups[piece];
    return piece;
  }

  /** @param {(variant: number, anchor: number) => boolean} holds whether an anchor has not let go
   * @returns {Piece[]} */
  held(holds) {
    /** @type {Set<number>} */ const groups = new Set();
    this.anchored.forEach((pieces, v) =>
      pieces.forEach((piece, a) => holds(v, a) && groups.add(this.group(piece))),
    );
    const adrift = !groups.size; // then there is nothing else to go with
    return this.shape.ropes.map(({ first, count }, i) => {
      return { first, nodes: count, held: adrift || groups.has(this.group(i)), adrift };
    });
  }
}
