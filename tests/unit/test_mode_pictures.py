"""Pictures of modes: how large motions are drawn."""

import numpy as np
import pytest
from matplotlib.axes import Axes

import ropewalk as rw
from ropewalk.scene import Straight

CORD = rw.Material(EA=1e4, mass_per_length=0.1)


def swings(axes: Axes) -> list[float]:
    """Return how far each rope is drawn from its shape at most, over the widest shape in a picture."""
    lines = [np.asarray(line.get_xydata()) for line in axes.lines]
    widest = max(float(np.ptp(base, axis=0).max()) for base in lines[::3])
    return [
        float(np.linalg.norm(moved - base, axis=1).max()) / widest
        for base, moved in zip(lines[::3], lines[1::3], strict=True)
    ]


def test_motions_in_and_out_of_the_plane_are_drawn_alike() -> None:
    found = rw.modes("wave-on-a-string", count=4)
    names = [motion.name for motion in found.motions]
    assert {"in plane", "out of plane"} <= set(names)
    drawn = [max(swings(axes)) for axes in found.plot.mode_shapes().axes[:4]]
    assert drawn == pytest.approx([0.12] * 4, rel=0.01)


def test_ropes_of_one_mode_are_drawn_to_one_scale() -> None:
    """A short pendulum and a long one that joints tie to nothing: each mode moves one of them."""
    ropes = [
        rw.Rope(
            name=name, segments=10, length=length, made_of=CORD,
            shape=Straight(start=(0.0, 0.0, 0.0), direction=(0.0, 0.0, -1.0)),
        )
        for name, length in (("short", 1.0), ("long", 4.0))
    ]  # fmt: skip
    anchors = [rw.Anchor(rope=name, node=0) for name in ("short", "long")]
    found = rw.modes(rw.Scene(ropes=ropes, anchors=anchors), count=6)
    for number, axes in enumerate(found.plot.mode_shapes().axes[:6]):
        size = np.abs(found.shapes[number]).max()
        assert max(swings(axes)) == pytest.approx(0.12 * size, rel=0.05)
