// What the page of a recording has besides: graphs that know the past after a jump, and what is rounded.

import { samplesOf } from "./graphs/samples.js";
import { readFrame } from "./source/frame.js";
import { h } from "./panels/dom.js";

/** @typedef {import("./app.js").App} App */
/** @typedef {import("./source/recording.js").RecordingSource} RecordingSource */

/** @param {App} app @param {RecordingSource} recording */
export function connectRecording(app, recording) {
  recording.jumped = (index) => fillGraphs(app, recording, index);
  const { about } = recording.header;
  app.help.window.append(h("p", { className: "faint", id: "about" }, about));
}

/** Give the graphs the seconds before a frame. @param {App} app @param {RecordingSource} recording
 * @param {number} index of the frame */
function fillGraphs({ graphs, stage }, recording, index) {
  const { history } = graphs;
  history.clear();
  stage.marks.trails?.clear();
  const part = recording.parts[recording.partOf(index)];
  const from = recording.times[index] - graphs.window;
  let at = index;
  while (at > part.first && recording.times[at - 1] >= from) at--;
  for (; at < index; at++) {
    const frame = readFrame(recording.frame(at), part.layout);
    history.add(frame.time, samplesOf(part.layout, frame, stage.marks.followed));
  }
}
