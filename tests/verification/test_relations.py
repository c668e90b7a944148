"""Scenes that must move alike do, with every feature: from elsewhere or in a mirror, in other units, from
the other end of a rope, and carried along.

What differs is rounding, times what eight steps amplify: the tolerance is a part of the largest number of the
same unit.
"""

from __future__ import annotations

import functools

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.scene import Scene
from verification.feature_pairs import FEATURES, scene_of
from verification.relations import (
    Record,
    as_points,
    back_again,
    carried,
    carried_record,
    difference,
    from_the_other_end,
    given,
    in_units,
    record_in_units,
    recorded,
    turned,
    turned_record,
)

#: Groups that between them have all features, in a method that takes them.
GROUPS = {
    "plain": (),
    "links": ("rigid links", "load", "clamp", "air"),
    "winch": ("winch", "bending", "axial friction", "joint"),
    "bounds": ("limiter", "force", "kick"),
    "curve": ("curve", "relaxation", "obstacle"),
    "touch": ("contact", "tension only", "moved anchor"),
    "slide": ("slide", "ground", "parting"),
}
METHODS = {"links": "esdirk3", "bounds": "esdirk3"}
CLOSE = 1e-8  # [1]
SHIFT = np.array([12.0, -25.0, 8.0])  # [m]
DOLL = 0.05, np.sqrt(0.05), 2e-4  # lengths, times and masses of a doll's house: gravity is the same
STIFF = 1e-5  # [m/N]; by default contacts know how long a frame of film is, see `laws.obstacle`


def turn(seed: int) -> np.ndarray:
    """A mirror, turned at random."""
    turned_by, _ = np.linalg.qr(np.random.default_rng(seed).normal(size=(3, 3)))
    mirror: np.ndarray = turned_by @ np.diag([1.0, 1.0, -1.0])
    return mirror


@functools.cache
def scene_with(group: str) -> Scene:
    scene = as_points(scene_of(METHODS.get(group, "sdirk2"), *GROUPS[group], implicit=True))
    ground = {
        name: getattr(scene.ground, name, None) for name in ("repulsion", "friction", "absorption")
    }
    parts = {
        "ground": scene.ground
        and given(scene.ground, **ground),  # whose defaults are numbers with units
        "obstacles": [given(body, compliance=STIFF) for body in scene.obstacles],
        "contact": scene.contact and given(scene.contact, compliance=STIFF),
        "slides": [given(slide, compliance=STIFF) for slide in scene.slides],
    }
    run = given(scene.run, duration=0.04, frame_rate=100.0)  # eight steps
    return given(scene, run=run, **parts)


@functools.cache
def run_of(group: str) -> rw.Result:
    return rw.simulate(scene_with(group))


def alike(wanted: Record, result: rw.Result) -> bool:
    return max(difference(wanted, recorded(result)).values()) < CLOSE


def test_all_features_are_in_a_group() -> None:
    assert {name for group in GROUPS.values() for name in group} == set(FEATURES)


@pytest.mark.parametrize("group", GROUPS)
def test_seen_in_a_mirror_from_elsewhere(group: str) -> None:
    """The twin: a scene that is turned without its gravity moves otherwise."""
    base, mirror = run_of(group), turn(1)
    there = turned(base.scene, mirror, SHIFT)
    wanted = turned_record(recorded(base), mirror, SHIFT, base.scene.up)
    assert alike(wanted, rw.simulate(there))
    if group == "plain":
        assert not alike(wanted, rw.simulate(given(there, gravity=base.scene.gravity)))


@pytest.mark.parametrize("group", GROUPS)
def test_in_other_units(group: str) -> None:
    """A doll's house moves as the house does: nothing has a length, a time or a mass of its own. The twin: it
    does not where its masses are those of the house.
    """
    base = run_of(group)
    wanted = record_in_units(recorded(base), DOLL)
    # Not yet: what presses ropes that come near is recorded otherwise in other units.
    if group == "touch":
        del wanted["contact_force"], wanted["contact_work"]
    assert alike(wanted, rw.simulate(in_units(base.scene, DOLL)))
    if group == "plain":
        assert not alike(wanted, rw.simulate(in_units(base.scene, (*DOLL[:2], 1.0))))


@pytest.mark.parametrize("group", GROUPS)
def test_from_the_other_end(group: str) -> None:
    base = run_of(group)
    span = base.layout.ropes[0]
    result = rw.simulate(from_the_other_end(base.scene, 0))
    got = back_again(recorded(result), span.first, span.last)
    assert max(difference(recorded(base), got).values()) < CLOSE


@pytest.mark.parametrize("group", [name for name in GROUPS if name not in ("touch", "slide")])
def test_carried_along(group: str) -> None:
    """Forces and motions are the same on board, and so is what the method makes of the energy: what anchors
    and obstacles do as they are led along is counted. All but the ground and anchors that have a way of their
    own can be carried.
    """
    base, velocity = run_of(group), np.array([1.5, -0.7, 0.4])
    result = rw.simulate(carried(base.scene, velocity))
    wanted = carried_record(recorded(base), base.time, velocity)
    waits = base.layout.ropes[0].start  # nodes that wait on a drum are recorded at rest
    wanted["velocities"][:, :waits] = 0.0
    assert alike(wanted, result)
    turned_over = sum(np.abs(work).max() for work in result.work.values())
    assert np.abs(result.energy_error - base.energy_error).max() < CLOSE * turned_over
