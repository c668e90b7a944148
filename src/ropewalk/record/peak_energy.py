"""What the energy that implicit steps lost while the largest tension grew may be of it.

A peak is where motion has become stretch: of a weight that a slack rope catches, T^2 / 2k is what it had.
Steps that lose a part of that on the way, as implicit Euler's do, make a peak that is too low, with nothing
else to be seen.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ropewalk.methods.registry import METHODS
from ropewalk.record.extremes import Extreme
from ropewalk.record.facts import FINISHED
from ropewalk.record.turnover import own_kinetic
from ropewalk.words.percents import percent

if TYPE_CHECKING:
    from ropewalk.record.result import Result

_TOLD = 2.0  # [%] of the energy then: a hundredth of the force
_ROSE = 0.5  # [1] of the peak: since the tension was less it has grown
_PIECE = 256  # frames that are read at once


def peak_energy_note(result: Result, peak: Extreme) -> str:
    """Say by how much the largest tension may be too low for the energy that was lost as it grew; else "".

    What was lost since the tension there was last less than half of the peak, as a part p of that and the
    energy of motion and stretch about it, both of all ropes: T^2 goes by the energy, so that p/2 is a first
    guess. It is no bound: falls and stops by implicit Euler in steps of 2 to 33 ms came out too low by 0.5 to
    1.5 p, and what segments or steps blur besides is not in it. Energies of explicit methods swing with the
    step, and say nothing of a peak.
    """
    plan = result.plan
    if result.status != FINISHED or not result.facts.ledger or result.facts.provenance.get("live"):
        return ""
    if plan.method not in METHODS or not METHODS[plan.method].implicit or not peak.value > 0.0:
        return ""
    frame = min(int(np.searchsorted(result.time, peak.until)), result.frames - 1)
    start = _began(result, peak, frame)
    if start is None:
        return ""
    errors = result.energy_errors[start + 1 : frame + 1]
    first = float(result.energy_error[start])
    lost = first - float(errors[np.isfinite(errors)].min(initial=first))
    about = slice(max(frame - 1, 0), frame + 1)
    there = float((own_kinetic(result)[about] + result.energy["elastic"][about]).max())
    share = 100.0 * lost / (there + lost) if there > 0.0 else 0.0
    if not share > _TOLD:
        return ""
    return (
        f"{plan.method} lost {lost:.3g} J while it grew, beside {there:.3g} J of motion and stretch of all "
        f"ropes: it may be too low by some {percent(0.5 * share)} and more; compare it with a run of "
        f"{_finer(result)}"
    )


def _began(result: Result, peak: Extreme, frame: int) -> int | None:
    """Return the last frame before in which the tension there was less than half of the peak, if any."""
    for last in range(frame, 0, -_PIECE):
        first = max(last - _PIECE, 0)
        low = result.read("tension", first, last)[:, peak.place] < _ROSE * peak.value
        if low.any():
            return first + int(np.flatnonzero(low)[-1])
    return None


def _finer(result: Result) -> str:
    plan = result.plan
    if plan.tolerance is not None:
        return f"tolerance = {0.1 * plan.tolerance:.3g}"
    return f"time_step = {0.25 * plan.dt:.3g} s"
