"""Ropes in films: as thick as they are, nearer ones over farther ones; lines where they are thin."""

from __future__ import annotations

from functools import partial

import numpy as np
import pytest
from matplotlib.collections import PolyCollection
from matplotlib.colors import to_rgb

from ropewalk.plots import film, shape
from ropewalk.plots.canvas import backdrop, box_around
from ropewalk.plots.movies import _Moment, _Painter
from ropewalk.plots.outlines import FACE
from ropewalk.plots.strands import LINE, ribbon
from ropewalk.record.simulate import simulate_in_memory
from ropewalk.scene import loads
from ropewalk.scene.presets import preset

SIZE = (600, 500)
SHORT = {"run.duration": 1 / 60}


HEAD = 'gravity = [0, 0, 0]\n[run]\nduration = 0.01\ntime_step = 1e-3\nmethod = "semi-implicit-euler"\n'
ROPE = """
[[rope]]
name = "{name}"
segments = {segments}
length = 1.0
diameter = {diameter}
made_of = {{ kind = "material", EA = 100.0, mass_per_length = 0.1 }}
shape = {{ kind = "straight", start = {start}, direction = {way} }}
"""


def crossing(diameter: float, bodies: str = ""):
    """Two straight ropes of 1 m that cross, seen along y: the upright one is nearer."""
    rope = partial(ROPE.format, diameter=diameter, segments=10)
    level = rope(name="level", start=[-0.5, 0.1, 0], way=[1, 0, 0])
    upright = rope(name="upright", start=[0.05, -0.1, -0.5], way=[0, 0, 1])
    return simulate_in_memory(loads(HEAD + level + upright + bodies))


def painted(diameter: float, bodies: str = ""):
    """The picture, (h, w, 3), the colours of both ropes, and pixels per metre."""
    result = crossing(diameter, bodies)
    seen = backdrop(result, "xz")
    painter = _Painter(result, seen, SIZE, 1.0, 3)
    tension = np.zeros(result.layout.segments)
    tension[11:] = 1.0
    painter._scale.vmin, painter._scale.vmax = 0.0, 1.0
    start = result.read("positions", 0, 1)[0]
    picture = np.asarray(painter.paint(_Moment(0.0, start, tension, False))).astype(int)
    box = painter._axes.get_window_extent()
    left, right = painter._axes.get_xlim()
    colours = [np.round(255 * np.array(painter.colours(t)[:3])) for t in (0.0, 1.0)]
    across, up = painter._axes.transData.transform((0.05, 0.0))
    return picture, colours, box.width / (right - left), (round(SIZE[1] - up), round(across))


def like(picture, colour):
    return np.abs(picture - colour).max(axis=-1) < 12


def test_a_rope_is_as_wide_as_its_diameter_and_hides_the_one_behind_it():
    picture, (far, near), scale, (row, column) = painted(0.1)
    half = round(0.05 * scale)
    assert half > 15
    cross = picture[row - half + 2 : row + half - 2, column - half + 2 : column + half - 2]
    assert like(cross, near).all()  # the level one passes behind
    aside = column - round(0.2 * scale)
    assert like(picture[:, aside], far).sum() == pytest.approx(0.1 * scale, abs=3)
    white = like(picture[row, column - half - 8 : column], 255.0)  # which is nearer is seen
    assert white.any()
    assert not like(picture[row, aside - half : aside], 255.0).any()  # the twin


@pytest.mark.parametrize("diameter", [0.03, 0.001])
def test_a_rope_has_no_gaps_between_its_segments(diameter):
    """A thin one, of lines with butt ends, was dashed."""
    picture, (far, _), scale, (row, column) = painted(diameter)
    start, end = (column - round(way * scale) for way in (0.5, 0.1))
    assert (np.abs(picture[row, start:end] - far).max(axis=-1) < 3.0).all()


def body(y: float) -> str:
    """A ball before or behind the left half of the level rope, and a ring that lets its end be seen."""
    ball = f'kind = "sphere"\ncenter = [-0.25, {y}, 0]\nradius = 0.1\n'
    ring = f'kind = "torus"\ncenter = [0.35, {y}, 0]\naxis = [0, 1, 0]\nradius = 0.1\nbar_radius = 0.02\n'
    return "".join(f"\n[[obstacle]]\n{one}" for one in (ball, ring))


def test_what_an_obstacle_hides_is_pale():
    seen, (far, _), scale, (row, column) = painted(0.03, body(0.5))
    hid, _, _, same = painted(0.03, body(-0.5))
    assert same == (row, column)
    at = {way: column + round((way - 0.05) * scale) for way in (-0.45, -0.25, 0.25, 0.35)}
    assert all(
        like(seen[row, place], far) for place in at.values()
    )  # the twin: all behind the rope
    pale = {way: not like(hid[row, place], far) for way, place in at.items()}
    assert pale == {-0.45: False, -0.25: True, 0.25: True, 0.35: False}  # seen through the ring
    face = np.round(255 * np.array(to_rgb(FACE)))
    assert np.abs(hid[row, at[-0.25]] - (0.8 * face + 0.2 * far)).max() < 8.0


