"""Whether a run's largest speed is of a motion that its steps resolve."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ropewalk.methods.registry import METHODS
from ropewalk.record.balances import energy_of_rounding
from ropewalk.record.extremes import Extreme
from ropewalk.record.facts import FINISHED
from ropewalk.record.tension_notes import FASTER, short_lived, wave_time
from ropewalk.record.turnover import own_errors
from ropewalk.words.percents import percent

if TYPE_CHECKING:
    from ropewalk.record.result import Result
    from ropewalk.scene import Rope

_STILL = 1e-9  # [1] of a segment in a step: what moves less stands still, but for rounding
#: [1] of the largest energy of motion in a frame. Of 11 random runs that lost more, and of whose energy and
#: speed nothing else was to be said, 10 were a tenth and more too slow.
_MOVED = 0.5
#: [1] of that of all ropes at the largest speed: less is of what was fast between two frames.
_WHOLE = 0.1
#: The same of steps so many times as long as a wave takes through a segment: of 275 speeds of random runs a
#: tenth too low, unsaid, 73 lost more, and 16 of 802 right ones.
_LONG, _MOVED_OF_LONG, _WHOLE_OF_LONG = 4.0, 0.1, 0.05


def speed_note(result: Result, fastest: Extreme) -> str:
    """Say why the largest speed may be too low; else "".

    Of steps that follow no wave through a segment.
    """
    plan = result.plan
    if result.status != FINISHED or plan.method not in METHODS or not fastest.value > 0.0:
        return ""
    rope = result.scene.rope_named(result.layout.rope_of(fastest.place)[0])
    if fastest.value * plan.dt < _STILL * rope.segment_length:
        return ""
    if plan.tolerance is None and not plan.dt > FASTER * wave_time(rope):
        return ""
    return _short_note(result, fastest) or _lost_note(result, fastest, rope)


def _lost_note(result: Result, fastest: Extreme, rope: Rope) -> str:
    """Say that steps lost much of what ever moved: what had no time to move is not seen.

    A taut rope that is let go has come to rest within a long step of `implicit-euler`.
    """
    plan = result.plan
    if not (METHODS[plan.method].implicit and result.facts.ledger):
        return ""
    if result.facts.provenance.get("live"):
        return ""
    errors, moved = own_errors(result), result.energy["kinetic"]
    errors = errors[np.isfinite(errors).all(axis=1)]
    if not errors.size or not np.isfinite(moved).any():
        return ""
    lost = float((np.maximum.accumulate(errors, axis=0) - errors).max())
    most = float(moved[np.isfinite(moved)].max())
    ropes = result.scene.ropes
    mass = sum(rope.own_mass + sum(load.mass for load in rope.loads) for rope in ropes)
    whole = 0.5 * mass * fastest.value**2
    much = lost > max(_MOVED * most, _WHOLE * whole)
    long = plan.tolerance is None and not rope.rigid and plan.dt > _LONG * wave_time(rope)
    some = long and lost > max(_MOVED_OF_LONG * most, _WHOLE_OF_LONG * whole)
    if not (much or some) or not lost > energy_of_rounding(result.scene):
        return ""
    by = "far more than a fifth" if much else "a tenth and more"
    finer = (
        f"tolerance = {0.1 * plan.tolerance:.3g}"
        if plan.tolerance is not None
        else f"time_step = {0.25 * plan.dt:.3g} s"
    )
    return (
        f"{plan.method} lost {lost:.3g} J, beside at most {most:.3g} J of motion in any frame: if that would "
        f"have moved the ropes, it may be too low by {by}; compare it with a run of {finer}"
    )


def _short_note(result: Result, fastest: Extreme) -> str:
    """Say that the largest speed lasts a step or two, of a whip or a wave, and may be too low; else "".

    Of steps of one length. A crack of a rope's end is as short as a wave through its last segments: longer
    steps round it off, as they do its tension. What falls and lands came to its speed slowly.
    """
    plan = result.plan
    frame = int(np.searchsorted(result.time, fastest.until))
    if plan.tolerance is not None or not 0 < frame < result.frames:
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
