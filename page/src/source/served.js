// Frames of a run that a server has: fetched in pieces ahead of the player, kept in a bounded memory.

import { layoutOf } from "./frame.js";
import { join } from "./join.js";
import { wordsOf } from "./replay.js";

/** @typedef {import("./protocol.js").Layout} Layout */
/** @typedef {import("./replay.js").Frames} Frames */

const MEMORY = 64e6; // bytes of frames that are kept
const PIECE = 2e6; // bytes that are fetched at once, about
const MOST = 64; // frames that are fetched at once
const PASSED = 16; // frames that are put together here; for more the server does it
const AGAIN = 1000; // ms after a failure

/** @implements {Frames} */
export class ServedFrames {
  /** @param {string} base @param {(text: string) => void} fail told of what cannot be had */
  constructor(base, fail) {
    this.base = base;
    this.fail = fail;
    this.within = 1e-9;
    this.count = 0; // of frames in the run
    this.loading = false;
    this.failed = -Infinity; // when [ms]
    this.said = ""; // of the last failure
    this.held = 0; // bytes
    /** Oldest first; the keys name a frame and since which one it tells what was seen.
     * @type {Map<string, ArrayBuffer>} */
    this.kept = new Map();
    /** @type {Map<number, Promise<Layout>>} */ this.layouts = new Map();
    /** @type {Map<number, Layout>} */ this.written = new Map(); // by their numbers
    this.bytes = 1; // of a frame, as last seen
  }

  async times() {
    const found = new Float64Array(await (await this.fetch("times.bin")).arrayBuffer());
    this.count = found.length;
    return found;
  }

  /** @param {number} part @returns {Promise<Layout>} */
  layout(part) {
    const known = this.layouts.get(part);
    if (known) return known;
    const found = this.fetch(`layout.json?part=${part}`).then((answer) => answer.json());
    found.catch(() => this.layouts.delete(part));
    this.layouts.set(part, found);
    return found;
  }

  /** @param {number} index @param {number} after @param {number} every @param {boolean} on */
  take(index, after, every, on) {
    const count = (index - after) / every;
    const whole = Number.isInteger(count) && count <= Math.min(PASSED, MEMORY / 4 / this.bytes);
    const step = on && whole ? every : index - after;
    let found = null;
    for (let at = after + step; at <= index; at += step) {
      const kept = this.kept.get(`${at} ${step}`);
      if (!kept) {
        this.load(at, step, on && step === every ? this.piece : 1);
        return null;
      }
      const next = kept.slice(0);
      if (found) join(found, next, this.written.get(layoutOf(next)));
      found = next;
    }
    if (on && step === every) this.ahead(index, step);
    return found;
  }

  /** Frames of a piece. */
  get piece() {
    return Math.min(MOST, Math.max(2, Math.floor(PIECE / this.bytes)));
  }

  /** Fetch what will be wanted next, once only half a piece is left. @param {number} index
   * @param {number} step */
  ahead(index, step) {
    const { piece } = this;
    let left = 0;
    while (left < piece && this.kept.has(`${index + (left + 1) * step} ${step}`)) left++;
    const next = index + (left + 1) * step;
    if (left < piece / 2 && next < this.count) this.load(next, step, piece);
  }

  /** @param {number} first @param {number} every @param {number} count */
  async load(first, every, count) {
    if (this.loading || performance.now() < this.failed + AGAIN) return;
    this.loading = true;
    try {
      (await this.read(first, count, every)).forEach((frame, i) =>
        this.keep(`${first + i * every} ${every}`, frame),
      );
    } catch (error) {
      this.failed = performance.now();
      const text = error instanceof TypeError ? "" : wordsOf(error); // no server: the socket says so
      if (text && text !== this.said) this.fail(text);
      this.said = text;
    } finally {
      this.loading = false;
    }
  }

  /** @param {string} key @param {ArrayBuffer} frame */
  keep(key, frame) {
    this.held += frame.byteLength - (this.kept.get(key)?.byteLength ?? 0);
    this.kept.delete(key);
    this.kept.set(key, frame);
    for (const [oldest, { byteLength }] of this.kept) {
      if (this.held <= MEMORY || this.kept.size <= 4) return;
      this.kept.delete(oldest);
      this.held -= byteLength;
    }
  }

  /** @param {number} first @param {number} count @param {number} every @param {AbortSignal} [signal] */
  async read(first, count, every, signal) {
    const path = `frames.bin?first=${first}&count=${count}&every=${every}`;
    const bytes = await (await this.fetch(path, signal)).arrayBuffer();
    const found = [];
    for (let at = 0; at < bytes.byteLength; at += this.bytes) {
      const number = layoutOf(bytes.slice(at, at + 48));
      const layout = await this.layout(number - 1);
      this.written.set(number, layout);
      this.bytes = layout.bytes;
      if (at + this.bytes > bytes.byteLength) throw new Error("the server's answer is cut short");
      found.push(bytes.slice(at, at + this.bytes));
    }
    return found;
  }

  /** @param {string} path @param {AbortSignal} [signal] */
  async fetch(path, signal) {
    const answer = await fetch(`${this.base}replay/${path}`, { signal });
    if (!answer.ok) throw new Error((await answer.text()).trim());
    return answer;
  }
}