def test_an_obstacle_hides_a_rope_of_one_segment():
    level = ROPE.format(name="one", segments=1, diameter=0.03, start=[-0.75, 0, 0], way=[1, 0, 0])
    pixels = []
    for y in (0.5, -0.5):  # behind it and before it
        result = simulate_in_memory(loads(HEAD + level + body(y)))
        painter = _Painter(result, backdrop(result, "xz"), SIZE, 1.0, 3)
        start = result.read("positions", 0, 1)[0]
        picture = np.asarray(painter.paint(_Moment(0.0, start, np.zeros(1), False))).astype(int)
        across, up = painter._axes.transData.transform((-0.25, 0.0))
        pixels.append(picture[round(SIZE[1] - up), round(across)])
    seen, hid = pixels
    face = np.round(255 * np.array(to_rgb(FACE)))
    assert np.abs(hid - (0.8 * face + 0.2 * seen)).max() < 8.0


def test_a_thin_rope_is_a_line():
    picture, (far, _), scale, (_, column) = painted(0.001)
    aside = column - round(0.2 * scale)
    assert 1 <= like(picture[:, aside], far).sum() <= 4


def test_ribbons_have_their_width_and_no_gaps_in_bends():
    points = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [1.0, 1.0], [3.0, 1.0]])
    found = ribbon(points, np.array([True, True, True, False]), np.full(4, 0.1))
    assert np.allclose(found[0], [[0.0, 0.1], [0.9, 0.1], [1.1, -0.1], [0.0, -0.1]])
    assert np.array_equal(found[0][1], found[1][0])
    assert np.array_equal(found[0][2], found[1][3])
    assert np.isfinite(found).all()  # of no length, too


def ribbons(figure) -> list[np.ndarray]:
    """The corners of all pieces of ropes in a figure's first axes [m], (4, 2) each."""
    figure.canvas.draw()
    found = [one for one in figure.axes[0].collections if isinstance(one, PolyCollection)]
    return [path.vertices[:4] for one in found for path in one.get_paths()]


@pytest.mark.parametrize("draw", [lambda run: film(run, 1), lambda run: shape(run, [0.0])])
def test_film_strips_and_a_shape_draw_ropes_as_thick_as_they_are(draw) -> None:
    pieces = ribbons(draw(crossing(0.08)))
    heights = [np.ptp(one[:, 1]) for one in pieces if abs(one[:, 0].mean() + 0.45) < 0.01]
    assert sorted(heights) == pytest.approx([0.08, 1.3 * 0.08])  # and its white edge
    last = pieces[-1]  # drawn over all others: of the upright rope, which is nearer
    assert np.ptp(last[:, 0]) == pytest.approx(0.08)
    assert ribbons(draw(crossing(0.001))) == []  # a line


def test_shapes_of_several_times_are_lines_that_do_not_hide_one_another() -> None:
    assert ribbons(shape(crossing(0.08), [0.0, 0.01])) == []


def test_a_thin_rope_beside_a_thick_one_is_no_thinner_than_a_line() -> None:
    both = crossing(0.08)
    thin = both.scene.ropes[0].replace(diameter=1e-4)
    run = simulate_in_memory(both.scene.replace(ropes=[thin, both.scene.ropes[1]]))
    figure = film(run, 1)
    level = [one for one in ribbons(figure) if abs(one[:, 0].mean() + 0.45) < 0.01]
    room = figure.axes[0].transData.transform(level[1]) * 72.0 / figure.dpi
    assert np.ptp(room[:, 1]) == pytest.approx(LINE, rel=0.3)


def test_a_rope_at_a_drum_is_no_wider_than_it_is() -> None:
    """Beside what lies on the drum, segments without length, it was half as wide again."""
    points = np.array([[0.0, 0.0], [0.0, 0.0], [0.0, -1.0], [0.0, -2.0], [0.0, -2.0]])
    corners = ribbon(points, np.ones(4, dtype=bool), np.full(4, 0.1))
    for segment in (1, 2):
        begin, end = corners[segment, [0, 3]], corners[segment, [1, 2]]
        assert np.ptp(begin[:, 0]) == pytest.approx(0.2)
        assert np.ptp(end[:, 0]) == pytest.approx(0.2)


def test_the_time_of_a_film_hides_no_rope() -> None:
    result = crossing(0.03)
    painter = _Painter(result, backdrop(result, "xz"), SIZE, 1.0, 3)
    start = result.read("positions", 0, 1)[0]
    painter.paint(_Moment(0.0, start, np.zeros(result.layout.segments), False))
    room = painter._axes.get_window_extent()
    stamp = painter._stamp.get_window_extent()
    assert painter._stamp.get_text() == "t = 0.000 s"
    assert stamp.y0 >= room.y1
    assert stamp.y1 < SIZE[1]


def test_a_knot_is_drawn_to_one_scale() -> None:
    """Ropes that touch each other and reach no higher than some diameters, even if they are long."""
    flat = np.array([[0.0, 0.0], [1.0, 0.04]])
    assert box_around(flat, None, thick=0.01).magnified == 1.0
    assert box_around(flat, None, thick=0.001).magnified > 1.0
    assert box_around(flat, None).magnified > 1.0
    assert (
        backdrop(simulate_in_memory(preset("overhand").replace(**SHORT)), None).box.magnified == 1
    )
