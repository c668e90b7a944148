"""How a run broke: single steps past its last good frame, kept apart from what counts."""

from __future__ import annotations

import io
from collections import deque
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.core.status import UNSOLVED
from ropewalk.lowering import Layout
from ropewalk.record.errors import RunError
from ropewalk.record.files import reading, write
from ropewalk.record.place import BEYOND as NAME
from ropewalk.simulation import Simulation

if TYPE_CHECKING:
    from ropewalk.record.result import Result

_APART = 10.0  # [1] times the longest segment: torn, though made-up energy was found before
_FRAMES = 10  # so many at most are looked at past the last good one ...
_STEPS = 20_000  # ... and so many steps
_KEPT = 64  # steps, the last before the rope is torn apart
_NUMBERS = 3_000_000  # coordinates kept
_TORN = (1.5, 3.0)  # [1] longest segment of a broken shape that is drawn, over that before


@dataclass(frozen=True)
class Beyond:
    """Single steps of a run past its last good frame, up to where the rope is torn apart.

    They show how it broke, and nothing else: no number of the rope's is to be taken from them.
    """

    time: Floats  # (k,) [s]
    positions: Floats  # (k, n, 3) [m]; finite, but NaN of ropes that went on
    tension: Floats | None = None  # (k, s) [N], as large as it got; None in folders that lack it


class Torn(NamedTuple):
    """Single steps past the last good frame of a run, as far as the rope is not torn apart."""

    time: Floats  # (k,) [s]
    positions: Floats  # (k, n, 3) [m]
    tension: Floats | None  # (k, s) [N]; None in run folders that did not keep it
    shapes: list[int]  # one or two of the steps, those that show the break best
    last: int  # the frame that they follow on


def until_torn(result: Result) -> Torn | None:
    """Return the steps past a result's break that can be drawn; None where it has none.

    They end with the last one in which no segment is longer than three times the longest before; of the
    `shapes` the first is the last one below one and a half times. Raises RunError when the run folder's
    copy is damaged.
    """
    beyond = result.beyond
    if beyond is None:
        return None
    last = result.ends[0].frames - 1 if result.ends else result.frames - 1
    return cut(beyond, result.read("positions", last, last + 1)[0], last)


def cut(beyond: Beyond, before: Floats, last: int = 0) -> Torn:
    """Return the steps that can be drawn, of a rope that lay at `before` [m], (n, 3), when it broke."""
    before = np.where(np.isnan(beyond.positions[0]), np.nan, before)
    usual, longest = float(_longest(before[None])[0]), _longest(beyond.positions)
    chosen = [np.flatnonzero(longest <= factor * usual) for factor in _TORN]
    rows = sorted({int(found[-1]) if found.size else 0 for found in chosen})
    end = rows[-1] + 1
    tension = None if beyond.tension is None else beyond.tension[:end]
    return Torn(beyond.time[:end], beyond.positions[:end], tension, rows, last)


def _longest(positions: Floats) -> Floats:
    """Return the longest distance of two neighbours [m], (f,)."""
    with np.errstate(all="ignore"):
        apart = np.linalg.norm(np.diff(positions, axis=1), axis=2)
        size: Floats = np.nanmax(apart, axis=1)
    return size


def look_beyond(simulation: Simulation, whole: Simulation | None = None) -> Beyond | None:
    """Step a simulation that stands at its last good frame on into its break; leave it as it stands.

    With a `whole` one it is that of some of its ropes; of the others everything is NaN then.
    Ends early where the whole simulation's slices are asked to.
    """
    here, plan, whole = simulation.state, simulation.plan, whole or simulation
    told = simulation.failure, simulation.reason
    most = max(2, min(_KEPT, _NUMBERS // (3 * simulation.layout.nodes)))
    apart = _APART * float(_longest(simulation.positions[None])[0])
    seen: deque[tuple[float, Floats, Floats]] = deque(maxlen=most)
    for _ in range(min(_FRAMES * plan.steps_per_frame, _STEPS)):
        if whole.slices.is_asked():
            break
        status = simulation.advance_steps(1)
        positions = simulation.positions.copy()
        if not np.isfinite(positions).all():
            break
        with np.errstate(all="ignore"):
            tension = simulation.recording().recording.tension[0].copy()
        seen.append((simulation.time, positions, tension))
        if status == UNSOLVED or not _longest(positions[None])[0] <= apart:
            break
    simulation.restore(here)
    simulation.failure, simulation.reason = told
    if not seen:
        return None
    time, x, tensions = (np.array(part) for part in zip(*seen, strict=True))
    return Beyond(time, *_in_whole(x, tensions, simulation.layout, whole.layout))


def _in_whole(x: Floats, tension: Floats, own: Layout, whole: Layout) -> tuple[Floats, Floats]:
    """Return positions and tensions of some ropes in arrays of all; NaN stands for the others."""
    if own.nodes == whole.nodes:
        return x, tension
    places = np.full((len(x), whole.nodes, 3), np.nan)
    pulls = np.full((len(x), whole.segments), np.nan)
    for here in own.ropes:
        there = whole.span(here.name)
        places[:, there.first : there.last + 1] = x[:, here.first : here.last + 1]
        pulls[:, there.first : there.last] = tension[:, here.first : here.last]
    return places, pulls


def save(folder: Path, beyond: Beyond) -> None:
    """Write it into a run folder. Raises OSError."""
    data = io.BytesIO()
    parts = {"time": beyond.time, "positions": beyond.positions}
    if beyond.tension is not None:
        parts["tension"] = beyond.tension
    np.savez(data, allow_pickle=False, **parts)
    write(folder / NAME, data.getvalue())


def load(folder: Path) -> Beyond | None:
    """Read it from a run folder; None where there is none. Raises RunError when it is damaged."""
    path = folder / NAME
    if not path.exists():
        return None
    with reading(path):
        data = path.read_bytes()
    try:
        with np.load(io.BytesIO(data), allow_pickle=False) as archive:
            tension = archive.get("tension")
            return Beyond(archive["time"], archive["positions"], tension)
    except Exception as error:  # a damaged header of numpy's or of zip's can raise nearly anything
        raise RunError(path, f"is damaged: {error}") from None
