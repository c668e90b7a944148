"""Solids of triangles and of distances on a grid by closed forms: where they are, what they bear and hold."""

from __future__ import annotations

import dataclasses
import math
from typing import Any

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.analysis.facet_notes import facet_warnings
from ropewalk.laws.obstacle_rows import place_of, turned_by
from ropewalk.laws.obstacle_shapes import MESH, probe
from ropewalk.lowering import build
from ropewalk.scene import Material, Mesh, Obstacle, Points, Rope, RunSettings, Scene, Sdf
from ropewalk.statics import static_shape
from verification.test_capstan import capstan
from verification.test_meshes import ball_of_distances, block

g, MU = 9.81, 0.3
HALF = np.array([0.0, 0.5, 0.0])  # of the length of bars [m]
SLOPE = math.radians(25.0)
TURN = (0.5, -0.9, 0.3)  # rad
PLACE = (0.7, -2.0, 5.0)  # m
#: Along a slope that falls along x, and away from it.
DOWN = np.array([math.cos(SLOPE), 0.0, -math.sin(SLOPE)])
UP = np.array([math.sin(SLOPE), 0.0, math.cos(SLOPE)])


def grid(half: tuple[float, float, float], spacing: float) -> tuple[Any, tuple[float, ...]]:
    """Distances to a box, and the grid's first point."""
    first = [-(math.ceil(h / spacing) + 1.4) * spacing for h in half]
    axes = [np.arange(low, -low + spacing, spacing) for low in first]
    over = np.stack([np.abs(a) for a in np.meshgrid(*axes, indexing="ij")], -1) - np.array(half)
    outside = np.linalg.norm(np.maximum(over, 0.0), axis=-1)
    return outside + np.minimum(over.max(axis=-1), 0.0), tuple(first)


def slab(kind: str, friction: float) -> Obstacle:
    """A slab whose upper side is a slope through the origin."""
    half, more = (1.0, 0.3, 0.1), {"friction": friction, "name": "slab"}
    there = {"position": tuple(-0.1 * UP), "rotation": (0.0, SLOPE, 0.0)}
    if kind == "mesh":
        return block(half, 0.0, **there, **more)
    values, origin = grid(half, 0.05)
    return Sdf(values=values, spacing=0.05, origin=origin, **there, **more)


def laid(body: Obstacle, **more: Any) -> Scene:
    """A rope of two segments along the slope, at rest, just touching."""
    points = [tuple(0.005 * UP + s * DOWN) for s in (-0.2, -0.15, -0.1)]
    stuff = Material(EA=1e4, mass_per_length=0.1, axial_damping=5.0)
    shape = Points(points=points)
    rope = Rope(segments=2, length=0.1, diameter=0.01, made_of=stuff, shape=shape)
    run = {"duration": 0.25, "frame_rate": 60.0, "method": "esdirk3", "time_step": 1 / 240}
    return Scene(ropes=[rope], obstacles=[body], run=RunSettings(**(run | more)))


@pytest.mark.parametrize("unit", [1.0, 1e-3])
def test_a_ball_on_a_grid_is_a_ball_wherever_it_lies(unit: float) -> None:
    """Moved and turned, in metres and millimetres: distance, normal and side, also far off the grid.

    As near as the grid is: facets are within h^2 / 2 R, and lean by about h / R.
    """
    pytest.importorskip("skimage")
    values, origin = ball_of_distances(0.02)
    body = Sdf(
        values=values / unit,
        spacing=0.02 / unit,
        origin=tuple(np.array(origin) / unit),
        scale=unit,
        position=PLACE,
        rotation=TURN,
    )
    center, axis, row = (np.array(part, float) for part in place_of(body))
    rng = np.random.default_rng(4)
    for far in (0.2, 0.29, 0.31, 0.35, 3.0):
        way = rng.normal(size=3)
        way /= np.linalg.norm(way)
        found = probe(MESH, center, axis, row, *(np.array(PLACE) + far * way))
        assert found[0] == pytest.approx(far - 0.3, abs=0.02**2 / 0.6)
        if far > 0.25:
            assert np.array(found[1:4]) @ way > math.cos(0.02 / 0.3)


