"""Solids of any form: a box of triangles does what a box does, and what is no solid is refused in words."""

from __future__ import annotations

import math
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.laws.obstacle_rows import corners_of, place_of, turned_by
from ropewalk.laws.obstacle_shapes import BOX, MESH, probe
from ropewalk.laws.triangle_rows import mesh_row
from ropewalk.lowering import build
from ropewalk.scene import (
    Box,
    Material,
    Mesh,
    Obstacle,
    Rope,
    RunSettings,
    Scene,
    SceneError,
    Sdf,
    Sphere,
    Straight,
    Velocity,
    dumps,
    load,
    loads,
)

HALF, EDGE = (0.2, 0.3, 0.1), 0.03
#: The corners of a cube, and its sides as triangles.
CORNERS = [(x, y, z) for x in (-1.0, 1.0) for y in (-1.0, 1.0) for z in (-1.0, 1.0)]
SIDES = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
FACES = [face for a, b, c, d in SIDES for face in ((a, b, c), (a, c, d))]


def block(half: Any = HALF, rounding: float = EDGE, **more: Any) -> Mesh:
    """A box of twelve triangles, rounded."""
    vertices = [[s * (h - rounding) for s, h in zip(c, half, strict=True)] for c in CORNERS]
    return Mesh(vertices=vertices, faces=FACES, rounding=rounding, **more)


def dropped(body: Obstacle, **more: Any) -> Scene:
    """A rope that falls across a body from 5 cm above."""
    shape = Straight(start=(-0.5, 0.01, 0.16), end=(0.5, 0.02, 0.16))
    made_of = Material(EA=1e3, mass_per_length=0.1)
    rope = Rope(segments=20, length=1.0, made_of=made_of, shape=shape, diameter=0.01)
    settings = {"duration": 0.5, "frame_rate": 60.0, "time_step": 1.0 / 240.0, "method": "esdirk3"}
    return Scene(ropes=[rope], obstacles=[body], run=RunSettings(**(settings | more)))


@pytest.mark.parametrize("rotation", [(0.0, 0.0, 0.0), (0.5, -0.9, 0.3)])
def test_a_box_of_triangles_is_a_box(rotation: tuple[float, ...]) -> None:
    """Distance, normal and curvature outside of it are those of a box, about faces, edges and corners."""
    box = Box(center=(0, 0, 0), half_sizes=HALF, edge_radius=EDGE, rotation=rotation)
    center, axis, size = (np.array(part, float) for part in place_of(box))
    row = place_of(block(rotation=rotation))[2]
    rng = np.random.default_rng(3)
    seen = set()
    for own in rng.uniform(-0.5, 0.5, (400, 3)):
        (point,) = turned_by(rotation, own[None])
        if np.all(np.abs(own) < np.array(HALF) - EDGE):
            continue
        wanted = probe(BOX, center, axis, size, *point)
        found = probe(MESH, center, axis, row, *point)
        np.testing.assert_allclose(found[:4], wanted[:4], atol=1e-12)
        np.testing.assert_allclose(_turning(found), _turning(wanted), atol=1e-9)
        seen.add(int((np.abs(own) > np.array(HALF) - EDGE).sum()))
    assert seen == {1, 2, 3}


def test_a_turned_box_is_the_box_of_a_turned_world() -> None:
    """Rope, gravity and box turned together: the rope comes to the turned places, sticking and slipping."""
    turn = (0.5, -0.9, 0.3)
    box = Box(center=(0, 0, 0), half_sizes=HALF, edge_radius=EDGE, friction=0.2)
    scene = dropped(box)
    straight = rw.simulate(scene).positions
    (start,), (end,), (down,) = (
        turned_by(turn, np.array([one]))
        for one in ((-0.5, 0.01, 0.16), (0.5, 0.02, 0.16), scene.gravity)
    )
    shape = Straight(start=tuple(map(float, start)), end=tuple(map(float, end)))
    rope = scene.ropes[0].replace(shape=shape)
    there = scene.replace(
        ropes=[rope], obstacles=[box.replace(rotation=turn)], gravity=tuple(map(float, down))
    )
    assert straight[-1, :, 2].min() < -0.05  # its ends hang beside the box, its middle lies on it
    found = rw.simulate(there).positions
    for one, other in zip(found, straight, strict=True):
        np.testing.assert_allclose(one, turned_by(turn, other), atol=1e-7)
    # The twin: turned a little less it is elsewhere.
    less = there.replace(obstacles=[box.replace(rotation=tuple(0.98 * one for one in turn))])
    assert not np.allclose(rw.simulate(less).positions[-1], found[-1], atol=1e-3)


