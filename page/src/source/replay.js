// The player: plays a run in this page, whether its frames lie in the page or are fetched from a server.

import { PLAYING } from "./frame.js";
import { Pace } from "./pace.js";

/** @typedef {import("./protocol.js").Source} Source */
/** @typedef {import("./protocol.js").SourceEvents} SourceEvents */
/** @typedef {import("./protocol.js").Layout} Layout */
/** @typedef {import("./protocol.js").Hello} Hello */
/** What there is to play; `single` frames at the end are steps past a break.
 * @typedef {{duration: number, single: number, playing: boolean,
 *   parts: {frames: number, method: string, dt: number}[]}} Run */

/** Where the frames of a run come from.
 * @typedef {Object} Frames
 * @property {string} base address of the server's files, "./", or "" where there are none
 * @property {number} within how exact the times are [s]
 * @property {() => Promise<Float64Array>} times of all frames [s]
 * @property {(part: number) => Promise<Layout>} layout of a part
 * @property {(index: number, after: number, every: number, on: boolean) => ArrayBuffer | null} take
 *   a frame of the caller's own, with what was seen since frame `after`; null: not there yet, ask again.
 *   `on`: the ones `every` frames later will be wanted next
 * @property {(first: number, count: number, every: number, signal?: AbortSignal) => Promise<ArrayBuffer[]>} read
 *   frames, each with what was seen since the one `every` before it; none that do not exist
 */

const STATUS = 250; // ms
const STEP_SHOWN = 0.1; // s that a single step past a break is seen
const RATE = 60; // frames per second that are shown at most
const CAN = ["play", "pause", "step", "speed", "seek", "reset"];

/** @implements {Source} */
export class Replay {
  /** @param {Hello} hello @param {Run} run @param {Frames} frames */
  constructor(hello, run, frames) {
    this.hello = { ...hello, can: CAN };
    this.run = run;
    this.frames = frames;
    this.base = frames.base;
    this.time = 0;
    this.speed = 1;
    this.playing = run.playing;
    this.pace = new Pace();
    this.number = 0;
    this.shown = -1;
    this.leapt = false;
    this.part = -1;
    this.last = 0;
    this.lastStatus = 0;
    /** @type {number[]} */ this.first = []; // frame of each part
    let first = 0;
    for (const part of run.parts) {
      this.first.push(first);
      first += part.frames;
    }
    /** @type {Float64Array} */ this.times = new Float64Array(0);
    /** @type {Layout[]} */ this.layouts = []; // of the parts that were shown
    /** @type {SourceEvents | null} */ this.events = null;
    /** Called before the frame of a jump: graphs want what was before it. */
    this.jumped = () => {};
  }

  /** @param {SourceEvents} events */
  async open(events) {
    this.events = events;
    try {
      this.times = await this.frames.times();
      this.layouts[0] = await this.frames.layout(0);
    } catch (error) {
      events.state("damaged", `This page cannot be shown: ${wordsOf(error)}.`);
      return;
    }
    events.state("open", "");
    events.message(this.hello);
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

  /** @param {Record<string, any>} command */
  send(command) {
    const fault = this.obey(command);
    if (!fault) {
      this.show(this.index);
      this.tellStatus();
    }
    const { id, type } = command;
    if (id === undefined) return;
    const frame = this.number + (this.index === this.shown ? 0 : 1);
    const made = { id, command: type };
    // As from a server, later: the page waits for it after it has sent.
    queueMicrotask(() =>
      this.events?.message(
        fault
          ? { type: "error", ...made, text: fault }
          : { type: "done", ...made, step: this.index, frame },
      ),
    );
  }

  /** @param {Record<string, any>} command @returns {string} why not, "" where it was done */
  obey({ type, time, value, count = 1 }) {
    const { duration } = this.run;
    switch (type) {
      case "play":
        if (this.time >= duration) this.moveTo(0);
        this.playing = true;
        this.last = performance.now();
        this.pace.restart();
        return "";
      case "pause":
        this.playing = false;
        return "";
      case "step":
        this.playing = false;
        this.time = this.times[Math.min(this.index + count, this.times.length - 1)];
        return "";
      case "speed":
        this.speed = value;
        this.pace.restart();
        return "";
      case "seek":
        if (!(time >= 0 && time <= duration * (1 + 1e-9)))
          return `time: ${time} - must be from 0 to ${duration} s`;
        this.moveTo(Math.min(time, duration));
        return "";
      case "reset":
        this.moveTo(0);
        return "";
    }
    return `${type}: cannot be done in a replay; there is ${CAN.join(", ")}`;
  }

  /** Nothing is sent that must be acknowledged. */
  used() {}

  /** @param {number} time [s] */
  moveTo(time) {
    this.time = time;
    this.leapt = true; // what lies between is not passed over
    this.pace.restart();
  }

  /** The frame to show now: the last one that is not later. */
  get index() {
    return this.indexAt(this.time);
  }

  /** @param {number} time [s] */
  indexAt(time) {
    let [low, high] = [0, this.times.length];
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (this.times[middle] <= time + this.frames.within) low = middle;
      else high = middle;
    }
    return low;
  }

