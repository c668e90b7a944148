"""What lies on an accelerated body sticks to it: it goes along, by m a, up to the limit, and does not creep.

A method's velocity of a node is what it makes of its way, by implicit Euler the mean of a step. Against the
body's own at the step's end all would slip that sticks.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.core.arrays import Floats
from ropewalk.record.contact_modes import SLIPS, STICKS
from ropewalk.record.result import Result
from ropewalk.scene import (
    Cylinder,
    Load,
    Material,
    Motion,
    Obstacle,
    Plane,
    Points,
    Rope,
    RunSettings,
    Scene,
    Shake,
    Spin,
    Straight,
    Table,
)

g, MU, FRAME = 9.81, 0.3, 1.0 / 60.0
METHODS = ("implicit-euler", "sdirk2", "esdirk3")
MASS = 0.02  # [kg]


def lying(body: Obstacle, method: str, duration: float, *, aside: float = 0.0) -> Scene:
    """A rope of 0.2 m along y, its middle `aside` [m] from where a plane turns."""
    shape = Straight(start=(aside, -0.1, 0.005), end=(aside, 0.1, 0.005))
    made = Material(EA=1e4, mass_per_length=0.1, axial_damping=5.0)
    rope = Rope(segments=4, length=0.2, diameter=0.01, made_of=made, shape=shape)
    run = RunSettings(duration=duration, frame_rate=60.0, method=method, time_step=FRAME)
    return Scene(ropes=[rope], obstacles=[body], run=run)


def speeding(way: Floats) -> Table:
    """A motion that gains |`way`| [m/s] in every second from rest; but at the ends of a second it is no cubic
    spline that does so."""
    times = np.linspace(0.0, 1.0, 41)
    places = [tuple(map(float, 0.5 * t * t * way)) for t in times]
    return Table(times=tuple(map(float, times)), positions=places, interpolation="cubic")


def pushed(share: float, method: str) -> Result:
    """A plane along x at a share of mu g, for 0.6 s of that second."""
    motion = speeding(share * MU * g * np.array([1.0, 0.0, 0.0]))
    return rw.simulate(lying(Plane(friction=MU, motion=motion), method, 0.6))


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("share", [0.34, 0.85])
def test_below_the_limit_it_sticks_and_has_m_a(share: float, method: str) -> None:
    result = pushed(share, method)
    late = result.time > 0.3
    over = (result.positions - result.obstacle_positions())[late]
    assert np.ptp(over[..., 0], axis=0).max() < 1e-6
    force = result.contact_force[late][:, :, 0].sum(axis=1)
    np.testing.assert_allclose(force, MASS * share * MU * g, rtol=1e-3)
    modes = result.contact_modes[late]
    assert np.isin(modes, STICKS).all()


@pytest.mark.parametrize("method", METHODS)
def test_above_the_limit_it_slips_by_what_is_beyond(method: str) -> None:
    """The twin: relative to a plane at 1.05 mu g it is left behind by 0.05 mu g, and told as slipping."""
    result = pushed(1.05, method)
    late = result.time > 0.3
    over = (result.positions - result.obstacle_positions())[late][..., 0].mean(axis=1)
    found = np.diff(over, n=2).mean() / FRAME**2
    assert found == pytest.approx(-0.05 * MU * g, rel=0.02)
    assert np.isin(result.contact_modes[late], SLIPS).all()


@pytest.mark.parametrize("method", METHODS)
def test_a_turntable_holds_what_it_carries_round(method: str) -> None:
    """At 0.7 of the limit, for more than a radian: the way that the middle has over it, turned back."""
    rate = math.sqrt(0.7 * MU * g / 0.5)
    body = Plane(friction=MU, spin=Spin(rate=rate))
    scene = lying(body, method, 0.6, aside=0.5)
    held = scene.ropes[0].replace(
        segments=1, length=0.02, shape=Straight(
            start=(0.5, -0.01, 0.005), end=(0.5, 0.01, 0.005), velocity=(0.0, 0.5 * rate, 0.0)
        )
    )  # fmt: skip
    result = rw.simulate(scene.replace(ropes=[held]))
    middle, angle = result.positions.mean(axis=1), rate * result.time
    out = np.cos(angle) * middle[:, 0] + np.sin(angle) * middle[:, 1]
    along = np.cos(angle) * middle[:, 1] - np.sin(angle) * middle[:, 0]
    late = result.time > 0.3
    assert max(np.ptp(out[late]), np.ptp(along[late])) < 1e-6
    force = np.linalg.norm(result.contact_force[late][:, :, :2].sum(axis=1), axis=1)
    np.testing.assert_allclose(force, 0.002 * rate**2 * 0.5, rtol=2e-3)


@pytest.mark.parametrize("method", ["implicit-euler", "sdirk2"])
def test_a_shaken_table_gets_nothing_from_friction(method: str) -> None:
    """At 0.6 of the limit, from where it turns: the rope goes along, and friction only takes."""
    motion: Motion = Shake(axis=(1, 0, 0), amplitude=0.02, frequency=1.5, phase=0.5 * math.pi)
    result = rw.simulate(lying(Plane(name="table", friction=MU, motion=motion), method, 1.5))
    late = result.time > 0.5
    over = (result.positions - result.obstacle_positions())[late][..., 0]
    assert np.ptp(over, axis=0).max() < 3e-5  # the springs of contacts give 0.02 mm at most
    assert np.abs(over[40:] - over[:-40]).max() < 1e-6  # a period later it is where it was
    rubbed = np.asarray(result.contact_work["table"]["friction"])[late]
    assert np.diff(rubbed).max() < 1e-12


@pytest.mark.parametrize("method", METHODS)
def test_a_floor_that_rises_faster_and_faster_is_told_to_press_by_what_it_does(method: str) -> None:
    a = 1.0
    motion = speeding(np.array([0.0, 0.0, a]))
    result = rw.simulate(lying(Plane(friction=MU, motion=motion), method, 0.6))
    push = result.contact_force[result.time > 0.3][:, :, 2].sum(axis=1)
    np.testing.assert_allclose(push, MASS * (g + a), rtol=1e-3)


@pytest.mark.parametrize("method", ["implicit-euler", "sdirk2"])
def test_an_accelerated_floor_carries_the_rope_no_higher(method: str) -> None:
    """By implicit Euler it lay above the floor by what the damper made of a h / 2."""
    motion = speeding(np.array([0.0, 0.0, 5.0]))
    runs = [
        rw.simulate(lying(Plane(friction=MU, motion=motion), name, 0.4))
        for name in (method, "esdirk3")
    ]
    here, there = ((run.positions - run.obstacle_positions())[-4:, :, 2] for run in runs)
    np.testing.assert_allclose(here, there, atol=2e-6)
    assert (here < 0.005).all()


@pytest.mark.parametrize("method", ["implicit-euler", "sdirk2"])
def test_friction_over_an_accelerated_drum_carries_what_it_does_by_short_steps(method: str) -> None:
    """The damper lifted nodes as the acceleration grew, which drew the rope over the top: 7 % too much."""
    tops = [hoisted(name).tension[-4:, 20 + 6].mean() for name in (method, "esdirk3")]
    assert tops[0] == pytest.approx(tops[1], rel=5e-3)


def hoisted(
    method: str, gain: float = 3.0, spin: Spin | None = None, step: float = FRAME
) -> Result:
    """A rope over a drum whose axle comes to gain so much in every second, half a kilogram at each end."""
    radius, half, hang = 0.055, 12, 20
    angles = np.linspace(math.pi, 0.0, half + 1)
    chord = 2.0 * radius * math.sin(0.5 * math.pi / half)
    down = chord * np.arange(1, hang + 1)
    places = [(-radius, 0.0, -float(z)) for z in down[::-1]]
    places += [(radius * math.cos(a), 0.0, radius * math.sin(a)) for a in angles]
    places += [(radius, 0.0, -float(z)) for z in down]
    rope = Rope(
        segments=len(places) - 1,
        length=chord * (len(places) - 1),
        diameter=0.01,
        made_of=Material(EA=1e5, mass_per_length=0.05, axial_damping=50.0),
        shape=Points(points=places),
        loads=[Load(node=0, mass=0.5), Load(node=-1, mass=0.5)],
    )
    times = np.linspace(0.0, 1.0, 81)
    gains = gain * np.clip(times / 0.5, 0.0, 1.0)
    speeds = np.concatenate([[0.0], np.cumsum(0.5 * (gains[1:] + gains[:-1])) / 80.0])
    rises = np.concatenate([[0.0], np.cumsum(0.5 * (speeds[1:] + speeds[:-1])) / 80.0])
    motion = Table(
        times=tuple(map(float, times)),
        positions=[(0.0, 0.0, float(z)) for z in rises],
        interpolation="cubic",
    )
    drum = Cylinder(
        start=(0, -0.1, 0), end=(0, 0.1, 0), radius=0.05, friction=0.4, motion=motion, spin=spin
    )  # fmt: skip
    run = RunSettings(method=method, duration=0.8, frame_rate=60.0, time_step=step, start="at-rest")
    return rw.simulate(Scene(ropes=[rope], obstacles=[drum], run=run))
