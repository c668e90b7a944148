"""Whether a run's largest speed is of a motion that its steps resolve."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ropewalk.methods.registry import METHODS
from ropewalk.record.extremes import Extreme
from ropewalk.record.facts import FINISHED
from ropewalk.record.tension_notes import FASTER, short_lived, wave_time
from ropewalk.words.percents import percent

if TYPE_CHECKING:
    from ropewalk.record.result import Result

_STILL = 1e-9  # [1] of a segment in a step: what moves less stands still, but for rounding


def speed_note(result: Result, fastest: Extreme) -> str:
    """Say that the largest speed lasts a step or two, of a whip or a wave, and may be too low; else "".

    Of steps of one length that follow no wave through a segment. A crack of a rope's end is as short as a
    wave through its last segments: longer steps round it off, as they do its tension. What falls and lands
    came to its speed slowly.
    """
    plan = result.plan
    if result.status != FINISHED or plan.method not in METHODS or plan.tolerance is not None:
        return ""
    frame = int(np.searchsorted(result.time, fastest.until))
    if not fastest.value > 0.0 or not 0 < frame < result.frames:
        return ""
    rope = result.scene.rope_named(result.layout.rope_of(fastest.place)[0])
    if (
        not plan.dt > FASTER * wave_time(rope)
        or fastest.value * plan.dt < _STILL * rope.segment_length
    ):
        return ""
    last = min(frame + 1, result.frames - 1)
    velocity = result.read("velocities", frame - 1, last + 1)[:, fastest.place]
    shares = np.linalg.norm(velocity[[0, -1]], axis=1) / fastest.value
    if not short_lived(plan, *shares.tolist()):
        return ""
    before, after = (percent(100.0 * float(share)) for share in shares)
    return (
        f"a speed of a step or two of {1e3 * plan.dt:.3g} ms, from {before} of it one frame before to "
        f"{after} in the one after: steps do not resolve it, and it may be too low by a fifth and "
        f"more; compare it with a run of time_step = {0.25 * plan.dt:.3g} s"
    )
