"""The table of contacts adds up to the forces that were recorded, body by body and before the touch."""

from __future__ import annotations

import math

import numpy as np
import pandas as pd
import pytest

import ropewalk as rw
from ropewalk.record.moving_rows import axle_loads
from ropewalk.scene import Plane, Scene, Straight, loads


def test_what_comes_fast_is_in_the_table_before_it_touches() -> None:
    """A damper stops it from some millimetres out; looked for is only what may be within its reach."""
    scene = loads("""
[run]
duration = 0.05
frame_rate = 1000
method = "esdirk3"
time_step = 0.001
[[rope]]
segments = 10
length = 0.5
diameter = 0.01
made_of = { kind = "material", EA = 1e3, mass_per_length = 0.1 }
shape = { kind = "straight", start = [-0.25, 0, 0.06], end = [0.25, 0, 0.06], velocity = [0, 0, -5] }
[[obstacle]]
name = "floor"
kind = "plane"
motion = { kind = "velocity", velocity = [0.3, 0, 0.2] }
[[obstacle]]
name = "wheel"
kind = "cylinder"
from = [0, -0.1, 0]
to = [0, 0.1, 0]
radius = 0.04
spin = { free = true, inertia = 1e-4, rate = 20.0 }
""")
    result = rw.simulate(scene)
    table = result.to_pandas("contacts")
    parts = ["fx [N]", "fy [N]", "fz [N]"]
    sums = table.groupby("time [s]")[parts].sum().reindex(np.asarray(result.time)).fillna(0.0)
    whole = result.contact_force.sum(axis=1)
    assert np.allclose(sums.to_numpy(), whole, rtol=1e-9, atol=1e-9)
    gap = table["z [m]"] - 0.2 * table["time [s]"] - 0.005
    assert (gap[table["obstacle"] == "floor"] > 1e-3).any()  # pushed, and not there yet
    wheel = table[table["obstacle"] == "wheel"].groupby("time [s]")[parts].sum()
    loads_ = np.linalg.norm(wheel.reindex(np.asarray(result.time)).fillna(0.0), axis=1)
    assert loads_.max() > 0.0
    assert np.allclose(
        axle_loads(result, range(result.frames))[:, 0], loads_, rtol=1e-12, atol=1e-12
    )
    floor = table[table["obstacle"] == "floor"].groupby("time [s]")[parts].sum()
    pressed = np.linalg.norm(floor, axis=1)
    told = result.table
    assert told["largest force on an obstacle [N]"] == pytest.approx(pressed.max(), rel=1e-9)
    when = f"obstacle 'floor', t = {floor.index[pressed.argmax()]:.6g} s"
    assert told["largest force on an obstacle at"] == when
    # friction as the step ended with it: a frame evaluates that of what slips anew
    assert told["largest load on the axle of a pulley [N]"] == pytest.approx(loads_.max(), rel=1e-3)


@pytest.mark.parametrize(
    ("left", "right", "along"), [(45, 45, 0), (30, 60, 0), (20, 70, 0), (30, 60, 1)]
)
def test_in_a_groove_each_side_has_its_own_friction(left: int, right: int, along: int) -> None:
    """What the contacts remember themselves: half of it was told, and 50 % of what friction can carry."""
    slopes = np.radians([left, -right])
    normals = np.stack([np.sin(slopes), np.zeros(2), np.cos(slopes)], axis=1)
    x, z = np.linalg.solve(normals[:, [0, 2]], [0.005, 0.005])
    rope = rw.Rope(
        segments=10,
        length=1.0,
        diameter=0.01,
        made_of=rw.Material(EA=2e4, mass_per_length=0.1, axial_damping=20.0),
        shape=Straight(start=(x, -0.5, z), end=(x, 0.5, z), velocity=(0, 1.0 * along, 0)),
    )
    sides = [
        Plane(normal=tuple(one), friction=mu) for one, mu in zip(normals, (0.3, 0.2), strict=True)
    ]
    run = {"method": "esdirk3", "time_step": 0.004, "duration": 0.2}
    simulation = rw.Simulation(Scene(ropes=[rope], obstacles=sides, run=run))
    result = rw.simulate(simulation.scene)
    while simulation.time < result.time[-1] - 1e-9:
        simulation.step()
    table = result.to_pandas("contacts")
    last = table[table["time [s]"] == result.time[-1]]
    parts = last[["fx [N]", "fy [N]", "fz [N]"]].to_numpy()
    whole = result.contact_force[-1]
    assert np.allclose(parts.reshape(11, 2, 3).sum(axis=1), whole, rtol=1e-9, atol=1e-12)
    assert not along or last["slip speed [m/s]"].min() > 0.1
    kept = simulation._state.memory.obstacle.grip[:, :3]  # (obstacle, axis, node)
    sizes = last["friction force [N]"].to_numpy().reshape(11, 2)
    for row in range(2):
        assert np.allclose(sizes[:, row], np.linalg.norm(kept[row], axis=0), rtol=0.01)
    assert last["friction used [1]"].max() <= 1.0 + 1e-9


