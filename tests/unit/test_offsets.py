"""Ropes that lie still in each other are pressed up, slowly enough for what is heavy, and on the books."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from ropewalk.api import simulate
from ropewalk.core.arrays import State, System
from ropewalk.laws.couplings import coupled_energy
from ropewalk.laws.nodes import node_given, touch_nodes
from ropewalk.laws.pairs import offsets
from ropewalk.laws.pairs.force import add_pair_forces, pair_energy
from ropewalk.laws.pairs.heaps import heavy_of, leads, weigh_heaps
from ropewalk.laws.pairs.pair_books import record_pair_books
from ropewalk.laws.pairs.table import (
    CONTACTS,
    LEFT,
    LIFTED,
    MORE,
    NORMAL,
    OWN,
    PUSH,
    SETTLES,
)
from ropewalk.lowering.layout import make_layout
from ropewalk.lowering.pieces import Pieces
from ropewalk.lowering.system import make_tables
from ropewalk.methods.verdict import energy_now
from ropewalk.record import checkpoint
from ropewalk.record.checkpoint import Checkpoint
from ropewalk.scene import (
    Air,
    Anchor,
    Contact,
    Kick,
    Load,
    Material,
    Rope,
    RunSettings,
    Scene,
    Straight,
)
from ropewalk.simulation import Simulation
from unit.test_pair_memory import D, crossed, pressed, push_of

DT = 1.0 / 60.0  # [s]
QUICKEST = offsets.QUICKEST * D * DT  # [m] in a step


def led(system: System, state: State) -> float:
    """By how much a step of rest has changed the offset [m]; the contact is pressed by 1 %."""
    memory = state.memory.contact
    memory.grip[0, PUSH] = 1.0
    memory.way[...] = 0.0
    before = float(memory.grip[0, MORE])
    offsets.lead_offsets(state.x, DT, system.node.contact, memory)
    return float(memory.grip[0, MORE]) - before


def still(**contact: float) -> tuple[System, State]:
    """Two ropes pressed into each other by 1 %, as their points say."""
    system, state = pressed(0.05, **contact)
    memory = state.memory.contact
    memory.tally[SETTLES], memory.grip[0, LEFT], memory.grip[0, MORE] = 0, 0.0, 0.0
    return system, state


def test_what_lies_still_is_pressed_up_to_half_a_hundredth() -> None:
    """By no more than 3 % of the diameter a second; not between no depth and 0.5 %; back where it is open."""
    system, state = still()
    assert led(system, state) == pytest.approx(QUICKEST)
    place = state.x[2, 3:].copy()
    for depth, expected in ((0.004, 0.0), (0.0, 0.0), (-0.02, -QUICKEST)):
        state.memory.contact.grip[0, MORE] = 0.02 * D
        state.x[2, 3:] = place + (0.01 - depth) * D
        assert led(system, state) == pytest.approx(expected, abs=1e-9 * D), depth


def test_what_moves_or_is_open_fades() -> None:
    """By more than 0.2 diameters a second; the twins: less, pressed, and a lever whose end goes farther."""
    for way, push, fades in ((0.3, 1.0, True), (0.1, 1.0, False), (0.0, 0.0, True)):
        system, state = still()
        memory = state.memory.contact
        memory.grip[0, MORE], memory.grip[0, PUSH] = 0.01 * D, push
        memory.way[...] = 0.0
        memory.way[0, 3:] = way * D * DT
        offsets.lead_offsets(state.x, DT, system.node.contact, memory)
        faded = 0.01 * D * np.exp(-DT / offsets.FADES)
        assert (memory.grip[0, MORE] == pytest.approx(faded)) == fades, way
        memory.grip[0, MORE], memory.grip[0, PUSH] = 0.01 * D, 1.0
        memory.way[2, 3:] = (-0.3 * D * DT, 0.3 * D * DT)  # about the contact in the middle
        offsets.lead_offsets(state.x, DT, system.node.contact, memory)
        assert (memory.grip[0, MORE] == pytest.approx(faded)) == (way > 0.2), way


def test_what_counts_as_less_deep_than_it_is_comes_back_as_ever() -> None:
    system, state = still()
    state.memory.contact.grip[0, MORE] = -0.02 * D
    back = 0.02 * D * (1.0 - np.exp(-DT / offsets.FADES))
    assert led(system, state) == pytest.approx(back + QUICKEST)


def test_what_it_gives_is_the_motors_and_no_energy_made_up() -> None:
    """The books have it, and a run is judged by it as given; a step, by all that is stored."""
    system, state = still()
    table, memory, entries = system.node.contact, state.memory.contact, np.zeros(5)
    before, judged = pair_energy(state.x, table, memory), energy_now(system, state)
    assert node_given(system, state, state.x) == 0.0
    led(system, state)
    gain = pair_energy(state.x, table, memory) - before
    assert gain > 0.01 * before > 0.0
    assert memory.books[LIFTED] == pytest.approx(gain)
    assert node_given(system, state, state.x) == memory.books[LIFTED]
    assert energy_now(system, state) - judged == pytest.approx(gain)
    assert coupled_energy(system, state, state.x) == pytest.approx(before + gain)
    record_pair_books(state.x, table, memory, entries)
    assert entries[0] == pytest.approx(gain)
    assert entries.sum() == pytest.approx(0.0, abs=1e-12 * before)


def test_what_is_heavy_is_pressed_up_slowly() -> None:
    """A time constant of two m / c at least, m all that there is: else it keeps swinging."""
    system, state = still()
    table = system.node.contact
    heavy = table._replace(total=np.array([0.02, 1e3]))
    slow = led(system._replace(node=system.node._replace(contact=heavy)), state)
    assert 0.0 < slow < 1e-3 * QUICKEST
    assert table.total == pytest.approx([0.02, 0.02])
    loaded = pressed(0.05, loads=[Load(node=0, mass=2.0)])[0].node.contact
    assert loaded.total == pytest.approx([0.02, 2.02])


def test_what_is_elsewhere_is_on_no_contact() -> None:
    """Of six ropes the first two lie on each other, as do the next; a joint hangs the fifth on the second."""
    system, state = pressed(0.05)
    memory, rope = state.memory.contact, np.arange(6)
    weights, pairs = 2.0**rope, np.array([(0, 1), (2, 3)])
    memory.pair[:2], memory.tally[CONTACTS] = pairs, 2
    table = system.node.contact._replace(rope=rope, total=weights, lead=leads(6, [(1, 4)]))
    for swapped in (False, True):
        room = np.zeros((3, 6))
        memory.pair[:2] = pairs[::-1] if swapped else pairs
        weigh_heaps(table, memory, room)
        found = [heavy_of(table, room, i) for i in range(6)]
        assert found == [19.0, 19.0, 12.0, 12.0, 19.0, 32.0]


def test_what_is_bound_is_compared_by_value() -> None:
    """So that tables of contact are not made anew where nothing has changed."""
    scene, keep = crossed(0.05), Pieces()
    layout = make_layout(scene)
    for _ in range(2):
        keep.made.clear()
        make_tables(scene, layout, keep)
    assert "contact" not in keep.made


def crossing(*, beside: bool) -> Scene:
    """Return two taut ropes of which one lies on the other, alone or 10 m beside one that carries 5 kg."""
    common = {"diameter": D, "made_of": Material(EA=1e3, mass_per_length=0.1, axial_damping=5.0)}
    places = {"a": ((-0.25, 0, 0), (0.25, 0, 0)), "b": ((0, -0.25, 0.99 * D), (0, 0.25, 0.99 * D))}
    ropes = [
        Rope(name=name, segments=5, length=0.4999, shape=Straight(start=a, end=b), **common)
        for name, (a, b) in places.items()
    ]
    anchors = [Anchor(rope=name, node=node) for name in "ab" for node in (0, -1)]
    if beside:
        shape = Straight(start=(10, 0, 0), end=(10, 0, -0.5))
        loads = [Load(node=-1, mass=5.0)]
        ropes.append(Rope(name="c", segments=3, length=0.5, shape=shape, loads=loads, **common))
        anchors.append(Anchor(rope="c", node=0))
    run = RunSettings(method="semi-implicit-euler", time_step=1e-5, duration=0.02, frame_rate=100.0)
    return Scene(ropes=ropes, anchors=anchors, contact=Contact(friction=0.3), run=run)


def test_a_pair_has_the_same_bits_beside_a_heavy_rope_elsewhere() -> None:
    """The mass of all ropes of the scene slowed it."""
    alone, beside = (simulate(crossing(beside=beside)) for beside in (False, True))
    nodes = alone.layout.nodes
    np.testing.assert_array_equal(alone.positions, beside.positions[:, :nodes])
    np.testing.assert_array_equal(alone.velocities, beside.velocities[:, :nodes])


def test_what_a_compliance_of_the_users_gives_stays() -> None:
    """It says how far a force presses ropes into each other."""
    soft, hard = still(compliance=1e-4), still()
    assert led(*soft) == 0.0
    assert led(*hard) > 0.0


def test_statics_says_how_deep_what_it_left_stays() -> None:
    """Until it opens."""
    system, state = still()
    memory = state.memory.contact
    memory.tally[SETTLES] = 1
    assert led(system, state) == 0.0
    assert memory.grip[0, LEFT] == pytest.approx(0.01 * D)
    memory.tally[SETTLES] = 0
    assert led(system, state) == 0.0
    memory.grip[0, PUSH] = 0.0
    offsets.lead_offsets(state.x, DT, system.node.contact, memory)
    assert led(system, state) == pytest.approx(QUICKEST)


def test_there_is_no_room_under_much_load() -> None:
    """What presses as hard as 1 % beyond the skin: 6 % deep does. The twin: 1 % deep."""
    for more, expected in ((0.05, 0.0), (0.0, QUICKEST)):
        system, state = still()
        state.x[2, 3:] -= more * D
        assert led(system, state) == pytest.approx(expected), more


def test_a_plane_that_hides_how_deep_it_is_takes_up_no_room() -> None:
    """One that leans by 13 degrees counts 2.5 % less; what lay so stayed 2.5 % deep for ever."""
    for lean in (0.0, 0.22):
        system, state = still()
        memory = state.memory.contact
        memory.grip[0, MORE], memory.grip[0, OWN] = 0.03 * D, 0.5 + 0.99 * D * np.tan(lean) / 0.1
        memory.grip[0, NORMAL : NORMAL + 3] = np.sin(lean), 0.0, -np.cos(lean)
        moved = led(system, state)
        assert moved == pytest.approx(QUICKEST) if lean > 0.0 else moved < 0.0, lean


def tipped(friction: float) -> Scene:
    """Return a bar 1 % above a held one, whose other end is 1.5 % above it and sinks by 2.5 %, dragged.

    Its contact is where it was nearest as the run began, and wrong by 2 % there: a plane that may stay.
    """
    common = {"segments": 1, "diameter": D, "made_of": Material(EA=1e4, mass_per_length=0.1)}
    drag, way = 0.1, 0.025 * D  # [N s/m], [m]: a node of 5 g goes v m / c
    bar = Straight(start=(0.05, 0, 1.01 * D), end=(0.15, 0, 1.015 * D))
    kick = Kick(node=1, velocity=(0, 0, -way * drag / 0.005))
    ropes = [
        Rope(name="a", length=0.2, shape=Straight(start=(0, 0, 0), end=(0.2, 0, 0)), **common),
        Rope(name="b", length=0.1, shape=bar, kicks=[kick], **common),
    ]
    return Scene(
        gravity=(0, 0, 0),
        ropes=ropes,
        anchors=[Anchor(rope="a", node=node) for node in (0, 1)],
        contact=Contact(friction=friction),
        air=Air(node_drag=drag),
        run=RunSettings(method="implicit-euler", time_step=DT, frame_rate=60),
    )


@pytest.mark.parametrize("friction", [0.0, 0.3])
def test_what_lies_in_each_other_beside_an_open_contact_is_pressed_up(friction: float) -> None:
    """Nothing pressed it: a pile of 200 segments lay 1 % deep where its contact was open by its plane."""
    simulation = Simulation(tipped(friction))
    lowest = 1.0
    for _ in range(300):
        simulation.step(DT)
        lowest = min(lowest, simulation.arrays.x[2, 3] / D)
    assert lowest == pytest.approx(0.99, abs=3e-4)  # it got there, and nothing stopped it before
    assert simulation.arrays.x[2, 2:].min() / D > 1.0 - 1.02 * offsets.ENOUGH
    assert np.abs(simulation.arrays.v).max() < 1e-9


def test_a_checkpoint_of_before_contacts_kept_so_much_goes_on(tmp_path: Path) -> None:
    """With fewer columns, counts and works: what they stand for is nothing."""
    simulation = Simulation(crossed(0.05, free=True))
    simulation.step(DT)
    now = simulation.state
    memory = now.state.memory.contact
    short = memory._replace(
        grip=memory.grip[:, :LEFT], tally=memory.tally[:SETTLES], books=memory.books[:LIFTED]
    )
    old = now._replace(state=now.state._replace(memory=now.state.memory._replace(contact=short)))
    checkpoint.save(tmp_path, Checkpoint(old, 1, "hash", 0.0, ()))
    found = checkpoint.load(tmp_path, now).snapshot.state.memory.contact
    for name in ("grip", "tally", "books"):
        there, kept = getattr(found, name), getattr(short, name)
        assert there.shape == getattr(memory, name).shape
        assert there.dtype == kept.dtype
        np.testing.assert_array_equal(there[..., : kept.shape[-1]], kept)
        assert not there[..., kept.shape[-1] :].any()
    simulation.restore(old)  # as it was pickled then
    np.testing.assert_array_equal(simulation.arrays.memory.contact.grip, found.grip)


def test_forces_told_are_those_of_the_step() -> None:
    """Not those of the offsets that the next one has; the twin: these are more."""
    system, state = still()
    force, more = np.zeros_like(state.x), np.zeros_like(state.x)
    before = push_of(system, state)[0]
    led(system, state)
    touch_nodes(system, state, force)
    add_pair_forces(state.x, state.v, system.node.contact, state.memory.contact, more)
    assert np.linalg.norm(force[:, 3:].sum(axis=1)) == pytest.approx(before)
    assert np.linalg.norm(more[:, 3:].sum(axis=1)) > 1.01 * before
