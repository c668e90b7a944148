"""An equilibrium beyond a stretch limiter, which takes no part in it, says so wherever it is told."""

from __future__ import annotations

import math

import pytest

import ropewalk as rw
from ropewalk.plots.margin_notes import margin_notes
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


def loaded(load: float = 500.0, apart: float = 5.0, **more: object) -> rw.Scene:
    """Two ropes with 80 kg each: `a` soft, at 1.08 of its length and 790 N, `b` within 1.01."""
    ropes = [
        rw.Rope(
            name=name, segments=4, length=10.0, loads=[{"node": -1, "mass": 80.0}],
            made_of=rw.Material(EA=EA, mass_per_length=0.05, breaking_load=strength),
            shape={"kind": "straight", "start": (x, 0, 0), "end": (x, 0, -10)},
        )
        for name, x, EA, strength in (("a", 0.0, 1e4, load), ("b", apart, 1e5, 5e3))
    ]  # fmt: skip
    anchors = [{"rope": name, "node": 0} for name in "ab"]
    return rw.Scene(ropes=ropes, anchors=anchors, limiter={"max_stretch": 1.01}).replace(**more)


def test_what_is_past_breaking_without_the_limiter_is_told_as_the_least() -> None:
    found = rw.check(loaded(), measure=False)
    a, b = found.as_dict()["ropes"]
    assert a["utilisation"] == a["worst"] == pytest.approx(1.5794, rel=1e-3)
    assert "at least 158 % of the breaking load, safety factor at most 0.633; it would" in str(
        found
    )
    assert any("carries at least 1.58 times" in text for text in found.warnings)
    assert (b["utilisation"], b["limited"], b["at_least"]) == (
        pytest.approx(0.1579, rel=1e-3),
        0,
        0,
    )
    rest = rw.equilibrium(loaded())
    used = "largest utilisation of the breaking load"
    assert rest.table[f"{used} [%]"] == pytest.approx(157.94, rel=1e-3)
    assert rest.table[f"about the {used}"].startswith("it is at least that")
    assert {"rest beyond limiter", "above breaking load"} <= set(kinds(rest))
    assert "Rope a: at least 158 %" in margin_notes(rest, 0, 1)[0]
    made = rw.sheet(loaded(), run=False, convergence=False)
    assert made.section("Summary").items[0].rows[0][-2:] == (
        "at least 158 %, rope 'a'",
        "at most 0.633",
    )
    said = [item.words for item in made.section("At rest").items if isinstance(item, Text)]
    assert any(": at least 158 % (safety factor at most 0.633)" in text for text in said)


def test_below_breaking_it_is_not_known_of_what_the_limiter_would_hold() -> None:
    """Of the whole nothing is known either: the rope that would be held may come nearest."""
    a, b = rw.check(loaded(5e3), measure=False).as_dict()["ropes"]
    assert (a["utilisation"], a["worst"], a["doubt"]) == (None, None, None)
    assert b["worst"] == pytest.approx(0.1579, rel=1e-3)
    rest = rw.equilibrium(loaded(5e3))
    used = "largest utilisation of the breaking load"
    assert f"{used} [%]" not in rest.table
    others = (
        "not known at rest of rope 'a', for the stretch limiter; of the others rope 'b' comes nearest, "
        "15.8 % of the breaking load, safety factor 6.33"
    )
    assert rest.table[f"about the {used}"] == others
    made = rw.sheet(loaded(5e3), run=False, convergence=False)
    said = [item.words for item in made.section("At rest").items if isinstance(item, Text)]
    assert f"How near to breaking is {others}." in said
    alone = rw.equilibrium(span(1.0)).table[f"about the {used}"]
    assert alone == "not known at rest of rope 'rope', for the stretch limiter"


def test_what_is_joined_to_it_is_not_known_either() -> None:
    tie = {"points": [{"rope": "a", "node": -1}, {"rope": "b", "node": -1}]}
    scene = loaded(5e3, 0.0, joints=[tie])
    for rope in rw.check(scene, measure=False).as_dict()["ropes"]:
        assert (rope["limited"], rope["utilisation"]) == (True, None)


def test_the_least_of_a_guess_beyond_breaking_is_told() -> None:
    rope = loaded().ropes[0]
    guess = [{"of": "breaking_load", "value": 1000.0, "low": 660.0, "high": 1500.0}]
    made_of = rope.made_of.replace(breaking_load=1000.0, guess=guess)
    scene = loaded(ropes=[rope.replace(made_of=made_of)], anchors=[{"rope": "a", "node": 0}])
    rest, ropes = rw.equilibrium(scene), rw.check(scene, measure=False).as_dict()["ropes"]
    assert ropes[0]["worst"] == pytest.approx(1.19, abs=0.01)
    assert ropes[0]["utilisation"] < 1.0
    assert any(key.startswith("largest utilisation with the least") for key in rest.table)
    assert "guess" in kinds(rest)
    assert "above breaking load" not in kinds(rest)


def test_a_stretch_of_little_more_than_one_is_told_apart_from_it() -> None:
    scene = loaded().replace(**{"rope.made_of.EA": 2e6, "limiter.max_stretch": 1.0})
    said = " ".join(rw.check(scene, measure=False).warnings)
    assert "(at most 1) acts even at rest" in said
    assert "would stretch to 1.0004;" in said
    assert (
        "is 1.0004 of its length and it allows 1:"
        in rw.equilibrium(scene).table["about the stretch limiter"]
    )


@pytest.mark.parametrize("load", [500.0, 5e3])
def test_a_sweep_keeps_what_the_table_tells(load: float) -> None:
    """It kept 0.158 and a safety factor of 6.3 where the table and the check tell none."""
    keep = ["utilisation.max", "safety_factor.min"]
    ds = rw.sweep(loaded(load), {"gravity[2]": [-9.81]}, keep=keep, what="rest", on="here")
    table = rw.equilibrium(loaded(load)).table
    share = table.get("largest utilisation of the breaking load [%]", math.nan) / 100.0
    factor = table.get("least safety factor [1]", math.nan)
    assert (load > 1e3) == math.isnan(share)
    assert float(ds.utilisation_max[0]) == pytest.approx(share, rel=1e-12, nan_ok=True)
    assert float(ds.safety_factor_min[0]) == pytest.approx(factor, rel=1e-12, nan_ok=True)
