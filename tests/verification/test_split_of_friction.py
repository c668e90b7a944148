"""What each of several surfaces at a node does by friction, and what they hold together."""

from __future__ import annotations

import math

import numpy as np
import pytest

import ropewalk as rw
from laid import half_round, laid
from ropewalk.lowering.splitting import split
from ropewalk.record.body_loads import body_loads
from ropewalk.record.quantities import PRESSED
from ropewalk.scene import Plane, Scene, Sphere, Straight

g = 9.81
MADE = rw.Material(EA=1e4, mass_per_length=0.1, axial_damping=5.0)


def last_on(result: rw.Result, body: str) -> dict[str, float]:
    """The sums over the nodes on a body at the last frame."""
    table = result.to_pandas("contacts")
    there = (table["time [s]"] == table["time [s]"].max()) & (table["obstacle"] == body)
    found: dict[str, float] = table[there].sum(numeric_only=True).to_dict()
    return found | {"modes": set(table[there]["mode"])}


def on_a_floor(floor: Plane, belt: Plane, gravity: tuple[float, float, float]) -> rw.Result:
    rope = rw.Rope(
        segments=6,
        length=0.3,
        diameter=0.01,
        made_of=MADE,
        shape=Straight(start=(0, 0.005, 0.005), end=(0.3, 0.005, 0.005)),
    )
    run = {"method": "esdirk3", "duration": 0.5, "frame_rate": 50}
    return rw.simulate(Scene(gravity=gravity, ropes=[rope], obstacles=[floor, belt], run=run))


RUNS = {"kind": "velocity", "velocity": (0.5, 0.0, 0.0)}


@pytest.mark.parametrize("firm", [True, False])
def test_a_belt_that_drags_a_rope_over_a_table_pulls_with_all_its_friction(firm: bool) -> None:
    """Only the sum, next to nothing, was divided: 0.009 N for 28 N, and loads 22 % too small."""
    belt_mu, pressed = 0.8, {"compliance": 1e-4} if firm else {}
    floor = Plane(name="table", friction=0.9, **pressed)
    belt = Plane(
        name="belt",
        point=(0, 0, 0.0099),
        normal=(0, 0, -1),
        friction=belt_mu,
        motion=RUNS,
        **pressed,
    )
    result = on_a_floor(floor, belt, (0, 0, -g))
    on_belt, on_table = last_on(result, "belt"), last_on(result, "table")
    push, rub = on_belt["normal force [N]"], on_belt["friction force [N]"]
    assert on_belt["modes"] == {"slips"}
    assert on_table["modes"] == {"sticks"}
    assert rub == pytest.approx(belt_mu * push, rel=1e-4)
    assert on_belt["fx [N]"] == pytest.approx(rub, rel=1e-9)
    assert on_table["fx [N]"] == pytest.approx(-rub, rel=1e-4)
    done = result.contact_work["belt"]["friction"]
    power = (done[-1] - done[-6]) / (result.time[-1] - result.time[-6])
    assert on_belt["friction power [W]"] == pytest.approx(power, rel=1e-3)
    loads = body_loads(result, range(result.frames), ["belt", "table"])
    assert loads[-1, 0] == pytest.approx(math.hypot(push, rub), rel=1e-6)
    # what the law itself presses with, of every step: at rest that of the frame
    engine = result.read(PRESSED[0])[-1]
    assert loads[-1] == pytest.approx(engine[::-1], rel=1e-3)


def test_a_wall_that_slides_along_a_rope_on_a_floor_rubs_with_all_its_friction() -> None:
    """0.0007 N were told for 0.0213 N, with a power that gave energy to the ropes."""
    half = g / math.sqrt(2.0)
    floor = Plane(name="floor", friction=0.5)
    wall = Plane(name="wall", normal=(0, 1, 0), friction=0.2, motion=RUNS)
    result = on_a_floor(floor, wall, (0, -half, -half))
    on_wall = last_on(result, "wall")
    rub = on_wall["friction force [N]"]
    assert rub == pytest.approx(0.2 * on_wall["normal force [N]"], rel=1e-3)
    assert on_wall["friction power [W]"] == pytest.approx(-0.5 * rub, rel=1e-3)
    done = result.contact_work["wall"]["friction"]
    power = (done[-1] - done[-6]) / (result.time[-1] - result.time[-6])
    assert on_wall["friction power [W]"] == pytest.approx(power, rel=1e-2)


