"""An equilibrium beyond a stretch limiter, which takes no part in it, says so wherever it is told."""

from __future__ import annotations

import pytest

import ropewalk as rw
from ropewalk.record.note_kinds import kinds
from ropewalk.sheets.content import Text
from ropewalk.sweeps.calibration import NotFitted


def span(longest: float | None = 1.0, **material: float) -> rw.Scene:
    """A soft rope of 10.2 m over 10 m, which rests at 1.06 to 1.08 of its length."""
    made = {"EA": 200.0, "mass_per_length": 0.2, "breaking_load": 500.0, **material}
    rope = rw.Rope(
        segments=20, length=10.2, made_of=rw.Material(**made),
        shape={"kind": "slack", "start": (0, 0, 0), "end": (10, 0, 0)},
    )  # fmt: skip
    limiter = None if longest is None else {"max_stretch": longest}
    return rw.Scene(ropes=[rope], anchors=[{"node": 0}, {"node": -1}], limiter=limiter)


@pytest.mark.parametrize(
    ("longest", "beyond"), [(0.99, 1), (1.0, 1), (1.05, 1), (1.1, 0), (None, 0)]
)
def test_a_check_warns_and_tells_no_safety_factor(longest: float | None, beyond: bool) -> None:
    found = rw.check(span(longest), measure=False)
    assert any("acts even at rest" in text for text in found.warnings) == beyond
    assert ("safety factor" in str(found)) != beyond
    assert (found.as_dict()["ropes"][0]["utilisation"] is None) == beyond


def test_a_rope_that_breaks_without_the_limiter_is_told_with_it() -> None:
    found = rw.check(span(1.0, breaking_load=10.0), measure=False)
    assert any("times its breaking load" in text for text in found.warnings)
    assert "it would have parted" in str(found)


def test_a_limiter_leaves_rigid_links_alone() -> None:
    assert not any("acts even" in text for text in rw.check(span(1.0, EA=float("inf"))).warnings)


@pytest.mark.parametrize(("longest", "beyond"), [(1.0, 1), (1.1, 0)])
def test_tables_and_sheets_say_so(longest: float, beyond: bool) -> None:
    rest = rw.equilibrium(span(longest))
    assert ("about the stretch limiter" in rest.table) == beyond
    assert ("least safety factor [1]" in rest.table) != beyond
    assert ("rest beyond limiter" in kinds(rest)) == beyond
    made = rw.sheet(span(longest), run=False, convergence=False)
    for title in ("Summary", "At rest"):
        told = [item for item in made.section(title).items if isinstance(item, Text)]
        warned = [item.words for item in told if item.warning]
        assert any("it would act at rest" in text for text in warned) == beyond
    row = made.section("Summary").items[0].rows[0]
    assert (row[-2:] == ("not known", "")) == beyond


def test_a_fit_at_rest_beyond_the_limiter_is_refused() -> None:
    """What is measured with the limiter gave a length of 9.04 m for 10.2, and called it determined."""
    measured = rw.calibrate.sag(0.8732, 0.001)
    ranges = {"rope.length": (8.5, 12.0)}
    with pytest.raises(NotFitted, match="rests beyond the stretch limiter"):
        rw.calibrate(span(1.0), measured, ranges, starts=2, profile=False)
    fit = rw.calibrate(span(None), measured, ranges, starts=2, profile=False)
    assert fit.values["rope.length"] == pytest.approx(9.04, abs=0.01)