def test_a_grids_origin_is_where_its_first_point_is() -> None:
    """A box off the origin, turned: its upper side is a plane, to what shifts zeros off grid points."""
    pytest.importorskip("skimage")
    values, first = grid((0.2, 0.3, 0.1), 0.05)
    off = np.array([0.5, 0.1, -0.2])
    body = Sdf(
        values=values,
        spacing=0.05,
        origin=tuple(np.array(first) + off),
        position=PLACE,
        rotation=TURN,
    )
    center, axis, row = (np.array(part, float) for part in place_of(body))
    for x, y, z in ((0.0, 0.0, 0.1), (0.1, -0.2, 0.12), (-0.1, 0.1, 0.5), (0.05, 0.1, 0.07)):
        (place,) = turned_by(TURN, np.array([[x, y, z]]) + off)
        found = probe(MESH, center, axis, row, *(np.array(PLACE) + place))
        assert found[0] == pytest.approx(z - 0.1, abs=1e-6)
        (normal,) = turned_by(TURN, np.array([[0.0, 0.0, 1.0]]))
        np.testing.assert_allclose(found[1:4], normal, atol=1e-6)


@pytest.mark.parametrize("kind", ["mesh", "sdf"])
def test_on_an_incline_it_holds_slides_and_bears_by_the_law(kind: str) -> None:
    """At 1.1 tan(slope) it does not move, at MU it slides with g (sin - MU cos); it bears m g cos."""
    if kind == "sdf":
        pytest.importorskip("skimage")
    held = rw.simulate(laid(slab(kind, 1.1 * math.tan(SLOPE))))
    assert np.abs(held.positions[-1] - held.positions[9]).max() < 1e-8
    np.testing.assert_allclose(held.contact_force[-1].sum(axis=0), (0, 0, 0.01 * g), atol=1e-6)
    slid = rw.simulate(laid(slab(kind, MU)))
    speed = (slid.velocities @ DOWN).mean(axis=1)
    found = (speed[-1] - speed[6]) / (slid.time[-1] - slid.time[6])
    assert found == pytest.approx(g * (math.sin(SLOPE) - MU * math.cos(SLOPE)), rel=1e-3)
    bears = (slid.contact_force[-1] @ UP).sum()
    assert bears == pytest.approx(0.01 * g * math.cos(SLOPE), rel=1e-3)


def bar(kind: str, fine: int) -> Obstacle:
    """The bar of `capstan` of so many triangles round it, or points of a grid across its radius."""
    more = {"friction": MU, "compliance": 1e-6, "name": "bar"}
    if kind == "mesh":
        turn = 2.0 * np.pi * np.arange(fine) / fine
        ring = np.stack([0.05 * np.cos(turn), 0.0 * turn, 0.05 * np.sin(turn)], axis=1)
        sides = [(i, (i + 1) % fine) for i in range(fine)]
        front, back = 2 * fine, 2 * fine + 1
        faces = [
            three
            for i, j in sides
            for three in (
                (i, fine + i, fine + j),
                (i, fine + j, j),
                (i, j, front),
                (fine + j, fine + i, back),
            )
        ]
        ends = [ring - HALF, ring + HALF, [(0, -0.5, 0), (0, 0.5, 0)]]
        return Mesh(vertices=np.concatenate(ends), faces=faces, **more)
    h = 0.05 / fine
    across, along = np.arange(-0.07, 0.07 + h, h), np.arange(-0.06, 0.06 + h, h)
    x, y, z = np.meshgrid(across, along, across, indexing="ij")
    round_it, beyond = np.hypot(x, z) - 0.05, np.abs(y) - 0.04
    outside = np.hypot(np.maximum(round_it, 0.0), np.maximum(beyond, 0.0))
    values = outside + np.minimum(np.maximum(round_it, beyond), 0.0)
    return Sdf(values=values, spacing=h, origin=(across[0], along[0], across[0]), **more)


