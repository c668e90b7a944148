// The page: the server's frames come by a socket, or those of a run that lies in the page itself.

import { App } from "./app.js";
import { makeHook } from "./hook.js";
import { connectReplay } from "./replayed.js";
import { chooseRenderer } from "./render/choose.js";
import { Session } from "./session.js";
import { h } from "./panels/dom.js";
import { findRecording } from "./source/recording.js";
import { Replay } from "./source/replay.js";
import { ServedFrames } from "./source/served.js";
import { SocketSource } from "./source/socket.js";
import { applyTheme, chosenTheme } from "./view/theme.js";

applyTheme(chosenTheme());
const recording = findRecording();
const session = new Session(recording?.replay ?? new SocketSource());
const root = /** @type {HTMLElement} */ (document.getElementById("app"));
const app = new App(root, session, chooseRenderer);
if (recording) {
  connectReplay(app, recording.replay);
  app.help.window.append(h("p", { className: "faint", id: "about" }, recording.about));
} else session.on("replay", (run) => playServed(run));
Object.assign(window, { ropewalk: makeHook(app) });
session.open();

/** Play a run that the server has; after a lost connection it plays on.
 * @param {import("./source/replay.js").Run} run */
function playServed(run) {
  const { hello, source } = session;
  if (source instanceof Replay) return session.take(source.hello);
  if (!hello) return;
  const frames = new ServedFrames(source.base, (text) => session.take({ type: "error", text }));
  const replay = new Replay(hello, run, frames);
  connectReplay(app, replay);
  session.open(replay);
}
