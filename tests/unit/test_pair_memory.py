"""What contacts of ropes keep from step to step: no jump of force or energy, friction that is handed on."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
import pytest

from ropewalk.core.arrays import State, System
from ropewalk.laws.pairs.force import pair_energy, pair_forces
from ropewalk.laws.pairs.offsets import FADES
from ropewalk.laws.pairs.pair_memory import frame_of, remember_pairs
from ropewalk.laws.pairs.search import freeze, new_row, row_of
from ropewalk.laws.pairs.table import (
    CONTACTS,
    FOUND,
    GONE,
    LEFT,
    MORE,
    NORMAL,
    PUSH,
    SETTLES,
    SPRING,
)
from ropewalk.laws.pairs.way import begin_contact
from ropewalk.lowering import build
from ropewalk.scene import Anchor, Contact, Load, Material, Rope, RunSettings, Scene, Straight
from ropewalk.simulation import Broken, Simulation

D = 0.01


def crossed(
    at: float,
    *,
    speed: float = 0.0,
    free: bool = False,
    loads: Sequence[Load] = (),
    **contact: float,
) -> Scene:
    """A rope of two segments along x, held everywhere, and a bar across it at x = `at` that presses by 1 %.

    The bar's ends are held, and go down by `speed`, or `free`.
    """
    common = {"diameter": D, "made_of": Material(EA=1e4, mass_per_length=0.1)}
    down = {"velocity": (0.0, 0.0, -speed)}
    bar = Straight(start=(at, -0.1, 0.99 * D), end=(at, 0.1, 0.99 * D))
    ropes = [
        Rope(
            name="a",
            segments=2,
            length=0.2,
            shape=Straight(start=(0, 0, 0), end=(0.2, 0, 0)),
            **common,
        ),
        Rope(name="b", segments=1, length=0.2, shape=bar, loads=list(loads), **common),
    ]
    anchors = [Anchor(rope="a", node=k) for k in range(3)]
    motion = {"motion": {"kind": "velocity"} | down} if speed else {}
    anchors += [] if free else [Anchor(rope="b", node=k, **motion) for k in (0, 1)]
    run = RunSettings(method="implicit-euler", time_step=1 / 60, frame_rate=60)
    return Scene(
        gravity=(0, 0, 0),
        ropes=ropes,
        anchors=anchors,
        contact=Contact(friction=0.3, **contact),
        run=run,
    )


def pressed(at: float, **more: Any) -> tuple[System, State]:
    """Tables and state of it, the contact found and pressed, as statics has it."""
    model = build(crossed(at, **more), drawn=False)
    state, table = model.state, model.system.node.contact
    state.memory.contact.tally[SETTLES] = 1
    remember_pairs(state.x, state.v, 50.0 * FADES, table, state.memory.contact, state.tied)
    assert state.memory.contact.tally[CONTACTS] == 1
    return model.system, state


def push_of(system: System, state: State) -> tuple[float, float]:
    """The force on the bar [N] and what the contact has stored [J]."""
    table, memory, x = system.node.contact, state.memory.contact, state.x
    force = np.zeros_like(x)
    pair_forces(x, np.zeros_like(x), table, memory, force, 0, x.shape[1])
    return float(np.linalg.norm(force[:, 3:].sum(axis=1))), float(pair_energy(x, table, memory))


def test_a_contact_that_is_found_anew_keeps_force_and_energy() -> None:
    """Its plane was wrong, aside by more than 3 % of the diameter: nothing jumps, and then fades."""
    system, state = pressed(0.05)
    table, memory = system.node.contact, state.memory.contact
    honest = push_of(system, state)
    lean = math.sqrt(1.0 - 0.99**2)
    memory.grip[0, NORMAL : NORMAL + 3] = (lean, 0.0, -0.99)
    begin_contact(state.x, table, memory, 0, 1e-5)  # a contact pressed by 0.01 mm
    before = push_of(system, state)
    remember_pairs(state.x, state.v, 0.0, table, memory, state.tied)
    assert memory.grip[0, NORMAL + 2] == pytest.approx(-1.0)
    assert push_of(system, state) == pytest.approx(before, rel=1e-9)
    assert before[0] < 0.2 * honest[0]  # else nothing would be shown
    remember_pairs(state.x, state.v, 50.0 * FADES, table, memory, state.tied)
    assert memory.grip[0, MORE] == pytest.approx(0.0, abs=1e-8 * D)
    assert push_of(system, state) == pytest.approx(honest, rel=1e-6)


def test_friction_is_handed_on_to_a_contact_that_was_found_on_the_way() -> None:
    """Past the node the next segment has it: a row made during the step takes over force and depth."""
    system, state = pressed(0.095)
    table, memory = system.node.contact, state.memory.contact
    memory.grip[0, SPRING : SPRING + 3] = (0.01, 0.0, 0.0)
    memory.grip[0, PUSH] = push_of(system, state)[0]
    left = 0.007 * D  # so deep statics left it: a run presses it up no further
    memory.tally[SETTLES], memory.grip[0, LEFT] = 0, left
    state.x[0, 3:] = 0.106
    row = -1 - row_of(memory, 1, 3)
    assert new_row(memory, 1, 3, row)
    freeze(state.x, state.x, 0.0, system.node.contact, memory, row, 0.06, 0.5)
    begin_contact(state.x, table, memory, row, 0.0)
    memory.grip[row, FOUND] = 1.0
    remember_pairs(state.x, state.v, 0.0, table, memory, state.tied)
    assert memory.tally[CONTACTS] == 1
    assert tuple(memory.pair[0]) == (1, 3)
    assert memory.grip[0, FOUND] == memory.grip[0, GONE] == 0.0
    assert memory.grip[0, PUSH] > 0.0
    assert abs(memory.grip[0, SPRING]) > 0.005
    assert memory.grip[0, LEFT] == left


@pytest.mark.parametrize(("turn", "within"), [(1.0, 2e-3), (0.2, 0.05), (0.0, 1e-9)])
def test_the_frame_of_a_contact_is_that_in_which_both_go_along_themselves(
    turn: float, within: float
) -> None:
    """Where the bar lies across, at 11 degrees, and along: there each has half of what slides."""
    _, state = pressed(0.05)
    x, memory, carried = state.x, state.memory.contact, np.array([3.0, -2.0, 5.0])
    x[:, 4] = x[:, 3] + 0.2 * np.array(
        [np.cos(0.5 * np.pi * turn), np.sin(0.5 * np.pi * turn), 0.0]
    )
    along, v = x[:, 4] - x[:, 3], np.zeros_like(x)
    v[0, :3] = 0.5
    v[:, 3:] = -0.5 * (along / np.linalg.norm(along))[:, None]
    found = frame_of(x, v, memory, 0)
    assert found == pytest.approx(np.zeros(3), abs=within)
    assert frame_of(x, v + carried[:, None], memory, 0) == pytest.approx(found + carried)
    x[:, 4] = x[:, 3]  # of no length: the mean of both
    assert frame_of(x, v, memory, 0) == pytest.approx(0.5 * (v[:, 0] + v[:, 3]))


@pytest.mark.parametrize("contact", [{}, {"compliance": 1e-3}])
def test_what_is_pressed_slowly_does_not_go_through(contact: dict[str, float]) -> None:
    """Held ends press the bar on at 1 mm/s: the run ends in words at a tenth of the diameter."""
    simulation = Simulation(crossed(0.05, speed=1e-3, **contact))
    with pytest.raises(Broken, match="too near to each other"):
        simulation.step(2.0)
    x = simulation.arrays.x
    assert 0.9 * D * (1.0 - 1e-6) < x[2, 3] < 0.92 * D


def test_too_many_couplings_end_the_run_in_words() -> None:
    """A network without room for the contacts there are says what is the matter."""
    simulation = Simulation(crossed(0.05, free=True))
    engine = simulation._engine
    network = engine._scratch.stage.saddle.network
    engine._scratch = engine._scratch._replace(
        stage=engine._scratch.stage._replace(
            saddle=engine._scratch.stage.saddle._replace(
                network=network._replace(later=network.later[:2])
            )
        )
    )
    with pytest.raises(Broken, match="contacts couple more nodes"):
        simulation.step(0.5)
