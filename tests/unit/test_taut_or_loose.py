"""Ropes without weight whose anchors are nearer than they are long: taut or loose, as rest tells."""

from __future__ import annotations

import math

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.scene import Anchor, Cylinder, Joint, Material, Polyline, Rope, Scene, Slack, Straight

STRING = Material(EA=1e3, mass_per_length=0.01)
HALF, BELOW, ROUND = (
    0.5,
    0.3,
    0.051,
)  # of the anchors, and radius of the peg to the string's axis [m]
LOOSE = r"it is slack between its anchors, and has there no shape of its own"


def over_a_peg(length: float, above: float = 0.0) -> Scene:
    """Return a string without weight between two anchors, drawn over a peg without friction above them.

    Drawn so far above its surface [m].
    """
    turns = [
        (ROUND * math.sin(a), 0.0, ROUND * math.cos(a) + above) for a in np.linspace(-1.0, 1.0, 9)
    ]
    points = [(-HALF, 0.0, -BELOW), *turns, (HALF, 0.0, -BELOW)]
    string = Rope(
        segments=80, length=length, diameter=0.002, made_of=STRING, shape=Polyline(points=points)
    )
    peg = Cylinder(name="peg", start=(0, -1, 0), end=(0, 1, 0), radius=0.05)
    return Scene(
        gravity=(0, 0, 0),
        ropes=[string],
        anchors=[Anchor(node=0), Anchor(node=-1)],
        obstacles=[peg],
    )


def way_over_the_peg() -> float:
    """Return the length of the shortest way over the peg [m]: two tangents and the arc between them."""
    far = math.hypot(HALF, BELOW)
    side = math.sqrt(far**2 - ROUND**2)
    turn = math.pi - 2.0 * math.atan2(HALF, BELOW) + 2.0 * (math.pi / 2.0 - math.acos(ROUND / far))
    return 2.0 * side + ROUND * turn


def test_a_string_over_a_peg_is_taut_by_its_way() -> None:
    """It was refused as slack between its anchors, by their distance straight through the peg."""
    length = way_over_the_peg() / 1.1
    assert length > 2.0 * HALF
    scene = over_a_peg(length)
    rest = rw.equilibrium(scene)
    free = rest.tension[0, [0, 20, 60, -1]]
    assert free == pytest.approx(np.full(4, 100.0), rel=0.005)
    assert rw.check(scene, measure=False).ropes[0].largest_tension == rest.tension.max()


def test_a_string_that_hangs_loosely_about_a_peg_is_refused() -> None:
    scene = over_a_peg(1.3 * way_over_the_peg(), above=0.02)
    with pytest.raises(rw.SceneError, match=LOOSE):
        rw.equilibrium(scene)
    told = str(rw.check(scene, measure=False))
    assert "at rest: largest tension 0 N, strain 0 %\n  segments slack at rest 80" in told
    assert "its anchor bears" not in told


def two(first: float, second: float) -> Scene:
    """Return two strings of lengths [m] in a line over 6 m, tied where they are drawn 4 m from its start."""
    ropes = [
        Rope(name=name, segments=3, length=size, made_of=STRING, shape=Straight(start=a, end=b))
        for name, size, a, b in (
            ("first", first, (0, 0, 0), (4, 0, 0)),
            ("second", second, (4, 0, 0), (6, 0, 0)),
        )
    ]
    ends = [{"rope": "first", "node": -1}, {"rope": "second", "node": 0}]
    held = [Anchor(rope="first", node=0), Anchor(rope="second", node=-1)]
    return Scene(gravity=(0, 0, 0), ropes=ropes, anchors=held, joints=[Joint(points=ends)])


def test_a_string_that_another_draws_taut_is_so() -> None:
    """The second was refused as slack by where its joint is drawn, not by where it comes to rest."""
    rest = rw.equilibrium(two(3.0, 2.5))
    want = 1e3 * (6.0 / 5.5 - 1.0)
    assert np.delete(rest.tension[0], 3) == pytest.approx(np.full(6, want), rel=1e-9)
    with pytest.raises(rw.SceneError, match=LOOSE):
        rw.equilibrium(two(4.0, 3.0))


def test_the_rounding_of_a_stiff_chain_takes_no_tension_from_a_thread_beside_it() -> None:
    """At map coordinates 0.35 mN are left on the chain: 10 mN of the thread were told as slack."""
    at, over = 5e5, ROUND + 0.06
    turns = [(at + over * math.sin(a), at, over * math.cos(a)) for a in np.linspace(-1.5, 1.5, 9)]
    chain = Rope(
        name="chain",
        segments=60,
        length=2.41,
        diameter=0.02,
        made_of=Material(EA=1e6, mass_per_length=20.0),
        shape=Polyline(points=[(at - 0.4, at, -1.0), *turns, (at + 0.4, at, -1.0)]),
    )
    thread = Rope(
        name="thread",
        segments=8,
        length=1.05,
        diameter=0.001,
        made_of=Material(EA=50.0, mass_per_length=1e-3),
        shape=Slack(start=(at, at + 3.0, 0.0), end=(at + 1.0, at + 3.0, 0.0)),
    )
    bar = Cylinder(name="bar", start=(at, at - 1, 0), end=(at, at + 1, 0), radius=0.1, friction=0.3)
    held = [Anchor(rope=name, node=node) for name in ("chain", "thread") for node in (0, -1)]
    scene = Scene(ropes=[chain, thread], anchors=held, obstacles=[bar])
    alone = Scene(ropes=[thread], anchors=held[2:])
    told, want = (rw.check(one, measure=False).ropes[-1] for one in (scene, alone))
    assert told.slack == 0
    assert told.largest_tension == pytest.approx(want.largest_tension, rel=1e-3)
    assert 0.009 < told.largest_tension < 0.011
