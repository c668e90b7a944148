"""Anchors that let go of ropes that pull at once: rigid links, limiters, and the peak before."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from ropewalk.api import simulate
from ropewalk.scene import Anchor, Limiter, Load, Material, Rope, Scene, Straight, Velocity
from ropewalk.simulation import Simulation

AT_A_STEP, INSIDE = 0.1, 0.1043  # s


def let_go(method: str, time: float, limiter: bool) -> Scene:
    """An oblique rope with 50 kg at its end, let go at its top: it falls without any force in it."""
    EA, reach = (500.0, 1.02) if limiter else (math.inf, 1.0)
    rope = Rope(
        segments=5,
        length=1.0,
        made_of=Material(EA=EA, mass_per_length=0.05),
        shape=Straight(end=(0.6 * reach, 0.0, -0.8 * reach)),
        loads=[Load(node=-1, mass=50.0)],
    )
    run: dict[str, Any] = {"method": method, "duration": 0.3, "frame_rate": 100.0}
    if method == "adaptive":
        run["tolerance"] = 1e-5
    else:
        run |= {"time_step": 0.01, "steps": "exact"}
    more = {"limiter": Limiter(min_stretch=0.0, max_stretch=reach)} if limiter else {}
    return Scene(ropes=[rope], anchors=[Anchor(node=0, release_time=time)], run=run, **more)


@pytest.mark.parametrize("time", [AT_A_STEP, INSIDE])
@pytest.mark.parametrize("limiter", [False, True])
@pytest.mark.parametrize("method", ["implicit-euler", "bdf2", "esdirk3", "adaptive"])
def test_what_was_held_falls_without_a_jerk(method: str, limiter: bool, time: float) -> None:
    """The pull of before was taken into the step after: 35 J from nothing, 555 N in a rope that falls."""
    simulation = Simulation(let_go(method, time, limiter))
    energy, pull = [], []
    for _ in range(30):
        recording = simulation.advance_frames(1).recording
        energy.append(float(recording.energy[-1].sum()))
        pull.append(float(np.abs(recording.tension[-1]).max()))
    assert np.diff(energy).max() < (0.05 if limiter else 1e-3)
    assert max(pull[:9]) > 300.0  # held, it carries the load
    assert max(pull[12:]) < (25.0 if limiter else 0.05)
    top = simulation.velocities[0]
    assert abs(top[2] + 9.81 * (0.3 - time)) < (1.5 if limiter else 0.3)


def test_the_peak_before_a_release_inside_a_step_is_seen() -> None:
    """An end is pulled at 2 m/s until it lets go at 0.165 s, in steps of 1/60 s.

    Only ends of whole steps were looked at, the last one at 0.15 s: 3010 N for 3310 N.
    """
    time, speed, EA = 0.165, 2.0, 1e4
    rope = Rope(
        segments=5,
        length=1.0,
        made_of=Material(EA=EA, mass_per_length=0.01, axial_damping=5.0),
        shape=Straight(end=(1.0, 0.0, 0.0)),
    )
    away = Velocity(velocity=(speed, 0.0, 0.0))
    ends = [Anchor(node=0), Anchor(node=-1, motion=away, release_time=time)]
    run = {"method": "esdirk3", "time_step": 1.0 / 60.0, "duration": 0.3}
    table = simulate(Scene(ropes=[rope], anchors=ends, gravity=(0, 0, 0), run=run)).table
    slowly = EA * speed * time  # of a massless rope, without its damping
    assert table["largest tension [N]"] == pytest.approx(slowly, rel=0.01)
    assert "t = 0.165 s" in table["largest tension at"]
