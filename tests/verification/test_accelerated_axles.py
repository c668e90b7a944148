"""What turns freely leads what sticks to it as it turns and as its axle is moved, by the method's own step.

A rope over a pulley whose axle gains a in every second has g + a in place of g; on a free turntable that is
pushed it goes along by m a, and round by m w^2 r.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.core.arrays import Floats
from ropewalk.record.contact_modes import STICKS
from ropewalk.record.result import Result
from ropewalk.scene import Box, Plane, Spin
from verification.test_accelerated_obstacles import FRAME, MASS, MU, g, hoisted, lying, speeding

METHODS = ("implicit-euler", "sdirk2", "esdirk3")
HEAVY = 1e3  # [kg m^2] which ropes of some grams do not turn


def table(kind: str, rate: float, way: tuple[float, float, float]) -> Plane | Box:
    """A turntable in its bearing, round or not, that gains `way` in every second."""
    spin, down = Spin(free=True, inertia=HEAVY, rate=rate), 0.1 if kind == "box" else 0.0
    motion = speeding(np.array(way))
    places = [(x, y, z - down) for x, y, z in motion.positions]
    motion = motion.replace(positions=places)
    if kind == "plane":
        return Plane(name="table", friction=MU, spin=spin, motion=motion)
    return Box(
        name="table", center=(0, 0, -down), half_sizes=(1, 1, down), edge_radius=0.05, friction=MU,
        axis=(0, 0, 1), spin=spin, motion=motion,
    )  # fmt: skip


def over(result: Result) -> Floats:
    """Places of nodes in the frame of what carries them, (t, n, 2) [m]."""
    x, y, _ = np.moveaxis(result.positions - result.obstacle_positions(), -1, 0)
    angle = result.pulley("table").angle[:, None]
    c, s = np.cos(angle), np.sin(angle)
    return np.stack([c * x + s * y, c * y - s * x], axis=-1)


def sticks(result: Result, late: Floats) -> None:
    """The rope does not creep, contacts are told so, and friction only takes."""
    assert np.ptp(over(result)[late], axis=0).max() < 1e-8
    assert np.isin(result.contact_modes[late], STICKS).all()
    contacts = result.to_pandas("contacts")
    slip = contacts["slip speed [m/s]"][contacts["time [s]"] > 0.3]
    assert slip.max() < 1e-4
    assert np.diff(np.asarray(result.contact_work["table"]["friction"])[late]).max() < 1e-12


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("kind", ["plane", "box"])
def test_a_free_turntable_that_is_pushed_takes_along_what_lies_on_it(
    kind: str, method: str
) -> None:
    a = 0.85 * MU * g
    result = rw.simulate(lying(table(kind, 0.0, (a, 0.0, 0.0)), method, 0.6))
    late = result.time > 0.3
    sticks(result, late)
    force = result.contact_force[late][:, :, 0].sum(axis=1)
    np.testing.assert_allclose(force, MASS * a, rtol=1e-3)


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("kind", ["plane", "box"])
def test_a_free_turntable_holds_what_it_carries_round(kind: str, method: str) -> None:
    rate = math.sqrt(0.7 * MU * g / 0.5)
    scene = lying(table(kind, rate, (0.0, 0.0, 0.0)), method, 0.6)
    rope = scene.ropes[0].replace(
        segments=1, length=0.02, shape={
            "kind": "straight", "start": (0.5, -0.01, 0.005), "end": (0.5, 0.01, 0.005),
            "velocity": (0.0, 0.5 * rate, 0.0),
        }
    )  # fmt: skip
    run = scene.run.replace(time_step=FRAME / 4)  # shorter ones than where such steps are cut
    result = rw.simulate(scene.replace(ropes=[rope], run=run))
    late = result.time > 0.3
    sticks(result, late)
    force = np.linalg.norm(result.contact_force[late][:, :, :2].sum(axis=1), axis=1)
    np.testing.assert_allclose(force, 0.002 * rate**2 * 0.5, rtol=1e-3)


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("a", [3.0, -3.0])
def test_a_rope_over_a_pulley_whose_axle_is_accelerated_pulls_by_g_and_a(
    a: float, method: str
) -> None:
    """Half a kilogram with half a segment at each end; over the top by what friction there carries."""
    free = Spin(free=True, inertia=2e-4)
    result = hoisted(method, gain=a, spin=free)
    late = result.tension[result.time > 0.6]
    segment = 2.0 * 0.055 * math.sin(0.5 * math.pi / 12)
    load = 0.5 + 0.5 * 0.05 * segment
    np.testing.assert_allclose(late[:, [0, -1]], load * (g + a), rtol=2e-4)
    top = hoisted("esdirk3", gain=a, spin=free, step=FRAME / 4).tension[-1, 20 + 6]
    np.testing.assert_allclose(late[:, 20 + 6], top, rtol=5e-3)
