// How fast a replay goes: time of the run per time on the clock, measured, waits for frames included.

const WINDOW = 500; // ms over which it is taken
const LEAST = 100; // ms, less tells nothing

export class Pace {
  constructor() {
    /** When [ms], and the run's time then [s]; oldest first. @type {[number, number][]} */
    this.marks = [];
  }

  /** Begin to measure anew: after a pause, a jump, another speed. */
  restart() {
    this.marks = [];
  }

  /** @param {number} now [ms] @param {number} time of the run [s] */
  note(now, time) {
    const { marks } = this;
    marks.push([now, time]);
    while (marks.length > 2 && marks[1][0] <= now - WINDOW) marks.shift();
  }

  /** Null: not known yet. @returns {number | null} */
  get reached() {
    const [first, last] = [this.marks[0], this.marks[this.marks.length - 1]];
    if (!first || last[0] - first[0] < LEAST) return null;
    return (1000 * (last[1] - first[1])) / (last[0] - first[0]);
  }
}
