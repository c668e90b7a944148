"""A slide without friction at which its line turns sharply: bumps of segments hold it, and it is said.

How much they hold follows from the statics of three nodes (`statics.slide_bumps`), here against runs.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.record.result import Result
from ropewalk.scene import (
    Anchor,
    Cylinder,
    Force,
    Joint,
    Load,
    Material,
    Points,
    Rope,
    Scene,
    Slack,
    Slide,
    Straight,
    Velocity,
)
from ropewalk.sheets.loads import run_section
from ropewalk.statics.slide_bumps import held_by_bumps

PULL, SEGMENTS, LENGTH = 10.0, 24, 2.0  # [N], of the line, and its length [m]
SAID = "hold tensions on both sides that differ by up to"


@pytest.mark.parametrize(
    ("degrees", "share"), [(60, 0.0148), (90, 0.0771), (120, 0.254), (150, 0.665), (165, 1.05)]
)
def test_what_bumps_hold_is_as_the_how_to_says(degrees: float, share: float) -> None:
    assert held_by_bumps(math.radians(degrees)) == pytest.approx(share, rel=5e-3)


def rider(name: str, length: float, mass: float, line: Rope) -> Rope:
    """Return one segment of the line's stuff that hangs straight down [m], with a load at its end [kg]."""
    return line.replace(
        name=name,
        segments=1,
        length=length,
        shape=Straight(direction=(0, 0, -1)),
        loads=[Load(node=-1, mass=mass)],
    )


def test_on_small_turns_they_vanish_by_the_fourth_power() -> None:
    assert held_by_bumps(0.2) / held_by_bumps(0.1) == pytest.approx(16.0, rel=0.02)


def through_a_ring(degrees: float, ratio: float) -> Scene:
    """Return a line drawn through a fixed ring, by a pull on one side and `ratio` times that on the other.

    It turns by `degrees` at its middle node, a load of 1 kg at either end.
    """
    half, h = math.radians(degrees) / 2.0, LENGTH / SEGMENTS
    down = -math.sin(half)
    legs = [np.array([side * math.cos(half), 0.0, down]) for side in (-1.0, 1.0)]
    middle = SEGMENTS // 2
    points = [
        tuple(map(float, legs[i > middle] * h * abs(i - middle))) for i in range(SEGMENTS + 1)
    ]
    pulls = PULL, PULL * ratio
    line = Rope(
        name="line",
        segments=SEGMENTS,
        length=LENGTH * (1.0 - sum(pulls) / 2e5),
        diameter=0.005,
        made_of=Material(EA=1e5, mass_per_length=0.01, axial_damping=20.0),
        shape=Points(points=points),
        loads=[Load(node=0, mass=1.0), Load(node=-1, mass=1.0)],
        forces=[
            Force(node=node, force=tuple(map(float, leg * pull)))
            for node, leg, pull in zip((0, -1), legs, pulls, strict=True)
        ],
    )
    deep = h * down * (1.0 - math.sqrt(0.5))  # where the line's curve is
    ring = Rope(
        name="ring",
        segments=1,
        length=0.1 - deep,
        made_of=Material(EA=1e5, mass_per_length=0.01),
        shape=Straight(start=(0, 0, deep), end=(0, 0, 0.1)),
    )
    return Scene(
        gravity=(0, 0, 0),
        ropes=[line, ring],
        anchors=[Anchor(rope="ring", node=0), Anchor(rope="ring", node=-1)],
        slides=[Slide(name="r", rope="ring", on="line", compliance=1e-6)],
        run={"duration": 0.4, "frame_rate": 50, "method": "esdirk3", "time_step": 5e-4},
    )


