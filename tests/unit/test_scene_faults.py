"""Every fault of a scene is named by path, value and rule, and all at once."""

from __future__ import annotations

import math
import pickle

import numpy as np
import pytest

from ropewalk.scene import (
    Anchor,
    Limiter,
    Material,
    Orbit,
    Polyline,
    Rope,
    Scene,
    SceneError,
    Shake,
    Springs,
    Straight,
    Table,
    Velocity,
    loads,
)
from ropewalk.simulation import Simulation

ROPE = """
[[rope]]
name = "line"
segments = 4
made_of = { kind = "springs", spring_constant = 100, node_mass = 0.1, segment_length = 1.0 }
"""
TWO = ROPE + ROPE.replace("line", "other")


def faults(text: str) -> list[str]:
    """The lines of the error that a scene text gives."""
    with pytest.raises(SceneError) as caught:
        loads(text)
    return str(caught.value).splitlines()


def changed(old: str, new: str) -> str:
    assert old in ROPE
    return ROPE.replace(old, new)


def test_the_plain_text_has_no_fault() -> None:
    scene = loads(ROPE)
    assert scene.ropes[0].segments == 4
    assert loads(TWO).ropes[1].name == "other"


@pytest.mark.parametrize(
    ("old", "new", "line"),
    [
        ("segments = 4", "segments = 0", "rope[0].segments: 0 - must be at least 1"),
        ("segments = 4", "segments = -3", "rope[0].segments: -3 - must be at least 1"),
        ("segments = 4", "segments = 4.0", "rope[0].segments: 4.0 - must be a whole number"),
        ("segments = 4", 'segments = "4"', 'rope[0].segments: "4" - must be a whole number'),
        ("segments = 4", "segments = true", "rope[0].segments: true - must be a whole number"),
        (
            "segments = 4",
            "segments = 20000000",
            "rope[0].segments: 20000000 - must be at most 1e+07",
        ),
        ("segments = 4", "", "rope[0].segments: missing - is needed: number of segments"),
        (
            "segments = 4",
            "segmets = 4",
            'rope[0].segmets: unknown key; did you mean "segments"?',
        ),
        ('"springs"', '"spring"', 'did you mean "springs"?'),
        (
            "constant = 100",
            'constant = "100"',
            'rope[0].made_of.spring_constant: "100" - must be a number (N/m)',
        ),
        (
            "constant = 100",
            "constant = true",
            "rope[0].made_of.spring_constant: true - must be a number (N/m)",
        ),
        ("= 0.1", "= 0", "rope[0].made_of.node_mass: 0 - must be greater than 0"),
        ("= 0.1", "= -1", "rope[0].made_of.node_mass: -1 - must be greater than 0"),
        ("= 0.1", "= 1e-200", "rope[0].made_of.node_mass: 1e-200 - must be at least 1e-12"),
        ("= 0.1", "= nan", "rope[0].made_of.node_mass: nan - must be a finite number (kg)"),
        ("= 0.1", "= inf", "rope[0].made_of.node_mass: inf - must be a finite number (kg)"),
        ("= 0.1", "= 1e300", "rope[0].made_of.node_mass: 1e+300 - must be at most 1e+15"),
        (
            "segment_length = 1.0",
            "segment_length = -1",
            "rope[0].made_of.segment_length: -1 - must be at least 0",
        ),
        ('"line"', '"a.b"', 'rope[0].name: "a.b" - must start with a letter and have only'),
        ('"line"', '""', 'rope[0].name: "" - must start with a letter'),
        ("[[rope]]", "[rope]", "must be a list of tables: write [[rope]], not [rope]"),
    ],
)
def test_one_fault_of_a_rope(old: str, new: str, line: str) -> None:
    found = faults(changed(old, new))
    assert len(found) == 1
    assert line in found[0]


