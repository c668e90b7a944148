"""The table of wraps: what every stretch of a rope on an obstacle does at a frame."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ropewalk.core.arrays import Ints
from ropewalk.lowering.touching import PRESSED
from ropewalk.record.contacts import each_frame, lying
from ropewalk.record.rope_contact_table import pressed_by_ropes

if TYPE_CHECKING:
    from ropewalk.record.result import Result

WRAP_COLUMNS = (
    *("time [s]", "rope", "obstacle", "first node", "last node", "angle [rad]"),
    *("tension before [N]", "tension after [N]", "ratio [1]", "ratio at slip [1]"),
    *("normal force [N]", "friction power [W]", "normal force of ropes [N]"),
)


def wrap_rows(result: Result, frames: Iterable[int], wanted: Ints) -> list[NDArray[np.generic]]:
    """Return the columns: a row for every stretch of a rope on an obstacle at a frame.

    Each is whole, and there where one of its nodes is `wanted`.
    The angle is that towards the obstacle: what turns within a floor, or lies in a trough, is not held by it.
    The ratio is that of the larger tension to the smaller one, NaN where that pulls nothing; at slip it is
    `Contacts.at_slip`, of a rope without weight: exp(mu angle) where it turns towards the surface alone; NaN
    where ropes or other obstacles press on it there, which hold the rest, see `Contacts.pressed_by`.
    """
    found: list[tuple[object, ...]] = []
    tension = result.tension
    for frame, contacts in each_frame(result, frames):
        power = (contacts.rub * contacts.slip).sum(axis=1)
        ropes = pressed_by_ropes(result, frame)
        for wrap in lying(result.scene, result.layout, contacts, tension[frame]):
            if not np.isin(contacts.node[wrap.rows], wanted).any():
                continue
            push, by_ropes = contacts.push[wrap.rows].sum(), ropes[contacts.node[wrap.rows]].sum()
            alone = by_ropes <= PRESSED * push and not contacts.pressed_by(wrap.rows)
            at_slip = wrap.at_slip if alone else np.nan
            found.append(
                (
                    *(result.time[frame], result.layout.ropes[wrap.rope].name),
                    *(result.scene.obstacles[wrap.obstacle].name, wrap.first, wrap.last),
                    *(wrap.angle, wrap.before, wrap.after, wrap.ratio, at_slip),
                    *(push, power[wrap.rows].sum(), by_ropes),
                )
            )
    columns = list(zip(*found, strict=True)) or [()] * len(WRAP_COLUMNS)
    words = ("rope", "obstacle")
    return [
        np.array(column, dtype=object if header in words else None)
        for header, column in zip(WRAP_COLUMNS, columns, strict=True)
    ]
