"""Bodies that are not round and turn freely: an impact, a bearing, a physical pendulum, a cam, the tangent.

A rope that lies along the axis at the distance r from it acts as one mass M: struck at v, a body of inertia I
turns with w = M v r / (I + M r^2), for what hits it does not bounce.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.core.arrays import copy
from ropewalk.laws.wheel_rows import TIE
from ropewalk.lowering import build
from ropewalk.methods.recording import CONSERVATIVE
from ropewalk.scene import (
    Anchor,
    Box,
    Cylinder,
    Kick,
    Material,
    Polyline,
    Rope,
    RunSettings,
    Scene,
    Spin,
    Straight,
)  # fmt: skip
from ropewalk.simulation import Simulation
from ropewalk.statics import checked_shape
from verification.wheel_tangent import tangent_and_differences

g, THICK, MASS, ARM, INERTIA, SPEED = 9.81, 0.01, 0.2, 0.2, 2e-3, 1.0
TOP = 0.02 + 0.5 * THICK
WHOLE = INERTIA + MASS * ARM**2
EXPLICIT, IMPLICIT = ("semi-implicit-euler", 2.5e-6), ("implicit-euler", 2.5e-4)


def lever(spin: Spin | None, *, friction: float = 0.0, tilt: float = 0.0, **more: Any) -> Box:
    """A plank that turns about the y axis through its middle."""
    return Box(
        name="body", center=(0, 0, 0), half_sizes=(0.3, 0.15, 0.02), edge_radius=0.005,
        axis=(0, 1, 0), rotation=(0, tilt, 0), friction=friction, spin=spin, **more,
    )  # fmt: skip


def across(
    body: Any, method: str, step: float, *, x: float = ARM, height: float = TOP + 1e-3,
    gravity: float = 0.0, **run: Any,
) -> Scene:  # fmt: skip
    """A short rope along y over a body, which comes down at a speed, or lies there under gravity."""
    kicks = [Kick(node=k, velocity=(0, 0, -SPEED)) for k in range(5)] if gravity == 0.0 else []
    rope = Rope(
        segments=4, length=0.2, diameter=THICK, made_of=Material(EA=1e4, mass_per_length=1.0),
        shape=Polyline(points=[(x, -0.1, height), (x, 0.1, height)]), kicks=kicks,
    )  # fmt: skip
    settings: dict[str, Any] = {
        "duration": 0.02,
        "frame_rate": 500.0,
        "method": method,
        "time_step": step,
    }
    return Scene(
        ropes=[rope], obstacles=[body], gravity=(0, 0, -gravity),
        run=RunSettings(**(settings | run)),
    )  # fmt: skip


def closes(result: rw.Result) -> float:
    """By how much works differ from the body's change of kinetic energy, over all it turned over [1]."""
    body = result.pulley("body")
    works = body.rope_work + body.bearing_work + body.weight_work
    scale = np.abs([body.energy, body.rope_work, body.weight_work]).max()
    return float(np.abs(body.energy - body.energy[0] - works).max() / scale)


def spun(result: rw.Result, inertia: float) -> tuple[float, float]:
    """Angular momentum about y over that at the start, and the body's rate, at the end."""
    x, v = result.positions, result.velocities
    mass = build(result.scene).state.mass
    turning = ((x[..., 2] * v[..., 0] - x[..., 0] * v[..., 2]) * mass).sum(axis=1)
    speed = result.pulley("body").speed
    whole = turning + inertia * speed
    return float(whole[-1] / whole[0]), float(speed[-1])


@pytest.mark.parametrize(("method", "step"), [EXPLICIT, IMPLICIT])
def test_what_strikes_a_lever_turns_it(method: str, step: float) -> None:
    result = rw.simulate(across(lever(Spin(free=True, inertia=INERTIA)), method, step))
    kept, rate = spun(result, INERTIA)
    assert kept == pytest.approx(1.0, abs=5e-3)
    assert rate == pytest.approx(MASS * SPEED * ARM / WHOLE, rel=0.02)
    assert closes(result) < 1e-9
    assert np.abs(result.balance_residual).max() < 1e-9
    taken = result.work["obstacle"][-1] + result.pulley("body").rope_work[-1]
    lost = 0.5 * MASS * SPEED**2 * INERTIA / WHOLE  # what an impact that does not bounce takes
    assert -taken == pytest.approx(lost, rel=0.05)
    heavy = rw.simulate(across(lever(Spin(free=True, inertia=2.0 * INERTIA)), method, step))
    assert spun(heavy, INERTIA)[0] != pytest.approx(1.0, abs=0.1)  # the twin: another inertia
    still = rw.simulate(across(lever(None), method, step))
    assert still.velocities[-1, 2, 2] > 0.0  # and one that is held lets nothing go on


