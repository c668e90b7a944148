// The sound of the first anchor's force, in the live view: off until it is asked for.

import { Sound } from "../sound.js";
import { button } from "./dom.js";

/** @typedef {import("../session.js").Session} Session */

export class Hearing {
  /** @param {Session} session */
  constructor(session) {
    this.session = session;
    this.sound = new Sound();
    this.heard = 0; // forces that have come
    this.button = button("sound", "Sound of the first anchor's force", () => this.turn(), {
      id: "sound",
    });
    this.show();
    session.on("sound", ({ seconds, forces }) => this.hear(seconds, forces));
    session.on("hello", () => {
      this.show();
      if (this.sound.on) session.send({ type: "listen", on: true }); // to a server that is new
    });
    session.on("status", ({ playing }) => playing || this.sound.restart());
  }

  turn() {
    this.sound.turn(!this.sound.on);
    this.sound.restart();
    this.session.send({ type: "listen", on: this.sound.on });
    this.show();
  }

  show() {
    this.button.hidden = !this.session.can("listen");
    this.button.setAttribute("aria-pressed", String(this.sound.on));
  }

  /** @param {number} seconds from one force to the next @param {number[]} forces [N] */
  hear(seconds, forces) {
    if (!this.sound.on) return;
    this.heard += forces.length;
    for (const force of forces) this.sound.hear(force, seconds);
    this.sound.play();
  }
}
