"""The energies of bodies that turn freely by their weight, too, and the method's error in them."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from ropewalk.core.arrays import Floats
from ropewalk.laws.wheel_rows import RECORDED
from ropewalk.record.quantities import PULLEYS
from ropewalk.scene.obstacles import is_free

if TYPE_CHECKING:
    from ropewalk.record.result import Result

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
    """Return the energies of what turns freely; None where no weight turns anything or it was not kept.

    Where none does the works are all that changes the energy, by how they are booked.
    """
    free = (body.spin for body in result.scene.obstacles if is_free(body))
    if (
        not any(spin and spin.mass is not None for spin in free)
        or PULLEYS not in result.source.names
    ):
        return None
    each = result.read(PULLEYS).sum(axis=1)
    error = each[:, _KINETIC] - each[:, _ROPES] - each[:, _BEARING] - each[:, _WEIGHT]
    return Turning(each[:, _KINETIC], -each[:, _WEIGHT], error - error[0])
