"""Motions of obstacles: what moves after a run is of no matter to it, and where a table begins is told."""

from __future__ import annotations

from typing import Any

import pytest

import ropewalk as rw
from ropewalk.lowering import build
from ropewalk.motions.rows import largest_speed, motion_rows
from ropewalk.scene import (
    Box,
    HalfPipe,
    Material,
    Obstacle,
    Plane,
    Rope,
    RunSettings,
    Scene,
    SceneError,
    Spin,
    Straight,
    Table,
    Velocity,
)


def over(body: Obstacle, **more: Any) -> Scene:
    """A short rope at rest above a body."""
    shape = Straight(start=(-0.1, 0, 0.3), end=(0.1, 0, 0.3))
    stuff = Material(EA=1e4, mass_per_length=0.1)
    rope = Rope(segments=4, length=0.2, diameter=0.01, made_of=stuff, shape=shape)
    run = {"duration": 0.5, "frame_rate": 60.0, "method": "esdirk3", "time_step": 1 / 240}
    return Scene(ropes=[rope], obstacles=[body], run=RunSettings(**(run | more)))


def slab(**more: Any) -> Box:
    return Box(name="slab", center=(0, 0, 0), half_sizes=(0.2, 0.2, 0.05), edge_radius=0.01, **more)


#: At rest until 10 s, then at 20 m/s.
LATE = Table(times=(0.0, 10.0, 10.1), positions=((0, 0, 0), (0, 0, 0), (0, 0, 2)))


@pytest.mark.parametrize(
    "late",
    [
        {"motion": LATE},
        {"motion": Velocity(velocity=(0, 0, 20.0), start=10.0)},
        {"spin": Spin(rate=500.0, start=10.0)},
        {"spin": Spin(times=(0.0, 10.0, 10.1), angles=(0.0, 0.0, 50.0))},
    ],
)
def test_what_moves_after_the_run_neither_refuses_it_nor_shortens_steps(
    late: dict[str, Any],
) -> None:
    """In a run that lasts until then, or one without an end, it does."""
    scene = over(slab(**late))
    build(scene)
    longer = scene.replace(run=scene.run.replace(duration=12.0))
    with pytest.raises(SceneError, match="would jump over nodes|friction turns with the body"):
        build(longer)
    with pytest.raises(SceneError, match="would jump over nodes|friction turns with the body"):
        build(scene, endless=True)
    own = scene.replace(run=scene.run.replace(time_step="auto"))
    rests = build(own.replace(obstacles=[slab()])).plan.dt
    assert build(own).plan.dt == rests
    assert build(own, endless=True).plan.dt < rests


def test_the_largest_speed_before_a_time_is_that_of_what_is_done_by_then() -> None:
    line = Table(times=(0.0, 1.0, 2.0), positions=((0, 0, 0), (1, 0, 0), (4, 0, 0)))
    # The natural spline: x = (7 t + t^3) / 4 ... up to 1 s, so that x' = 0.5 + 1.5 t^2.
    curve = line.replace(interpolation="cubic")
    rows = motion_rows([line, curve, None], [[0.0] * 3] * 3)
    for until, speed in ((0.0, 0.0), (0.5, 1.0), (1.0, 1.0), (1.1, 3.0), (9.0, 3.0)):
        assert largest_speed(rows, 0, until) == pytest.approx(speed)
    for until in (0.3, 0.5, 1.0):
        assert largest_speed(rows, 1, until) == pytest.approx(0.5 + 1.5 * until**2)
    assert largest_speed(rows, 1) == pytest.approx(3.5)
    assert largest_speed(rows, 2) == 0.0


def told(body: Obstacle) -> list[str]:
    found = rw.check(over(body), measure=False).warnings
    return [note for note in found if "its table of motion begins" in note]


def test_check_says_where_a_table_begins_elsewhere_than_the_body_is_drawn() -> None:
    """A table of ways moves a body to the origin at once; not what is endless and moved along itself."""
    ways = Table(times=(0.0, 1.0), positions=((0, 0, 0), (0.1, 0, 0)))
    drawn = slab().replace(center=(0, 0, -0.05), motion=ways)
    (note,) = told(drawn)
    assert "'slab': it is drawn at (0, 0, -0.05) m" in note
    assert "begins at (0, 0, 0) m, 50 mm off" in note
    assert not told(slab(motion=ways))
    floor = Plane(point=(3.0, 0, 0), motion=ways)
    assert not told(floor)
    assert told(floor.replace(point=(0, 0, -0.01)))
    trough = HalfPipe(start=(5, 0, 0), end=(6, 0, 0), radius=0.5, motion=ways)
    assert not told(trough)
    assert told(trough.replace(start=(5, 0, -0.01), end=(6, 0, -0.01)))
