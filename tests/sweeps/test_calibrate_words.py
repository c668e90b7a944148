"""What a fit says of itself: which values it determines, and why it cannot be made."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.record.errors import InputError, RunError
from ropewalk.scene import SceneError
from ropewalk.sweeps.calibration import NotFitted
from ropewalk.sweeps.fit_ranges import make_scales
from ropewalk.sweeps.identify import verdict
from ropewalk.sweeps.measurements import as_measurements
from sweeps.scenes import EA, rigid, swing

LENGTH = "rope.length"
DETERMINED = "The measurement determines EA."


def fitted(error: float, ranges: tuple[float, float], profile: bool = True) -> Any:
    """EA from a pull test of 2 m, made with 2000 N."""
    forces = np.array([50.0, 100.0, 200.0])
    pull = rw.calibrate.pull_test(forces, forces * 2.0 / 2e3, error=error)
    return rw.calibrate(swing(0.02), pull, {EA: ranges}, starts=2, profile=profile)


@pytest.mark.parametrize("profile", [True, False])
def test_a_value_whose_interval_a_bound_cuts_is_not_determined(profile: bool) -> None:
    sharp = fitted(1e-4, (1e3, 1e4), profile)
    assert DETERMINED in sharp.words
    assert not any("not determined" in text for text in sharp.words)
    low = "EA is not determined: its interval ends at the lower end of its range."
    at_end = fitted(0.03, (1.9e3, 8e3), profile)
    assert low in at_end.words
    high = "EA is not determined: its interval ends at the upper end of its range."
    assert high in fitted(0.03, (1e3, 2.1e3), profile).words
    both = fitted(0.05, (1.9e3, 2.1e3), profile)
    assert any(
        text.startswith("EA is not determined") or "does not show" in text for text in both.words
    )
    for fit in (at_end, both):
        assert DETERMINED not in fit.words


def test_a_verdict_is_that_of_the_interval() -> None:
    def of(low: float, high: float, *words: str) -> tuple[str, ...]:
        return verdict(words, [(low, high)], ["EA"])

    assert of(0.2, 0.6) == (DETERMINED,)
    assert of(0.0, 1.0) == ("EA is not determined: its interval spans its range.",)
    assert of(0.1, 0.9) == ("EA is not determined: its interval spans most of its range.",)
    assert of(math.nan, math.nan) == ()  # nothing is known of it
    assert of(math.nan, math.nan, "told") == ("told",)
    assert of(0.0, 1.0, "EA does not show in this measurement.") == (
        "EA does not show in this measurement.",
    )
    two = verdict([], [(0.2, 0.3), (0.4, 1.0)], ["a", "b"])
    assert two == ("b is not determined: its interval ends at the upper end of its range.",)
    assert verdict([], [(0.2, 0.3)] * 2, ["a", "b"], 6) == (
        "Near this fit the measurement tells all of them apart. In 6 searches no other fit was found, which "
        "is no proof that there is none.",
    )
    assert verdict([], [(0.2, 0.3)], ["EA"], beyond=True) == ()  # the cutting is


def test_bounds_that_no_scene_can_have_are_told_before_any_run(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def none(*given: Any) -> None:
        raise AssertionError("a run was made")

    monkeypatch.setattr("ropewalk.sweeps.calibration.Residuals", none)
    sag = rw.calibrate.sag(1.0, 0.1)
    with pytest.raises(rw.SceneError, match=r"rope\[0\]\.length.*-1\.5"):
        rw.calibrate(swing(0.02), sag, {LENGTH: (-2.0, -1.0)})
    with pytest.raises(rw.SceneError, match=r"rope\.segments.*is a whole number"):
        rw.calibrate(swing(0.02), sag, {"rope.segments": (4, 20)})
    with pytest.raises(AssertionError, match="a run was made"):  # one end alone may be refused
        rw.calibrate(swing(0.02), sag, {EA: (0.0, 1e3)})


def test_a_fit_whose_starts_all_break_tells_the_first_reason() -> None:
    kept = rw.calibrate.kept("tension.max", 1.0, 0.1)
    with pytest.raises(NotFitted, match="every start broke: .* the first: Broke after t = 0 s"):
        rw.calibrate(swing(0.02), kept, {EA: (4e6, 9e6)}, starts=2)


def test_a_length_that_only_another_end_allows_is_no_fault() -> None:
    """Rigid ropes too short for the span as it is; nearer together they hang."""
    hanging, lengths = rigid(), {LENGTH: (6.0, 7.0)}
    rule = "the first: rope.*shorter than the"
    sag = rw.calibrate.pull_test([1.0, 2.0], [0.1, 0.2], error=0.1)
    with pytest.raises(NotFitted, match=rule):
        rw.calibrate(hanging, sag, lengths, starts=2)
    make_scales(hanging, {"rope.shape.end[0]": (3.0, 4.0), **lengths})


def test_a_fit_without_an_interval_says_so() -> None:
    pull = rw.calibrate.pull_test([100.0], [0.1])
    fit = rw.calibrate(swing(0.02), pull, {EA: (1e3, 1e4)}, starts=2)
    assert "(interval not known)" in repr(fit)
    assert any(text.startswith("1 number for 1 value: nothing is left") for text in fit.words)
    assert DETERMINED not in fit.words


@pytest.mark.parametrize(
    ("options", "told"),
    [
        ({"starts": "a"}, "starts: 'a' - must be a whole number from 0 on"),
        ({"starts": 2.5}, "starts: 2.5 - must be a whole number from 0 on"),
        ({"seed": -1}, "seed: -1 - must be a whole number from 0 on"),
        ({"level": "a"}, "level: 'a' - must be between 0 and 1"),
    ],
)
def test_options_that_cannot_be_have_a_sentence(options: dict[str, Any], told: str) -> None:
    with pytest.raises(InputError, match=told):
        rw.calibrate(swing(0.02), rw.calibrate.sag(1.0, 0.1), {EA: (1e3, 2e3)}, **options)


@pytest.mark.parametrize(
    ("options", "told"),
    [
        ({"samples": 3.5}, "samples: 3.5 - must be a whole number from 2 on"),
        ({"samples": 1}, "samples: 1 - must be a whole number from 2 on"),
        ({"samples": True}, "samples: True - must be a whole number from 2 on"),
        ({"seed": -1}, "seed: -1 - must be a whole number from 0 on"),
        ({"seed": "a"}, "seed: 'a' - must be a whole number from 0 on"),
    ],
)
def test_samples_and_seeds_that_cannot_be_have_a_sentence(
    options: dict[str, Any], told: str
) -> None:
    with pytest.raises(InputError, match=told):
        rw.uncertain(swing(0.02), {EA: (1e3, 2e3)}, **options)


def stiff(forces: Any, strains: Any, error: float | None, ranges: dict[str, Any]) -> Any:
    """A fit to a pull test of 1 m of a rope whose elongations are far below a millimetre."""
    rope = swing(0.02).ropes[0]
    rope = rope.replace(length=1.0, made_of=rope.made_of.replace(EA=1e7))
    pull = rw.calibrate.pull_test(forces, strains, error)
    return rw.calibrate(swing(0.02).replace(ropes=[rope]), pull, ranges)


def test_a_fit_does_not_stop_where_units_are_small() -> None:
    """Three elongations of at most half a micrometre that 6e6 N meet exactly."""
    forces = np.array([1.0, 2.0, 3.0])
    fit = stiff(forces, forces / 6e6, None, {EA: (2e6, 2e7)})
    assert fit.values[EA] == pytest.approx(6e6, rel=1e-6)
    for low, high in (fit.intervals[EA], fit.profile[EA]):
        assert 6e6 * (1.0 - 1e-6) < low <= high < 6e6 * (1.0 + 1e-6)
    assert not any("starts ended in a worse place" in text for text in fit.words)


def test_starts_that_end_elsewhere_are_told_where_units_are_small(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """One of two searches is cut short, 2 % off: far less than a millimetre here."""
    import scipy.optimize

    search, made = scipy.optimize.least_squares, []

    def one_cut_short(*given: Any, **options: Any) -> Any:
        made.append(search(*given, **options))
        if len(made) == 1:
            made[-1].x = made[-1].x * 1.02
            made[-1].cost = 0.5 * float((given[0](made[-1].x) ** 2).sum())
        return made[-1]

    monkeypatch.setattr(scipy.optimize, "least_squares", one_cut_short)
    forces = np.array([1.0, 2.0, 3.0])
    fit = stiff(forces, forces / 6e6, None, {EA: (2e6, 2e7)})
    assert len(made) == 2
    assert any(text.startswith("1 of 2 starts ended in a worse place") for text in fit.words)


@pytest.mark.parametrize("error", [None, 2e-6])
def test_a_profile_goes_all_the_way_along_what_cannot_be_told_apart(error: float | None) -> None:
    """Only EA over the length shows: EA ends where the length, 0.5 m to 2 m, meets its bounds.

    By hand: k = EA / L is a line through the origin in 1/k, its interval that of a straight line.
    """
    forces = np.linspace(100.0, 1000.0, 10)
    noise = 1.0 + 0.02 * np.random.default_rng(0).normal(size=10)
    e = forces / 6e6 * noise
    fit = stiff(forces, e, error, {EA: (2e6, 2e7), LENGTH: (0.5, 2.0)})
    square = forces @ forces
    k = square / (forces @ e)
    left = e - forces / k
    spread, quantile = (error, 1.6449) if error else (math.sqrt(left @ left / 8.0), 1.8595)
    half = quantile * spread * k / math.sqrt(square)  # of k, as a share
    low, high = fit.profile[EA]
    width = high - low
    assert 0.5 * k * (1.0 - half) - 0.03 * width < low < 0.5 * k * (1.0 - 0.9 * half)
    assert 2.0 * k * (1.0 + 0.9 * half) < high < 2.0 * k * (1.0 + half) + 0.03 * width
    assert fit.profile[LENGTH] == pytest.approx((0.5, 2.0))
    assert "EA and length cannot be told apart by this measurement." in fit.words


def test_what_a_measurement_names_that_is_not_there_has_a_sentence() -> None:
    ranges = {EA: (1e3, 1e4)}
    with pytest.raises(InputError, match=r"droop\.node: 99 - there is no such node: there are 5"):
        rw.calibrate(swing(0.02), rw.calibrate.droop(0.3, 0.01, node=99), ranges, starts=2)
    pull = rw.calibrate.pull_test([1.0, 2.0], [0.1, 0.2], rope="rop")
    with pytest.raises(InputError, match=r"pull_test\.rope: 'rop' .* did you mean \"rope\""):
        rw.calibrate(swing(0.02), pull, ranges, starts=2)
    for mode in (0, -1, 1.5):
        with pytest.raises(
            InputError, match=rf"swing\.mode: {mode} - must be a whole number from 1"
        ):
            rw.calibrate.swing(1.0, mode=mode)
    beyond = rw.calibrate.swing(1.0, 0.01, mode=40)  # of 4 free nodes
    with pytest.raises(InputError, match=r"swing\.mode: 40 - there are 12 modes"):
        rw.calibrate(swing(0.02), beyond, ranges, starts=2)
    for node in (1.5, "x", True):
        with pytest.raises(InputError, match=r"droop\.node: .* - must be a whole number$"):
            rw.calibrate.droop(0.3, 0.01, node=node)  # type: ignore[arg-type]


def test_measured_numbers_are_plain_ones_and_lengths_are_lengths(tmp_path: Path) -> None:
    sag, pull = rw.calibrate.sag, rw.calibrate.pull_test
    for make in (
        lambda: sag("1.2 m"),
        lambda: sag("1.2"),
        lambda: pull(["10 N"], [0.1]),
        lambda: pull([10.0], [[0.1], 2.0]),
        lambda: rw.calibrate.shape([["1 m", 2.0, 3.0]]),
        lambda: rw.calibrate.track([[0.0, "1", 2.0, 3.0]]),
    ):
        with pytest.raises(InputError, match="must be plain numbers, in SI units"):
            make()
    for length in (-1.0, 0.0, "1 kg", math.nan):
        with pytest.raises(SceneError, match=r"pull_test\.length: .* - (must be a|is of another)"):
            pull([10.0], [0.1], length=length)
    rope = swing(0.02)
    (short,) = pull([100.0], [0.1], length="50 cm").predicted({}, {}, rope)
    assert short == pytest.approx(100.0 * 0.5 / rope.ropes[0].made_of.EA)
    (tmp_path / "t.csv").write_bytes("time,x\n0,1\n# gr\u00f6\u00dfer\n".encode("latin-1"))
    with pytest.raises(RunError, match=r"t\.csv: is not a text file \(UTF-8\)"):
        rw.calibrate.track(tmp_path / "t.csv")


def test_a_list_of_two_is_no_value_with_its_error() -> None:
    with pytest.raises(InputError, match=r"write \(120.0, 2.0\) for a value and its error, or "):
        as_measurements({"tension.max": [120.0, 2.0]})
    (one,) = as_measurements({"tension.max": (120.0, 2.0)})
    assert (one.values.tolist(), one.error) == ([120.0], 2.0)
    (two,) = as_measurements({"tension.max": ([120.0, 2.0], None)})
    assert (two.values.tolist(), two.error) == ([120.0, 2.0], None)


def test_ranges_of_a_fit_may_have_units() -> None:
    made = make_scales(swing(0.02), {EA: ("200 N", "5 kN"), LENGTH: (1.5, "250 cm")})
    assert (made[EA].low, made[EA].high) == (200.0, 5000.0)
    assert (made[LENGTH].low, made[LENGTH].high) == (1.5, 2.5)
    with pytest.raises(SceneError, match=r"EA: \"200 m\" - is of another kind"):
        make_scales(swing(0.02), {EA: ("200 m", "5 kN")})


def test_all_positions_may_be_measured_at_once() -> None:
    places = np.arange(15.0).reshape(5, 3)
    measured = rw.calibrate.kept("positions[-1]", places)
    found = measured.predicted({measured.variable: places[None]}, {}, swing(0.02))  # type: ignore[attr-defined]
    assert (found == measured.values).all()


def test_a_measurement_in_a_scene_of_several_ropes_is_of_the_one_that_is_named() -> None:
    """Node -1 was the last of the whole scene, whosever the measurement was."""
    one = swing(0.02).ropes[0]
    scene = rw.Scene(ropes=[one.replace(name=name) for name in "ab"], anchors=[])
    count, corner = one.nodes, np.array([[0.0, 0.0, 0.0], [0.0, 0.0, -5.0]])
    places = np.zeros((2 * count, 3))
    places[:, 0] = np.arange(2 * count)
    places[:count, 2], places[count:, 2] = np.linspace(0.0, -1.0, count), 7.0
    rest = {"positions_last": places}
    for rope, fall in (("a", 1.0), ("b", 0.0)):
        droop = rw.calibrate.droop(0.5, rope=rope)
        assert droop.predicted({}, rest, scene) == pytest.approx([fall])
        shape = rw.calibrate.shape(corner, axes="xyz", rope=rope)
        alone = rw.Scene(ropes=[scene.rope_named(rope)], anchors=[])
        own = {"positions_last": places[:count] if rope == "a" else places[count:]}
        twin = rw.calibrate.shape(corner, axes="xyz").predicted({}, own, alone)
        np.testing.assert_array_equal(shape.predicted({}, rest, scene), twin)
    for name, made in (
        ("droop", rw.calibrate.droop),
        ("shape", lambda _, **of: rw.calibrate.shape(corner, **of)),
    ):
        with pytest.raises(InputError, match=rf"{name}\.rope.*must name one of .* ropes, a, b"):
            made(0.5).predicted({}, rest, scene)
        with pytest.raises(InputError, match=rf"{name}\.rope: 'c' - there is no such rope"):
            made(0.5, rope="c").predicted({}, rest, scene)
    with pytest.raises(InputError, match="the only rope of a scene"):
        rw.calibrate.track([[0.0, 0.0, 0.0, 0.0]]).predicted({}, rest, scene)


@pytest.mark.parametrize(
    ("text", "rule"),
    [
        ("time,x\n0,1,0.5,2\n", "must hold 2 numbers a line, as its head does: row 1 has 4"),
        ("time,x,z\n0,1,2\n1,2\n", "must hold 3 numbers a line, as its head does: row 2 has 2"),
        ("time,x,x\n0,1,2\n", "must name each column once in its head, not time,x,x"),
    ],
)
def test_a_track_whose_lines_are_not_as_its_head_says_is_refused(
    tmp_path: Path, text: str, rule: str
) -> None:
    """A line of twice as many numbers became two rows of them."""
    (tmp_path / "track.csv").write_text(text)
    with pytest.raises(RunError, match=rule):
        rw.calibrate.track(tmp_path / "track.csv")
