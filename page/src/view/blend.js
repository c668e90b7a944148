// Smooth motion between frames: what is shown runs one frame behind what has arrived.

export class Blend {
  /** @param {number} size how many numbers a frame has */
  constructor(size) {
    /** What is shown now. */
    this.shown = new Float32Array(size);
    this.from = new Float32Array(size);
    this.to = new Float32Array(size);
    this.arrival = 0; // ms
    this.spacing = 1000 / 60; // ms between frames, a running mean
    this.part = 1;
    this.empty = true;
  }

  /** Take a new frame in: the caller writes it into the array that this returns.
   * @param {number} now ms @param {boolean} jump show it at once @returns {Float32Array} */
  next(now, jump = false) {
    const gap = now - this.arrival;
    this.arrival = now;
    if (this.empty || jump) {
      this.empty = false;
      this.part = 1 - 1e-9; // shown at the next step, whatever the time
      this.arrival = -Infinity;
      return this.to;
    }
    if (gap < 250) this.spacing += 0.15 * (Math.max(4, gap) - this.spacing);
    this.from.set(this.shown); // what is seen goes on without a jump
    this.part = 0;
    return this.to;
  }

  /** Move on to a time; tells whether what is shown changed. @param {number} now ms */
  advance(now) {
    if (this.empty || this.part >= 1) return false;
    this.part = Math.min(1, Math.max(this.part, (now - this.arrival) / this.spacing));
    const { shown, from, to, part } = this;
    if (part >= 1) shown.set(to);
    else for (let i = 0; i < shown.length; i++) shown[i] = from[i] + part * (to[i] - from[i]);
    return true;
  }
}
