// What a frame adds to the graphs: energies, and tension, height and speed of followed nodes, forces of anchors.
// Tension, speed and force are the greatest since the frame before; "low" and "high" begin the names of bounds.

import { between, scalar } from "../source/frame.js";

/** @typedef {import("../source/protocol.js").Layout} Layout */
/** @typedef {import("../source/frame.js").Frame} Frame */

const LATE = 0.1; // s of the clock after which a frame is late ...
const FRAMES = 4; // ... and frames of the scene, where these are longer

/** Between two frames of a server that plays, of which none is missing [s].
 * @param {import("../session.js").Session} session */
export function longestOf({ hello, status }) {
  if (hello?.mode !== "live" || !status) return Infinity; // others show what they have
  return Math.max(LATE * status.speed, FRAMES * status.dt * status.steps_per_frame);
}

/** Numbers by name; "tension 12" is that beside node 12.
 * @param {Layout} layout @param {Frame} frame @param {Iterable<number>} nodes
 * @returns {[string, number][]} */
export function samplesOf(layout, frame, nodes) {
  const part = frame.parts[0];
  /** @type {[string, number][]} */
  const values = layout.scalars.map((name, i) => [name, part.scalars[i]]);
  const [ux, uy, uz] = layout.up;
  const { seen } = part;
  const pull = (/** @type {number} */ share) =>
    between(layout, part, share, "tension_low", "tension_high");
  const place = (/** @type {number} */ share) => between(layout, part, share, "low", "high");
  for (const node of nodes) {
    const [x, y, z] = part.positions.subarray(3 * node, 3 * node + 3);
    const height = x * ux + y * uy + z * uz;
    const segment = segmentAt(layout, node);
    values.push(
      [`height ${node}`, height],
      [`low height ${node}`, Math.min(height, place(seen.leastHeight[node]))],
      [`high height ${node}`, Math.max(height, place(seen.greatestHeight[node]))],
      [`speed ${node}`, between(layout, part, seen.greatestSpeed[node], null, "speed_high")],
      [`tension ${node}`, pull(seen.greatestTension[segment])],
      [`low tension ${node}`, pull(seen.leastTension[segment])],
    );
  }
  seen.greatestForce.forEach((force, a) => values.push([`force ${a}`, force]));
  layout.variants.slice(1).forEach((_, v) => {
    values.push([`difference ${v + 1}`, scalar(layout, frame.parts[v + 1], "difference")]);
  });
  return values;
}

/** What columns that are told by a number are of, by what their names are like: that of another layout may be
 * another anchor, copy or place. @param {Layout} layout @returns {[RegExp, string][]} */
export function numbered({ variants: [first, ...others] }) {
  return [
    [/^force \d+$/, JSON.stringify(first.anchors.map(({ name }) => name))],
    [/^difference \d+$/, JSON.stringify(others.map(({ label }) => label))],
    [/(height|speed|tension) \d+$/, String(first.nodes)],
  ];
}

/** The segment after a node, or before it at a rope's end. @param {Layout} layout @param {number} node */
export function segmentAt(layout, node) {
  for (const { first, nodes } of layout.variants[0].ropes) {
    if (node >= first && node < first + nodes)
      return Math.max(first, Math.min(node, first + nodes - 2));
  }
  return node;
}
