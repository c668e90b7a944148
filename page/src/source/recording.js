// The frames of a run inside the page, written as the protocol says.

import { AT_END, BROKEN, MAGIC, touchedIn } from "./frame.js";
import { Replay } from "./replay.js";
import { fromBase64, inflate, rowOf, unpack } from "./unpack.js";

/** @typedef {import("./protocol.js").Layout} Layout */
/** @typedef {import("./protocol.js").Hello} Hello */
/** @typedef {import("./replay.js").Frames} Frames */
/** @typedef {import("./unpack.js").Stream} Stream */
/** @typedef {import("./unpack.js").Numbers} Numbers */
/** @typedef {{layout: Layout, frames: number, good: number, method: string, dt: number,
 *   streams: Stream[]}} PackedPart */
/** @typedef {import("./frame.js").Touched} Touched */
/** @typedef {{ropewalk: string, title: string, duration: number, about: string, times: Stream,
 *   parts: PackedPart[], single: number}} Header */
/** @typedef {{layout: Layout, first: number, frames: number, good: number,
 *   numbers: Record<string, Numbers>}} Part */

const HEADER = 48; // bytes
const PASSED = 600; // frames passed over, whose extremes the next one shows
const AT_ONCE = 40; // frames that are read before the page may draw again

/** The recording in this page, if there is one, and what is to be said of it.
 * @returns {{replay: Replay, about: string} | null} */
export function findRecording() {
  const header = document.getElementById("recording");
  const data = document.getElementById("recording-data");
  if (!header || !data) return null;
  /** @type {Header} */ const run = JSON.parse(header.textContent ?? "");
  const frames = new PackedFrames(run, data.textContent ?? "");
  return { replay: new Replay(helloOf(run), { ...run, playing: true }, frames), about: run.about };
}

/** What there is of contacts, and what stands where a run does not tell it. @type {[Touched, number][]} */
const TOUCHED = [
  ["contact", 0],
  ["rope_contacts", -1],
  ["wraps", -1],
  ["friction_work", NaN],
];

/** @param {Header} run @returns {Hello} */
function helloOf({ ropewalk, title }) {
  return {
    type: "hello",
    protocol: 1,
    ropewalk,
    client: 0,
    mode: "replay",
    can: [],
    limits: {},
    title,
    folder: null,
    address: "",
    speeds: [0.01, 4],
    grabs: 0,
    exports: [],
  };
}

/** @implements {Frames} */
export class PackedFrames {
  /** @param {Header} header @param {string} text base64 */
  constructor(header, text) {
    this.base = "";
    this.within = 1e-6;
    this.header = header;
    this.text = text;
    /** @type {Part[]} */ this.parts = [];
    /** @type {Float64Array} */ this.clock = new Float64Array(0);
  }

  async times() {
    await this.load();
    return this.clock;
  }

  /** @param {number} part */
  async layout(part) {
    return this.parts[part].layout;
  }

  /** @param {number} index @param {number} after */
  take(index, after) {
    return this.frame(index, after);
  }

  /** @param {number} first @param {number} count @param {number} every */
  async read(first, count, every) {
    const found = [];
    for (let i = 0; i < count && first + i * every < this.clock.length; i++) {
      found.push(this.frame(first + i * every, first + (i - 1) * every));
      if (i % AT_ONCE === AT_ONCE - 1) await new Promise((done) => setTimeout(done));
    }
    return found;
  }

  async load() {
    const bytes = fromBase64(this.text);
    this.text = "";
    let at = 0;
    const next = async (/** @type {Stream} */ stream, /** @type {number} */ rows) => {
      const packed = bytes.slice(at, (at += stream.bytes));
      return unpack(stream, rows, await inflate(packed));
    };
    const { parts, times } = this.header;
    const frames = parts.reduce((sum, part) => sum + part.frames, 0);
    const clock = await next(times, frames);
    this.clock = Float64Array.from(clock.whole, (value) => times.low[0] + times.step[0] * value);
    let first = 0;
    for (const part of parts) {
      /** @type {Record<string, Numbers>} */ const numbers = {};
      for (const stream of part.streams) numbers[stream.name] = await next(stream, part.frames);
      const { layout, good } = part;
      this.parts.push({ layout, first, frames: part.frames, good, numbers });
      first += part.frames;
    }
  }

  /** @param {number} index */
  partOf(index) {
    return this.parts.findIndex(({ first, frames }) => index < first + frames);
  }

