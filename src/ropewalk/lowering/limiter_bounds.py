"""A stretch limiter that is solved for: what it needs to be run, and a start within its bounds."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from ropewalk.core import arrays
from ropewalk.core.arrays import Floats
from ropewalk.lowering import Model
from ropewalk.lowering.link_lengths import TAUT, fit_lengths, fit_velocities, points, reaches
from ropewalk.methods.registry import METHODS
from ropewalk.scene import SceneError
from ropewalk.scene.faults import NO_VALUE, Fault

_AT_BOUND = 1e-9  # [1] a stretch this close to its bound counts as at it


def with_bounds(model: Model) -> Model:
    """Return the model with all segments within the limiter's bounds; itself where nothing is to be done.

    An implicit method holds the bounds at the end of its first step: what lies beyond them at the start
    would be thrown back. Explicit methods put it back after the step, places only. Rigid links keep their
    lengths, and what joints tie stays together.
    Raises SceneError for anchors farther apart than the limiter lets the rope reach, and for a start at rest
    beyond the bounds: the limiter takes no part in the equilibrium, so that it would not be at rest.
    """
    limiter = model.scene.limiter
    if limiter is not None and model.scene.run.start == "at-rest":
        _refuse_rest(model)
    if limiter is None or not METHODS[model.plan.method].implicit:
        return model
    for reach in reaches(model.layout, model.state, model.state.x, limiter.max_stretch):
        if reach.distance >= (1.0 - TAUT) * reach.length:
            rule = f"{reach}: an implicit method holds to that; take a larger one, or an explicit method"
            raise SceneError([Fault("limiter.max_stretch", limiter.max_stretch, rule)])
    state, rigid = arrays.copy(model.state), np.isinf(model.state.stiffness)
    least = np.where(model.system.slack_floor == 0.0, 0.0, 1.0)  # of rigid links
    shortest = np.where(rigid, least, limiter.min_stretch) * state.rest_length
    longest = np.where(rigid, 1.0, limiter.max_stretch) * state.rest_length

    def gaps() -> tuple[Floats, Floats, NDArray[np.bool_]]:
        d = np.diff(state.x, axis=1)
        r = np.sqrt((d * d).sum(axis=0))
        free = state.inverse_mass[:-1] + state.inverse_mass[1:] > 0.0
        live = (state.stiffness > 0.0) & (r > 0.0) & free
        gap = np.where(live, r - np.clip(r, shortest, longest), 0.0)
        at_bound = (r >= (1.0 - _AT_BOUND) * longest) | (r <= (1.0 + _AT_BOUND) * shortest)
        return d / np.maximum(r, 1e-300), gap, live & at_bound

    if not gaps()[1][~rigid].any():
        return model
    worst = fit_lengths(state, gaps, points(model))
    if worst is not None:
        rope, segment = model.layout.rope_of(worst)
        rule = f"segment {segment} of rope {rope!r} cannot be brought within the limiter's bounds"
        raise SceneError([Fault("limiter", NO_VALUE, rule)])
    found = replace(model, state=state)
    if rigid.any():
        fit_velocities(found)
    return found


def beyond_bounds(model: Model, x: Floats) -> str:
    """Say which segment is the farthest beyond the limiter's bounds at places (3, n) [m]; "" for none."""
    state, limiter = model.state, model.scene.limiter
    bounded = (state.stiffness > 0.0) & np.isfinite(state.stiffness)
    if limiter is None or not bounded.any():
        return ""
    r = np.sqrt((np.diff(x, axis=1) ** 2).sum(axis=0))
    stretch = np.divide(r, state.rest_length, out=np.ones_like(r), where=bounded)
    off = np.maximum(
        stretch / limiter.max_stretch, limiter.min_stretch / np.maximum(stretch, 1e-300)
    )
    worst = int(np.argmax(np.where(bounded, off, 0.0)))
    if off[worst] <= 1.0 + _AT_BOUND:
        return ""
    rope, segment = model.layout.rope_of(worst)
    return f"segment {segment} of rope {rope!r} at {stretch[worst]:.4g} of its length"


def _refuse_rest(model: Model) -> None:
    if far := beyond_bounds(model, model.state.x):
        rule = (
            f"rests beyond the limiter's bounds, which take no part in the equilibrium: {far}; let it come "
            "to rest from a drawn shape"
        )
        raise SceneError([Fault("run.start", "at-rest", rule)])
