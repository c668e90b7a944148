// What the graphs of a replay show of the time before a jump: all of it in coarse steps, the last seconds in fine ones.

import { BROKEN } from "../source/frame.js";
import { samplesOf } from "./samples.js";

/** @typedef {import("../app.js").App} App */
/** @typedef {import("../source/frame.js").Frame} Frame */
/** @typedef {import("../source/protocol.js").Layout} Layout */
/** @typedef {{time: number, values: [string, number][]}} Sample */
/** Reads frames `first`, `first + every`, ...; only those of the layout that is shown.
 * @typedef {(first: number, count: number, every: number) => Promise<Frame[]>} Read */

const FINE = 900; // samples at most
const COARSE = 600;
const REST = 120; // ms without a further jump

export class Past {
  /** @param {App} app @param {Read} read */
  constructor(app, read) {
    this.app = app;
    this.read = read;
    this.timer = 0;
    this.known = ""; // what the coarse samples hold
    this.until = -1; // index of a frame up to which they go
    /** @type {Sample[]} */ this.coarse = [];
    app.graphs.wanted = () => this.want();
  }

  /** The place in the run has changed, or what is to be seen of it; a little later is soon enough. */
  want() {
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => this.fill(), REST);
  }

  async fill() {
    const { graphs, session, stage } = this.app;
    const { layout, frame } = session;
    if (!graphs.open || !layout || !frame || frame.steps < 1) return;
    const [index, now] = [frame.steps, frame.time];
    const seconds = Math.min(graphs.window, now);
    const back = Math.min(index, Math.ceil((seconds * index) / Math.max(now, 1e-9)));
    const known = `${layout.layout} ${[...stage.marks.followed]}`;
    if (known !== this.known || index > this.until) {
      this.coarse = await this.samples(0, index, COARSE, layout);
      [this.known, this.until] = [known, index];
    }
    const fine = await this.samples(index - back, back, FINE, layout);
    if (session.layout !== layout || !session.frame || session.frame.time < now) return;
    const start = fine[0]?.time ?? now;
    const { history } = graphs;
    history.clear();
    for (const { time, values } of this.coarse) if (time < start) history.add(time, values);
    for (const { time, values } of fine) history.add(time, values);
    graphs.take(session.frame);
    graphs.bounds();
  }

  /** @param {number} first @param {number} count of frames @param {number} most samples
   * @param {Layout} layout @returns {Promise<Sample[]>} */
  async samples(first, count, most, layout) {
    const every = Math.max(1, Math.ceil(count / most));
    const nodes = [...this.app.stage.marks.followed];
    const frames = await this.read(first, Math.ceil(count / every), every);
    const sound = frames.filter((frame) => !(frame.flags & BROKEN));
    return sound.map((frame) => ({ time: frame.time, values: samplesOf(layout, frame, nodes) }));
  }
}
