"""Constant forces and weights in water are named and drawn on figures."""

from __future__ import annotations

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pytest
from matplotlib.colors import to_rgb
from matplotlib.patches import FancyArrowPatch
from PIL import Image

import ropewalk as rw
from live.drive import slack_rope
from ropewalk import plots
from ropewalk.plots import compare
from ropewalk.plots.dimensions import dimensions
from ropewalk.plots.given_forces import GIVEN, given_notes
from ropewalk.plots.movies import _moments, _Painter, stage
from ropewalk.scene import Force, Straight


def texts(figure: plt.Figure) -> list[str]:
    """Return all that is written in a figure."""
    axes = [text.get_text() for one in figure.axes for text in one.texts]
    return axes + [text.get_text() for text in figure.texts]


def test_a_figure_of_the_shape_shows_what_the_scene_gives() -> None:
    plain = slack_rope(6)
    plain = plain.replace(run=plain.run.replace(duration=0.05))
    forces = [Force(node=3, force=(0.0, 30.0, -40.0)), Force(node=1, force=(0.0, 0.0, 0.0))]
    rope = plain.ropes[0].replace(forces=forces, submerged_weight=-1.5)
    said = texts(rw.simulate(plain.replace(ropes=[rope])).plot.shape())
    assert "50 N" in said
    assert any("Weight in water: -1.5 N/m." in one for one in said)
    assert any("Brown arrows: constant forces at nodes." in one for one in said)
    assert "50 N" not in texts(rw.simulate(plain).plot.shape())
    assert given_notes(plain) == []


def pulled(force: tuple[float, float, float] = (0.0, 30.0, -40.0)) -> rw.Result:
    scene = slack_rope(6)
    rope = scene.ropes[0].replace(forces=[Force(node=3, force=force)])
    return rw.simulate(scene.replace(ropes=[rope], run=scene.run.replace(duration=0.05)))


def arrows(axes: plt.Axes) -> list[FancyArrowPatch]:
    return [one for one in axes.get_children() if type(one) is FancyArrowPatch]


def test_every_figure_that_shows_the_ropes_shows_the_forces_at_nodes() -> None:
    result, other = pulled(), pulled((0.0, 0.0, 100.0))
    for figure in (result.plot.shape(), result.plot.forces(), dimensions(result)):
        assert len(arrows(figure.axes[0])) == 1
        assert {"50 N"} <= set(texts(figure))
    strip = result.plot.film(3)
    assert [len(arrows(axes)) for axes in strip.axes[:3]] == [1, 1, 1]
    assert "Brown arrows: constant forces at nodes, the longest 50 N." in texts(strip)
    both = compare([result, other])
    assert "Brown arrows: constant forces at nodes, the longest 100 N." in " ".join(texts(both))
    lengths = []
    for axes in both.axes[:2]:  # one scale for both runs
        (arrow,) = arrows(axes)
        start, tip = (np.array(place) for place in arrow._posA_posB)  # type: ignore[attr-defined]
        lengths.append(abs(tip - start)[1])
    assert lengths[1] == pytest.approx(2.5 * lengths[0])


def test_arrows_stay_in_the_picture() -> None:
    """Those at the end of a rope, along it, left every picture but that of forces."""
    springs = rw.Springs(spring_constant=1e3, node_mass=0.1, segment_length=0.5)
    for direction, force in (((0, 0, -1), (0, 0, -20.0)), ((1, 0, 0), (30.0, 0, 0))):
        shape = Straight(start=(0, 0, 0), direction=direction)
        rope = rw.Rope(
            segments=4, made_of=springs, shape=shape, forces=[Force(node=-1, force=force)]
        )
        run = rw.RunSettings(duration=0.1, time_step=1e-3, method="semi-implicit-euler")
        scene = rw.Scene(ropes=[rope], anchors=[rw.Anchor(node=0)], run=run)
        result = rw.simulate(scene)
        figures = [plots.film(result, 4), compare([result, result]), dimensions(result)]
        drawn = [axes for figure in figures for axes in figure.axes]
        drawn += plots.shape(result, [0.0], plane="xz").axes
        seen = stage(result, "xz", (960, 540))
        painter = _Painter(result, seen, (960, 540), 1.0, 2)
        painter.paint(next(_moments(result, np.array([0.1]), seen.good)))
        found = [(axes, arrow) for axes in (*drawn, painter._axes) for arrow in arrows(axes)]
        assert len(found) == 4 + 2 + 1 + 1 + 1
        for axes, arrow in found:
            x, y = arrow._posA_posB[1]  # type: ignore[attr-defined]
            assert axes.get_xlim()[0] < x < axes.get_xlim()[1]
            assert axes.get_ylim()[0] < y < axes.get_ylim()[1]


def test_the_forces_at_nodes_go_with_the_rope_in_a_movie(tmp_path: Path) -> None:
    plain = slack_rope(6)
    still = rw.simulate(plain.replace(run=plain.run.replace(duration=0.05)))
    brown = np.array(to_rgb(GIVEN)) * 255.0

    def seen(result: rw.Result) -> int:
        path = result.movie(tmp_path / "movie.gif", size=(400, 300))
        pixels = np.asarray(Image.open(path).convert("RGB"), dtype=float)
        return int((np.abs(pixels - brown).max(axis=2) < 12.0).sum())

    assert seen(pulled()) > 20
    assert seen(still) == 0


def test_of_many_forces_the_largest_are_drawn_and_the_note_says_so() -> None:
    scene = slack_rope(150)
    forces = [Force(node=i, force=(0.0, 0.0, 1e-6 * (1 + i))) for i in range(151)]
    scene = scene.replace(ropes=[scene.ropes[0].replace(forces=forces)])
    result = rw.simulate(scene.replace(run=scene.run.replace(duration=0.02, time_step=1e-4)))
    figure = result.plot.shape()
    assert len(arrows(figure.axes[0])) == 100
    note = "Brown arrows: the 100 largest of the constant forces at nodes, the longest 0.000151 N."
    assert note in " ".join(texts(figure)).replace("\n", " ")
