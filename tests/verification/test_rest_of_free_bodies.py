"""Free bodies at rest: `settle` turns them until weight, ropes and bearing balance, and says by how much."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.core import arrays
from ropewalk.laws.wheel_rows import ANGLE
from ropewalk.lowering import Model, build
from ropewalk.scene import Box, Material, Spin, Straight
from ropewalk.statics import Statics, checked_shape
from ropewalk.statics.passing import passes
from ropewalk.statics.pulleys import Pulley

g, MASS, OFF, LEAN = 9.81, 0.5, 0.1, 0.6


def plank(center_of_mass: tuple[float, float, float], **spin: Any) -> Box:
    """A plank that turns about the y axis through its middle."""
    turns = Spin(free=True, inertia=0.02, mass=MASS, center_of_mass=center_of_mass, **spin)
    return Box(
        name="plank", center=(0, 0, 0), half_sizes=(0.3, 0.15, 0.02), edge_radius=0.005, axis=(0, 1, 0),
        spin=turns, friction=spin.pop("friction", 0.0),
    )  # fmt: skip


def scene(body: Box, *, place: float = 0.2, height: float = -0.05, **more: Any) -> rw.Scene:
    """A taut rope along y below the plank's right half, and the plank."""
    rope = rw.Rope(
        segments=4, length=0.999, diameter=0.01,
        made_of=Material(EA=2e3, mass_per_length=0.02, axial_damping=2.0),
        shape=Straight(start=(place, -0.5, height), end=(place, 0.5, height)),
    )  # fmt: skip
    run = {"duration": 0.5, "method": "esdirk3", "time_step": 1e-3, "frame_rate": 100.0}
    anchors = [rw.Anchor(node=0), rw.Anchor(node=-1)]
    given = {"run": run | more.pop("run", {})} | more
    return rw.Scene(ropes=[rope], anchors=anchors, obstacles=[body], **given)


def hanging(**spin: Any) -> rw.Scene:
    """Its mass hangs 0.6 rad aside, and no rope is near."""
    aside = (-OFF * math.sin(LEAN), 0.0, -OFF * math.cos(LEAN))
    return scene(plank(aside, **spin), place=5.0)


def torque_of_weight(angle: float) -> float:
    """Of a mass OFF along x, turned by an angle about y [N m], positive as the angle."""
    return MASS * g * OFF * math.cos(angle)


def torque_of_rope(found: Statics) -> float:
    """Of the rope at its middle node about the y axis, by what its segments pull there [N m]."""
    x, middle = found.positions, 2
    ways = [x[middle - 1] - x[middle], x[middle + 1] - x[middle]]
    pull = sum(
        T * way / np.linalg.norm(way) for T, way in zip(found.tension[1:3], ways, strict=True)
    )
    pull = pull - np.array([0.0, 0.0, 0.02 * 0.999 / 4 * g])
    return float(np.cross(x[middle], pull)[1])


def test_a_pendulum_hangs_straight_down() -> None:
    (body,) = checked_shape(hanging()).pulleys
    assert body.stands
    assert body.angle == pytest.approx(-LEAN, abs=1e-6)
    assert f"turned by -{math.degrees(LEAN):.4g} degrees" in str(body)


def test_a_bearing_holds_it_on_the_way_there() -> None:
    """Where m g d sin a is what the bearing carries; the twin with more of it stays as it is drawn."""
    most = 0.5 * MASS * g * OFF * math.sin(LEAN)
    (body,) = checked_shape(hanging(bearing=most)).pulleys
    left = math.asin(0.5 * math.sin(LEAN))
    assert body.angle == pytest.approx(-(LEAN - left), abs=1e-6)
    assert abs(body.torque) == pytest.approx(most, rel=1e-6)
    (firm,) = checked_shape(hanging(bearing=2.1 * most)).pulleys
    assert firm.stands
    assert firm.angle == 0.0


@pytest.fixture(scope="module")
def leaning() -> Statics:
    return checked_shape(scene(plank((OFF, 0.0, 0.0))))


def test_it_lies_on_a_rope_where_torques_balance(leaning: Statics) -> None:
    """Those of the rope's own segments and of the weight, neither of which the search looks at."""
    (body,) = leaning.pulleys
    assert leaning.solved
    assert body.stands
    assert 0.1 < body.angle < 0.4
    assert torque_of_rope(leaning) == pytest.approx(-torque_of_weight(body.angle), rel=1e-5)


def test_a_damped_run_comes_to_rest_there(leaning: Statics) -> None:
    run = {"duration": 12.0, "time_step": 5e-3, "frame_rate": 10.0}
    result = rw.simulate(scene(plank((OFF, 0.0, 0.0), viscous=0.3), run=run))
    body = result.pulley("plank")
    assert np.ptp(body.angle) > 0.3
    assert body.angle[-20:] == pytest.approx(leaning.pulleys[0].angle, abs=5e-4)
    np.testing.assert_allclose(result.positions[-1], leaning.positions, atol=1e-3)


