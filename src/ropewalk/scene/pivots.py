"""What about the pivot, the axis and the mass of a body that turns cannot be."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from ropewalk.scene.faults import Fault
from ropewalk.words.safe_side import rounded_up

if TYPE_CHECKING:
    from ropewalk.scene.spin import Spin

_ALONG = 1e-9  # [1] sine of the angle between axes that are one
_OWN = ("sphere", "box", "mesh", "sdf")  # whose own `axis` is that of their spin


def pivot_faults(body: Any, spin: Spin) -> list[Fault]:
    """Return what is wrong with where a body turns, and with its mass."""
    faults = []
    given = {name for name in ("pivot", "axis", "mass") if getattr(spin, name) is not None}
    if given and body.kind in ("plane", "half-pipe"):
        rule = (
            "is for bodies that have an end: this one turns about its own axis only; leave it out"
        )
        return [Fault(f"spin.{min(given)}", getattr(spin, min(given)), rule)]
    if spin.axis is not None:
        if body.kind in _OWN:
            rule = "is for bodies with an axis of their own shape: give this one's own axis"
            return [Fault("spin.axis", spin.axis, rule)]
        tilted = math.hypot(*_cross(_unit(spin.axis), _unit(own_axis(body)))) > _ALONG
        if body.kind == "cylinder" and body.endless and tilted:
            rule = "must lie along an endless cylinder: its ends would go at any speed"
            faults.append(Fault("spin.axis", spin.axis, rule))
    if spin.mass is None:
        return faults
    if body.motion.kind != "fixed":
        rule = "turns a body by its weight, not by what moves its pivot: leave out the mass, or its motion"
        faults.append(Fault("spin.mass", spin.mass, rule))
    square = spin.mass * _off(body, spin) ** 2
    if spin.inertia is not None and spin.inertia < square * (1.0 - 1e-9):
        rule = (
            "must be at least mass times the square of its centre's distance from the axis "
            f"({rounded_up(square, 4)} kg m^2): it is about the axis, not about the centre of mass"
        )
        faults.append(Fault("spin.inertia", spin.inertia, rule))
    return faults


def middle_of(body: Any) -> tuple[float, ...]:
    """Return the middle of a body, of a mesh its position [m]."""
    if body.kind in ("cylinder", "capsule"):
        return tuple(0.5 * (a + b) for a, b in zip(body.start, body.end, strict=True))
    return tuple(body.position if body.kind in ("mesh", "sdf") else body.center)


def own_axis(body: Any) -> Sequence[float]:
    """Return the axis about which a body turns by itself, of any length."""
    if body.kind in ("cylinder", "capsule"):
        return [b - a for a, b in zip(body.start, body.end, strict=True)]
    found: Sequence[float] = body.axis
    return found


def _off(body: Any, spin: Spin) -> float:
    """Return how far the centre of mass is from the axis [m]."""
    where, pivot = spin.center_of_mass or middle_of(body), spin.pivot or middle_of(body)
    arm = [a - b for a, b in zip(where, pivot, strict=True)]
    return math.hypot(*_cross(_unit(spin.axis or own_axis(body)), arm))


def _unit(axis: Sequence[float]) -> list[float]:
    size = math.hypot(*axis)
    return [part / size for part in axis] if size > 0.0 else [0.0, 0.0, 0.0]


def _cross(a: Sequence[float], b: Sequence[float]) -> tuple[float, float, float]:
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]
