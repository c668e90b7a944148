// What a string's bridge feels.

/** @typedef {import("./kernel.js").Rope} Rope */

/** The upward force that the rope puts on the node of its first anchor [N].
 * @param {Rope} rope @param {Float64Array} tension @param {number[]} up */
export function bridge(rope, tension, up) {
  const node = rope.anchors.find((anchor) => anchor.held)?.node ?? 0;
  let force = 0;
  for (const [j, other] of [
    [node - 1, node - 1],
    [node, node + 1],
  ]) {
    if (j < 0 || j >= rope.n - 1 || rope.stiffness[j] === 0) continue;
    let [square, climb] = [0, 0];
    for (const [k, row] of rope.x.entries()) {
      const way = row[other] - row[node];
      square += way * way;
      climb += way * up[k];
    }
    if (square > 0) force += (tension[j] * climb) / Math.sqrt(square);
  }
  return force;
}
