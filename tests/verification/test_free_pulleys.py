"""Obstacles that turn freely: an Atwood machine against its closed form, its bearing, its ledger, its slip.

With the ropes' middle at the radius r, two loads M and m, a rope of mass m' and a wheel of inertia I, without
slip:  a = ((M - m) g - bearing / r) / (M + m + m' + I / r^2) , as long as the rope's two sides are alike.
"""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.core.arrays import copy, flatten
from ropewalk.laws.wheel_rows import TIE, TRIAL
from ropewalk.lowering import build
from ropewalk.scene import Cylinder, Load, Material, Polyline, Rope, RunSettings, Scene, Spin
from ropewalk.simulation import Simulation
from ropewalk.statics import checked_shape
from verification.wheel_tangent import tangent_and_differences

g, RADIUS, THICK, SIDE = 9.81, 0.05, 0.01, 0.3
r, LINE, HEAVY, LIGHT, INERTIA = RADIUS + 0.5 * THICK, 1e-3, 1.0, 0.6, 2e-3
ROPE = LINE * (2.0 * SIDE + math.pi * r)
FREE = Spin(free=True, inertia=INERTIA)


def atwood(
    spin: Spin | None = FREE, *, friction: float = 1.0, light: float = LIGHT, **run: Any
) -> Scene:
    """Two loads on a light rope over a wheel of 5 cm."""
    arc = [(-r * math.cos(a), 0.0, r * math.sin(a)) for a in np.linspace(0.0, math.pi, 49)]
    points = [(-r, 0.0, -SIDE), *arc, (r, 0.0, -SIDE)]
    explicit = run.get("method") == "semi-implicit-euler"  # steps would be shorter than 0.1 us
    rubs = 0.02 if explicit else 5.0
    made_of = Material(
        EA=2e4, mass_per_length=20.0 * LINE if explicit else LINE, axial_damping=rubs
    )
    loads = [Load(node=0, mass=HEAVY), Load(node=-1, mass=light)]
    rope = Rope(
        segments=80, length=2.0 * SIDE + math.pi * r, diameter=THICK, made_of=made_of,
        shape=Polyline(points=points), loads=loads,
    )  # fmt: skip
    wheel = Cylinder(
        name="wheel", start=(0, -0.1, 0), end=(0, 0.1, 0), radius=RADIUS, friction=friction,
        compliance=1e-5, spin=spin,
    )  # fmt: skip
    settings = {"duration": 0.3, "frame_rate": 60.0, "time_step": 1.0 / 240.0}
    settings |= {"method": "implicit-euler", "start": "at-rest"}
    return Scene(ropes=[rope], obstacles=[wheel], run=RunSettings(**(settings | run)))


def acceleration(inertia: float = INERTIA, bearing: float = 0.0, light: float = LIGHT) -> float:
    """That of the closed form [m/s^2]."""
    return ((HEAVY - light) * g - bearing / r) / (HEAVY + light + ROPE + inertia / r**2)


def fallen(result: rw.Result) -> tuple[float, float]:
    """Mean acceleration of the heavy load and of the wheel's rim over a run from rest [m/s^2]."""
    over = 2.0 / result.time[-1] ** 2
    drop = result.positions[0, 0, 2] - result.positions[-1, 0, 2]
    return over * float(drop), -over * r * float(result.pulley("wheel").angle[-1])


def closes(result: rw.Result) -> float:
    """By how much works differ from the wheel's change of kinetic energy, over all it turned over [1]."""
    wheel = result.pulley("wheel")
    left = wheel.energy - wheel.energy[0] - wheel.rope_work - wheel.bearing_work
    scale = np.abs([wheel.energy, wheel.rope_work, wheel.bearing_work]).max()
    return float(np.abs(left).max() / scale)


# -- against the closed form ---------------------------------------------------------------------


