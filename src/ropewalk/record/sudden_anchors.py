"""Anchors that start or stop at once: what sets their own node going counts as a force in one step.

Only in methods that do not cut steps there. By the momentum m dv of the held node over the step h it is
m dv / h: it grows as steps get shorter, and says nothing of what the rope bears.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.lowering.masses import line, masses
from ropewalk.methods.registry import METHODS
from ropewalk.motions.tabulated import cubic_rows
from ropewalk.record.extremes import Extreme
from ropewalk.scene.motions import Motion, Table, Velocity
from ropewalk.words.percents import percent

if TYPE_CHECKING:
    from ropewalk.record.result import Result

TOLD = 0.02  # [1] of an anchor's largest force, from which on it is told
ABOUT = 1.5  # steps: times of peaks are those of their ends


def started_note(result: Result, force: Extreme) -> str:
    """Say so where the largest anchor force is of its own node, set going or stopped at once; else ""."""
    if METHODS[result.plan.method].cuts or not force.value > 0.0:
        return ""
    anchor, step = result.scene.anchors[force.place], result.plan.dt
    jump = _largest_jump(anchor.motion, force.since - ABOUT * step, force.until + ABOUT * step)
    mass = _held_mass(result, result.layout.anchor_nodes[force.place])
    own = mass * jump / step
    if not own > TOLD * force.value:
        return ""
    share = f"{percent(100.0 * min(own / force.value, 1.0))} of it"
    return (
        f"the anchor starts or stops at once, by {jump:.4g} m/s: for its own node's {mass:.4g} kg that takes "
        f"{own:.4g} N over one step, up to {share}, which grows as steps get shorter and no rope bears; "
        "give it a table with cubic interpolation, or take another method"
    )


def _held_mass(result: Result, node: int) -> float:
    """Return the mass of an anchored node with all that joints tie to it [kg]."""
    mass = masses(result.layout, tuple(line(rope) for rope in result.scene.ropes))[0]
    tied, held = iter(result.layout.tied_nodes), [node]
    for joint in result.scene.joints:
        nodes = [next(tied) for _ in joint.points]
        held = nodes if node in nodes else held
    return float(mass[held].sum())


def _largest_jump(motion: Motion, since: float, until: float) -> float:
    """Return the largest jump of a motion's velocity in an interval [s] [m/s]."""
    if isinstance(motion, Velocity):
        sudden = since <= motion.start <= until or since <= motion.stop <= until
        return math.hypot(*motion.velocity) if sudden else 0.0
    if not isinstance(motion, Table):
        return 0.0
    rows = cubic_rows(motion)
    after, before = np.zeros((len(rows), 3)), np.zeros((len(rows), 3))
    after[:-1] = rows[:-1, 2::4]
    width = np.diff(rows[:, 0])[:, None]
    before[1:] = rows[:-1, 2::4] + width * (2.0 * rows[:-1, 3::4] + 3.0 * width * rows[:-1, 4::4])
    there = (rows[:, 0] >= since) & (rows[:, 0] <= until)
    sizes: Floats = np.linalg.norm(after - before, axis=1)[there]
    return float(sizes.max(initial=0.0))
