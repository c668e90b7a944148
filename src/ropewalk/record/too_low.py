"""Why the largest force of a run may be too low: of a segment, of an anchor, on an obstacle.

All are of the same steps: what these do not resolve is missing in each.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from ropewalk.record.balances import SLACK
from ropewalk.record.body_loads import of_nodes
from ropewalk.record.extremes import Extreme
from ropewalk.record.joined_ropes import joined_ropes
from ropewalk.record.landings import Landing
from ropewalk.record.margins import breaking_load
from ropewalk.record.peak_energy import peak_energy_note
from ropewalk.record.ringing_note import ringing_note
from ropewalk.record.tension_notes import JERK, short_note, tension_note
from ropewalk.words.percents import percent

if TYPE_CHECKING:
    from ropewalk.record.result import Result

_LOWER = 0.95  # [1] of what a landing gives at least: less is too low
_ABOUT = 2  # frames from one largest force to another that comes of the same
_SAME = "see the largest tension, of about the same time: "
#: What is said of a force beside the largest tension's kind of note.
_AS_THERE = {
    "peak may be wrong": _SAME
    + "it is of the same steps, which do not resolve what makes that one",
    "peak may be too low": _SAME + "the energy that was lost until then may be missing here, too",
}

_WHOSE = "see the largest tension, whose it is: that "
#: What is said of a utilisation that is the largest tension's.
_OF_PEAK = {
    "peak may be wrong": _WHOSE + "may be wrong, and the safety factor with it",
    "peak may be too low": _WHOSE + "may be too low, and the safety factor too high",
}
#: Kind of a note for a sweep's counts, and its text, "" where there is nothing to say.
Told = tuple[str, str]


def tension_too_low(result: Result, peak: Extreme) -> Told:
    """Return why the largest tension may be too low."""
    if text := ringing_note(result, peak) or tension_note(result, peak):
        return "peak may be wrong", text
    short, lost = short_note(result, peak), peak_energy_note(result, peak)
    kind = "peak may be too low" if lost or not short else "peak may be wrong"
    return kind, "; ".join(text for text in (short, lost) if text)


def margin_too_low(result: Result, use: Extreme, peak: Extreme) -> Told:
    """Return why the largest utilisation may be too low, and the safety factor too high.

    `use` is the largest tension over breaking load [1], `peak` the largest tension of all ropes [N]: it is
    the force of another rope, or of another time, where breaking loads differ.
    """
    load = breaking_load(result.scene.rope_named(result.layout.rope_of(use.place)[0]))
    if load is None or math.isnan(use.value):
        return "", ""
    own = use._replace(value=use.value * load)
    same = peak.place == use.place and peak.until == use.until
    kind, text = tension_too_low(result, peak if same else own)
    if not text:
        return "", ""
    return kind, _OF_PEAK[kind] if same else f"of a tension of {own.value:.6g} N: {text}"


def anchor_too_low(
    result: Result, force: Extreme, tension: Extreme, landings: Sequence[Landing]
) -> Told:
    """Return why the largest force of an anchor may be too low."""
    landing = max(landings, key=lambda one: one.held, default=None)
    if landing is not None and force.value < _LOWER * landing.held:
        return "landing not shown", landing.words(landing.held, _steps(result))
    layout = result.layout
    if not (force.value > 0.0 and tension.value > 0.0):
        return "", ""
    names = [layout.rope_of(one)[0] for one in (layout.anchor_nodes[force.place], tension.place)]
    if names[0] not in joined_ropes(result.scene, layout, names[1:]):
        return "", ""
    return _as_there(result, int(np.searchsorted(result.time, force.until)), tension)


def obstacle_too_low(
    result: Result,
    frame: int,
    forces: tuple[float, float],
    tension: Extreme,
    landings: Sequence[Landing],
) -> Told:
    """Return why the largest of the forces on an obstacle in frames may be too low.

    `frame` is the one of the largest, `forces` are those of the frame before and of that one [N].
    """
    (before, most), plan = forces, result.plan
    landing = max(landings, key=lambda one: one.force, default=None)
    if landing is not None and most < _LOWER * landing.force:
        by = f"{_steps(result)}, or frames between which there are some,"
        return "landing not shown", landing.words(landing.force, by)
    elastic = [one for one in result.scene.ropes if not one.rigid]
    stiff = max((one.segment_stiffness * one.segment_length for one in elastic), default=0.0)
    if not most > SLACK * stiff:  # nothing presses
        return "", ""
    if frame and before < JERK * most and (plan.steps_per_frame > 1 or plan.tolerance is not None):
        share = percent(100.0 * before / most)
        return "force between frames", (
            f"from {share} of it one frame before: between two frames there may be far more; a higher "
            "frame_rate, up to a frame a step, shows it"
        )
    if not tension.value > 0.0:
        return "", ""
    name, _ = result.layout.rope_of(tension.place)
    span = result.layout.span(name)
    pressed = np.nan_to_num(result.read(of_nodes(result), frame, frame + 1))
    if not pressed[0, span.first : span.last + 1].any():
        return "", ""
    return _as_there(result, frame, tension)


def _as_there(result: Result, frame: int, tension: Extreme) -> Told:
    """Return what the note of the largest tension makes of a force of its rope in this frame."""
    if abs(frame - int(np.searchsorted(result.time, tension.until))) > _ABOUT:
        return "", ""
    kind, text = tension_too_low(result, tension)
    return kind, _AS_THERE[kind] if text else ""


def _steps(result: Result) -> str:
    plan = result.plan
    if plan.tolerance is not None:
        return f"steps of tolerance {plan.tolerance:.3g} m"
    return f"steps of {1e3 * plan.dt:.3g} ms"
