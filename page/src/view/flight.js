// A short flight of the camera from one pose to another.

import { minus, plus } from "./vector.js";

/** @typedef {import("./camera.js").Pose} Pose */

const DURATION = 320; // ms

export class Flight {
  /** @param {Pose} from @param {Pose} to @param {number} now ms @param {number} [duration] ms */
  constructor(from, to, now, duration = DURATION) {
    this.duration = duration;
    const turn = to.azimuth - from.azimuth;
    this.from = from;
    this.to = to;
    this.turn = turn - 2 * Math.PI * Math.round(turn / (2 * Math.PI)); // the short way round
    this.start = now;
  }

  /** The pose at a time, and whether the flight is over.
   * @param {number} now ms @returns {{pose: Pose, over: boolean}} */
  at(now) {
    const part = Math.min(1, Math.max(0, (now - this.start) / this.duration));
    const s = part * part * (3 - 2 * part);
    const { from, to } = this;
    return {
      over: part >= 1,
      pose: {
        target: plus(from.target, minus(to.target, from.target), s),
        distance: from.distance * (to.distance / from.distance) ** s,
        azimuth: from.azimuth + s * this.turn,
        elevation: from.elevation + s * (to.elevation - from.elevation),
      },
    };
  }
}
