"""Modes where friction carries all it can: small motions have it hold, as runs do after their first swing."""

from __future__ import annotations

import math
import re
from typing import Any

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.scene import Contact, Cylinder, Ring, Slack, Spin, Straight, Velocity
from ropewalk.statics import static_shape

RADIUS, THICK, g = 0.05, 0.01, 9.81
RUN = rw.RunSettings(method="esdirk3", time_step=0.01, frame_rate=100.0, duration=4.0)


def arc(
    radius: float, start: float, sides: int, y: float = 0.0
) -> list[tuple[float, float, float]]:
    turns = np.linspace(start, 0.0, sides + 1)
    return [(float(radius * np.cos(a)), y, float(radius * np.sin(a))) for a in turns]


def length_of(points: Any) -> float:
    return float(np.linalg.norm(np.diff(np.array(points), axis=0), axis=1).sum())


def pendulum(
    share: float = 1.0, EA: float = 1e5, down: float = 1.0, segments: int = 120, **more: Any
) -> rw.Scene:
    """1 kg on 1 m of rope that goes over a drum: its own weight drags all contacts to their limit."""
    radius = RADIUS + 0.5 * THICK + 1e-4
    points = [(-0.5, 0.0, radius), *arc(radius, 0.5 * math.pi, 13), (radius, 0.0, -down)]
    rope = rw.Rope(
        name="rope",
        segments=segments,
        length=share * length_of(points),
        diameter=THICK,
        made_of=rw.Material(EA=EA, mass_per_length=1e-3),
        shape={"kind": "polyline", "points": points},
        loads=[rw.Load(node=-1, mass=1.0)],
    )
    drum = rw.Cylinder(start=(0, -0.1, 0), end=(0, 0.1, 0), radius=RADIUS, friction=0.3, **more)
    return rw.Scene(ropes=[rope], anchors=[rw.Anchor(node=0)], obstacles=[drum], run=RUN)


