"""Figures of ropes on obstacles: outlines, contact forces along the rope, the tension round a bar."""

from __future__ import annotations

import base64
import math
from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from matplotlib.patches import PathPatch

import ropewalk as rw
from ropewalk import plots
from ropewalk.plots.canvas import backdrop
from ropewalk.plots.contact_forces import coils, pressing
from ropewalk.plots.dimensions import dimensions
from ropewalk.record.contacts import each_frame, lying
from ropewalk.record.export import export
from ropewalk.record.result import Result
from ropewalk.scene import Cylinder, Obstacle, Plane, Scene, Sphere, Velocity, loads
from ropewalk.scene.overrides import apply_overrides
from verification.test_meshes import block

TURNS = 1.5


def round_a_drum(friction: float = 0.3, mass: float = 1e-3) -> Scene:
    """A rope of little weight three half turns round a drum that drags it, a load at one end."""
    count = 36
    radius = 0.055 / math.cos(math.pi * TURNS / count)  # chords touch the drum
    angles = [2.0 * math.pi * TURNS * i / count for i in range(count + 1)]
    round_it = [[radius * math.cos(a), 0.0, radius * math.sin(a)] for a in angles]
    points = [[radius, 0.0, -0.2], *round_it, [-radius, 0.0, -0.2]]
    length = sum(math.dist(a, b) for a, b in pairwise(points))
    return loads(f"""
[run]
duration = 0.5
time_step = 0.005
method = "implicit-euler"
[[rope]]
segments = 60
length = {length}
diameter = 0.01
loads = [{{ node = -1, mass = 1.0 }}]
made_of = {{ kind = "material", EA = 1e4, mass_per_length = {mass}, axial_damping = 5.0 }}
shape = {{ kind = "polyline", points = {points} }}
[[anchor]]
node = 0
[[obstacle]]
name = "drum"
kind = "cylinder"
from = [0, -0.1, 0]
to = [0, 0.1, 0]
radius = 0.05
friction = {friction}
spin = {{ rate = 2.0 }}
[[obstacle]]
name = "ring"
kind = "torus"
center = [0.2, 0, 0]
axis = [0, 1, 0]
radius = 0.08
bar_radius = 0.02
""")


@pytest.fixture(scope="module")
def slipping() -> Result:
    """A run of it, at whose end the rope slips."""
    return rw.simulate(round_a_drum())


def test_a_slipping_coil_follows_eulers_formula(slipping: Result) -> None:
    """Ratio and angle from the record alone; with another coefficient the formula is far off."""
    (coil,) = coils(slipping, slipping.frames - 1)
    assert (coil.rope, coil.obstacle) == ("rope", "drum")
    assert coil.angle == pytest.approx(2.0 * math.pi * TURNS, rel=0.01)
    assert coil.held == pytest.approx(coil.tension, rel=0.05)
    wrong = 0.5 * coil.friction
    assert np.exp(wrong * coil.angle) * coil.tension.min() < 0.5 * coil.tension.max()


def test_the_figure_tells_the_slip_that_tables_and_the_view_tell() -> None:
    """It told exp(mu angle), 16.86 where the view said 16.4: a wrap that goes along its drum slips before."""
    scene = rw.preset("capstan")
    result = rw.simulate(scene.replace(run=scene.run.replace(duration=0.05)))
    last = result.frames - 1
    (coil,), ((_, contacts),) = coils(result, last), each_frame(result, [last])
    (wrap,) = lying(result.scene, result.layout, contacts, result.tension[last])
    assert coil.at_slip == pytest.approx(wrap.at_slip, rel=1e-12)
    assert coil.at_slip < 0.999 * math.exp(coil.friction * coil.angle)
    figure = plots.contact(result)
    notes = " ".join(" ".join(text.get_text().split()) for text in figure.texts)
    assert f"slips at {wrap.at_slip:.4g} as it lies" in notes


