"""What is to be said of modes of ropes that relax: they are those of the rope at rest, without its loss.

A mass on a solid of stiffness E that lasts and E r that relaxes in the time tau rings at w, w^2 between w_0^2
of E alone, where that is slow, and (1 + r) w_0^2, where it is far faster than 1 / tau. Its damping ratio is
largest between them, (sqrt(1 + r) - 1) / 2 at w^2 = w_0^2 sqrt(1 + r): that of the cubic
tau s^3 + s^2 + (1 + r) tau w_0^2 s + w_0^2 = 0.
Source: Findley, Lai & Onaran, Creep and Relaxation of Nonlinear Viscoelastic Materials, ch. 5, for the solid.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from ropewalk.theory.curve import at_strain

if TYPE_CHECKING:
    from ropewalk.scene import Rope
    from ropewalk.vibration.modes import Modes


def relaxing_notes(modes: Modes) -> list[str]:
    """Return a sentence for every rope that relaxes."""
    return [_note(modes, rope) for rope in modes.scene.ropes if rope.relaxes]


def _note(modes: Modes, rope: Rope) -> str:
    made_of = rope.made_of
    ratio = made_of.relaxing_EA / _slope(modes, rope)  # type: ignore[union-attr, operator]
    rate = 1.0 / (2.0 * math.pi * made_of.relaxation_time)  # type: ignore[union-attr, operator]
    stiffer = math.sqrt(1.0 + ratio)
    damped = min(0.5 * (stiffer - 1.0), 1.0)
    return (
        f"rope {rope.name!r} relaxes: these modes have its stiffness at rest and leave out that loss. What "
        f"stretches it far faster than at {rate:.3g} Hz rings up to {stiffer:.3g} times as fast, and near "
        f"that it dies down, with a damping ratio of up to {damped:.2g}; a run shows it"
    )


def _slope(modes: Modes, rope: Rope) -> float:
    """Return the least slope of a rope's tension at rest [N]."""
    made_of = rope.made_of
    if not rope.curved:
        return made_of.EA  # type: ignore[union-attr]
    span = modes.layout.span(rope.name)
    nodes = modes.positions[span.start : span.end + 1]
    strain = np.linalg.norm(np.diff(nodes, axis=0), axis=1) / rope.segment_length - 1.0
    slope = at_strain(made_of.curve.pieces, np.maximum(strain, 0.0))[1]  # type: ignore[union-attr]
    return float(slope.min())
