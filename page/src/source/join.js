// Two frames as one: what was seen for one that is not shown is seen in the next one, as `combined` in
// src/ropewalk/live/frame.py does for frames that a slow page never gets.

import { layoutOf, readFrame, scalar } from "./frame.js";

/** @typedef {import("./protocol.js").Layout} Layout */
/** @typedef {import("./frame.js").Part} Part */

const least = (/** @type {number} */ a, /** @type {number} */ b) => (b < a || a !== a ? b : a);
const most = (/** @type {number} */ a, /** @type {number} */ b) => (b > a || a !== a ? b : a);
/** @type {[string, typeof least][]} */
const SCALARS = [
  ["tension_low", least],
  ["tension_high", most],
  ["tension_max", most],
  ["speed_high", most],
  ["low", least],
  ["high", most],
];

/** Widen the newer frame by what the older one has seen; left as it is where they are not written alike.
 * @param {ArrayBuffer} older @param {ArrayBuffer} newer @param {Layout} [layout] of the newer */
export function join(older, newer, layout) {
  if (!layout || layoutOf(older) !== layoutOf(newer)) return;
  const before = readFrame(older, layout).parts;
  readFrame(newer, layout).parts.forEach((after, i) => joinPart(layout, before[i], after));
}

/** @param {Layout} layout @param {Part} before @param {Part} after */
function joinPart(layout, before, after) {
  const own = { ...after, scalars: after.scalars.slice() };
  for (const [name, choose] of SCALARS) {
    const at = layout.scalars.indexOf(name);
    if (at >= 0) after.scalars[at] = choose(own.scalars[at], before.scalars[at]);
  }
  /** @param {Part} part @param {string | null} low @param {string} high @returns {[number, number]} */
  const range = (part, low, high) => [
    low === null ? 0 : scalar(layout, part, low),
    scalar(layout, part, high),
  ];
  /** @param {Uint16Array} to @param {Uint16Array | null} from @param {typeof least} choose
   * @param {string | null} low @param {string} high */
  const write = (to, from, choose, low, high) => {
    const [[a, b], [c, d], [bottom, top]] = [own, before, after].map((one) =>
      range(one, low, high),
    );
    const scale = 65535 / Math.max(top - bottom, 1e-30);
    for (let i = 0; i < to.length; i++) {
      let value = a + (to[i] / 65535) * (b - a);
      if (from) value = choose(value, c + (from[i] / 65535) * (d - c));
      to[i] = Math.min(65535, Math.max(0, (value - bottom) * scale + 0.5));
    }
  };
  const { seen } = after;
  write(after.tension, null, most, "tension_low", "tension_high");
  write(after.speed, null, most, null, "speed_high");
  write(seen.leastTension, before.seen.leastTension, least, "tension_low", "tension_high");
  write(seen.greatestTension, before.seen.greatestTension, most, "tension_low", "tension_high");
  write(seen.greatestSpeed, before.seen.greatestSpeed, most, null, "speed_high");
  write(seen.leastHeight, before.seen.leastHeight, least, "low", "high");
  write(seen.greatestHeight, before.seen.greatestHeight, most, "low", "high");
  seen.greatestForce.forEach((force, a) => {
    seen.greatestForce[a] = most(force, before.seen.greatestForce[a]);
  });
}
