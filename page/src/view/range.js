// Ranges of what colours mean, and numbers in words.

const NOTHING = 1e-25; // what stands for nothing where nothing is allowed
const LITTLE = 1e-9; // what rounding leaves of nothing [N], [m/s] ...
const SLOW = 4; // s in which a range shrinks that was filled a while ago ...
const QUICK = 0.5; // s ... and one that nothing has filled
const HOLD = 2; // s for this long: what comes again sooner does not flicker

/** A range for colours that grows at once and shrinks slowly, so that colours do not flicker; soon where nothing
 * comes near its end again, so that a jolt at the start is not shown for half a minute. */
export class Range {
  constructor() {
    this.low = 0;
    this.high = 1;
    this.fresh = true;
    this.unknown = true; // nothing was shown yet
    /** Since the lower and the upper end were reached [s]. */ this.since = [0, 0];
  }

  /** Follow the present extremes. @param {number} low @param {number} high
   * @param {number} seconds since the last call */
  follow(low, high, seconds) {
    if (!Number.isFinite(low) || !Number.isFinite(high)) return;
    const bottom = low < -0.01 * high && low < -LITTLE ? low : 0; // a little push is not worth a number
    const top = Math.max(high, bottom + 1e-9);
    this.unknown = false;
    if (this.fresh) {
      [this.low, this.high, this.fresh] = [bottom, top, false];
      return;
    }
    const [below, above] = this.since;
    this.since = [bottom <= this.low ? 0 : below + seconds, top >= this.high ? 0 : above + seconds];
    const [down, up] = this.since.map(
      (time) => 1 - Math.exp(-seconds / (time > HOLD ? QUICK : SLOW)),
    );
    this.high = top > this.high ? top : this.high + up * (Math.max(top, 1e-9) - this.high);
    this.low = bottom < this.low ? bottom : this.low + down * (bottom - this.low);
  }

  /** Whether there is more than the ends have colours for. @param {number} low @param {number} high
   * @returns {[boolean, boolean]} */
  beyond(low, high) {
    const room = 0.01 * (this.high - this.low); // as much as `follow` leaves out
    return [low < this.low - room, high > this.high + room];
  }
}

const PREFIXES = /** @type {[number, string][]} */ ([
  [1e9, "G"],
  [1e6, "M"],
  [1e3, "k"],
  [1, ""],
  [1e-3, "m"],
  [1e-6, "µ"],
  [1e-9, "n"],
]);
const PREFIXED = new Set(["N", "J", "W", "s", "Hz", "N/m", "m", "m/s", "N s/m"]);

/** A unit as it is written: m/s² for m/s^2, nothing for 1. @param {string} unit */
export const unitText = (unit) =>
  unit === "1" ? "" : unit.replace(/\^2/g, "²").replace(/\^3/g, "³");

/** A number with its unit for people: three figures, with a prefix where that is usual.
 * @param {number | null | undefined} value @param {string} [unit] @returns {string} */
export function quantity(value, unit = "") {
  if (value === null || value === undefined || Number.isNaN(value)) return "–";
  if (!Number.isFinite(value)) return value > 0 ? "∞" : "−∞";
  const space = unit && unit !== "1" ? ` ${unitText(unit)}` : "";
  const size = Math.abs(value);
  if (size < NOTHING) return `0${space}`;
  if (PREFIXED.has(unit) && (size >= 1e4 || size < 0.1) && size >= 1e-9) {
    const small = unit === "m" || unit === "m/s" ? 1 : 1e10; // no kilometres here
    const [scale, prefix] = PREFIXES.find(([s]) => size >= s * 0.9995 && s <= small) ?? PREFIXES[6];
    return `${figures(value / scale)} ${prefix}${unit}`;
  }
  return `${figures(value)}${space}`;
}

/** The numbers of an axis with their unit: one prefix for all, that of the largest unless `plain`, and as many
 * figures as tell each apart. @param {number[]} values in order @param {string} unit @param {boolean} [plain] */
export function marks(values, unit, plain = false) {
  const largest = Math.max(0, ...values.map(Math.abs));
  const [, prefixed] = quantity(largest, unit).split(" ");
  const found = PREFIXES.find(([, prefix]) => prefix && prefix + unit === prefixed);
  const [scale, prefix] = plain || !found ? [1, ""] : found;
  if (!values.length || largest / scale < 1e-3 || largest / scale >= 1e7) {
    return values.map((value) => quantity(value, unit));
  }
  const scaled = values.map((value) => value / scale);
  const gaps = scaled.slice(1).map((value, i) => value - scaled[i]);
  const room = 0.01 * Math.min(largest / scale, ...gaps);
  const right = (/** @type {number} */ digits) =>
    scaled.every((value) => Math.abs(Number(value.toFixed(digits)) - value) <= room);
  let digits = 0;
  while (digits < 12 && !right(digits)) digits += 1;
  const space = unit && unit !== "1" ? ` ${prefix}${unitText(unit)}` : "";
  return scaled.map((v) => `${Number(v.toFixed(digits)) + 0}${space}`.replace("-", "−"));
}

/** @param {number} value @returns {string} */
export function figures(value) {
  const size = Math.abs(value);
  if (size >= 1e5 || size < 1e-3) {
    if (value === 0) return "0";
    const [mantissa, power] = value.toExponential(2).split("e");
    return `${Number(mantissa)}e${Number(power)}`.replaceAll("-", "−");
  }
  const digits = Math.max(0, 2 - Math.floor(Math.log10(size)));
  return String(Number(value.toFixed(Math.min(6, digits)))).replace("-", "−");
}

/** A round number (1, 2 or 5 times a power of ten) near `size`. @param {number} size */
export function round(size) {
  const power = 10 ** Math.floor(Math.log10(size));
  const lead = size / power;
  return power * (lead < 1.5 ? 1 : lead < 3.5 ? 2 : lead < 7.5 ? 5 : 10);
}
