"""What forces are where nothing gives: a bound of the stretch limiter, or a rigid link, stops what moves.

It does so within a step or two, by momentum over step: that force says nothing of a rope's.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ropewalk.record.extremes import Extreme

if TYPE_CHECKING:
    from ropewalk.record.result import Result

NEAR = 1e-6  # [1] of a bound: a stretch that is at it
SUDDEN = 2.0  # [1] times the forces there before and after: a peak that a stop has made
STEPS = 2  # in which what is stopped is stopped: a frame may be a step


def hard_note(result: Result, found: dict[str, Extreme]) -> str:
    """Say so where the largest tension or anchor force is of what nothing that gives has stopped; else "".

    `found` are the run's extremes by their names.
    """
    tension, force = found["greatest tension"], found["greatest anchor force"]
    limiter, longest = result.scene.limiter, found["greatest stretch"].value
    reached = limiter is not None and longest > limiter.max_stretch * (1.0 - NEAR)
    if not reached and not any(rope.rigid for rope in result.scene.ropes):
        return ""
    for quantity, peak, node in (
        ("tension", tension, tension.place),
        ("reactions", force, result.layout.anchor_nodes[force.place] if force.value > 0.0 else 0),
    ):
        if not peak.value > 0.0:
            continue
        name, _ = result.layout.rope_of(node)
        rope = next(rope for rope in result.scene.ropes if rope.name == name)
        what = "a rigid link" if rope.rigid else "a bound of the limiter"
        hard = rope.made_of.tension_only if rope.rigid else reached
        if not (hard and _is_sudden(result, quantity, peak)):
            continue
        instead = "a finite EA, or a curve" if rope.rigid else "its EA, or a curve, for the limiter"
        return (
            f"{what} gives nothing: it stops what moves within a step. The largest tension and anchor force, "
            "and utilisation by them, are momentum over a step and grow as steps get shorter; for a rope's "
            f"own peak give it {instead}"
        )
    return ""


def _is_sudden(result: Result, quantity: str, peak: Extreme) -> bool:
    """Tell whether a peak, of "tension" or "reactions", is far more than there was before and after it."""
    before = int(np.searchsorted(result.time, peak.since)) - STEPS
    after = int(np.searchsorted(result.time, peak.until, "right")) - 1 + STEPS
    around = []
    for frame in (max(before, 0), min(after, result.good_frames - 1)):
        there = result.read(quantity, frame, frame + 1)[0, peak.place]
        around.append(float(np.linalg.norm(there)))
    return peak.value > SUDDEN * max(around)
