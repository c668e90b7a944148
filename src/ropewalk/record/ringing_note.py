"""Peaks of methods that keep waves ringing which their steps do not resolve: they may be far too high."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ropewalk.engine.unsolved import CALMER, RINGING
from ropewalk.record.extremes import Extreme
from ropewalk.record.facts import FINISHED
from ropewalk.record.tension_notes import RESOLVED, SHORT, SHORT_WITHIN, wave_time

if TYPE_CHECKING:
    from ropewalk.record.result import Result

CALM = 0.9  # [1] of a peak: what is there beside it, where nothing rings


def ringing_note(result: Result, peak: Extreme) -> str:
    """Say that the largest tension may be far too high where the method keeps its rope ringing; else "".

    `implicit-midpoint` and `generalized-alpha` take forces of mid-step, or of a mean. What a segment bears at
    the end of a step swings about that by as much as waves that no step resolves have left in it: tensions of
    tens of times a rope's own are seen beside anchor forces that are right. What it bore as the run began no
    step has made.
    """
    plan = result.plan
    if result.status != FINISHED or plan.method not in RINGING or not peak.value > 0.0:
        return ""
    if peak.until <= result.time[0]:
        return ""
    name, _ = result.layout.rope_of(peak.place)
    rope = result.scene.rope_named(name)
    through = wave_time(rope)
    if not 0.0 < through < RESOLVED * plan.dt:
        return ""
    if rope.bending_stiffness == 0.0 and not _rings(result, peak):
        return ""
    return (
        f"{plan.method} keeps waves ringing that its steps do not resolve: one takes "
        f"{1e3 * through:.3g} ms through a segment, a step {1e3 * plan.dt:.3g} ms. At the ends of steps the "
        "tension swings about what the rope bears, and its peak may be far too high, or too low; take "
        f"method = {CALMER}"
    )


def _rings(result: Result, peak: Extreme) -> bool:
    """Tell whether tensions about a peak, in time or along the rope, are far from it within a step or so."""
    frame = min(int(np.searchsorted(result.time, peak.until)), result.frames - 1)
    names = ["tension", "least_tension"] if result.has_extremes else ["tension"]
    frames = slice(max(frame - 1, 0), min(frame + 2, result.frames))
    beside = result.read("tension", frames.start, frames.stop)[:, peak.place]
    within = min(float(result.read(name, frame, frame + 1)[0, peak.place]) for name in names)
    least = SHORT_WITHIN if result.plan.steps_per_frame > 1 else SHORT
    if min(float(beside.min()), within) < least * peak.value:
        return True
    span = result.layout.span(result.layout.rope_of(peak.place)[0])
    near = slice(max(peak.place - 1, span.start), min(peak.place + 2, span.end))
    along = result.read("tension", frame, frame + 1)[0, near]
    return bool(np.abs(np.diff(along)).max(initial=0.0) > (1.0 - CALM) * peak.value)
