"""Figures of runs in which a rope broke while another went on, or parted: right places, times and notes."""

from __future__ import annotations

import warnings
from itertools import combinations

import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import FixedLocator
from matplotlib.transforms import Bbox

import ropewalk as rw
from ropewalk import plots
from ropewalk.plots.arcs import laid_lengths, segment_arcs
from ropewalk.plots.canvas import backdrop
from ropewalk.plots.movies import _moments, _Painter
from ropewalk.plots.style import FAINT, scaled_axis
from ropewalk.plots.tensions import tension_map
from ropewalk.record.result import Result
from ropewalk.scene import Force, Straight, Velocity
from ropewalk.scene.presets import preset


def note(figure: Figure) -> str:
    """What stands below a figure."""
    return figure._supxlabel.get_text().replace("\n", " ") if figure._supxlabel else ""


def two(direction: tuple[float, float, float], **stiff: object) -> Result:
    """Two ropes side by side that are held by their first nodes; the "stiff" one breaks in the run."""
    made_of = {"segment_length": 0.5, "node_mass": 0.05, "spring_friction": 0.05}
    ropes = [
        rw.Rope(
            name=name,
            segments=6,
            made_of=rw.Springs(spring_constant=constant, **made_of),
            shape=Straight(start=(0, at, 0), direction=direction),
            **(stiff if name == "stiff" else {}),
        )
        for name, constant, at in (("soft", 500.0, 0.0), ("stiff", 56e3, 0.01))
    ]
    anchors = [rw.Anchor(name=f"hold-{name}", rope=name, node=0) for name in ("soft", "stiff")]
    run = rw.RunSettings(duration=0.3, time_step=1e-3, method="semi-implicit-euler", frame_rate=50)
    result = rw.simulate(rw.Scene(ropes=ropes, anchors=anchors, run=run), on_failure="return")
    assert [end.ropes for end in result.ends] == [("stiff",)]
    assert result.ends[0].frames < result.frames == 16
    return result


@pytest.fixture(scope="module")
def hanging() -> Result:
    return two((0, 0, -1), forces=[Force(node=-1, force=(0, 0, -3.0))])


@pytest.fixture(scope="module")
def level() -> Result:
    return two((1, 0, 0))


def test_shapes_side_by_side_are_there_after_a_rope_broke(hanging: Result) -> None:
    """The middle of what is NaN of one rope took the others out of the figure."""
    figure = plots.shape(hanging)
    axes = figure.axes[0]
    ticks = axes.get_xticks()
    columns = len(ticks)
    middles = [line.get_xdata() for line in axes.lines if len(line.get_xdata()) == 7]
    seen = [x for x in middles if np.isfinite(x).all()]
    assert columns > 4
    for column in range(columns):
        assert any(abs(x.mean() - ticks[column]) < 0.1 * ticks[1] for x in seen)
    assert "Brown arrows" not in note(figure)  # side by side there are none


def test_a_comparison_says_when_a_rope_broke(level: Result) -> None:
    """It said that a run broke at its end, long after."""
    text = note(plots.compare([level, level], ["one", "other"]))
    assert f"one: ended early, stiff after {level.ends[0].time:.5g} s." in text
    assert "broke after t" not in text


def test_the_phase_plane_has_the_end_of_a_rope_that_broke(level: Result) -> None:
    axes = plots.phase(level, ("stiff", 6), "z").axes[0]
    (end,) = [line for line in axes.lines if line.get_label() in ("end", "last good")]
    frame, node = level.ends[0].frames - 1, level.layout.node(6, "stiff")
    assert end.get_label() == "last good"
    assert end.get_xdata() == [level.positions[frame, node, 2]]
    assert end.get_ydata() == [level.velocities[frame, node, 2]]
    (whole,) = [
        line for line in plots.phase(level, 6, "z").axes[0].lines if line.get_label() == "end"
    ]
    assert whole.get_xdata() == [level.positions[-1, 6, 2]]


def test_forces_name_and_tell_of_what_is_drawn(hanging: Result) -> None:
    figure = plots.forces(hanging)
    (legend,) = [axes.get_legend() for axes in figure.axes if axes.get_legend()]
    assert [text.get_text() for text in legend.get_texts()] == ["soft"]
    assert "Orange arrows" in note(figure)
    assert "Brown arrows" not in note(figure)  # the force is on the rope that broke
    assert "Brown arrows" in note(plots.film(hanging))


