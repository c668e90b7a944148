"""Pictures of modes: how large motions are drawn."""

import numpy as np
import pytest
from matplotlib.axes import Axes

import ropewalk as rw
from ropewalk.scene import Slack, Straight

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


def test_a_shape_in_no_plane_has_no_motion_in_it_or_out_of_it() -> None:
    """Legs of a sling swing "out of plane", and stood in the picture of the plane."""
    found = rw.modes("three-leg-sling", count=7)
    assert found.normal is None
    assert {motion.name for motion in found.motions} == {"sideways", "along"}


@pytest.mark.parametrize("wind", [(0.0, 0.0, 0.0), (0.0, 500.0, 0.0), (0.0, 2e4, 0.0)])
def test_the_plane_of_the_words_is_that_of_the_picture(wind: tuple[float, float, float]) -> None:
    """Of a plane that leans, or lies, the picture was of the upright one."""
    shape = {"kind": "slack", "end": (4.0, 0.0, 0.0)}
    rope = rw.Rope(segments=12, length=6.0, made_of=CORD, shape=shape)
    anchors = [rw.Anchor(node=0), rw.Anchor(node=-1)]
    scene = rw.Scene(ropes=[rope], anchors=anchors, air=rw.Air(wind=wind, node_drag=1e-3))
    found = rw.modes(scene, count=6)
    assert found.normal is not None
    assert {"in plane", "out of plane"} <= {motion.name for motion in found.motions}
    for motion, axes in zip(found.motions, found.plot.mode_shapes().axes, strict=False):
        base, moved, _ = (np.asarray(line.get_xydata()) for line in axes.lines)
        flat = float(np.ptp(base[:, 1])) == 0.0  # drawn over the rope's own length
        assert flat == (motion.name == "out of plane")
        assert np.abs(moved - base).max() > 0.05 * np.ptp(base, axis=0).max()


def slack(name: str, start: tuple[float, float, float], end: tuple[float, float, float]) -> rw.Rope:
    shape = Slack(start=start, end=end)
    return rw.Rope(name=name, segments=8, length=1.0, made_of=CORD, shape=shape)


def told(*ropes: rw.Rope, ends: tuple[int, ...] = (0, -1)) -> tuple[rw.Modes, set[str]]:
    """Return the modes of ropes that are held at both ends, and what their motions are called."""
    held = [rw.Anchor(rope=rope.name, node=k) for rope in ropes for k in ends]
    found = rw.modes(rw.Scene(ropes=ropes, anchors=held), count=6)
    return found, {motion.name for motion in found.motions}


@pytest.mark.parametrize("beside", [0.01, 0.1, 3.0])
def test_ropes_side_by_side_have_each_its_own_plane(beside: float) -> None:
    """All nodes as one cloud lie in no plane, or in a level one: sags were "sideways", or out of it."""
    found, names = told(
        slack("a", (0, 0, 0), (0.9, 0, 0)), slack("b", (0, beside, 0), (0.9, beside, 0))
    )
    assert found.normal == pytest.approx([0, 1, 0], abs=1e-9)
    assert names == {"in plane", "out of plane"}
    for shape, motion in zip(found.shapes, found.motions, strict=True):
        assert (np.abs(shape[:, 1]).max() > 0.9) == (motion.name == "out of plane")


def test_the_many_ropes_of_one_shape_sag_in_planes_of_their_own() -> None:
    """At 0.653 Hz they move across their planes alone, which was called in plane."""
    found = rw.modes("r5", count=6)
    assert {motion.name for motion in found.motions} == {"out of plane"}


def test_ropes_across_each_other_have_no_plane_and_one_that_hangs_down_has_any() -> None:
    along, across = slack("a", (0, 0, 0), (0.9, 0, 0)), slack("b", (2, 0, 0), (2, 0.9, 0))
    found, names = told(along, across)
    assert found.normal is None
    assert "sideways" in names
    assert not {"in plane", "out of plane"} & names
    down = Straight(start=(5.0, 2.0, 0.0), direction=(0.0, 0.0, -1.0))
    held = [rw.Anchor(rope=name, node=k) for name, k in (("a", 0), ("a", -1), ("d", 0))]
    ropes = [along, along.replace(name="d", shape=down)]
    both = rw.modes(rw.Scene(ropes=ropes, anchors=held), count=8)
    names_of = {rope: {one.name for one in both.motions if one.rope == rope} for rope in "ad"}
    assert names_of == {"a": {"in plane", "out of plane"}, "d": {"sideways"}}