  /** A frame in the bytes of the protocol, with what was seen since the frame `after`.
   * @param {number} index @param {number} [after] */
  frame(index, after = index - 1) {
    const { layout, first, good, numbers } = this.parts[this.partOf(index)];
    const row = index - first;
    const [variant] = layout.variants;
    const { offsets, nodes, anchors } = variant;
    const buffer = new ArrayBuffer(layout.bytes);
    const head = new DataView(buffer, 0, HEADER);
    const flags = (index === this.clock.length - 1 ? AT_END : 0) | (row >= good ? BROKEN : 0);
    [MAGIC, layout.layout, 0, flags].forEach((value, i) => head.setUint32(4 * i, value, true));
    head.setFloat64(16, this.clock[index], true);
    head.setFloat64(24, index, true);
    const floats = (/** @type {number} */ at, /** @type {number} */ count) =>
      new Float32Array(buffer, at, count);
    const scalars = rowOf(numbers.scalars, row, floats(offsets.scalars, layout.scalars.length));
    const positions = rowOf(numbers.positions, row, floats(offsets.positions, 3 * nodes));
    const range = (/** @type {string} */ name, /** @type {number} */ value) => {
      const at = layout.scalars.indexOf(name);
      if (at >= 0) scalars[at] = value;
    };
    const since = Math.max(after - first + 1, row - PASSED, 0);
    const seen = seenIn(numbers, Math.min(since, row), row);
    const words = (/** @type {number} */ at) => new Uint16Array(buffer, at, nodes);
    const at = Object.fromEntries(layout.scalars.map((name, i) => [name, i]));
    for (let i = since; i < row; i++) {
      const passed = rowOf(numbers.scalars, i, new Float64Array(layout.scalars.length));
      scalars[at.tension_max] = Math.max(scalars[at.tension_max], passed[at.tension_max]);
      scalars[at.high] = Math.max(scalars[at.high], passed[at.high]);
      scalars[at.low] = Math.min(scalars[at.low], passed[at.low]);
    }
    const pulls = [seen.leastTension, seen.greatestTension, seen.tension];
    const [low, high] = bounds(pulls);
    share(seen.tension, low, high, words(offsets.tension));
    share(seen.leastTension, low, high, words(offsets.least_tension));
    share(seen.greatestTension, low, high, words(offsets.greatest_tension));
    range("tension_low", low);
    range("tension_high", high);
    const fast = bounds([seen.greatestSpeed, seen.speed])[1];
    share(seen.speed, 0, fast, words(offsets.speed));
    share(seen.greatestSpeed, 0, fast, words(offsets.greatest_speed));
    range("speed_high", fast);
    const heights = Float64Array.from({ length: nodes }, (_, i) =>
      layout.up.reduce((sum, up, k) => sum + up * positions[3 * i + k], 0),
    );
    for (const place of [offsets.least_height, offsets.greatest_height])
      share(heights, scalars[at.low], scalars[at.high], words(place)); // the bounds of single nodes are not packed
    floats(offsets.greatest_force, anchors.length).set(seen.greatestForce);
    const velocity = rowOf(numbers.velocity, row, new Float32Array(3 * anchors.length));
    const force = rowOf(numbers.force, row, new Float32Array(3 * anchors.length));
    const hands = floats(offsets.anchors, 10 * anchors.length);
    anchors.forEach(({ index: node, until }, a) => {
      hands.set(positions.subarray(3 * node, 3 * node + 3), 10 * a);
      hands.set(velocity.subarray(3 * a, 3 * a + 3), 10 * a + 3);
      hands.set(force.subarray(3 * a, 3 * a + 3), 10 * a + 6);
      hands[10 * a + 9] = holdsYet(until, this.clock[index]) ? 1 : 0;
    });
    writeTouch(numbers, row < good ? row : -1, buffer, offsets);
    const grabs = floats(offsets.grabs, Math.floor((layout.bytes - offsets.grabs) / 4));
    for (let i = 0; i < grabs.length; i += 8) grabs[i] = -1;
    return buffer;
  }
}

/** What is touched, of a row of numbers; nothing is known past a break, where there is none (-1).
 * @param {Record<string, Numbers>} numbers @param {number} row @param {ArrayBuffer} buffer
 * @param {import("./protocol.js").Offsets} offsets */
function writeTouch(numbers, row, buffer, offsets) {
  for (const [name, unknown] of TOUCHED) {
    const part = touchedIn(buffer, offsets, name).fill(unknown);
    if (row >= 0 && numbers[name] && part.length) rowOf(numbers[name], row, part);
  }
}

/** Whether an anchor that lets go at some time still holds. @param {number | null} [until] [s]
 * @param {number} [time] [s] */
export const holdsYet = (until, time = 0) => until == null || time < until;

/** What some rows have seen, and the last one itself. @param {Record<string, Numbers>} numbers
 * @param {number} from @param {number} row the last */
function seenIn(numbers, from, row) {
  const read = (/** @type {string} */ name, /** @type {number} */ at) =>
    rowOf(numbers[name], at, new Float64Array(numbers[name].columns));
  /** @param {string} name @param {string} beyond @param {number} sign */
  const farthest = (name, beyond, sign) => {
    const found = new Float64Array(numbers[name].columns).fill(-sign * Infinity);
    for (let at = from; at <= row; at++) {
      const [now, more] = [read(name, at), read(beyond, at)];
      now.forEach((value, i) => {
        const far = value + sign * more[i];
        if (sign * far > sign * found[i]) found[i] = far;
      });
    }
    return found;
  };
  const columns = numbers.greatest_force.columns;
  const greatestForce = new Float64Array(columns);
  for (let at = from; at <= row; at++) {
    const [force, more] = [read("force", at), read("greatest_force", at)];
    greatestForce.forEach((most, a) => {
      const size = Math.hypot(...force.subarray(3 * a, 3 * a + 3)) + more[a];
      greatestForce[a] = Math.max(most, size);
    });
  }
  return {
    tension: read("tension", row),
    speed: read("speed", row),
    leastTension: farthest("tension", "least_tension", -1),
    greatestTension: farthest("tension", "greatest_tension", 1),
    greatestSpeed: farthest("speed", "greatest_speed", 1),
    greatestForce,
  };
}

/** The least (0 at most) and the largest of all these numbers. @param {Float64Array[]} rows
 * @returns {[number, number]} */
function bounds(rows) {
  let [low, high] = [0, 1e-30];
  for (const values of rows) {
    for (const value of values) {
      if (value < low) low = value;
      if (value > high) high = value;
    }
  }
  return [low, high];
}

/** Write numbers as shares of 65535 between two bounds. @param {Float64Array} values
 * @param {number} low @param {number} high @param {Uint16Array} out */
function share(values, low, high, out) {
  const scale = 65535 / Math.max(high - low, 1e-30);
  for (let i = 0; i < values.length; i++) {
    out[i] = Math.min(65535, Math.max(0, (values[i] - low) * scale + 0.5));
  }
}
