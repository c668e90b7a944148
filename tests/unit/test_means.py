"""Mean forces over a step, whole for a ledger, else at anchors alone: the same bits."""

from __future__ import annotations

import numpy as np
import pytest

from golden.states import scene
from ropewalk import Anchor, Rope, RunSettings, Scene, Springs
from ropewalk.core.arrays import Forces, blank, copy, flatten
from ropewalk.core.jit import kernel
from ropewalk.lowering import build
from ropewalk.methods.means import share_beside
from ropewalk.methods.scratch import add_forces, begin_forces, clear_forces
from ropewalk.simulation import Simulation


@pytest.mark.parametrize("method", ["euler", "heun", "rk4", "verlet"])
def test_anchors_pull_the_same_without_a_ledger(method: str) -> None:
    """Nodes side by side, in another order, and one let go; a load comes and goes."""
    springs = Springs(
        spring_constant=500.0, node_mass=0.05, spring_friction=0.1, segment_length=0.2
    )
    held = [Anchor(node=node) for node in (6, 0, 5, -1)]
    rope = Rope(segments=9, made_of=springs, kicks=[{"node": 3, "velocity": (0.3, 2.0, 1.0)}])
    run = RunSettings(method=method, time_step=1e-3, frame_rate=100.0, duration=1.0)
    made = Scene(ropes=[rope], anchors=[*held, Anchor(node=1, release_time=0.015)], run=run)
    with_ledger, without = (Simulation(made, ledger=ledger) for ledger in (True, False))
    for load in (0.0, 3.0, 0.0):
        for simulation in (with_ledger, without):
            simulation.apply_force(6, (0.0, load, 0.0))
            simulation.step(0.01)
        assert with_ledger.arrays.reaction.any()
        assert np.array_equal(with_ledger.arrays.reaction, without.arrays.reaction)


def test_a_segment_between_two_anchors_counts_once() -> None:
    """And what is beside none of them stays as it was."""
    order, nodes = np.array([1, 0]), np.array([3, 2])
    force, mean = np.arange(21.0).reshape(3, 7), np.full((3, 7), -1.0)
    share_beside(order, nodes, force, 0.5, True, mean)
    share_beside(order, nodes, force, 0.5, False, mean)
    assert np.array_equal(mean[:, 2:5], force[:, 2:5])
    assert (mean[:, [0, 1, 5, 6]] == -1.0).all()


@kernel
def both_ways(system, source, fresh, whole):
    """Write 0.3 times the forces to two others."""
    begin_forces(system, source, 0.3, fresh)
    clear_forces(system, whole)
    add_forces(system, source, 0.3, whole)


def filled(forces: Forces, rng: np.random.Generator) -> Forces:
    """Return forces of the same shapes, drawn by lot."""
    found = blank(forces)
    for channel in flatten(found).values():
        channel[...] = rng.uniform(-1.0, 1.0, channel.shape)
    return found


@pytest.mark.parametrize("law", ["air-linear", "bending", "limiter", "ground"])
def test_the_first_share_is_that_of_forces_cleared_and_added(law: str) -> None:
    """In all channels that act, of which the source keeps what it had."""
    model = build(scene(law, "verlet"))
    rng = np.random.default_rng(1)
    forces = model.state.forces
    source, whole = filled(forces, rng), filled(forces, rng)
    fresh = copy(whole)
    before = filled(forces, np.random.default_rng(1))
    both_ways(model.system, source, fresh, whole)
    kept, own = flatten(before), flatten(source)
    for name, channel in flatten(fresh).items():
        assert np.array_equal(channel, flatten(whole)[name]), name
        assert np.array_equal(own[name], kept[name]), name
    assert fresh.elastic.any()