@pytest.mark.parametrize(
    ("method", "step"),
    [
        ("implicit-euler", 1 / 960),
        ("esdirk3", 1 / 240),
        ("bdf2", 1 / 240),
        ("semi-implicit-euler", 5e-6),
    ],
)
def test_an_atwood_machine_falls_as_its_wheel_lets_it(method: str, step: float) -> None:
    result = rw.simulate(atwood(method=method, time_step=step))
    load, rim = fallen(result)
    assert load == pytest.approx(acceleration(), rel=0.01)
    assert rim == pytest.approx(acceleration(), rel=0.01)
    assert load != pytest.approx(acceleration(inertia=0.0), rel=0.2)  # it is the wheel's inertia
    assert closes(result) < 1e-12
    assert np.abs(result.balance_residual).max() < 1e-9


@pytest.mark.parametrize("method", ["implicit-euler", "semi-implicit-euler"])
def test_a_wheel_turns_alike_as_a_body_that_is_not_round(method: str) -> None:
    """With its axis beside its middle by a nanometre all that presses turns it, which is nothing more."""
    step = 1 / 960 if method == "implicit-euler" else 5e-6
    beside = Spin(free=True, inertia=INERTIA, bearing=0.08, pivot=(1e-9, 0.0, 0.0))
    plain = Spin(free=True, inertia=INERTIA, bearing=0.08)
    found, wanted = (
        rw.simulate(atwood(spin, method=method, time_step=step, duration=0.1))
        for spin in (beside, plain)
    )
    assert build(found.scene).system.node.obstacle.sweeps.tolist() == [1]
    assert build(wanted.scene).system.node.obstacle.sweeps.tolist() == [0]
    np.testing.assert_allclose(found.positions, wanted.positions, atol=1e-7)
    angle = wanted.pulley("wheel").angle
    np.testing.assert_allclose(found.pulley("wheel").angle, angle, atol=1e-5 * np.ptp(angle))
    assert closes(found) < 1e-9


def test_a_bearing_takes_its_torque() -> None:
    torque = 0.08
    spin = Spin(free=True, inertia=INERTIA, bearing=torque)
    result = rw.simulate(atwood(spin, time_step=1 / 960))
    assert fallen(result)[0] == pytest.approx(acceleration(bearing=torque), rel=0.01)
    wheel = result.pulley("wheel")
    assert wheel.bearing_work[-1] == pytest.approx(torque * wheel.angle[-1], rel=0.01)
    assert closes(result) < 1e-12
    drop = np.diff(wheel.bearing_work)
    assert (drop <= 0.0).all()


@pytest.mark.parametrize("light", [0.9, 1.0])
def test_below_its_torque_a_bearing_holds_still(light: float) -> None:
    """0.1 kg on r is 0.054 N m: a bearing of 0.06 N m holds the wheel, exactly."""
    result = rw.simulate(atwood(Spin(free=True, inertia=1e-5, bearing=0.06), light=light))
    wheel = result.pulley("wheel")
    assert (wheel.speed == 0.0).all()
    assert (wheel.angle == 0.0).all()
    still = result.positions[result.time > 0.1]
    assert np.abs(still - still[-1]).max() < 1e-6


def test_a_viscous_bearing_lets_it_come_to_a_speed() -> None:
    """(M - m) g r = viscous w at last; the time for it is (M + m + I/r^2) r^2 / viscous."""
    viscous = 0.1
    found = rw.simulate(atwood(Spin(free=True, inertia=INERTIA, viscous=viscous), duration=0.4))
    last = (HEAVY - LIGHT) * g * r / viscous
    pace = (HEAVY + LIGHT + ROPE + INERTIA / r**2) * r**2 / viscous
    time, speed = found.time, -found.pulley("wheel").speed
    np.testing.assert_allclose(speed[9:], last * (1.0 - np.exp(-time[9:] / pace)), rtol=0.015)


def test_the_rope_slips_where_the_wheel_is_too_heavy_for_its_friction() -> None:
    """A wheel that hardly turns is a drum: the heavy side falls with T1 = T2 exp(mu pi)."""
    friction = 0.1
    result = rw.simulate(atwood(Spin(free=True, inertia=10.0), friction=friction, start="shape"))
    gain = math.exp(friction * math.pi)
    wanted = g * (HEAVY - LIGHT * gain) / (HEAVY + LIGHT * gain)
    late = result.time > 0.1  # its drawn shape falls onto the wheel first
    load = -np.polyfit(result.time[late], result.velocities[late, 0, 2], 1)[0]
    assert load == pytest.approx(wanted, rel=0.005)
    assert abs(fallen(result)[1]) < 1e-3
    modes = result.contact_modes[-1]
    assert (modes[modes > 0] == 2).all()
    stuck = rw.simulate(atwood()).contact_modes[-1]  # the twin whose wheel goes along
    assert (stuck == 1).sum() > 5 * (stuck == 2).sum()  # it slips where it comes up, at most