def _turning(found: Any) -> Any:
    """How the normal turns with the place, H (3, 3)."""
    n, a = np.array(found[1:4]), np.array(found[4:7])
    return found[7] * (np.eye(3) - np.outer(n, n) - np.outer(a, a)) + found[8] * np.outer(a, a)


def test_it_tells_inside_from_outside_of_what_is_not_convex() -> None:
    """An L of three cubes: its distance is the least of two boxes' outside, its sign right in the notch."""
    trimesh = pytest.importorskip("trimesh")
    outline = [(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)]
    body = trimesh.Trimesh(*_prism(outline, 1.0))
    assert body.is_watertight
    row = mesh_row(np.array(body.vertices), np.array(body.faces), 0.0)
    rng = np.random.default_rng(5)
    for x, y, z in rng.uniform(-1.0, 3.0, (400, 3)):
        boxes = [((1.0, 0.5, 0.5), (1.0, 0.5, 0.5)), ((0.5, 1.0, 0.5), (0.5, 1.0, 0.5))]
        each = [_away(np.array([x, y, z]) - middle, half) for middle, half in boxes]
        found = probe(MESH, np.zeros(3), np.array([0.0, 0.0, 1.0]), row, x, y, z)[0]
        assert (found < 0.0) == (min(each) < 0.0)
        if found > 0.0:
            assert found == pytest.approx(min(each), abs=1e-12)


def _prism(outline: list[tuple[int, int]], height: float) -> tuple[Any, Any]:
    """The L of six corners, upright."""
    low = [(x, y, 0.0) for x, y in outline]
    n = len(low)
    flat = [(0, 1, 2), (0, 2, 3), (0, 3, 4), (0, 4, 5)]
    sides = [(i, (i + 1) % n, n + (i + 1) % n) for i in range(n)]
    sides += [(i, n + (i + 1) % n, n + i) for i in range(n)]
    faces = [(c, b, a) for a, b, c in flat] + [(a + n, b + n, c + n) for a, b, c in flat] + sides
    return low + [(x, y, height) for x, y, _ in low], faces


def _away(p: Any, half: Any) -> float:
    q = np.abs(p) - np.array(half)
    return float(np.linalg.norm(np.maximum(q, 0.0)) + min(q.max(), 0.0))


@pytest.mark.parametrize("method", ["esdirk3", "adaptive"])
def test_a_rope_falls_over_it_as_over_a_box(method: str) -> None:
    more = {} if method == "esdirk3" else {"time_step": "auto"}
    box = Box(center=(0, 0, 0), half_sizes=HALF, edge_radius=EDGE)
    expected = rw.simulate(dropped(box, method=method, **more))
    found = rw.simulate(dropped(block(), method=method, **more))
    within = (
        1e-9 if method == "esdirk3" else 5e-5
    )  # its tolerance: rounding decides where it cuts steps
    np.testing.assert_allclose(found.positions, expected.positions, atol=within)
    assert np.abs(expected.positions[-1, :, 2]).min() < 0.12  # it has come down on it


def test_a_mesh_that_moves_is_a_box_that_moves() -> None:
    motion = Velocity(velocity=(0.3, 0.0, 0.4))
    box = Box(center=(0, 0, 0), half_sizes=HALF, edge_radius=EDGE, motion=motion)
    expected = rw.simulate(dropped(box))
    found = rw.simulate(dropped(block(motion=motion)))
    np.testing.assert_allclose(found.positions, expected.positions, atol=1e-9)


@pytest.mark.parametrize(("degrees", "holds"), [(16.0, True), (18.0, False)])
def test_turned_to_an_incline_it_holds_below_the_angle_of_friction(
    degrees: float, holds: bool
) -> None:
    """atan 0.3 is 16.7 degrees."""
    slope = math.radians(degrees)
    along, up = (math.cos(slope), -math.sin(slope)), (math.sin(slope), math.cos(slope))
    body = block((1.0, 1.0, 0.1), 0.01, rotation=(0.0, slope, 0.0), friction=0.3)
    ends = [
        tuple(0.15 * s * a + 0.105 * u for a, u in zip(along, up, strict=True)) for s in (-1, 1)
    ]
    shape = Straight(start=(ends[0][0], 0.0, ends[0][1]), end=(ends[1][0], 0.0, ends[1][1]))
    scene = dropped(body)
    rope = scene.ropes[0].replace(segments=6, length=0.3, shape=shape)
    places = rw.simulate(scene.replace(ropes=[rope])).positions
    moved = np.abs(places[-1] - places[12]).max()
    assert moved < 1e-8 if holds else moved > 1e-3


