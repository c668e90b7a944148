// A run that the server replays: after a jump the graphs get the seconds before it, fetched as frames.

import { samplesOf } from "./graphs/samples.js";
import { layoutOf, readFrame } from "./source/frame.js";

/** @typedef {import("./app.js").App} App */
/** @typedef {import("./source/protocol.js").Layout} Layout */

const JUMP = 3; // frames
const MOST = 900; // samples to fetch

/** @param {App} app */
export function connectReplay(app) {
  const { session } = app;
  let last = 0;
  session.on("frame", ({ steps, time }) => {
    const jumped = session.hello?.mode === "replay" && Math.abs(steps - last) > JUMP;
    last = steps;
    if (jumped) fetchBefore(app, steps, time);
  });
}

/** @param {App} app @param {number} index of a frame @param {number} time of it [s] */
async function fetchBefore({ session, graphs, stage }, index, time) {
  const layout = /** @type {Layout} */ (session.layout);
  const back = Math.min(index, Math.ceil((graphs.window * index) / Math.max(time, 1e-9)));
  const every = Math.max(1, Math.ceil(back / MOST));
  const count = Math.floor(back / every);
  if (count < 1) return;
  const first = index - count * every;
  const path = `replay/frames.bin?first=${first}&count=${count}&every=${every}`;
  const answer = await fetch(session.source.base + path).catch(() => null);
  if (!answer?.ok) return; // graphs without a past
  const bytes = await answer.arrayBuffer();
  if (session.layout !== layout || Math.abs((session.frame?.steps ?? NaN) - index) > 60) return;
  const { history } = graphs;
  history.clear();
  stage.marks.trails?.clear();
  for (const buffer of framesOf(bytes, layout)) {
    const frame = readFrame(buffer, layout);
    history.add(frame.time, samplesOf(layout, frame, stage.marks.followed));
  }
  if (graphs.open) graphs.bounds();
}

/** The last frames of a file that are of one layout. @param {ArrayBuffer} bytes @param {Layout} layout */
function framesOf(bytes, layout) {
  const found = [];
  for (let end = bytes.byteLength; end >= layout.bytes; end -= layout.bytes) {
    const buffer = bytes.slice(end - layout.bytes, end);
    if (layoutOf(buffer) !== layout.layout) break;
    found.unshift(buffer);
  }
  return found;
}
