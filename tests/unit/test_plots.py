"""Figures show the result's own numbers, with units, and survive broken runs."""

from __future__ import annotations

import math
import re
import subprocess
import sys
from types import SimpleNamespace

import numpy as np
import pytest
from matplotlib.figure import Figure

import runs
from ropewalk import equilibrium, plots
from ropewalk.plots.energies import energy_curves, work_curves
from ropewalk.plots.sight import good_frames
from ropewalk.plots.style import set_title
from ropewalk.plots.tensions import colour_scale, open_ends, thinned
from ropewalk.record.simulate import simulate_in_memory
from ropewalk.scene import Scene, apply_overrides
from ropewalk.scene.presets import preset

OF_CONTACTS = ("contact", "sticking")  # see test_plots_of_obstacles
UNIT = re.compile(r"\[(s|m|m/s|[pnµmkMG]?(N|J))\]")


@pytest.fixture(scope="module")
def three_anchors():
    return simulate_in_memory(apply_overrides(preset("r4"), ["run.duration=2.0"]))


@pytest.fixture(scope="module")
def broken():
    """The report's stiff rope at one step a frame, recorded on until it is NaN."""
    scene = apply_overrides(preset("r6"), ["run.duration=3.0"])
    result = simulate_in_memory(scene, keep_going=True)
    assert not np.isfinite(result.positions[-1]).all()
    assert np.nanmax(np.abs(result.positions)) > 1e100
    return result


@pytest.fixture(scope="module")
def many_ropes():
    ropes = [
        {
            "name": f"rope{i}",
            "segments": 4 + i,
            "made_of": {
                "kind": "springs",
                "spring_constant": 100.0,
                "node_mass": 0.1,
                "segment_length": 0.2,
            },
            "shape": {"kind": "straight", "start": [0.0, 0.3 * i, 0.0]},
        }
        for i in range(8)
    ]
    scene = Scene.model_validate(
        {
            "name": "eight $ropes$",
            "run": {"duration": 0.5, "time_step": 0.002},
            "rope": ropes,
            "anchor": [{"rope": f"rope{i}", "node": 0} for i in range(8)],
            "ground": {"height": -1.0},
        }
    )
    return simulate_in_memory(scene)


def line(axes, label):
    """The one line of that name."""
    (found,) = [item for item in axes.lines if item.get_label() == label]
    return found


@pytest.mark.parametrize("name", list(plots.PLOTS))
@pytest.mark.parametrize("case", ["three_anchors", "broken", "many_ropes"])
def test_every_figure_draws_and_labels_with_units(name, case, request, tmp_path):
    result = request.getfixturevalue(case)
    if not plots.PLOTS[name].there(result):
        with pytest.raises(ValueError, match="it needs obstacles"):
            plots.PLOTS[name].draw(result)
        return
    figure = plots.PLOTS[name].draw(result)
    assert isinstance(figure, Figure)
    path = plots.save(figure, tmp_path / f"{name}.png", dpi=50)
    assert path.read_bytes().startswith(b"\x89PNG")
    labels = [text for a in figure.axes for text in (a.get_xlabel(), a.get_ylabel()) if text]
    assert len(labels) >= 2
    assert all(UNIT.search(text) for text in labels), labels
    assert figure._suptitle.get_text().startswith(result.scene.name[:5])


@pytest.mark.parametrize("name", [name for name in plots.PLOTS if name not in OF_CONTACTS])
def test_broken_runs_keep_the_axes_at_the_good_part_and_say_so(name, broken):
    figure = plots.PLOTS[name].draw(broken)
    assert "broke after t =" in figure._supxlabel.get_text()
    for axes in figure.axes:
        assert np.isfinite([*axes.get_xlim(), *axes.get_ylim()]).all()
        assert max(map(abs, (*axes.get_xlim(), *axes.get_ylim()))) < 1e8
        for item in axes.lines:
            data = np.asarray(item.get_ydata(), dtype=float)
            assert np.abs(data[np.isfinite(data)]).max(initial=0.0) < 1e10


def test_the_figure_of_forces_says_when_they_act(three_anchors, broken):
    """A run's last frame is no rest, and is not called so."""
    rest = equilibrium(three_anchors.scene)
    for result, when in (
        (rest, "at rest"),
        (three_anchors, "forces at t = 2 s"),
        (broken, f"forces at t = {broken.time[good_frames(broken) - 1]:.4g} s"),
    ):
        title = plots.forces(result)._suptitle.get_text().rstrip()
        assert title == f"{result.scene.name}: {when}"