@pytest.mark.parametrize(
    ("more", "line"),
    [
        ("length = 3.0", "rope[0].length: 3.0 - leave it out with springs"),
        ('shape = { kind = "slack", end = [0, 0, 3] }', "aside from start, across gravity"),
        ('shape = { kind = "slack", end = [0, 0, 0] }', "must be another point than start"),
        ('shape = { kind = "straight", end = [0, 0, 0] }', "must be another point than start"),
        ('shape = { kind = "straight", direction = [0, 0, 0] }', "must not be zero"),
        (
            'shape = { kind = "straight", end = [1, 0, 0], direction = [1, 0, 0] }',
            "give either end or direction",
        ),
        (
            'shape = { kind = "polyline", points = [[0, 0, 0], [1, 0, 0], [1, 0, 0]] }',
            "rope[0].shape.points[2]: [1.0, 0.0, 0.0] - must not lie on the point before it",
        ),
        (
            'shape = { kind = "polyline", points = [[0, 0, 0]] }',
            "rope[0].shape.points: [[0.0, 0.0, 0.0]] - must have at least 2 points",
        ),
        (
            'shape = { kind = "points", points = [[0, 0, 0], [1, 0, 0]] }',
            'rope[0].shape.points: "2 points" - must be 5 points, one per node',
        ),
        ('shape = { kind = "points" }', "rope[0].shape.points: missing - give points"),
        (
            'shape = { kind = "hanging", start = [0, 0] }',
            "rope[0].shape.start: [0, 0] - must be a list of three numbers, [x, y, z] (m)",
        ),
        (
            'shape = { kind = "hanging", start = [0, "0", 0] }',
            'rope[0].shape.start[1]: "0" - must be a number (m)',
        ),
        ('shape = { kind = "hanging", stat = [0, 0, 0] }', 'did you mean "start"?'),
        ("shape = { start = [0, 0, 0] }", "rope[0].shape.kind: missing - must be one of"),
        ("shape = 3", "rope[0].shape: 3 - must be a table"),
        ("load = [{ node = 5, mass = 1 }]", "rope[0].load[0].node: 5 - must be from 0 to 4, or"),
        ("load = [{ node = -6, mass = 1 }]", "rope[0].load[0].node: -6 - must be from 0 to 4"),
        ("load = [{ node = 0, mass = 0 }]", "rope[0].load[0].mass: 0 - must be greater than 0"),
        ("kick = [{ node = 5, velocity = [0, 0, 0] }]", "rope[0].kick[0].node: 5 - must be"),
        (
            "kick = [{ node = 4, velocity = [0, 0, 0] }, { node = -1, velocity = [1, 0, 0] }]",
            "rope[0].kick[1].node: -1 - is kicked by kick[0] already",
        ),
        ("diameter = 0", "rope[0].diameter: 0 - must be greater than 0"),
        ("[[anchor]]\nnode = 5", "anchor[0].node: 5 - must be from 0 to 4, or from -5 to -1"),
        ("[[anchor]]\nnode = -6", "anchor[0].node: -6 - must be from 0 to 4, or from -5 to -1"),
        (
            "[[anchor]]\nnode = 4\n[[anchor]]\nnode = -1",
            "anchor[1].node: -1 - is held by anchor[0]",
        ),
        (
            '[[anchor]]\nnode = 0\nrope = "lien"',
            'anchor[0].rope: "lien" - no such rope; did you mean "line"?',
        ),
        (
            '[[anchor]]\nnode = 0\nname = "a"\n[[anchor]]\nnode = 1\nname = "a"',
            'anchor[1].name: "a" - is the name of anchor[0] already',
        ),
        (
            '[[anchor]]\nnode = 0\nname = "anchor1"\n[[anchor]]\nnode = 1',
            'anchor[1].name: "anchor1" - is the name of anchor[0] already',
        ),
        (
            "[[anchor]]\nnode = 0\nrelease_time = -1",
            "anchor[0].release_time: -1 - must be at least 0",
        ),
        (
            "[[anchor]]\nnode = 0\nmotion = "
            '{ kind = "velocity", velocity = [1, 0, 0], start = 2, stop = 2 }',
            "anchor[0].motion.stop: 2.0 - must be later than start (2.0)",
        ),
        (
            "[[anchor]]\nnode = 0\nmotion = "
            '{ kind = "velocity", velocity = [1, 0, 0], stop = nan }',
            "anchor[0].motion.stop: nan - must be",
        ),
        (
            '[[anchor]]\nnode = 0\nmotion = { kind = "table", times = [0, 1, 1], '
            "positions = [[0, 0, 0], [1, 0, 0], [2, 0, 0]] }",
            "anchor[0].motion.times[2]: 1.0 - must be later than the time before it",
        ),
        (
            "[[anchor]]\nnode = 0\nmotion = "
            '{ kind = "table", times = [0, 1], positions = [[0, 0, 0]] }',
            'anchor[0].motion.positions: "1 place" - must have 2 places',
        ),
        (
            '[[anchor]]\nnode = 0\nmotion = { kind = "table", times = [0, 1] }',
            "anchor[0].motion.positions: missing - give times and positions, or file",
        ),
        (
            "[[anchor]]\nnode = 0\nmotion = "
            '{ kind = "shake", axis = [0, 0, 0], amplitude = 1, frequency = 1 }',
            "anchor[0].motion.axis: [0.0, 0.0, 0.0] - must not be zero",
        ),
        (
            "[[anchor]]\nnode = 0\nmotion = "
            '{ kind = "orbit", axis = [0, 0, 1], center = [0, 0, 0], frequency = 0 }',
            "anchor[0].motion.frequency: 0.0 - must not be zero",
        ),
        ('[[winch]]\nend = "end"\nspeed = 1', 'winch[0].end: "end" - needs an anchor at node -1'),
        (
            '[[winch]]\nend = "top"\nspeed = 1',
            'winch[0].end: "top" - must be one of "start", "end"',
        ),
        (
            '[[anchor]]\nnode = 0\n[[winch]]\nend = "start"\nspeed = 1\n'
            '[[winch]]\nend = "start"\nspeed = 2',
            'winch[1].end: "start" - has winch[0] already',
        ),
        (
            '[[anchor]]\nnode = 0\n[[winch]]\nend = "start"\nspeed = 1\nmax_length = 3',
            "winch[0].max_length: 3.0 - must be at least the rope's length at the start (4 m)",
        ),
        (
            '[[anchor]]\nnode = 0\n[[winch]]\nend = "start"\nspeed = 1\nmin_length = 5',
            "winch[0].min_length: 5.0 - must be at most the rope's length at the start (4 m)",
        ),
        ("[limiter]\nmin_stretch = 1.2", "limiter.min_stretch: 1.2 - must be at most max_stretch"),
        ("[limiter]\npasses = 0", "limiter.passes: 0 - must be at least 1"),
        ("[air]\nnode_drag = -1", "air.node_drag: -1 - must be at least 0"),
        ("[ground]\nheigth = 1", 'ground.heigth: unknown key; did you mean "height"?'),
        ("[[ground]]\nheight = 1", "must be one table: write [ground], not [[ground]]"),
        ("[run]\nduration = 0", "run.duration: 0 - must be greater than 0"),
        ("[run]\nduration = 1e14", "run.duration: 100000000000000.0 - makes 6e+15 frames"),
        (
            "[run]\ntime_step = 0",
            "run.time_step: 0 - must be a number of seconds from 1e-12 on, or",
        ),
        ('[run]\ntime_step = "fast"', 'run.time_step: "fast" - must be a number of seconds'),
        ("[run]\ntime_step = true", "run.time_step: true - must be a number of seconds"),
        ('[run]\nmethod = "rk5"', 'did you mean "rk4"?'),
        ("[run]\nmethod = 4", 'run.method: 4 - must be one of "euler", '),
        ("[run]\nseed = 4", "run.seed: unknown key; "),
    ],
)
def test_one_fault_around_a_rope(more: str, line: str) -> None:
    found = faults(f"{ROPE}\n{more}\n")
    assert len(found) == 1
    assert line in found[0]


