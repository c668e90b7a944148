"""With which length of its parts a step begins, and that it is kept in what evolves."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from ropewalk.laws.pairs.table import CONTACTS
from ropewalk.methods.part_lengths import (
    LENGTH,
    MANY,
    MOST_HALVINGS,
    begin_parts,
    is_fast,
    keep_parts,
)
from ropewalk.methods.stage_report import SOLVES
from ropewalk.record import checkpoint
from ropewalk.record.checkpoint import Checkpoint
from ropewalk.scene import Contact, Material, Rope, RunSettings, Scene, Straight
from ropewalk.simulation import Simulation, Snapshot
from verification.heaps import STEP, fed


def kept(level: int, run: int, need: int, dt: float = STEP, carried: bool = True) -> np.ndarray:
    """What a step leaves that came to these parts."""
    past = np.zeros(6)
    keep_parts(past, dt, carried, level, run, need)
    return past


def test_a_step_goes_on_with_the_parts_of_the_last_one() -> None:
    assert begin_parts(kept(3, 5, 8), STEP, True) == (3, 5, 8, False)


def test_enough_parts_are_followed_by_a_longer_one() -> None:
    assert begin_parts(kept(3, 8, 8), STEP, True) == (2, 0, 8, True)
    assert begin_parts(kept(1, 2, 2), STEP, True) == (0, 0, 2, True)


@pytest.mark.parametrize(
    "past", [kept(0, 0, 16), kept(2, 1, 4, carried=False), np.zeros(6)], ids=str
)
def test_a_whole_step_begins_anew(past: np.ndarray) -> None:
    assert begin_parts(past, STEP, True) == (0, 0, 2, False)


def test_few_contacts_begin_with_the_whole_step() -> None:
    assert begin_parts(kept(3, 5, 8), STEP, False) == (0, 0, 2, False)


@pytest.mark.parametrize(
    ("share", "level"), [(1.0 + 1e-15, 3), (0.5, 2), (0.1, 0), (2.0, 4), (1e6, MOST_HALVINGS)]
)
def test_a_step_of_another_length_has_parts_as_long(share: float, level: int) -> None:
    assert begin_parts(kept(3, 5, 8), share * STEP, True)[0] == level


@pytest.fixture(scope="module")
def heaped() -> tuple[Simulation, Snapshot]:
    """A rope that is fed onto a floor, where it has come to parts of a step."""
    simulation = Simulation(fed(200, 1e3, 0.0, 0.8))
    for _ in range(100):  # at which of these steps hangs on the last bits, so on the machine
        simulation.step(STEP)
        many = simulation.arrays.memory.contact.tally[CONTACTS] > 1.25 * MANY  # and stay many
        if many and 0.0 < simulation.arrays.past[LENGTH] < STEP:
            return simulation, simulation.state
    pytest.fail("no step left parts and many contacts behind")


def stepped(simulation: Simulation, steps: int = 5) -> np.ndarray:
    for _ in range(steps):
        simulation.step(STEP)
    return simulation.positions.copy()


@pytest.mark.slow
def test_a_run_goes_on_from_its_checkpoint_to_the_same_bits(
    heaped: tuple[Simulation, Snapshot], tmp_path: Path
) -> None:
    simulation, begun = heaped
    simulation.restore(begun)
    checkpoint.save(tmp_path, Checkpoint(begun, 1, "hash", 0.0, ()))
    whole, other = stepped(simulation), Simulation(simulation.scene)
    other.restore(checkpoint.load(tmp_path, other.state).snapshot)
    np.testing.assert_array_equal(stepped(other), whole)


@pytest.mark.slow
def test_a_checkpoint_of_before_parts_were_kept_goes_on(
    heaped: tuple[Simulation, Snapshot], tmp_path: Path
) -> None:
    """It begins with the whole step, as all did then."""
    simulation, begun = heaped
    old = begun._replace(state=begun.state._replace(past=begun.state.past[:LENGTH]))
    checkpoint.save(tmp_path, Checkpoint(old, 1, "hash", 0.0, ()))
    simulation.restore(checkpoint.load(tmp_path, begun).snapshot)
    np.testing.assert_array_equal(simulation.arrays.past[LENGTH:], 0.0)
    np.testing.assert_array_equal(simulation.positions, begun.state.x.T)
    assert np.isfinite(stepped(simulation)).all()


@pytest.mark.slow
def test_that_takes_fewer_solutions(heaped: tuple[Simulation, Snapshot]) -> None:
    """Than where each step begins with the whole one, over five steps."""
    simulation, begun = heaped

    def solutions(forgets: bool) -> float:
        report, before = simulation._engine._scratch.stage.report, 0.0
        simulation.restore(begun)
        before = report[SOLVES]
        for _ in range(5):
            if forgets:
                simulation.arrays.past[LENGTH:] = 0.0
            simulation.step(STEP)
        return float(report[SOLVES] - before)

    assert solutions(forgets=False) < 0.8 * solutions(forgets=True)


@pytest.mark.slow
def test_so_it_does_where_a_rope_with_bending_is_fed() -> None:
    """A stiff one, with few contacts, from its start on: fast, as slow ones hardly need parts now."""

    def solutions(forgets: bool) -> float:
        simulation = Simulation(fed(100, 1e6, 1e-6, 0.8))
        for _ in range(60):
            if forgets:
                simulation.arrays.past[LENGTH:] = 0.0
            simulation.step(STEP)
        return float(simulation._engine._scratch.stage.report[SOLVES])

    assert solutions(forgets=False) < 0.8 * solutions(forgets=True)


@pytest.mark.parametrize(("speed", "fast"), [(0.0, False), (0.14, False), (0.16, True)])
def test_what_goes_a_quarter_of_the_thinnest_diameter_in_a_step_is_fast(
    speed: float, fast: bool
) -> None:
    """Cords of 10 and 20 mm, in steps of 1/60 s: from 0.15 m/s on, by any node."""
    table = Simulation(ropes(0.01, 0.02)).system.node.contact
    v = np.zeros((3, len(table.rope) + 1))
    v[:, -1] = speed / math.sqrt(3.0)
    assert is_fast(v, STEP, table) == fast


def test_nothing_is_fast_where_no_rope_is() -> None:
    table = Simulation(ropes(0.01, 0.02)).system.node.contact
    nowhere = table._replace(rope=np.full_like(table.rope, -1))
    assert not is_fast(np.ones((3, len(table.rope) + 1)), STEP, nowhere)


def ropes(*diameters: float) -> Scene:
    """Cords side by side that may touch each other."""
    stuff = Material(EA=100.0, mass_per_length=0.02)
    made = [
        Rope(
            name=f"r{k}",
            segments=2,
            length=0.1,
            diameter=d,
            made_of=stuff,
            shape=Straight(start=(0, k, 1)),
        )
        for k, d in enumerate(diameters)
    ]
    return Scene(
        ropes=made, contact=Contact(), run=RunSettings(method="implicit-euler", time_step=STEP)
    )
