// From where bodies hide no ends of ropes: a line whose end is behind its post is not seen to go anywhere.

import { hides } from "./solids.js";

/** @typedef {import("./camera.js").Camera} Camera */
/** @typedef {import("./camera.js").Pose} Pose */
/** @typedef {import("./solids.js").Solid} Solid */
/** @typedef {import("./vector.js").Vector} Vector */

const TURNS = [0, 0.5, -0.5, 1, -1, 1.5, -1.5, 2, -2, 2.5, -2.5, Math.PI]; // the nearest first [rad]

/** The azimuth nearest to that of a pose from which bodies hide fewest of these places [rad].
 * @param {Camera} camera @param {Pose} pose @param {Vector[]} places @param {Solid[]} solids */
export function inSight(camera, pose, places, solids) {
  let [best, fewest] = [pose.azimuth, Infinity];
  for (const turn of TURNS) {
    const azimuth = pose.azimuth + turn;
    const { eye } = camera.at({ ...pose, azimuth });
    const hidden = places.filter((place) => solids.some((one) => hides(one, eye, place, 0))).length;
    if (hidden < fewest) [best, fewest] = [azimuth, hidden];
  }
  return best;
}
