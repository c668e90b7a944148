"""What to say of a rope with bending stiffness before it is run."""

from __future__ import annotations

import math

import numpy as np

from ropewalk.laws.acting import flow
from ropewalk.lowering import Model
from ropewalk.scene import Clamp, Material, Rope

_FLAT = 1e-6  # [1] what counts as in a plane
_THICK = (
    5.0  # [1] diameter of a rod over its segments' length up to which hostile starts were tried
)
_SHARP = 0.5  # [rad] a bend at one node from which on the angle no longer follows the curvature


def bending_warnings(model: Model) -> list[str]:
    """Return one sentence for every way in which a scene leaves what bending is made for."""
    found = []
    for rope in model.scene.ropes:
        if isinstance(rope.made_of, Material) and rope.made_of.EI > 0.0:
            found += _out_of_plane(model, rope) + _too_coarse(model, rope) + _too_fine(rope)
    return found


def _out_of_plane(model: Model, rope: Rope) -> list[str]:
    """A natural curvature has an axis fixed in space: right only while all is in the plane across it."""
    assert isinstance(rope.made_of, Material)
    curvature = np.array(rope.made_of.curvature)
    if not curvature.any():
        return []
    axis = curvature / np.linalg.norm(curvature)
    span = model.layout.span(rope.name)
    nodes = slice(span.start, span.end + 1)
    x, v = model.state.x[:, nodes], model.state.v[:, nodes]
    causes = {
        "its shape": np.ptp(axis @ x) > _FLAT * rope.length_unstretched,
        "its velocity": np.abs(axis @ v).max() > _FLAT * np.abs(v).max(),
        "gravity": _leaves(axis, model.system.gravity),
        "the wind": _leaves(axis, flow(model.system)),
        "a clamp": any(_leaves(axis, d) for d in _directions(model, rope)),
        "a clamp's turn": any(_turns_out(axis, clamp) for clamp in _clamps(model, rope)),
    }
    named = [cause for cause, leaves in causes.items() if leaves]
    if not named:
        return []
    return [
        f"rope {rope.name!r} has a natural curvature, whose axis stays fixed in space: it is right "
        f"only in the plane across it, which {' and '.join(named)} "
        f"{'leaves' if len(named) == 1 else 'leave'}"
    ]


def _clamps(model: Model, rope: Rope) -> list[Clamp]:
    anchors = [anchor for anchor in model.scene.anchors if anchor.rope == rope.name]
    return [anchor.clamp for anchor in anchors if anchor.clamp is not None]


def _directions(model: Model, rope: Rope) -> list[tuple[float, ...]]:
    return [tuple(clamp.direction) for clamp in _clamps(model, rope)]


def _turns_out(axis: np.ndarray, clamp: Clamp) -> bool:
    """Tell whether a clamp turns about another axis."""
    about = np.asarray(clamp.turn_axis, dtype=np.float64)
    aside = np.linalg.norm(np.cross(axis, about)) > _FLAT * np.linalg.norm(about)
    return clamp.turn_rate != 0.0 and bool(aside)


def _leaves(axis: np.ndarray, vector: object) -> bool:
    array = np.asarray(vector, dtype=np.float64)
    return bool(abs(axis @ array) > _FLAT * np.linalg.norm(array))


def _too_coarse(model: Model, rope: Rope) -> list[str]:
    """Bends at time zero that segments of this length cannot follow."""
    span = model.layout.span(rope.name)
    e = np.diff(model.state.x[:, span.start : span.end + 1], axis=1)
    sizes = np.linalg.norm(e, axis=0)
    t = np.divide(e, sizes, out=np.zeros_like(e), where=sizes > 0.0)
    angle = np.arccos(np.clip((t[:, 1:] * t[:, :-1]).sum(axis=0), -1.0, 1.0))
    if not angle.size or angle.max() <= _SHARP:
        return []
    node = int(np.argmax(angle)) + 1
    return [
        f"rope {rope.name!r} starts bent by {math.degrees(angle.max()):.0f} degrees at node {node}: "
        "too much for one node of a rope with bending stiffness; take more segments or a smoother shape"
    ]


def _too_fine(rope: Rope) -> list[str]:
    """Segments much shorter than the round section that EI and EA make: EI / EA = (d / 4)^2."""
    assert isinstance(rope.made_of, Material)
    diameter = 4.0 * math.sqrt(rope.made_of.EI / rope.made_of.EA)
    if diameter <= _THICK * rope.segment_length:
        return []
    most = max(1, math.floor(rope.length_unstretched / diameter))
    return [
        f"rope {rope.name!r} has the EI and EA of a round rod {diameter:.3g} m thick, in segments of "
        f"{rope.segment_length:.3g} m: finer than bending means anything, and steps may have no solution; "
        f"take {most} segment{'s' if most > 1 else ''} at most, or a smaller EI"
    ]
