"""Knots that are tied, drawn tight and loaded: they stay the knots they are, and hold by friction alone."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from ropewalk.core.arrays import Floats
from ropewalk.scene import (
    Anchor,
    Contact,
    Force,
    Knot,
    Material,
    Rope,
    RunSettings,
    Scene,
    Velocity,
)
from ropewalk.simulation import Simulation
from verification.topology import crossings, jones

D = 0.01  # [m]
FAR = 8.0  # [m]
STUFF = Material(EA=1e4, mass_per_length=0.08, axial_damping=2.0)
RUN = RunSettings(method="implicit-euler", time_step=1 / 240, frame_rate=60)


def rope(name: str, one: float, ends: float, **shape: Any) -> Rope:
    """A rope in a knot, of segments of so many diameters and ends of so many [m] together."""
    knot = Knot(**shape)
    count = math.ceil((knot.tied(D).length + ends) / (one * D))
    length = count * one * D
    return Rope(name=name, segments=count, length=length, diameter=D, made_of=STUFF, shape=knot)


def bend(knot: str, friction: float) -> Scene:
    """Two ropes tied to each other, whose long ends go apart at 0.3 m/s; the short ends are free."""
    ropes = [rope(name, 1.2, 0.3, knot=knot, rope=k + 1) for k, name in enumerate(("one", "two"))]
    hands = [
        Anchor(rope=one.name, node=0, motion=Velocity(velocity=(speed, 0, 0)))
        for one, speed in zip(ropes, (-0.15, 0.15), strict=True)
    ]
    contact = Contact(friction=friction)
    return Scene(gravity=(0, 0, 0), ropes=ropes, anchors=hands, contact=contact, run=RUN)


def knot_of(x: Floats, nodes: int) -> dict[int, int]:
    """The Jones polynomial of two ropes joined far away, long ends to each other and short ones; (3, n)."""
    a, b = x[:, :nodes].T, x[:, nodes:].T
    over = [[-FAR, a[-1, 1], 0], [-FAR, FAR, 0], [FAR, FAR, 0], [FAR, b[-1, 1], 0]]
    below = [[FAR, b[0, 1], 0], [FAR, -FAR, 0], [-FAR, -FAR, 0], [-FAR, a[0, 1], 0]]
    closed = np.vstack([a, over, b[::-1], below])
    turns = np.linspace(0.1, 2.0, 20)
    return jones(closed, min(turns, key=lambda turn: len(crossings([closed], turn)[0])))


def pulled(scene: Scene, frames: int, enough: float) -> tuple[Simulation, float]:
    """The scene after so many frames, or when its first segments carry enough [N]; and their most."""
    simulation, most = Simulation(scene), 0.0
    for _ in range(frames):
        simulation.step(1.0 / 60.0)
        most = max(most, float(simulation.arrays.tension[:5].mean()))
        if most > enough:
            break
    return simulation, most


@pytest.mark.slow
@pytest.mark.parametrize("knot", ["reef", "granny"])
def test_a_reef_and_a_granny_stay_what_they_are(knot: str) -> None:
    """With friction 0.5 both hold 500 N, and nothing passed through: the same polynomials as before."""
    scene = bend(knot, 0.5)
    nodes = scene.ropes[0].nodes
    before = knot_of(Simulation(scene).arrays.x, nodes)
    simulation, most = pulled(scene, 90, 500.0)
    assert most > 500.0
    assert knot_of(simulation.arrays.x, nodes) == before


@pytest.mark.slow
def test_without_friction_a_reef_runs_out() -> None:
    """The twin: what held was friction."""
    _, most = pulled(bend("reef", 0.0), 90, 500.0)
    assert most < 20.0


def about_a_post(knot: str, friction: float) -> Scene:
    """A newton at the free end, and the other drawn away at 0.2 m/s."""
    line = rope("line", 1.0, 0.4, knot=knot, post_radius=2.0 * D)
    x = line.shape.places(line.segments, line.length_unstretched, line.segment_length, (0, 0, 1), D)
    ways = [
        (end - before) / np.linalg.norm(end - before)
        for end, before in ((x[0], x[1]), (x[-1], x[-2]))
    ]
    line = line.replace(forces=[Force(node=-1, force=ways[1].tolist())])
    hand = Anchor(node=0, motion=Velocity(velocity=(0.2 * ways[0]).tolist()))
    assert isinstance(line.shape, Knot)
    post = line.shape.post(0.5, friction=friction, compliance=1e-5)
    contact = Contact(friction=friction)
    return Scene(
        gravity=(0, 0, 0), ropes=[line], anchors=[hand], obstacles=[post], contact=contact, run=RUN
    )


@pytest.mark.slow
def test_a_clove_hitch_holds_more_than_its_turns() -> None:
    """Two turns hold exp(0.4 * 4 pi) = 152 times the newton; the hitch, two turns too, twice that."""
    simulation, _ = pulled(about_a_post("bollard", 0.4), 42, math.inf)
    turns = float(simulation.arrays.tension[:5].mean())
    assert turns == pytest.approx(math.exp(0.4 * 4.0 * math.pi), rel=0.1)
    _, hitch = pulled(about_a_post("clove-hitch", 0.4), 42, 2.0 * turns + 1.0)
    assert hitch > 2.0 * turns


@pytest.mark.slow
def test_without_friction_a_clove_hitch_slips() -> None:
    """The twin: the newton at the free end is all that there is, and what it takes to move the rope."""
    _, hitch = pulled(about_a_post("clove-hitch", 0.0), 42, math.inf)
    assert hitch < 20.0
