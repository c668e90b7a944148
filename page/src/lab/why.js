// Why a rope broke, in words for somebody who has not heard of it.

import { largestStep } from "./bounds.js";

/** @typedef {import("./kernel.js").Rope} Rope */
/** @typedef {import("./kernel.js").Method} Method */

/** @param {number} seconds */
export const milliseconds = (seconds) => `${Number((1e3 * seconds).toPrecision(4))} ms`;

const SPRINGS =
  "In one step the springs push a node past where it should be, in the next they push it back farther still: " +
  "the zigzag grows until nothing is left.";
const FRICTION =
  "Friction is to slow the nodes down. In so long a step it throws them back faster than they came, in the next " +
  "step faster still: the zigzag grows until nothing is left. With less friction this step would hold.";

/** @param {Rope} rope @param {Method} method @param {number} step @param {number} bound the longest that holds [s] */
export function whyItBroke(rope, method, step, bound) {
  const when = `After ${rope.time.toPrecision(3)} s. `;
  if (step <= bound)
    return `${when}The step is short enough: something pulled the rope beyond ten times its length.`;
  const rubs = step <= largestStep(rope, method, false); // the springs alone would hold
  return (
    `${when}With this stiffness, friction and mass a step may be at most ${milliseconds(bound)}; it is ` +
    `${milliseconds(step)}. ${rubs ? FRICTION : SPRINGS}`
  );
}
