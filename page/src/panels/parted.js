// Ropes that have parted, in words: where, at what tension, and when.

import { quantity } from "../view/range.js";
import { h } from "./dom.js";

/** @typedef {import("../session.js").Session} Session */
/** @typedef {import("../source/protocol.js").Parted} One */

const MOST = 2; // that are named in the legend

/** @param {One} one */
export function partedText({ rope, place, length, tension, time }) {
  const from = Math.min(place, length - place);
  const end = place <= length / 2 ? "start" : "end";
  const where = `${quantity(from, "m")} from its ${end}`;
  return `${rope} parted ${where}, at ${quantity(tension, "N")}, t = ${quantity(time, "s")}`;
}

export class PartedNote {
  /** @param {Session} session @param {(text: string) => void} say */
  constructor(session, say) {
    this.session = session;
    this.say = say;
    this.host = h("div", { className: "numbers parted", id: "parted", hidden: true });
    this.host.title = "A rope parts where its tension passes its breaking load";
    /** What has been said. @type {Set<string>} */ this.said = new Set();
    session.on("frame", ({ time }) => this.show(time));
    session.on("layout", () => this.show(session.frame?.time ?? -Infinity));
  }

  /** @param {number} time of what is shown [s] */
  show(time) {
    const { layout } = this.session;
    const many = (layout?.variants.length ?? 0) > 1;
    const all = (layout?.variants ?? []).flatMap(({ parted, label }) =>
      (parted ?? [])
        .filter((one) => one.time <= time)
        .map((one) => (many ? `${label}: ` : "") + partedText(one)),
    );
    for (const text of all) if (!this.said.has(text)) this.say(text);
    this.said = new Set(all);
    const more = all.length - MOST;
    const text = [...all.slice(0, MOST), ...(more > 0 ? [`and ${more} more`] : [])].join("\n");
    this.host.hidden = !text;
    if (this.host.textContent !== text) this.host.textContent = text;
  }
}
