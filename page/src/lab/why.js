// Why a rope broke, in words for somebody who has not heard of it.

import { largestStep } from "./bounds.js";
import { longest } from "./verdict.js";

/** @typedef {import("./kernel.js").Rope} Rope */
/** @typedef {import("./kernel.js").Method} Method */

/** @param {number} energy that the rope has made up [J] */
const made = (energy) => {
  const more = Number.isFinite(energy) ? `${Number(energy.toPrecision(3))} J` : "far";
  return ` the rope has ${more} more energy than it began with, and nothing gave it so much`;
};

/** @param {number} seconds */
const milliseconds = (seconds) => `${Number((1e3 * seconds).toPrecision(4))} ms`;

/** The largest step in words: no larger than it is, as it is to hold. @param {number} seconds */
export function atMost(seconds) {
  const [exact, near] = [1e3 * seconds, Number((1e3 * seconds).toPrecision(4))];
  const last = 10 ** (Math.floor(Math.log10(exact)) - 3);
  return `${near > exact * (1 + 1e-12) ? Number((near - last).toPrecision(4)) : near} ms`;
}

const SPRINGS =
  "In one step the springs push a node past where it should be, in the next they push it back farther still: " +
  "the zigzag grows until nothing is left.";
const FRICTION =
  "Friction is to slow the nodes down. In so long a step it throws them back faster than they came, in the next " +
  "step faster still: the zigzag grows until nothing is left. With less friction this step would hold.";

/** @typedef {import("./verdict.js").Verdict} Verdict */

/** @param {Rope} rope @param {Method} method @param {number} step @param {number} bound the longest that holds [s]
 * @param {Verdict} verdict @param {import("./verdict.js").Break} broke */
export function whyItBroke(rope, method, step, bound, verdict, broke) {
  const when = `After ${rope.time.toPrecision(3)} s${broke === "energy" ? made(verdict.gain(rope)) : ""}. `;
  if (step <= bound && broke === "through")
    return `${when}The step is short enough: something pulled the rope so hard that it goes through a post.`;
  if (step <= bound)
    return broke === "energy"
      ? `${when}For a small swing the step is short enough, for so wild a one it is not.`
      : `${when}The step is short enough: something pulled the rope beyond ` +
          `${Number(longest(rope).toPrecision(3))} times its length.`;
  const rubs = step <= largestStep(rope, method, false); // the springs alone would hold
  return (
    `${when}With this stiffness, friction and mass a step may be at most ${atMost(bound)}; it is ` +
    `${milliseconds(step)}. ${rubs ? FRICTION : SPRINGS}`
  );
}
