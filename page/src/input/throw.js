// How fast a hand is when it lets go, and how fast time goes for it.

import { minus, times } from "../view/vector.js";

/** @typedef {import("../view/vector.js").Vector} Vector */
/** Places of a hand, oldest first, with their times [ms]. @typedef {{time: number, place: Vector}[]} Trace */

const SLOWEST = 1e-4; // as the server's hands

/** The velocity of a hand over the last milliseconds [m/s], in the user's time; none where it has rested.
 * @param {Trace} trace @param {number} now ms @param {number} recent ms @returns {Vector} */
export function throwOf(trace, now, recent) {
  const late = trace.filter(({ time }) => now - time <= recent);
  if (late.length < 2) return [0, 0, 0];
  const [first, last] = [late[0], late[late.length - 1]];
  const seconds = (now - first.time) / 1000; // a rest before the release counts
  return seconds > 0 ? times(minus(last.place, first.place), 1 / seconds) : [0, 0, 0];
}

/** Simulated seconds in one of the user's. @param {{realtime: number} | null} frame
 * @param {{playing: boolean, slow: boolean, speed: number} | null} status */
export function paceOf(frame, status) {
  if (!status?.playing) return 1;
  const reached = frame && status.slow && frame.realtime > 0 ? frame.realtime : status.speed;
  return Math.max(SLOWEST, Math.min(reached, status.speed));
}
