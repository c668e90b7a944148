"""What a mode is: which rope moves, along itself or sideways, in the plane of its sag or out of it.

Or which body turns.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ropewalk.core.arrays import Floats
from ropewalk.lowering import Model, Span
from ropewalk.words.annotations import unquoted

Complex = NDArray[np.complex128]
TURNS = "turns"
_MOST = 0.5  # of the kinetic energy in the turning of bodies: the mode is theirs [1]
_SEEN = 0.05  # of the largest displacement: what counts as a motion of its own [1]
_STRAIGHT = 1e-8  # of the extent: a shape narrower than this is a straight line [1]


@unquoted
class Motion(NamedTuple):
    """One mode in words; the shares are of its kinetic energy and add up to 1."""

    name: str  # "along", "in plane", "out of plane", "sideways", of a body "turns"
    rope: str  # the rope that moves most, or the body that turns
    half_waves: int  # of the leading part of the motion
    along: float
    in_plane: float
    out_of_plane: float
    turning: float = 0.0  # of bodies that turn freely


def plane_normal(model: Model, x: Floats) -> Floats:
    """Return the unit normal (3,) of the plane of a shape `x` (3, n).

    A straight shape lies in the upright plane through it; an upright one in any, of which one is taken.
    """
    alive = model.state.mass > 0.0
    points = x[:, alive] - x[:, alive].mean(axis=1, keepdims=True)
    axes, sizes, _ = np.linalg.svd(points, full_matrices=False)
    up = np.array(model.scene.up)
    if len(sizes) > 1 and sizes[1] > _STRAIGHT * max(sizes[0], 1e-300):
        normal = np.cross(axes[:, 0], axes[:, 1])
    else:
        normal = np.cross(axes[:, 0], up)
        if np.linalg.norm(normal) < 1e-6:
            normal = np.cross(up, np.eye(3)[int(np.argmin(np.abs(up)))])
    normal = normal / np.linalg.norm(normal)
    lead = normal[int(np.argmax(np.abs(normal)))]
    return np.asarray(normal * np.sign(lead))


def motions(model: Model, x: Floats, shapes: Complex, normal: Floats) -> tuple[Motion, ...]:
    """Describe all modes; `shapes` (m, n, 3)."""
    tangent = _tangents(model, x)
    across = np.cross(normal, tangent)
    upright = _is_upright(model, x)
    found = []
    for shape in shapes:
        parts = np.stack(
            [(shape * tangent).sum(axis=1), (shape * across).sum(axis=1), shape @ normal]
        )
        energy = model.state.mass * np.abs(parts) ** 2  # (3, n)
        total = float(energy.sum()) or 1.0
        rope = max(
            model.layout.ropes, key=lambda span: float(energy[:, span.first : span.last + 1].sum())
        )
        own = energy[:, rope.first : rope.last + 1].sum(axis=1)
        lead = int(np.argmax(own))
        name = ("along", "in plane", "out of plane")[lead]
        if upright and lead > 0:
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


def _is_upright(model: Model, x: Floats) -> bool:
    alive = model.state.mass > 0.0
    points = (x[:, alive] - x[:, alive][:, :1]).T
    up = np.array(model.scene.up)
    aside = points - np.outer(points @ up, up)
    size = float(np.abs(points).max(initial=0.0))
    return bool(np.abs(aside).max(initial=0.0) <= 1e-6 * size) and bool(
        np.any(model.system.gravity)
    )


def _half_waves(part: Complex, rope: Span) -> int:
    """Count the stretches in which the motion has one sign."""
    own = part[rope.start : rope.end + 1]
    lead = own[int(np.argmax(np.abs(own)))]
    if lead == 0.0:
        return 0
    values = (own * np.conj(lead)).real
    values = values[np.abs(values) > _SEEN * float(np.abs(values).max())]
    return 1 + int((np.sign(values[1:]) != np.sign(values[:-1])).sum())