@pytest.mark.parametrize(
    ("first", "line"),
    [
        ("time_step = 0.1", 'time_step: unknown key here; it belongs to "run.time_step"'),
        ("gravty = [0, 0, 0]", 'gravty: unknown key; did you mean "gravity"?'),
        ("gravity = 9.81", "gravity: 9.81 - must be a list of three numbers, [x, y, z] (m/s^2)"),
        ("schema_version = 2", "schema_version: 2 - this version of ropewalk reads 1"),
        ("name = 3", "name: 3 - must be text in quotes"),
        ('name = ""', 'name: "" - must not be empty'),
    ],
)
def test_one_fault_at_the_top(first: str, line: str) -> None:
    found = faults(f"{first}\n{ROPE}")
    assert len(found) == 1
    assert line in found[0]


def test_numbers_of_numpy_are_told_as_numbers() -> None:
    """It was told "np.float64(2e+16)"."""
    with pytest.raises(SceneError, match=r"^EA: 2e\+16 - must be at most"):
        Material(EA=np.float64(2e16), mass_per_length=0.1)


def test_faults_between_ropes() -> None:
    twice = 'rope[1].name: "line" - is the name of rope[0] already: give it another'
    assert faults(ROPE + ROPE) == [twice]
    unnamed = TWO.replace('name = "other"', "")
    assert faults(unnamed) == ["rope[1].name: missing - with several ropes each needs a name"]
    anchor = "[[anchor]]\nnode = 0\n"
    assert faults(TWO + anchor) == [
        "anchor[0].rope: missing - with several ropes, the name of one is needed"
    ]
    huge = TWO.replace("segments = 4", "segments = 6000000")
    assert faults(huge) == ['rope: "12000000 segments" - must be at most 10000000 in total']


def test_springs_without_a_length() -> None:
    text = changed("segment_length = 1.0", "segment_length = 0")
    assert faults(text)[0].startswith("rope[0].shape.end: missing - springs of no length")
    ended = text + "shape = { end = [1, 0, 0], kind = 'straight' }\n"
    assert loads(ended).ropes[0].length_unstretched == 0.0
    assert faults(ended + "[limiter]\n") == [
        "limiter: cannot limit rope[0], whose springs have no length"
    ]


