"""Likely slips of units in a line: lengths, sags and pulls that few lines have, and what may be meant."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from ropewalk.rigging.words import force
from ropewalk.scene.straight_words import straight_words

if TYPE_CHECKING:
    from ropewalk.rigging.lines import Line

_TAUTEST = 1e-3  # sag over span [1]; a sag of 0.02 m over 300 m is more likely one of 2 %
_LONGEST = 1e4  # [m]; the longest spans of power lines have half of it
_THICKEST = 50.0  # span over diameter [1]
_MOST_STRAIN = 0.4  # [1]; climbing ropes take 35 %
_HEAVIEST = 5000.0  # [1] of the line's own mass, at least of 1 kg
_RUBBER = 200.0  # [m/s] of sound, below which a rope is of rubber and takes more


def line_slips(line: Line) -> list[str]:
    """Return one sentence for every number of a line that looks like a slip of units."""
    found = []
    way, size = line.set_up
    if way == "sag" and size < _TAUTEST * line.span:
        found.append(
            f"a sag of {size:.4g} m is {100.0 * size / line.span:.3g} % of the span; "
            f'a share of it is written as "{100.0 * size:.4g} %"'
        )
    if line.span > _LONGEST:
        found.append(f"a span of {line.span:.6g} m is longer than any; millimetres for metres?")
    if line.diameter and line.span < _THICKEST * line.diameter:
        found.append(
            f"the span is {line.span / line.diameter:.3g} times the rope's diameter of "
            f"{1e3 * line.diameter:.4g} mm; millimetres for metres, or metres for millimetres?"
        )
    return found + strain_slip(line, max(line.tensions))


def load_slip(line: Line, mass: float) -> list[str]:
    """Return a sentence for a load [kg] that is heavier than any that a line carries."""
    own = line.length * line.material.mass_per_length
    if mass <= _HEAVIEST * max(own, 1.0):
        return []
    return [
        f"a load of {mass:.4g} kg is {mass / own:.3g} times the line's own mass; grams for kilograms?"
    ]


def strain_slip(line: Line, tension: float) -> list[str]:
    """Return a sentence where a tension [N] stretches the rope by more than lines are stretched."""
    strain = tension / line.material.EA
    if bent := straight_words(line.material, strain):
        return [f"{force(tension)} stretches this rope by {100.0 * strain:.3g} %, {bent}"]
    sound = math.sqrt(line.material.EA / line.material.mass_per_length)
    if strain <= _MOST_STRAIN or sound < _RUBBER:
        return []
    return [
        f"{force(tension)} stretches this rope, of EA {force(line.material.EA)}, by {100.0 * strain:.3g} %; "
        "kN for N, or grams for kilograms?"
    ]
