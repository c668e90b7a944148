"""What slides along a line touches it where it does not lie in it: beside the trolley, and once it is off."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.laws.pairs.beside_slides import follow_slides
from ropewalk.laws.pairs.search import are_neighbours
from ropewalk.scene import Straight

SEGMENTS, DIAMETER = 20, 0.02


def swinging(method: str = "sdirk2", step: float = 1e-3, **more: Any) -> rw.Simulation:
    """2 kg on a metre of rope, whose trolley is held on a taut line, thrown along the line at 10 m/s."""
    lines = more.pop("lines", 1)
    stuff = {"EA": 1e5, "mass_per_length": 0.3, "axial_damping": 50.0}
    made = [
        rw.Rope(
            name=f"line{i}",
            segments=SEGMENTS,
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
        slides=[rw.Slide(rope="rider", on="line0", at=4.6, brake=1e4)],
        contact=contact,
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
    follow_slides(x, table, memory, slide.grip, slide.off, tied)
    assert memory.inside[0, 0] <= 9 <= memory.inside[0, 1]  # it lies in it still
    x[2, own.start : own.end + 1] -= 0.9 * DIAMETER
    follow_slides(x, table, memory, slide.grip, slide.off, tied)
    assert memory.inside[0, 0] <= 9 <= memory.inside[0, 1]
    x[2, own.start : own.end + 1] -= 0.2 * DIAMETER
    follow_slides(x, table, memory, slide.grip, slide.off, tied)
    assert memory.inside[0, 0] > memory.inside[0, 1]
    assert not any(are_neighbours(table, memory, tied, j, own.start) for j in range(SEGMENTS))
