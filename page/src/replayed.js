// A run that the server replays: the graphs fetch what was before, as frames.

import { Past } from "./graphs/past.js";
import { layoutOf, readFrame } from "./source/frame.js";

/** @typedef {import("./app.js").App} App */
/** @typedef {import("./source/protocol.js").Layout} Layout */

const LEAP = 0.3; // s

/** @param {App} app */
export function connectReplay(app) {
  const { session, stage } = app;
  /** @type {Past | null} */ let past = null;
  let last = 0;
  session.on("frame", ({ time }) => {
    if (session.hello?.mode !== "replay") return;
    past ??= new Past(app, (...which) => fetchFrames(app, ...which));
    const leapt = time < last || time > last + LEAP * Math.max(1, session.status?.speed ?? 1);
    last = time;
    if (!leapt) return;
    stage.marks.trails?.clear();
    past.want();
  });
}

/** @param {App} app @param {number} first @param {number} count @param {number} every */
async function fetchFrames({ session }, first, count, every) {
  const layout = /** @type {Layout} */ (session.layout);
  if (count < 1) return [];
  const path = `replay/frames.bin?first=${first}&count=${count}&every=${every}`;
  const answer = await fetch(session.source.base + path).catch(() => null);
  if (!answer?.ok) return []; // graphs without a past
  return framesOf(await answer.arrayBuffer(), layout).map((buffer) => readFrame(buffer, layout));
}

/** The last frames of a file that are of one layout. @param {ArrayBuffer} bytes @param {Layout} layout */
function framesOf(bytes, layout) {
  const found = [];
  for (let end = bytes.byteLength; end >= layout.bytes; end -= layout.bytes) {
    const buffer = bytes.slice(end - layout.bytes, end);
    if (layoutOf(buffer) !== layout.layout) break;
    found.push(buffer);
  }
  return found.reverse();
}