@pytest.mark.parametrize(("method", "step"), [EXPLICIT, IMPLICIT])
def test_a_cam_is_turned_by_what_presses_on_it(method: str, step: float) -> None:
    """A cylinder about an axis beside its own, without friction: the arm is the way between them."""
    off, radius = 0.03, 0.05
    spin = Spin(free=True, inertia=1e-4, pivot=(-off, 0, 0))
    cam = Cylinder(
        name="body", start=(0, -0.2, 0), end=(0, 0.2, 0), radius=radius, friction=0.0, spin=spin
    )
    height = radius + 0.5 * THICK
    result = rw.simulate(across(cam, method, step, x=0.0, height=height + 1e-3, duration=0.006))
    wanted = MASS * SPEED * off / (1e-4 + MASS * off**2)
    assert result.pulley("body").speed[-1] == pytest.approx(wanted, rel=0.06)
    assert closes(result) < 1e-9
    plain = cam.model_copy(update={"spin": Spin(free=True, inertia=1e-4)})
    alone = rw.simulate(across(plain, method, step, x=0.0, height=height + 1e-3, duration=0.006))
    assert np.abs(alone.pulley("body").speed).max() < 1e-9  # the twin turns by friction only


@pytest.mark.slow
@pytest.mark.parametrize(("method", "step"), [EXPLICIT, IMPLICIT])
def test_a_bearing_holds_a_lever_below_its_torque_and_turns_above(method: str, step: float) -> None:
    torque = MASS * g * ARM
    for share, stands in ((1.1, True), (0.6, False)):
        spin = Spin(free=True, inertia=INERTIA, bearing=share * torque)
        scene = across(
            lever(spin, friction=1.0), method, step, gravity=g, height=TOP, start="at-rest",
            duration=0.06,
        )  # fmt: skip
        body = rw.simulate(scene).pulley("body")
        if stands:
            assert (body.angle == 0.0).all()
            continue
        wanted = 0.5 * (1.0 - share) * torque / WHOLE * 0.06**2
        assert body.angle[-1] == pytest.approx(wanted, rel=0.05)
        assert body.bearing_work[-1] == pytest.approx(-share * torque * body.angle[-1], rel=0.01)
        if method == EXPLICIT[0]:
            continue  # rest is the same of all methods
        (rest,) = checked_shape(scene).pulleys
        assert not rest.stands
        assert abs(rest.torque) == pytest.approx(torque, rel=1e-3)


@pytest.mark.parametrize(
    ("method", "step", "close"), [("semi-implicit-euler", 1e-4, 1e-3), ("esdirk3", 1 / 240, 1e-3)]
)
def test_a_body_whose_mass_is_off_its_axis_swings(method: Any, step: float, close: float) -> None:
    """T = 2 pi sqrt(I / (m g d)) (1 + a^2 / 16) at the amplitude a."""
    mass, off, inertia, lean = 1.0, 0.1, 0.02, 0.05
    spin = Spin(
        free=True, inertia=inertia, mass=mass,
        center_of_mass=(off * math.sin(lean), 0.0, -off * math.cos(lean)),
    )  # fmt: skip
    rope = Rope(
        segments=4, length=0.4, diameter=THICK, made_of=Material(EA=100.0, mass_per_length=1.0),
        shape=Straight(start=(5, 0, 0), direction=(0, 0, -1)),
    )  # fmt: skip
    run = RunSettings(duration=2.0, frame_rate=1000.0, method=method, time_step=step)
    result = rw.simulate(
        Scene(ropes=[rope], anchors=[Anchor(node=0)], obstacles=[lever(spin)], run=run)
    )
    body = result.pulley("body")
    after = np.flatnonzero((body.speed[1:-1] > 0.0) != (body.speed[2:] > 0.0)) + 1
    at = result.time[after] - body.speed[after] * 1e-3 / (body.speed[after + 1] - body.speed[after])
    wanted = 2.0 * math.pi * math.sqrt(inertia / (mass * g * off)) * (1.0 + lean**2 / 16.0)
    assert 2.0 * np.diff(at).mean() == pytest.approx(wanted, rel=close)
    assert closes(result) < 0.01  # what is left is the method's error
    gained = mass * g * off * (np.cos(lean - body.angle) - math.cos(lean))
    np.testing.assert_allclose(body.weight_work, gained, atol=1e-9 * np.ptp(gained))


