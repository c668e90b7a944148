"""What slides along ropes, as a table: where it is, how fast it goes, what it presses on its line with."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ropewalk.core.arrays import Ints
from ropewalk.record.moving_rows import SlideMotion, slide_motion

if TYPE_CHECKING:
    from ropewalk.record.result import Result

HEADERS = (
    *("time [s]", "slide", "rope", "along"),
    *("place [m]", "speed [m/s]", "load [N]", "speed of the rope's centre of mass [m/s]"),
)


def slide_rows(result: Result, nodes: Ints) -> Callable[[Ints], list[NDArray[np.generic]]]:
    """Return what makes the columns at some frames: a row a frame for each slide of one of some nodes.

    `place` is of the line's unstretched rope, NaN once the slide has run off. All frames are looked at
    once: where a slide is follows from where it was.
    """
    found: list[tuple[tuple[str, str, str], SlideMotion]] | None = None
    wanted = set(nodes.tolist())
    slides = [s for s in result.scene.slides if result.layout.node(s.node, s.rope) in wanted]

    def columns(frames: Ints) -> list[NDArray[np.generic]]:
        nonlocal found
        if found is None:
            found = [((s.name, s.rope, s.on), slide_motion(result, s.name)) for s in slides]
        times = np.repeat(result.time[frames], len(found))
        named = [
            np.array([labels[k] for labels, _ in found] * len(frames), dtype=object)
            for k in range(3)
        ]
        values = [
            np.array([motion[k][frames] for _, motion in found]).reshape(len(found), -1).T.ravel()
            for k in range(len(SlideMotion._fields))
        ]
        return [times, *named, *values]

    return columns
