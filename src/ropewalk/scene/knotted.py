"""What the knot that a rope is tied in takes of its breaking load, which is told of a rope without one."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from ropewalk.scene.guess import guesses_of, worst_of
from ropewalk.scene.knot_shape import Knot
from ropewalk.words.safe_side import percent_up, safety_factor

if TYPE_CHECKING:
    from ropewalk.scene.rope import Rope

#: [1] of a rope's strength, an overhand or reef knot and a clove hitch, by tests of 1946: Jacobson, Knots for
#: the Outdoors. EN 1891 asks 15 kN with figure-eight knots of a rope of 22 kN.
LEFT = (0.45, 0.75)
_NO_KNOT = "bollard"  # its turns lie beside each other


def is_tied(rope: Rope) -> bool:
    """Tell whether a rope is tied in a knot that takes of its strength."""
    return isinstance(rope.shape, Knot) and rope.shape.knot != _NO_KNOT


def knotted_worst(rope: Rope, utilisation: float) -> float:
    """Return the utilisation [1] with the least that a knot leaves; as it is where there is none."""
    return utilisation / LEFT[0] if is_tied(rope) else utilisation


def least_worst(rope: Rope, utilisation: float) -> float:
    """Return the utilisation [1] with the least that a knot leaves of a guessed breaking load's least."""
    return knotted_worst(rope, worst_of(rope.made_of, utilisation))


def both_doubt(rope: Rope, utilisation: float) -> str:
    """Return what a knot and a guess make of a utilisation [1] together; "" unless a rope has both."""
    guessed = "breaking_load" in guesses_of(rope.made_of)
    if not (guessed and is_tied(rope)) or math.isnan(utilisation):
        return ""
    share = least_worst(rope, utilisation)
    text = f"with the least of guess and knot together {percent_up(100.0 * share, 3)}"
    return text + (f", safety factor {safety_factor(share)}" if share > 0.0 else "")


def knot_doubt(rope: Rope, utilisation: float) -> str:
    """Return what a knot makes of a utilisation [1], on the safe side; "" of a rope that is tied in none."""
    if not is_tied(rope) or math.isnan(utilisation):
        return ""
    share = knotted_worst(rope, utilisation)
    text = (
        f"without the knot, which leaves a rope some {100 * LEFT[0]:.0f} to {100 * LEFT[1]:.0f} % of its "
        f"strength: with the least of it {percent_up(100.0 * share, 3)}"
    )
    return text + (f", safety factor {safety_factor(share)}" if share > 0.0 else "")
