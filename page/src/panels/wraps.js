// Wraps of ropes on obstacles in words and numbers, and what friction has taken.

import { scalar } from "../source/frame.js";
import { figures, quantity } from "../view/range.js";
import { h } from "./dom.js";

/** @typedef {import("../source/protocol.js").Layout} Layout */
/** @typedef {import("../source/frame.js").Frame} Frame */
/** @typedef {import("../source/frame.js").Part} Part */
/** One stretch of a rope on an obstacle: by which angle it turns there [rad], the tensions at both ends [N],
 * their ratio at which it slips [1], and whether ropes lie on it.
 * @typedef {{rope: string, obstacle: string, angle: number, before: number, after: number, slip: number,
 *   pressed: boolean}} Wrap */

const WRAP = 8; // numbers of a wrap
const PAIR = 5; // numbers of a contact of two ropes
const MOST = 4; // that are listed; and as many surfaces
const LATE = 0.25; // s, from which on it is said how old wraps are
const ENDLESS = 1e4; // a ratio at slip beyond which there is none
const HELD = 1e-3; // of a ratio over 1, below which friction holds nothing
const OVER = 1.03; // of the logarithm of a ratio at slip: so much nodes on a turn may err by
const SLACK = 1e-9; // N
const NOTHING = 1e-9; // J, which friction has not taken
const ROPES = "ropes on ropes"; // as the server calls what they do to each other
const ROOMY = "(min-width: 701px) and (min-height: 740px)"; // windows in which it is open from the start
const TITLE =
  "By which angle a rope turns towards an obstacle, its tensions before and after, and the ratio of these. It slips " +
  "at exp(friction × angle) round a drum, if it has no weight, does not move and nothing else lies on it. In " +
  "brackets: how much of that angle its ratio takes.";

/** @param {Layout} layout @param {Part} part @returns {Wrap[]} */
export function wrapsOf({ obstacles, variants: [{ ropes }] }, { wraps, ropeContacts }) {
  const found = [];
  for (let at = 0; at < wraps.length; at += WRAP) {
    const [rope, obstacle, first, last, angle, before, after, grip] = wraps.subarray(at, at + WRAP);
    if (!(rope >= 0)) continue;
    const names = [ropes[rope]?.name ?? "", obstacles?.[obstacle]?.name ?? ""];
    found.push({
      ...{ rope: names[0], obstacle: names[1], angle, before, after },
      slip: Math.exp(grip),
      pressed: pressed(ropeContacts, (ropes[rope]?.zero ?? 0) + first, last - first),
    });
  }
  return found;
}

/** Whether ropes touch each other on some segments. @param {Float32Array} pairs @param {number} first node
 * @param {number} length */
function pressed(pairs, first, length) {
  for (let row = 0; row < pairs.length; row += PAIR)
    for (const place of pairs.subarray(row, row + 2))
      if (pairs[row] >= 0 && place >= first - 1 && place <= first + length + 1) return true;
  return false;
}

/** Larger over smaller tension; NaN where that pulls nothing. @param {Wrap} wrap */
export function ratioOf({ before, after }) {
  const [low, high] = [Math.min(before, after), Math.max(before, after)];
  return low > SLACK ? high / low : NaN;
}

/** A wrap in two lines. @param {Wrap} wrap @param {boolean} named whether ropes are told apart */
export function wrapText(wrap, named) {
  const { rope, obstacle, angle, before, after } = wrap;
  const where = `${named ? `${rope} on ` : ""}${obstacle}: ${Math.round((180 / Math.PI) * angle)}°`;
  const pull = (/** @type {number} */ size) => (size > SLACK ? quantity(size, "N") : "slack");
  return [`${where}, ${pull(before)} → ${pull(after)}`, holdsText(wrap)];
}

/** The ratio of tensions, and how much of what friction of the turn can hold it takes: of the angle of a rope
 * without weight that is alone there. Where other ropes lie on it, or it is being braked, that is not the limit.
 * @param {Wrap} wrap */
