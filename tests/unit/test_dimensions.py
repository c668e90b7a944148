"""Words of a drawing with dimensions keep clear of the ropes."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.plots.dimensions import dimensions

ENDS = {  # where the rope goes on from the load at its first node, beside the other end
    "falls off to the right": [(0.0, 0.0, 0.0), (2.0, 0.0, -1.0), (4.0, 0.0, 0.0)],
    "hangs on it": [(0.0, 0.0, 0.0), (0.0, 0.0, 4.0), (2.0, 0.0, 4.0)],
    "lies beside it": [(0.0, 0.0, 0.0), (4.0, 0.0, 0.2), (6.0, 0.0, -2.0)],
    "goes down from it": [(0.0, 0.0, 0.0), (0.0, 0.0, -4.0), (2.0, 0.0, -4.0)],
}


@pytest.mark.parametrize("way", ENDS)
def test_no_rope_goes_through_the_words_of_a_load(way: str) -> None:
    """Of the preset `tow` the rope ran through the mass of the car."""
    size = float(np.linalg.norm(np.diff(ENDS[way], axis=0), axis=1).sum())
    rope = rw.Rope(
        length=size,
        segments=40,
        made_of=rw.Material(EA=1e6, mass_per_length=0.1),
        shape=rw.scene.Polyline(points=ENDS[way]),
        loads=[rw.Load(node=0, mass=1500.0)],
    )
    scene = rw.Scene(ropes=[rope], anchors=[rw.Anchor(node=-1)], run={"duration": 0.01})
    figure = dimensions(rw.simulate(scene))
    figure.canvas.draw()
    (axes,) = figure.axes
    (words,) = (one for one in axes.texts if one.get_text().endswith("kg"))
    line = max(axes.lines, key=lambda one: len(one.get_xdata()))  # type: ignore[arg-type]
    places = axes.transData.transform(np.column_stack(line.get_data()))
    fine = np.concatenate([np.linspace(a, b, 50) for a, b in pairwise(places)])
    box = words.get_window_extent()
    assert not any(box.contains(*place) for place in fine)


def test_flat_shapes_are_drawn_higher() -> None:
    """A line of 150 m that hangs by 8 m was drawn at one scale: shapes in time hid one another."""
    for drop, times in ((8.0, 5.0), (40.0, 1.0)):
        rope = rw.Rope(
            length=float(np.hypot(150.0, drop)),
            segments=20,
            made_of=rw.Material(EA=1e6, mass_per_length=0.1),
            shape=rw.scene.Polyline(points=[(0.0, 0.0, 0.0), (150.0, 0.0, -drop)]),
        )
        scene = rw.Scene(ropes=[rope], anchors=[rw.Anchor(node=0)], run={"duration": 0.01})
        (axes,) = dimensions(rw.simulate(scene)).axes
        assert axes.get_aspect() == times