def test_a_run_that_starts_at_rest_stays_there(leaning: Statics) -> None:
    """The twin starts as it is drawn, and falls on to the rope."""
    still = rw.simulate(scene(plank((OFF, 0.0, 0.0)), run={"start": "at-rest"}))
    body = still.pulley("plank")
    assert body.angle[0] == pytest.approx(leaning.pulleys[0].angle, abs=1e-9)
    assert np.ptp(body.angle) < 1e-6
    assert np.abs(still.positions - still.positions[0]).max() < 1e-6
    assert np.ptp(rw.simulate(scene(plank((OFF, 0.0, 0.0)))).pulley("plank").angle) > 0.1


def test_the_equilibrium_is_a_result_with_the_body_turned(leaning: Statics) -> None:
    rest = rw.equilibrium(scene(plank((OFF, 0.0, 0.0))))
    assert rest.pulley("plank").angle[0] == pytest.approx(leaning.pulleys[0].angle, abs=1e-9)


@pytest.mark.slow
def test_what_has_no_rest_is_left_as_it_is_drawn() -> None:
    """A rope that hangs over one half of a plank without weight turns it until it slides off."""
    rope = rw.Rope(
        segments=4, length=0.2, diameter=0.01, made_of=Material(EA=1e4, mass_per_length=1.0),
        shape=Straight(start=(0.2, -0.1, 0.0251), end=(0.2, 0.1, 0.0251)),
    )  # fmt: skip
    body = plank((0.0, 0.0, 0.0)).replace(spin=Spin(free=True, inertia=0.02), friction=0.3)
    (told,) = checked_shape(scene(body).replace(ropes=[rope], anchors=[])).pulleys
    assert not told.stands
    assert told.angle == 0.0
    assert told.torque == pytest.approx(0.2 * g * 0.2, rel=0.01)


def lever(place: float = 0.8, height: float = -0.1, **spin: Any) -> rw.Scene:
    """One metre to its tip and 10 mm thick: a turn of 0.05 rad takes it past a rope of 10 mm."""
    turns = Spin(
        free=True, inertia=0.1875, mass=MASS, center_of_mass=(0.5, 0.0, 0.0), viscous=2.0, **spin
    )
    body = Box(
        name="plank", center=(0, 0, 0), half_sizes=(1.0, 0.15, 0.005), edge_radius=0.00125,
        axis=(0, 1, 0), spin=turns, friction=0.0,
    )  # fmt: skip
    found = scene(body, place=place, height=height)
    return found.replace(
        ropes=[found.ropes[0].replace(segments=40)]
    )  # the lever goes between no two


def test_a_thin_lever_is_not_turned_through_a_rope() -> None:
    """Where a damped run ends, and not where it would hang without a rope."""
    (found,) = checked_shape(lever()).pulleys
    assert found.stands
    run = {"duration": 1.6, "time_step": 5e-3, "frame_rate": 20.0, "method": "implicit-euler"}
    result = rw.simulate(lever().replace(run=rw.RunSettings(**run)))
    assert np.ptp(result.pulley("plank").angle[-5:]) < 1e-4
    assert found.angle == pytest.approx(float(result.pulley("plank").angle[-1]), abs=2e-5)
    (alone,) = checked_shape(lever(place=5.0)).pulleys
    assert alone.angle == pytest.approx(0.5 * math.pi, abs=1e-6)


def test_what_is_past_a_rope_that_it_bore_is_told() -> None:
    """Both ways; the twin is turned as far with the rope beneath it all the while."""
    model = build(lever(height=-0.0101))

    def turned(angle: float, height: float) -> Model:
        state = arrays.copy(model.state)
        state.memory.obstacle.wheel[0, ANGLE] = angle
        state.x[2] = height
        return replace(model, state=state)

    assert passes(turned(0.0, -0.01), turned(0.05, -0.01), 0)
    assert passes(turned(0.0, 0.01), turned(-0.05, 0.01), 0)
    assert not passes(turned(0.0, -0.01), turned(0.05, -0.0502), 0)


def test_an_unstable_rest_is_told() -> None:
    """With its mass straight above; the twins hang, stand with friction in the bearing, or are just off."""
    (above,) = checked_shape(scene(plank((0.0, 0.0, OFF)), place=5.0)).pulleys
    assert above.stands
    assert above.tips
    assert "does not stay there if it is pushed" in str(above)
    (below,) = checked_shape(scene(plank((0.0, 0.0, -OFF)), place=5.0)).pulleys
    (rubs,) = checked_shape(scene(plank((0.0, 0.0, OFF), bearing=0.01), place=5.0)).pulleys
    (off,) = checked_shape(scene(plank((1e-3, 0.0, OFF)), place=5.0)).pulleys
    for twin in (below, rubs, off):
        assert twin.stands
        assert not twin.tips
        assert "pushed" not in str(twin)


def test_only_what_stands_is_said_to_rest() -> None:
    turned = Pulley("plank", 1.0, 0.1, angle=0.3)
    assert "rests" not in str(turned)
    assert "turns when it is let go" in str(turned)
    assert "rests turned by" in str(replace(turned, torque=0.1))