  /** The last frame that is no step past a break. */
  get sound() {
    return this.times.length - 1 - this.run.single;
  }

  /** Every how many frames are shown while it plays. */
  get every() {
    const rate = this.sound / Math.max(this.times[this.sound], 1e-9); // frames per second
    return Math.max(1, Math.floor((this.speed * rate * 1.001) / RATE));
  }

  /** @param {number} now ms */
  tick(now) {
    const elapsed = Math.min(0.25, Math.max(0, (now - this.last) / 1000));
    this.last = now;
    if (!this.playing) {
      this.show(this.index);
      return;
    }
    const time = this.leapt ? this.time : this.later(elapsed * this.speed); // the one sought comes first
    if (this.show(this.next(time))) this.time = time; // else it waits for the frame
    this.pace.note(now, this.time);
    this.playing = this.time < this.run.duration;
    if (!this.playing || now - this.lastStatus > STATUS) this.tellStatus();
  }

  /** The time in the run when so much has passed [s]; steps past a break go by slowly.
   * @param {number} passed */
  later(passed) {
    const { duration, single } = this.run;
    const { time } = this;
    const broke = this.times[this.sound];
    if (!single || time + passed < broke) return Math.min(time + passed, duration);
    if (time < broke) return broke;
    const slowly = Math.min(1, (duration - broke) / (single * STEP_SHOWN));
    return Math.min(time + passed * slowly, duration);
  }

  /** The frame to show at a time while it plays on: every so many, and the last. @param {number} time [s] */
  next(time) {
    const index = this.indexAt(time);
    const { shown, every, sound } = this;
    if (this.leapt || shown < 0 || index < shown || index >= sound) return index;
    return shown + every * Math.floor((index - shown) / every);
  }

  /** Show a frame; false: it is not there yet. @param {number} index */
  show(index) {
    if (!this.events || index === this.shown) {
      this.leapt = false;
      return true;
    }
    const on = this.shown < index && this.shown >= 0 && !this.leapt;
    const part = this.partOf(index);
    const buffer = this.frames.take(
      index,
      on ? this.shown : index - 1,
      index >= this.sound ? 1 : this.every,
      this.playing,
    );
    if (!buffer || !this.layoutThere(part)) return false;
    if (part !== this.part) this.tellLayout(part);
    const far = this.leapt && Math.abs(index - this.shown) > 2;
    [this.shown, this.leapt] = [index, false];
    this.number++;
    this.stamp(buffer);
    if (far) this.jumped();
    this.events.frame(buffer);
    return true;
  }

  /** Write into a frame what only the player knows. @param {ArrayBuffer} buffer */
  stamp(buffer) {
    const head = new DataView(buffer);
    head.setUint32(8, this.number, true);
    if (this.playing) head.setUint32(12, head.getUint32(12, true) | PLAYING, true);
    head.setFloat32(32, this.playing ? (this.pace.reached ?? 0) : 0, true);
    head.setFloat32(36, this.speed, true);
  }

  /** @param {number} index */
  partOf(index) {
    let part = this.first.length - 1;
    while (this.first[part] > index) part--;
    return part;
  }

  /** Whether a part's layout is known; it is asked for. @param {number} part */
  layoutThere(part) {
    if (this.layouts[part]) return true;
    this.frames.layout(part).then(
      (layout) => (this.layouts[part] = layout),
      () => {}, // its frames tell why
    );
    return false;
  }

  /** @param {number} part */
  tellLayout(part) {
    this.part = part;
    this.events?.message(this.layouts[part]);
  }

  /** Frames, each with the layout that it is written in. @param {number} first @param {number} count
   * @param {number} every @param {AbortSignal} [signal] @returns {Promise<{buffer: ArrayBuffer, layout: Layout}[]>} */
  async read(first, count, every, signal) {
    const there = Math.min(count, Math.ceil((this.times.length - first) / every));
    if (there <= 0) return [];
    const buffers = await this.frames.read(first, there, every, signal);
    const found = [];
    for (const [i, buffer] of buffers.entries()) {
      const part = this.partOf(first + i * every);
      this.layouts[part] ??= await this.frames.layout(part);
      found.push({ buffer, layout: this.layouts[part] });
    }
    return found;
  }

  tellStatus() {
    this.lastStatus = performance.now();
    const { method, dt } = this.run.parts[Math.max(this.part, 0)];
    this.events?.message({
      type: "status",
      playing: this.playing,
      speed: this.speed,
      realtime: this.playing ? this.pace.reached : 0,
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
      duration: this.run.duration,
    });
  }
}

/** @param {unknown} error */
export const wordsOf = (error) => (error instanceof Error ? error.message : String(error));