function holdsText(wrap) {
  const ratio = ratioOf(wrap);
  const beyond = wrap.pressed ? "held by ropes on it, too" : "more than its turn holds";
  if (Number.isNaN(ratio)) return wrap.pressed ? beyond : "one side is slack";
  const said = `ratio ${figures(Number(ratio.toPrecision(3)))}`;
  if (wrap.slip < 1 + HELD) return `${said}, no friction along it`;
  if (wrap.slip > ENDLESS) return `${said}, slips at none`;
  const share = Math.log(ratio) / Math.log(wrap.slip);
  const slips = `slips at ${figures(wrap.slip)}`;
  if (share > OVER) return `${said}, ${slips}: ${beyond}`;
  if (wrap.pressed) return `${said}, ${slips} without the ropes on it`;
  return `${said}, ${slips} (${figures(Number((100 * Math.min(share, 1)).toPrecision(2)))} %)`;
}

/** What friction has taken, the most first: [J] by surface; [] where it is not known. Ropes take of each other
 * only: what is less than nothing is what their contacts hold.
 * @param {Layout} layout @param {Part} part @returns {{name: string, taken: number}[]} */
export function takenBy({ variants: [{ surfaces }] }, { frictionWork }) {
  return [...frictionWork]
    .map((work, k) => ({ name: surfaces?.[k] ?? "", taken: -work }))
    .filter(({ name, taken }) => name && (name === ROPES ? taken : Math.abs(taken)) >= NOTHING)
    .sort((a, b) => Math.abs(b.taken) - Math.abs(a.taken));
}

/** What friction took, or gave where an obstacle drives ropes by it; "" where it is not known.
 * @param {Layout} layout @param {Part} part */
export function takenText(layout, part) {
  if (![...part.frictionWork].some(Number.isFinite)) return "";
  const taken = takenBy(layout, part);
  if (!taken.length) return "Friction has taken nothing yet";
  const said = taken.slice(0, MOST).map(({ name, taken }) => {
    const where = name === ROPES ? "between ropes" : `on ${name}`;
    return `${taken < 0 ? "gave " : ""}${quantity(Math.abs(taken), "J")} ${where}`;
  });
  if (taken.length > MOST) said.push(`and on ${taken.length - MOST} more`);
  return `Friction ${taken[0].taken < 0 ? "" : "took "}${said.join(", ")}`;
}

export class WrapNote {
  constructor() {
    this.wraps = h("div", { id: "wrap-list" });
    this.taken = h("p", { id: "friction-taken" });
    this.summary = h("summary", {});
    this.host = h(
      "details",
      { className: "wraps", id: "wraps", hidden: true, open: matchMedia(ROOMY).matches },
      this.summary,
      h("div", { className: "wraps-body" }, this.wraps, this.taken),
    );
    this.host.title = TITLE;
    this.text = "";
  }

  /** @param {Layout | null} layout @param {Frame | null} frame */
  show(layout, frame) {
    const part = frame?.parts[0];
    const known = layout && part && (part.wraps.length || part.frictionWork.length);
    this.host.hidden = !known;
    if (!known) return;
    const [summary, wraps, taken] = wordsOf(layout, part);
    const text = JSON.stringify([summary, wraps, taken]);
    if (text === this.text) return;
    this.text = text;
    this.summary.textContent = summary;
    this.wraps.replaceChildren(
      ...wraps.map((lines) => h("p", {}, ...lines.map((line) => h("span", {}, line)))),
    );
    this.taken.textContent = taken;
    this.taken.hidden = !taken;
  }
}

/** What is told: the headline, the wraps by lines, and what friction took. @param {Layout} layout
 * @param {Part} part @returns {[string, string[][], string]} */
export function wordsOf(layout, part) {
  const wraps = wrapsOf(layout, part);
  const named = layout.variants[0].ropes.length > 1;
  const lines = wraps.slice(0, MOST).map((wrap) => wrapText(wrap, named));
  const all = scalar(layout, part, "wraps");
  if (all > lines.length) lines.push([`and ${all - lines.length} more wraps`]);
  const age = scalar(layout, part, "wrap_age");
  if (age > LATE && lines.length)
    lines.push([`as it was ${quantity(Number(age.toPrecision(2)), "s")} ago`]);
  const summary = part.wraps.length ? "Wraps and friction" : "Friction";
  return [summary, lines, takenText(layout, part)];
}
