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
from ropewalk.record.tension_notes import is_pressed
from ropewalk.scene.motions import Motion, Table, Velocity

if TYPE_CHECKING:
    from ropewalk.record.result import Result

TOLD = 0.02  # [1] of an anchor's largest force, from which on it is told
ABOUT = 1.5  # steps: times of peaks are those of their ends


def started_note(result: Result, force: Extreme) -> str:
    """Say so where the largest anchor force is of its own node, set going or stopped at once; else "".

    It is where the motion jumps then, and no rope beside it bears as much. A held node begins with its
    anchor's velocity: nothing jumps at time zero.
    """
    if METHODS[result.plan.method].cuts or not force.value > 0.0:
        return ""
    anchor, step = result.scene.anchors[force.place], result.plan.dt
    jump = _largest_jump(anchor.motion, force.since - ABOUT * step, force.until + ABOUT * step)
    held = _held(result, result.layout.anchor_nodes[force.place])
    if not jump > 0.0 or any(is_pressed(result, node, force.until) for node in held):
        return ""
    mass = float(
        masses(result.layout, tuple(line(rope) for rope in result.scene.ropes))[0][held].sum()
    )
    borne = _borne(result, held, force)
    if not force.value - borne - mass * math.hypot(*result.scene.gravity) > TOLD * force.value:
        return ""
    return (
        f"ropes at its node bear {borne:.4g} N then, at most: the anchor starts or stops at once, by "
        f"{jump:.4g} m/s, and what that takes of the node's own {mass:.4g} kg counts as a force over one "
        "step, which grows as steps get shorter; let its speed change bit by bit, by more rows of a table, "
        "or take another method"
    )


def _held(result: Result, node: int) -> list[int]:
    """Return an anchored node with all that joints tie to it."""
    tied = iter(result.layout.tied_nodes)
    groups = [[next(tied) for _ in joint.points] for joint in result.scene.joints]
    return next((group for group in groups if node in group), [node])


def _borne(result: Result, nodes: list[int], force: Extreme) -> float:
    """Return the most that the segments at these nodes pull or push in the frames of a peak, added up [N]."""
    first = max(int(np.searchsorted(result.time, force.since)) - 1, 0)
    last = min(int(np.searchsorted(result.time, force.until)) + 1, result.good_frames - 1)
    ends = {span.first for span in result.layout.ropes}, {span.last for span in result.layout.ropes}
    beside = {node - 1 for node in nodes if node not in ends[0]}
    beside |= {node for node in nodes if node not in ends[1]}
    found = 0.0
    for name in ("greatest_tension", "least_tension"):
        there = np.abs(result.read(name, first, last + 1)[:, sorted(beside)])
        found = max(found, float(np.nan_to_num(there).max(axis=0).sum()))
    return found


def _largest_jump(motion: Motion, since: float, until: float) -> float:
    """Return the largest jump of a motion's velocity in an interval [s] [m/s]."""
    if isinstance(motion, Velocity):
        sudden = any(time > 0.0 and since <= time <= until for time in (motion.start, motion.stop))
        return math.hypot(*motion.velocity) if sudden else 0.0
    if not isinstance(motion, Table):
        return 0.0
    rows = cubic_rows(motion)
    after, before = np.zeros((len(rows), 3)), np.zeros((len(rows), 3))
    after[:-1] = rows[:-1, 2::4]
    width = np.diff(rows[:, 0])[:, None]
    before[1:] = rows[:-1, 2::4] + width * (2.0 * rows[:-1, 3::4] + 3.0 * width * rows[:-1, 4::4])
    there = (rows[:, 0] >= since) & (rows[:, 0] <= until) & (rows[:, 0] > 0.0)
    sizes: Floats = np.linalg.norm(after - before, axis=1)[there]
    return float(sizes.max(initial=0.0))
