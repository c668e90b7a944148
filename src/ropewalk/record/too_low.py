"""Why the largest force of a run may be too low: of a segment, of an anchor, on an obstacle.

All are of the same steps: what these do not resolve is missing in each.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from ropewalk.core.arrays import Floats
from ropewalk.record.extremes import Extreme
from ropewalk.record.landings import Landing
from ropewalk.record.peak_energy import peak_energy_note
from ropewalk.record.tension_notes import JERK, anchor_note, tension_note
from ropewalk.words.percents import percent

if TYPE_CHECKING:
    from ropewalk.record.result import Result

_LOWER = 0.95  # [1] of what a landing gives at least: less is too low
_AS_THERE = (
    "see the largest tension: it is of the same steps, which do not resolve what makes that one"
)


#: Kind of a note for a sweep's counts, and its text, "" where there is nothing to say.
Told = tuple[str, str]


def tension_too_low(result: Result, peak: Extreme) -> Told:
    """Return why the largest tension may be too low."""
    if text := tension_note(result, peak):
        return "peak may be wrong", text
    return "peak may be too low", peak_energy_note(result, peak)


def anchor_too_low(
    result: Result, force: Extreme, tension: Extreme, landings: Sequence[Landing]
) -> Told:
    """Return why the largest force of an anchor may be too low, or is a mean."""
    landing = max(landings, key=lambda one: one.held, default=None)
    if landing is not None and force.value < _LOWER * landing.held:
        return "landing not shown", landing.words(landing.held, _steps(result))
    if text := anchor_note(result, force, tension):
        return "mean anchor force", text
    layout = result.layout
    if not (force.value > 0.0 and tension.value > 0.0):
        return "", ""
    node = layout.anchor_nodes[force.place]
    if layout.rope_of(node)[0] != layout.rope_of(tension.place)[0]:
        return "", ""
    kind, text = tension_too_low(result, tension)
    return kind, _AS_THERE if text else ""


def obstacle_too_low(
    result: Result, loads: Floats, frame: int, tension: Extreme, landings: Sequence[Landing]
) -> str:
    """Return why the largest of the forces on an obstacle in frames, (frames,) [N], may be too low; or "".

    `frame` is the one of the largest.
    """
    most, plan = float(loads[frame]), result.plan
    landing = max(landings, key=lambda one: one.force, default=None)
    if landing is not None and most < _LOWER * landing.force:
        return landing.words(
            landing.force, f"{_steps(result)}, or frames between which there are some,"
        )
    before = float(loads[frame - 1]) if frame else most
    if before < JERK * most and (plan.steps_per_frame > 1 or plan.tolerance is not None):
        share = percent(100.0 * before / most)
        return (
            f"from {share} of it one frame before: between two frames there may be far more; a higher "
            "frame_rate, up to a frame a step, shows it"
        )
    return _AS_THERE if tension_too_low(result, tension)[1] else ""


def _steps(result: Result) -> str:
    plan = result.plan
    if plan.tolerance is not None:
        return f"steps of tolerance {plan.tolerance:.3g} m"
    return f"steps of {1e3 * plan.dt:.3g} ms"
