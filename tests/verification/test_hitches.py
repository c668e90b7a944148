"""Hitches that are drawn tight, let go of, and loaded slowly: friction holds them, and nothing else."""

from __future__ import annotations

import math
from typing import Literal

import numpy as np
import pytest

from ropewalk.core.arrays import Floats
from ropewalk.scene import Air, Anchor, Contact, Knot, Material, Rope, RunSettings, Scene, Table
from ropewalk.simulation import Broken, Simulation

D = 0.01  # [m]
STUFF = Material(EA=1e4, mass_per_length=0.08, axial_damping=2.0)
DRAG = Air(node_drag=0.02)  # takes the whipping of ends that are let go
Course = list[tuple[float, Floats]]  # times [s] and places [m]


def segments(shape: Knot) -> int:
    """Of such a rope: its ends are 0.3 m together, with what of them a knot is tied about."""
    return math.ceil((shape.tied(D).curves[0].length + 0.3) / D)


def hitch(shape: Knot, courses: tuple[Course, Course], post: float, rope: float) -> Scene:
    """A hitch on a fixed post, with those frictions; the last end is let go where its course ends."""
    count = segments(shape)
    line = Rope(segments=count, length=count * D, diameter=D, made_of=STUFF, shape=shape)
    anchors = [
        Anchor(
            node=node,
            motion=Table(times=[t for t, _ in course], positions=[p.tolist() for _, p in course]),
            release_time=None if course[-1][0] > 3.0 else course[-1][0],
        )
        for node, course in zip((0, -1), courses, strict=True)
    ]
    return Scene(
        gravity=(0, 0, 0),
        ropes=[line],
        anchors=anchors,
        obstacles=[shape.post(1.0, friction=post, compliance=1e-5)],
        contact=Contact(friction=rope),
        run=RunSettings(method="implicit-euler", time_step=1 / 240, frame_rate=60),
        air=DRAG,
    )


def ends(shape: Knot) -> tuple[Floats, Floats, Floats, Floats]:
    """Places [m] of both ends of such a rope, and the directions in which they are drawn."""
    count = segments(shape)
    x = shape.places(count, count * D, D, (0, 0, 1), D)
    return x[0], x[-1], (x[0] - x[1]) / D, (x[-1] - x[-2]) / D


def clove_hitch(post: float, rope: float) -> tuple[float, float]:
    """The load [N] of a clove hitch with a free end, at most till that slid 2 mm; its way [m]."""
    shape = Knot(knot="clove-hitch", post_radius=2.0 * D)
    hand, tail, out, off = ends(shape)
    tight = 0.025
    courses = (
        [
            (0.0, hand),
            (0.4, hand + tight * out),
            (0.8, hand + tight * out),
            (3.8, hand + 0.175 * out),
        ],
        [(0.0, tail), (0.4, tail + tight * off), (0.5, tail + 0.023 * off)],
    )
    simulation = Simulation(hitch(shape, courses, post, rope))
    simulation.step(0.78)
    start, most = simulation.arrays.x[:, -1].copy(), 0.0
    for _ in range(90):
        simulation.step(1.0 / 60.0)
        slid = float(np.linalg.norm(simulation.arrays.x[:, -1] - start))
        if slid > 0.002:
            break
        most = max(most, float(simulation.arrays.tension[:3].mean()))
        if most > 1000.0:
            break
    return most, slid


def prusik(friction: float) -> tuple[float, float]:
    """A prusik is drawn along its post by both ends: the most they take [N], how far it slid [m]."""
    shape = Knot(knot="prusik", post_radius=D)
    tight, length = 0.07, 0.0
    courses = []
    for place in ends(shape)[:2]:
        foot = np.array([-2.0 * D, place[1], place[2]])
        length = foot[0] - place[0] + tight
        angles = np.linspace(0.0, 0.5 * math.pi, 13)
        arc = [
            (0.4 + 0.4 * a / angles[-1], foot - length * np.array([math.cos(a), 0.0, math.sin(a)]))
            for a in angles
        ]
        away = (3.8, foot - (length + 0.15) * np.array([0.0, 0.0, 1.0]))
        courses.append([(0.0, place), *arc, away])
    simulation = Simulation(hitch(shape, (courses[0], courses[1]), friction, friction))
    simulation.step(0.82)

    def middle() -> float:
        x = simulation.arrays.x
        return float(x[2, np.hypot(x[0], x[1]) < 1.75 * D].mean())

    start, most = middle(), 0.0
    for _ in range(90):
        simulation.step(1.0 / 60.0)
        tension = simulation.arrays.tension
        most = max(most, float(tension[:3].mean() + tension[-3:].mean()))
        if most > 700.0:
            break
    return most, start - middle()


