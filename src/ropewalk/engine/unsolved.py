"""A step without solution: where the simulation then stands, and what to try."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from ropewalk.core.arrays import State
from ropewalk.engine.no_room import no_room
from ropewalk.engine.too_near import finer, one_of, refused_pair
from ropewalk.lowering import Layout, Model
from ropewalk.lowering.link_lengths import has_links, reaches
from ropewalk.methods import adaptive
from ropewalk.methods.controller import END, LONGEST, SHORTEST_STEP
from ropewalk.methods.part_lengths import MOST_HALVINGS, SMALLEST_PART
from ropewalk.methods.stage import Stage
from ropewalk.methods.stage_report import MISFIT, NODE, RESIDUAL, ROUNDING, SCALE, TIGHT, TIME

# Stable at any step by linear theory, but what a stiff rope's slack and taut segments feed into the fast
# modes stays in them, and grows.
RINGING = ("implicit-midpoint", "generalized-alpha")
CALMER = "bdf2 or esdirk3"
ALMOST_TAUT = (
    0.999  # a span of rigid links this near to their length [1] is why they have no solution
)

Clock = tuple[float, float, int]  # start [s], step [s], steps since


def standing(clock: Clock, scratch: Any) -> tuple[float, int]:
    """Return start [s] and steps of the clock at which the state stands after a step without solution.

    The parts of that step that were solved are done. The adaptive method goes to its last accepted step.
    """
    start, dt, _ = clock
    if isinstance(scratch, adaptive.AdaptiveScratch):
        scratch.here[:] = scratch.walk.ahead
        return float(scratch.walk.control[END]), 0
    end = float(scratch.stage.report[TIME])
    parts = round((end - start) / (dt * SMALLEST_PART)) - 1
    steps, rest = divmod(parts, 2**MOST_HALVINGS)
    return (start, steps) if rest == 0 else (start + parts * SMALLEST_PART * dt, 0)


def describe(model: Model, state: State, clock: Clock, scratch: Any) -> str:
    """Say where a method found no solution, and what to try; `clock` is that before the steps."""
    plan, layout, limiter = model.plan, model.layout, model.scene.limiter
    longest = limiter.max_stretch if limiter else math.inf
    if plan.tolerance is not None:
        return _describe_shortest(model, state, plan.tolerance, longest, scratch)
    start, dt, done = clock
    time = float(scratch.stage.report[TIME])
    step = done + max(1, math.ceil((time - start) / dt - done - 1e-9))
    refused = _refused(model, state)
    text = (
        f"{plan.method} found no solution of step {step} at t = {time:.6g} s, not even in "
        f"parts of {dt * SMALLEST_PART:.2g} s: {refused or _what_is_left(layout, state, scratch.stage)}"
    )
    if refused:
        return text
    if too_far := _too_far(layout, state, longest, scratch):
        return f"{text}: {too_far}"
    if plan.method in RINGING:
        return (
            f"{text}. {plan.method} keeps stiff segments ringing: take {CALMER}, or a shorter "
            "time_step."
        )
    return (
        f"{text}. Try a shorter time_step; look for anchors that jump or move apart, and for nodes "
        "thrown or pressed together at the start."
    )


def _refused(model: Model, state: State, longest: float = 0.0) -> str:
    """Say who were not let pass, see `refused_pair`, or have no room for it; "" where that was not it."""
    squeezed = no_room(model.system, state, model.layout, model.scene)
    return squeezed or refused_pair(state, model.layout, model.scene, model.plan, longest)


def _too_far(layout: Layout, state: State, longest: float, scratch: Any) -> str:
    """Say which anchors are too far apart for the rope between them, and what to do; "" for none."""
    for reach in reaches(layout, state, scratch.stage.x, longest):
        if reach.distance > ALMOST_TAUT * reach.length:
            way = "a larger max_stretch" if reach.stretches else "a finite stiffness"
            return f"{reach}. Keep the anchors nearer, or give the rope {way}."
    return ""


def _what_is_left(layout: Layout, state: State, stage: Stage) -> str:
    """Say where forces stay unbalanced or, where that is farther from solved, a length misfits."""
    report, off = stage.report, np.abs(stage.saddle.misfit)
    rope, index = layout.rope_of(int(report[NODE]))
    force = f"at node {index} of rope {rope!r} a force of {report[RESIDUAL]:.3g} N stays unbalanced"
    worst = int(np.argmax(off))
    rope, segment = layout.rope_of(worst)
    misfit = f"segment {segment} of rope {rope!r} is {off[worst]:.3g} m off"
    if has_links(state):
        return f"{force}, and {misfit} its length"
    if report[MISFIT] * (TIGHT * report[SCALE] + report[ROUNDING]) > report[RESIDUAL]:
        return f"{misfit} the length that its tension makes, and {force}"
    return force


def _of_error(layout: Layout, place: int) -> str:
    """Say where the adaptive method's error is the largest, see `controller.NODE`."""
    turning = -1 - place - layout.segments
    if turning >= 0:
        return f"pulley {layout.pulleys[turning]!r}"
    rope, index = layout.rope_of(place if place >= 0 else -1 - place)
    return f"{'node' if place >= 0 else 'segment'} {index} of rope {rope!r}"


def _describe_shortest(
    model: Model, state: State, tolerance: float, longest: float, scratch: Any
) -> str:
    """Say where the adaptive method found no step short enough, and what to try."""
    time, place, error = adaptive.failure(scratch)
    layout, taken = model.layout, float(scratch.walk.control[LONGEST])
    text = f"adaptive needs steps below {SHORTEST_STEP:g} s at t = {time:.6g} s"
    if refused := _refused(model, state, taken):
        return f"{text}: {refused}"
    if not math.isfinite(error):
        why, helps = _what_is_left(layout, state, scratch.stage), finer(model.plan, taken)
    else:
        why = f"at {_of_error(layout, place)} "
        why += f"its estimated error is {error:.3g} m, more than {tolerance:g} m"
        helps = ("a larger tolerance",)
    if too_far := _too_far(layout, state, longest, scratch):
        return f"{text}: {why}: {too_far}"
    return (
        f"{text}: {why}. Try {one_of(*helps)}; look for anchors that jump or move apart, and for nodes "
        "thrown or pressed together."
    )
