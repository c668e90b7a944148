"""How many steps what moves by itself takes for a swing, as anchors and obstacles do that shake or go round.

Steps see a motion at their ends and stages only: with too few of them to a swing they see another one, which
a rope then lies at rest on, or is carried away by. What friction takes off a rope on a table that is shaken
(12 and 60 Hz) was too small by 19 to 40 % with 4 steps, 5 to 20 % with 8, 0.6 to 5 % with 20, and 0.2 to 1 %
with 40.

A motion by a table has no period. It gets that of the sine of whose velocity's changes steps miss as much.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats, Ints
from ropewalk.motions.tabulated import cubic_rows
from ropewalk.scene import Scene, SceneError
from ropewalk.scene.faults import Fault
from ropewalk.scene.motions import Motion, Orbit, Shake, Table
from ropewalk.words.safe_side import rounded_down

#: Automatic steps to a swing [1]; of `adaptive`, which takes shorter ones where it has to, at least.
STEPS, LONGEST = 40.0, 20.0
#: Steps to a swing [1] with fewer of which `check` warns; of `adaptive`, whose error estimate sees the rest.
FEW, FEW_OF_ADAPTIVE = 20.0, 8.0
#: Steps to a swing [1] with fewer of which they see another one.
LEAST = 4.0
_ROUNDING = 1e-9  # [1]
_SAMPLES = 8  # to a row of a table
_MOST = 32.0  # ends of steps in a row that are looked at
_QUIET = 1e-4  # [1] of all changes of velocity: what rows make that are not looked into, together
_PHASES = np.arange(4) / 4.0  # of steps against a table
#: The share of a sine's changes of velocity that `FEW` steps to a swing see: the mean of cos(pi u / FEW).
_SEEN = FEW / math.pi * math.sin(math.pi / FEW)
_HALVINGS = 4  # between two lengths of which one is twice the other


class Swing(NamedTuple):
    """What swings, and how fast."""

    path: str  # in the scene
    name: str  # of its anchor or obstacle, with what it is
    value: str
    period: float  # [s]; of a table that of the sine that is as hard to follow
    exact: bool  # whether it is a sine


def swings(scene: Scene, until: float) -> Iterator[Swing]:
    """Yield what swings, or by a table may, before the time `until` [s]; an anchor while it holds."""
    for k, one in enumerate(scene.anchors):
        held = until if one.release_time is None else min(until, one.release_time)
        if held > 0.0 and (
            found := _of(f"anchor[{k}].motion", f"anchor {one.name!r}", one.motion, held)
        ):
            yield found
    for k, body in enumerate(scene.obstacles):
        if found := _of(f"obstacle[{k}].motion", f"obstacle {body.name!r}", body.motion, until):
            yield found
    for k, body in enumerate(scene.obstacles):
        spin = getattr(body, "spin", None)
        if spin is not None and spin.times:
            table = spin.as_motion()
            if found := _of(f"obstacle[{k}].spin", f"obstacle {body.name!r}", table, until):
                yield found


def _of(path: str, name: str, motion: Motion, until: float) -> Swing | None:
    match motion:
        case Shake() | Orbit():
            rate = abs(motion.frequency)
            return Swing(
                f"{path}.frequency", name, f"{motion.frequency:g} Hz", 1.0 / rate, exact=True
            )
        case Table():
            period = _known(motion, until)
            if period < math.inf:
                return Swing(path, name, "its table", period, exact=False)
    return None


@lru_cache(maxsize=64)
def _known(table: Table, until: float) -> float:
    return math.inf if table.interpolation == "linear" else period_of(cubic_rows(table), until)


def swinging_step(scene: Scene, until: float, steps: float = STEPS) -> float:
    """Return the step that so many to a swing make of the shortest one [s]; inf where nothing swings."""
    return min((one.period / steps for one in swings(scene, until)), default=math.inf)


def too_few(scene: Scene, method: str, step: float, until: float) -> Iterator[Swing]:
    """Yield what swings in so few steps [s] that it is followed badly."""
    few = FEW_OF_ADAPTIVE if method == "adaptive" else FEW
    for one in swings(scene, until):
        if one.period < few * step * (1.0 - _ROUNDING):
            yield one


def remedy(one: Swing) -> str:
    """Return which step to take."""
    return f"take a run.time_step of at most {rounded_down(one.period / STEPS, 3)} s"


def refuse_unseen(scene: Scene, step: float, until: float) -> None:
    """Raise SceneError for what shakes or goes round and swings in fewer than `LEAST` steps [s].

    By a table it may be noise that does: `check` tells of that.
    """
    faults = []
    for one in swings(scene, until):
        if one.exact and one.period < LEAST * step * (1.0 - _ROUNDING):
            rule = (
                f"is a swing in {1e3 * one.period:.4g} ms, which {one.name} makes in {one.period / step:.3g} "
                f"steps of {1e3 * step:.4g} ms: they see another motion than this one; {remedy(one)}, or auto"
            )
            faults.append(Fault(one.path, one.value, rule))
    if faults:
        raise SceneError(faults)


def period_of(rows: Floats, until: float) -> float:
    """Return the period of the sine that is as hard to follow as a table (see `cubic_rows`) up to a time [s].

    inf: velocities jump at its times only, where steps are cut, or do not change.
    """
    last = min(until, float(rows[-1, 0]))
    first = float(rows[0, 0])
    if last <= first or not (rows[:-1, 3::4].any() or rows[:-1, 4::4].any()):
        return math.inf
    inside = rows[:-1, 0] < last
    pieces = rows[:-1][inside]
    ends = np.append(pieces[1:, 0], last)
    at = np.linspace(0.0, 1.0, _SAMPLES + 1) * (ends - pieces[:, 0])[:, None]
    own = _changes(pieces, np.repeat(np.arange(len(ends)), _SAMPLES + 1), at.ravel())
    changes = np.append(own, 0.0).reshape(len(ends), -1)[:, :-1].sum(axis=1)
    total = float(changes.sum())
    most = np.where(changes * len(ends) > _QUIET * total, _MOST, 2.0)
    step, least = last - first, float((ends - pieces[:, 0]).min()) / FEW
    while step > least and _seen(pieces, ends, most, step) < _SEEN * total:
        step *= 0.5
    low, high = step, 2.0 * step
    for _ in range(_HALVINGS):
        middle = math.sqrt(low * high)
        if _seen(pieces, ends, most, middle) < _SEEN * total:
            high = middle
        else:
            low = middle
    return FEW * low


def _seen(rows: Floats, ends: Floats, most: Floats, step: float) -> float:
    """Return what steps of a length [s] see of the changes of velocity [m/s], the mean of phases.

    Of the ends of steps in a row, which is over at `ends` (r,) [s], at most so many as `most` (r,) count:
    fewer see less, so that no step is found too long.
    """
    starts, found = rows[:, 0], 0.0
    border = np.append(starts, ends[-1]) - starts[0]
    for phase in _PHASES:
        border_at = np.maximum(np.ceil(border / step - phase), 0.0)
        count = np.diff(border_at)  # floats: so many as no integer can count, maybe
        taken = np.minimum(count, most).astype(np.int64)
        row = np.repeat(np.arange(len(rows)), taken)
        nth = np.arange(len(row)) - np.repeat(np.cumsum(taken) - taken, taken)
        stride = (count - 1.0) / np.maximum(taken - 1, 1)
        number = border_at[row] + np.floor(nth * stride[row])
        s = (number + phase) * step - border[row]
        row = np.concatenate([[0], row, [len(rows) - 1]])
        s = np.concatenate([[0.0], s, [ends[-1] - starts[-1]]])
        found += float(_changes(rows, row, s).sum())
    return found / _PHASES.size


def _changes(rows: Floats, row: Ints, s: Floats) -> Floats:
    """Return the changes of a table's velocity (t - 1,) [m/s] between times `s` [s] in rows `row` (t,)."""
    found = np.zeros(len(s) - 1)
    for k in range(3):
        c = rows[:, 4 * k + 2 : 4 * k + 5]
        v = c[row, 0] + s * (2.0 * c[row, 1] + 3.0 * s * c[row, 2])
        found += np.diff(v) ** 2
    return np.sqrt(found)
