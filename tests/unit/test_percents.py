"""Per cents in sentences: never as powers of ten that nobody reads."""

from __future__ import annotations

import pytest

from ropewalk.analysis.check import check
from ropewalk.analysis.cost import run_time
from ropewalk.analysis.stability import stability
from ropewalk.lowering import build
from ropewalk.record.ends import End, in_words
from ropewalk.record.margins import margin_words
from ropewalk.scene import Anchor, Load, Material, Rope, Scene
from ropewalk.words.counts import counted
from ropewalk.words.percents import percent
from ropewalk.words.safe_side import outwards, percent_up
from runs import hanging


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (0.2345, "0.23 %"),
        (99.4, "99 %"),
        (99.6, "100 %"),  # was 1e+02 %
        (103.56, "104 %"),
        (-1234.5, "-1234 %"),
        (0.0, "0 %"),
        (1.2e-7, "1.2e-07 %"),
        (3e9, "3e+09 %"),
    ],
)
def test_per_cents_are_written_out(value: float, text: str) -> None:
    assert percent(value) == text


def test_digits_and_signs() -> None:
    assert percent(103.56, 3) == "104 %"
    assert percent(1035.6, 3) == "1036 %"
    assert percent(150.0, sign="+") == "+150 %"
    assert percent(0.0, sign="+") == "+0 %"


def test_margins_are_written_out() -> None:
    """Was 3.92e+03 %."""
    assert margin_words(39.24) == (
        "3924 % of the breaking load, safety factor 0.0254; it would have parted"
    )
    assert margin_words(0.1234).startswith("12.4 % of")


def test_what_is_at_most_or_at_least_is_rounded_to_the_safe_side() -> None:
    """A safety factor of 1.996 was 2, and 12.34 % "up to 12.3 %"; a solver's last digits make no step."""
    assert margin_words(0.501).endswith("safety factor 1.99")
    assert margin_words(0.2 * (1.0 + 1e-11)).endswith("safety factor 5")
    assert percent_up(12.34, 3) == "12.4 %"
    assert percent_up(1234.2, 3) == "1235 %"
    assert margin_words(1.0001).startswith("101 % of the breaking load, safety factor 0.999; it")
    assert percent_up(20.0 * (1.0 + 1e-11), 3) == "20 %"
    assert percent_up(0.0) == "0 %"
    assert outwards(1234.9, 2345.1) == (1234.0, 2346.0)
    assert outwards(1234.9, 1234.9 * (1.0 + 1e-9)) == (1235.0, 1235.0)


@pytest.mark.parametrize(
    ("seconds", "measured", "words"),
    [
        (110.4, True, "in about 110 s"),  # was 1.1e+02 s
        (99.6, True, "in about 100 s"),
        (12.34, True, "in about 12 s"),
        (1e-5, False, "in about 1 ms (not measured)"),  # was "in some 1 ms to 1 ms"
        (0.03, False, "in some 10 ms to 90 ms (not measured)"),
    ],
)
def test_run_times_are_written_out(seconds: float, measured: bool, words: str) -> None:
    assert run_time(build(hanging()), seconds, measured) == words


def test_one_thing_is_no_plural() -> None:
    assert [counted(number, "step") for number in (0, 1, 2)] == ["0 steps", "1 step", "2 steps"]
    ends = tuple(End((name,), 0.1, 5, f"{name} broke.") for name in "abcd")
    assert in_words(ends, 4) == "a broke. b broke. c broke. 1 more rope ended after that."
    assert in_words((*ends, ends[0]), 5).endswith("2 more ropes ended after that.")
    scene = hanging(duration=0.01, frame_rate=100.0, time_step=0.01, segments=1)
    found = check(scene, measure=False)
    assert found.pace == "1 frame of 1 step, 1 step of 10 ms"
    assert "rope 'rope': 1 segment, " in str(found)


def test_the_margin_of_a_step_is_written_out() -> None:
    """Was 1.13e+03 %."""
    scene = hanging(time_step=1e-3, spring_constant=300.0).replace(anchors=[Anchor(node=0)])
    found = stability(scene)
    assert found.margin > 10.0
    assert f", margin {100.0 * found.margin:.0f} %)" in found.verdict


def test_what_parts_at_rest_is_written_out() -> None:
    """A breaking load in kN typed as N was carried by 4.925e+04 %."""
    made_of = Material(EA=1e5, mass_per_length=0.1, breaking_load=10.0, parts=True)
    rope = Rope(segments=2, length=2.0, made_of=made_of, loads=[Load(node=-1, mass=500.0)])
    found = check(Scene(ropes=[rope], anchors=[Anchor(node=0)]), measure=False)
    share = 100.0 * found.ropes[0].utilisation
    assert share > 1e4
    assert any(f"carries {share:.0f} % of the breaking load" in said for said in found.warnings)
