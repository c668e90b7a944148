// The force across the string at its anchor, played: what the bridge of a guitar feels.

const LOWEST = 20; // [Hz] slower changes, and the steady pull, are left out
const LOUD = 0.25; // of what the loudspeaker can do, where the force is largest
const AHEAD = 0.06; // [s] between what is computed and what is heard, so that no gap is
const MOST = 0.25; // [s] of sound that waits at most

/** Steps' forces, without their slow part, at the times of a loudspeaker. */
export class Resampler {
  /** @param {number} rate samples a second that come out */
  constructor(rate) {
    this.rate = rate;
    this.force = NaN; // of the last step
    /** @type {number} */ this.quick = 0; // its part above LOWEST
    /** @type {number} */ this.phase = 0; // of a sample's length that has passed since the last sample
  }

  restart() {
    [this.force, this.quick, this.phase] = [NaN, 0, 0];
  }

  /** @param {number} force of this step [N] @param {number} seconds of sound that the step lasts
   * @param {number[]} out samples are appended */
  add(force, seconds, out) {
    if (!Number.isFinite(force)) return;
    const before = this.quick;
    const passes = Math.exp(-2 * Math.PI * LOWEST * seconds);
    if (Number.isFinite(this.force)) this.quick = passes * (before + force - this.force);
    this.force = force;
    const length = seconds * this.rate; // in samples
    let left = 1 - this.phase; // until the next sample
    while (left <= length) {
      out.push(before + (this.quick - before) * (left / length));
      left += 1;
    }
    this.phase = 1 - (left - length);
  }
}

export class Sound {
  constructor() {
    /** @type {AudioContext | null} */ this.context = null;
    this.resampler = new Resampler(1);
    /** @type {number[]} */ this.samples = [];
    this.loudest = 0;
    this.next = 0; // when what comes next is heard, by the context's clock [s]
  }

  get on() {
    return this.context !== null;
  }

  /** To be called by a click: browsers allow no sound before. @param {boolean} on */
  turn(on) {
    if (on && !this.context) {
      this.context = new AudioContext();
      this.resampler = new Resampler(this.context.sampleRate);
      this.next = 0;
    } else if (!on && this.context) {
      this.context.close();
      this.context = null;
    }
  }

  restart() {
    this.resampler.restart();
    this.samples = [];
    this.loudest = 0;
  }

  /** @param {number} force [N] @param {number} seconds of sound that the step lasts */
  hear(force, seconds) {
    this.resampler.add(force, seconds, this.samples);
  }

  /** Play what has been heard since the last call. */
  play() {
    const { context, samples } = this;
    if (!context || samples.length === 0) return;
    this.samples = [];
    for (const one of samples) this.loudest = Math.max(this.loudest, Math.abs(one));
    const start = Math.max(this.next, context.currentTime + AHEAD);
    if (start > context.currentTime + MOST) return; // a tab that was asleep
    const buffer = context.createBuffer(1, samples.length, context.sampleRate);
    const factor = this.loudest > 0 ? LOUD / this.loudest : 0;
    buffer.copyToChannel(
      Float32Array.from(samples, (one) => factor * one),
      0,
    );
    const source = context.createBufferSource();
    source.buffer = buffer;
    source.connect(context.destination);
    source.start(start);
    this.next = start + samples.length / context.sampleRate;
  }
}
