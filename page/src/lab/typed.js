// What is said of a number that was written in a field and cannot be had, beside that field.

/** The sentence about a number that was written, "" where it can be had.
 * @param {string} what the field's name @param {number} typed NaN where it is none @param {number} low
 * @param {number} high @param {number} held what it was before @param {string} unit */
export function saidOf(what, typed, low, high, held, unit) {
  /** @param {number} value */
  const told = (value) => `${Number(value.toPrecision(6))} ${unit}`.trim();
  if (Number.isNaN(typed)) return `${what} needs a number; it stays ${told(held)}.`;
  if ([low, high].some((end) => told(end) === told(typed))) return ""; // what it is shown as
  if (typed < low)
    return `${what}: ${told(typed)} is less than the least here, ${told(low)}, which it is now.`;
  if (typed > high)
    return `${what}: ${told(typed)} is more than the most here, ${told(high)}, which it is now.`;
  return "";
}

/** The line in which it is said; there is one on the page, beside what was written last. */
export class Typed {
  /** @param {HTMLElement} line */
  constructor(line) {
    this.line = line;
  }

  /** @param {HTMLElement} field @param {string} text "" takes the line away */
  say(field, text) {
    this.line.hidden = text === "";
    field.closest(".value, .measure")?.append(this.line);
    this.line.textContent = text; // after it has moved, so that it is read out
  }

  clear() {
    this.line.hidden = true;
  }
}