@pytest.mark.parametrize("suffix", ["stl", "obj", "ply"])
def test_files_are_read_and_no_longer_needed(suffix: str, tmp_path: Path) -> None:
    trimesh = pytest.importorskip("trimesh")
    body = trimesh.Trimesh(1000.0 * corners_of(block()), FACES)
    body.export(tmp_path / f"block.{suffix}")
    whole = dumps(dropped(block()))
    own = (
        f'[[obstacle]]\nkind = "mesh"\nfile = "block.{suffix}"\nscale = "1 mm"\nrounding = {EDGE}\n'
    )
    (tmp_path / "scene.toml").write_text(whole[: whole.index("[[obstacle]]")] + own)
    scene = load(tmp_path / "scene.toml")
    (tmp_path / f"block.{suffix}").unlink()
    assert loads(dumps(scene)) == scene
    table = build(scene).system.node.obstacle
    places = corners_of(scene.obstacles[0])
    np.testing.assert_allclose(
        np.unique(np.round(places, 6), axis=0), np.unique(corners_of(block()), axis=0)
    )
    assert (table.kind == MESH).all()


def test_a_copy_of_a_vertex_for_every_triangle_is_one_vertex() -> None:
    """As libraries give them, and files of them pass; what is open is told by its own edges alone."""
    loose = [CORNERS[corner] for face in FACES for corner in face]
    faces = [(3 * k, 3 * k + 1, 3 * k + 2) for k in range(len(FACES))]
    body = Mesh(vertices=loose, faces=faces)
    assert len(body.vertices) == len(CORNERS)
    assert loads(dumps(dropped(body))) == dropped(body)
    rows = [place_of(one)[2] for one in (body, Mesh(vertices=CORNERS, faces=FACES))]
    for place in np.random.default_rng(2).uniform(-2.0, 2.0, (50, 3)):
        one, other = (probe(MESH, np.zeros(3), np.array([0.0, 0, 1]), row, *place) for row in rows)
        np.testing.assert_allclose(one[:4], other[:4], atol=1e-12)
    with pytest.raises(SceneError, match="must be closed: 3 edges"):
        Mesh(vertices=loose, faces=faces[1:])
    # Two cubes along one edge are closed as they are, and stay so.
    twice = [*CORNERS, *[(x + 2.0, y + 2.0, z) for x, y, z in CORNERS]]
    both = [*FACES, *[tuple(8 + corner for corner in face) for face in FACES]]
    assert len(Mesh(vertices=twice, faces=both).vertices) == 16


def test_solids_that_share_an_edge_are_told_so() -> None:
    """Of two cubes along one edge each is closed, and nobody disagrees; one triangle turned round does."""
    twice = [*CORNERS, *[(x + 2.0, y + 2.0, z) for x, y, z in CORNERS]]
    both = [*FACES, *[tuple(8 + corner for corner in face) for face in FACES]]
    corners = sorted(set(twice))
    joined = [tuple(corners.index(twice[corner]) for corner in face) for face in both]
    with pytest.raises(SceneError, match="two solids, or two parts of one, share an edge") as told:
        Mesh(vertices=corners, faces=joined)
    assert "disagree" not in str(told.value)
    with pytest.raises(SceneError, match="disagree which side is outside"):
        Mesh(vertices=CORNERS, faces=[FACES[0][::-1], *FACES[1:]])


def ball_of_distances(spacing: float) -> Any:
    """Distances to a ball of radius 0.3 about the origin, (n, n, n), and the grid's first point."""
    first = -0.4
    x = np.arange(first, 0.4 + spacing, spacing)
    return np.sqrt(sum(np.meshgrid(x**2, x**2, x**2, indexing="ij"))) - 0.3, (first,) * 3