@pytest.mark.parametrize("start", ["at-rest", "shape"])
@pytest.mark.parametrize("friction", [(0.1, 0.5), (0.05, 0.8)])
def test_no_side_of_a_groove_carries_more_than_its_friction(
    start: str, friction: tuple[float, float]
) -> None:
    """On a slope near to what it holds a rope that creeps in is held across, too: 1.008 of it was told."""
    half, limit = math.radians(30.0), math.atan(sum(friction))  # (mu + mu') / 2 over sin 30 degrees
    tilt = limit - math.radians(5.0)
    rope = rw.Rope(
        segments=10,
        length=0.5,
        diameter=0.01,
        made_of=rw.Material(EA=1e4, mass_per_length=0.1, axial_damping=5.0),
        shape=Straight(start=(0, 0, 0.01), end=(0.5, 0, 0.01)),
    )
    normals = [(0, side * math.cos(half), math.sin(half)) for side in (1, -1)]
    sides = [Plane(normal=one, friction=mu) for one, mu in zip(normals, friction, strict=True)]
    down = (9.81 * math.sin(tilt), 0, -9.81 * math.cos(tilt))
    run = {"method": "esdirk3", "duration": 0.1, "frame_rate": 100, "start": start}
    result = rw.simulate(Scene(gravity=down, ropes=[rope], obstacles=sides, run=run))
    table = result.to_pandas("contacts")
    assert 0.9 < table["friction used [1]"].max() <= 1.0 + 1e-6
    coefficients = np.tile(friction, len(table) // 2)
    most = coefficients * table["normal force [N]"].to_numpy()
    assert (table["friction force [N]"] <= (1.0 + 1e-6) * most).all()
    parts = table[["fx [N]", "fy [N]", "fz [N]"]].to_numpy().reshape(-1, 11, 2, 3).sum(axis=2)
    forces = [force for force in result.contact_force if force.any()]
    assert np.allclose(parts, forces, rtol=1e-9, atol=1e-12)


def test_what_an_obstacle_bears_is_told_when_another_rope_has_broken() -> None:
    """Its places hold no numbers from then on. The twin: the rope on its own."""
    scene = loads("""
[run]
duration = 0.6
method = "semi-implicit-euler"
time_step = 0.0008333333333333334
[[rope]]
name = "a"
segments = 10
length = 0.5
diameter = 0.01
made_of = { kind = "material", EA = 50.0, mass_per_length = 0.1, axial_damping = 0.05 }
shape = { kind = "straight", start = [-0.25, 0, 0.12], end = [0.25, 0, 0.12] }
[[rope]]
name = "b"
segments = 20
length = 1.0
diameter = 0.01
made_of = { kind = "material", EA = 3e4, mass_per_length = 0.05 }
shape = { kind = "straight", start = [5, 0, 1], end = [6, 0, 1.02] }
[[anchor]]
rope = "b"
node = 0
[[obstacle]]
name = "ball"
kind = "sphere"
center = [0, 0, 0]
radius = 0.08
""")
    both = rw.simulate(scene, on_failure="return")
    alone = rw.simulate(scene.model_copy(update={"ropes": scene.ropes[:1], "anchors": ()}))
    assert both.table["broken ropes"]
    title = "largest force on an obstacle"
    assert alone.table[f"{title} [N]"] > 0.1
    assert both.table[f"{title} [N]"] == pytest.approx(alone.table[f"{title} [N]"], rel=1e-6)


def _landing_beside_a_wheel(spin: str) -> Scene:
    """Return a stretched rope that bounces on a wheel with 60 N and more, and one that falls to the floor."""
    return loads(f"""
[run]
duration = 0.12
frame_rate = 1000
method = "esdirk3"
time_step = 0.001
[[rope]]
name = "taut"
segments = 10
length = 0.45
diameter = 0.01
made_of = {{ kind = "material", EA = 1e3, mass_per_length = 0.1 }}
shape = {{ kind = "straight", start = [-0.25, 0, 0.07], end = [0.25, 0, 0.07] }}
[[rope]]
name = "falls"
segments = 4
length = 0.2
diameter = 0.01
made_of = {{ kind = "material", EA = 1e3, mass_per_length = 0.1 }}
shape = {{ kind = "straight", start = [-0.1, 1, -0.4], end = [0.1, 1, -0.4], velocity = [0, 0, -1] }}
[[anchor]]
rope = "taut"
node = 0
motion = {{ kind = "velocity", velocity = [0, 0, -1], stop = 0.04 }}
[[anchor]]
rope = "taut"
node = -1
motion = {{ kind = "velocity", velocity = [0, 0, -1], stop = 0.04 }}
[[obstacle]]
name = "floor"
kind = "plane"
point = [0, 0, -0.42]
[[obstacle]]
name = "wheel"
kind = "cylinder"
from = [0, -0.1, 0]
to = [0, 0.1, 0]
radius = 0.06
{spin}
""")


def test_the_largest_force_on_an_obstacle_is_found_beside_a_wheel_that_bears_more() -> None:
    """The frames in which the wheel bears most were looked at alone. The twin: a wheel that does not turn."""
    title = "largest force on an obstacle"
    result = rw.simulate(_landing_beside_a_wheel("spin = { free = true, inertia = 1e-4 }"))
    table = result.to_pandas("contacts")
    parts = ["fx [N]", "fy [N]", "fz [N]"]
    of = {
        name: table[table["obstacle"] == name].groupby("time [s]")[parts].sum().pipe(_sizes)
        for name in ("floor", "wheel")
    }
    lands = of["floor"].idxmax()
    assert (of["wheel"] > of["wheel"].get(lands, 0.0) + of["floor"].max()).sum() > 24
    assert result.table[f"{title} [N]"] == pytest.approx(of["floor"].max(), rel=1e-9)
    assert result.table[f"{title} at"].startswith(f"obstacle 'floor', t = {lands:.6g} s")
    held = rw.simulate(_landing_beside_a_wheel("")).table
    assert held[f"{title} [N]"] > result.table[f"{title} [N]"]
    assert held[f"{title} at"].startswith("obstacle 'wheel'")


def _sizes(forces: pd.DataFrame) -> pd.Series:
    return (forces**2).sum(axis=1) ** 0.5
