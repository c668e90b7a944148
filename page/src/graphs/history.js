// The last seconds as columns of numbers for the graphs: contiguous, in constant memory.

/** @typedef {import("../source/protocol.js").Layout} Layout */
/** @typedef {import("../source/frame.js").Frame} Frame */

const KEPT = 7200; // samples, two minutes at 60 frames per second

export class History {
  constructor() {
    this.count = 0; // of samples, which lie in `start` to `start + count`
    this.start = 0;
    this.time = new Float64Array(2 * KEPT);
    this.apart = new Uint8Array(2 * KEPT); // whether samples are missing before one
    /** @type {Map<string, Float64Array>} */
    this.columns = new Map();
    /** @type {string[]} */ this.of = []; // what numbers in names stand for
  }

  clear() {
    this.count = this.start = 0;
    this.columns.clear();
  }

  /** Forget what columns have of something that their names stand for no more.
   * @param {[RegExp, string][]} now what is like that, and what it is of */
  tell(now) {
    for (const [k, [names, of]] of now.entries()) {
      if (of === this.of[k]) continue;
      this.of[k] = of;
      for (const name of this.columns.keys()) if (names.test(name)) this.columns.delete(name);
    }
  }

  /** Add a sample; names that were not there before are NaN in the past.
   * @param {number} time [s] @param {Iterable<[string, number]>} values
   * @param {number} [most] from the sample before, where none is missing [s] */
  add(time, values, most = Infinity) {
    if (this.count > 0 && time <= this.last) {
      if (time === this.last) return; // a paused run
      this.count = this.search(time); // gone back: what was before then still holds
    }
    if (this.start + this.count === 2 * KEPT) {
      for (const column of [this.time, this.apart, ...this.columns.values()])
        column.copyWithin(0, this.start + 1);
      this.start = 0;
      this.count = KEPT - 1;
    }
    const at = this.start + this.count;
    this.apart[at] = time - this.last > most ? 1 : 0;
    this.time[at] = time;
    for (const column of this.columns.values()) column[at] = NaN;
    for (const [name, value] of values) {
      let column = this.columns.get(name);
      if (!column) {
        column = new Float64Array(2 * KEPT).fill(NaN);
        this.columns.set(name, column);
      }
      column[at] = value;
    }
    this.count++;
    if (this.count > KEPT) {
      this.count = KEPT;
      this.start++;
    }
  }

  /** The newest time [s], or NaN. */
  get last() {
    return this.count ? this.time[this.start + this.count - 1] : NaN;
  }

  /** The oldest time [s], or NaN. */
  get first() {
    return this.count ? this.time[this.start] : NaN;
  }

  /** Times and columns between two times, without a copy.
   * @param {number} from @param {number} to [s] @param {string[]} names @returns {Float64Array[]} */
  between(from, to, names) {
    const [a, b] = this.ends(from, to);
    const empty = new Float64Array(b - a).fill(NaN);
    return [
      this.time.subarray(a, b),
      ...names.map((name) => this.columns.get(name)?.subarray(a, b) ?? empty),
    ];
  }

  /** Whether samples are missing before each between two times. @param {number} from @param {number} to [s] */
  apartBetween(from, to) {
    return this.apart.subarray(...this.ends(from, to));
  }

  /** The first sample to be seen between two times, and the one after the last. @param {number} from
   * @param {number} to [s] @returns {[number, number]} */
  ends(from, to) {
    const low = Math.max(0, this.search(from) - 1);
    const high = Math.min(this.count, this.search(to) + 1);
    return [this.start + low, this.start + high];
  }

  /** How many samples are before a time. @param {number} time */
  search(time) {
    let [low, high] = [0, this.count];
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.time[this.start + middle] < time) low = middle + 1;
      else high = middle;
    }
    return low;
  }
}