def test_a_movie_leaves_out_the_rope_that_broke(hanging: Result) -> None:
    """It stood there to the end as it was, in the colour of middle tensions."""
    seen = backdrop(hanging, "xz")
    painter = _Painter(hanging, seen, (400, 300), 1.0, 2)
    before, after = _moments(hanging, np.array([0.0, 0.2]), seen.good)
    painter.paint(before)
    assert len(painter._rope.get_segments()) == 12
    assert np.isfinite(painter._anchors.get_xydata()).all(axis=1).tolist() == [True, True]
    assert all(artist.get_visible() for artist in painter._forces.artists)
    painter.paint(after)
    assert len(painter._rope.get_segments()) == 6
    assert np.isfinite(painter._anchors.get_xydata()).all(axis=1).tolist() == [True, False]
    assert not any(artist.get_visible() for artist in painter._forces.artists)


def texts_of_ticks(axes: Axes) -> list[Bbox]:
    """Where the numbers below axes stand in the picture."""
    low, high = axes.get_xlim()
    shown = [t.label1 for t in axes.xaxis.get_major_ticks() if low <= t.get_loc() <= high]
    return [one.get_window_extent() for one in shown if one.get_text()]


def test_behind_broken_shapes_lies_what_broke_and_titles_are_apart(
    hanging: Result, level: Result
) -> None:
    """In grey lay the other rope at the end of the run; titles of narrow panels ran into each other."""
    for result in (hanging, level):
        figure = plots.film(result)
        panels = [axes for axes in figure.axes if "broken" in axes.get_title(loc="left")]
        drawn = [
            np.asarray(line.get_xydata())
            for line in panels[0].lines
            if line.get_color() == FAINT and np.isfinite(line.get_xydata()).any()
        ]
        last = result.rope("stiff").positions[result.ends[0].frames - 1]
        assert len(drawn) == 1
        np.testing.assert_array_equal(drawn[0], last[:, [0, 2]] if result is level else last[:, 1:])
        figure.draw_without_rendering()
        titles = [axes._left_title.get_window_extent() for axes in panels]
        assert len(titles) == 2
        assert not titles[0].overlaps(titles[1])


def test_numbers_below_narrow_pictures_are_apart(hanging: Result) -> None:
    """Of one picture of an upright rope, and of its forces, they stood on each other."""
    for figure in (plots.film(hanging, [3]), plots.forces(hanging)):
        figure.draw_without_rendering()
        boxes = texts_of_ticks(figure.axes[0])
        assert len(boxes) > 1
        assert not any(one.overlaps(other) for one, other in combinations(boxes, 2))


def test_narrow_pictures_of_forces_stand_in_the_middle(hanging: Result) -> None:
    figure = plots.forces(hanging)
    figure.draw_without_rendering()
    above, below = (axes.get_window_extent() for axes in figure.axes[:2])
    assert above.width < 0.3 * below.width
    assert below.x0 + 0.3 * below.width < above.x0 < below.x0 + 0.6 * below.width


@pytest.fixture(scope="module")
def parted() -> Result:
    """A rope of 2 m whose middle is pulled away from an anchor: it parts there."""
    made_of = rw.Material(EA=2e3, mass_per_length=0.05, breaking_load=60.0, parts=True)
    rope = rw.Rope(segments=8, length=2.0, made_of=made_of, shape=Straight(start=(0, 0, 0)))
    anchors = [
        rw.Anchor(node=0),
        rw.Anchor(name="pull", node=5, motion=Velocity(velocity=(20.0, 0, 0))),
    ]
    run = rw.RunSettings(
        duration=0.004, time_step=1e-4, method="semi-implicit-euler", frame_rate=1e3
    )
    result = rw.simulate(rw.Scene(ropes=[rope], anchors=anchors, run=run))
    assert [one.segment for one in result.partings] == [4]
    return result


def test_what_lies_behind_a_parting_stays_in_its_place(parted: Result) -> None:
    """What has parted has no length, and the rest of the rope was drawn that much nearer to its start."""
    places = 0.25 * (np.arange(8) + 0.5)
    np.testing.assert_allclose(segment_arcs(parted, -1, "rope"), places)
    (profile,) = plots.forces(parted).axes[1].lines
    np.testing.assert_allclose(profile.get_xdata(), places)
    gap = np.isnan(profile.get_ydata())
    assert gap.tolist() == [segment == 4 for segment in range(8)]  # no line goes over it
    assert (parted.rest_length[-1] == 0.0).tolist() == gap.tolist()  # the result's own stay
    np.testing.assert_array_equal(profile.get_ydata()[~gap], parted.tension[-1][~gap])