def test_sound_runs_carry_no_such_note(three_anchors):
    assert plots.shape(three_anchors)._supxlabel is None


def test_shape_shows_the_positions_at_the_nearest_frames(three_anchors):
    axes = plots.shape(three_anchors, times=[0.0, 2.0]).axes[0]
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("x [m]", "y [m]")
    assert axes.get_aspect() == 1.0
    for time in (0.0, 2.0):
        frame = three_anchors.frame_at(time)
        drawn = line(axes, f"{time:.4g} s")
        np.testing.assert_array_equal(drawn.get_xdata(), three_anchors.positions[frame, :, 0])
        np.testing.assert_array_equal(drawn.get_ydata(), three_anchors.positions[frame, :, 1])


def test_shape_takes_another_plane_and_refuses_what_is_none(three_anchors):
    axes = plots.shape(three_anchors, times=[1.0], plane="zy").axes[0]
    assert axes.get_xlabel() == "z [m]"
    with pytest.raises(ValueError, match="plane: 'xx' - must be two of x, y and z"):
        plots.shape(three_anchors, plane="xx")


def test_times_outside_the_run_are_refused(three_anchors):
    with pytest.raises(ValueError, match="times: 3.0 - must be within the run, 0 to 2 s"):
        plots.shape(three_anchors, times=[3.0])


def test_film_shows_the_chosen_frames(three_anchors):
    figure = plots.film(three_anchors, frames=[0, 60, 120])
    stamps = [axes.get_title(loc="left") for axes in figure.axes if axes.get_visible()]
    assert stamps == ["t = 0 s", "t = 1 s", "t = 2 s"]
    for frame, axes in zip((0, 60, 120), figure.axes, strict=False):
        np.testing.assert_array_equal(
            line(axes, "rope").get_ydata(), three_anchors.positions[frame, :, 1]
        )
    limits = {(*axes.get_xlim(), *axes.get_ylim()) for axes in figure.axes}
    assert len(limits) == 1
    with pytest.raises(ValueError, match="frames 0 to 120"):
        plots.film(three_anchors, frames=[500])


def test_height_shows_nodes_by_number_and_by_rope(three_anchors, many_ropes):
    axes = plots.height(three_anchors, nodes=[10, -1]).axes[0]
    np.testing.assert_array_equal(line(axes, "node 10").get_xdata(), three_anchors.time)
    np.testing.assert_array_equal(
        line(axes, "node 10").get_ydata(), three_anchors.positions[:, 10, 1]
    )
    assert line(axes, "node 40 (end)")
    axes = plots.height(many_ropes, nodes=["rope2:-1", ("rope0", 1)]).axes[0]
    index = many_ropes.layout.node(-1, "rope2")
    drawn = line(axes, "rope2, node 6 (end)").get_ydata()
    np.testing.assert_array_equal(drawn, many_ropes.positions[:, index, 2])
    with pytest.raises(ValueError, match=r"node: 41 - rope 'rope' has the nodes 0 to 40, not 41"):
        plots.height(three_anchors, nodes=[41])
    with pytest.raises(ValueError, match=r"node: 'x' - must be a number"):
        plots.height(three_anchors, nodes=["x"])


def test_default_heights_are_middles_between_anchors(three_anchors):
    labels = [item.get_label() for item in plots.height(three_anchors).axes[0].lines]
    assert labels == ["node 10", "node 30"]


def test_tension_image_is_the_tension_over_arc_length(three_anchors):
    figure = plots.tension(three_anchors, times=[1.0])
    (image,) = figure.axes[0].images
    peaks, lows = three_anchors.greatest_tension, three_anchors.least_tension
    farthest = np.where(np.abs(lows) > np.abs(peaks), lows, peaks)
    np.testing.assert_array_equal(image.get_array(), farthest.T)
    time = three_anchors.time
    interval = time[-1] / (len(time) - 1)  # a column is of the steps that end at its frame
    assert image.get_extent() == pytest.approx([-interval, time[-1], 0.0, 40.0], abs=1e-9)
    profile = figure.axes[1].lines[0]
    np.testing.assert_array_equal(profile.get_ydata(), three_anchors.tension[60])
    np.testing.assert_allclose(profile.get_xdata(), np.arange(40) + 0.5)
    labels = [axes.get_ylabel() for axes in figure.axes]
    assert "tension, largest since the frame before [N]" in labels
    assert "tension [N]" in labels
    (band,) = figure.axes[1].collections
    high = band.get_paths()[0].vertices[:, 1].max()
    assert high == three_anchors.greatest_tension.max()


