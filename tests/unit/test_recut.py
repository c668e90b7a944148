"""Ropes that a sheet cuts anew, to see what their segments cost, are the same ropes."""

from __future__ import annotations

import pytest

import ropewalk as rw
from ropewalk.scene import Kick, Load
from ropewalk.scene.recut import recut
from ropewalk.scene.shapes import Points
from unit.test_sheets import hung


def test_a_recut_rope_is_the_same_rope() -> None:
    """Loads, forces and anchors stay where they are; odd ones are cut twice as fine instead."""
    scene = hung(12)
    half = recut(scene)
    assert half.scene is not None
    assert half.factor == 0.5
    assert half.scene.ropes[0].segments == 6
    assert half.scene.ropes[0].loads[0].node == 3
    assert half.scene.anchors[1].node == 6
    assert half.scene.ropes[0].total_mass == pytest.approx(scene.ropes[0].total_mass, rel=1e-12)
    odd = recut(hung(10))  # the load is at node 5
    assert odd.scene is not None
    assert odd.factor == 2.0
    assert odd.scene.ropes[0].loads[0].node == 10


def test_a_rope_in_motion_is_recut_with_its_motion() -> None:
    """Kicks at every node that no anchor holds are a motion of the rope: it stays the same one."""
    fall = rw.preset("climbing-fall")
    half = recut(fall)
    assert half.scene is not None
    (rope,), (whole,) = half.scene.ropes, fall.ropes
    assert [kick.node for kick in rope.kicks] == [*range(1, 8)]
    assert rope.kicks[-1].velocity == whole.kicks[-1].velocity
    fine = recut(half.scene).scene  # 7 segments: cut twice as fine
    assert fine is not None
    found = {kick.node: kick.velocity[2] for kick in fine.ropes[0].kicks}
    want = {kick.node: kick.velocity[2] for kick in whole.kicks}
    assert found == pytest.approx(want, abs=1e-3)
    assert recut(fall.replace(ropes=[whole.replace(kicks=whole.kicks[1:])])).scene is None


def test_what_cannot_be_recut_says_why() -> None:
    rope = hung().ropes[0].replace(kicks=[Kick(node=2, velocity=(0, 1, 0))])
    assert "kick" in recut(hung(ropes=[rope])).why_not
    points = [(0.5 * i, 0.0, 0.1 * (i % 2)) for i in range(5)]
    rope = hung().ropes[0].replace(segments=4, shape=Points(points=points), loads=())
    half = recut(hung(ropes=[rope])).scene
    assert half is not None
    assert list(half.ropes[0].shape.points) == points[::2]
    rope = rope.replace(loads=[Load(node=1, mass=1.0)])
    finer = recut(hung(ropes=[rope])).scene
    assert finer is not None
    assert finer.ropes[0].shape.points[1] == pytest.approx((0.25, 0.0, 0.05))
