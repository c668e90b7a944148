// From a slider's place (0 to 1) to a value and back, evenly or by powers of ten.

/** @typedef {{low: number, high: number, scale: "linear" | "log", whole: boolean}} Scale */

/** @param {Scale} scale @param {number} place @returns {number} */
export function valueAt(scale, place) {
  const { low, high } = scale;
  const log = scale.scale === "log" && low > 0;
  const value = log ? low * (high / low) ** place : low + place * (high - low);
  if (scale.whole) return Math.round(value);
  return Number(value.toPrecision(3)); // what a slider can mean
}

/** @param {Scale} scale @param {number} value @returns {number} */
export function placeOf(scale, value) {
  const { low, high } = scale;
  const log = scale.scale === "log" && low > 0;
  const place = log
    ? Math.log(Math.max(value, low) / low) / Math.log(high / low)
    : (value - low) / (high - low);
  return Math.min(1, Math.max(0, Number.isFinite(place) ? place : 0));
}

/** A number as people type it. @param {string} text @returns {number} NaN if it is none */
export function readNumber(text) {
  return noNumber(text) || text.trim() === "" ? NaN : Number(plain(text));
}

/** What is wrong with what was typed where a number is wanted; "" for nothing, and for an emptied field.
 * @param {string} text @param {string} [unit] in words, "" for none */
export function noNumber(text, unit = "") {
  const typed = text.trim();
  if (THOUSANDS.test(typed)) {
    return `${typed}: a comma is a decimal point here; write ${typed.replaceAll(",", "")}`;
  }
  const [, number, more = ""] = BEGINS.exec(plain(text)) ?? [];
  if (typed === "" || (number && more === "" && Number.isFinite(Number(number)))) return "";
  if (INFINITE.test(plain(text)) || (number && more === "")) {
    return `${typed}: must be a finite number`;
  }
  if (!number) return `${typed}: is no number`;
  if (more === "%") return `${typed}: write ${Number((Number(number) / 100).toPrecision(12))}`;
  return `${typed}: write the number alone${unit && `, in ${unit}`}`;
}

/** @param {string} text */
const plain = (text) => text.trim().replace(",", ".").replace("−", "-");
const BEGINS = /^([+-]?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?)\s*(.*)$/i;
const THOUSANDS = /^[-+−]?[1-9]\d{0,2}(,\d{3})+(\.\d*)?$/;
const INFINITE = /^[+-]?(nan|inf|infinity|∞)$/i;

/** A number as it stands in a field: six figures, no noise, and with a power of ten where that is needed to fit.
 * @param {number} value @param {number} [most] letters */
export function fieldText(value, most = 11) {
  const plain = String(Number(value.toPrecision(6)));
  if (plain.length <= most) return plain;
  return Number(value.toPrecision(most - 5)).toExponential();
}
