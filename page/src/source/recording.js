// A run inside the page: plays it as the server would, with frames written as the protocol says.

import { AT_END, BROKEN, MAGIC, PLAYING, touching } from "./frame.js";
import { fromBase64, inflate, rowOf, unpack } from "./unpack.js";

/** @typedef {import("./protocol.js").Source} Source */
/** @typedef {import("./protocol.js").SourceEvents} SourceEvents */
/** @typedef {import("./protocol.js").Layout} Layout */
/** @typedef {import("./unpack.js").Stream} Stream */
/** @typedef {import("./unpack.js").Numbers} Numbers */
/** @typedef {{layout: Layout, frames: number, good: number, streams: Stream[]}} PackedPart */
/** @typedef {{ropewalk: string, title: string, duration: number, method: string, dt: number, about: string,
 *   times: Stream, parts: PackedPart[], single: number}} Header */
/** @typedef {{layout: Layout, first: number, frames: number, good: number,
 *   numbers: Record<string, Numbers>}} Part */

const HEADER = 48; // bytes
const STATUS = 250; // ms
const PASSED = 600; // frames passed over, whose extremes the next one shows
const STEP_SHOWN = 0.1; // s that a single step past a break is seen
const CAN = ["play", "pause", "step", "speed", "seek", "reset"];

/** The recording in this page, if there is one. @returns {RecordingSource | null} */
export function findRecording() {
  const header = document.getElementById("recording");
  const data = document.getElementById("recording-data");
  if (!header || !data) return null;
  return new RecordingSource(JSON.parse(header.textContent ?? ""), data.textContent ?? "");
}

/** @implements {Source} */
export class RecordingSource {
  /** @param {Header} header @param {string} text base64 */
  constructor(header, text) {
    this.base = "";
    this.header = header;
    this.text = text;
    this.time = 0;
    this.speed = 1;
    this.playing = true;
    this.number = 0;
    this.shown = -1;
    this.leapt = false;
    this.layout = -1;
    this.last = 0;
    this.lastStatus = 0;
    /** @type {Part[]} */ this.parts = [];
    /** @type {Float64Array} */ this.times = new Float64Array(0);
    /** @type {SourceEvents | null} */ this.events = null;
    /** Called before the frame of a jump: graphs want what was before it.
     * @type {(index: number) => void} */
    this.jumped = () => {};
  }

  /** @param {SourceEvents} events */
  async open(events) {
    this.events = events;
    try {
      await this.load();
    } catch (error) {
      events.state(
        "damaged",
        `This page cannot be shown: ${error instanceof Error ? error.message : error}.`,
      );
      return;
    }
    events.state("open", "");
    events.message(this.hello());
    this.tellLayout(0);
    events.message({ type: "parameters", parameters: [] });
    events.message({ type: "presets", presets: [] });
    this.tellStatus();
    this.last = performance.now();
    const tick = (/** @type {number} */ now) => {
      this.tick(now);
      requestAnimationFrame(tick);
    };
    requestAnimationFrame(tick);
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
    this.times = Float64Array.from(clock.whole, (value) => times.low[0] + times.step[0] * value);
    let first = 0;
    for (const part of parts) {
      /** @type {Record<string, Numbers>} */ const numbers = {};
      for (const stream of part.streams) numbers[stream.name] = await next(stream, part.frames);
      const { layout, good } = part;
      this.parts.push({ layout, first, frames: part.frames, good, numbers });
      first += part.frames;
    }
  }

  hello() {
    const { ropewalk, title } = this.header;
    return {
      type: "hello",
      protocol: 1,
      ropewalk,
      client: 0,
      mode: "replay",
      can: CAN,
      limits: {},
      title,
      folder: null,
      address: "",
      speeds: [0.01, 4],
      grabs: 0,
      exports: [],
    };
  }

