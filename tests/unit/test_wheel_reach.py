"""Boxes of what turns freely, and of what it reaches; and whose it is."""

from __future__ import annotations

import numpy as np
import pytest

from ropewalk.engine.wheel_reach import ahead_of, boxes_of_wheels, homes_of, reached
from ropewalk.laws.contact import push_on
from ropewalk.laws.obstacle_places import surface_near
from ropewalk.laws.pairs.swept import AHEAD, HELD_LOW, place_held, runs_of, with_held
from ropewalk.lowering import build
from ropewalk.scene import Material, Rope, RunSettings, Scene, Straight

FREE = {"free": True, "inertia": 1e-3}
BODIES = {
    "cylinder": {"kind": "cylinder", "start": (0.1, 0.2, 0), "end": (0.5, 0.6, 0.3), "radius": 0.2},
    "capsule": {"kind": "capsule", "start": (0, 0, 0), "end": (0, 0.3, 0.1), "radius": 0.1},
    "sphere": {"kind": "sphere", "center": (0.3, 0, 0), "radius": 0.2, "axis": (0, 1, 0),
               "spin": {"pivot": (0.3, 0.1, 0)}},
    "torus": {"kind": "torus", "center": (0, 0, 0), "axis": (0, 1, 0.5), "radius": 0.3, "bar_radius": 0.05},
}  # fmt: skip
CAMS = {
    "tilted": {"kind": "cylinder", "start": (-0.3, 0, 0), "end": (0.3, 0, 0), "radius": 0.1,
               "spin": {"axis": (0.2, 0.4, 1.0), "pivot": (0.2, 0.1, 0.0)}},
    "aside": {"kind": "sphere", "center": (0.3, 0, 0), "radius": 0.2, "axis": (0, 1, 0),
              "spin": {"pivot": (0.35, 0, 0.1)}},
    "box": {"kind": "box", "center": (0, 0, 0), "half_sizes": (0.3, 0.1, 0.05), "edge_radius": 0.01,
            "axis": (0, 1, 0), "rotation": (0.1, 0.2, 0.3)},
    "mesh": {"kind": "mesh", "position": (0.2, 0, 0), "axis": (0, 1, 0), "rounding": 0.02,
             "vertices": [(0, 0, 0), (0.4, 0, 0), (0, 0.4, 0), (0, 0, 0.4)],
             "faces": [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]},
}  # fmt: skip


def with_body(body: dict[str, object], ys: tuple[float, ...] = (5.0,)) -> Scene:
    body = body | {"name": "w", "spin": FREE | dict(body.get("spin", {}))}  # type: ignore[call-overload]
    stuff = Material(EA=1e4, mass_per_length=0.1)
    ropes = [
        Rope(name=f"r{k}", segments=2, length=1.0, diameter=0.02, made_of=stuff,
             shape=Straight(start=(0.0, y, 5.0)))
        for k, y in enumerate(ys)
    ]  # fmt: skip
    run = RunSettings(method="implicit-euler", time_step=0.01, duration=0.1)
    return Scene(ropes=ropes, obstacles=[body], run=run)


@pytest.mark.parametrize("name", BODIES)
def test_a_wheel_stays_in_its_box(name: str) -> None:
    """Points inside it do not leave it; the twin: it is not too large."""
    table = build(with_body(BODIES[name])).system.node.obstacle
    ((*low, a, b, c),) = boxes_of_wheels(table)
    high, low = np.array((a, b, c)), np.array(low)
    random = np.random.default_rng(2)
    points = random.uniform(low - 0.1, high + 0.1, (12000, 3))
    points = points[[surface_near(table, 0, one)[0] < 0.0 for one in points]]
    assert len(points) > 60
    assert (points >= low - 1e-9).all()
    assert (points <= high + 1e-9).all()
    middle, half = 0.5 * (low + high), 0.5 * (high - low)
    assert (np.abs(points - middle).max(axis=0) > 0.8 * half).any()


@pytest.mark.parametrize("name", BODIES)
def test_what_a_wheel_would_press_is_within_its_reach(name: str) -> None:
    """At any place and speed; the twin: most of those that it does not press are not."""
    model = build(with_body(BODIES[name]))
    table, random = model.system.node.obstacle, np.random.default_rng(3)
    ahead, (wheel,) = ahead_of(model), boxes_of_wheels(table)
    assert ahead[1] == table.ratio[0] * table.damping[0, 1] / table.stiffness[0, 1] > 0.0
    swept = with_held(runs_of(np.zeros(2, np.int64)), ahead)[1:]
    pressed, spared = 0, [0, 0]
    for _ in range(3000):
        x, v = np.full((3, 3), 0.2), np.zeros((3, 3))
        x[:, 1:], v[:, 1] = random.uniform(-0.6, 0.6, (3, 1)), random.normal(size=3) * 30.0
        gap, *normal = surface_near(table, 0, x[:, 1])[:4]
        rise = float(np.dot(normal, v[:, 1]))
        push = push_on(table, 0, 1, gap, rise) > 0.0
        place_held(x, v, x, v, swept)
        own = swept[0, HELD_LOW:AHEAD] + 0.011 * np.repeat([-1.0, 1.0], 3)
        near = bool((own[:3] <= wheel[3:]).all() and (wheel[:3] <= own[3:]).all())
        pressed += push
        assert near or not push
        spared[near] += not push
    assert pressed > 40
    assert spared[0] > spared[1]


def test_what_has_no_ends_or_moves_is_within_reach_of_all() -> None:
    endless = BODIES["capsule"] | {"kind": "cylinder", "endless": True}
    box = boxes_of_wheels(build(with_body(endless)).system.node.obstacle)[0]
    assert np.isfinite(box[[0, 3]]).all()
    assert np.isinf(box[[1, 2, 4, 5]]).all()
    for cam in CAMS.values():
        assert np.isinf(boxes_of_wheels(build(with_body(cam)).system.node.obstacle)).all()
    moving = BODIES["sphere"] | {"motion": {"kind": "velocity", "velocity": (0, 0, 1)}}
    assert np.isinf(boxes_of_wheels(build(with_body(moving)).system.node.obstacle)).all()


def test_a_wheel_goes_with_the_rope_that_is_nearest_where_it_is_drawn() -> None:
    assert homes_of(build(with_body(BODIES["sphere"], (9.0, 2.0, 3.0)))).tolist() == [1]


def test_groups_meet_the_one_that_has_the_wheel_and_no_other() -> None:
    wheels = np.array([[0, 0, 0, 1, 1, 1], [10, 0, 0, 11, 1, 1]], float)
    boxes = [
        np.array([[0.5, 0.5, 0.5, 0.6, 0.6, 0.6], [10.9, 0, 0, 12, 1, 1]]),
        np.array([[5, 5, 5, 6, 6, 6.0]]),
        np.array([[20, 0, 0, 21, 1, 1.0]]),
    ]
    groups = [(0, 3), (1,), (2,)]
    assert reached(wheels, np.array([3, 2]), groups, boxes) == {(0, 2)}
    assert reached(wheels, np.array([1, 1]), groups, boxes) == {(0, 1)}
    assert reached(wheels, np.array([0, 3]), groups, boxes) == set()
