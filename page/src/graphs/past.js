// What the graphs of a replay show of the time before a jump: all of it in coarse steps, the last seconds in fine ones.

import { BROKEN } from "../source/frame.js";
import { wordsOf } from "../source/replay.js";
import { numbered, samplesOf } from "./samples.js";

/** @typedef {import("../app.js").App} App */
/** @typedef {import("../source/frame.js").Frame} Frame */
/** @typedef {import("../source/protocol.js").Layout} Layout */
/** @typedef {{time: number, values: [string, number][]}} Sample */
/** Reads frames `first`, `first + every`, ..., each with its layout.
 * @typedef {(first: number, count: number, every: number, signal: AbortSignal) =>
 *   Promise<{frame: Frame, layout: Layout}[]>} Read */

const FINE = 900; // samples at most
const COARSE = 600;
const LEAST = 60; // samples, however large the frames
const BYTES = 24e6; // that a row of samples may be read from
const PIECE = 2e6; // bytes of frames that are there at once
const REST = 120; // ms without a further jump

export class Past {
  /** @param {App} app @param {Read} read */
  constructor(app, read) {
    this.app = app;
    this.read = read;
    this.timer = 0;
    this.stop = new AbortController();
    this.known = ""; // what the coarse samples hold
    this.until = -1; // index of a frame up to which they go
    /** @type {Sample[]} */ this.coarse = [];
    app.graphs.wanted = () => this.want();
  }

  /** The place in the run has changed, or what is to be seen of it; a little later is soon enough. */
  want() {
    clearTimeout(this.timer);
    this.stop.abort(); // nobody wants what is still on its way
    this.timer = window.setTimeout(() => this.fill(), REST);
  }

  async fill() {
    this.stop.abort();
    this.stop = new AbortController();
    const { signal } = this.stop;
    try {
      await this.fetch(signal);
    } catch (error) {
      if (signal.aborted || error instanceof TypeError) return; // no server: the socket says so
      const text = `The graphs cannot tell of the time before: ${wordsOf(error)}.`;
      this.app.session.take({ type: "error", text });
    }
  }

  /** @param {AbortSignal} signal */
  async fetch(signal) {
    const { graphs, session, viewport } = this.app;
    const { layout, frame } = session;
    if (!graphs.open || !layout || !frame || frame.steps < 1) return;
    const [index, now] = [frame.steps, frame.time];
    const seconds = Math.min(graphs.window, now);
    const back = Math.min(index, Math.ceil((seconds * index) / Math.max(now, 1e-9)));
    const known = `${layout.layout} ${[...viewport.marks.followed]}`;
    if (known !== this.known || index > this.until) {
      this.coarse = await this.samples(0, index, COARSE, layout, signal);
      [this.known, this.until] = [known, index];
    }
    const fine = await this.samples(index - back, back, FINE, layout, signal);
    if (session.layout !== layout || !session.frame || session.frame.time < now) return;
    const start = fine[0]?.time ?? now;
    const { history } = graphs;
    history.clear();
    for (const { time, values } of this.coarse) if (time < start) history.add(time, values);
    for (const { time, values } of fine) history.add(time, values);
    graphs.take(session.frame);
    graphs.bounds();
  }

  /** Samples of what was seen in each interval, fewer where frames are large; read piece by piece, so that no
   * more than a piece of frames is there at once.
   * @param {number} first @param {number} count of frames @param {number} most samples
   * @param {Layout} layout @param {AbortSignal} signal @returns {Promise<Sample[]>} */
  async samples(first, count, most, layout, signal) {
    const affordable = Math.max(LEAST, Math.floor(BYTES / layout.bytes));
    const every = Math.max(1, Math.ceil(count / Math.min(most, affordable)));
    const piece = Math.max(1, Math.floor(PIECE / layout.bytes));
    const nodes = [...this.app.viewport.marks.followed];
    const end = first + count;
    /** @type {Sample[]} */ const found = [];
    for (let at = first; at < end; at += piece * every) {
      const left = Math.ceil((end - at) / every);
      const frames = await this.read(at, Math.min(piece, left), every, signal);
      if (signal.aborted) throw signal.reason;
      for (const { frame, layout: its } of frames) {
        if (frame.flags & BROKEN) continue;
        found.push({ time: frame.time, values: samplesFor(layout, its, frame, nodes) });
      }
    }
    return found;
  }
}

/** What a frame of another layout adds to the graphs of one: not what its names stand for in that one only.
 * @param {Layout} layout @param {Layout} its @param {Frame} frame @param {number[]} nodes
 * @returns {[string, number][]} */
function samplesFor(layout, its, frame, nodes) {
  if (its.layout === layout.layout) return samplesOf(layout, frame, nodes);
  const then = numbered(its);
  const others = numbered(layout).filter(([, of], k) => of !== then[k][1]);
  const there = nodes.filter((node) => node < its.variants[0].nodes);
  return samplesOf(its, frame, there).filter(([name]) => !others.some(([one]) => one.test(name)));
}
