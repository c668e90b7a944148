// A broken run: what happened in words, and one button for each way out.

import { BROKEN } from "../source/frame.js";
import { figures } from "../view/range.js";
import { placeOn } from "../view/cards.js";
import { theoryOf, whyInShort, whyItBroke } from "../view/why.js";
import { h } from "./dom.js";

/** @typedef {import("../session.js").Session} Session */
/** @typedef {import("../source/protocol.js").Broken} Broken */

const STEP = 300; // ms that a step past a break is seen
const REST = 3; // times that long the last one stays
const MOST = 0.38; // of the view's height that the card may take; beyond, its words are folded away
const SIGNS = /** @type {Record<string, string>} */ ({
  back: "Back to before",
  step: "Use the suggested step",
  implicit: "Use an implicit method",
  on: "Go on with these values",
});

export class BrokenCard {
  /** @param {Session} session @param {HTMLElement} host
   * @param {(positions: number[][] | null, variant: number) => void} draw shows places of nodes; null: the frame */
  constructor(session, host, draw) {
    this.session = session;
    this.draw = draw;
    this.timer = 0;
    this.card = h("section", {
      className: "card broken",
      hidden: true,
      role: "alert",
      id: "broken",
    });
    host.append(this.card);
    this.host = host;
    new ResizeObserver(() => this.fold()).observe(host);
    session.on("broken", (broken) => this.show(broken));
    session.on("frame", ({ flags }) => this.tellReplay((flags & BROKEN) !== 0));
  }

  /** In a replay: say that what is shown is past the break. @param {boolean} past */
  tellReplay(past) {
    const { hello, layout } = this.session;
    if (hello?.mode !== "replay" || this.card.hidden !== past) return;
    this.card.hidden = !past;
    if (!past || !layout?.broke) return;
    this.card.replaceChildren(
      h("h2", {}, "The run broke"),
      h("p", {}, layout.broke.text || `It broke after t = ${figures(layout.broke.time)} s.`),
      h(
        "p",
        { className: "faint" },
        "Shown: steps past the last good frame. No number counts them.",
      ),
    );
  }

  /** @param {Broken | null} broken */
  show(broken) {
    this.card.hidden = broken === null;
    clearTimeout(this.timer);
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
      h("p", { className: "short" }, whyInShort(broken.cause)),
      h("p", { className: "why" }, whyItBroke(broken.cause)),
      h("details", {}, h("summary", {}), h("p", {}, `${broken.text} ${theoryOf(broken.cause)}`)),
      h("div", { className: "row" }, ...buttons, ...this.look(broken)),
    );
    this.fold();
  }

  /** Where the words would cover the rope, put them behind a click but for the first few, and the buttons
   * beside the title. */
  fold() {
    const [why, details] = ["p.why", "details"].map((part) => this.card.querySelector(part));
    if (!why || !details || this.card.hidden) return;
    this.card.classList.remove("tight");
    details.before(why);
    const tight = this.card.scrollHeight > MOST * this.host.clientHeight;
    this.card.classList.toggle("tight", tight);
    if (tight) details.children[0].after(why);
    details.children[0].textContent = tight
      ? "Why, in words and numbers"
      : "The theory, in numbers";
  }

  /** Where it lies on the scene; null: it is not shown. @param {HTMLElement} canvas */
  place(canvas) {
    return placeOn(this.card, canvas);
  }

  /** A button that shows the steps past the last good frame. @param {Broken} broken */
  look(broken) {
    const { past } = broken;
    if (!past?.length) return [];
    const line = h("span", { className: "faint", id: "past" });
    const play = (/** @type {number} */ i) => {
      const step = past[Math.min(i, past.length - 1)];
      const over = i === past.length + REST;
      this.draw(over ? null : step.positions, broken.variant);
      line.textContent = over ? "" : `${step.time.toFixed(5)} s: past the last good state`;
      if (!over) this.timer = window.setTimeout(() => play(i + 1), STEP);
    };
    const onclick = () => {
      clearTimeout(this.timer);
      play(0);
    };
    return [
      h(
        "button",
        { type: "button", className: "second", id: "see-break", onclick },
        "See it break",
      ),
      line,
    ];
  }
}
