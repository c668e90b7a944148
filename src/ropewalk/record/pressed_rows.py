"""The rows about the largest force on what stands in the way: an edge, a post, the axle of a pulley."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.record.body_loads import body_loads, is_apart, of_nodes
from ropewalk.record.extremes import SEEN, Extreme
from ropewalk.record.facts import AT_REST
from ropewalk.record.landings import Landing
from ropewalk.record.quantities import PRESSED
from ropewalk.record.too_low import obstacle_too_low

if TYPE_CHECKING:
    from ropewalk.record.result import Result

BODY, AXLE = "largest force on an obstacle", "largest load on the axle of a pulley"
_FEW = 8  # frames that are looked at for a sweep, those in which nodes are pressed most
_TOGETHER = "at most: the greatest of each of the ropes that move by themselves, added up"


class Pressed(NamedTuple):
    """The largest force of the ropes on one of some obstacles: of every step, or of the recorded frames."""

    name: str  # of the obstacle
    frame: int  # it was not after this one, and after the one before
    force: float  # [N]
    time: float  # [s]; NaN: ropes that move by themselves had each their greatest at times of their own
    before: float  # [N] the least in the three steps before; NaN: of frames, or not known
    every_step: bool

    def when(self, result: Result) -> str:
        """Return when it was, in words, and of what it is the largest."""
        last = float(result.time[self.frame])
        if self.every_step and math.isnan(self.time):
            first = float(result.time[max(self.frame - 1, 0)])
            return f"t from {first:.6g} to {last:.6g} s, {_TOGETHER}"
        return f"t = {self.time:.6g} s" + ("" if self.every_step else f", {SEEN}")


def pressed_rows(result: Result, tension: Extreme, landings: Sequence[Landing]) -> dict[str, Any]:
    """Return the largest force of the ropes on one obstacle that does not turn freely, and on an axle.

    `tension` is the run's largest, `landings` those of ropes' ends.
    What a shape as it is drawn presses at the start does not count, as it is no load, unless it is at rest.
    """
    told: dict[str, Any] = {}
    for title, names in _named(result).items():
        found = largest(result, names)
        if found is None:
            continue
        stop = "; of rigid links it may be momentum over a step" if _is_hard(result) else ""
        told[f"{title} [N]"] = found.force
        told[f"{title} at"] = _place(title, found.name, f", {found.when(result)}{stop}")
        if note := _note(result, found, tension, landings)[1]:
            told[f"about the {title}"] = note
    return told


def pressed_rows_at_rest(result: Result) -> dict[str, Any]:
    """Return the largest force of ropes at rest on one obstacle that does not turn freely, and on an axle."""
    told: dict[str, Any] = {}
    if "contact_force" not in result.source.names:
        return told
    for title, names in _named(result).items():
        load = body_loads(result, range(1), names)[0]
        row = int(np.argmax(load))
        if load[row] > 0.0:
            told[f"{title} [N]"] = float(load[row])
            told[f"{title} at"] = _place(title, names[row])
    return told


def _place(title: str, name: str, when: str = "") -> str:
    """Return what is pressed, in words, and when."""
    if title == AXLE:
        return f"pulley {name!r}{when}; its own weight is not in it"
    return f"obstacle {name!r}{when}"


def pressed_kinds(result: Result, tension: Extreme, landings: Sequence[Landing]) -> Iterator[str]:
    """Yield the kinds of what `pressed_rows` says.

    Of several obstacles in a run that has kept frames alone, where no end lands, `_FEW` frames are looked
    at: all take a third of a short run.
    """
    for names in _named(result).values():
        found = largest(result, names, few=not landings)
        if found is not None:
            yield _note(result, found, tension, landings)[0]


def _named(result: Result) -> dict[str, list[str]]:
    """Return the names of obstacles by what a table calls the largest force on them."""
    pulleys = result.layout.pulleys
    bodies = [one.name for one in result.scene.obstacles if one.name not in pulleys]
    return {title: names for title, names in ((BODY, bodies), (AXLE, list(pulleys))) if names}


def _note(
    result: Result, found: Pressed, tension: Extreme, landings: Sequence[Landing]
) -> tuple[str, str]:
    if _is_hard(result):
        return "", ""

    def sizes(first: int, last: int) -> Floats:
        loads: Floats = body_loads(result, range(first, last), [found.name])[:, 0]
        return loads

    return obstacle_too_low(result, found, sizes, tension, landings)


def _is_hard(result: Result) -> bool:
    return any(rope.rigid for rope in result.scene.ropes)


def largest(result: Result, names: list[str], *, few: bool = False) -> Pressed | None:
    """Return the largest force on one of these obstacles; None where nothing presses.

    Of every step where the run has kept that, at the ends of steps. `few`: of several obstacles in few
    frames, where it has not.
    """
    if "contact_force" not in result.source.names:
        return None
    if PRESSED[0] not in result.source.names:
        return _of_frames(result, names, few=few)
    found = _of_steps(result, names)
    if result.scene.run.start == "at-rest" and result.good_frames:  # no step ends with that one
        load = body_loads(result, range(1), names)[0]
        if load.max() > (found.force if found else 0.0):
            row = int(load.argmax())
            first = float(result.time[0])
            return Pressed(names[row], 0, float(load[row]), first, math.nan, True)
    return found


def _of_steps(result: Result, names: list[str]) -> Pressed | None:
    """Return the largest force of all steps."""
    rows = [result.layout.surfaces.index(name) for name in names]
    force, time, before = (result.read(one, 0, result.good_frames)[:, rows] for one in PRESSED)
    force = np.where(np.isfinite(force), force, 0.0)
    frame, row = divmod(int(np.argmax(force)), len(rows)) if force.size else (0, 0)
    if not force.size or not force[frame, row] > 0.0:
        return None
    values = float(force[frame, row]), float(time[frame, row]), float(before[frame, row])
    return Pressed(names[row], frame, *values, True)


def loads_of_steps(result: Result, force: Floats, names: Sequence[str]) -> Floats:
    """Return the greatest force on obstacles of these names since the frame before, (frames, names) [N].

    `force` is what the run has kept of that, (frames, surfaces). Where it starts at rest its first frame
    counts, as that of an equilibrium; a shape as it is drawn does not, as in a run's table.
    """
    found: Floats = force[:, [result.layout.surfaces.index(name) for name in names]]
    rests = result.status == AT_REST or result.scene.run.start == "at-rest"
    if rests and len(found):
        found[0] = np.fmax(found[0], body_loads(result, range(1), names)[0])
    return found


def _of_frames(result: Result, names: list[str], *, few: bool) -> Pressed | None:
    """Return the largest force of the recorded frames."""
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
            frame = frames.start + at + skip
            best = Pressed(names[row], frame, most, float(result.time[frame]), math.nan, False)
    return best


def _most_pressed(result: Result, first: int) -> list[int]:
    """Return the frames from `first` on with the largest sums of the forces on nodes, a few at most."""
    force = np.nan_to_num(result.read(of_nodes(result), first, result.good_frames))
    sums = np.sqrt(np.einsum("fnk,fnk->fn", force, force)).sum(axis=1)
    return [first + k for k in np.argsort(-sums, kind="stable")[:_FEW].tolist() if sums[k] > 0.0]
