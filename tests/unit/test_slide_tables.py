"""What slides along ropes, in tables and figures."""

from pathlib import Path

import numpy as np
import pandas as pd
import pytest

import ropewalk as rw
from ropewalk.plots import PLOTS
from ropewalk.record.result import Result
from ropewalk.scene import Load, Plane, Slide, Straight

LINE = rw.Material(EA=2e4, mass_per_length=0.05, axial_damping=50.0)


def scene(**more: object) -> rw.Scene:
    line = rw.Rope(
        name="line", segments=10, made_of=LINE, shape=Straight(direction=(1, 0, -0.3)), length=5.0
    )
    riders = [
        rw.Rope(
            name=name, segments=1, length=0.5, made_of=LINE,
            shape=Straight(direction=(0, 0, -1)), loads=[Load(node=0, mass=mass)],
        )
        for name, mass in (("one", 2.0), ("two", 3.0))
    ]  # fmt: skip
    return rw.Scene(
        ropes=[line, *riders],
        anchors=[rw.Anchor(rope="line", node=0), rw.Anchor(rope="line", node=-1)],
        slides=[
            Slide(name="trolley", rope="one", on="line", at=1.0),
            Slide(name="hook", rope="two", on="line", at=3.0),
        ],
        run={"duration": 0.1, "time_step": 1e-4, "method": "semi-implicit-euler"} | more,
    )


@pytest.fixture(scope="module")
def result() -> Result:
    return rw.simulate(scene())


def test_the_export_has_places_speeds_and_loads_of_slides(result: Result, tmp_path: Path) -> None:
    files = result.export("csv", tmp_path, every=2)
    table = pd.read_csv(tmp_path / "slides.csv")
    assert tmp_path / "slides.csv" in files
    assert list(table) == [
        *("time [s]", "slide", "rope", "along", "place [m]", "speed [m/s]", "load [N]"),
        "speed of the rope's centre of mass [m/s]",
    ]
    for name, rope in (("trolley", "one"), ("hook", "two")):
        rows, motion = table[table["slide"] == name], result.slide(name)
        assert set(rows["rope"]) == {rope}
        assert set(rows["along"]) == {"line"}
        np.testing.assert_array_equal(rows["time [s]"], result.time[::2])
        np.testing.assert_array_equal(rows["place [m]"], motion.place[::2])
        np.testing.assert_array_equal(rows["speed [m/s]"], motion.speed[::2])
        np.testing.assert_array_equal(rows["load [N]"], motion.load[::2])
        np.testing.assert_array_equal(rows.iloc[:, -1], motion.carried[::2])


def test_the_start_of_a_line_is_a_place_like_any_other() -> None:
    """A slide at 0 was refused. It goes as one at the far end of the same line drawn from there."""
    given = scene()
    line, rider, trolley = given.ropes[0], given.ropes[1], given.slides[0]
    top = given.replace(ropes=[line, rider], slides=[trolley.replace(at=0.0)])
    way = Straight(start=(0, 0, 0), direction=(1, 0, -0.3))
    end = [5.0 / np.hypot(1.0, 0.3) * part for part in way.direction]
    turned = line.replace(shape=Straight(start=end, direction=(-1, 0, 0.3)))
    bottom = given.replace(ropes=[turned, rider], slides=[trolley.replace(at=5.0)])
    one, other = (rw.simulate(each).slide("trolley") for each in (top, bottom))
    assert one.place[0] == 0.0
    assert one.place[-1] > 0.01
    np.testing.assert_allclose(one.place, 5.0 - other.place, atol=1e-9)
    np.testing.assert_allclose(one.load, other.load, rtol=1e-6, atol=1e-6)
    with pytest.raises(rw.SceneError, match=r"at: -0.1 - must be at least 0"):
        trolley.replace(at=-0.1)


def test_pandas_and_xarray_have_them_too(result: Result) -> None:
    table = result.to_pandas("slides", rope="two")
    assert set(table["slide"]) == {"hook"}
    part = result.datasets["slides"]
    assert part["place"].attrs["units"] == "m"
    assert part["load"].attrs["units"] == "N"
    assert part.sizes["row"] == 2 * result.frames


def test_a_table_of_nodes_alone_stays_one_file(result: Result, tmp_path: Path) -> None:
    out = tmp_path / "nodes.csv"
    assert result.export("csv", out, quantities=["positions", "velocities"]) == (out,)


def test_where_nothing_can_touch_no_contact_is_told(result: Result) -> None:
    """A trolley's force is in its load: columns and figures of contacts would say that it is none."""
    assert "contact_force" not in result.source.names
    assert not PLOTS["contact"].there(result)
    assert not PLOTS["sticking"].there(result)
    touching = rw.simulate(scene(duration=0.01).replace(ground={"height": -9.0}))
    assert not PLOTS["contact"].there(touching)
    wall = Plane(point=(0, 0, -9), normal=(0, 0, 1))
    assert PLOTS["contact"].there(rw.simulate(scene(duration=0.01).replace(obstacles=[wall])))
