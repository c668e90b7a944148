"""A step that is taken and taken back leaves nothing behind."""

from __future__ import annotations

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.simulation.warming import warm_up


def made(method: str) -> rw.Simulation:
    """A rope whose end is on its way to somewhere."""
    scene = rw.preset("r4")
    simulation = rw.Simulation(
        scene.replace(run=scene.run.replace(method=method, time_step="auto"))
    )
    simulation.advance_frames(2)
    anchor = simulation.anchors[simulation.layout.anchor_names[0]]
    anchor.move_to(anchor.position + np.array([0.0, 0.05, 0.0]))
    return simulation


@pytest.mark.parametrize("method", ["semi-implicit-euler", "sdirk2"])
def test_a_step_taken_back_leaves_nothing(method: str) -> None:
    """The twin that was not warmed goes the same way, to the same bits, where its anchor was sent, too."""
    warmed, other = made(method), made(method)
    before = warmed.positions.copy()
    warm_up(warmed)
    assert np.array_equal(warmed.positions, before)
    assert warmed.clock == other.clock
    for simulation in (warmed, other):
        simulation.advance_frames(2)
    assert np.array_equal(warmed.positions, other.positions)
    assert np.array_equal(warmed.recording().recording.work, other.recording().recording.work)
    assert not np.array_equal(warmed.positions, before)