@pytest.mark.parametrize(
    ("degrees", "ratio", "goes"),
    [(60, 1.3, True), (120, 1.15, False), (120, 1.6, True), (150, 1.5, False)],
)
def test_a_ring_is_held_by_bumps_where_they_hold_more_than_what_draws(
    degrees: float, ratio: float, goes: bool
) -> None:
    """Without any friction it stays within its segment, under tensions that differ by less than that."""
    draws = 2.0 * (ratio - 1.0) / (ratio + 1.0)
    assert (draws > held_by_bumps(math.radians(degrees))) is goes
    result = rw.simulate(through_a_ring(degrees, ratio))
    place = result.slide("r").place
    assert (float(np.ptp(place)) > LENGTH / SEGMENTS) is goes
    _told(result, degrees)


def _told(result: Result, degrees: float) -> None:
    """Check that what turns by more than 60 degrees is told by table, sheet and check."""
    if degrees == 60:  # on the mean it turns by a little more or less
        return
    note = result.table["about the slides"]
    assert degrees <= told_turn(note) <= degrees + 10  # of frames of a line that rings, the largest
    assert SAID in note
    assert any(SAID in str(item) for item in run_section(result).items)
    told = [note for note in rw.check(result.scene, measure=False).warnings if SAID in note]
    assert len(told) == 1
    assert f"turns by {degrees} degrees" in told[0]


def told_turn(note: str) -> int:
    """Return the turn that a run's row tells of [degrees]."""
    return int(note.partition("turns by up to ")[2].partition(" ")[0])


def test_of_a_line_that_comes_to_turn_sharply_the_run_tells_the_largest_turn_and_no_mean() -> None:
    """Its anchors come near each other: all it bears, from level to steep. On the mean it were 129."""
    line = Rope(
        name="line",
        segments=20,
        length=2.0,
        made_of=Material(EA=2e4, mass_per_length=0.005, axial_damping=20.0),
        shape=Slack(start=(-0.95, 0, 0), end=(0.95, 0, 0)),
    )
    block = rider("block", 0.2, 2.0, line)
    near = Velocity(velocity=(-1.0, 0, 0), stop=1.7)
    scene = Scene(
        ropes=[line, block],
        anchors=[Anchor(rope="line", node=0), Anchor(rope="line", node=-1, motion=near)],
        slides=[Slide(name="b", rope="block", on="line", at=1.0)],
        run={"duration": 2.0, "frame_rate": 25, "method": "esdirk3", "time_step": 0.01},
    )
    result = rw.simulate(scene)
    steep = 180.0 - 2.0 * math.degrees(math.asin(0.2 / 2.0))
    assert told_turn(result.table["about the slides"]) >= steep - 5.0


def test_of_many_sharp_turns_the_sharpest_are_told_and_how_many_more() -> None:
    """A zigzag with a load at each of six corners."""
    line = Rope(
        name="line",
        segments=42,
        length=4.2,
        made_of=Material(EA=1e3, mass_per_length=0.05),
        shape=Points(points=[(0.03 * i, 0.0, 0.095 * abs((i + 3) % 6 - 3)) for i in range(43)]),
    )
    riders = [rider(f"rider-{i}", 0.1, 1.0, line) for i in range(6)]
    scene = Scene(
        ropes=[line, *riders],
        anchors=[Anchor(rope="line", node=0), Anchor(rope="line", node=-1)],
        slides=[
            Slide(name=f"s{i}", rope=f"rider-{i}", on="line", at=0.6 * (i + 1)) for i in range(6)
        ],
        run={"duration": 0.02, "time_step": 1e-4, "method": "semi-implicit-euler"},
    )
    note = rw.simulate(scene).table["about the slides"]
    *told, more = note.split("; and ")
    assert more == "2 more"
    assert "; and ".join(told).count("slide '") == 4


def test_of_a_line_that_hangs_deep_check_foretells_the_turn() -> None:
    """Two anchors half a metre apart on 4 m of line: 10 kg draw it to a V, as steep on both sides."""
    scene = drawn_to_a_v(60, 0.5)
    (note,) = [note for note in rw.check(scene, measure=False).warnings if SAID in note]
    turn = 180.0 - 2.0 * math.degrees(math.asin(0.5 / 4.0))
    assert f"turns by {turn:.0f} degrees" in note
    level = scene.ropes[0].replace(shape=Slack(start=(-1.99, 0, 0), end=(1.99, 0, 0)))
    braked = scene.replace(slides=[scene.slides[0].replace(brake=1e3)])
    assert not foretold(scene.replace(ropes=(level, scene.ropes[1])))
    assert not foretold(braked)  # which stays where one side is slack


