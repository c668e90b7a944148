"""What forces are where nothing gives: a bound of the stretch limiter, or a rigid link, stops what moves.

It does so within a step or two, by momentum over step: that force says nothing of a rope's.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ropewalk.record.extremes import Extreme

if TYPE_CHECKING:
    from ropewalk.record.result import Result

SUDDEN = 2.0  # [1] times the forces there before and after: a peak that a stop has made
STEPS = 2  # in which what is stopped is stopped: a frame may be a step


def hard_note(result: Result, tension: Extreme, force: Extreme) -> str:
    """Say so where the largest tension or anchor force is of what nothing that gives has stopped; else ""."""
    limited, rigid = result.scene.limiter is not None, any(one.rigid for one in result.scene.ropes)
    if not (limited or rigid):
        return ""
    if not (_is_sudden(result, "tension", tension) or _is_sudden(result, "reactions", force)):
        return ""
    what = " or ".join(["a rigid link"] * rigid + ["a bound of the limiter"] * limited)
    instead = "a finite EA, or a curve" if rigid else "its EA, or a curve, in place of the limiter"
    return (
        f"{what} gives nothing: it stops what moves within a step. The largest tension and anchor force, and "
        "utilisation by them, are momentum over a step and grow as steps get shorter; for a rope's own peak "
        f"give it {instead}"
    )


def _is_sudden(result: Result, quantity: str, peak: Extreme) -> bool:
    """Tell whether a peak, of "tension" or "reactions", is far more than there was before and after it."""
    if not peak.value > 0.0:
        return False
    around = []
    for frame in (
        int(np.searchsorted(result.time, peak.since)) - STEPS,
        int(np.searchsorted(result.time, peak.until, "right")) - 1 + STEPS,
    ):
        if 0 <= frame < result.good_frames:
            there = result.read(quantity, frame, frame + 1)[0, peak.place]
            around.append(float(np.linalg.norm(there)))
    return bool(around) and peak.value > SUDDEN * max(around)