def test_what_friction_would_hold_does_not_flatten_the_tension() -> None:
    """A wrap of many turns: the dashed line rises to 20 times the tension, the axes to twice."""
    scene = rw.preset("capstan")
    drum = scene.obstacles[0].replace(friction=0.9)
    run = scene.run.replace(duration=0.05)
    result = rw.simulate(scene.replace(run=run, obstacles=(drum, *scene.obstacles[1:])))
    largest = result.tension[result.frames - 1].max()
    (coil,) = coils(result, result.frames - 1)
    assert coil.held.max() > 10.0 * largest
    low, high = plots.contact(result).axes[1].get_ylim()
    assert high == pytest.approx(2.0 * largest)
    assert low == 0.0  # the margin of the dashed line made it negative, where no tension was


def test_nothing_is_told_to_slip_where_ropes_press_on_a_wrap() -> None:
    """Of a prusik "slips at 29.68" was told, and the line went to 105 times its slack end's tension."""
    result = rw.simulate(apply_overrides(rw.preset("clove-hitch"), ["run.duration=0.05"]))
    frame = result.frames - 1
    table = result.to_pandas("wraps")
    now = table[table["time [s]"] == result.time[frame]]["ratio at slip [1]"]
    (free, pressed) = coils(result, frame)
    assert [free.pressed, pressed.pressed] == [(), ("ropes",)]
    assert now.isna().tolist() == [False, True]
    assert pressed.held is None
    figure = plots.contact(result)
    (dashed,) = (line for line in figure.axes[1].lines if line.get_label() == "_held")
    assert dashed.get_ydata() == pytest.approx(free.held)
    notes = " ".join(" ".join(text.get_text().split()) for text in figure.texts)
    assert notes.count("slips at") == 1
    assert notes.count("ropes press on it, too: where it slips is not known") == 1


def test_what_friction_would_hold_ends_at_the_ratio_that_is_told() -> None:
    """With how far the rope turns alone it ended above: a wrap that goes along its drum slips before."""
    scene = rw.preset("capstan")
    result = rw.simulate(scene.replace(run=scene.run.replace(duration=0.05)))
    (coil,) = coils(result, result.frames - 1)
    assert coil.held is not None
    assert coil.held.max() / coil.slack == pytest.approx(coil.at_slip, rel=1e-12)
    pushed = replace(coil, tension=coil.tension - 2.0 * coil.slack)
    assert pushed.slack < 0.0
    assert pushed.held is None  # a line went from -0.83 N to -8.5 N


def test_the_figure_shows_a_time_at_which_something_touches() -> None:
    """Of a rope that had left its table it had empty axes, without a word."""
    up = {"kind": "velocity", "velocity": (0.0, 0.0, 0.1)}
    stuff = rw.Material(EA=1e3, mass_per_length=0.1, axial_damping=2.0)
    shape = {"kind": "straight", "start": (0, 0, 0.005), "end": (0.3, 0, 0.005)}
    rope = rw.Rope(segments=6, length=0.3, made_of=stuff, diameter=0.01, shape=shape)
    scene = rw.Scene(
        ropes=[rope],
        anchors=[rw.Anchor(node=0, motion=up), rw.Anchor(node=-1, motion=up)],
        obstacles=[Plane()],
        run=rw.RunSettings(duration=0.3, time_step=1.0 / 240.0, method="implicit-euler"),
    )
    result = rw.simulate(scene)
    touching = np.flatnonzero(result.contact_force.any(axis=(1, 2)))
    last, end = result.time[touching[-1]], result.time[-1]
    assert 0.0 < last < end

    def told(time: float | None = None) -> tuple[str, str, float]:
        figure = plots.contact(result, time)
        title, *notes = (" ".join(text.get_text().split()) for text in figure.texts)
        highest = max(line.get_ydata().max() for line in figure.axes[0].lines)
        return figure.get_suptitle(), " ".join((title, *notes)), float(highest)

    title, notes, highest = told()
    assert f"contact at t = {last:.4g} s" in title
    assert f"After t = {last:.4g} s nothing touches, up to the last frame at {end:.4g} s." in notes
    assert highest > 0.0
    title, notes, highest = told(float(end))
    assert f"contact at t = {end:.4g} s" in title
    assert f"Nothing touches at this time; at {last:.4g} s something does." in notes
    assert highest == 0.0
    assert "ouches" not in told(float(last))[1]