def test_of_a_line_with_heavier_loads_of_its_own_no_turn_is_foretold() -> None:
    """They draw it to another shape than a V at what slides: of the twin with light ones it is."""
    scene = drawn_to_a_v(40, 0.0)
    line, block = scene.ropes
    for mass in (1.0, 30.0):
        loaded = line.replace(loads=[Load(node=10, mass=mass), Load(node=0, mass=100.0)])
        assert bool(foretold(scene.replace(ropes=(loaded, block)))) is (mass < 10.0)


def drawn_to_a_v(segments: int, rise: float) -> Scene:
    """4 m of light line over half a metre, the right end `rise` [m] higher, and 10 kg that slide on it."""
    line = Rope(
        name="line",
        segments=segments,
        length=4.0,
        made_of=Material(EA=1e5, mass_per_length=0.001),
        shape=Slack(start=(-0.25, 0, 0), end=(0.25, 0, rise)),
    )
    held = [Anchor(rope="line", node=0), Anchor(rope="line", node=-1)]
    slides = [Slide(name="blk", rope="block", on="line", at=1.2)]
    return Scene(ropes=[line, rider("block", 0.2, 10.0, line)], anchors=held, slides=slides)


def foretold(scene: Scene) -> list[str]:
    """Return what `check` says of sharp turns."""
    return [note for note in rw.check(scene, measure=False).warnings if SAID in note]


def over_two_saddles(**more: Any) -> Scene:
    """Return a line that runs up, 4 m across between masts and down again, with 20 kg in the middle."""
    corners = np.array([(-3.0, 0.0, 0.0), (-2.0, 0.0, 6.0), (2.0, 0.0, 6.0), (3.0, 0.0, 0.0)])
    along = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(corners, axis=0), axis=1))])
    places = np.linspace(0.0, along[-1], 81)
    points = np.stack([np.interp(places, along, column) for column in corners.T], axis=1)
    line = Rope(
        name="line",
        segments=80,
        length=float(along[-1]),
        diameter=0.01,
        made_of=Material(EA=2e5, mass_per_length=0.1),
        shape=Points(points=[tuple(map(float, point)) for point in points]),
    )
    block = rider("block", 0.2, 20.0, line)
    held = [Anchor(rope="line", node=0), Anchor(rope="line", node=-1)]
    slides = [Slide(name="blk", rope="block", on="line", at=0.5 * float(along[-1]))]
    return Scene(**({"ropes": [line, block], "anchors": held, "slides": slides} | more))


def test_of_a_line_that_saddles_or_slings_bear_no_turn_is_foretold() -> None:
    """A run of such a line turns by 30 degrees between its saddles; from anchor to anchor it were 127."""
    (note,) = foretold(over_two_saddles())  # without any, it hangs from anchor to anchor
    assert "turns by 1" in note
    saddles = [
        Cylinder(name=name, **{"from": (x, -1, 5.7), "to": (x, 1, 5.7)}, radius=0.2)
        for name, x in (("a", -1.7), ("b", 1.7))
    ]
    assert not foretold(over_two_saddles(obstacles=saddles))
    scene = over_two_saddles()
    node = 22  # about where it leaves a mast
    held = Anchor(rope="sling", node=-1)
    tied = Joint(points=[{"rope": "line", "node": node}, {"rope": "sling", "node": 0}])
    start = tuple(scene.ropes[0].shape.points[node])
    sling = scene.ropes[1].replace(
        name="sling", length=0.5, loads=(), shape=Straight(start=start, direction=(0, 0, 1))
    )
    slung = scene.replace(
        ropes=[*scene.ropes, sling], anchors=[*scene.anchors, held], joints=[tied]
    )
    assert not foretold(slung)
