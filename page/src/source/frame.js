// Frames: typed arrays over the bytes of a message, as the layout says; nothing is copied.

/** @typedef {import("./protocol.js").Layout} Layout */
/** @typedef {import("./protocol.js").Variant} Variant */

export const MAGIC = 0x46505752;
export const PLAYING = 1;
export const BROKEN = 2;
export const AT_END = 16;

/** @typedef {{scalars: Float32Array, positions: Float32Array, tension: Uint16Array, speed: Uint16Array,
 *   seen: Seen, anchors: Float32Array, contact: Float32Array, ropeContacts: Float32Array, wraps: Float32Array,
 *   frictionWork: Float32Array, grabs: Float32Array}} Part one variant */
/** The greatest and least of every step since the frame before. @typedef {{leastTension: Uint16Array,
 *   greatestTension: Uint16Array, greatestSpeed: Uint16Array, leastHeight: Uint16Array,
 *   greatestHeight: Uint16Array, greatestForce: Float32Array}} Seen */
/** @typedef {{layout: number, number: number, flags: number, time: number, steps: number, realtime: number,
 *   speed: number, load: number, parts: Part[]}} Frame */

/** The number of the layout a frame is written in. @param {ArrayBuffer} buffer */
export const layoutOf = (buffer) => new DataView(buffer).getUint32(4, true);

/** The number of a frame. @param {ArrayBuffer} buffer */
export const numberOf = (buffer) => new DataView(buffer).getUint32(8, true);

/** @param {ArrayBuffer} buffer @param {Layout} layout @returns {Frame}
 * @throws {Error} for bytes that are no frame of this layout */
export function readFrame(buffer, layout) {
  const head = new DataView(buffer);
  if (head.byteLength < 48 || head.getUint32(0, true) !== MAGIC) throw new Error("not a frame");
  if (head.getUint32(4, true) !== layout.layout) throw new Error("a frame of another layout");
  if (buffer.byteLength < layout.bytes) throw new Error("a frame cut short");
  return {
    layout: layout.layout,
    number: head.getUint32(8, true),
    flags: head.getUint32(12, true),
    time: head.getFloat64(16, true),
    steps: head.getFloat64(24, true),
    realtime: head.getFloat32(32, true),
    speed: head.getFloat32(36, true),
    load: head.getFloat32(40, true),
    parts: layout.variants.map((variant, i) => readPart(buffer, layout, variant, i)),
  };
}

/** Give back the memory of a frame that nobody looks at any more: the browser would collect it only with
 * long pauses, once there are megabytes of it. @param {Frame} frame */
export function forget(frame) {
  const buffer = /** @type {any} */ (frame.parts[0]?.scalars.buffer);
  buffer?.transfer?.(0);
}

/** @param {ArrayBuffer} buffer @param {Layout} layout @param {Variant} variant @param {number} i
 * @returns {Part} */
function readPart(buffer, layout, variant, i) {
  const { offsets, nodes, anchors } = variant;
  const end = layout.variants[i + 1]?.offsets.scalars ?? layout.bytes;
  return {
    scalars: new Float32Array(buffer, offsets.scalars, layout.scalars.length),
    positions: new Float32Array(buffer, offsets.positions, 3 * nodes),
    tension: new Uint16Array(buffer, offsets.tension, nodes),
    speed: new Uint16Array(buffer, offsets.speed, nodes),
    seen: {
      leastTension: new Uint16Array(buffer, offsets.least_tension, nodes),
      greatestTension: new Uint16Array(buffer, offsets.greatest_tension, nodes),
      greatestSpeed: new Uint16Array(buffer, offsets.greatest_speed, nodes),
      leastHeight: new Uint16Array(buffer, offsets.least_height, nodes),
      greatestHeight: new Uint16Array(buffer, offsets.greatest_height, nodes),
      greatestForce: new Float32Array(buffer, offsets.greatest_force, anchors.length),
    },
    anchors: new Float32Array(buffer, offsets.anchors, 10 * anchors.length),
    contact: touchedIn(buffer, offsets, "contact"),
    ropeContacts: touchedIn(buffer, offsets, "rope_contacts"),
    wraps: touchedIn(buffer, offsets, "wraps"),
    frictionWork: touchedIn(buffer, offsets, "friction_work"),
    grabs: new Float32Array(buffer, offsets.grabs, 8 * Math.floor((end - offsets.grabs) / 32)),
  };
}

/** What is told of contacts, in its order.
 * @typedef {"contact" | "rope_contacts" | "wraps" | "friction_work"} Touched */
const TOUCHED = /** @type {Touched[]} */ (["contact", "rope_contacts", "wraps", "friction_work"]);

/** The numbers of a part that tells of contacts, none where there is nothing to touch. @param {ArrayBuffer} buffer
 * @param {Variant["offsets"]} offsets @param {Touched} name */
export function touchedIn(buffer, offsets, name) {
  const from = offsets[name];
  if (from === undefined) return new Float32Array(0);
  const later = TOUCHED.slice(TOUCHED.indexOf(name) + 1).map((one) => offsets[one]);
  const end = later.find((at) => at !== undefined) ?? offsets.grabs;
  return new Float32Array(buffer, from, (end - from) / 4);
}

/** Whether there is anything that ropes touch. @param {Variant["offsets"]} offsets */
export const touching = ({ contact, grabs }) => contact !== undefined && contact < grabs;

/** One scalar of a variant, NaN if there is none. @param {Layout} layout @param {Part} part
 * @param {string} name */
export function scalar(layout, part, name) {
  const at = layout.scalars.indexOf(name);
  return at < 0 ? NaN : part.scalars[at];
}

/** A number written as a share of 65535 between two scalars; between 0 and one where there is no `low`.
 * @param {Layout} layout @param {Part} part @param {number} share @param {string | null} low
 * @param {string} high */
export function between(layout, part, share, low, high) {
  const bottom = low === null ? 0 : scalar(layout, part, low);
  return bottom + (share / 65535) * (scalar(layout, part, high) - bottom);
}
