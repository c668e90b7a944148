"""What friction's tangent makes of a contact that turns within a solve."""

from __future__ import annotations

import numpy as np
import pytest

from ropewalk.laws.pairs.table import AGO, CONTACTS, COURSE, FIRST_LOOK, LATER, NO_SOLVE
from ropewalk.laws.slip_course import BEFORE, ROWS, WHEN, follow_slip, keep_slips, settled
from ropewalk.methods.stage_report import SOLVES
from ropewalk.simulation import Simulation
from verification.heaps import STEP, pile


def test_what_turns_back_is_held_as_by_the_chord() -> None:
    """What slips as it did has the derivative, as all have at first; what stuck has half of it."""
    ahead, back, none = (1.0, 0.0, 0.0), (-1.0, 0.0, 0.0), (0.0, 0.0, 0.0)
    assert settled(ahead, ahead, LATER) == 1.0
    assert settled(ahead, none, LATER) == 0.5
    assert settled(ahead, back, LATER) == 0.0
    assert settled(ahead, (0.0, 1.0, 0.0), LATER) == 0.5
    assert settled(ahead, back, FIRST_LOOK) == settled(ahead, back, NO_SOLVE) == 1.0


def test_obstacles_note_what_slips() -> None:
    """From one iteration to the next, across the normal and no longer than one."""
    slips = np.zeros((1, ROWS, 2))
    up, pull = (0.0, 0.0, 1.0), (3.0, 4.0, 7.0)
    assert follow_slip(slips, 0, 1, up, pull, 1.0) == 1.0
    keep_slips(slips, LATER)
    assert slips[0, BEFORE : BEFORE + 3, 1] == pytest.approx([0.6, 0.8, 0.0])
    assert follow_slip(slips, 0, 1, up, pull, 1.0) == pytest.approx(1.0)
    assert follow_slip(slips, 0, 1, up, (-3.0, -4.0, 7.0), 1.0) == pytest.approx(0.0)
    assert follow_slip(slips, 0, 1, up, pull, 10.0) == pytest.approx(0.75)  # it sticks, at half
    keep_slips(slips, NO_SOLVE)
    assert (slips[0, WHEN] == NO_SOLVE).all()


def test_a_pile_takes_few_solutions_and_leaves_no_trace_of_them() -> None:
    """6118 with the derivative alone, 4070 with what turns held; after a step tangents are derivatives."""
    simulation = Simulation(pile(2, False))
    for _ in range(80):
        simulation.step(STEP)
    memory = simulation.arrays.memory.contact
    assert memory.tally[CONTACTS] > 20
    assert (memory.grip[:, COURSE] == NO_SOLVE).all()
    assert (memory.grip[:, AGO : AGO + 3] == 0.0).all()
    assert simulation._engine._scratch.stage.report[SOLVES] < 5000
