"""The row about the largest force on what stands in the way: an edge, a karabiner, a post."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.record.extremes import SEEN
from ropewalk.record.moving_rows import body_loads
from ropewalk.record.quantities import OBSTACLE_FORCE

if TYPE_CHECKING:
    from ropewalk.record.result import Result

_PIECE = 256  # frames that are read at once
_FRAMES = 24  # of which the contacts are looked at one by one
_TITLE = "largest force on an obstacle"


def pressed_rows(result: Result) -> dict[str, Any]:
    """Return the largest force of the ropes on one obstacle that does not turn freely; {} without any.

    Frames are looked at from the one on that can have most, until the next cannot have more than was found.
    What a shape as it is drawn presses at the start does not count, as it is no load, unless it is at rest.
    """
    scene, pulleys = result.scene, result.layout.pulleys
    names = [one.name for one in scene.obstacles if one.name not in pulleys]
    if not names or "contact_force" not in result.source.names:
        return {}
    bounds = _bounds(result)
    if scene.run.start != "at-rest":
        bounds[:1] = 0.0
    most, where, seen = 0.0, (0, ""), SEEN
    for count, frame in enumerate(np.argsort(-bounds, kind="stable").tolist()):
        if not bounds[frame] > most:
            break
        if count == _FRAMES:
            seen = f"of the {_FRAMES} recorded frames with the largest forces in all"
            break
        loads = body_loads(result, [frame], names)[0]
        if loads.max() > most:
            most, where = float(loads.max()), (frame, names[int(loads.argmax())])
    if not most > 0.0:
        return {}
    hard = any(rope.rigid for rope in scene.ropes)
    stop = "; of rigid links it may be momentum over a step" if hard else ""
    at = f"obstacle {where[1]!r}, t = {result.time[where[0]]:.6g} s, {seen}{stop}"
    return {f"{_TITLE} [N]": most, f"{_TITLE} at": at}


def _bounds(result: Result) -> Floats:
    """Return what no obstacle bears more than, (frames,) [N]; of one that is alone what it bears.

    The sums of the sizes of forces on nodes, or the size of their sum, where none is of another body or rope.
    """
    apart = OBSTACLE_FORCE in result.source.names
    name = OBSTACLE_FORCE if apart else "contact_force"
    alone = len(result.scene.obstacles) == 1 and (apart or result.scene.contact is None)
    found = list[Floats]()
    for first in range(0, result.good_frames, _PIECE):
        # NaN: of a rope that broke, where others go on
        force = np.nan_to_num(result.read(name, first, min(first + _PIECE, result.good_frames)))
        if alone:
            found.append(np.linalg.norm(force.sum(axis=1), axis=1))
        else:
            found.append(np.linalg.norm(force, axis=2).sum(axis=1))
    return np.concatenate(found)
