"""With what mass a node strikes: rigid links push at once what is behind it.

The damper of a contact takes hold before the surface does, and the farther off the more mass it is made for.
So it is made for what a few links push. Deep in the contact, to where a longer rod comes through, it is made
for all that the rod may push.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from ropewalk.core.arrays import Floats

if TYPE_CHECKING:
    from ropewalk.scene import Rope

BEHIND = 5  # links through which a rigid rope strikes as one from afar
HARD = 0.3  # [1] damping ratio of a contact that is pressed farther than its skin
RODS = 3.0  # [1] the same of rods: they begin there, and a critical damper gives exp(-2) back


def pushes(rope: Rope) -> bool:
    """Tell whether a rope's links push: rigid ones that are no strings."""
    return not (rope.made_of.tension_only or math.isfinite(rope.segment_stiffness))


def striking(rope: Rope, masses: Floats) -> Floats:
    """Return the mass with which every node strikes [kg], (nodes,), of nodes of these `masses`."""
    if not pushes(rope):
        return masses
    return np.convolve(masses, np.ones(2 * BEHIND + 1))[BEHIND : BEHIND + len(masses)]


def firmness(rope: Rope, struck: Floats, whole: float) -> Floats:
    """Return the damping ratio of contacts that are pressed deep, over that of nodes that strike [1], (m,).

    `struck` is the mass with which nodes strike, (m,), `whole` that of the rope and all it is tied to [kg].
    """
    if not pushes(rope):
        return np.full(len(struck), HARD)
    return RODS * np.sqrt(np.maximum(whole / struck, 1.0))