  /** @param {Record<string, any>} command */
  send(command) {
    const end = this.header.duration;
    switch (command.type) {
      case "play":
        if (this.time >= end) this.moveTo(0);
        this.playing = true;
        this.last = performance.now();
        break;
      case "pause":
        this.playing = false;
        break;
      case "step":
        this.playing = false;
        this.time = this.times[Math.min(this.index + (command.count ?? 1), this.times.length - 1)];
        break;
      case "speed":
        this.speed = command.value;
        break;
      case "seek":
        this.moveTo(Math.min(Math.max(0, command.time), end));
        break;
      case "reset":
        this.moveTo(0);
        break;
    }
    this.show();
    this.tellStatus();
    if (command.id === undefined) return;
    const { id, type } = command;
    // As from a server, later: the page waits for it after it has sent.
    queueMicrotask(() =>
      this.events?.message({
        type: "done",
        id,
        command: type,
        step: this.index,
        frame: this.number,
      }),
    );
  }

  /** Nothing is sent that must be acknowledged. */
  used() {}

  /** @param {number} time [s] */
  moveTo(time) {
    this.time = time;
    this.leapt = true; // what lies between is not passed over
    if (Math.abs(this.index - this.shown) > 2) this.jumped(this.index);
  }

  /** The frame to show now: the last one that is not later. */
  get index() {
    let [low, high] = [0, this.times.length];
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (this.times[middle] <= this.time + 1e-6) low = middle;
      else high = middle;
    }
    return low;
  }

  /** @param {number} now ms */
  tick(now) {
    const elapsed = Math.min(0.25, Math.max(0, (now - this.last) / 1000));
    this.last = now;
    if (this.playing) {
      this.time = this.later(elapsed * this.speed);
      this.playing = this.time < this.header.duration;
      if (!this.playing || now - this.lastStatus > STATUS) this.tellStatus();
    }
    this.show();
  }

  /** The time in the run when so much has passed [s]; steps past a break go by slowly.
   * @param {number} passed */
  later(passed) {
    const { duration, single } = this.header;
    const { time } = this;
    const broke = this.times[this.times.length - 1 - single];
    if (!single || time + passed < broke) return Math.min(time + passed, duration);
    if (time < broke) return broke;
    const slowly = Math.min(1, (duration - broke) / (single * STEP_SHOWN));
    return Math.min(time + passed * slowly, duration);
  }

  show() {
    const { index } = this;
    if (index === this.shown || !this.events) return;
    const before = this.shown;
    this.shown = index;
    const part = this.partOf(index);
    if (part !== this.layout) this.tellLayout(part);
    this.number++;
    const on = before < index && !this.leapt;
    this.leapt = false;
    this.events.frame(this.frame(index, on ? before : index - 1));
  }

  /** @param {number} index */
  partOf(index) {
    return this.parts.findIndex(({ first, frames }) => index < first + frames);
  }

  /** @param {number} part */
  tellLayout(part) {
    this.layout = part;
    this.events?.message(this.parts[part].layout);
  }

  tellStatus() {
    this.lastStatus = performance.now();
    const { method, dt, duration } = this.header;
    this.events?.message({
      type: "status",
      playing: this.playing,
      speed: this.speed,
      realtime: this.playing ? this.speed : 0,
      slow: false,
      text: "",
      time: this.time,
      step: this.index,
      dt,
      steps_per_frame: 1,
      method,
      broken: false,
      clients: 1,
      address: "",
      duration,
    });
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
    const flags =
      (this.playing ? PLAYING : 0) |
      (index === this.times.length - 1 ? AT_END : 0) |
      (row >= good ? BROKEN : 0);
    [MAGIC, layout.layout, this.number, flags].forEach((value, i) =>
      head.setUint32(4 * i, value, true),
    );
    head.setFloat64(16, this.times[index], true);
    head.setFloat64(24, index, true);
    head.setFloat32(32, this.playing ? this.speed : 0, true);
    head.setFloat32(36, this.speed, true);
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
    anchors.forEach(({ index: node }, a) => {
      hands.set(positions.subarray(3 * node, 3 * node + 3), 10 * a);
      hands.set(velocity.subarray(3 * a, 3 * a + 3), 10 * a + 3);
      hands.set(force.subarray(3 * a, 3 * a + 3), 10 * a + 6);
      hands[10 * a + 9] = 1;
    });
    if (numbers.contact && row < good)
      rowOf(numbers.contact, row, floats(offsets.contact ?? 0, touching(offsets)));
    const grabs = floats(offsets.grabs, Math.floor((layout.bytes - offsets.grabs) / 4));
    for (let i = 0; i < grabs.length; i += 8) grabs[i] = -1;
    return buffer;
  }
}

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