def test_the_lightest_wheel_is_stable() -> None:
    """One of a microgram's inertia: the rope runs over it as over no wheel, one tension on both sides."""
    spin = Spin(free=True, inertia=1e-12)
    result = rw.simulate(atwood(spin, time_step=1 / 240))
    assert fallen(result)[0] == pytest.approx(acceleration(inertia=0.0), rel=0.02)
    tension = result.tension[-1]
    assert tension[0] == pytest.approx(tension[-1], rel=0.01)


@pytest.mark.parametrize(
    ("method", "least", "most"), [("implicit-euler", 1.8, 2.2), ("esdirk3", 3.4, 5.0)]
)
def test_a_wheel_has_the_order_of_the_stages(method: str, least: float, most: float) -> None:
    """Errors of its angle fall to a half and to a quarter with half the step."""
    angles = [
        rw.simulate(atwood(method=method, time_step=step, duration=0.1)).pulley("wheel").angle[-1]
        for step in (1 / 480, 1 / 960, 1 / 1920)
    ]
    assert least < (angles[0] - angles[1]) / (angles[1] - angles[2]) < most


# -- the tangent -----------------------------------------------------------------------------------


@pytest.mark.parametrize("share", [0.0, 0.3, 1.0])
@pytest.mark.parametrize(
    ("friction", "bearing"), [(1.0, 0.0), (0.3, 0.005), (0.05, 0.0), (1.0, 10.0)]
)
def test_the_tangent_is_that_of_differences(friction: float, bearing: float, share: float) -> None:
    """With what the wheel ties, in sticking and slipping, with a bearing that turns and one that holds."""
    spin = Spin(free=True, inertia=INERTIA, bearing=bearing, rate=3.0)
    scene = atwood(spin, friction=friction, start="shape", duration=0.05)
    simulation = Simulation(scene)
    simulation.advance_frames(1)
    state = copy(simulation.arrays)
    found, alone, wanted = tangent_and_differences(scene, state, 0.004, 2e-5, share=share)
    wheel = state.memory.obstacle.wheel[0]
    tie = wheel[TIE]
    assert (tie == 0.0) == (bearing > 1.0) == (wheel[TRIAL] == 0.0)
    if tie > 0.0:
        assert np.abs(found - wanted).max() < 1e-3 * np.abs(alone - wanted).max()
    assert np.abs(found - wanted).max() < 1e-5 * np.abs(wanted).max()


# -- state, record, words ----------------------------------------------------------------------------


@pytest.mark.parametrize("method", ["implicit-euler", "semi-implicit-euler"])
def test_a_run_that_goes_on_has_the_bits_of_one_in_a_piece(method: str) -> None:
    scene = atwood(method=method, time_step=5e-6, duration=0.1)
    whole, first = Simulation(scene), Simulation(scene)
    whole.advance_frames(6)
    first.advance_frames(2)
    second = Simulation(scene)
    second.restore(first.state)
    second.advance_frames(4)
    one, two = flatten(whole.arrays), flatten(second.arrays)
    assert one["memory.obstacle.wheel"][0, 0] != 0.0
    for name, array in one.items():
        np.testing.assert_array_equal(array, two[name], err_msg=name)


def test_what_is_recorded_is_in_folder_dataset_and_tables(tmp_path: Path) -> None:
    scene = atwood(duration=0.1)
    result = rw.simulate(scene)
    result.save(tmp_path / "run")
    kept = rw.Result.open(tmp_path / "run")
    wheel = result.pulley("wheel")
    np.testing.assert_array_equal(kept.pulley("wheel"), wheel)
    data = result.datasets["pulleys"]["pulleys"]
    assert data.dims == ("time", "pulley", "motion")
    np.testing.assert_array_equal(data.sel(pulley="wheel", motion="speed"), wheel.speed)
    table = result.to_pandas("pulleys")
    np.testing.assert_array_equal(table["work of ropes [J]"], wheel.rope_work)
    with pytest.raises(KeyError, match="turn freely, wheel, not 'drum'"):
        result.pulley("drum")
    angles = result.obstacle_angles()
    np.testing.assert_array_equal(angles[:, 0], wheel.angle)
    for frames in (slice(None, None, -1), slice(-2, None), slice(5, 1, -2), slice(3, 3)):
        np.testing.assert_array_equal(result.obstacle_angles(frames), angles[frames])