@pytest.mark.slow
def test_a_clove_hitch_holds_with_a_free_end() -> None:
    """1 kN with friction 0.6; with 0.3 it slides at a tenth of it, and without any at once."""
    most, slid = clove_hitch(0.6, 0.6)
    assert most > 1000.0
    assert slid < 0.001
    assert clove_hitch(0.3, 0.3)[0] < 150.0
    assert clove_hitch(0.0, 0.0)[0] < 1.0


@pytest.mark.slow
def test_the_strand_over_the_ends_drags_them_along() -> None:
    """All strands slide the same way: with smooth rope on a rough post it holds, with rough rope not."""
    assert clove_hitch(0.4, 0.0)[0] > 1000.0
    assert clove_hitch(0.4, 0.4)[0] < 300.0


@pytest.mark.slow
def test_a_prusik_holds_along_its_post() -> None:
    """700 N on 0.3; without friction it comes along."""
    most, slid = prusik(0.3)
    assert most > 700.0
    assert slid < 0.008
    most, _ = prusik(0.0)
    assert most < 5.0


def bend(
    knot: Literal["reef", "granny"], friction: float, stiffness: float = 0.0
) -> tuple[float, float]:
    """Two ropes tied to each other, drawn tight by all four ends; then the short ones are let go.

    With a bending stiffness [N m^2] the short ends are slackened by 1 mm before, lest they spring.
    Returns the most [N] that the long ends bore till a short one had slid 50 mm, or 700 N; and its way [m].
    Negative: no step was found beyond that.
    """
    tight, ropes, anchors = 0.05, [], []
    stuff = STUFF
    if stiffness:
        stuff = STUFF.replace(EI=stiffness, bending_damping=0.02 * stiffness)
    for k, name in enumerate(("one", "two")):
        shape = Knot(knot=knot, rope=k + 1)
        count = math.ceil((shape.tied(D).length + 0.4) / D)
        one = Rope(
            name=name, segments=count, length=count * D, diameter=D, made_of=stuff, shape=shape
        )
        ropes.append(one)
        x = shape.places(count, count * D, D, (0, 0, 1), D)
        for node, release in ((0, None), (-1, 0.6)):
            out = np.array([np.sign(x[node, 0]), 0.0, 0.0])
            ways = (0.0, tight, tight - (0.002 if stiffness and release else 0.0), 0.125)
            course = [x[node] + way * out for way in ways]
            places = [p.tolist() for p in course]
            motion = Table(times=[0.0, 0.5, 0.7, 2.2], positions=places)
            anchors.append(Anchor(rope=name, node=node, motion=motion, release_time=release))
    scene = Scene(
        gravity=(0, 0, 0),
        ropes=ropes,
        anchors=anchors,
        contact=Contact(friction=friction),
        run=RunSettings(method="implicit-euler", time_step=1 / 240, frame_rate=60),
        air=DRAG,
    )
    simulation = Simulation(scene)
    simulation.step(0.7)
    short = [ropes[0].nodes - 1, -1]
    start, most, slid = simulation.arrays.x[:, short].copy(), 0.0, 0.0
    for _ in range(90):
        try:
            simulation.step(1.0 / 60.0)
        except Broken:
            return -most, slid
        slid = float(np.linalg.norm(simulation.arrays.x[:, short] - start, axis=0).max())
        if slid > 0.05:
            break
        most = max(most, float(simulation.arrays.tension[:3].mean()))
        if most > 700.0:
            break
    return most, slid


@pytest.mark.slow
def test_a_reef_holds_where_a_granny_slips() -> None:
    """With friction 0.3; with 0.1 the reef slips, too."""
    assert bend("reef", 0.3)[0] > 700.0
    assert bend("granny", 0.3)[0] < 400.0
    assert bend("reef", 0.1)[0] < 5.0
