// What a frame adds to the graphs: energies, and tension, height and speed of followed nodes.

import { scalar, tensionOf } from "../source/frame.js";

/** @typedef {import("../source/protocol.js").Layout} Layout */
/** @typedef {import("../source/frame.js").Frame} Frame */

/** Numbers by name; "tension 12" is that beside node 12.
 * @param {Layout} layout @param {Frame} frame @param {Iterable<number>} nodes
 * @returns {[string, number][]} */
export function samplesOf(layout, frame, nodes) {
  const part = frame.parts[0];
  /** @type {[string, number][]} */
  const values = layout.scalars.map((name, i) => [name, part.scalars[i]]);
  const [ux, uy, uz] = layout.up;
  const fastest = scalar(layout, part, "speed_high");
  for (const node of nodes) {
    const [x, y, z] = part.positions.subarray(3 * node, 3 * node + 3);
    values.push([`height ${node}`, x * ux + y * uy + z * uz]);
    values.push([`speed ${node}`, (part.speed[node] / 65535) * fastest]);
    values.push([`tension ${node}`, tensionOf(layout, part, segmentAt(layout, node))]);
  }
  layout.variants.slice(1).forEach((_, v) => {
    values.push([`difference ${v + 1}`, scalar(layout, frame.parts[v + 1], "difference")]);
  });
  return values;
}

/** The segment after a node, or before it at a rope's end. @param {Layout} layout @param {number} node */
export function segmentAt(layout, node) {
  for (const { first, nodes } of layout.variants[0].ropes) {
    if (node >= first && node < first + nodes)
      return Math.max(first, Math.min(node, first + nodes - 2));
  }
  return node;
}