@pytest.mark.parametrize("share", [0.0, 0.3, 1.0])
@pytest.mark.parametrize(
    ("friction", "bearing"), [(1.0, 0.0), (0.05, 0.0), (0.0, 0.01), (1.0, 1e4)]
)
def test_the_tangent_is_that_of_differences(friction: float, bearing: float, share: float) -> None:
    """With what the body ties, pressed by gravity, in sticking and slipping, standing and turning."""
    spin = Spin(free=True, inertia=INERTIA, bearing=bearing, rate=0.0 if bearing > 1.0 else 0.3)
    scene = across(lever(spin, friction=friction), *IMPLICIT, gravity=g, height=TOP, duration=0.02)
    simulation = Simulation(scene)
    simulation.advance_frames(4)
    state = copy(simulation.arrays)
    found, alone, wanted = tangent_and_differences(
        scene, state, 0.002, 1e-6, press=1e-4, share=share
    )
    assert np.abs(wanted).max() > 1.0
    tie = state.memory.obstacle.wheel[0, TIE]
    assert (tie == 0.0) == (bearing > 1.0)
    if tie > 0.0:
        assert np.abs(found - wanted).max() < 1e-3 * np.abs(alone - wanted).max()
    assert np.abs(found - wanted).max() < 1e-5 * np.abs(wanted).max()


@pytest.mark.parametrize(
    ("spin", "words"),
    [
        ({"mass": 1.0, "center_of_mass": (0.1, 0, 0)}, r"inertia.*at least mass times.*0\.01"),
        ({"center_of_mass": (0.1, 0, 0)}, "mass.*give the mass"),
        ({"axis": (1, 0, 0)}, "axis.*own axis"),
    ],
)
def test_what_cannot_turn_so_is_refused_in_words(spin: dict[str, Any], words: str) -> None:
    with pytest.raises(ValueError, match=words):
        lever(Spin(free=True, inertia=INERTIA, **spin))


@pytest.mark.parametrize("mass", [None, 0.5])
def test_the_energy_rows_of_a_table_add_up(mass: float | None) -> None:
    """A body's own energy was in none of them."""
    more = {} if mass is None else {"mass": mass, "center_of_mass": (-0.05, 0, 0)}
    body = lever(Spin(free=True, inertia=INERTIA, bearing=0.01, **more), friction=0.3)
    result = rw.simulate(across(body, *IMPLICIT, gravity=g, duration=0.1))
    table, own = result.table, result.pulley("body")
    assert table["final kinetic energy at"] == "of the ropes; what turns freely has its own"
    moves = table["final kinetic energy of what turns freely [J]"]
    assert moves == own.energy[-1] > 1e-3
    hung = table.get("final energy of weight of what turns freely [J]", 0.0)
    assert (hung != 0.0) is (mass is not None)
    works = (work[-1] for name, work in result.work.items() if name not in CONSERVATIVE)
    given = sum(works) + own.rope_work[-1] + own.bearing_work[-1]
    gained = table["final total energy [J]"] - result.energy["total"][0] + moves + hung
    assert gained == pytest.approx(given + table["final energy error [J]"], abs=1e-6 * moves)
    still = rw.simulate(across(lever(None), *IMPLICIT, gravity=g, duration=0.01)).table
    assert not any("turns freely" in str(part) for row in still.items() for part in row)