@pytest.mark.parametrize(
    ("kind", "fine", "within", "told"),
    [
        ("mesh", 24, 0.12, "meet at 15 degrees"),
        ("mesh", 96, 0.015, "meet at 3.7 degrees"),
        ("mesh", 200, 0.015, ""),
        ("sdf", 10, 0.015, "meet at 5.5 degrees"),
    ],
)
def test_a_wrap_holds_what_the_law_says_as_near_as_its_facets_are(
    kind: str, fine: int, within: float, told: str
) -> None:
    """exp(mu theta) = 2.566 of half a turn at rest; and `check` tells of facets that are coarse for it."""
    if kind == "sdf":
        pytest.importorskip("skimage")
    scene = capstan(180, MU, 0.9).replace(obstacles=[bar(kind, fine)])
    rest = static_shape(scene)
    (wrap,) = rest.wraps
    assert wrap.angle == pytest.approx(math.pi, abs=1e-3)
    assert wrap.most / wrap.before == pytest.approx(math.exp(MU * math.pi), rel=within)
    notes = facet_warnings(build(scene), rest)
    assert [told in note for note in notes] == ([True] if told else [])
    smooth = scene.replace(obstacles=[scene.obstacles[0].replace(friction=0.0)])
    assert not facet_warnings(build(smooth), rest)


def test_facets_are_told_of_where_a_rope_is_drawn_round_their_edges_and_has_no_rest() -> None:
    """What slides on has no rest: drawn 0.4 diameters off the edges it was told of nothing."""
    scene = capstan(180, MU, 0.9).replace(obstacles=[bar("mesh", 24)])
    rope = scene.ropes[0]
    model = build(scene)
    x = model.state.x
    off = 1.0 + 0.4 * rope.diameter / (0.05 + 0.5 * rope.diameter)
    turned = np.hypot(x[0], x[2]) < 0.05 + rope.diameter
    x[:, turned] = x[:, turned] * np.array([[off], [1.0], [off]])
    rest = dataclasses.replace(static_shape(scene), solved=False)
    assert facet_warnings(model, rest)


def over_a_ridge(count: int) -> Scene:
    """A rope of 1 m in so many segments over the one rounded edge of a roof, which turns it by 36 degrees.

    It comes and leaves at 2 degrees to the sides of the roof, which meet at 40.
    """
    bend, clear, rounded = math.radians(40.0), math.radians(2.0), 0.02
    radius = rounded + 0.005
    low = (2 * math.cos(bend), -2 * math.sin(bend))
    outline = [(-2.0, 0.0), (0.0, 0.0), low, (low[0], -4.0), (-2.0, -4.0)]
    corners = [(x, side, z) for side in (-1.0, 1.0) for x, z in outline]
    faces = [three for i in (1, 2, 3) for three in ((0, i, i + 1), (5, 5 + i + 1, 5 + i))]
    for i in range(5):
        j = (i + 1) % 5
        faces += [(i, 5 + i, 5 + j), (i, 5 + j, j)]
    faces = [three[::-1] for three in faces]  # seen from outside
    roof = Mesh(vertices=corners, faces=faces, rounding=rounded, friction=MU, name="roof")

    def place(s: float) -> tuple[float, float, float]:
        a = min(max(s / radius, clear), bend - clear)
        on, tail = np.array([math.sin(a), math.cos(a)]), s - radius * a
        x, z = radius * on + tail * np.array([math.cos(a), -math.sin(a)])
        return float(x), 0.0, float(z)

    points = np.array([place(-0.5 + i / count) for i in range(count + 1)])
    length = float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum())
    out = [points[0] - points[1], points[-1] - points[-2]]
    pulls = [
        {"node": n, "force": 10 * d / np.linalg.norm(d)} for n, d in zip((0, -1), out, strict=True)
    ]
    stuff = Material(EA=1e4, mass_per_length=0.1, axial_damping=5.0)
    rope = Rope(
        segments=count, length=length, diameter=0.01, made_of=stuff, forces=pulls,
        shape=Points(points=points.tolist()),
    )  # fmt: skip
    return Scene(gravity=(0, 0, 0), ropes=[rope], obstacles=[roof])


def test_one_edge_is_no_facet_and_more_nodes_do_help_there() -> None:
    """It was called bumps, friction 0.3 plus or minus 0.35 "with any number of nodes"."""
    coarse, fine = over_a_ridge(40), over_a_ridge(240)
    rest = static_shape(coarse)
    few, many = (max(one.wraps, key=lambda wrap: wrap.angle) for one in (rest, static_shape(fine)))
    assert facet_warnings(build(coarse), rest) == []
    assert few.coarse.is_told
    assert not many.coarse.is_told
    assert many.most / many.before == pytest.approx(math.exp(MU * math.radians(36.0)), rel=0.01)
