"""The row about the largest force on what stands in the way: an edge, a karabiner, a post."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.record.body_loads import body_loads, is_apart, of_nodes
from ropewalk.record.extremes import SEEN, Extreme
from ropewalk.record.landings import Landing
from ropewalk.record.too_low import obstacle_too_low

if TYPE_CHECKING:
    from ropewalk.record.result import Result

_TITLE = "largest force on an obstacle"
_FEW = 8  # frames that are looked at for a sweep, those in which nodes are pressed most


class Pressed(NamedTuple):
    """The largest force of the ropes on one obstacle that does not turn freely, in recorded frames."""

    name: str  # of the obstacle
    frame: int
    force: float  # [N]


def pressed_rows(result: Result, tension: Extreme, landings: Sequence[Landing]) -> dict[str, Any]:
    """Return the largest force of the ropes on one obstacle that does not turn freely; {} without any.

    `tension` is the run's largest, `landings` those of ropes' ends.
    What a shape as it is drawn presses at the start does not count, as it is no load, unless it is at rest.
    """
    found = _largest(result, few=False)
    if found is None:
        return {}
    stop = "; of rigid links it may be momentum over a step" if _is_hard(result) else ""
    at = f"obstacle {found.name!r}, t = {result.time[found.frame]:.6g} s, {SEEN}{stop}"
    told = {f"{_TITLE} [N]": found.force, f"{_TITLE} at": at}
    note = _note(result, found, tension, landings)[1]
    return told | ({"about the largest force on an obstacle": note} if note else {})


def pressed_kind(result: Result, tension: Extreme, landings: Sequence[Landing]) -> str:
    """Return the kind of what `pressed_rows` says of that force, "" of nothing.

    Of several obstacles, where no end lands, `_FEW` frames are looked at: all take a third of a short run.
    """
    found = _largest(result, few=not landings)
    return _note(result, found, tension, landings)[0] if found is not None else ""


def _note(
    result: Result, found: Pressed, tension: Extreme, landings: Sequence[Landing]
) -> tuple[str, str]:
    if _is_hard(result):
        return "", ""

    def sizes(first: int, last: int) -> Floats:
        loads: Floats = body_loads(result, range(first, last), [found.name])[:, 0]
        return loads

    return obstacle_too_low(result, found.frame, sizes, tension, landings)


def _is_hard(result: Result) -> bool:
    return any(rope.rigid for rope in result.scene.ropes)


def _largest(result: Result, *, few: bool) -> Pressed | None:
    """Return the largest force; None where nothing presses. `few`: of several obstacles in few frames."""
    names = [one.name for one in result.scene.obstacles if one.name not in result.layout.pulleys]
    if not names or "contact_force" not in result.source.names:
        return None
    first = 0 if result.scene.run.start == "at-rest" else 1
    if result.good_frames <= first:
        return None
    pieces = [range(result.good_frames)]
    if few and not (len(result.scene.obstacles) == 1 and is_apart(result)):
        pieces = [range(max(k - 1, 0), k + 1) for k in _most_pressed(result, first)]
    best: Pressed | None = None
    for frames in pieces:
        loads = body_loads(result, frames, names)
        skip = max(first - frames.start, 0)
        at, row = divmod(int(np.argmax(loads[skip:])), len(names))
        most = float(loads[at + skip, row])
        if most > (best.force if best else 0.0):
            best = Pressed(names[row], frames.start + at + skip, most)
    return best


def _most_pressed(result: Result, first: int) -> list[int]:
    """Return the frames from `first` on with the largest sums of the forces on nodes, a few at most."""
    force = np.nan_to_num(result.read(of_nodes(result), first, result.good_frames))
    sums = np.sqrt(np.einsum("fnk,fnk->fn", force, force)).sum(axis=1)
    return [first + k for k in np.argsort(-sums, kind="stable")[:_FEW].tolist() if sums[k] > 0.0]
