"""A stretch limiter that is solved for: what it needs to be run, and a start within its bounds."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from ropewalk.core import arrays
from ropewalk.core.arrays import Floats
from ropewalk.lowering import Model
from ropewalk.lowering.link_lengths import TAUT, fit_lengths, reaches
from ropewalk.methods.registry import METHODS
from ropewalk.scene import Limiter, SceneError
from ropewalk.scene.faults import NO_VALUE, Fault

_AT_BOUND = 1e-9  # [1] a stretch this close to its bound counts as at it


def with_bounds(model: Model) -> Model:
    """Return the model with all segments within the limiter's bounds; itself where nothing is to be done.

    An implicit method holds the bounds at the end of its first step: what lies beyond them at the start
    would be thrown back. Explicit methods put it back after the step, places only.
    Raises SceneError for anchors farther apart than the limiter lets the rope reach, and for a start at rest
    beyond the bounds: the limiter takes no part in the equilibrium, so that it would not be at rest.
    """
    limiter = model.scene.limiter
    if limiter is not None and model.scene.run.start == "at-rest":
        _refuse_rest(model, limiter)
    if limiter is None or not METHODS[model.plan.method].implicit:
        return model
    for reach in reaches(model.layout, model.state, model.state.x, limiter.max_stretch):
        if reach.distance >= (1.0 - TAUT) * reach.length:
            rule = f"{reach}: an implicit method holds to that; take a larger one, or an explicit method"
            raise SceneError([Fault("limiter.max_stretch", limiter.max_stretch, rule)])
    state = arrays.copy(model.state)

    def gaps() -> tuple[Floats, Floats, NDArray[np.bool_]]:
        d = np.diff(state.x, axis=1)
        r = np.sqrt((d * d).sum(axis=0))
        shortest, longest = (
            stretch * state.rest_length for stretch in (limiter.min_stretch, limiter.max_stretch)
        )
        free = state.inverse_mass[:-1] + state.inverse_mass[1:] > 0.0
        live = (state.stiffness > 0.0) & (r > 0.0) & free
        gap = np.where(live, r - np.clip(r, shortest, longest), 0.0)
        at_bound = (r >= (1.0 - _AT_BOUND) * longest) | (r <= (1.0 + _AT_BOUND) * shortest)
        return d / np.maximum(r, 1e-300), gap, live & at_bound

    _, gap, _ = gaps()
    if not gap.any():
        return model
    worst = fit_lengths(state, gaps)
    if worst is not None:
        rope, segment = model.layout.rope_of(worst)
        rule = f"segment {segment} of rope {rope!r} cannot be brought within the limiter's bounds"
        raise SceneError([Fault("limiter", NO_VALUE, rule)])
    return replace(model, state=state)


def _refuse_rest(model: Model, limiter: Limiter) -> None:
    state = model.state
    r = np.sqrt((np.diff(state.x, axis=1) ** 2).sum(axis=0))
    stretch = np.divide(r, state.rest_length, out=np.ones_like(r), where=state.stiffness > 0.0)
    off = np.maximum(
        stretch / limiter.max_stretch, limiter.min_stretch / np.maximum(stretch, 1e-300)
    )
    worst = int(np.argmax(off))
    if off[worst] > 1.0 + _AT_BOUND:
        rope, segment = model.layout.rope_of(worst)
        rule = (
            "rests beyond the limiter's bounds, which take no part in the equilibrium: segment "
            f"{segment} of rope {rope!r} at {stretch[worst]:.4g} of its length; let it come to rest "
            "from a drawn shape"
        )
        raise SceneError([Fault("run.start", "at-rest", rule)])
