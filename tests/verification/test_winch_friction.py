"""What friction takes in the rope at a drum, against its own integral; the rest of its work is the drum's."""

from __future__ import annotations

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.scene import Anchor, Load, Material, Rope, RunSettings, Scene, Straight, Winch

C, SEGMENTS, LENGTH, TIME = 400.0, 6, 3.0, 0.03  # N s, 1, m, s
STEPS = {"semi-implicit-euler": 2e-5, "rk4": 5e-5, "verlet": 5e-5, "esdirk3": 2e-4, "sdirk2": 2e-4}


def paid_out(method: str, speed: float, damping: float = C) -> rw.Result:
    """A load whose rope begins to be wound at once, every step a frame."""
    rope = Rope(
        segments=SEGMENTS,
        length=LENGTH,
        made_of=Material(EA=2e4, mass_per_length=0.3, axial_damping=damping),
        shape={"kind": "hanging"},
        loads=[Load(node=-1, mass=20.0)],
    )
    step = STEPS[method]
    return rw.simulate(
        Scene(
            ropes=[rope],
            anchors=[Anchor(node=0)],
            winches=[Winch(end="start", speed=speed, on_drum=2.0)],
            run=RunSettings(method=method, time_step=step, duration=TIME, frame_rate=1.0 / step),
        )
    )


def integrals(result: rw.Result) -> tuple[float, float]:
    """What friction takes, -int c L (d(r/L)/dt)^2 dt, and what it does along dr, off the drum [J]."""
    x, L = np.asarray(result.positions), np.asarray(result.rest_length)
    off = L.min(axis=0) > 0.0
    L, r = L[:, off], np.linalg.norm(np.diff(x, axis=1), axis=-1)[:, off]
    mean, strain = 0.5 * (L[1:] + L[:-1]), np.diff(r / L, axis=0)
    rate = C * strain / np.diff(np.asarray(result.time))[:, None]
    return -float((rate * mean * strain).sum()), -float((rate * np.diff(r, axis=0)).sum())


@pytest.mark.parametrize("speed", [0.6, -0.6])
@pytest.mark.parametrize("method", sorted(STEPS))
def test_friction_takes_what_the_rate_of_strain_takes(method: str, speed: float) -> None:
    """It only takes, in every step; what it does along the way of the nodes, the twin, is far off that."""
    result = paid_out(method, speed)
    friction = np.asarray(result.work["friction"])
    takes, twin = integrals(result)
    assert friction[-1] == pytest.approx(takes, rel=0.01)
    assert np.diff(friction).max() <= 0.0
    assert abs(twin - takes) > 0.4 * abs(takes)


@pytest.mark.parametrize("speed", [0.6, -0.6])
def test_the_drum_is_pulled_by_friction_too(speed: float) -> None:
    """The winch's work is that of the whole tension at the drum, less what the rope lets go of."""
    result = paid_out("rk4", speed)
    L = np.asarray(result.rest_length)
    working = int(np.argmax(np.abs(L[-1] - L[0])))
    x = np.asarray(result.positions)
    strain = np.linalg.norm(x[:, working + 1] - x[:, working], axis=-1) / L[:, working] - 1.0
    pull = np.asarray(result.tension)[:, working]
    power = -speed * ((1.0 + strain) * pull - 0.5 * 2e4 * strain**2)
    t = np.asarray(result.time)
    work = float((0.5 * (power[1:] + power[:-1]) * np.diff(t)).sum())
    assert np.asarray(result.work["winch"])[-1] == pytest.approx(work, rel=0.01)
    spring = -speed * 2e4 * (strain + 0.5 * strain**2)  # the twin: without friction
    without = float((0.5 * (spring[1:] + spring[:-1]) * np.diff(t)).sum())
    assert abs(without - work) > 0.3 * abs(work)


@pytest.mark.parametrize("ledger", [True, False])
@pytest.mark.parametrize("method", sorted(STEPS))
def test_what_friction_hauls_was_given_without_a_ledger_too(method: str, ledger: bool) -> None:
    """A soft damped rope hauls a load: friction pulls, the spring is idle, and nothing has made up energy."""
    rope = Rope(
        segments=3,
        length=1.5,
        made_of=Material(EA=10.0, mass_per_length=0.1, axial_damping=100.0),
        shape=Straight(start=(0, 0, 0), end=(1.5, 0, 0)),
        loads=[Load(node=-1, mass=1.0)],
    )
    run = RunSettings(method=method, time_step=5e-5, duration=0.06, frame_rate=50.0)
    winch = Winch(end="start", speed=-0.5, start=0.01)
    scene = Scene(
        ropes=[rope], anchors=[Anchor(node=0)], winches=[winch], gravity=(0, 0, 0), run=run
    )
    result = rw.simulate(scene, ledger=ledger)
    assert result.status == "finished"
    assert (
        np.asarray(result.energy["kinetic"])[-1] > 100.0 * np.asarray(result.energy["elastic"])[-1]
    )
