"""How stiff contacts have to be: by a rope's inertia, its segments and what is known to hang on it."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.laws.hardening import SKIN

if TYPE_CHECKING:
    from ropewalk.scene import Rope

FRAME = 1.0 / 60.0  # [s]
SHARP = 2.0  # [1] what a node presses with, over the tension, where the rope turns back
SHARE = 0.15  # [1] compliance of a contact over the rope's own at a node


def node_stiffness(rope: Rope, whole: float, mass: float | None = None) -> tuple[float, float]:
    """Return the stiffness of a contact [N/m] and the mass [kg] of an inner node, or one of `mass`.

    `whole` is the mass of the rope and all that joints tie to it [kg].
    """
    own = rope.own_mass / max(rope.nodes, 1) if mass is None else mass
    inert, whole = own / FRAME**2, whole / FRAME**2
    k = rope.segment_stiffness
    shown = math.sqrt(inert**2 + 4.0 * k * inert) if math.isfinite(k) else whole
    return min(min(shown, whole) / SHARE, most(rope, own)), own


def wished(rope: Rope, weight: float, radius: float) -> float:
    """Return how stiff contacts with a body of `radius` [m] have to be to hold a rope in their skin [N/m].

    `weight` is that of all that hangs on the rope [N], a `radius` of 0 that of a sharp edge. 0: as stiff as
    the rope asks for, on flat bodies.
    """
    if radius == math.inf:
        return 0.0
    pull = weight + sum(math.hypot(*one.force) for one in rope.forces)
    turn = min(rope.segment_length / (radius + 0.5 * rope.diameter), SHARP)
    return pull * turn / (SKIN * rope.diameter)


def lying(rope: Rope, masses: Floats, gravity: float) -> Floats:
    """Return how stiff contacts have to be to hold every node by itself in their skin [N/m], (nodes,).

    Of such `masses` [kg], under `gravity` [m/s^2] and given forces.
    """
    force = gravity * masses
    for one in rope.forces:
        force[rope.node_index(one.node)] += math.hypot(*one.force)
    return np.asarray(force / (SKIN * rope.diameter))


def most(rope: Rope, mass: float) -> float:
    """Return the stiffness of a contact that steps for the rope allow for as well [N/m]."""
    return max(rope.segment_stiffness, mass / FRAME**2)


def loaded(rope: Rope, stiffness: float, mass: float, whole: float) -> tuple[Floats, Floats]:
    """Return stiffness [N/m] and mass [kg] of all nodes, those with loads stiffer, (nodes,) each."""
    masses, found = np.full(rope.nodes, mass), np.full(rope.nodes, stiffness)
    for load in rope.loads:
        masses[rope.node_index(load.node)] += load.mass
    for node in {rope.node_index(load.node) for load in rope.loads}:
        found[node] = node_stiffness(rope, whole, float(masses[node]))[0]
    return found, masses
