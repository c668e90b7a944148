"""What slides along a line touches it where it does not lie in it: beside the trolley, and once it is off."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.laws.couplings import FINE
from ropewalk.laws.pairs.beside_slides import first_of, follow_slides, last_of, reach_ahead
from ropewalk.laws.pairs.search import are_neighbours
from ropewalk.laws.pairs.way import meet_pairs
from ropewalk.laws.slides.table import PLACE
from ropewalk.scene import Straight

SEGMENTS, DIAMETER = 20, 0.02


def swinging(method: str = "sdirk2", step: float = 1e-3, **more: Any) -> rw.Simulation:
    """2 kg on a metre of rope, whose trolley is held on a taut line, thrown along the line at 10 m/s."""
    lines, segments = more.pop("lines", 1), more.pop("segments", SEGMENTS)
    stuff = {"EA": 1e5, "mass_per_length": 0.3, "axial_damping": 50.0}
    made = [
        rw.Rope(
            name=f"line{i}",
            segments=segments,
            length=9.9,
            diameter=DIAMETER,
            made_of=rw.Material(**stuff),
            shape=Straight(end=(10.0, 0, 0)),
        )
        for i in range(lines)
    ]
    rider = rw.Rope(
        name="rider",
        segments=1,
        length=1.0,
        diameter=DIAMETER,
        made_of=rw.Material(EA=1e4, mass_per_length=0.1, axial_damping=20.0),
        shape=Straight(end=(0, 0, -1.0)),
        loads=[rw.Load(node=-1, mass=2.0)],
    )
    anchors = [rw.Anchor(rope=line.name, node=node) for line in made for node in (0, -1)]
    contact = rw.Contact(friction=0.1) if more.pop("contact", True) else None
    scene = rw.Scene(
        ropes=[*made, rider],
        anchors=anchors,
        slides=[
            rw.Slide(
                rope="rider", on="line0", **({"at": 4.6, "brake": 1e4} | more.pop("slide", {}))
            )
        ],
        contact=contact,
        winches=more.pop("winches", []),
        run={"method": method, "time_step": step, "frame_rate": 200.0, "duration": 1.0},
    )
    simulation = rw.Simulation(scene)
    tip = simulation.layout.span("rider").end
    simulation.arrays.v[0, tip] = 10.0  # in a plane with the line: it goes round no side of it
    return simulation


def highest(simulation: rw.Simulation) -> float:
    """How far above the line beside it the tip comes in the time in which it would swing over it [m]."""
    tip, top, x = simulation.layout.span("rider").end, -math.inf, simulation.arrays.x
    while simulation.time < 0.7:
        simulation.advance_steps(10)
        line = np.interp(x[0, tip], x[0, : SEGMENTS + 1], x[2, : SEGMENTS + 1])
        top = max(top, float(x[2, tip] - line))
    return top


@pytest.mark.parametrize("method", ["sdirk2", "esdirk3", "bdf2"])
def test_a_load_that_swings_up_does_not_pass_through_its_line(method: str) -> None:
    assert highest(swinging(method)) < DIAMETER


def test_without_contact_it_swings_over_the_line() -> None:
    assert highest(swinging(contact=False)) > 0.3


def test_it_lies_in_its_line_about_the_trolley_alone() -> None:
    """It hangs there with no contact, and no force."""
    simulation = swinging()
    simulation.arrays.v[...] = 0.0
    table, memory = simulation.system.node.contact, simulation.arrays.memory.contact
    (row,) = memory.inside
    assert row[0] <= 8 < 9 < 10 <= row[1] + 1
    assert row[1] - row[0] <= 4
    simulation.advance_steps(50)
    assert memory.inside.tolist() == [[8, 10]]  # the trolley at 9.3, and a segment to each side
    assert memory.tally[0] == 0
    own, tied = simulation.layout.span("rider").start, simulation.arrays.tied
    there = [bool(are_neighbours(table, memory, tied, j, own)) for j in range(SEGMENTS)]
    assert np.flatnonzero(there).tolist() == [8, 9, 10]


def across(lines: int) -> rw.Scene:
    """A thick rope of 5 cm segments each of whose nodes slides along a line of its own."""
    made = [
        rw.Rope(
            name=f"line{i}",
            segments=8,
            length=0.8,
            diameter=DIAMETER,
            made_of=rw.Material(EA=1e4, mass_per_length=0.1, axial_damping=10.0),
            shape=Straight(start=(0.05 * i, -0.41, 0.0), end=(0.05 * i, 0.41, 0.0)),
        )
        for i in range(lines)
    ]
    rider = rw.Rope(
        name="rider",
        segments=lines - 1,
        length=0.05 * (lines - 1),
        diameter=0.1,
        made_of=rw.Material(EA=1e4, mass_per_length=0.1, axial_damping=10.0),
        shape=Straight(start=(0, 0, 0), end=(0.05 * (lines - 1), 0, 0)),
    )
    slides = [rw.Slide(name=f"ring{i}", rope="rider", node=i, on=f"line{i}") for i in range(lines)]
    return rw.Scene(
        ropes=[*made, rider],
        anchors=[rw.Anchor(rope=line.name, node=node) for line in made for node in (0, -1)],
        slides=slides,
        contact=rw.Contact(),
        run={"method": "sdirk2", "time_step": 1e-3, "duration": 0.1, "frame_rate": 100.0},
    )


@pytest.mark.parametrize("lines", [3, 6])
def test_a_rope_may_lie_in_any_number_of_lines(lines: int) -> None:
    """Four were left out near a segment, and the fifth pushed away what slides along it."""
    simulation = rw.Simulation(across(lines))
    table, memory = simulation.system.node.contact, simulation.arrays.memory.contact
    assert (table.slides >= 0).sum(axis=1).max() == lines
    for _ in range(20):
        assert memory.tally[0] == 0
        simulation.advance_steps(1)


def test_what_has_run_off_touches_its_line_again_once_it_is_clear() -> None:
    """Nothing is pressed as that begins."""
    simulation = swinging()
    simulation.arrays.v[...] = 0.0
    table, memory = simulation.system.node.contact, simulation.arrays.memory.contact
    slide, x = simulation.arrays.memory.slide, simulation.arrays.x.copy()
    own, tied = simulation.layout.span("rider"), simulation.arrays.tied
    slide.off[0] = 0.0
    follow_slides(x, table, memory, slide, tied)
    assert memory.inside[0, 0] <= 9 <= memory.inside[0, 1]  # it lies in it still
    x[2, own.start : own.end + 1] -= 0.9 * DIAMETER
    follow_slides(x, table, memory, slide, tied)
    assert memory.inside[0, 0] <= 9 <= memory.inside[0, 1]
    x[2, own.start : own.end + 1] -= 0.2 * DIAMETER
    follow_slides(x, table, memory, slide, tied)
    assert memory.inside[0, 0] > memory.inside[0, 1]
    assert not any(are_neighbours(table, memory, tied, j, own.start) for j in range(SEGMENTS))


def rolling(speed: float, method: str, step: float = 1.0 / 60.0, **more: Any) -> rw.Simulation:
    """A trolley that nothing brakes, and all that hangs on it, at a speed along the line."""
    given = {"segments": 100, "slide": {"at": 2.0, "brake": 0.0}} | more
    simulation = swinging(method, step, **given)
    span = simulation.layout.span("rider")
    simulation.arrays.v[0, span.start : span.end + 1] = speed
    return simulation


@pytest.mark.parametrize("method", ["implicit-euler", "sdirk2"])
@pytest.mark.parametrize(("speed", "steps"), [(10.0, 16), (20.0, 10)])
def test_a_trolley_of_many_segments_per_step_is_not_braked(
    method: str, speed: float, steps: int
) -> None:
    """Its rope met the line between the places at the step's ends: 10 m/s were 5.9 after 0.27 s."""
    free, touches = (rolling(speed, method, contact=contact) for contact in (False, True))
    span = free.layout.span("rider")
    for _ in range(steps):
        free.advance_steps(1)
        touches.advance_steps(1)
        np.testing.assert_array_equal(touches.arrays.v[:, span.start], free.arrays.v[:, span.start])
        assert touches.arrays.memory.contact.tally[0] == 0
    assert free.arrays.v[0, span.start] == pytest.approx(speed, rel=0.02)


