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
    /** @type {Broken | null} */ this.broken = null; // that is shown
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

  /** Show a break; of one that is shown already only what is new is written: what is open stays so, and a
   * press on a button meets the same one when it ends. @param {Broken | null} broken */
  show(broken) {
    const before = this.broken;
    this.broken = broken;
    this.card.hidden = broken === null;
    const same = broken && before && isSame(before, broken);
    if (!same) clearTimeout(this.timer);
    if (!broken) return;
    if (!same) this.begin();
    const [short, why, theory] = ["p.short", "p.why", "p.theory"].map((part) => this.part(part));
    write(short, whyInShort(broken.cause));
    write(why, whyItBroke(broken.cause));
    write(theory, `${broken.text} ${theoryOf(broken.cause)}`);
    const ways = broken.remedies.map((remedy, i) => this.way(remedy, i === 0));
    arrange(this.part(".row"), [...ways, ...this.look(broken)]);
    this.fold();
  }

  /** Empty the card for another break. */
  begin() {
    this.card.replaceChildren(
      h("h2", {}, "The simulation broke"),
      h("p", { className: "short" }),
      h("p", { className: "why" }),
      h("details", {}, h("summary"), h("p", { className: "theory" })),
      h("div", { className: "row" }),
    );
  }

  /** A piece of the card that is there. @param {string} selector @returns {HTMLElement} */
  part(selector) {
    return /** @type {HTMLElement} */ (this.card.querySelector(selector));
  }

  /** The button of a way out. @param {Broken["remedies"][number]} remedy @param {boolean} first */
  way(remedy, first) {
    const told = { type: "remedy", remedy: remedy.id };
    const button =
      this.part(`[data-remedy="${remedy.id}"]`) ??
      h("button", {
        type: "button",
        data: { remedy: remedy.id },
        onclick: () => this.session.tell(told),
      });
    button.className = first ? "main" : "second";
    write(button, remedy.label || SIGNS[remedy.id]);
    return button;
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
    write(details.children[0], tight ? "Why, in words and numbers" : "The theory, in numbers");
  }

  /** Where it lies on the scene; null: it is not shown. @param {HTMLElement} canvas */
  place(canvas) {
    return placeOn(this.card, canvas);
  }

  /** A button that shows the steps past the last good frame, and their line. @param {Broken} broken
   * @returns {HTMLElement[]} */
  look(broken) {
    const { past } = broken;
    if (!past?.length) return [];
    const there = [this.part("#see-break"), this.part("#past")];
    if (there[0]) return there;
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
    const about = { type: "button", className: "second", id: "see-break", onclick };
    return [h("button", about, "See it break"), line];
  }
}

/** Whether two messages are of one break. @param {Broken} one @param {Broken} other */
function isSame(one, other) {
  return one.variant === other.variant && one.time === other.time && one.step === other.step;
}

/** Write a text where it is another one: what is selected in it stays. @param {Element} element
 * @param {string} text */
function write(element, text) {
  if (element.textContent !== text) element.textContent = text;
}

/** Let an element have these children; those that are there stay where they are. @param {HTMLElement} host
 * @param {HTMLElement[]} wanted */
function arrange(host, wanted) {
  for (const child of [...host.children])
    if (!wanted.includes(/** @type {HTMLElement} */ (child))) child.remove();
  let next = host.firstElementChild;
  for (const child of wanted) {
    if (child === next) next = next.nextElementSibling;
    else host.insertBefore(child, next);
  }
}
