"""Runs compared: exactly zero with itself, the true distance otherwise, or a reason why not."""

from __future__ import annotations

import math

import numpy as np
import pytest

from ropewalk import plots
from ropewalk.analysis.compare import compare_runs, differing_settings, distance, resample
from ropewalk.record.simulate import simulate_in_memory
from ropewalk.scene import apply_overrides
from ropewalk.scene.presets import preset
from runs import breaking, hanging

SHORT = ["run.duration=1.0"]


def run(name, *changes, keep_going=False):
    scene = apply_overrides(preset(name), [*SHORT, *changes])
    return simulate_in_memory(scene, keep_going=keep_going)


@pytest.fixture(scope="module")
def reference():
    return run("r4")


def test_a_run_lies_at_no_distance_from_itself(reference):
    found = distance(reference, run("r4"))
    assert found.time.size == reference.frames
    assert not found.largest.any()
    assert not found.rms.any()
    assert found.worst == 0.0


def test_another_method_gives_the_distance_of_the_positions(reference):
    other = run("r4", "run.method=rk4")
    found = distance(reference, other)
    gap = np.linalg.norm(reference.positions - other.positions, axis=2)
    np.testing.assert_allclose(found.largest, gap.max(axis=1), rtol=1e-12, atol=1e-15)
    assert found.worst > 1e-4
    assert found.when == reference.time[gap.max(axis=1).argmax()]


def test_frame_rates_may_differ(reference):
    """Equal steps recorded at 60 and 20 frames a second: zero at common frames, from either side."""
    rare = run("r4", "run.frame_rate=20", "run.time_step=0.0018519")
    assert rare.plan.dt == pytest.approx(reference.plan.dt, rel=1e-12)
    back = distance(rare, reference)
    assert back.time.size == 21
    assert back.worst < 1e-9  # round-off of the step length, grown over 540 steps
    there = distance(reference, rare)
    assert there.time.size == 21  # at those of the first lines between frames lay beside the rope
    assert there.worst < 1e-9
    assert there.way == "node by node"


def test_between_frames_ropes_go_on_smoothly(reference):
    """At 27 frames a second only every ninth time is a frame of the other run; the motion is the same."""
    rare = run("r4", "run.frame_rate=27", "run.time_step=0.0018519", "run.duration=0.4")
    found = distance(reference, rare)
    assert found.way == "node by node, between frames of one run"
    moments = rare.time
    low = np.clip(np.searchsorted(reference.time, moments + 1e-9) - 1, 0, reference.frames - 2)
    share = ((moments - reference.time[low]) * 60.0)[:, None, None]
    a, b = reference.positions[low], reference.positions[low + 1]
    linear = np.linalg.norm(a + share * (b - a) - rare.positions, axis=2).max()
    assert found.worst < 0.5 * linear
    assert found.largest[::9].max() < 1e-9 < found.worst


def test_numbers_of_nodes_may_differ():
    """At first both lie on one catenary; then they move apart by what the cut changes."""
    coarse = run("hanging-rope", "rope.segments=20")
    fine = run("hanging-rope", "rope.segments=40")
    found = distance(coarse, fine)
    assert "equal shares" in found.way
    assert found.largest[0] < 1e-9 < found.worst < 0.5
    gap = np.linalg.norm(coarse.positions - fine.positions[:, ::2], axis=2).max(axis=1)
    np.testing.assert_allclose(found.largest, gap, rtol=1e-9, atol=1e-12)


def test_resampling_keeps_ends_and_straight_lines():
    points = np.linspace(0.0, 1.0, 11)[None, :, None] * np.array([3.0, 4.0, 0.0])
    out = resample(points, 5)
    np.testing.assert_allclose(out[0, :, 0], [0.0, 0.75, 1.5, 2.25, 3.0], atol=1e-15)
    np.testing.assert_array_equal(out[0, [0, -1]], points[0, [0, -1]])


def test_where_there_is_no_distance_it_says_why(reference):
    two = simulate_in_memory(two_ropes())
    found = distance(reference, two)
    assert not found.defined
    assert math.isnan(found.worst)
    assert found.note == "not defined: 1 ropes and 2"
    rows = compare_runs([reference, two], ["a", "b"]).rows
    assert rows[1]["compared"] == "not defined: 1 ropes and 2"
    assert plots.compare([reference, two], ["a", "b"]).axes


def two_ropes():
    scene = apply_overrides(preset("r2"), SHORT)
    rope = scene.ropes[0]
    twin = rope.model_copy(update={"name": "twin"})
    data = scene.model_dump(by_alias=True)
    data["rope"] = [rope.model_dump(by_alias=True), twin.model_dump(by_alias=True)]
    return type(scene).model_validate(data)


