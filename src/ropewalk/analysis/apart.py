"""Anchors that pull the rope between them apart, whatever the method and the step."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.lowering import Model
from ropewalk.lowering.apart import Span, spans, stretch_of
from ropewalk.methods.registry import METHODS
from ropewalk.motions.rows import largest_speed

_ROUNDING = 1e-9  # [1]
_MOST_TIMES = 20_000  # frames looked at; of more, as many, evenly
#: What a sudden pull adds to the stretch is at most this times its speed over that of waves [1]: of a long
#: chain of equal nodes 1.092 in the first segment, ever nearer to 1.274 far from it (Schroedinger 1914).
_FIRST = 1.28


class Torn(NamedTuple):
    """Two anchors that come farther apart than the rope between them can be long."""

    rope: str
    anchors: tuple[str, str]
    time: float  # [s] of the first frame at which they are so far apart
    stretch: float  # [1] their distance then, over the length of the rope between them
    most: float  # [1] beyond which it breaks or, where the rope cannot stretch, has no solution

    def __str__(self) -> str:
        first, last = self.anchors
        can = f"can be {self.most:.4g} times its length at most"
        if self.most == 1.0:
            can = "does not stretch"
        return (
            f"anchors {first!r} and {last!r} come {self.stretch:.4g} times as far apart as the rope between "
            f"them is long, until t = {self.time:.4g} s; rope {self.rope!r} {can}, so the run breaks by "
            "then, with any method and step"
        )


def torn_apart(model: Model) -> list[Torn]:
    """Return the pairs of anchors whose motions alone tear the rope between them apart.

    A rope that is pulled so far is longer than what counts as one, but may break earlier.
    """
    found = []
    for span in spans(model.system, model.state):
        times, stretch = _stretches(model, span)
        most = _most(model, span)
        far = np.flatnonzero(stretch > most * (1.0 + _ROUNDING))
        if far.size:
            at = int(far[0])
            found.append(Torn(*_names(model, span), float(times[at]), float(stretch[at]), most))
    return found


def jerks(model: Model) -> list[str]:
    """Say which anchors move so fast that waves cannot spread the pull before a segment is too long."""
    found = []
    system, state = model.system, model.state
    for span in spans(system, state):
        speeds = [largest_speed(system.anchors, row) for row in span.rows]
        waves = _slowest_waves(model, span)
        jerk = _FIRST * max(speeds) / waves
        led, most = float(_stretches(model, span)[1].max()), _most(model, span)
        largest = led + jerk
        if led <= most * (1.0 + _ROUNDING) < largest:  # beyond it by its way: `torn_apart`
            rope, names = _names(model, span)
            fast = names[int(np.argmax(speeds))]
            found.append(
                f"anchor {fast!r} moves at up to {max(speeds):.4g} m/s, and waves run along rope {rope!r} at "
                f"{waves:.4g} m/s: segments beside it may be pulled to {largest:.3g} times their length, "
                "where a run breaks with any method and step"
            )
    return found


def _stretches(model: Model, span: Span) -> tuple[Floats, Floats]:
    """Return times of frames while two anchors hold [s], and their distance over the rope's length [1]."""
    plan = model.plan
    frames = np.arange(0, plan.frames + 1, max(1, plan.frames // _MOST_TIMES))
    times: Floats = np.asarray(frames * plan.frame_interval, dtype=np.float64)
    times = times[times < span.end]
    return times, stretch_of(model.system, model.state, span, times)


def _most(model: Model, span: Span) -> float:
    """Return the stretch beyond which a run breaks, or has no solution [1]."""
    system = model.system
    if np.isinf(model.state.stiffness[span.first : span.last]).all():
        return 1.0
    if system.limiter.active and METHODS[model.plan.method].implicit:  # others give way
        return min(system.break_stretch, system.limiter.longest)
    return system.break_stretch


def _slowest_waves(model: Model, span: Span) -> float:
    """Return the slowest speed of waves along the rope between two anchors [m/s], by its heaviest nodes."""
    state, segments = model.state, slice(span.first, span.last)
    heaviest = np.maximum(
        state.mass[span.first : span.last], state.mass[span.first + 1 : span.last + 1]
    )
    speeds = state.rest_length[segments] * np.sqrt(state.stiffness[segments] / heaviest)
    return float(speeds[state.rest_length[segments] > 0.0].min())


def _names(model: Model, span: Span) -> tuple[str, tuple[str, str]]:
    one, other = (model.layout.anchor_names[row] for row in span.rows)
    return model.layout.rope_of(span.first)[0], (one, other)
