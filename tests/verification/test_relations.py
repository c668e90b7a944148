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
from ropewalk.scene import (
    Anchor,
    Contact,
    Load,
    Material,
    Points,
    Rope,
    RunSettings,
    Scene,
    Straight,
)
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
STAYS = "ground", "moved anchor"  # what cannot be carried along
EXPLICIT = "semi-implicit-euler"
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
def scene_with(group: str, *without: str, method: str = "") -> Scene:
    method = method or METHODS.get(group, "sdirk2")
    features = [name for name in GROUPS[group] if name not in without]
    scene = as_points(scene_of(method, *features, implicit=method != EXPLICIT))
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
def run_of(group: str, *without: str, method: str = "") -> rw.Result:
    return rw.simulate(scene_with(group, *without, method=method))


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


@pytest.mark.parametrize(
    ("group", "method"),
    [*((group, "") for group in GROUPS), *((group, EXPLICIT) for group in ("touch", "slide"))],
)
def test_carried_along(group: str, method: str) -> None:
    """Forces and motions are the same on board, and so is what the method makes of the energy: what anchors
    and obstacles do as they are led along is counted. All but the ground and anchors that have a way of their
    own can be carried.
    """
    base, velocity = run_of(group, *STAYS, method=method), np.array([1.5, -0.7, 0.4])
    result = rw.simulate(carried(base.scene, velocity))
    wanted = carried_record(recorded(base), base.time, velocity)
    waits = base.layout.ropes[0].start  # nodes that wait on a drum are recorded at rest
    wanted["velocities"][:, :waits] = 0.0
    assert alike(wanted, result)
    turned_over = sum(np.abs(work).max() for work in result.work.values())
    assert np.abs(result.energy_error - base.energy_error).max() < CLOSE * turned_over


def drawn_over(method: str) -> Scene:
    """A rope over a taut one, whose right end draws it over by a load."""
    side, size = 0.02, np.hypot(0.035, 0.01)
    angles = 2.0 * np.arcsin(0.5 * side / size) * np.arange(-3, 4)
    arc = size * np.stack([np.sin(angles), 0.0 * angles, np.cos(angles)], axis=1)
    left = arc[0] - side * np.outer([2, 1], (0, 0, 1))
    right = arc[-1] - side * np.outer([1, 2, 3], (0, 0, 1))
    line = Material(EA=2e3, mass_per_length=0.1, axial_damping=1.0)
    over = Rope(
        name="over",
        segments=11,
        length=11 * side,
        diameter=0.01,
        made_of=line,
        shape=Points(points=np.concatenate([left, arc, right]).tolist()),
        loads=[Load(node=-1, mass=0.1)],
    )
    taut = Straight(start=(0, -0.2, 0), end=(0, 0.2, 0))
    below = Rope(name="below", segments=1, length=0.4, diameter=0.06, made_of=line, shape=taut)
    return Scene(
        ropes=[over, below],
        anchors=[Anchor(rope="below", node=node) for node in (0, 1)],
        contact=Contact(friction=0.3),
        run=RunSettings(method=method, time_step=1 / 240, duration=0.05, frame_rate=240.0),
    )


@pytest.mark.parametrize("method", ["implicit-euler", "esdirk3"])
def test_what_slips_slips_alike_carried_along(method: str) -> None:
    """Friction does not know how fast both ropes go: at 2 m/s across the bar tensions were 70 % off."""
    base, velocity = rw.simulate(drawn_over(method)), np.array([-2.0, 0.0, 0.0])
    result = rw.simulate(carried(base.scene, velocity))
    assert alike(carried_record(recorded(base), base.time, velocity), result)
    assert base.positions[-1, 0, 2] - base.positions[0, 0, 2] > 5e-3
    assert base.work["contact"][-1] < 0.0


def thrown_over() -> Scene:
    """A rope with a load at each end, laid over a taut one that is not quite level."""
    line = Material(EA=2e4, mass_per_length=0.06, axial_damping=20.0)
    x, s = np.linspace(-0.483, 0.517, 11), np.linspace(-0.2963, 0.3037, 21)
    side, drop = np.minimum(np.abs(s), 0.05), np.maximum(np.abs(s) - 0.05, 0.0)
    taut = np.stack([x, 0.0 * x, 0.1 * x], axis=1)
    over = np.stack([0.003 * s, np.sign(s) * side, 0.01 - drop], axis=1)
    given = {"diameter": 0.01, "made_of": line}
    ropes = [
        Rope(name="taut", segments=10, length=1.0, shape=Points(points=taut.tolist()), **given),
        Rope(
            name="over",
            segments=20,
            length=0.6,
            shape=Points(points=over.tolist()),
            loads=[Load(node=node, mass=1.0) for node in (0, -1)],
            **given,
        ),
    ]
    return Scene(
        ropes=ropes,
        anchors=[Anchor(rope="taut", node=node) for node in (0, -1)],
        contact=Contact(friction=0.3),
        run=RunSettings(method="implicit-euler", time_step=1 / 60, duration=0.1, frame_rate=60.0),
    )


def test_what_a_step_may_make_up_is_the_same_carried_along() -> None:
    """By the energy of the whole it was more on board: other steps were halved, and nodes 6 mm off."""
    base, velocity = rw.simulate(thrown_over()), np.array([16.0, -8.0, 0.0])
    result = rw.simulate(carried(base.scene, velocity))
    assert alike(carried_record(recorded(base), base.time, velocity), result)