def rung(scene: rw.Scene, mode: int, speed: float, node: int, axis: int) -> float:
    """At what frequency a run that starts in a mode goes on past its first swing [Hz]."""
    run = scene.run.replace(start="at-rest", ring=Ring(mode=mode, speed=speed))
    way = rw.simulate(scene.replace(run=run)).positions[:, node, axis]
    way = way[len(way) // 4 :]
    way = way - 0.5 * (way.max() + way.min())
    turns = np.flatnonzero(np.diff(np.sign(way)) != 0)
    ends = turns - way[turns] / (way[turns + 1] - way[turns])
    return float(0.5 * (len(ends) - 1) / (ends[-1] - ends[0]) * scene.run.frame_rate)


@pytest.mark.parametrize("share", [1.0, 0.9999])
def test_a_load_over_a_drum_swings_about_where_it_leaves_it(share: float) -> None:
    """However little of its tension friction has left: 0.360 Hz and others were found, a run has 0.497."""
    scene = pendulum(share)
    rest = static_shape(scene)
    swings = math.sqrt(g / np.linalg.norm(rest.positions[-1] - rest.positions[rest.wraps[0].last]))
    found = rw.modes(scene, count=2)
    assert found.frequencies == pytest.approx([swings / (2.0 * math.pi)] * 2, rel=3e-3)


def test_a_run_rings_as_it_is_said() -> None:
    found = rw.modes(pendulum(), count=1)
    assert found.motions[0].name == "out of plane"
    assert rung(pendulum(), 1, 0.01, -1, 1) == pytest.approx(found.frequencies[0], rel=2e-3)
    (note,) = found.notes
    assert re.match("[67] of 7 contacts carry nearly all that friction can, and hold", note)


def turning(**more: Any) -> rw.Scene:
    return pendulum(0.9999, 1e3, 0.5, 60, **more)


@pytest.mark.parametrize("rate", [20.0, -20.0])
def test_over_a_drum_that_turns_nothing_holds_along(rate: float) -> None:
    """The rope slips all the time: 6.99 Hz were found with friction that holds, as on one that stands."""
    scene = turning(spin=Spin(rate=rate))
    found = rw.modes(scene, count=4)
    (mode,) = [row["mode"] for row in found.table if row["motion"] == "along"]
    said = found.frequencies[mode - 1]
    run = scene.run.replace(duration=2.0)
    rings = rung(scene.replace(run=run), mode, 0.01, -1, 2)
    assert rings == pytest.approx(said, rel=0.2)
    assert abs(rings - said) > 0.05 * said  # what the note is for
    (note,) = found.notes
    assert note.startswith("obstacle 'obstacle0' moves along under what touches it from the start")
    assert "over bodies that stand" in note
    assert found.at_limit == (0, 0)


def test_where_no_surface_moves_along_friction_holds() -> None:
    """A drum that stands, one that turns later or after the run, and one that goes where the anchor goes."""
    still = rw.modes(turning(), count=3)
    lift = Velocity(velocity=(0, 0, 0.1))
    leaves = turning(spin=Spin(rate=20.0, start=9.0))
    later = turning(spin=Spin(rate=20.0, start=1.0))  # 4.8 Hz: as if it turned already
    both = turning(motion=lift)
    both = both.replace(anchors=[rw.Anchor(node=0, motion=lift)])
    for scene in (leaves, later, both):
        found = rw.modes(scene, count=3)
        assert found.frequencies == pytest.approx(still.frequencies, rel=1e-9)
        assert not found.slips_on
    assert rw.modes(turning(motion=lift), count=3).slips_on == ("obstacle0",)


def test_a_capstan_that_turns_later_holds_at_rest() -> None:
    """0, 0 and 0.358 Hz were found: without friction a kilogram holds no twelve."""
    capstan = rw.preset("capstan")
    (drum,) = capstan.obstacles
    still = capstan.replace(obstacles=[drum.replace(spin=None)])
    found = rw.modes(capstan, count=3)
    assert found.frequencies == pytest.approx(rw.modes(still, count=3).frequencies, rel=1e-9)
    assert found.frequencies[0] > 0.8
    assert not any("slips all the time" in note for note in found.notes)


@pytest.mark.parametrize("turns", [24, 25])
def test_bumps_of_a_rope_that_slides_over_a_drum_are_told(turns: int) -> None:
    """12 kg on both sides: 0.187 Hz, or e in 0.47 s; the rope's own weight lets it grow by e in 3.5 s."""
    radius, free, mass = 0.1055, 0.5, 0.1
    points = [(-radius, 0.0, -free), *arc(radius, math.pi, turns), (radius, 0.0, -free)]
    long = length_of(points)
    rope = rw.Rope(
        segments=4 * turns,
        length=long,
        diameter=0.01,
        made_of=rw.Material(EA=1e5, mass_per_length=mass, axial_damping=5.0),
        shape={"kind": "polyline", "points": points},
        loads=[rw.Load(node=0, mass=12.0), rw.Load(node=-1, mass=12.0)],
    )
    drum = Cylinder(name="drum", start=(0, -0.2, 0), end=(0, 0.2, 0), radius=0.1, friction=0.0)
    found = rw.modes(rw.Scene(ropes=[rope], obstacles=[drum], run=RUN), count=5)
    (note,) = [one for one in found.notes if "slides over 'drum'" in one]
    told = re.search(r"without them it grows, x e in (\S+) s", note)
    assert told
    smooth = math.sqrt((24.0 + mass * long) / (2.0 * mass * g))
    assert float(told[1]) == pytest.approx(smooth, rel=0.05)


def test_a_trolley_that_friction_just_holds_does_not_roll() -> None:
    """It rolled as without friction, at 0.1 Hz."""
    line = rw.Rope(
        name="line",
        segments=20,
        length=10.1,
        made_of=rw.Material(EA=1e8, mass_per_length=0.002),
        shape=Slack(start=(0, 0, 0), end=(10, 0, 0)),
    )
    rider = rw.Rope(
        name="rider",
        segments=1,
        length=0.3,
        made_of=rw.Material(EA=1e4, mass_per_length=0.002),
        shape=Straight(end=(0, 0, -0.3)),
        loads=[rw.Load(node=0, mass=5.0)],
    )
    anchors = [rw.Anchor(rope="line", node=node) for node in (0, -1)]
    slides = [rw.Slide(rope="rider", on="line", at=7.0, friction=0.05)]
    scene = rw.Scene(ropes=[line, rider], anchors=anchors, slides=slides, run=RUN)
    (seat,) = static_shape(scene).seats
    assert seat.use == pytest.approx(1.0, abs=1e-6)  # it has crept to the edge
    found = rw.modes(scene, count=2)
    assert (found.frequencies > 0.6).all()
    assert found.notes == [
        "the one contact carries nearly all that friction can, and holds in small motions, once the first "
        "half swing has let them slip a little: larger motions slip on, ring lower and die down sooner"
    ]


def test_ropes_that_friction_just_holds_on_each_other_stay() -> None:
    """1 kg and 2.52 kg on a rope over another one, which slips from exp(pi mu) = 2.566 on: it hung free."""
    radius = 1.01 * THICK
    over = [(0.0, -x, z) for x, _, z in arc(radius, math.pi, 7)]
    points = [(0.0, radius, -0.3), *over, (0.0, -radius, -0.3)]
    line = rw.Rope(
        name="line",
        segments=21,
        length=0.995,
        diameter=THICK,
        made_of=rw.Material(EA=1e4, mass_per_length=0.02, axial_damping=20.0),
        shape=Straight(start=(-0.5, 0, 0), end=(0.5, 0, 0)),
    )
    hung = rw.Rope(
        name="hung",
        segments=90,
        length=length_of(points),
        diameter=THICK,
        made_of=rw.Material(EA=1e4, mass_per_length=0.001, axial_damping=20.0),
        shape={"kind": "polyline", "points": points},
        loads=[rw.Load(node=0, mass=1.0), rw.Load(node=-1, mass=2.52)],
    )
    anchors = [rw.Anchor(rope="line", node=node) for node in (0, -1)]
    contact = Contact(friction=0.3)
    run = RUN.replace(method="implicit-euler")
    scene = rw.Scene(ropes=[line, hung], anchors=anchors, contact=contact, run=run)
    found = rw.modes(scene, count=2)
    assert (found.frequencies > 0.8).all()  # as pendulums
    full, of = found.at_limit
    assert full > 0.5 * of
    assert any("carry nearly all that friction can" in note for note in found.notes)
