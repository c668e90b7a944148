"""What a mode is: which rope moves, along itself or sideways, in the plane of its sag or out of it.

Or which body turns.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ropewalk.core.arrays import Floats
from ropewalk.lowering import Model, Span
from ropewalk.vibration.plane import Plane
from ropewalk.words.annotations import unquoted

Complex = NDArray[np.complex128]
TURNS = "turns"
_MOST = 0.5  # of the kinetic energy in the turning of bodies: the mode is theirs [1]
_SEEN = 0.05  # of the largest displacement: what counts as a motion of its own [1]


@unquoted
class Motion(NamedTuple):
    """One mode in words; the shares are of its kinetic energy and add up to 1."""

    # "along", "in plane", "out of plane", of what is upright or not plane "sideways", of a body "turns"
    name: str
    rope: str  # the rope that moves most, or the body that turns
    half_waves: int  # of the leading part of the motion
    along: float
    in_plane: float
    out_of_plane: float
    turning: float = 0.0  # of bodies that turn freely


def motions(model: Model, x: Floats, shapes: Complex, plane: Plane) -> tuple[Motion, ...]:
    """Describe all modes; `shapes` (m, n, 3)."""
    tangent = _tangents(model, x)
    across = np.cross(plane.normal, tangent)
    found = []
    for shape in shapes:
        parts = np.stack(
            [(shape * tangent).sum(axis=1), (shape * across).sum(axis=1), shape @ plane.normal]
        )
        energy = model.state.mass * np.abs(parts) ** 2  # (3, n)
        total = float(energy.sum()) or 1.0
        rope = max(
            model.layout.ropes, key=lambda span: float(energy[:, span.first : span.last + 1].sum())
        )
        own = energy[:, rope.first : rope.last + 1].sum(axis=1)
        lead = int(np.argmax(own))
        name = ("along", "in plane", "out of plane")[lead]
        if lead > 0 and (plane.upright[model.layout.ropes.index(rope)] or not plane.flat):
            name = "sideways"
        shares = energy.sum(axis=1) / total
        waves = _half_waves(parts[lead], rope)
        found.append(Motion(name, rope.name, waves, *(float(share) for share in shares)))
    return tuple(found)


def turnings(
    found: tuple[Motion, ...], energy: Floats, ropes: Floats, names: tuple[str, ...]
) -> tuple[Motion, ...]:
    """Return the same with the turning of bodies, whose motion a mode is that has most of its energy there.

    Args:
        found: of ropes alone.
        energy: of every body's turning, (m, b), in any unit.
        ropes: of the ropes, (m,), in the same unit.
        names: of the bodies.
    """
    told = []
    for motion, own, rest in zip(found, energy, ropes, strict=True):
        share = float(own.sum()) / (float(own.sum() + rest) or 1.0)
        left = 1.0 - share
        parts = (left * motion.along, left * motion.in_plane, left * motion.out_of_plane, share)
        what = motion.name, motion.rope, motion.half_waves
        if share > _MOST:
            what = TURNS, names[int(np.argmax(own))], 0
        told.append(Motion(*what, *parts))
    return tuple(told)


def _tangents(model: Model, x: Floats) -> Floats:
    """Return the rope's direction at every node, (n, 3), the mean of both sides."""
    tangent = np.zeros((x.shape[1], 3))
    for span in model.layout.ropes:
        points = x[:, span.start : span.end + 1].T
        steps = np.diff(points, axis=0)
        steps = steps / np.maximum(np.linalg.norm(steps, axis=1), 1e-300)[:, None]
        sums = np.zeros_like(points)
        sums[:-1] += steps
        sums[1:] += steps
        folds = np.flatnonzero(np.linalg.norm(sums, axis=1) < 1e-9)
        sums[folds] = steps[
            np.minimum(folds, len(steps) - 1)
        ]  # at a fold that of the segment after it
        size = np.linalg.norm(sums, axis=1)
        tangent[span.start : span.end + 1] = sums / np.maximum(size, 1e-300)[:, None]
    return tangent


def _half_waves(part: Complex, rope: Span) -> int:
    """Count the stretches in which the motion has one sign."""
    own = part[rope.start : rope.end + 1]
    lead = own[int(np.argmax(np.abs(own)))]
    if lead == 0.0:
        return 0
    values = (own * np.conj(lead)).real
    values = values[np.abs(values) > _SEEN * float(np.abs(values).max())]
    return 1 + int((np.sign(values[1:]) != np.sign(values[:-1])).sum())
