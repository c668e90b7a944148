"""Winding within a step: nothing is lost between two drums, nor where a step fails, and orders are kept."""

from __future__ import annotations

import pytest

from ropewalk.scene import Anchor, Material, Rope, RunSettings, Scene, Straight, Winch
from ropewalk.simulation import Simulation

G = 9.80665  # [m/s^2]


def between(method: str, segments: int, speeds: tuple[float, float]) -> Scene:
    """A slack rope of 1 m between two drums 0.9 m apart."""
    steps = {"tolerance": 1e-3} if method == "adaptive" else {"time_step": 1e-4}
    rope = Rope(
        segments=segments,
        length=1.0,
        made_of=Material(EA=100.0, mass_per_length=0.1, axial_damping=0.1),
        shape=Straight(start=(0, 0, 0), end=(1.0, 0, 0)),
    )
    winches = [
        Winch(end=end, speed=speed, on_drum=1.0)
        for end, speed in zip(("start", "end"), speeds, strict=True)
    ]
    return Scene(
        ropes=[rope],
        anchors=[Anchor(node=0), Anchor(node=-1)],
        winches=winches,
        gravity=(0, 0, 0),
        run=RunSettings(method=method, duration=0.5, **steps),
    )


@pytest.mark.parametrize(
    "method", ["euler", "semi-implicit-euler", "verlet", "rk4", "bdf2", "sdirk2", "adaptive"]
)
def test_two_drums_lose_no_rope(method: str) -> None:
    """What is out is what was out, and what was paid out: with few segments both work on the same ones."""
    for segments in (1, 2, 3):
        for speeds in ((-0.2, 0.2), (0.3, 0.3), (0.8, 0.5), (-0.4, -0.4)):
            simulation = Simulation(between(method, segments, speeds))
            before = simulation.arrays.mass.sum()
            simulation.step(0.5)
            state = simulation.arrays
            out = state.rest_length.sum() + state.winch_debt.sum()
            assert out == pytest.approx(1.0 + state.winch_paid.sum(), abs=1e-9), (segments, speeds)
            grown = 0.1 * state.winch_paid.sum()
            assert state.mass.sum() == pytest.approx(before + grown, abs=1e-9), (segments, speeds)


def hoisted(method: str, steps: int) -> float:
    """How high a load on a damped rope is, 0.15 s after its winch has started [m]."""
    rope = Rope(
        segments=8,
        length=4.0,
        made_of=Material(EA=5000.0, mass_per_length=0.1, axial_damping=400.0),
        loads=[{"node": -1, "mass": 20.0}],
        shape={"kind": "hanging"},
    )
    scene = Scene(
        ropes=[rope],
        anchors=[Anchor(node=0)],
        winches=[Winch(end="start", speed=-0.5, start=0.05)],
        gravity=(0.0, 0.0, -G),
        run=RunSettings(method=method, time_step=1.0 / steps, duration=0.2, start="at-rest"),
    )
    simulation = Simulation(scene)
    simulation.step(0.2)
    return float(simulation.positions[-1, 2])


@pytest.mark.parametrize(
    ("method", "most"),
    [("esdirk3", 1e-5), ("bdf2", 3e-4), ("generalized-alpha", 1.5e-4), ("sdirk2", 1e-4)],
)
def test_a_start_costs_no_order(method: str, most: float) -> None:
    """Friction along the rope knows the rate of winding; with those of the rate before, it was one."""
    lead = hoisted("esdirk3", 5120)
    coarse, fine = (abs(hoisted(method, steps) - lead) for steps in (40, 160))
    assert coarse < most
    assert fine < coarse / 6.0  # of order one it would be a quarter
