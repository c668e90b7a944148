"""How ropes lie on obstacles in time, as a table: angle, tensions, and what friction could hold."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ropewalk.core.arrays import Ints
from ropewalk.lowering.touching import turns
from ropewalk.record.contacts import each_frame

if TYPE_CHECKING:
    from ropewalk.record.result import Result

HEADERS = (
    *("time [s]", "rope", "obstacle", "first node", "last node", "angle [rad]"),
    *("tension before [N]", "tension after [N]", "ratio [1]", "ratio at slip [1]"),
    *("normal force [N]", "friction power [W]"),
)


def wrap_rows(result: Result, frames: Iterable[int], wanted: Ints) -> list[NDArray[np.generic]]:
    """Return the columns: a row for every rope with `wanted` nodes and obstacle that touch at a frame.

    Nodes are counted from the first that touches to the last, those between that do not touch included. The
    ratio is that of the larger tension to the smaller one, NaN where that pulls nothing; at slip it is
    exp(mu angle) for a rope without weight.
    """
    found: list[tuple[object, ...]] = []
    tension, places = result.tension, result.positions
    for frame, contacts in each_frame(result, frames):
        power = (contacts.rub * contacts.slip).sum(axis=1)
        for span in result.layout.ropes:
            own = (contacts.node >= span.start) & (contacts.node <= span.end)
            own &= np.isin(contacts.node, wanted)
            for o in np.unique(contacts.obstacle[own]):
                here = own & (contacts.obstacle == o)
                body, nodes = result.scene.obstacles[o], contacts.node[here]
                first, last = int(nodes.min()), int(nodes.max())
                beyond = slice(max(first - 1, span.start), min(last + 1, span.end) + 1)
                angle = float(turns(places[frame, beyond]).sum())
                before = float(tension[frame, first - 1]) if first > span.start else 0.0
                after = float(tension[frame, last]) if last < span.end else 0.0
                low, high = sorted((before, after))
                found.append(
                    (
                        *(result.time[frame], span.name, body.name),
                        *(first - span.start, last - span.start, angle, before, after),
                        *(high / low if low > 0.0 else np.nan, np.exp(body.friction * angle)),
                        *(contacts.push[here].sum(), power[here].sum()),
                    )
                )
    columns = list(zip(*found, strict=True)) or [()] * len(HEADERS)
    words = ("rope", "obstacle")
    return [
        np.array(column, dtype=object if header in words else None)
        for header, column in zip(HEADERS, columns, strict=True)
    ]
