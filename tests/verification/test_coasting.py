"""Ropes that nothing pulls: what rounding leaves of their forces and energies cuts no step."""

from __future__ import annotations

import numpy as np
import pytest

from ropewalk.core.status import OK
from ropewalk.methods.stage_report import SPLITS
from ropewalk.scene import Material, Rope, RunSettings, Scene, Straight
from ropewalk.simulation import Simulation


def coasting(method: str, **stuff: float) -> Simulation:
    """A straight rope of 0.6 m that flies askew, far from the origin, where places are rounded more."""
    along = np.array([0.3, -0.7, 0.2]) / np.linalg.norm([0.3, -0.7, 0.2])
    start = np.array([0.11, 0.25, -0.07])
    made_of = Material(EA=66683.57999828721, mass_per_length=0.17, **stuff)
    shape = Straight(
        start=tuple(start), end=tuple(start + 0.6 * along), velocity=(7.1398, -6.5988, -1.5932)
    )
    rope = Rope(segments=6, length=0.6, made_of=made_of, shape=shape)
    run = RunSettings(method=method, duration=0.05, frame_rate=60.0, time_step=1 / 120)
    return Simulation(Scene(ropes=[rope], gravity=(0, 0, 0), run=run))


@pytest.mark.parametrize("stuff", [{}, {"axial_damping": 67.0}, {"EI": 1e-3}])
@pytest.mark.parametrize("method", ["implicit-euler", "sdirk2", "bdf2", "esdirk3"])
def test_a_rope_that_coasts_is_taken_in_whole_steps(method: str, stuff: dict[str, float]) -> None:
    """Rounding stores 1e-28 J in its springs, all that there is: a step that made a little of it, or whose
    friction balanced to no more than rounding, was taken in up to 4096 parts.
    """
    simulation = coasting(method, **stuff)
    begin = simulation.positions.copy()
    assert simulation.advance_steps(3) == OK
    assert simulation._engine._scratch.stage.report[SPLITS] == 0
    moved = simulation.positions - begin
    assert np.abs(moved - 0.025 * np.array([7.1398, -6.5988, -1.5932])).max() < 1e-12
