// What a page has besides that replays a run, its own or the server's: graphs that know the past after a jump.

import { Past } from "./graphs/past.js";
import { readFrame } from "./source/frame.js";

/** @typedef {import("./app.js").App} App */
/** @typedef {import("./source/replay.js").Replay} Replay */

/** @param {App} app @param {Replay} replay */
export function connectReplay(app, replay) {
  const past = new Past(app, async (first, count, every, signal) => {
    const found = await replay.read(first, count, every, signal);
    return found.map(({ buffer, layout }) => ({ frame: readFrame(buffer, layout), layout }));
  });
  replay.jumped = () => {
    app.viewport.marks.trails?.clear();
    past.want();
  };
}