def test_what_lies_behind_a_parting_stays_in_its_place_on_a_winch() -> None:
    """Its map counts from the end, where the last segment has parted and two are left."""
    made_of = rw.Material(EA=2e3, mass_per_length=0.05, breaking_load=60.0, parts=True)
    rope = rw.Rope(
        segments=6,
        length=1.5,
        made_of=made_of,
        shape=Straight(start=(0, 0, 0), direction=(1, 0, 0)),
    )
    anchors = [
        rw.Anchor(node=0),
        rw.Anchor(name="pull", node=-1, motion=Velocity(velocity=(20.0, 0, 0))),
    ]
    run = rw.RunSettings(
        duration=0.004, time_step=1e-4, method="semi-implicit-euler", frame_rate=1e3
    )
    scene = rw.Scene(
        ropes=[rope], anchors=anchors, run=run, winches=[rw.Winch(end="start", speed=0.5)]
    )
    result = rw.simulate(scene)
    (one,) = result.partings
    assert one.segment == 5
    paid_out = result.rest_length.sum(axis=1) + 0.25 * (result.time >= one.time)
    assert 1.5 < paid_out[-1] < 1.502
    np.testing.assert_allclose(laid_lengths(result, "rope").sum(axis=1), paid_out, rtol=1e-9)
    found = tension_map(result, 0)
    assert found.length == pytest.approx(paid_out[-1])
    middle = (np.arange(found.values.shape[1]) + 0.5) * found.length / found.values.shape[1]
    own = result.rope("rope").tension[-1]
    assert not found.values[-1][middle < 0.25].any()  # it has parted
    assert set(found.values[-1][(middle > 0.25) & (middle < 0.5)]) == {own[-2]}


def test_an_equilibrium_is_seen_and_called_so() -> None:
    """Its one frame was not seen in figures over time; of its energy error "at most nan J" was said."""
    springs = rw.Springs(spring_constant=1e3, node_mass=0.1, segment_length=0.5)
    rope = rw.Rope(segments=2, made_of=springs, shape=Straight(start=(0, 0, 0)))
    scene = rw.Scene(ropes=[rope], anchors=[rw.Anchor(name="hold", node=0)])
    rest = rw.equilibrium(scene)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        figures = [plots.energy(rest), plots.height(rest), plots.reactions(rest)]
    for figure in figures:
        drawn = [line for line in figure.axes[0].lines if not line.get_label().startswith("_")]
        assert drawn
        assert {line.get_marker() for line in drawn if len(line.get_xdata()) == 1} == {"o"}
    assert "nan" not in note(figures[0])
    assert [t.get_text() for t in figures[0].axes[1].texts] == [
        "an equilibrium has no energy error"
    ]
    for figure in (*figures, plots.tension(rest), plots.shape(rest), plots.compare([rest, rest])):
        assert figure.texts[1].get_text() == "equilibrium"  # it was told as a run of no time
    labels = [axes.get_ylabel() for axes in plots.tension(rest).axes]
    assert "tension [N]" in labels  # not the largest since a frame before
    run = rw.simulate(scene.replace(**{"run.duration": 0.1}))
    assert plots.height(run).axes[0].lines[0].get_marker() == "None"  # a run has its curve
    assert "steps, 0 to 0.1 s" in plots.height(run).texts[1].get_text()


def test_an_energy_error_needs_no_power_of_ten() -> None:
    run = rw.simulate(preset("r7"), on_failure="return")
    said = note(plots.energy(run))
    assert "at most 1.55 kJ" in said
    assert "e+" not in said


def test_a_legend_has_the_ground_where_it_is_in_view(level: Result) -> None:
    for height, named in ((-0.02, True), (-5.0, False)):
        scene = level.scene.replace(ground={"height": height}, **{"run.duration": 0.1})
        run = rw.simulate(scene, on_failure="return")
        names = [line.get_label() for line in plots.height(run).axes[0].lines]
        assert ("ground" in names) is named


def test_numbers_at_axes_of_what_is_zero_are_plain() -> None:
    """They were "-1.0e+00" to "1.0e+00"."""
    for size, shown in ((0.0, "0.50"), (1e-14, "5.0e-01"), (3.0, "0.5")):
        axes = Figure().subplots()
        axes.set_ylim(0.0, 1.0)
        axes.set_yticks([0.0, 0.25, 0.5])
        scaled_axis(axes, "force", "N", size)
        axes.yaxis.set_major_locator(FixedLocator([0.0, 0.25, 0.5]))
        axes.figure.draw_without_rendering()
        assert axes.get_yticklabels()[-1].get_text() == shown
