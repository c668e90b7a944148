"""How deep soft ropes go into obstacles: under 10 % of their diameter in any step, under 1 % at rest.

Before contacts had anything beyond the stiffness of the segments, these ropes went 0.2 to 1.6 diameters into
bars that they were thrown at, and lay 1 % to 70 % of one deep in what carried them.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.core.arrays import Floats
from ropewalk.laws.obstacle_places import depths
from ropewalk.lowering import build
from ropewalk.scene import Points, Straight

Triple = tuple[float, float, float]
AT_REST: dict[str, Any] = {"method": "implicit-euler", "time_step": 1 / 60, "duration": 3.0}
RADIUS = 0.02
#: Methods that take any stiffness, with steps that see how deep a rope is; `adaptive` has its own.
THROWN: dict[str, float | None] = {
    "implicit-euler": 0.0005,
    "bdf2": 0.001,
    "esdirk3": 0.002,
    "adaptive": None,
}


def points(places: Floats) -> list[Triple]:
    return [(float(x), float(y), float(z)) for x, y, z in places]


def thrown(seed: int, run: dict[str, Any]) -> tuple[rw.Scene, float]:
    """A soft rope that is held at its ends, thrown at a bar along the y axis; and where it touches [m]."""
    rng = np.random.default_rng(seed)
    d, radius = float(rng.choice([0.004, 0.01])), float(10 ** rng.uniform(-1.8, -1.4))
    across, down, n = rng.uniform(0.1, 0.18), rng.uniform(0.2, 0.3), 24
    angle, lift = np.linspace(0.0, np.pi, n + 1), rng.uniform(0.02, 0.1)
    x = np.c_[-across * np.cos(angle), np.zeros(n + 1), down * np.sin(angle) - down + lift + radius]
    way = np.array([0.15, 0.1, 0.15]) * rng.normal(size=3) + (0.0, 0.0, -1.0)
    way *= rng.uniform(10.0, 50.0) / np.linalg.norm(way)
    rope = rw.Rope(
        segments=n,
        length=float(np.linalg.norm(np.diff(x, axis=0), axis=1).sum()),
        diameter=d,
        made_of=rw.Material(
            EA=float(10 ** rng.uniform(3.0, 3.6)),
            mass_per_length=0.05,
            axial_damping=float(rng.choice([0.0, 1.0])),
        ),
        shape=Points(points=points(x), velocity=points(way[None])[0]),
    )
    bar = rw.Cylinder(
        start=(0, -1, 0),
        end=(0, 1, 0),
        radius=radius,
        endless=True,
        friction=float(rng.choice([0.0, 0.3])),
    )
    ends = [rw.Anchor(node=0), rw.Anchor(node=-1)]
    return rw.Scene(ropes=[rope], anchors=ends, obstacles=[bar], run=run), radius + 0.5 * d


@pytest.mark.parametrize("method", THROWN)
def test_soft_ropes_thrown_at_bars_stay_outside(method: str) -> None:
    step, deepest = THROWN[method], []
    rate = {"frame_rate": 2000} if step is None else {"time_step": step, "frame_rate": 1 / step}
    for seed in range(12):
        scene, touch = thrown(seed, {"method": method, "duration": 0.06, **rate})
        found = rw.simulate(scene).positions
        inside = touch - np.hypot(found[..., 0], found[..., 2]).min()
        deepest.append(float(inside) / scene.ropes[0].diameter)
    print(method, np.round(deepest, 3))
    assert sum(one > 0.005 for one in deepest) >= 8
    assert max(deepest) < 0.1


def bar_of_triangles(radius: float, half: float) -> rw.Mesh:
    """A bar along the y axis with 48 sharp edges."""
    around = np.arange(48)
    turn = around * 2.0 * np.pi / 48
    ring = np.c_[radius * np.cos(turn), np.full(48, -half), radius * np.sin(turn)]
    middle = np.array([(0.0, -half, 0.0), (0.0, half, 0.0)])
    nodes = np.concatenate([ring, ring * (1.0, -1.0, 1.0), middle])
    faces = [
        face
        for i, j in zip(around.tolist(), np.roll(around, -1).tolist(), strict=True)
        for face in ((i, i + 48, j), (j, i + 48, j + 48), (i, j, 96), (j + 48, i + 48, 97))
    ]
    return rw.Mesh(vertices=points(nodes), faces=faces, friction=0.3)


def deep_in_mesh(scene: rw.Scene) -> Floats:
    """Return how deep the rope is in every frame over its diameter, (frames,)."""
    table, found = build(scene).system.node.obstacle, rw.simulate(scene).positions
    deep = [depths(table, np.ascontiguousarray(one.T)).max() for one in found]
    return np.array(deep) / scene.ropes[0].diameter


def test_soft_ropes_thrown_at_sharp_edges_stay_outside() -> None:
    """Of triangles without a rounding, which had contacts no stiffer than the segments: 0.99 d deep."""
    deepest = []
    for seed in range(6):
        run = {
            "method": "implicit-euler",
            "duration": 0.06,
            "time_step": 0.0005,
            "frame_rate": 2000,
        }
        scene, touch = thrown(seed, run)
        edges = bar_of_triangles(touch - 0.5 * scene.ropes[0].diameter, 1.0)
        deepest.append(float(deep_in_mesh(scene.replace(obstacles=[edges])).max()))
    print(np.round(deepest, 3))
    assert sum(one > 0.005 for one in deepest) >= 4
    assert max(deepest) < 0.1


def over_bar(d: float, EA: float, masses: dict[int, float]) -> rw.Scene:
    """A rope over half a bar, with masses at its ends; an end without one is held."""
    r = RADIUS + 0.5 * d
    h = np.pi * r / 12
    turn, legs = np.linspace(0.0, np.pi, 13), h * np.arange(8, 0, -1)
    x = np.concatenate(
        [
            np.c_[np.full(8, -r), -legs],
            np.c_[-r * np.cos(turn), r * np.sin(turn)],
            np.c_[np.full(8, r), -legs[::-1]],
        ]
    )
    places = np.c_[x[:, 0], np.zeros(len(x)), x[:, 1]]
    rope = rw.Rope(
        segments=len(x) - 1,
        length=float(np.linalg.norm(np.diff(x, axis=0), axis=1).sum()),
        diameter=d,
        made_of=rw.Material(EA=EA, mass_per_length=0.05, axial_damping=EA * 0.0005),
        shape=Points(points=points(places)),
        loads=[rw.Load(node=node, mass=mass) for node, mass in masses.items()],
    )
    bar = rw.Cylinder(start=(0, -0.1, 0), end=(0, 0.1, 0), radius=RADIUS, friction=0.3)
    held = [rw.Anchor(node=node) for node in (0, -1) if node not in masses]
    return rw.Scene(ropes=[rope], anchors=held, obstacles=[bar], run=AT_REST)


def deep_in_bar(scene: rw.Scene) -> Floats:
    """Return how deep the rope is in every frame over its diameter, (frames,)."""
    found, d = rw.simulate(scene).positions, scene.ropes[0].diameter
    return np.asarray(RADIUS / d + 0.5 - np.hypot(found[..., 0], found[..., 2]).min(axis=1) / d)


@pytest.mark.parametrize("held", [False, True], ids=["both ends loaded", "one end held"])
@pytest.mark.parametrize(
    ("d", "EA", "mass"),
    [(0.004, 1e4, 30.0), (0.004, 1e4, 100.0), (0.004, 1234.0, 10.0), (0.01, 1234.0, 30.0)],
)
def test_what_hangs_over_a_bar_by_a_soft_rope_lies_on_it(
    d: float, EA: float, mass: float, held: bool
) -> None:
    scene = over_bar(d, EA, {0: mass} if held else {0: mass, -1: mass})
    deep = deep_in_bar(scene)
    assert 0.004 < deep[-1] < 0.01
    assert deep.max() < 0.02
    settled = scene.replace(run={**AT_REST, "start": "at-rest", "duration": 0.1})
    assert 0.004 < deep_in_bar(settled)[0] < 0.01


@pytest.mark.parametrize(("d", "EA", "mass"), [(0.004, 1e4, 100.0), (0.01, 1234.0, 30.0)])
def test_what_hangs_over_sharp_edges_by_a_soft_rope_lies_on_them(
    d: float, EA: float, mass: float
) -> None:
    """It lay 4.9 and 5.9 % of its diameter deep in them."""
    scene = over_bar(d, EA, {0: mass, -1: mass})
    deep = deep_in_mesh(scene.replace(obstacles=[bar_of_triangles(RADIUS, 0.1)]))
    assert 0.004 < deep[-1] < 0.01
    assert deep.max() < 0.02


@pytest.mark.parametrize("mass", [1.0, 10.0, 100.0])
@pytest.mark.parametrize("EA", [1234.0, 1e5])
def test_a_load_on_a_soft_rope_lies_on_the_plane(EA: float, mass: float) -> None:
    d = 0.004
    rope = rw.Rope(
        segments=20,
        length=0.5,
        diameter=d,
        made_of=rw.Material(EA=EA, mass_per_length=0.05, axial_damping=EA * 0.0005),
        shape=Straight(start=(0, 0, 0.5 * d + 0.003), end=(0.5, 0, 0.5 * d + 0.003)),
        loads=[rw.Load(node=10, mass=mass)],
    )
    run = rw.simulate(rw.Scene(ropes=[rope], obstacles=[rw.Plane()], run=AT_REST))
    deep = 0.5 - run.positions[:, 10, 2] / d
    assert 0.003 < deep[-1] < 0.01
    assert deep.max() < 0.015
