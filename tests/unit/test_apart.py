"""Anchors that pull a rope apart by their motions alone: `check` knows it beforehand."""

from __future__ import annotations

import pytest

import ropewalk as rw
from ropewalk.analysis.apart import jerks, torn_apart
from ropewalk.core.status import BROKEN, OK, UNSOLVED
from ropewalk.lowering import build
from ropewalk.scene import Anchor, Limiter, Material, Rope, RunSettings, Scene, Straight, Velocity
from ropewalk.simulation import Simulation


def pulled(speed: float = 4.0, method: str = "verlet", **more: object) -> Scene:
    """A metre of soft cord; one end is held, the other one pulled away along it for 3 s."""
    stuff = Material(**({"EA": 200.0, "mass_per_length": 0.1, "axial_damping": 1.0} | more))
    shape = Straight(start=(0, 0, 0), end=(1, 0, 0))
    motion = Velocity(velocity=(speed, 0, 0))
    return Scene(
        ropes=[Rope(segments=6, length=1.0, made_of=stuff, shape=shape)],
        anchors=[Anchor(name="wall", node=0), Anchor(name="hand", node=-1, motion=motion)],
        gravity=(0, 0, 0),
        run=RunSettings(method=method, duration=3.0),
    )


def broken_at(scene: Scene) -> tuple[int, float]:
    simulation = Simulation(scene)
    status = OK
    for block in simulation.frames():
        status = block.status
    return status, simulation.time


@pytest.mark.parametrize("method", ["verlet", "esdirk3"])
def test_it_says_when_the_run_breaks(method: str) -> None:
    """At 4 m/s a metre is ten long after 2.25 s, in every method; at 2.9 m/s it is 9.7 at the end."""
    scene = pulled(method=method)
    found = rw.check(scene, measure=False)
    assert not found.ok
    (torn,) = found.torn
    assert torn.anchors == ("wall", "hand")
    assert torn.time == pytest.approx(2.25, abs=1.0 / 60.0)
    assert str(torn) == found.warnings[0]
    status, time = broken_at(scene)
    assert status == BROKEN
    assert (
        torn.time - 3.0 / 60.0 < time < torn.time
    )  # its last good frame; the pull swings a little
    calm = pulled(2.9, method)
    assert rw.check(calm, measure=False).ok
    assert broken_at(calm)[0] == OK


def test_a_jerk_is_not_blamed_for_a_distance() -> None:
    """Waves run at 45 m/s: 100 m/s stretches the first segment too far, 4 m/s only what is led too far."""
    assert not jerks(build(pulled()))
    (told,) = jerks(build(pulled(400.0).replace(run=RunSettings(method="verlet", duration=0.001))))
    assert "moves at up to 400 m/s" in told


def test_rigid_links_and_bounds_give_way_by_nothing() -> None:
    bound = pulled().replace(limiter=Limiter(max_stretch=2.0))
    implicit = bound.replace(run=bound.run.replace(method="bdf2"))
    assert torn_apart(build(implicit))[0].time == pytest.approx(0.25, abs=1.0 / 60.0)
    assert broken_at(implicit)[0] == UNSOLVED
    assert torn_apart(build(bound))[0].time > 2.0  # an explicit limiter does not hold it


def test_who_lets_go_in_time_pulls_nothing_apart() -> None:
    scene = pulled()
    wall, hand = scene.anchors
    assert torn_apart(build(scene.replace(anchors=[wall, hand.replace(release_time=2.0)]))) == []
    assert torn_apart(build(scene.replace(anchors=[wall, hand.replace(release_time=2.5)])))
    between = Anchor(name="post", node=3, release_time=1.0)
    found = torn_apart(build(scene.replace(anchors=[wall, between, hand])))
    assert found[0].anchors == ("wall", "hand")  # from when the post lets go
