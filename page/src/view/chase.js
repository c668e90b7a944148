// The camera's own calm movement: critically damped towards a goal that may move on, so it starts and ends softly.

import { minus, plus, times } from "./vector.js";

/** @typedef {import("./camera.js").Pose} Pose */
/** @typedef {import("./vector.js").Vector} Vector */

const RATE = 3.5; // 1/s: nine tenths of the way after 1.1 s
const NEAR = 0.02; // of the goal's distance, within which it has been reached
const STILL = 0.05; // and of that distance in a second

export class Chase {
  /** @param {Pose} from @param {Pose} to @param {number} now ms */
  constructor(from, to, now) {
    this.pose = from;
    this.to = to;
    this.time = now;
    /** @type {Vector} of the target [m/s] */ this.speed = [0, 0, 0];
    this.zoom = 0; // rate of the logarithm of the distance [1/s]
  }

  /** The pose at a time, and whether the goal is reached; the step is exact, so the rate of frames does not matter.
   * @param {number} now ms @returns {{pose: Pose, over: boolean}} */
  at(now) {
    const seconds = Math.min(0.5, Math.max(0, (now - this.time) / 1000));
    this.time = now;
    const { pose, to } = this;
    const decay = Math.exp(-RATE * seconds);
    const off = minus(pose.target, to.target);
    const lean = plus(this.speed, off, RATE);
    this.speed = times(plus(this.speed, lean, -RATE * seconds), decay);
    const target = plus(to.target, plus(off, lean, seconds), decay);
    const far = Math.log(pose.distance / to.distance);
    const leanFar = this.zoom + RATE * far;
    this.zoom = (this.zoom - RATE * leanFar * seconds) * decay;
    const distance = to.distance * Math.exp((far + leanFar * seconds) * decay);
    this.pose = { ...to, target, distance };
    return { pose: this.pose, over: this.there };
  }

  /** Move on with what the camera goes along with. @param {Vector} by [m] */
  carry(by) {
    this.pose = { ...this.pose, target: plus(this.pose.target, by) };
    this.to = { ...this.to, target: plus(this.to.target, by) };
  }

  get there() {
    const { pose, to } = this;
    const off = Math.hypot(...minus(pose.target, to.target)) / to.distance;
    const fast = Math.hypot(...this.speed) / to.distance;
    const far = Math.abs(Math.log(pose.distance / to.distance));
    return Math.max(off, far) < NEAR && Math.max(fast, Math.abs(this.zoom)) < STILL;
  }
}
