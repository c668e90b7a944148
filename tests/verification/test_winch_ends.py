"""Winches at the ends of what they can do: stops, two drums, held nodes, haste, soft ropes."""

from __future__ import annotations

import math

import numpy as np
import pytest

from ropewalk.analysis.check import check
from ropewalk.core.status import OK
from ropewalk.scene import (
    Anchor,
    Hanging,
    Limiter,
    Load,
    Material,
    Rope,
    RunSettings,
    Scene,
    SceneError,
    Springs,
    Straight,
    Winch,
)
from ropewalk.simulation import Broken, Simulation

CORD = Material(EA=100.0, mass_per_length=0.1, axial_damping=1.0)


def winched(*winches: Winch, step: float = 1e-3, duration: float = 2.0, nodes=(0, -1)) -> Scene:
    """A cord of 8 m in 16 segments between anchors at the given nodes."""
    return Scene(
        ropes=[Rope(segments=16, length=8.0, made_of=CORD, shape=Straight(end=(6.0, 0.0, 0.0)))],
        anchors=[Anchor(node=node) for node in nodes],
        winches=winches,
        run=RunSettings(
            duration=duration, time_step=step, steps="exact", method="semi-implicit-euler"
        ),
    )


def length(simulation: Simulation) -> float:
    """Unstretched length off the drums [m]."""
    state = simulation.arrays
    return float(state.rest_length.sum() + state.winch_debt.sum())


def test_a_winch_stops_within_a_step() -> None:
    """Speed times the time it turns, to round-off: 0.1 m/s from 0 to 0.1005 s with steps of 1 ms."""
    simulation = Simulation(winched(Winch(end="start", speed=0.1, stop=0.1005), duration=0.2))
    list(simulation.frames())
    assert length(simulation) == pytest.approx(8.0 + 0.1 * 0.1005, abs=1e-12)


def test_two_winches_share_one_rope() -> None:
    """The shortest length counts the whole rope, however much the other end pays out."""
    winches = (
        Winch(end="start", speed=-1.0, min_length=7.0),
        Winch(end="end", speed=0.5, max_length=20.0),
    )
    simulation = Simulation(winched(*winches, duration=4.0))
    for block in simulation.frames():
        assert block.status == OK
        assert np.isfinite(block.recording.x).all()
    assert length(simulation) == pytest.approx(7.0, abs=0.5 * 1e-3 + 1e-9)  # one step's pay-out


def test_a_held_node_does_not_come_on_to_the_drum() -> None:
    """An anchor two segments from the drum ends the winding; it keeps its node and its place."""
    simulation = Simulation(winched(Winch(end="start", speed=-0.5), duration=4.0, nodes=(0, 2)))
    place = simulation.positions[2].copy()
    for block in simulation.frames():
        assert block.status == OK
    assert simulation.winches["winch0"].stopped_by == "held node"
    assert 7.0 < length(simulation) < 7.5  # the second node stays out; the first is wound on
    assert len(set(simulation.arrays.anchor_node)) == 2
    np.testing.assert_array_equal(simulation.positions[2], place)