def test_heights_lie_in_the_band_of_all_steps(three_anchors):
    figure = plots.height(three_anchors, nodes=[20])
    (band,) = figure.axes[0].collections
    corners = band.get_paths()[0].vertices[:, 1]
    assert corners.max() == three_anchors.greatest_height[:, 20].max()
    assert corners.min() == three_anchors.least_height[:, 20].min()


@pytest.mark.parametrize("kind", ["tension", "forces", "reactions"])
def test_large_forces_are_labelled_in_kilonewtons(kind: str) -> None:
    """The same rope ten thousand times as heavy and stiff: the numbers at its axes stay small."""

    def labels(factor: float) -> tuple[list[str], set[str]]:
        made_of = {"spring_constant": 1e4, "node_mass": 0.05, "spring_friction": 0.05}
        changes = {f"rope.made_of.{name}": factor * value for name, value in made_of.items()}
        scene = runs.hanging(duration=0.2).replace(**changes, **{"air.node_drag": 0.02 * factor})
        figure = getattr(plots, kind)(simulate_in_memory(scene))
        figure.draw_without_rendering()
        axes = [one for one in figure.axes if one.get_ylabel().endswith("N]")]
        ticks = {tick.get_text() for one in axes for tick in one.get_yticklabels()}
        return [one.get_ylabel() for one in axes], ticks

    small, large = labels(1.0), labels(1e4)
    assert any(name.endswith("[N]") for name in small[0])
    assert not any("kN" in name for name in small[0])
    assert any(name.endswith("[kN]") for name in large[0])
    assert not any(name.endswith("[N]") for name in large[0])
    assert all(abs(float(tick.replace("−", "-"))) < 1000.0 for tick in large[1])


def test_one_spike_does_not_bleach_the_tension_map():
    values = np.linspace(0.0, 10.0, 10_000).reshape(100, 100)
    values[3, 3] = 1e6
    scale, colours, extend = colour_scale([values])
    assert (scale.vmin, colours, extend) == (0.0, "viridis", "max")
    assert 9.9 < scale.vmax < 10.1
    beyond = [(0.0, 10.0), (0.0, 11.0), (-1.0, 10.0), (-1.0, 11.0), (math.nan, math.nan)]
    names = ["neither", "max", "min", "both", "neither"]
    assert [open_ends(scale, *ends) for ends in beyond] == names


def test_colours_diverge_from_zero_where_the_rope_pushes():
    scale, colours, _ = colour_scale([np.linspace(-5.0, 10.0, 1000)])
    assert colours == "RdBu_r"
    assert scale.vmin == -scale.vmax


def test_thinning_keeps_the_largest_tension():
    values = np.zeros((20_000, 3))
    values[12_345, 1] = -7.0
    out = thinned(values)
    assert out.shape[0] <= 1600
    assert out.min() == -7.0
    assert np.count_nonzero(out) == 1


def test_tension_of_a_winch_rope_ends_where_the_rope_ends():
    changes = ["run.duration=2.0", "run.time_step=0.00005"]
    result = simulate_in_memory(apply_overrides(preset("h3"), changes))
    (image,) = plots.tension(result).axes[0].images
    shown = ~np.ma.getmaskarray(np.ma.masked_invalid(image.get_array()))
    paid = result.rest_length.sum(axis=1)
    step = image.get_extent()[3] / shown.shape[0]
    np.testing.assert_allclose(shown.sum(axis=0) * step, paid, atol=step)
    assert paid[-1] > paid[0] + 2.5


def test_energy_curves_and_error_are_the_results(three_anchors):
    upper, lower = plots.energy(three_anchors).axes[:2]
    energy, work = three_anchors.energy, three_anchors.work
    np.testing.assert_array_equal(line(upper, "kinetic").get_ydata(), energy["kinetic"])
    np.testing.assert_array_equal(line(upper, "gravity").get_ydata(), energy["gravity"])
    np.testing.assert_allclose(line(upper, "total").get_ydata(), energy["total"], atol=1e-12)
    np.testing.assert_array_equal(line(upper, "work of friction").get_ydata(), work["friction"])
    moved = line(upper, "work of anchor left").get_ydata()
    np.testing.assert_array_equal(moved, work["anchor:left"])
    np.testing.assert_array_equal(
        line(lower, "energy error").get_ydata(), three_anchors.energy_error
    )
    labels = [item.get_label() for item in upper.lines]
    assert "work of air" not in labels  # there is none
    assert "work of anchor middle" not in labels  # it does not move


