// Notices: short messages that go away, and a banner while there is no server.

import { h, icon } from "./dom.js";

/** @typedef {import("../session.js").Session} Session */

const STAYS = 7000; // ms
const LETTER = 40; // ms that a long one stays longer for each letter
const SHORT = 80; // letters
const MOST = 3;

export class Notices {
  /** @param {Session} session @param {HTMLElement} host */
  constructor(session, host) {
    this.list = h("div", { className: "notices", "aria-live": "polite" });
    this.banner = h("div", { className: "banner", hidden: true, role: "alert", id: "banner" });
    this.slow = h("div", { className: "slow-note", hidden: true, id: "slow" });
    host.append(this.banner, this.slow, this.list);
    session.on("error", (fault) => this.say(fault.text, "fault"));
    session.on("note", ({ text }) => this.say(text));
    session.on("saved", ({ folder }) => this.say(`Saved in ${folder}`));
    session.on("connection", ({ state, text }) => this.connection(state, text));
    session.on("status", ({ slow, text, broken, waits = "" }) => {
      const shown = waits || (slow && !broken && text) || "";
      this.slow.hidden = !shown;
      this.slow.classList.toggle("waits", waits !== "");
      if (shown && this.slow.textContent !== shown)
        this.slow.replaceChildren(waits && h("span", { className: "spinner" }), shown);
    });
  }

  /** @param {string} state @param {string} text */
  connection(state, text) {
    this.banner.hidden = state === "open";
    this.banner.classList.toggle("calm", state === "waiting");
    document.documentElement.dataset.connection = state;
    if (state === "open") return;
    if (state === "damaged") this.banner.replaceChildren(text);
    else {
      const more = state === "waiting" ? "" : " Trying again …";
      this.banner.replaceChildren(h("span", { className: "spinner" }), `${text}${more}`);
    }
  }

  /** @param {string} text @param {"note" | "fault"} [kind] @returns {() => void} takes it away again */
  say(text, kind = "note") {
    for (const other of this.list.children)
      if (other.firstChild?.textContent === text) other.remove();
    const close = h(
      "button",
      { type: "button", className: "plain", "aria-label": "Close", onclick: () => note.remove() },
      icon("close"),
    );
    const note = h("div", { className: `notice ${kind}` }, h("span", {}, text), close);
    this.list.append(note);
    while (this.list.children.length > MOST) this.list.firstChild?.remove();
    setTimeout(() => note.remove(), STAYS + LETTER * Math.max(0, text.length - SHORT));
    return () => note.remove();
  }
}