@pytest.mark.parametrize(("end", "node"), [("start", 2), ("end", 4)])
def test_a_load_does_not_come_on_to_the_drum(end: str, node: int) -> None:
    """It stayed on the innermost node of the drum for ever, and in the drum's reaction."""
    at_drum = 0 if end == "start" else -1
    cord = Material(EA=300.0, mass_per_length=0.1, axial_damping=5.0)
    way = (0, 0, -3) if end == "start" else (0, 0, 3)
    rope = Rope(
        segments=6,
        length=3.0,
        made_of=cord,
        shape=Straight(start=(0, 0, 0), end=way),
        loads=[Load(node=node, mass=2.0), Load(node=-1 - at_drum, mass=3.0)],
    )
    scene = Scene(
        ropes=[rope],
        anchors=[Anchor(node=at_drum)],
        winches=[Winch(end=end, speed=-1.0)],
        run=RunSettings(duration=2.0, time_step=1e-3, method="semi-implicit-euler"),
    )
    assert any(
        f"the load at node {node} comes to the drum at 0.75 s" in w for w in check(scene).warnings
    )
    simulation = Simulation(scene)
    span = simulation.layout.span("rope")
    simulation.advance_frames(60)
    assert simulation.winches["winch0"].stopped_by == "load"
    assert simulation.winches["winch0"].paid_out == pytest.approx(-0.75, abs=2e-3)
    mass = simulation.arrays.mass
    assert mass[span.start + node] > 2.0
    assert (
        np.delete(mass, [span.start + node, span.end if at_drum == 0 else span.start]).max() < 0.1
    )
    simulation.winches["winch0"].speed = 0.5
    simulation.advance_frames(30)
    assert simulation.winches["winch0"].length == pytest.approx(2.5, abs=2e-3)
    assert simulation.arrays.mass[span.start + node] == pytest.approx(2.05, abs=0.03)


def test_a_winch_too_fast_for_the_step_is_refused() -> None:
    with pytest.raises(SceneError, match=r"run\.time_step: .*must be at most"):
        Simulation(winched(Winch(end="start", speed=-200.0), step=1e-3))


def test_a_soft_rope_under_its_weight_is_not_broken() -> None:
    """k = 50 N/m, 5 springs of 0.1 m with 1 kg nodes: the top one rests at 1 + 5 m g / (k L) = 10.8."""
    springs = Springs(spring_constant=50.0, node_mass=1.0, segment_length=0.1, spring_friction=5.0)
    simulation = Simulation(
        Scene(
            ropes=[Rope(segments=5, made_of=springs, shape=Hanging())],
            anchors=[Anchor(node=0)],
            run=RunSettings(duration=40.0, time_step=1 / 240, method="semi-implicit-euler"),
        )
    )
    for block in simulation.frames():
        assert block.status == OK
    stretch = np.linalg.norm(np.diff(simulation.positions, axis=0), axis=1)[0] / 0.1
    # the slowest mode decays as exp(-c mu t / 2 m), mu = 4 sin^2(pi / 22): exp(-8) after 40 s
    slowest = math.exp(-0.5 * 5.0 * 4.0 * math.sin(math.pi / 22) ** 2 * 40.0)
    assert stretch == pytest.approx(1.0 + 5 * 9.81 / 5.0, rel=2.0 * slowest + 1e-9)


@pytest.mark.parametrize("method", ["implicit-euler", "bdf2", "esdirk3"])
def test_a_step_without_solution_winds_no_farther_than_it_came(method: str) -> None:
    """A winch takes in what is held at its far end, until the bound of the stretch ends the run in the middle
    of a step: what is out then is what was wound up to that time, and weighs as much.
    """
    rope = Rope(
        segments=10,
        length=2.0,
        made_of=Material(EA=5000.0, mass_per_length=0.1, axial_damping=5.0),
        shape=Straight(end=(1.99, 0.0, 0.0)),
    )
    simulation = Simulation(
        Scene(
            ropes=[rope],
            anchors=[Anchor(node=0), Anchor(node=-1)],
            winches=[Winch(end="start", speed=-0.137)],
            limiter=Limiter(min_stretch=0.5, max_stretch=1.02),
            run=RunSettings(duration=3.0, frame_rate=60.0, time_step=1.0 / 60.0, method=method),
        )
    )
    with pytest.raises(Broken, match="found no solution"):
        simulation.step(1.0)
    frames = 60.0 * simulation.time
    assert 0.35 < simulation.time < 0.36
    assert abs(frames - round(frames)) > 0.1  # it is inside a step
    assert length(simulation) == pytest.approx(2.0 - 0.137 * simulation.time, abs=1e-12)
    assert simulation.arrays.mass.sum() == pytest.approx(0.1 * length(simulation), abs=1e-12)
