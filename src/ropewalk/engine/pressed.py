"""The greatest force on obstacles of ropes that move by themselves, each with steps of its own.

Of what one island presses alone the greatest is known, and when it was. Of several each has its own greatest,
at times of its own: their sum is as much as it can have been at most.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ropewalk.core.arrays import Floats, Ints, State
from ropewalk.core.peaks import BEFORE, SQUARE, WHEN, root_of
from ropewalk.methods.recording import Recording

_FIELDS = ("pressed_high", "pressed_time", "pressed_before")


def add_pressed(
    out: Recording, frames: int, made: Sequence[Recording], bodies: Sequence[Ints]
) -> None:
    """Write the greatest forces on obstacles of frames, of what islands have recorded in groups, (k, f, ...).

    `bodies` are the obstacles that each group has.
    """
    whole = [getattr(out, name)[:frames] for name in _FIELDS]
    for array in whole:
        array[...] = np.nan
    for row in range(whole[0].shape[1]):
        found = [
            np.stack([getattr(part, name)[..., column] for name in _FIELDS])
            for part, own in zip(made, bodies, strict=True)
            for column in np.flatnonzero(own == row)
            if part.pressed_high.shape[2]
        ]
        if found:
            for array, values in zip(whole, _together(np.concatenate(found, axis=1)), strict=True):
                array[:, row] = values


def join_pressed(whole: State, parts: Sequence[tuple[State, Ints]]) -> None:
    """Write what parts have seen of obstacles since their intervals began; each with its rows there."""
    pressed = whole.peaks.pressed
    for row in range(pressed.shape[0]):
        found = [
            state.peaks.pressed[column]
            for state, rows in parts
            for column in np.flatnonzero(rows == row)
            if state.peaks.pressed.shape[0]
        ]
        if found:
            each = np.array(found).T
            columns = root_of(each[SQUARE]), each[WHEN], root_of(each[BEFORE])
            force, when, before = _together(np.stack(columns)[..., None])
            pressed[row] = np.nan
            pressed[row, SQUARE] = force[0] ** 2 if force[0] >= 0.0 else -np.inf
            pressed[row, WHEN], pressed[row, BEFORE] = when[0], before[0] ** 2


def _together(each: Floats) -> tuple[Floats, Floats, Floats]:
    """Return what islands have seen together, (f,) each; `each` (3, k, f) is what every one has.

    The sum of their greatest [N]; when it was, NaN where more than one presses [s]; and the sum of what was
    before.
    """
    unseen = np.isnan(each[0]).all(axis=0)
    force, before = np.nan_to_num(each[0]), np.nan_to_num(each[2])
    alone = (force > 0.0).sum(axis=0) <= 1
    first = force.argmax(axis=0), np.arange(force.shape[1])
    sums = [np.add.accumulate(part, axis=0)[-1] for part in (force, before)]
    when, was = np.where(alone, each[1][first], np.nan), np.where(alone, each[2][first], sums[1])
    return np.where(unseen, np.nan, sums[0]), when, np.where(unseen, np.nan, was)
