"""Pages tell of ropes on shaken bodies what tables do: implicit Euler's velocities are means of a step."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
import pytest

import ropewalk as rw
from live.test_touch import over_a_drum
from ropewalk.live.recorded import Recorded
from ropewalk.live.touch import wound_on, wraps_now
from ropewalk.record.contacts import Lying, each_frame, lying
from ropewalk.record.result import Result
from ropewalk.scene import Scene
from ropewalk.simulation import Simulation


def shaken() -> Scene:
    """A drum under a sliding rope, shaken up and down with 20 m/s2, in one step of implicit Euler a frame."""
    shake = {"kind": "shake", "axis": (0, 0, 1), "amplitude": 0.02, "frequency": 5.0}
    run = {"run.frame_rate": 250.0, "run.time_step": 0.004}
    return over_a_drum().replace(**run, **{"obstacle.drum.motion": shake})


@pytest.fixture(scope="module")
def run() -> Result:
    return rw.simulate(shaken())


def told(wraps: Iterable[Lying]) -> list[list[float]]:
    """Nodes, angle, tensions and ratio at slip of the wraps at one time."""
    return [[w.first, w.last, w.angle, w.before, w.after, w.at_slip] for w in wraps]


def tables(result: Result) -> dict[int, list[list[float]]]:
    """What the run's own table has of the drum, by frame."""
    scene, only = result.scene, wound_on(result.scene)
    return {
        frame: told(lying(scene, result.layout, contacts, result.tension[frame], only))
        for frame, contacts in each_frame(result, range(result.frames))
    }


def test_a_replay_s_wraps_are_those_of_the_table(run: Result) -> None:
    """The drum's speed at the step's end lost nodes: one wrap of 1.56 rad was two, of 0.5 and 0.9."""
    recorded = Recorded(run)
    recorded.touched.every = 1
    known = tables(run)
    assert len(known) > 15
    for frame, wraps in known.items():
        picture = recorded.picture(frame).touch
        found = [[*row[2:7], np.exp(row[7])] for row in picture.wraps if row[0] >= 0.0]
        turned = [row for row in wraps if row[2] > 1e-3]
        assert np.array(found) == pytest.approx(np.array(turned)), frame


def test_a_live_session_s_wraps_are_those_of_the_table(run: Result) -> None:
    simulation, known = Simulation(shaken()), tables(run)
    for frame in range(1, 30):
        simulation.advance_steps(1)
        found = told(wraps_now(simulation, simulation.recording()).rows)
        assert simulation.time == run.time[frame]
        assert np.array(found) == pytest.approx(np.array(known.get(frame, [])), rel=1e-9), frame
