// Why a simulation broke, as one would tell somebody who does not know the theory.

import { figures } from "./range.js";

/** @typedef {import("../source/protocol.js").Cause} Cause */

/** @param {Cause | null} cause null: not found out yet */
export function whyItBroke(cause) {
  if (!cause) return "The rope has flown apart. Why is being looked at.";
  if (cause.bound === null) {
    return "The rope was moved farther in one step than the computation can follow. Try a shorter step.";
  }
  if (cause.stable) {
    return (
      "The step is short enough for a rope at its length, so something pulled or threw a piece of it too far: " +
      "a hand, a fast anchor, a heavy load. Be gentler, or take a shorter step."
    );
  }
  if (cause.rubs) {
    return (
      "Each step was too long for so much friction: it is to slow a piece of the rope down, but in one step it threw " +
      "the piece back faster than it came, in the next step faster still, and so on. A real rope would not do this; " +
      "the computation did. A shorter step, less friction or more mass keep it together."
    );
  }
  if (cause.spring_factor === 0) {
    return (
      "Each step was too long for what damps the rope, or for what it touches: it is to slow a piece of the rope " +
      "down or to push it back, but in one step it threw the piece back faster than it came, and so on. A real " +
      "rope would not do this; the computation did. Softer springs do not help: a shorter step, less damping, " +
      "softer contacts or more mass keep it together."
    );
  }
  return (
    "Each step was too long for so stiff and light a rope: within one step a piece of it flew past where its " +
    "neighbours pull it back to, then farther past on the other side, and so on. A real rope would not do this; " +
    "the computation did. A shorter step, softer springs or more mass keep it together."
  );
}

/** The same in a few words, where there is no room for more. @param {Cause | null} cause */
export function whyInShort(cause) {
  if (!cause) return "Why is being looked at.";
  if (cause.bound === null) return "It was moved too far in one step.";
  if (cause.stable) return "Something pulled or threw a piece of it too far.";
  if (cause.rubs) return "Each step was too long for so much friction.";
  if (cause.spring_factor === 0) return "Each step was too long for damping and contacts.";
  return "Each step was too long for so stiff and light a rope.";
}

/** The theory's sum, for those who know it. @param {Cause | null} cause */
export function theoryOf(cause) {
  if (!cause || cause.meter === null || cause.meter_limit === null) return "";
  const { meter, meter_limit, meter_name } = cause;
  return `The meter: ${meter_name} = ${figures(meter)}, at most ${figures(meter_limit)}.`;
}
