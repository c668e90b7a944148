"""Contacts of ropes with each other and themselves, as a table: who, where, with what force, how."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ropewalk.core.arrays import Floats, Ints
from ropewalk.lowering.touching import SLIPS as ALL
from ropewalk.lowering.touching import STILL
from ropewalk.record.contact_modes import SLIPS, STICKS, WORDS
from ropewalk.record.quantities import ROPE_CONTACTS as NAME

if TYPE_CHECKING:
    from ropewalk.record.result import Result
    from ropewalk.scene import Scene

HEADERS = (
    *("time [s]", "rope", "segment", "other rope", "other segment"),
    *("x [m]", "y [m]", "z [m]", "normal force [N]", "friction force [N]", "friction used [1]"),
    *("slip speed [m/s]", "friction power [W]", "mode"),
    *("fx [N]", "fy [N]", "fz [N]"),  # on the first of both
)


def rope_rows(result: Result, frames: Iterable[int], segments: Ints) -> list[NDArray[np.generic]]:
    """Return the columns of the table, of those contacts with one of some segments, at some frames."""
    numbers = np.fromiter(frames, np.int64)
    wanted = np.zeros(result.layout.segments, bool)
    wanted[segments] = True
    first, last = (int(numbers[0]), int(numbers[-1]) + 1) if numbers.size else (0, 0)
    names = (NAME, "positions", "velocities", "time")
    read = {name: result.read(name, first, last) for name in names}
    found = []
    for frame in numbers - first:
        kept = read[NAME][frame]
        kept = kept[np.isfinite(kept[:, 0])]
        pair = kept[:, :2].astype(np.int64)
        here = wanted[pair].any(axis=1)
        at = read["time"][frame], read["positions"][frame], read["velocities"][frame]
        found.append(_of_frame(result, *at, pair[here], kept[here]))
    return [np.concatenate(parts) for parts in zip(*found, strict=True)]


def _of_frame(
    result: Result, time: float, x: Floats, v: Floats, pair: Ints, kept: Floats
) -> tuple[NDArray[np.generic], ...]:
    first, second = _points(x, pair[:, 0], kept[:, 2]), _points(x, pair[:, 1], kept[:, 3])
    normal = first - second
    normal /= np.maximum(np.linalg.norm(normal, axis=1), 1e-300)[:, None]
    over = _points(v, pair[:, 0], kept[:, 2]) - _points(v, pair[:, 1], kept[:, 3])
    over -= (over * normal).sum(axis=1)[:, None] * normal
    push, force = kept[:, 4], kept[:, 5:8]
    rub = np.sqrt(np.maximum((force**2).sum(axis=1) - push**2, 0.0))
    rub[rub < 1e-7 * push] = 0.0  # what rounding leaves
    labels = [[result.layout.rope_of(int(j)) for j in side] for side in pair.T]
    whose = [np.array([name for name, _ in side], dtype=object) for side in labels]
    which = [np.array([number for _, number in side], np.int64) for side in labels]
    friction = _frictions(result.scene, *whose)
    most = friction * push
    used = np.divide(rub, most, out=np.zeros_like(rub), where=most > 0.0)
    speed = np.linalg.norm(over, axis=1)
    slips = (speed > STILL) & ((used >= ALL) | (friction == 0.0))
    across = force - (force * normal).sum(axis=1)[:, None] * normal
    return (
        *(np.full(len(pair), time), whose[0], which[0], whose[1], which[1]),
        *(0.5 * (first + second)).T,
        *(push, rub, used, speed, (across * over).sum(axis=1)),
        WORDS[np.where(slips, SLIPS, STICKS)],
        *force.T,
    )


def _frictions(scene: Scene, first: Iterable[str], second: Iterable[str]) -> Floats:
    """Return the coefficients of friction of ropes by name, (c,) [1]."""
    if scene.contact is None:
        return np.zeros(len(list(first)))
    place = {rope.name: number for number, rope in enumerate(scene.ropes)}
    one, other = (np.array([place[name] for name in side], np.int64) for side in (first, second))
    return scene.contact.frictions_of(scene.ropes, one, other)


def _points(values: Floats, segments: Ints, at: Floats) -> Floats:
    """Return what nodes have, (n, 3), at places on segments, 0 to 1."""
    found: Floats = (1.0 - at)[:, None] * values[segments] + at[:, None] * values[segments + 1]
    return found


def modes_on_ropes(result: Result, frames: Sequence[int]) -> NDArray[np.int8]:
    """Return what the nodes of segments that lie on ropes do, (frames, nodes), by place in MODES."""
    found = np.zeros((len(frames), result.layout.nodes), np.int8)
    if NAME not in result.source.names:
        return found
    every = np.arange(result.layout.segments)
    for row, frame in enumerate(map(int, frames)):
        columns = dict(zip(HEADERS, rope_rows(result, [frame], every), strict=True))
        modes = np.where(columns["mode"] == WORDS[SLIPS], SLIPS, STICKS).astype(np.int8)
        kept = result.read(NAME, frame, frame + 1)[0]
        pair = kept[np.isfinite(kept[:, 0]), :2].astype(np.int64)
        for side in pair.T:
            np.maximum.at(found[row], side, modes)
            np.maximum.at(found[row], side + 1, modes)
    return found


def pressed_by_ropes(result: Result, frame: int) -> Floats:
    """Return the sum of the normal forces of ropes on every node at a frame, (nodes,) [N].

    That of a contact goes to both nodes of each of its segments, as it lies between them.
    """
    found = np.zeros(result.layout.nodes)
    if NAME not in result.source.names:
        return found
    kept = result.read(NAME, frame, frame + 1)[0]
    kept = kept[np.isfinite(kept[:, 0])]
    for segments, at in zip(kept[:, :2].astype(np.int64).T, kept[:, 2:4].T, strict=True):
        np.add.at(found, segments, (1.0 - at) * kept[:, 4])
        np.add.at(found, segments + 1, at * kept[:, 4])
    return found
