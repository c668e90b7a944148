// Where the button beside a parameter leads: to the scene's own value, of every rope its own.

import { unitText } from "../view/range.js";

/** @typedef {import("../source/protocol.js").Parameter} Parameter */

/** Whether there is anything to go back from, and what the button says. @param {Parameter} parameter
 * @param {string} rope that is changed; empty: all */
export function backOf(parameter, rope) {
  const { values, defaults } = parameter;
  const one = rope !== "" && rope in (values ?? {});
  const pairs =
    values && defaults
      ? (one ? [rope] : Object.keys(values)).map((name) => [values[name], defaults[name]])
      : [[parameter.value, parameter.default]];
  const [, first] = pairs[0];
  const alike = pairs.every(([, own]) => asText(own) === asText(first));
  const lost = !!defaults && pairs.some(([now, own]) => own === null && now !== null);
  const changed = !lost && pairs.some(([now, own]) => asText(now) !== asText(own));
  const text = asText(first);
  if (lost) return { changed, title: "A piece of a cut rope has no value of the scene's" };
  if (!alike) return { changed, title: "Back to each rope's own" };
  return { changed, title: `Back to ${text || "the scene's"} ${unitText(parameter.unit)}`.trim() };
}

/** @param {any} value @returns {string} */
function asText(value) {
  if (value === null || value === undefined) return "";
  if (typeof value === "number") return String(Number(value.toPrecision(6)));
  if (Array.isArray(value)) return `[${value.map(asText).join(", ")}]`;
  return String(value);
}