def test_ropes_that_carry_the_same_are_both_seen() -> None:
    """In a reef knot the second hid the first."""
    shape = {"kind": "straight", "start": (0, 0, 0), "end": (0.3, 0, 0)}
    stuff = rw.Material(EA=1e3, mass_per_length=0.1, axial_damping=2.0)
    ropes = [
        rw.Rope(name=name, segments=6, length=0.3, made_of=stuff, diameter=0.01, shape=shape)
        for name in ("one", "two")
    ]
    scene = rw.Scene(
        ropes=ropes, obstacles=[Plane(point=(0, 0, -0.01))], run=rw.RunSettings(duration=0.1)
    )
    for axes in plots.contact(rw.simulate(scene)).axes:
        one, two = (line for line in axes.lines if len(line.get_xdata()) > 2)
        assert one.get_ydata() == pytest.approx(two.get_ydata())
        assert one.get_linewidth() > 1.5 * two.get_linewidth()
        assert one.get_markersize() > 1.3 * two.get_markersize()


def test_the_figure_draws_what_was_recorded(slipping: Result) -> None:
    figure = plots.contact(slipping)
    above, below = figure.axes
    force = np.linalg.norm(slipping.contact_force[-1], axis=1)
    assert above.lines[0].get_ydata() == pytest.approx(force)
    assert below.lines[0].get_ydata() == pytest.approx(slipping.tension[-1])
    assert "[N]" in above.get_ylabel()
    assert "[m]" in below.get_xlabel()
    assert any(line.get_linestyle() == "--" for line in below.lines)


def test_the_figure_shows_what_presses_a_rope_from_both_sides() -> None:
    """Pressed between a floor and a rope with 10 N its nodes were drawn with some 0.2 N, the sum of both."""
    stuff = 'made_of = { kind = "material", EA = 1e4, mass_per_length = 0.1, axial_damping = 2.0 }'
    result = rw.simulate(
        loads(f"""
[run]
method = "implicit-euler"
time_step = 0.0041666667
duration = 0.3
[contact]
friction = 0.3
[[obstacle]]
name = "floor"
kind = "plane"
normal = [0, 0, 1]
friction = 0.3
[[rope]]
name = "under"
segments = 4
length = 0.2
diameter = 0.01
{stuff}
shape = {{ kind = "straight", start = [-0.1, 0, 0.005], end = [0.1, 0, 0.005] }}
[[rope]]
name = "over"
segments = 1
length = 0.2
diameter = 0.01
{stuff}
shape = {{ kind = "straight", start = [0.01, -0.1, 0.015], end = [0.01, 0.1, 0.015] }}
force = [{{ node = 0, force = [0, 0, -5] }}, {{ node = -1, force = [0, 0, -5] }}]
""")
    )
    last = result.frames - 1
    under = result.layout.span("under")
    own = slice(under.first, under.last + 1)
    net = np.linalg.norm(result.contact_force[last, own], axis=1)
    weight = 0.02 * 9.81  # of each rope [N]
    above = 10.0 + weight
    assert pressing(result, last)[own].sum() == pytest.approx(2.0 * above + weight, rel=0.02)
    assert pressing(result, last)[under.last + 1 :].sum() == pytest.approx(above, rel=0.02)
    figure = plots.contact(result)
    lines = figure.axes[0].lines
    assert lines[0].get_ydata() == pytest.approx(pressing(result, last)[own])
    assert lines[1].get_linestyle() == ":"
    assert lines[1].get_ydata() == pytest.approx(net)
    assert net.sum() < 0.2 * above
    assert "pressed by both" in " ".join(" ".join(t.get_text().split()) for t in figure.texts)


def test_vtk_has_the_forces_on_nodes(slipping: Result, tmp_path: Path) -> None:
    export(slipping, "vtk", tmp_path, quantities=["positions", "contact_force"])
    text = sorted((tmp_path).rglob("*.vtp"))[-1].read_text()
    packed = text.split('Name="contact_force"')[1].split(">", 1)[1].split("<", 1)[0]
    told = np.frombuffer(base64.b64decode(packed)[8:], "<f8").reshape(-1, 3)
    assert np.array_equal(told, slipping.contact_force[-1])
    packed = text.split('Name="contact_mode"')[1].split(">", 1)[1].split("<", 1)[0]
    modes = np.frombuffer(base64.b64decode(packed)[8:], "<i8")
    assert np.array_equal(modes, slipping.contact_modes[-1])
    assert (modes == 2).any()


