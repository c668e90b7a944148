// A broken run: what happened in words, and one button for each way out.

import { h } from "./dom.js";

/** @typedef {import("../session.js").Session} Session */
/** @typedef {import("../source/protocol.js").Broken} Broken */

const SIGNS = /** @type {Record<string, string>} */ ({
  back: "Back to before",
  step: "Use the suggested step",
  implicit: "Use an implicit method",
  on: "Go on with these values",
});

export class BrokenCard {
  /** @param {Session} session @param {HTMLElement} host */
  constructor(session, host) {
    this.session = session;
    this.card = h("section", {
      className: "card broken",
      hidden: true,
      role: "alert",
      id: "broken",
    });
    host.append(this.card);
    session.on("broken", (broken) => this.show(broken));
  }

  /** @param {Broken | null} broken */
  show(broken) {
    this.card.hidden = broken === null;
    if (!broken) return;
    const buttons = broken.remedies.map((remedy, i) =>
      h(
        "button",
        {
          type: "button",
          className: i === 0 ? "main" : "second",
          data: { remedy: remedy.id },
          onclick: () => this.session.tell({ type: "remedy", remedy: remedy.id }),
        },
        remedy.label || SIGNS[remedy.id],
      ),
    );
    this.card.replaceChildren(
      h("h2", {}, "The simulation broke"),
      h("p", {}, broken.text),
      h("div", { className: "row" }, ...buttons),
    );
  }
}