@pytest.mark.parametrize(
    ("degrees", "friction"),
    [((70.0, -25.0), (0.05, 0.8)), ((60.0, 0.0, -60.0), (0.3, 0.2, 0.5))],
)
def test_no_side_is_told_of_more_than_its_friction(
    degrees: tuple[float, ...], friction: tuple[float, ...]
) -> None:
    """At 0.9 of the limit of the outer two, as the rope creeps in: 1.0024 and 1.0018 of it were told."""
    normals = [(0.0, math.sin(a), math.cos(a)) for a in map(math.radians, degrees)]
    outer = np.array([normals[0][1:], normals[-1][1:]]).T
    pushes = np.linalg.solve(outer, [0.0, 1.0])
    tilt = math.atan(0.9 * float(pushes @ [friction[0], friction[-1]]))
    rope = rw.Rope(
        segments=6,
        length=0.3,
        diameter=0.01,
        made_of=MADE,
        shape=Straight(start=(0, 0, 0.01), end=(0.3, 0, 0.01)),
    )
    sides = [
        Plane(normal=one, point=tuple(np.array([0, 0, 0.01]) - 0.005 * np.array(one)), friction=mu)
        for one, mu in zip(normals, friction, strict=True)
    ]
    down = (g * math.sin(tilt), 0.0, -g * math.cos(tilt))
    run = {"method": "esdirk3", "duration": 0.5, "frame_rate": 50}
    result = rw.simulate(Scene(gravity=down, ropes=[rope], obstacles=sides, run=run))
    used = result.to_pandas("contacts")["friction used [1]"]
    assert 0.8 < used.max() <= 1.0 + 1e-6


@pytest.mark.parametrize("count", [2, 3, 4])
def test_what_can_be_split_is_split_within_the_friction(count: int) -> None:
    """Forces within it are added up and split again; up to 1.0043 of it were told."""
    rng = np.random.default_rng(count)
    for _ in range(200):
        normal = rng.normal(size=(count, 3))
        normal /= np.linalg.norm(normal, axis=1)[:, None]
        most = 10.0 ** rng.uniform(-2.0, 1.0, count)
        part = rng.normal(size=(count, 3))
        part -= (part * normal).sum(axis=1)[:, None] * normal
        part /= np.linalg.norm(part, axis=1)[:, None]
        part *= (rng.choice([0.2, 0.9, 1.0], size=count) * most)[:, None]
        found = split(normal, most, part.sum(axis=0), np.zeros_like(part), np.zeros(count, bool))
        assert (np.linalg.norm(found, axis=1) <= (1.0 + 1e-6) * most).all()
        assert np.allclose(found.sum(axis=0), part.sum(axis=0), rtol=1e-9, atol=1e-12)


def test_what_friction_cannot_carry_is_told_all_the_same() -> None:
    """Two floors at half of the force: each has twice its friction."""
    normal = np.array([[0.0, 0.0, 1.0], [0.0, 0.0, -1.0]])
    found = split(normal, np.ones(2), np.array([4.0, 0, 0]), np.zeros((2, 3)), np.zeros(2, bool))
    assert found == pytest.approx(np.array([[2.0, 0, 0], [2.0, 0, 0]]))


def test_a_rope_between_two_balls_slips_at_the_ratio_that_both_hold() -> None:
    """Of a V-belt, exp(mu angle / cos b), b that of a side to the bottom; told was 1, for both."""
    mu, radius, aside, reach = 0.2, 0.1, 0.06, 0.105
    out = math.sqrt(reach**2 - aside**2)
    rope = laid(half_round(1.01 * out), {0: 1.0, -1: 1.8})
    balls = [
        Sphere(name=name, center=(0, y, 0), radius=radius, friction=mu)
        for name, y in (("left", -aside), ("right", aside))
    ]
    result = rw.equilibrium(Scene(ropes=[rope], obstacles=balls))
    table = result.to_pandas("wraps")
    at_slip, cos = table["ratio at slip [1]"], math.sqrt(1.0 - (aside / reach) ** 2)
    assert len(table) == 2
    assert at_slip.iloc[0] == pytest.approx(math.exp(mu * math.pi / cos), rel=0.02)
    assert at_slip.iloc[1] == pytest.approx(at_slip.iloc[0], rel=1e-6)
    assert table["ratio [1]"].iloc[0] == pytest.approx(1.8, rel=0.01)