def test_a_step_reaches_as_far_as_the_slide_goes() -> None:
    """As far as at its start what slides would touch the line on its way."""
    simulation = rolling(10.0, "sdirk2")
    table, state = simulation.system.node.contact, simulation.arrays
    memory, slide, span = state.memory.contact, state.memory.slide, simulation.layout.span("rider")
    end = state.x.copy()
    end[0, span.start : span.end + 1] += 0.35
    first, last = memory.inside[0].tolist()
    assert not reach_ahead(end, table, memory, slide, state.tied)  # there was none to be given up
    assert memory.inside[0, 0] == first
    assert memory.inside[0, 1] == last_of(table, 0, 20.2 + 0.35 / 0.1)
    assert meet_pairs(state.x, end, table, memory, state.tied, 0.01) == FINE
    memory.inside[0] = first, last
    memory.origin[0, 0] = math.inf
    assert meet_pairs(state.x, end, table, memory, state.tied, 0.01) != FINE
    assert memory.tally[0] > 0
    assert reach_ahead(end, table, memory, slide, state.tied)
    assert memory.tally[0] == 0


@pytest.mark.parametrize("end", ["start", "end"])
def test_places_count_from_where_the_rope_begins(end: str) -> None:
    """And not from spare nodes on a drum: there the trolley went from 8 to 0.5 m/s."""
    winch = rw.Winch(rope="line0", end=end, speed=0.2)
    slow = {"segments": 20, "slide": {"at": 4.6, "brake": 0.0}, "winches": [winch]}
    free, touches = (
        rolling(8.0, "sdirk2", 4e-3, contact=contact, **slow) for contact in (False, True)
    )
    table, memory = touches.system.node.contact, touches.arrays.memory
    node = int(touches.system.node.slide.node[0])
    for _ in range(8):
        free.advance_steps(5)
        touches.advance_steps(5)
        x, place = touches.arrays.x, float(memory.slide.grip[0, PLACE])
        (below,) = np.flatnonzero((x[0, : node - 1] <= x[0, node]) & (x[0, 1:node] > x[0, node]))
        assert first_of(table, 0, place) < below < last_of(table, 0, place)
        assert touches.arrays.v[0, node] == pytest.approx(free.arrays.v[0, node], rel=1e-9)
    assert free.arrays.v[0, node] > 7.0
