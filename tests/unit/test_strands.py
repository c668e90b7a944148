"""Ropes in films: as thick as they are, nearer ones over farther ones; lines where they are thin."""

from __future__ import annotations

import numpy as np
import pytest
from matplotlib.collections import PolyCollection

from ropewalk.plots import film, shape
from ropewalk.plots.canvas import backdrop
from ropewalk.plots.movies import _Moment, _Painter
from ropewalk.plots.strands import LINE, ribbon
from ropewalk.record.simulate import simulate_in_memory
from ropewalk.scene import loads

SIZE = (600, 500)


def crossing(diameter: float):
    """Two straight ropes of 1 m that cross, seen along y: the upright one is nearer."""
    rope = """
[[rope]]
name = "{name}"
segments = 10
length = 1.0
diameter = {diameter}
made_of = {{ kind = "material", EA = 100.0, mass_per_length = 0.1 }}
shape = {{ kind = "straight", start = {start}, direction = {way} }}
"""
    level = rope.format(name="level", diameter=diameter, start=[-0.5, 0.1, 0], way=[1, 0, 0])
    upright = rope.format(
        name="upright", diameter=diameter, start=[0.05, -0.1, -0.5], way=[0, 0, 1]
    )
    head = 'gravity = [0, 0, 0]\n[run]\nduration = 0.01\ntime_step = 1e-3\nmethod = "semi-implicit-euler"\n'
    return simulate_in_memory(loads(head + level + upright))


def painted(diameter: float):
    """The picture, (h, w, 3), the colours of both ropes, and pixels per metre."""
    result = crossing(diameter)
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
