"""The row about the largest force on what stands in the way: an edge, a karabiner, a post."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from ropewalk.record.body_loads import body_loads
from ropewalk.record.extremes import SEEN, Extreme
from ropewalk.record.landings import Landing
from ropewalk.record.too_low import obstacle_too_low

if TYPE_CHECKING:
    from ropewalk.record.result import Result

_TITLE = "largest force on an obstacle"


def pressed_rows(result: Result, tension: Extreme, landings: Sequence[Landing]) -> dict[str, Any]:
    """Return the largest force of the ropes on one obstacle that does not turn freely; {} without any.

    `tension` is the run's largest, `landings` those of ropes' ends.
    What a shape as it is drawn presses at the start does not count, as it is no load, unless it is at rest.
    """
    scene, pulleys = result.scene, result.layout.pulleys
    names = [one.name for one in scene.obstacles if one.name not in pulleys]
    if not names or "contact_force" not in result.source.names:
        return {}
    loads = body_loads(result, range(result.good_frames), names)
    first = 0 if scene.run.start == "at-rest" else 1
    if len(loads) <= first:
        return {}
    frame, row = divmod(int(np.argmax(loads[first:])), len(names))
    frame += first
    most = float(loads[frame, row])
    if not most > 0.0:
        return {}
    hard = any(rope.rigid for rope in scene.ropes)
    stop = "; of rigid links it may be momentum over a step" if hard else ""
    at = f"obstacle {names[row]!r}, t = {result.time[frame]:.6g} s, {SEEN}{stop}"
    told = {f"{_TITLE} [N]": most, f"{_TITLE} at": at}
    note = "" if hard else obstacle_too_low(result, loads[:, row], frame, tension, landings)
    return told | ({"about the largest force on an obstacle": note} if note else {})
