"""What the energy that implicit steps had lost by then may be of the largest tension.

A peak is where motion has become stretch: of a weight that a rope stops, T^2 / 2k is what it had. Steps that
lost a part of that, as implicit Euler's do, make a peak that is too low, with nothing else to be seen.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ropewalk.methods.registry import METHODS
from ropewalk.record.balances import shorter_steps
from ropewalk.record.extremes import Extreme
from ropewalk.record.facts import FINISHED
from ropewalk.record.turnover import own_kinetic
from ropewalk.words.percents import percent
from ropewalk.words.safe_side import percent_up

if TYPE_CHECKING:
    from ropewalk.record.result import Result

_TOLD = 2.0  # [%] of the energy then: a hundredth of the force


def peak_energy_note(result: Result, peak: Extreme) -> str:
    """Say how much more the largest tension may be for the energy that was lost by then; else "".

    What was lost up to the frame after the peak, as a part p of the energy of motion and stretch about it and
    what was lost: as T^2 goes by the energy, at least p/2 of the tension. Told is what all of p makes: falls
    and stops by implicit Euler in steps of 2 to 33 ms came out too low by 0.5 to 0.8 of p. Of all ropes
    together, so that it may be of another rope. Energies of explicit methods swing with the step, and say
    nothing of a peak.
    """
    plan = result.plan
    if result.status != FINISHED or not result.facts.ledger or result.facts.provenance.get("live"):
        return ""
    if plan.method not in METHODS or not METHODS[plan.method].implicit or not peak.value > 0.0:
        return ""
    frame = min(int(np.searchsorted(result.time, peak.until)), result.frames - 1)
    errors = result.energy_errors[: frame + 1]
    lost = -float(errors[np.isfinite(errors)].min(initial=0.0))
    about = slice(max(frame - 1, 0), frame + 1)
    there = float((own_kinetic(result)[about] + result.energy["elastic"][about]).max())
    share = 100.0 * lost / (there + lost) if there > 0.0 else 0.0
    if not share > _TOLD:
        return ""
    return (
        f"{plan.method} had lost {lost:.3g} J by then, beside {there:.3g} J of motion and stretch: by that "
        f"it is too low by some {percent(0.5 * share)}, at most about {percent_up(share)}; take "
        f"{shorter_steps(plan)}"
    )
