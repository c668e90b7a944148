"""What is to be said of modes that turn a bend about the rope: bending damping takes nothing from these.

The moment of bending damping goes by the rate at which a bend grows or shrinks (`laws.bending`), as what it
turns along is not known without twist. A rod that is straight grows bends wherever it moves; one that sags,
moved out of the plane of that, turns the bend that it has, to first order. In a real rod whose ends cannot
turn, the material in the bend changes all the same, and damps that as it does the motion in the plane.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from ropewalk.scene import Material

if TYPE_CHECKING:
    from ropewalk.scene import Rope
    from ropewalk.vibration.modes import Modes

_LESS = 0.1  # [1] of what bending damping gives a rod that is straight


def turning_notes(modes: Modes) -> list[str]:
    """Return a sentence for every rope that a mode moves sideways hardly damped, though bending is damped."""
    return [note for rope in modes.scene.ropes if (note := _note(modes, rope))]


def _note(modes: Modes, rope: Rope) -> str:
    made_of = rope.made_of
    if not isinstance(made_of, Material) or not made_of.EI * made_of.bending_damping > 0.0:
        return ""
    retardation = made_of.bending_damping / made_of.EI
    pull = _pull(modes, rope, made_of)
    for number, motion in enumerate(modes.motions):
        if motion.rope != rope.name or motion.name != "out of plane":
            continue
        waves = math.pi * motion.half_waves / rope.length_unstretched
        straight = math.pi * float(modes.frequencies[number]) * retardation  # of bending alone
        ratio = float(modes.damping_ratios[number])
        if made_of.EI * waves**2 > pull and 0.0 <= ratio < _LESS * straight:
            return (
                f"rope {rope.name!r} is curved, and its bending damping takes nothing from what turns a bend "
                f"without changing how sharp it is: mode {number + 1}, out of plane, has a damping ratio of "
                f"{ratio:.2g}, straight it would have up to {min(straight, 1.0):.2g}. A real rod whose ends "
                "cannot turn dies down alike both ways"
            )
    return ""


def _pull(modes: Modes, rope: Rope, made_of: Material) -> float:
    """Return the largest tension of a rope in the shape of its modes [N]; 0 where it does not stretch."""
    if not math.isfinite(made_of.EA):
        return 0.0
    span = modes.layout.span(rope.name)
    nodes = modes.positions[span.start : span.end + 1]
    strain = np.linalg.norm(np.diff(nodes, axis=0), axis=1) / rope.segment_length - 1.0
    return max(float(made_of.EA * strain.max()), 0.0)
