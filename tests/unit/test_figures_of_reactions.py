"""Figures of the forces of anchors: each at its own anchor, of those that let go and of ropes that broke."""

from __future__ import annotations

import numpy as np
import pytest
from matplotlib.figure import Figure

import ropewalk as rw
from ropewalk import plots
from ropewalk.plots import reaction_forces
from ropewalk.record.result import Result
from ropewalk.scene import Straight, Velocity
from ropewalk.words.prefixes import prefixed


def hung(*releases: float | None) -> Result:
    """A rope of four segments on an anchor at each of its first nodes, let go at these times [s]."""
    springs = rw.Springs(
        spring_constant=1e3, node_mass=0.1, segment_length=0.5, spring_friction=0.5
    )
    rope = rw.Rope(segments=4, made_of=springs, shape=Straight(start=(0, 0, 0)))
    anchors = [rw.Anchor(node=node, release_time=when) for node, when in enumerate(releases)]
    run = rw.RunSettings(duration=0.3, time_step=0.01, method="semi-implicit-euler", frame_rate=50)
    return rw.simulate(rw.Scene(ropes=[rope], anchors=anchors, run=run))


def arrows(figure: Figure) -> list[tuple[tuple[float, float], str]]:
    """Where arrows start in the picture, each with the size that is written at its tip."""
    texts = figure.axes[0].texts
    tips = {text.xy: text.get_text().strip() for text in texts if text.get_text()}
    return [(text.xyann, tips[text.xy]) for text in texts if text.arrow_patch is not None]


@pytest.mark.parametrize("releases", [(0.1, None), (None, 0.1), (None, 0.3), (None, None)])
def test_forces_are_drawn_at_the_anchors_that_hold(releases: tuple[float | None, ...]) -> None:
    """The force of the second anchor stood at the first; and one that let go at the end had no place."""
    run = hung(*releases)
    holds = [row for row, when in enumerate(releases) if when is None]
    view = plots.forces(run)
    expected = [
        (
            (run.positions[-1, node, 0], run.positions[-1, node, 2]),
            prefixed(float(np.linalg.norm(run.reactions[-1, node])), "N"),
        )
        for node in holds
    ]
    assert arrows(view) == expected
    assert "anchors' forces" in view._supxlabel.get_text()


def test_where_all_anchors_have_let_go_there_are_no_arrows() -> None:
    figure = plots.forces(hung(0.1, 0.2))
    assert arrows(figure) == []
    assert figure._supxlabel is None


@pytest.fixture(scope="module")
def one_broke() -> Result:
    """Three ropes of which the middle one is torn and the others go on."""
    springs = rw.Springs(
        spring_constant=100.0, node_mass=0.01, segment_length=0.05, spring_friction=0.05
    )
    names = ("a", "b", "c")
    ropes = [
        rw.Rope(name=name, segments=2, made_of=springs, shape=Straight(start=(0, y, 0)))
        for y, name in enumerate(names)
    ]
    anchors = [rw.Anchor(name=f"hold-{name}", rope=name, node=0) for name in names]
    pulled = Velocity(velocity=(10.0, 0, 0))
    anchors.append(rw.Anchor(name="pull-b", rope="b", node=-1, motion=pulled))
    run = rw.RunSettings(duration=0.3, time_step=1e-3, method="semi-implicit-euler", frame_rate=50)
    scene = rw.Scene(ropes=ropes, anchors=anchors, run=run)
    result = rw.simulate(scene, on_failure="return")
    assert [end.ropes for end in result.ends] == [("b",)]
    assert np.isnan(result.reactions[-1, 3]).all()
    return result


def test_components_are_drawn_where_a_rope_broke(one_broke: Result) -> None:
    """What is NaN of one rope left the components of all anchors out."""
    figure = plots.reactions(one_broke)
    for row, axes in enumerate(figure.axes[:4]):
        drawn = {line.get_label(): line.get_ydata() for line in axes.lines}
        for k, name in ((0, "x"), (2, "z")):
            np.testing.assert_array_equal(drawn[name], one_broke.reactions[:, row, k])


def test_the_largest_anchors_are_shown_where_a_rope_broke(
    one_broke: Result, monkeypatch: pytest.MonkeyPatch
) -> None:
    """What was NaN at last counted as the least, and stood in no figure."""
    monkeypatch.setattr(reaction_forces, "_PANELS", 1)
    monkeypatch.setattr(reaction_forces, "_LINES", 2)
    (axes,) = plots.reactions(one_broke).axes
    shown = [line.get_label() for line in axes.lines if not line.get_label().startswith("_")]
    assert shown == ["hold-b", "pull-b"]


@pytest.mark.parametrize("panels", [6, 0])
def test_no_peak_between_frames_is_missing(panels: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """Frames had 0.73 of the largest force that the run tells, and the limits were theirs."""
    monkeypatch.setattr(reaction_forces, "_PANELS", panels)
    cord = rw.Material(EA=1e4, mass_per_length=0.1)
    rope = rw.Rope(
        segments=4, length=1.0, made_of=cord, shape=Straight(start=(0, 0, 0)),
        loads=[rw.Load(node=-1, mass=1.0)],
    )  # fmt: skip
    run = rw.RunSettings(duration=2.0, frame_rate=3.0)
    result = rw.simulate(rw.Scene(ropes=[rope], anchors=[rw.Anchor(node=0)], run=run))
    largest = result.table["largest anchor force [N]"]
    assert np.linalg.norm(result.reactions, axis=2).max() < 0.85 * largest
    (axes,) = plots.reactions(result).axes
    assert max(np.max(one.get_ydata()) for one in axes.lines) == pytest.approx(largest)
    assert axes.get_ylim()[1] > largest
