"""The plane that figures look at: that of the motion where it goes across that of the shape, and said."""

from __future__ import annotations

from typing import Any

import pytest

import ropewalk as rw
from ropewalk.plots.dimensions import dimensions
from ropewalk.plots.sight import sight
from ropewalk.scene import Kick, Polyline, Slack


def swung(velocity: tuple[float, float, float]) -> rw.Result:
    """A hung rope along x whose nodes set out with a velocity [m/s]."""
    rope = rw.Rope(
        segments=6, length=4.4, made_of=rw.Material(EA=1e4, mass_per_length=0.1, axial_damping=10.0),
        shape=Slack(end=(4.0, 0.0, 0.0)), kicks=[Kick(node=i, velocity=velocity) for i in range(1, 6)],
    )  # fmt: skip
    run = rw.RunSettings(duration=0.5, frame_rate=50.0, method="implicit-euler", time_step=0.01)
    anchors = [rw.Anchor(node=0), rw.Anchor(node=-1)]
    return rw.simulate(rw.Scene(ropes=[rope], anchors=anchors, run=run))


def written(figure: Any) -> str:
    return " ".join(" ".join(text.get_text() for text in figure.texts).split())


@pytest.mark.parametrize(
    ("velocity", "plane"), [((0.0, 2.0, 0.0), "yz"), ((0.0, 0.0, 2.0), "xz"), ((0, 0, 0), "xz")]
)
def test_a_rope_that_swings_out_of_its_plane_is_seen_along_it(
    velocity: tuple[float, float, float], plane: str
) -> None:
    """It was drawn as if nothing moved."""
    result = swung(velocity)
    view = sight(result)
    assert view.across_name + view.up_name == plane
    axes = result.plot.shape().axes[0]
    assert (axes.get_xlabel(), axes.get_ylabel()) == (f"{plane[0]} [m]", f"{plane[1]} [m]")
    told = "Drawn is the plane of y and z, in which the ropes move; across it they reach 4 m."
    for figure in (result.plot.shape(), result.plot.film()):
        assert (told in written(figure)) is (plane == "yz")


def test_what_is_still_is_drawn_in_the_plane_of_its_shape() -> None:
    """Dimensions and forces, whose arrows lie along the ropes."""
    result = swung((0.0, 2.0, 0.0))
    for figure in (dimensions(result), result.plot.forces()):
        assert figure.axes[0].get_xlabel() == "x [m]"


def test_motion_that_is_not_seen_is_told() -> None:
    result = swung((0.0, 2.0, 0.0))
    moves = "Drawn is the plane of x and z; across it the ropes move, too, by "
    assert moves in written(result.plot.shape(plane="xz"))
    assert "across it" not in written(swung((0.0, 0.0, 2.0)).plot.shape())


def test_what_reaches_out_of_the_plane_without_moving_is_told() -> None:
    """A rope blown aside by half its span was drawn as one that hangs; the twin hangs."""
    for aside, told in ((2.0, True), (0.2, False)):
        rope = rw.Rope(
            segments=2, length=5.0, made_of=rw.Material(EA=1e4, mass_per_length=0.1),
            shape=Polyline(points=[(0, 0, 0), (2, aside, -1), (4, 0, 0)]),
        )  # fmt: skip
        run = rw.RunSettings(duration=0.1, frame_rate=50.0, method="implicit-euler", time_step=0.01)
        anchors = [rw.Anchor(node=i) for i in range(3)]
        result = rw.simulate(rw.Scene(ropes=[rope], anchors=anchors, run=run))
        line = "Drawn is the plane of x and z; across it the ropes reach 2 m."
        assert (line in written(result.plot.shape())) is told


def test_loads_beside_each_other_have_one_label() -> None:
    """A trolley, a rider and his legs were written over each other; the twin's are apart."""
    for apart, labels in ((1, ["3 + 67 kg"]), (60, ["3 kg", "67 kg"])):
        loads = [rw.Load(node=10, mass=3.0), rw.Load(node=10 + apart, mass=67.0)]
        made_of = rw.Material(EA=1e5, mass_per_length=0.1)
        rope = rw.Rope(
            segments=100,
            length=10.2,
            made_of=made_of,
            shape=Slack(end=(10.0, 0.0, 0.0)),
            loads=loads,
        )
        ends = [rw.Anchor(node=0), rw.Anchor(node=-1)]
        figure = dimensions(rw.equilibrium(rw.Scene(ropes=[rope], anchors=ends)))
        written = [one.get_text() for one in figure.axes[0].texts]
        assert [text for text in written if text.endswith("kg")] == labels
