// How near ropes come to breaking, in words, each number rounded to the safe side.

import { figures, quantity } from "./range.js";

/** @typedef {import("../source/protocol.js").Layout} Layout */
/** @typedef {import("../source/protocol.js").Rope} Rope */
/** What a rope bears: its name, with the copy's where there are several; its tension over its breaking load as given
 * and over the least that a guessed one may be [1]; that load [N], null where it is no guess.
 * @typedef {{name: string, share: number, worst: number, least: number | null}} Use */

const DIGITS = 3;
const LITTLE = 1e-4; // of a breaking load: of less there is no number
const ROUNDING = 1e-9; // what computing a number may have added to it or taken away

/** @param {number} value @param {(x: number) => number} to `Math.ceil` or `Math.floor` */
function rounded(value, to) {
  const unit = 10 ** (Math.floor(Math.log10(value)) + 1 - DIGITS);
  const slack = to === Math.ceil ? -ROUNDING : ROUNDING;
  return figures(Number((to((value / unit) * (1 + slack)) * unit).toPrecision(DIGITS)));
}

/** @param {number} share of the breaking load [1] */
function near(share) {
  if (!(share > LITTLE)) return `${share > 0 ? "under 0.01" : 0} %`;
  const used = `${rounded(100 * share, Math.ceil)} %`;
  return share > 1
    ? `${used}: more than it bears`
    : `${used}, safety factor ${rounded(1 / share, Math.floor)}`;
}

/** What the ropes bear whose breaking loads are known, of tensions in the order of `layout`.
 * @param {Layout} layout @param {number[][]} tensions greatest of each rope of each variant [N] @returns {Use[]} */
export function usesOf({ variants }, tensions) {
  return variants.flatMap(({ label, ropes }, v) =>
    ropes.flatMap((rope, r) => {
      const { name, breaking_load: load, least_load: least = null } = rope;
      if (!load) return [];
      const tension = Math.max(0, tensions[v][r]);
      const full = variants.length > 1 ? `${label}, ${name}` : name;
      return [{ name: full, share: tension / load, worst: tension / (least || load), least }];
    }),
  );
}

/** How near to breaking: of the rope that is nearest, and of the one that is nearest where guessed breaking loads are
 * as small as they may be. @param {Use[]} uses @param {number} ropes how many there are, with those of no known load */
export function marginText(uses, ropes = uses.length) {
  if (!uses.length) return "";
  if (!uses.every(({ share }) => Number.isFinite(share))) return "Most now: not known"; // broken, or cut since
  const first = uses.reduce((most, one) => (one.share > most.share ? one : most));
  const worst = uses.reduce((most, one) => {
    const same = one.worst === most.worst && one === first;
    return one.worst > most.worst || same ? one : most;
  });
  const its = ropes > 1 ? `${first.name}, ` : "";
  const told = [`Most now: ${its}${near(first.share)}`];
  if (first.least !== null) told.push(guessText(first, "Its breaking load is a guess"));
  if (worst !== first && worst.least !== null)
    told.push(guessText(worst, `${worst.name} may be nearer: its breaking load is a guess`));
  const without = ropes - uses.length;
  if (without) told.push(`${without} of ${ropes} ropes: no breaking load known`);
  return told.join("\n");
}

/** @param {Use} use @param {string} why */
const guessText = ({ worst, least }, why) =>
  `${why}; if it is only ${quantity(least ?? 0, "N")}: ${near(worst)}`;
