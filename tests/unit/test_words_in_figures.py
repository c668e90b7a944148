"""Words and legends of figures stay inside the picture, and none lies on another."""

from __future__ import annotations

from itertools import combinations, pairwise

import numpy as np
import pytest
from matplotlib.figure import Figure

import ropewalk as rw
from ropewalk import plots
from ropewalk.plots.dimensions import dimensions
from ropewalk.record.result import Result
from ropewalk.scene import Straight

CORD = rw.Material(EA=1e5, mass_per_length=0.1)


def hangers(count: int, apart: float) -> Result:
    """Ropes that hang beside each other, each with a load of its own, at rest."""
    ropes = [
        rw.Rope(
            name=f"h{i}", segments=4, length=2.0, made_of=CORD,
            shape=Straight(start=(apart * i, 0.0, 0.0), direction=(0.0, 0.0, -1.0)),
            loads=[rw.Load(node=-1, mass=10.0 + i)],
        )
        for i in range(count)
    ]  # fmt: skip
    anchors = [rw.Anchor(name=f"a{i}", rope=f"h{i}", node=0) for i in range(count)]
    return rw.equilibrium(rw.Scene(ropes=ropes, anchors=anchors))


def overlaps(figure: Figure, ending: str) -> list[tuple[str, str]]:
    """Pairs of words that end so, of which one lies on the other."""
    figure.draw_without_rendering()
    said = [one for one in figure.axes[0].texts if one.get_text().strip().endswith(ending)]
    assert said
    return [
        (one.get_text(), other.get_text())
        for one, other in combinations(said, 2)
        if one.get_window_extent().overlaps(other.get_window_extent())
    ]


@pytest.mark.parametrize("count", [3, 8, 20])
def test_no_force_is_written_on_another(count: int) -> None:
    """Of hangers 0.3 m apart the numbers lay on each other."""
    figure = plots.forces(hangers(count, 0.3))
    assert overlaps(figure, " N") == []
    words = [one.get_text().strip() for one in figure.axes[0].texts if one.get_text()]
    assert len(words) <= 8
    assert f"{9.81 * (9.0 + count + 0.2):.4g} N" in words
    assert "only the largest" in figure._supxlabel.get_text()


def test_anchors_at_one_place_have_one_number() -> None:
    """Those of four ropes one behind another were written four times, one on the other."""
    figure = plots.forces(hangers(4, 0.0))
    words = [one.get_text().strip() for one in figure.axes[0].texts if one.get_text()]
    assert words == [f"4 anchors, at most {9.81 * 13.2:.4g} N"]


def test_no_sag_is_written_on_another() -> None:
    """Of the preset `net` eight were, one on the other."""
    figure = dimensions(rw.equilibrium(rw.preset("net")))
    assert overlaps(figure, " m") == []
    assert "of 14 sags are drawn" in figure._supxlabel.get_text()


@pytest.mark.parametrize("length", [3, 50])
def test_profiles_of_tension_have_a_legend_that_fits(length: int) -> None:
    """Its six columns were wider than the figure, and the panels a stripe."""
    names = [f"{'r' * length}{i}" for i in range(6)]
    ropes = [
        rw.Rope(name=name, segments=4, length=2.0, made_of=CORD,
                shape=Straight(start=(0.3 * i, 0.0, 0.0), direction=(0.0, 0.0, -1.0)))
        for i, name in enumerate(names)
    ]  # fmt: skip
    anchors = [rw.Anchor(name=f"a{i}", rope=name, node=0) for i, name in enumerate(names)]
    run = rw.RunSettings(duration=0.1, frame_rate=50.0)
    result = rw.simulate(rw.Scene(ropes=ropes, anchors=anchors, run=run))
    figure = plots.tension(result, times=[0.0, 0.04, 0.1])
    figure.draw_without_rendering()
    width = figure.get_window_extent().width
    panels = [axes.get_window_extent() for axes in figure.axes if axes.images or axes.lines]
    assert all(one.width > 0.7 * width and one.height > 40.0 for one in panels)
    (legend,) = [axes.get_legend() for axes in figure.axes if axes.get_legend()]
    assert legend.get_window_extent().x1 <= width
    assert len(legend.get_texts()) == 19


def test_plumb_ropes_side_by_side_are_drawn_to_one_scale() -> None:
    """Metres were drawn on an axis of column numbers: 3.6 m of 300 as wide as 3.6 columns, at 45 degrees."""
    made_of = rw.Material(EA=1e6, mass_per_length=0.5, axial_damping=100.0)
    leaning = Straight(start=(0.0, 0.0, 0.0), direction=(0.012, 0.0, -1.0))
    rope = rw.Rope(segments=10, length=300.0, made_of=made_of, shape=leaning)
    result = rw.simulate(rw.Scene(ropes=[rope], anchors=[rw.Anchor(node=0)], run={"duration": 6.0}))
    figure = plots.shape(result)
    figure.draw_without_rendering()
    axes = figure.axes[0]
    lines = [np.column_stack(one.get_data()) for one in axes.lines if len(one.get_xdata()) > 2]
    assert len(lines) == 6
    seen = axes.transData.transform(lines[0])
    across, down = np.ptp(seen, axis=0)
    assert across / down == pytest.approx(0.012, rel=0.02)
    middles = [line[:, 0].mean() for line in lines]
    assert np.allclose(np.diff(middles), axes.get_xticks()[1], rtol=0.1)
    assert all(axes.viewLim.x0 < line.min() and line.max() < axes.viewLim.x1 for line in
               (one[:, 0] for one in lines))  # fmt: skip
    assert all(one[:, 0].max() < other[:, 0].min() for one, other in pairwise(lines))
