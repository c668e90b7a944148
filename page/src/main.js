// The page: the server's frames come by a socket, or those of a run that lies in the page itself.

import { App } from "./app.js";
import { makeHook } from "./hook.js";
import { connectRecording } from "./recorded.js";
import { connectReplay } from "./replayed.js";
import { chooseRenderer } from "./render/choose.js";
import { Session } from "./session.js";
import { findRecording } from "./source/recording.js";
import { SocketSource } from "./source/socket.js";
import { applyTheme, chosenTheme } from "./view/theme.js";

applyTheme(chosenTheme());
const recording = findRecording();
const session = new Session(recording ?? new SocketSource());
const root = /** @type {HTMLElement} */ (document.getElementById("app"));
const app = new App(root, session, chooseRenderer);
if (recording) connectRecording(app, recording);
else connectReplay(app);
Object.assign(window, { ropewalk: makeHook(app) });
session.open();
