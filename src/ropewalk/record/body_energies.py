"""The energies of bodies that turn freely by their weight, too, and the method's error in them."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from ropewalk.core.arrays import Floats
from ropewalk.laws.wheel_rows import RECORDED
from ropewalk.record.quantities import PULLEYS
from ropewalk.scene.obstacles import has_mass

if TYPE_CHECKING:
    from ropewalk.record.result import Result
    from ropewalk.scene import Scene

_KINETIC, _ROPES, _BEARING, _WEIGHT = (
    RECORDED.index(name)
    for name in ("kinetic energy", "work of ropes", "work of bearing", "work of weight")
)


class Turning(NamedTuple):
    """What bodies have together [J], (frames,) each; that of weight is 0 in the beginning."""

    kinetic: Floats
    weight: Floats
    error: Floats  # what no law accounts for


def turning_of(result: Result) -> Turning | None:
    """Return the energies of what turns freely; None where no weight turns anything or it was not kept."""
    if not weight_turns(result.scene) or PULLEYS not in result.source.names:
        return None
    each = result.read(PULLEYS)
    kinetic, weight = (each[..., one].sum(axis=1) for one in (_KINETIC, _WEIGHT))
    error = unaccounted(each)
    return Turning(kinetic, -weight, error - error[0])


def weight_turns(scene: Scene) -> bool:
    """Tell whether its weight turns a body. Where none does works are booked as all that changes energies."""
    return any(has_mass(body) for body in scene.obstacles)


def unaccounted(wheels: Floats) -> Floats:
    """Return, up to a constant, what no law accounts for in bodies' energies [J], (...), of (..., w, 7)."""
    each = wheels.sum(axis=-2)
    error: Floats = (
        each[..., _KINETIC] - each[..., _ROPES] - each[..., _BEARING] - each[..., _WEIGHT]
    )
    return error