def test_the_table_of_a_run_says_how_fast_it_turns_and_what_its_axle_carries() -> None:
    """At the start M (g - a) + m (g + a) and the line; twice, where it is found contact by contact."""
    result = rw.simulate(atwood(duration=0.2))
    table = result.table
    assert table["largest rate of a pulley [rad/s]"] == np.abs(result.pulley("wheel").speed).max()
    assert table["largest rate of a pulley at"].startswith("pulley 'wheel', t = ")
    a, line = acceleration(), sum(rope.own_mass for rope in result.scene.ropes)
    loads = sum(load.mass for load in result.scene.ropes[0].loads)
    heavy = loads - LIGHT
    pull = heavy * (g - a) + LIGHT * (g + a) + line * g
    from ropewalk.record.moving_rows import axle_loads

    found = axle_loads(result, range(result.frames))[:, 0]
    assert table["largest load on the axle of a pulley [N]"] >= 0.999 * found.max()
    assert found[found > 0.0].mean() == pytest.approx(pull, rel=0.03)
    body = result.scene.obstacles[0]
    far = body.model_copy(
        update={"name": "far", "spin": None, "start": (9, 0, 0), "end": (9, 1, 0)}
    )
    both = rw.simulate(result.scene.model_copy(update={"obstacles": (body, far)}))
    np.testing.assert_allclose(
        axle_loads(both, range(5, 9))[:, 0],
        np.linalg.norm(both.contact_force[5:9].sum(axis=1), axis=1),
        rtol=1e-9,
    )


def test_two_ropes_on_one_wheel_turn_it_together() -> None:
    """Each of two machines side by side on one wheel of twice the inertia does what one on its own does."""
    one = atwood()
    rope = one.ropes[0]
    aside = [(x, 0.05, z) for x, _, z in rope.shape.points]
    other = rope.model_copy(
        update={"name": "other", "shape": rope.shape.model_copy(update={"points": tuple(aside)})}
    )
    body = one.obstacles[0].model_copy(update={"spin": Spin(free=True, inertia=2.0 * INERTIA)})
    both = one.model_copy(update={"ropes": (rope, other), "obstacles": (body,)})
    alone, found = rw.simulate(one), rw.simulate(both)
    count = alone.nodes
    np.testing.assert_allclose(found.positions[:, :count], alone.positions, atol=2e-4)
    np.testing.assert_allclose(found.positions[:, count:, 2], alone.positions[..., 2], atol=2e-4)


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ({"free": True}, r"inertia.*moment of inertia.*m R\^2 / 2"),
        ({"free": True, "inertia": 0.0}, "inertia.*greater than 0"),
        ({"free": True, "inertia": 1e-3, "start": 1.0}, "start.*turned"),
        ({"inertia": 1e-3, "rate": 1.0}, "inertia.*free = true"),
    ],
)
def test_what_cannot_be_a_pulley_is_refused_in_words(given: dict[str, Any], words: str) -> None:
    with pytest.raises(ValueError, match=words):
        Spin(**given)


def test_at_rest_it_is_held_and_says_whether_its_bearing_would_hold_it() -> None:
    """The ropes' torque is the difference of the loads times the radius."""
    expected = (HEAVY - LIGHT) * g * r
    for bearing, stands in ((0.0, False), (0.95 * expected, False), (1.05 * expected, True)):
        spin = Spin(free=True, inertia=INERTIA, bearing=bearing)
        (pulley,) = checked_shape(atwood(spin)).pulleys
        assert abs(pulley.torque) == pytest.approx(expected, rel=0.01)
        assert pulley.stands is stands
        assert ("turns when it is let go" in str(pulley)) is not stands
