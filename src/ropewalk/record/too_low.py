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
from ropewalk.record.tension_notes import (
    JERK,
    Sizes,
    reactions,
    short_note,
    tension_note,
    tensions,
)
from ropewalk.words.percents import percent

if TYPE_CHECKING:
    from ropewalk.core.arrays import Floats
    from ropewalk.lowering import Plan
    from ropewalk.record.pressed_rows import Pressed
    from ropewalk.record.result import Result

_LOWER = 0.95  # [1] of what a landing gives at least: less is too low
#: Steps before the largest force on a body, and less of it [1] in one of them: of 44 of random runs a tenth
#: too low, unsaid, 15 came so fast, and none of 23 right ones.
_HIT, _STRUCK = 3, 0.3
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
    return _by_shape(result, peak, tensions(result, peak.place))


def _by_shape(result: Result, peak: Extreme, sizes: Sizes) -> Told:
    """Return why a force may be too low, by what it was about its time and by what was lost until then."""
    short, lost = short_note(result, peak, sizes), peak_energy_note(result, peak, sizes)
    if not (short or lost):
        return "", ""
    kind = "peak may be too low" if lost else "peak may be wrong"
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
    if not force.value > 0.0:
        return "", ""
    layout, node = result.layout, result.layout.anchor_nodes[force.place]
    name, _ = layout.rope_of(node)
    if tension.value > 0.0 and name in joined_ropes(
        result.scene, layout, [layout.rope_of(tension.place)[0]]
    ):
        told = _as_there(result, int(np.searchsorted(result.time, force.until)), tension)
        if told[1]:
            return told
    own = force._replace(place=min(node, layout.span(name).last - 1))
    return _by_shape(result, own, reactions(result, force.place))


def obstacle_too_low(
    result: Result,
    found: Pressed,
    sizes: Sizes,
    tension: Extreme,
    landings: Sequence[Landing],
) -> Told:
    """Return why the largest of the forces on an obstacle may be too low.

    `sizes` returns the forces on that obstacle in frames.
    """
    frame, most, plan = found.frame, found.force, result.plan
    landing = max(landings, key=lambda one: one.force, default=None)
    if landing is not None and most < _LOWER * landing.force:
        frames = "" if found.every_step else ", or frames between which there are some,"
        by = f"{_steps(result)}{frames}"
        return "landing not shown", landing.words(landing.force, by)
    elastic = [one for one in result.scene.ropes if not one.rigid]
    stiff = max((one.segment_stiffness * one.segment_length for one in elastic), default=0.0)
    if not most > SLACK * stiff:  # nothing presses
        return "", ""
    steps = plan.steps_per_frame > 1 or plan.tolerance is not None  # between frames
    before = most if found.every_step else float(sizes(max(frame - 1, 0), frame + 1)[0])
    if frame and before < JERK * most and steps:
        share = percent(100.0 * before / most)
        return "force between frames", (
            f"from {share} of it one frame before: between two frames there may be far more; a higher "
            "frame_rate, up to a frame a step, shows it"
        )
    pressed = _pressed_about(result, frame)
    if tension.value > 0.0:
        span = result.layout.span(result.layout.rope_of(tension.place)[0])
        if pressed[span.first : span.last + 1].any():
            told = _as_there(result, frame, tension)
            if told[1]:
                return told
    if hit := _hit(plan, found, sizes):
        return "peak may be wrong", hit
    node, time = int(np.argmax((pressed**2).sum(axis=1))), float(result.time[frame])
    last = result.layout.span(result.layout.rope_of(node)[0]).last
    own = Extreme(most, min(node, last - 1), time, time, every_step=False)
    lost = peak_energy_note(result, own, sizes, pressed=True)
    return "peak may be too low" if lost else "", lost


def _pressed_about(result: Result, frame: int) -> Floats:
    """Return the force on every node in a frame (n, 3) [N], or in the one before if there is none."""
    for there in (frame, frame - 1):
        pressed: Floats = np.nan_to_num(result.read(of_nodes(result), there, there + 1)[0])
        if there <= 0 or pressed.any():
            break
    return pressed


def _hit(plan: Plan, found: Pressed, sizes: Sizes) -> str:
    """Say that what presses a body came within few steps, which may round it off; else "".

    `sizes` returns the forces on it [N] in frames, which may be steps.
    """
    least, most, steps = found.before, found.force, _HIT
    if plan.steps_per_frame == 1 and plan.tolerance is None:
        before = sizes(max(found.frame - _HIT, 0), found.frame + 1)
        least, steps = float(before.min()), len(before) - 1
    if plan.tolerance is not None or not least < _STRUCK * most:
        return ""
    share = percent(100.0 * least / most)
    return (
        f"from {share} of it within {steps} steps of {1e3 * plan.dt:.3g} ms: they hardly "
        "resolve what hits there, and it may be too low by a tenth and more; compare it with a run of "
        f"time_step = {0.25 * plan.dt:.3g} s"
    )


def _as_there(result: Result, frame: int, tension: Extreme) -> Told:
    """Return what the note of the largest tension makes of a force of its rope in this frame."""
    if abs(frame - int(np.searchsorted(result.time, tension.until))) > _ABOUT:
        return "", ""
    kind, text = tension_too_low(result, tension)
    return (kind, _AS_THERE[kind]) if text else ("", "")


def _steps(result: Result) -> str:
    plan = result.plan
    if plan.tolerance is not None:
        return f"steps of tolerance {plan.tolerance:.3g} m"
    return f"steps of {1e3 * plan.dt:.3g} ms"