def test_without_obstacles_there_is_no_such_figure() -> None:
    run = rw.simulate(round_a_drum().replace(obstacles=[], run={"duration": 0.01}))
    with pytest.raises(ValueError, match="it needs obstacles"):
        plots.contact(run)


def _area(corners: np.ndarray) -> float:
    x, y = corners.T
    return float((x[:-1] * y[1:] - x[1:] * y[:-1]).sum())


@pytest.mark.parametrize("draw", [plots.shape, plots.film, plots.forces, dimensions])
def test_obstacles_are_drawn_where_they_are(slipping: Result, draw: object) -> None:
    figure = draw(slipping)  # type: ignore[operator]
    patches = [one for one in figure.axes[0].patches if isinstance(one, PathPatch)]
    drum, ring = (one.get_path() for one in patches)
    low, high = drum.vertices.min(axis=0), drum.vertices.max(axis=0)
    assert [*low, *high] == pytest.approx([-0.05, -0.05, 0.05, 0.05], abs=1e-4)
    outer, hole = (part for part in ring.to_polygons())
    assert [outer[:, 0].min(), hole[:, 0].min()] == pytest.approx([0.1, 0.14], abs=1e-4)
    assert _area(outer) > 0.0 > _area(hole)  # the other way round: it is left empty
    limits = figure.axes[0].get_xlim()
    assert limits[0] < -0.05
    assert limits[1] > 0.3  # the picture holds all of the ring


@pytest.mark.parametrize("kind", ["mesh", "cylinder"])
def test_the_picture_holds_what_looks_like_a_rectangle(kind: str) -> None:
    """Four corners were taken for a plane's, and lay outside the picture."""
    body = block((0.06,) * 3, 0.01, position=(0.2, 0, 0))
    if kind == "cylinder":
        body = Cylinder(start=(0.2, 0, -0.05), end=(0.2, 0, 0.05), radius=0.05)
    scene = round_a_drum()
    run = rw.simulate(scene.replace(obstacles=[body], run=scene.run.replace(duration=0.01)))
    seen = backdrop(run, "xz")
    assert len(seen.outlines[0].outer) == 4
    assert seen.outlines[0].outer[:, 0].max() == pytest.approx(0.25)
    assert seen.box.right > 0.25


@pytest.mark.parametrize(
    ("body", "upright"),
    [
        (None, True),
        (Plane(point=(0, 0, -1.5)), True),  # level: it looks alike all along the axis of time
        (Plane(point=(-1, 0, 0), normal=(1, 0, 0)), False),
        (Sphere(center=(0.3, 0, -0.5), radius=0.1), False),
        (Sphere(center=(0.3, 0, -0.5), radius=0.1, motion=Velocity(velocity=(1, 0, 0))), False),
    ],
)
def test_shapes_stand_side_by_side_only_where_no_obstacle_is_beside_them(
    body: Obstacle | None, upright: bool
) -> None:
    """Obstacles were drawn in metres on an axis that is time."""
    springs = rw.Springs(spring_constant=20.0, node_mass=0.1, segment_length=0.25)
    rope = rw.Rope(segments=4, made_of=springs, diameter=0.01, shape={"kind": "hanging"})
    settings = rw.RunSettings(duration=0.2, time_step=2e-3, method="semi-implicit-euler")
    bodies = [] if body is None else [body]
    scene = rw.Scene(ropes=[rope], anchors=[rw.Anchor(node=0)], obstacles=bodies, run=settings)
    axes = plots.shape(rw.simulate(scene), plane="xz").axes[0]
    assert axes.get_xlabel() == ("time [s]" if upright else "x [m]")
    assert len(axes.patches) >= len(bodies)


def test_a_plane_is_drawn_where_it_is_seen_edge_on() -> None:
    scene = round_a_drum()
    floor = {"kind": "plane", "point": (0.0, 0.0, -0.4)}
    run = rw.simulate(scene.replace(obstacles=[floor], run=scene.run.replace(duration=0.01)))
    (outline,) = backdrop(run, "xz").outlines
    assert outline.outer[:, 1].max() == pytest.approx(-0.4)
    assert backdrop(run, "xy").outlines == ()
