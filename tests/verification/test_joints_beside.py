"""Joints beside winches, and beside a stretch limiter that is solved for."""

from __future__ import annotations

import numpy as np
import pytest

from ropewalk.api import simulate
from ropewalk.methods.registry import METHODS
from ropewalk.scene import Points, Winch
from ropewalk.simulation import Simulation
from verification.joined import cut, star, tie, uncut
from verification.test_joints import together


@pytest.mark.parametrize("speed", [-0.5, 0.5])
@pytest.mark.parametrize("method", METHODS)
def test_a_winch_winds_a_tied_rope_as_the_uncut_one(method: str, speed: float) -> None:
    """Over a node that comes on to the drum, or goes off it, to rounding; energies, too."""
    steps = {"tolerance": 1e-4, "time_step": "auto"} if method == "adaptive" else {}
    if method == "euler":  # it gains energy in longer ones
        steps = {"time_step": 2e-5}
    ends, works, masses = [], [], []
    for scene, rope in ((uncut(method), "rope"), (cut(method), "first")):
        wound = scene.replace(
            winches=[Winch(rope=rope, end="start", speed=speed)],
            run=scene.run.replace(duration=0.5, **steps),
        )
        simulation = Simulation(wound, ledger=True)
        before = int(simulation.arrays.winch_exit[0])
        simulation.step(0.5)
        assert abs(simulation.arrays.winch_exit[0] - before) == 1
        ends.append(simulation.arrays.x[:, -5:].copy())
        works.append(simulation.arrays.work.winch.copy())
        masses.append(simulation.arrays.mass.sum())
    assert np.abs(ends[1] - ends[0]).max() < (1e-8 if method == "adaptive" else 1e-10)
    assert works[1] == pytest.approx(works[0], rel=1e-6)
    assert masses[1] == pytest.approx(masses[0], rel=1e-12)


@pytest.mark.parametrize("method", ["verlet", "esdirk3"])
def test_a_tied_node_stays_off_the_drum(method: str) -> None:
    """The winch stands with half a segment left to it, and says so; untied it winds on."""
    scene = cut(method)
    first, second = scene.ropes
    knot = tie("knot", ("first", 2), ("second", 0))
    shape = Points(points=[(0.36, 0.04 + 0.02 * i, 1.04 - 0.19 * i) for i in range(5)])
    made = scene.replace(
        ropes=[first, second.replace(shape=shape, kicks=[])],
        joints=[knot],
        winches=[Winch(rope="first", end="start", speed=-0.5)],
        run=scene.run.replace(duration=2.0),
    )
    simulation = Simulation(made)
    simulation.step(0.8)
    assert simulation.winches["winch0"].stopped_by == "held node"
    working = simulation.arrays.rest_length[simulation.arrays.winch_exit[0]]
    assert working == pytest.approx(0.1, abs=1e-9)
    assert together(simulation)
    simulation.cut_joint("knot")
    simulation.step(0.3)
    assert simulation.winches["winch0"].stopped_by == ""


@pytest.mark.parametrize("method", [name for name in METHODS if METHODS[name].holds_links])
def test_bounds_of_the_stretch_hold_in_a_net_of_ropes(method: str) -> None:
    """A load falls into three slack legs that give next to nothing; without the limiter they give a lot."""
    steps = {"tolerance": 1e-4, "time_step": "auto"} if method == "adaptive" else {}
    free = star(method, load=2.0)
    free = free.replace(run=free.run.replace(duration=1.0, **steps))
    bound = free.replace(limiter={"min_stretch": 0.5, "max_stretch": 1.01})
    most = {}
    for name, scene in (("free", free), ("bound", bound)):
        result = simulate(scene)
        assert result.status == "finished"
        lengths = np.linalg.norm(np.diff(result.positions, axis=1), axis=2)
        legs = [slice(7 * k, 7 * k + 6) for k in range(3)]
        nominal = 1.0 / 6.0
        most[name] = max(float(lengths[:, leg].max()) for leg in legs) / nominal
        scale = max(float(np.abs(values).max()) for values in result.energy.values())
        assert result.table["largest balance residual [J]"] < 1e-9 * scale
    assert most["free"] > 1.05
    assert most["bound"] < 1.01 + 1e-6