def test_distances_on_a_grid_make_a_surface_of_second_order() -> None:
    """The surface of a ball is off by less than spacing^2 / (2 R), a quarter of it with half the spacing."""
    pytest.importorskip("skimage")
    errors = []
    for spacing in (0.08, 0.04, 0.02):
        values, origin = ball_of_distances(spacing)
        body = Sdf(values=values, spacing=spacing, origin=origin)
        row = place_of(body)[2]
        middle, axis = np.zeros(3), np.array([0.0, 0.0, 1.0])
        around = np.random.default_rng(1).normal(size=(200, 3))
        around *= 0.3 / np.linalg.norm(around, axis=1)[:, None]
        off = [abs(probe(MESH, middle, axis, row, *place)[0]) for place in around]
        assert max(off) < spacing**2 / 0.6
        errors.append(max(off))
    assert errors[0] / errors[2] > 8.0
    assert Sdf(vertices=body.vertices, faces=body.faces) == body


def test_a_rope_hangs_over_distances_as_over_a_ball(tmp_path: Path) -> None:
    pytest.importorskip("skimage")
    values, origin = ball_of_distances(0.02)
    np.savez(tmp_path / "ball.npz", values=values, spacing=0.02, origin=origin)
    body = Sdf.model_validate(
        {"file": "ball.npz", "friction": 1.0, "position": (0, 0, -0.2)},
        context={"folder": tmp_path},
    )
    found = rw.simulate(dropped(body)).positions[-1]
    ball = Sphere(center=(0, 0, -0.2), radius=0.3, friction=1.0)
    expected = rw.simulate(dropped(ball)).positions[-1]
    assert np.abs(found - expected).max() < 1e-2  # its ends still swing
    assert np.abs(expected[:, 2] - 0.16).max() > 0.1  # it has fallen


def test_slivers_turn_no_side_over() -> None:
    """A third vertex on an edge, as editors put there: outside read as 7 mm inside, in 93 of 600 places."""
    vertices = np.array([*CORNERS, (-1.0, -1.0, 0.3)])
    (cut,) = (face for face in FACES if (0, 1) in pairwise((*face, face[0])))
    apex = next(corner for corner in cut if corner not in (0, 1))
    rest = [face for face in FACES if face != cut]
    faces = np.array([*rest, (0, 8, apex), (8, 1, apex), (0, 1, 8)])
    rng = np.random.default_rng(7)
    middle, axis = np.zeros(3), np.array([0.0, 0.0, 1.0])
    for _ in range(40):
        turn = turned_by(rng.normal(size=3), np.eye(3))
        body = Mesh(vertices=vertices @ turn, faces=faces)
        row = place_of(body)[2]
        for along in rng.uniform(-0.9, 0.9, 10):
            out = np.array([-1.005, -1.005, along]) @ turn
            inside = np.array([-0.995, -0.995, along]) @ turn
            assert probe(MESH, middle, axis, row, *out)[0] == pytest.approx(math.hypot(5e-3, 5e-3))
            assert probe(MESH, middle, axis, row, *inside)[0] == pytest.approx(-5e-3)


def test_cavities_pass_and_parts_inside_out_do_not() -> None:
    """A part that is inside out counts as a cavity only where it lies in another."""
    inner = [(a, b, c) for c, b, a in (tuple(8 + corner for corner in face) for face in FACES)]
    half = [(0.5 * x, 0.5 * y, 0.5 * z) for x, y, z in CORNERS]
    hollow = Mesh(vertices=[*CORNERS, *half], faces=[*FACES, *inner])
    row = place_of(hollow)[2]
    middle, axis = np.zeros(3), np.array([0.0, 0.0, 1.0])
    assert probe(MESH, middle, axis, row, 0.1, 0.0, 0.0)[0] == pytest.approx(0.4)
    assert probe(MESH, middle, axis, row, 0.7, 0.0, 0.0)[0] == pytest.approx(-0.2)
    aside = [(x + 3.0, y, z) for x, y, z in half]
    with pytest.raises(SceneError, match=r"faces\[12\].*is inside out"):
        Mesh(vertices=[*CORNERS, *aside], faces=[*FACES, *inner])
    # Within the box round a tetrahedron, and outside of it: was taken for a cavity.
    tetrahedron = [(-1.0, -1.0, -1.0), (3.0, -1.0, -1.0), (-1.0, 3.0, -1.0), (-1.0, -1.0, 3.0)]
    sides = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]
    inner = [tuple(corner - 4 for corner in face) for face in inner]
    for middle_of, passes in ((0.0 - 0.4, True), (2.0, False)):
        small = [
            (middle_of + 0.2 * x, middle_of + 0.2 * y, middle_of + 0.2 * z) for x, y, z in CORNERS
        ]
        if passes:
            Mesh(vertices=[*tetrahedron, *small], faces=[*sides, *inner])
        else:
            with pytest.raises(SceneError, match=r"faces\[4\].*is inside out"):
                Mesh(vertices=[*tetrahedron, *small], faces=[*sides, *inner])


