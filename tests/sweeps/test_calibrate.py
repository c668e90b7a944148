"""Fits recover what made the measurements, with intervals that hold what they promise."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.lowering import build
from ropewalk.record.errors import InputError, RunError
from ropewalk.sweeps.identify import identify
from ropewalk.sweeps.measurements import offsets
from ropewalk.sweeps.misfit import runs_of_signs

EA, LENGTH = "rope.made_of.EA", "rope.length"


def hung(segments: int = 10, **changes: Any) -> rw.Scene:
    """A rope that hangs between two points, soft enough to show its stiffness."""
    from ropewalk.scene import Slack

    material = rw.Material(EA=800.0, mass_per_length=1.0, axial_damping=5.0)
    rope = rw.Rope(
        segments=segments, length=5.0, made_of=material, shape=Slack(end=(4.0, 0.0, 0.5))
    )
    run = rw.RunSettings(duration=0.4, time_step=0.002)
    scene = rw.Scene(ropes=[rope], anchors=[rw.Anchor(node=0), rw.Anchor(node=-1)], run=run)
    return scene.replace(**changes) if changes else scene


def test_sag_gives_the_length() -> None:
    true = rw.equilibrium(hung())
    measured = rw.sweep.function(hung(), [LENGTH], "sag[-1]", what="rest")([[5.1]])[0, 0]
    fit = rw.calibrate(hung(), rw.calibrate.sag(measured, error=1e-4), {LENGTH: (4.5, 6.0)})
    assert fit.values[LENGTH] == pytest.approx(5.1, abs=1e-6)
    low, high = fit.intervals[LENGTH]
    assert low < 5.1 < high
    assert fit.profile[LENGTH] == pytest.approx((low, high), abs=0.02 * (high - low))
    assert fit.scene.ropes[0].length == fit.values[LENGTH]
    assert true.positions.shape == (1, 11, 3)


def test_a_pull_test_has_the_intervals_of_a_straight_line() -> None:
    """Elongations e = F L / EA: a fit in 1/EA, whose variance is that of a line through the origin."""
    forces = np.linspace(50.0, 500.0, 10)
    noise = np.random.default_rng(2).normal(0.0, 1e-3, 10)
    e = forces * 5.0 / 800.0 + noise
    fit = rw.calibrate(hung(), rw.calibrate.pull_test(forces, e, error=1e-3), {EA: (500.0, 1500.0)})
    slope = (forces * 5.0) @ e / ((forces * 5.0) @ (forces * 5.0))
    assert fit.values[EA] == pytest.approx(1.0 / slope, rel=1e-6)
    deviation = 1e-3 / math.sqrt((forces * 5.0) @ (forces * 5.0)) / slope**2
    low, high = fit.intervals[EA]
    assert 0.5 * (high - low) == pytest.approx(1.6449 * deviation, rel=1e-3)
    assert fit.residuals["pull test"].shape == (10,)


def coverage(one: Any, count: int) -> tuple[float, float]:
    """How often the 90 % intervals of covariance and profile hold the truth, of `count` fits."""
    inside = np.array([one(np.random.default_rng(seed)) for seed in range(count)])
    return tuple(inside.mean(axis=0))


@pytest.mark.slow
def test_intervals_of_90_percent_hold_85_to_95_of_100_with_a_known_error() -> None:
    scene, error = hung(6), 2e-3
    at_rest = rw.equilibrium(scene).positions[0]
    arc = at_rest[:-1] + 0.37 * np.diff(at_rest, axis=0)

    def one(dice: np.random.Generator) -> tuple[bool, bool]:
        points = (arc + dice.normal(0.0, error, arc.shape))[:, [0, 2]]
        measured = rw.calibrate.shape(points, error, axes="xz")
        fit = rw.calibrate(scene, measured, {LENGTH: (4.8, 5.3)}, starts=2)
        return tuple(
            low <= 5.0 <= high for low, high in (fit.intervals[LENGTH], fit.profile[LENGTH])
        )

    for share in coverage(one, 100):
        assert 0.85 <= share <= 0.95


@pytest.mark.slow
def test_intervals_hold_85_to_95_of_100_with_an_error_that_is_not_known() -> None:
    forces = np.linspace(50.0, 500.0, 6)

    def one(dice: np.random.Generator) -> tuple[bool, bool]:
        e = forces * 5.0 / 800.0 + dice.normal(0.0, 2e-3, 6)
        fit = rw.calibrate(
            hung(), rw.calibrate.pull_test(forces, e), {EA: (400.0, 1600.0)}, starts=2
        )
        return tuple(low <= 800.0 <= high for low, high in (fit.intervals[EA], fit.profile[EA]))

    for share in coverage(one, 100):
        assert 0.85 <= share <= 0.95


@pytest.mark.slow
def test_what_one_measurement_cannot_tell_apart_is_said_and_two_do() -> None:
    """Sag alone fixes a combination of stiffness and length; a pull test besides fixes both."""
    true = rw.sweep.function(hung(), [LENGTH], "sag[-1]", what="rest")([[5.0]])[0, 0]
    sag = rw.calibrate.sag(true, error=1e-4)
    ranges = {EA: (400.0, 1600.0), LENGTH: (4.8, 5.2)}
    alone = rw.calibrate(hung(), sag, ranges)
    assert "EA and length cannot be told apart by this measurement." in alone.words
    assert alone.intervals[EA] == pytest.approx((400.0, 1600.0))
    forces = np.linspace(20.0, 200.0, 8)
    pull = rw.calibrate.pull_test(forces, forces * 2.0 / 800.0, error=1e-4, length=2.0)
    both = rw.calibrate(hung(), [sag, pull], ranges)
    assert "The cutting into segments may put length off" in both.words[-1]  # 5 mm of sag
    assert not any("cannot be told apart" in text for text in both.words)
    assert both.values[EA] == pytest.approx(800.0, rel=1e-4)
    assert both.values[LENGTH] == pytest.approx(5.0, abs=1e-4)
    true = rw.sweep.function(hung(40), [LENGTH], "sag[-1]", what="rest")([[5.0]])[0, 0]
    sag = rw.calibrate.sag(true, error=1e-3)
    pull = rw.calibrate.pull_test(forces, forces * 2.0 / 800.0, error=1e-3, length=2.0)
    fine = rw.calibrate(hung(40), [sag, pull], ranges, profile=False)
    assert fine.words[-1].startswith("Near this fit the measurement tells all of them apart. In ")


def pulled(bend: float, seed: int = 3) -> tuple[np.ndarray, np.ndarray]:
    """Forces and elongations with an error of 1 mm; with `bend` the rope gets stiffer as it is pulled."""
    forces = np.linspace(50.0, 500.0, 12)
    noise = np.random.default_rng(seed).normal(0.0, 1e-3, 12)
    return forces, forces * 5.0 / 800.0 * (1.0 - bend * forces / 500.0) + noise


def pull_words(bend: float, error: float | None) -> str:
    """What a fit of EA says of such a test."""
    pull = rw.calibrate.pull_test(*pulled(bend), error)
    fit = rw.calibrate(hung(), pull, {EA: (400.0, 1600.0)}, starts=2, profile=False)
    return " ".join(fit.words)


def test_a_model_that_fits_is_told_from_one_that_does_not() -> None:
    """By hand: the root of the mean square of residual over error, with 11 degrees of freedom."""
    forces, e = pulled(0.2)
    slope = (forces @ e) / (forces @ forces)
    size = math.sqrt((((e - slope * forces) / 1e-3) ** 2).sum() / 11.0)
    assert size > 30.0
    assert (
        f"The model does not fit: residuals are {size:.2g} times the stated uncertainty" in
        pull_words(0.2, 1e-3)
    )  # fmt: skip
    assert "The model fits: residuals are " in pull_words(0.0, 1e-3)
    assert "does not fit" not in pull_words(0.0, 1e-3)
    assert "stated too large" in pull_words(0.0, 0.1)


def test_without_a_stated_error_the_order_of_the_residuals_tells() -> None:
    bent, straight = pull_words(0.2, None), pull_words(0.0, None)
    for told in (bent, straight):
        assert "No uncertainty was stated: it is taken from the residuals" in told
    assert "Residuals of pull test keep their sign in rows (2 of them" in bent
    assert "in rows" not in straight


def test_rows_of_signs_have_the_chance_of_all_orders() -> None:
    """Counted over all orders of five and four signs."""
    from itertools import combinations

    orders = []
    for places in combinations(range(9), 5):
        signs = -np.ones(9)
        signs[list(places)] = 1.0
        orders.append(signs)
    rows = np.array([1 + (np.diff(one) != 0.0).sum() for one in orders])
    for one in orders:
        found, chance = runs_of_signs(one)
        assert chance == pytest.approx((rows <= found).mean())
    assert runs_of_signs(np.ones(8)) == (1, 2.0**-7)


def test_a_bound_that_stops_a_fit_is_no_good_fit() -> None:
    fit = rw.calibrate(
        hung(), rw.calibrate.sag(3.0, error=0.01), {LENGTH: (4.8, 5.2)}, starts=2, profile=False
    )
    assert fit.words[0].startswith("The model does not fit: residuals are ")
    assert repr(fit).startswith("Fitted to 1 number:")


def test_what_does_not_show_is_said() -> None:
    sag = rw.calibrate.sag([1.2, 1.21], error=0.01)
    fit = rw.calibrate(
        hung(), sag, {LENGTH: (4.5, 6.0), "rope.made_of.axial_damping": (1.0, 10.0)}, profile=False
    )
    assert "axial_damping does not show in this measurement." in fit.words


def test_identify_against_a_linear_problem() -> None:
    j = np.array([[1.0, 0.0], [0.0, 2.0], [1.0, 2.0], [3.0, 0.0]]) * 30.0
    r = np.array([1.0, -1.0, 0.5, 0.0])
    found = identify(j, r, False, 0.9, ["a", "b"])
    covariance = (r @ r / 2.0) * np.linalg.inv(j.T @ j)
    np.testing.assert_allclose(found.deviation, np.sqrt(np.diag(covariance)))
    assert found.quantile == pytest.approx(2.919986)  # Student's t, 95 % of 2 degrees of freedom
    known = identify(j, r, True, 0.9, ["a", "b"])
    np.testing.assert_allclose(known.deviation, np.sqrt(np.diag(np.linalg.inv(j.T @ j))))


def test_a_tracked_video_gives_damping_and_mass(tmp_path: Path) -> None:
    path = "rope.made_of.axial_damping"
    scene = hung(anchors=[rw.Anchor(node=0)])
    true = rw.simulate(scene.replace(ropes=[scene.ropes[0].replace(
        made_of=scene.ropes[0].made_of.replace(axial_damping=8.0))]))  # fmt: skip
    rows = np.column_stack([true.time, true.positions[:, -1, 0], true.positions[:, -1, 2]])[1::2]
    text = "\n".join(",".join(f"{v:.9f}" for v in row) for row in rows)
    (tmp_path / "track.csv").write_text(f"time,x,z\n{text}\n")
    fit = rw.calibrate(
        scene, rw.calibrate.track(tmp_path / "track.csv", error=1e-4), {path: (0.5, 50.0)},
        starts=2, profile=False,
    )  # fmt: skip
    assert fit.values[path] == pytest.approx(8.0, rel=1e-4)


def test_droop_and_swing_are_those_of_the_scene() -> None:
    scene = hung(anchors=[rw.Anchor(node=0)])
    fall = rw.equilibrium(scene).positions[0]
    droop = rw.calibrate.droop(fall[0, 2] - fall[-1, 2], error=1e-4)
    fit = rw.calibrate(scene, droop, {EA: (400.0, 1600.0)}, starts=2, profile=False)
    assert fit.values[EA] == pytest.approx(800.0, rel=1e-3)
    period = 1.0 / rw.modes(scene, count=1).frequencies[0]
    swing = rw.calibrate.swing(period, error=1e-4)
    fit = rw.calibrate(scene, swing, {LENGTH: (4.0, 6.0)}, starts=2, profile=False)
    assert fit.values[LENGTH] == pytest.approx(5.0, rel=1e-4)


def test_what_a_sweep_keeps_can_be_fitted() -> None:
    f = rw.sweep.function(hung(), ["rope.made_of.mass_per_length"], "reactions.max")
    measured = f([[1.3]])[0]
    fit = rw.calibrate(
        hung(), {"reactions.max": (measured, 0.01)}, {"rope.made_of.mass_per_length": (0.5, 3.0)},
        starts=2, profile=False,
    )  # fmt: skip
    assert fit.values["rope.made_of.mass_per_length"] == pytest.approx(1.3, rel=1e-5)


@pytest.mark.parametrize("error", [True, "1 mm", [0.01, 0.02], 0.0, float("nan"), float("inf")])
def test_an_error_is_one_positive_number(error: Any) -> None:
    with pytest.raises(InputError, match="must be a positive standard deviation"):
        rw.calibrate.kept("reactions.max", 7.0, error)


def test_a_measurement_of_another_size_is_refused() -> None:
    """Two anchors have two largest reactions; one number cannot stand for both."""
    one = rw.calibrate.kept("reactions.max", 7.0, 0.1)
    two = {"reactions_max": np.array([7.0, 8.0])}
    with pytest.raises(InputError, match="'1 measured' - the scene gives 2 numbers"):
        one.predicted(two, {}, hung())
    often = rw.calibrate.kept("reactions.max", [7.0, 7.1, 6.9], 0.1)
    with pytest.raises(InputError, match="'3 measured' - the scene gives 2 numbers"):
        often.predicted(two, {}, hung())
    again = rw.calibrate.sag([1.2, 1.3]).predicted({}, {"sag_last": np.array([1.25])}, hung())
    np.testing.assert_array_equal(again, [1.25, 1.25])
    measured = rw.calibrate.kept("reactions.max", 7.0, 0.1, rest=True)
    with pytest.raises(InputError, match="the scene gives 2 numbers"):
        rw.calibrate(hung(), measured, {LENGTH: (4.5, 6.0)}, starts=2)


def test_a_far_start_is_no_broken_one() -> None:
    """Errors so small that every start lies more than a million of them off."""
    forces = np.array([100.0, 200.0])
    pull = rw.calibrate.pull_test(forces, forces * 5.0 / 800.0, error=1e-12)
    fit = rw.calibrate(hung(), pull, {EA: (500.0, 2000.0)}, starts=2, profile=False)
    assert fit.values[EA] == pytest.approx(800.0, rel=1e-6)


def test_a_track_of_any_node_within_the_run() -> None:
    times = np.arange(21) / 50.0
    line = np.column_stack([times, 0.0 * times, 1.0 - times])
    speed = np.tile([1.0, 0.0, -1.0], (21, 1))
    scene = hung(run=rw.RunSettings(duration=0.4, frame_rate=50.0))
    for node, name in ((-1, "last"), (-10, "m10"), (-11, "m11"), (3, "3")):
        kept = {f"positions_all_{name}": line, f"velocities_all_{name}": speed}
        track = rw.calibrate.track([[0.11, 0.0, 0.0]], node=node, axes="xz")
        np.testing.assert_allclose(track.predicted(kept, {}, scene), [0.11, 0.89])
    kept = {"positions_all_last": line, "velocities_all_last": speed}
    # exact steps of 3 ms make frames of 21 ms, not of 20
    run = rw.RunSettings(duration=0.4, frame_rate=50.0, time_step=0.003, steps="exact")
    interval = build(hung(run=run)).plan.frame_interval
    assert abs(interval - 0.02) > 1e-3
    exact = rw.calibrate.track([[5.0 * interval, 0.0, 0.0]], axes="xz")
    np.testing.assert_allclose(exact.predicted(kept, {}, hung(run=run)), [0.1, 0.9])
    late = rw.calibrate.track([[0.1, 0.0, 0.0], [0.41, 0.0, 0.0]], axes="xz")
    with pytest.raises(InputError, match=r"0\.41 .* beyond the last frame, at 0\.4 s"):
        late.predicted(kept, {}, scene)


def test_names_of_what_is_kept_differ() -> None:
    from ropewalk.sweeps.keep import make_keep

    asked = ["positions[-1]", "positions[:, -1]", "positions[:, -10]", "positions[-1, -1]"]
    names = ["positions_last", "positions_all_last", "positions_all_m10", "positions_last_last"]
    assert [kept.name for kept in make_keep(asked, True)] == names


def test_points_beside_a_line() -> None:
    rope = np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 0.0, -1.0]])
    up = np.array([0.0, 0.0, 1.0])
    flat = np.array([[0.5, np.nan, 0.2], [1.1, np.nan, -0.5]])
    np.testing.assert_allclose(np.abs(offsets(rope, flat, up)), [0.2, 0.1])
    deep = np.array([[0.5, 0.3, 0.2]])
    np.testing.assert_allclose(np.abs(offsets(rope, deep, up)), [0.2, 0.3])


def test_words_for_what_cannot_be() -> None:
    sag = rw.calibrate.sag(1.0)
    with pytest.raises(rw.SceneError, match="low below high"):
        rw.calibrate(hung(), sag, {LENGTH: (2.0, 1.0)})
    with pytest.raises(rw.SceneError, match="name at least one path"):
        rw.calibrate(hung(), sag, {})
    with pytest.raises(InputError, match="for all measurements, or for none"):
        rw.calibrate(hung(), [sag, rw.calibrate.droop(1.0, 0.1)], {LENGTH: (4.0, 6.0)})
    with pytest.raises(InputError, match="cannot be weighed otherwise"):
        rw.calibrate(hung(), [sag, rw.calibrate.swing(1.0)], {LENGTH: (4.0, 6.0)})
    with pytest.raises(InputError, match="must be measurements"):
        rw.calibrate(hung(), 3.0, {LENGTH: (4.0, 6.0)})
    with pytest.raises(RunError, match="cannot be read"):
        rw.calibrate.track("nothing.csv")
    fit = rw.calibrate(hung(), sag, {LENGTH: (4.8, 6.0)}, starts=2)
    assert "give the error" in fit.words[0]
    assert math.isnan(fit.intervals[LENGTH][0])
    assert fit.profile == {}
