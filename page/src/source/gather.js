// Puts a frame's places and the numbers behind the colours into the array that is drawn.

import { scalar } from "./frame.js";

/** @typedef {import("./protocol.js").Layout} Layout */
/** @typedef {import("./frame.js").Frame} Frame */
/** @typedef {"tension" | "strain" | "utilisation" | "speed" | "plain"} Colouring */

/** What a newton of tension is worth in a rope. @param {import("./protocol.js").Rope} rope
 * @param {Colouring} colouring */
function perNewton(rope, colouring) {
  if (colouring === "strain") return rope.EA ? 1 / rope.EA : 0; // rigid links do not stretch
  if (colouring === "utilisation") return rope.breaking_load ? 1 / rope.breaking_load : 0;
  return 1;
}

/** Write x, y, z, value of all nodes of all variants; returns the extremes of what has values. These are the
 * greatest since the frame before, so that no colour misses what came in between.
 * @param {Frame} frame @param {Layout} layout @param {Colouring} colouring
 * @param {number[][]} shifts [m] of each variant @param {Float32Array} out
 * @returns {{low: number, high: number, tensions: number[][]}} what the colours run between, and the greatest tension
 * of each rope of each variant [N], where they show tensions */
export function gather(frame, layout, colouring, shifts, out) {
  let at = 0;
  let [lowest, highest] = [Infinity, -Infinity];
  /** @type {number[][]} */ const tensions = layout.variants.map(() => []);
  layout.variants.forEach((variant, v) => {
    const part = frame.parts[v];
    const [sx, sy, sz] = shifts[v];
    const { positions } = part;
    for (let i = 0, p = 0, q = at; i < variant.nodes; i++, p += 3, q += 4) {
      out[q] = positions[p] + sx;
      out[q + 1] = positions[p + 1] + sy;
      out[q + 2] = positions[p + 2] + sz;
    }
    if (colouring === "speed") {
      const high = scalar(layout, part, "speed_high");
      const { greatestSpeed } = part.seen;
      for (let i = 0; i < variant.nodes; i++)
        out[at + 4 * i + 3] = (greatestSpeed[i] / 65535) * high;
      lowest = 0;
      highest = Math.max(highest, high);
    } else if (colouring !== "plain") {
      const low = scalar(layout, part, "tension_low");
      const step = (scalar(layout, part, "tension_high") - low) / 65535;
      for (const rope of variant.ropes) {
        const per = perNewton(rope, colouring);
        const last = rope.first + rope.nodes - 1;
        const { greatestTension, leastTension } = part.seen;
        let before = greatestTension[rope.first];
        let [least, most] = [Infinity, -Infinity];
        for (let i = rope.first; i <= last; i++) {
          const after = i < last ? greatestTension[i] : before;
          out[at + 4 * i + 3] = (low + step * 0.5 * (before + after)) * per;
          before = after;
          most = Math.max(most, after);
          if (i < last) least = Math.min(least, leastTension[i]);
        }
        lowest = Math.min(lowest, (low + step * least) * per);
        highest = Math.max(highest, (low + step * most) * per);
        tensions[v].push(low + step * most);
      }
    }
    at += 4 * variant.nodes;
  });
  if (colouring === "utilisation") return { low: 0, high: Math.max(1, highest), tensions };
  return { low: lowest, high: highest, tensions };
}

/** Write the places of all anchors of all variants. @param {Frame} frame @param {number[][]} shifts [m]
 * @param {Float32Array} out */
export function gatherAnchors(frame, shifts, out) {
  let at = 0;
  frame.parts.forEach((part, v) => {
    for (let i = 0; i < part.anchors.length; i += 10) {
      for (let k = 0; k < 3; k++) out[at++] = part.anchors[i + k] + shifts[v][k];
    }
  });
}
