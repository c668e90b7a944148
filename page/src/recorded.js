// What the page of a recording has besides: graphs that know the past after a jump, and what is rounded.

import { Past } from "./graphs/past.js";
import { readFrame } from "./source/frame.js";
import { h } from "./panels/dom.js";

/** @typedef {import("./app.js").App} App */
/** @typedef {import("./source/frame.js").Frame} Frame */
/** @typedef {import("./source/recording.js").RecordingSource} RecordingSource */

const AT_ONCE = 40; // frames that are read before the page may draw again

/** @param {App} app @param {RecordingSource} recording */
export function connectRecording(app, recording) {
  const past = new Past(app, (...which) => framesOf(recording, ...which));
  recording.jumped = () => {
    app.stage.marks.trails?.clear();
    past.want();
  };
  const { about } = recording.header;
  app.help.window.append(h("p", { className: "faint", id: "about" }, about));
}

/** Frames of the part that is shown. @param {RecordingSource} recording @param {number} first
 * @param {number} count @param {number} every */
async function framesOf(recording, first, count, every) {
  const part = recording.parts[recording.layout];
  /** @type {Frame[]} */ const found = [];
  for (let i = 0; i < count; i++) {
    const index = first + i * every;
    if (index < part.first || index >= part.first + part.frames) continue;
    found.push(readFrame(recording.frame(index, index - every), part.layout));
    if (i % AT_ONCE === AT_ONCE - 1) await new Promise((done) => setTimeout(done));
  }
  return found;
}