FAULTS: dict[str, tuple[Any, str]] = {
    "open": (FACES[1:], "must be closed: 3 edges have a triangle on one side only"),
    "inside out": (
        [face[::-1] for face in FACES],
        "is inside out: faces must be counter-clockwise",
    ),
    "turned": ([FACES[0][::-1], *FACES[1:]], "its neighbours disagree which side is outside"),
    "flat": ([(0, 0, 1), *FACES], "must have three sides each"),
    "thin": ([(0, 1, 2), (0, 2, 1)], "encloses nothing: its sides lie on each other"),
    "square": (
        [(0, 1, 2, 3), *FACES],
        "must have three vertices, and has 4; cut what has more corners into triangles",
    ),
    "beyond": ([(0, 1, 8), *FACES], "must be numbers of vertices, 0 to 7"),
}


@pytest.mark.parametrize("name", FAULTS)
def test_what_is_no_solid_is_refused_in_words(name: str) -> None:
    faces, rule = FAULTS[name]
    with pytest.raises(SceneError, match=rule):
        Mesh(vertices=CORNERS, faces=faces)


def test_faults_of_distances_are_told() -> None:
    values, origin = ball_of_distances(0.04)
    cases = {
        "must be positive all round": {"values": values[:12], "spacing": 0.04},
        "are negative all round.*; turn their signs": {"values": -values, "spacing": 0.04},
        "with a slope of 1 next to the surface, not 99": {"values": 1e3 * values, "spacing": 0.04},
        "complex numbers are no distances": {"values": values + 0j, "spacing": 0.04},
        "there is none": {"values": np.abs(values) + 0.01, "spacing": 0.04},
        "with a slope of 1 next to the surface, not 0.0399": {"values": values, "spacing": 1.0},
        "three points or more each way": {"values": values[0], "spacing": 0.04},
        "must be finite": {"values": np.where(values > 0.2, np.nan, values), "spacing": 0.04},
        "give values and spacing": {"values": values},
        "spacing: .* the same spacing each way": {"values": values, "spacing": (0.04, 0.04, 0.04)},
        "spacing: .* must be finite": {"values": values, "spacing": np.nan},
        "spacing: must be numbers": {"values": values, "spacing": "wide"},
        "values: must be numbers": {"values": "many", "spacing": 0.04},
    }
    for rule, given in cases.items():
        with pytest.raises(SceneError, match=rule):
            Sdf(origin=origin, **given)


def test_faults_of_files_are_told(tmp_path: Path) -> None:
    (tmp_path / "bad.stl").write_text("solid")
    (tmp_path / "bad.npz").write_text("no zip")
    (tmp_path / "bad.obj").write_text("v 0 0 0\nf 1 2 3\n")
    cases = {
        'bad.obj" - cannot be read as OBJ: a triangle names a vertex that .* export it': (
            Mesh,
            "bad.obj",
        ),
        "no such file": (Mesh, "absent.stl"),
        "must end in .stl, .obj, .ply": (Mesh, "rock.step"),
        "holds no triangles|cannot be read as STL": (Mesh, "bad.stl"),
        "cannot be read as .npz": (Sdf, "bad.npz"),
        "is a folder": (Sdf, "."),
    }
    for rule, (model, file) in cases.items():
        with pytest.raises(SceneError, match=rule):
            model.model_validate({"file": file}, context={"folder": tmp_path})
    for model in (Mesh, Sdf):
        with pytest.raises(SceneError, match="file: 3 - must be text"):
            model(file=3)


def test_sharp_edges_need_a_rope_with_a_diameter() -> None:
    """Forces would jump at them else; with a rounding they do not."""
    scene = dropped(block(rounding=0.0))
    bare = scene.ropes[0].model_copy(update={"diameter": None})
    rope = Rope(
        **{name: getattr(bare, name) for name in ("segments", "length", "made_of", "shape")}
    )
    with pytest.raises(SceneError, match="its edges are sharp, and a rope has no diameter"):
        build(scene.replace(ropes=[rope]))
    build(scene)
    build(scene.replace(ropes=[rope], obstacles=[block()]))