def test_a_material_needs_a_length() -> None:
    text = '[[rope]]\nsegments = 2\nmade_of = { kind = "material", EA = 10, mass_per_length = 1 }\n'
    assert faults(text) == ["rope[0].length: missing - a material needs the rope's length (m)"]
    assert loads(text + "length = 2.0").ropes[0].segment_length == 1.0


def test_all_faults_come_at_once() -> None:
    """Those of the fields, of parts in themselves, and between the parts that are right."""
    found = faults(
        "gravity = [0, 0]\n[run]\nmethod = 'rk5'\n"
        + ROPE
        + ROPE.replace("segments = 4", "segments = 0").replace("line", "bad")
        + ROPE.replace("line", "third")
        + "shape = { kind = 'points', points = [[0, 0, 0], [1, 0, 0]] }\n"
        + "[[anchor]]\nnode = 7\nrope = 'line'\n[[anchor]]\nnode = 0\nrope = 'bad'\n"
        + "[[anchor]]\nnode = 'x'\nrope = 'line'\n[ground]\nrepulsion = -1\n"
    )
    paths = [line.split(":")[0] for line in found]
    assert paths == [
        "gravity",
        "run.method",
        "rope[1].segments",
        "rope[2].shape.points",
        "anchor[2].node",
        "ground.repulsion",
        "anchor[0].node",
    ]


def test_faults_can_be_read_by_programs() -> None:
    with pytest.raises(SceneError) as caught:
        loads(changed("segments = 4", "segments = 0"), "a.toml")
    (fault,) = caught.value.faults
    assert (fault.path, fault.value, fault.rule) == ("rope[0].segments", 0, "must be at least 1")
    assert caught.value.source == "a.toml"
    assert str(caught.value) == "a.toml: rope[0].segments: 0 - must be at least 1"
    again = pickle.loads(pickle.dumps(caught.value))
    assert again.faults == caught.value.faults
    assert str(again) == str(caught.value)


def springs(**changes: float) -> Springs:
    values = {"spring_constant": 1e4, "node_mass": 0.05, "segment_length": 1.0} | changes
    return Springs(**values)


@pytest.mark.parametrize(
    ("make", "line"),
    [
        (lambda: Rope(segments=0, made_of=springs()), "segments: 0 - must be at least 1"),
        (lambda: springs(node_mass=math.nan), "node_mass: nan - must be a finite number (kg)"),
        (lambda: springs(mass=1.0), "mass: unknown key"),
        (lambda: Straight(start=(0, 0)), "start: [0, 0] - must be a list of three numbers"),
        (lambda: Straight(start={1, 2, 3}), "start: {1, 2, 3} - must be a list of three"),
        (lambda: Polyline(points=[(0, 0, 0), (0, 0, 0)]), "points[1]: [0.0, 0.0, 0.0] - must not"),
        (lambda: Anchor(node=0, motion="fixed"), 'motion: "fixed" - must be a table'),
        (lambda: Velocity(velocity=(1, 0, 0), start=3, stop=1), "stop: 1.0 - must be later"),
        (lambda: Table(times=[0.0], positions=[(0, 0, 0)]), "times: [0.0] - must have at least 2"),
        (lambda: Shake(axis=(0, 0, 1), amplitude=0, frequency=1), "amplitude: 0 - must be greater"),
        (lambda: Orbit(center=(0, 0, 0), axis=(0, 0, 0), frequency=1), "axis: [0.0, 0.0, 0.0]"),
        (lambda: Limiter(passes=2.5), "passes: 2.5 - must be a whole number"),
        (lambda: Scene(), "rope: missing - a scene needs at least one [[rope]]"),
        (lambda: Scene(ropes=[3]), "rope[0]: 3 - must be a table"),
        (
            lambda: Scene(ropes=[Rope(segments=2, made_of=springs())], anchors=[Anchor(node=9)]),
            "anchor[0].node: 9 - must be from 0 to 2",
        ),
        (
            lambda: Material(EA=1.0, mass_per_length=0.0),
            "mass_per_length: 0.0 - must be greater than 0",
        ),
    ],
)
def test_faults_in_python(make, line: str) -> None:
    with pytest.raises(SceneError) as caught:
        make()
    assert line in str(caught.value)
    assert len(caught.value.faults) == 1


def test_a_rope_shorter_than_its_ends_are_apart_is_taut_unless_it_cannot_stretch() -> None:
    shape = 'shape = { kind = "slack", end = [5, 0, 0] }\nsegments = 4'
    taut = loads(changed("segments = 4", shape))
    assert Simulation(taut).positions[:, 0].tolist() == pytest.approx([0, 1.25, 2.5, 3.75, 5])
    rigid = changed("segments = 4", shape).replace("constant = 100", "constant = inf")
    assert any(
        "is shorter than the 5 m" in one and "does not stretch" in one for one in faults(rigid)
    )