def test_a_broken_run_is_compared_up_to_its_break(reference):
    broken = run("r6", keep_going=True)
    found = distance(reference, broken)
    assert found.time[-1] < 0.2
    assert np.isfinite(found.largest).all()
    assert "until one run broke" in found.note


def test_a_break_after_the_common_time_is_not_told():
    """The end of the shorter run, a sound one, was told to be when the longer one broke."""
    broken = simulate_in_memory(breaking(duration=1.0), keep_going=True)
    late = broken.broke_at
    assert broken.status == "broke"
    short, long = (
        simulate_in_memory(hanging(time_step=1 / 60, spring_constant=3.0, duration=duration))
        for duration in (0.5 * late, 1.0)
    )
    for pair in ((short, broken), (broken, short)):
        assert distance(*pair).note == ""
    assert distance(long, broken).note.endswith(f"until one run broke at {late:.4g} s")


def test_rows_hold_the_numbers_of_the_runs(reference):
    other = run("r4", "rope.made_of.spring_friction=0.5")
    found = compare_runs([reference, other], ["little", "much"])
    first, second = found.rows
    assert (first["run"], second["run"]) == ("little", "much")
    assert first["largest tension [N]"] == reference.greatest_tension.max()
    assert second["energy change [J]"] == other.energy["total"][-1] - other.energy["total"][0]
    assert second["largest energy error [J]"] == np.abs(other.energy_errors).max()
    assert second["largest distance [m]"] == found.distances[0].largest.max() > 0.0
    assert found.settings == (("rope[0].made_of.spring_friction", ("0.05", "0.5")),)


def test_settings_that_differ_are_listed_by_path():
    scenes = [preset("r4"), apply_overrides(preset("r4"), ["run.method=rk4", "ground.height=-9"])]
    found = dict(differing_settings(scenes))
    assert found["run.method"] == ("semi-implicit-euler", "rk4")
    assert found["ground.height"] == ("-", "-9")
    assert "name" not in found


def test_settings_that_differ_look_different():
    """Three times 0.05 was listed as what differs."""
    mass = "rope.made_of.node_mass"
    scenes = [
        apply_overrides(preset("r4"), [f"{mass}={value}"]) for value in ("0.05", "0.050000001")
    ]
    found = dict(differing_settings(scenes))
    assert found["rope[0].made_of.node_mass"] == ("0.05", "0.050000001")


def test_figure_shows_shapes_distance_and_energies(reference):
    other = run("r4", "run.method=rk4")
    figure = plots.compare([reference, other], ["one", "two"], times=[0.0, 1.0])
    titles = [axes.get_title(loc="left") for axes in figure.axes]
    assert titles[:2] == ["one", "two"]
    labels = [axes.get_ylabel() for axes in figure.axes]
    assert any(text.startswith("largest node distance [") for text in labels)
    distances, kinetic = figure.axes[2].lines[0], figure.axes[3].lines
    np.testing.assert_array_equal(distances.get_ydata(), distance(reference, other).largest)
    np.testing.assert_array_equal(kinetic[0].get_ydata(), reference.energy["kinetic"])
    np.testing.assert_array_equal(kinetic[1].get_ydata(), other.energy["kinetic"])
    shape = next(item for item in figure.axes[1].lines if item.get_label() == "1 s")
    np.testing.assert_array_equal(shape.get_ydata(), other.positions[60, :, 1])


def test_shapes_of_one_colour_are_of_one_time():
    """Of other runs the nearest frame stood there; and runs of few frames have places at these only."""
    few, odd, many = (
        simulate_in_memory(hanging(duration=0.4, frame_rate=rate, segments=4))
        for rate in (20, 30, 100)
    )
    for results in ([few, odd, many], [odd, many, few]):
        figure = plots.compare(results, ["a", "b", "c"], times=[0.24, 0.36])
        for time in (0.25, 0.35):  # frames of the run that has fewest
            exact = few.positions[few.frame_at(time)][:, [0, 2]]
            for axes in figure.axes[:3]:
                rope, anchors = (
                    np.stack([item.get_xdata(), item.get_ydata()], axis=1)
                    for item in axes.lines
                    if item.get_color() == line(axes, f"{time:g} s").get_color()
                )
                np.testing.assert_allclose(rope, exact, atol=0.002)
                np.testing.assert_array_equal(anchors, rope[[0, -1]])
    nearest = odd.positions[odd.frame_at(0.25)]
    assert np.abs(nearest - many.positions[25]).max() > 0.008


def line(axes, label):
    """The one line of that name."""
    (found,) = [item for item in axes.lines if item.get_label() == label]
    return found


def test_what_cannot_be_compared_is_refused(reference):
    with pytest.raises(ValueError, match="must be at least two runs"):
        compare_runs([reference])
    with pytest.raises(ValueError, match="must be 2 different names"):
        compare_runs([reference, reference], ["a", "a"])
