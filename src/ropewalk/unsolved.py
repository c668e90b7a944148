"""A step without solution: where the simulation then stands, and what to try."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from ropewalk.build import Layout, Plan
from ropewalk.build.links import has_links, reaches
from ropewalk.core.arrays import State
from ropewalk.methods import adaptive
from ropewalk.methods.controller import END, SHORTEST_STEP
from ropewalk.methods.implicit import MOST_HALVINGS, SMALLEST_PART, unsolved

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
    end, _, _ = unsolved(scratch)
    parts = round((end - start) / (dt * SMALLEST_PART)) - 1
    steps, rest = divmod(parts, 2**MOST_HALVINGS)
    return (start, steps) if rest == 0 else (start + parts * SMALLEST_PART * dt, 0)


def describe(plan: Plan, layout: Layout, state: State, clock: Clock, scratch: Any) -> str:
    """Say where a method found no solution, and what to try; `clock` is that before the steps."""
    if plan.tolerance is not None:
        return _describe_shortest(layout, plan.tolerance, scratch)
    start, dt, done = clock
    time, node, residual = unsolved(scratch)
    step = done + max(1, math.ceil((time - start) / dt - done - 1e-9))
    rope, index = layout.rope_of(node)
    text = (
        f"{plan.method} found no solution of step {step} at t = {time:.6g} s, not even in "
        f"parts of {dt * SMALLEST_PART:.2g} s: at node {index} of rope {rope!r} a force of "
        f"{residual:.3g} N stays unbalanced"
    )
    stage = scratch.stage
    off = np.abs(stage.saddle.misfit)
    if has_links(state):
        rope, segment = layout.rope_of(int(np.argmax(off)))
        text += f", and segment {segment} of rope {rope!r} is {off.max():.3g} m off its length"
    for reach in reaches(layout, state, stage.x):
        if reach.distance > ALMOST_TAUT * reach.length:
            return f"{text}: {reach}. Keep the anchors nearer, or give the rope a finite stiffness."
    if plan.method in RINGING:
        return (
            f"{text}. {plan.method} keeps stiff segments ringing: take {CALMER}, or a shorter "
            "time_step."
        )
    return (
        f"{text}. Try a shorter time_step; look for anchors that jump or move apart, and for nodes "
        "thrown or pressed together at the start."
    )


def _describe_shortest(layout: Layout, tolerance: float, scratch: Any) -> str:
    """Say where the adaptive method found no step short enough, and what to try."""
    time, node, error = adaptive.failure(scratch)
    if not math.isfinite(error):
        _, node, residual = unsolved(scratch)
        why = f"a force of {residual:.3g} N stays unbalanced"
    else:
        why = f"its estimated error is {error:.3g} m, more than {tolerance:g} m"
    rope, index = layout.rope_of(node)
    return (
        f"adaptive needs steps below {SHORTEST_STEP:g} s at t = {time:.6g} s: at node {index} of rope "
        f"{rope!r} {why}. Try a larger tolerance; look for anchors that jump or move apart, and for "
        "nodes thrown or pressed together."
    )