def test_works_are_told_in_whole_words():
    """The work of what a hand applies was called "work of applied"."""
    parts = {"applied": np.ones(3), "air": np.ones(3), "anchor:a $": np.ones(3)}
    found = work_curves(SimpleNamespace(work=parts, contact_work={}), 3)
    assert set(found) == {"work of applied forces", "work of air", r"work of anchor a \$"}


def test_gravity_is_left_out_where_there_is_none():
    scene = apply_overrides(preset("wave-on-a-string"), ["run.duration=0.2"])
    assert "gravity" not in energy_curves(simulate_in_memory(scene))


def test_phase_shows_velocity_against_position(three_anchors):
    figure = plots.phase(three_anchors, 10, "y")
    axes = figure.axes[0]
    pieces = np.array(axes.collections[0].get_segments())
    np.testing.assert_array_equal(pieces[:, 0, 0], three_anchors.positions[:-1, 10, 1])
    np.testing.assert_array_equal(pieces[:, 1, 1], three_anchors.velocities[1:, 10, 1])
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("position y [m]", "velocity y [m/s]")
    with pytest.raises(ValueError, match="axis: 'w' - must be x, y, z or up"):
        plots.phase(three_anchors, 10, "w")


def test_reactions_show_components_and_magnitude(three_anchors, many_ropes):
    figure = plots.reactions(three_anchors)
    left = three_anchors.reactions[:, 0]
    np.testing.assert_array_equal(line(figure.axes[0], "y").get_ydata(), left[:, 1])
    size = np.linalg.norm(left, axis=1)
    np.testing.assert_allclose(line(figure.axes[0], "magnitude").get_ydata(), size, rtol=1e-12)
    most = line(figure.axes[0], "largest of all steps")
    np.testing.assert_array_equal(
        most.get_ydata(), three_anchors.read("greatest_reactions", 0, three_anchors.frames)[:, 0]
    )
    assert most.get_drawstyle() == "steps-pre"
    opposite = plots.reactions(three_anchors, on_anchors=True)
    np.testing.assert_array_equal(line(opposite.axes[0], "y").get_ydata(), 0.0 - left[:, 1])
    assert figure._supxlabel.get_text().startswith("Forces of the anchors on the ropes.")
    assert opposite._supxlabel.get_text().startswith("Forces of the ropes on the anchors.")
    together = plots.reactions(many_ropes)
    assert len(together.axes) == 1
    assert len([a for a in together.axes[0].lines if not a.get_label().startswith("_")]) == 8


@pytest.mark.parametrize(
    ("ending", "start"), [("svg", b"<?xml"), ("pdf", b"%PDF"), ("png", b"\x89P")]
)
def test_files_are_written_and_equal_for_equal_figures(ending, start, three_anchors, tmp_path):
    texts = []
    for number in range(2):
        figure = plots.energy(three_anchors)
        texts.append(plots.save(figure, tmp_path / f"{number}.{ending}").read_bytes())
    assert texts[0] == texts[1]
    assert texts[0].startswith(start)
    assert sorted(p.name for p in tmp_path.iterdir()) == [f"0.{ending}", f"1.{ending}"]


def test_other_endings_are_refused(three_anchors, tmp_path):
    with pytest.raises(ValueError, match=r"must end in .png, .svg or .pdf"):
        plots.save(plots.height(three_anchors), tmp_path / "a.xls")
    assert not list(tmp_path.iterdir())


def test_figures_need_no_pyplot():
    code = (
        "import sys; from ropewalk import plots; from ropewalk.scene.presets import preset; "
        "from ropewalk.record.simulate import simulate_in_memory as run; "
        "from ropewalk.scene import apply_overrides as but; "
        "plots.shape(run(but(preset('r2'), ['run.duration=0.1']))); "
        "sys.exit('matplotlib.pyplot' in sys.modules)"
    )
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


def test_a_long_name_is_cut_and_what_is_shown_is_not():
    """The figure of contacts of a scene with a long name did not say at which time: "contact at t =..."."""
    for name in ("a $long$ name " * 20, "no end", "a: b: " * 30):
        figure = Figure(figsize=(6.0, 4.0), layout="constrained")
        set_title(figure, f"{name}: contact at t = 1.25 s", "")
        title = figure._suptitle.get_text().strip()
        assert title.endswith(": contact at t = 1.25 s")
        assert len(title) <= 70
        assert title.startswith(name.split(" ")[0])
