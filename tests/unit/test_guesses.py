"""Guessed numbers: their marks go with a material, and whatever is told from them says so."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.live.describe import rope_list
from ropewalk.lowering import build
from ropewalk.record.margins import margin_words
from ropewalk.scene import SceneError, dumps, loads
from ropewalk.scene.guess import Guess, doubt_of, guesses_of
from ropewalk.scene.overrides import apply_overrides
from ropewalk.sheets.content import Table, Text
from ropewalk.sheets.loads import rest_section, summary_section
from ropewalk.sheets.ropes import rope_section
from ropewalk.words.safe_side import percent_up

STRAND = rw.Material.of_wire("1x19", "12 mm", guesses=True)
#: K of 0.507 (0.477 to 0.549) times 1570 N/mm^2 times 144 mm^2.
LOAD, LEAST, MOST = (K * 1570.0 * 144.0 for K in (0.507, 0.477, 0.549))
PULL = 9.81 * (5000.0 + STRAND.mass_per_length * 2.0 * 0.9)  # [N] of the first of five segments


def hung(made_of: rw.Material) -> rw.Scene:
    rope = rw.Rope(
        segments=5, length=2.0, made_of=made_of, shape={"kind": "hanging"},
        loads=[rw.Load(node=-1, mass=5000.0)],
    )  # fmt: skip
    run = rw.RunSettings(duration=0.01, frame_rate=100.0, start="at-rest")
    return rw.Scene(ropes=[rope], anchors=[rw.Anchor(node=0)], run=run)


SURE = STRAND.replace(breaking_load=LOAD * 1.01)
USED = margin_words(PULL / LEAST, "").replace(" of the breaking load", "")
DOUBT = f"with the least of it {USED}"


def test_the_mark_goes_through_a_file_and_off_with_the_number() -> None:
    scene = loads(dumps(hung(STRAND)))
    assert scene == hung(STRAND)
    mark = guesses_of(scene.ropes[0].made_of)["breaking_load"]
    assert (mark.value, mark.low, mark.high) == pytest.approx((LOAD, LEAST, MOST))
    assert list(guesses_of(scene.ropes[0].made_of)) == ["breaking_load"]
    known = apply_overrides(scene, ["rope.made_of.breaking_load=135 kN"])
    assert not guesses_of(known.ropes[0].made_of)
    assert not guesses_of(rw.Material.of_wire("1x19", "12 mm", guesses=True, breaking_load=1e5))
    with pytest.raises(SceneError, match="must be from 2 to 3"):
        Guess(of="EA", value=1.0, low=2.0, high=3.0)
    with pytest.raises(SceneError, match="must be greater than 0"):
        Guess(of="breaking_load", value=1.0, low=0.0, high=3.0)


def test_all_of_locked_coil_is_marked_and_nothing_of_what_has_a_source() -> None:
    coil = rw.Material.of_wire("locked coil", 0.04, guesses=True)
    marks = guesses_of(coil)
    assert set(marks) == {"EA", "mass_per_length", "breaking_load"}
    assert (marks["EA"].low, marks["EA"].high) == pytest.approx((95e9 * 0.0016, 117e9 * 0.0016))
    assert marks["mass_per_length"].high == pytest.approx(5870 * 0.0016)  # 0.587 kg/100 m per mm^2
    assert not rw.Material.of_wire("6x36 IWRC", 0.012, guesses=True).guessed


def test_ropes_of_the_library_are_marked_whatever_way_they_come() -> None:
    entry = rw.rope("semistatic-10.5")
    named = hung(STRAND).ropes[0].replace(made_of=entry.name).made_of
    old = loads(dumps(hung(entry.material()).replace()).split("guess = ")[0] + "\n")
    for made_of in (entry.material(), named, old.ropes[0].made_of):
        assert set(guesses_of(made_of)) == {"EA"}
    assert set(guesses_of(entry.material(guesses=True))) == set(entry.guesses) & {
        *("EA", "mass_per_length", "axial_damping", "breaking_load")
    }


def words(items: Any) -> str:
    rows = [cell for item in items if isinstance(item, Table) for row in item.rows for cell in row]
    return "\n".join([*rows, *(item.words for item in items if isinstance(item, Text))])


@pytest.mark.parametrize("made_of", [STRAND, SURE])
def test_wherever_a_margin_is_told_it_says_that_it_is_from_a_guess(made_of: rw.Material) -> None:
    """Check, tables, figures, sheets, lines; with its range, and with what the least of it makes of it."""
    scene = hung(made_of)
    rest, run = rw.equilibrium(scene), rw.simulate(scene)
    line = rw.line(30.0, 0.0, made_of, sag=0.6)
    rolling = line.rolling(1000.0)
    told = {
        "check": str(rw.check(scene, measure=False)),
        "table of rest": str(rest.table),
        "table of a run": str(run.table),
        "tensions": " ".join(one.get_text() for one in run.plot.tension().texts),
        "forces": " ".join(one.get_text() for one in run.plot.forces().texts),
        "summary": words(summary_section(rest, run).items),
        "at rest": words(rest_section(rest, ()).items),
        "ropes": words(rope_section(scene).items),
        "line": str(line),
        "rolling": str(rolling),
        "figure of it": " ".join(one.get_text() for one in rolling.figure().texts),
    }
    for where, text in told.items():
        text = " ".join(text.split())
        assert ("is a guess" in text or "a guess:" in text) == (made_of is STRAND), where
        assert ("107.8 kN to 124.1 kN" in text) == (made_of is STRAND), where
        if made_of is STRAND and where not in ("ropes", "line", "rolling", "figure of it"):
            assert DOUBT in text, where
    if made_of is STRAND:
        share = rolling.largest_tension.max() / LEAST
        assert f"with the least of it {percent_up(100 * share, 3)}" in told["rolling"]


def test_the_page_gets_the_least_of_a_guessed_load() -> None:
    for made_of, least in ((STRAND, LEAST), (SURE, None)):
        scene = hung(made_of)
        (told,) = rope_list(scene, build(scene).layout.ropes, {})
        assert told["least_load"] == (least and pytest.approx(least))


def test_a_guessed_stiffness_is_told_beside_the_margin_too() -> None:
    """A tow rope's EA may be ten times another; the safety factor of a jerk stood there as known."""
    tow = rw.preset("tow")
    told = doubt_of(tow.ropes[0].made_of, 0.2)
    assert told.startswith("EA is a guess, 72.6 kN to 726 kN")
    assert "breaking load" not in told
    both = STRAND.replace(
        guessed=[*STRAND.guessed, Guess(of="EA", value=STRAND.EA, low=1e6, high=2e7)]
    )
    assert doubt_of(both, 0.5).startswith("the breaking load is a guess, 107.8 kN to 124.1 kN")
    assert "EA is a guess, 1 MN to 20 MN" in doubt_of(both, 0.5)
    assert doubt_of(SURE, 0.5) == ""


def two_ropes(known: float) -> rw.Scene:
    """Two that carry the same: of one the breaking load is known [N], of the other it is STRAND's guess."""
    weak = hung(SURE).ropes[0].replace(name="weak", made_of=SURE.replace(breaking_load=known))
    other = hung(STRAND).ropes[0].replace(name="other")
    anchors = [rw.Anchor(rope="weak", node=0), rw.Anchor(rope="other", node=0)]
    return rw.Scene(ropes=[weak, other], anchors=anchors, run={"duration": 0.05})


@pytest.mark.parametrize(("known", "may"), [(0.5 * LEAST, False), (0.5 * (LEAST + LOAD), True)])
def test_the_rope_that_comes_nearest_with_the_least_of_guesses_is_named(
    known: float, may: bool
) -> None:
    """Of equal pulls the known load is the nearer one, unless the guessed one may be less."""
    scene = two_ropes(known)
    rest, run = rw.equilibrium(scene), rw.simulate(scene)
    pull = float(rest.reactions[0, 0, 2])  # which the anchor bears
    for table in (rest.table, run.table):
        assert "rope 'weak'" in table["largest utilisation of the breaking load at"]
    assert rest.table["largest utilisation of the breaking load [%]"] == pytest.approx(
        100.0 * pull / known
    )
    least = "largest utilisation with the least of a guessed breaking load"
    assert rest.table.get(f"{least}, of") == ("rope 'other'" if may else None)
    if may:
        assert rest.table[f"{least} [%]"] == pytest.approx(100.0 * pull / LEAST)
    for text in (
        rest.table.get("about the largest utilisation of the breaking load", ""),
        words(summary_section(rest, run).items),
        words(rest_section(rest, ()).items),
        " ".join(one.get_text() for one in run.plot.tension().texts),
    ):
        text = " ".join(text.split()).replace("Rope 'other'", "rope 'other'")
        assert ("rope 'other' may come nearer: the breaking load is a guess" in text) is may
        assert ("with the least of it" in text) is may
    assert "%, rope 'weak'" in words(summary_section(rest, None).items)


@pytest.mark.parametrize("strong", ["first", "second"])
def test_the_largest_utilisation_is_that_of_the_weaker_rope_though_the_other_pulls_more(
    strong: str,
) -> None:
    """300 kg on 10 kN, 200 kg on 4 kN: each with its own breaking load, and by its name, everywhere."""
    ropes = [
        hung(SURE)
        .ropes[0]
        .replace(
            name=name,
            loads=[{"node": -1, "mass": 300.0 if name == strong else 200.0}],
            made_of=SURE.replace(breaking_load=1e4 if name == strong else 4e3),
        )
        for name in ("first", "second")
    ]
    anchors = [rw.Anchor(rope=rope.name, node=0) for rope in ropes]
    scene = rw.Scene(ropes=ropes, anchors=anchors, run={"duration": 0.05})
    rest, run = rw.equilibrium(scene), rw.simulate(scene)
    weak = "second" if strong == "first" else "first"
    borne = rest.reactions[0, ("first", "second").index(weak), 2]  # half a segment's weight more
    share = borne / 4e3
    assert share > float(rest.tension.max()) / 1e4  # what the other, which pulls more, has
    assert rest.table["largest utilisation of the breaking load [%]"] == pytest.approx(100 * share)
    assert f"{percent_up(100 * share, 3)}, rope '{weak}'" in words(summary_section(rest, run).items)
    assert f"Rope {weak}: at most" in " ".join(one.get_text() for one in run.plot.tension().texts)
    found = {rope.name: rope.utilisation for rope in rw.check(scene, measure=False).ropes}
    assert found[weak] == pytest.approx(share)


def test_a_rope_that_may_carry_more_than_it_can_is_warned_of() -> None:
    """97 % of a guessed breaking load may be 103.1 % of it."""
    load = 0.97 * LOAD / 9.81
    for made_of, warned in ((STRAND, True), (STRAND.replace(guessed=()), False)):
        scene = hung(made_of).replace(**{"rope.loads": [{"node": -1, "mass": load}]})
        found = rw.check(scene, measure=False)
        assert found.ropes[0].utilisation == pytest.approx(0.97, rel=1e-3)
        said = [text for text in found.warnings if "its breaking load" in text]
        assert bool(said) is warned
        assert not warned or "with the least of it 104 %" in said[0]


def test_a_line_says_how_near_to_breaking_the_stiff_end_of_a_guess_brings_it() -> None:
    """It told tensions at the ends of a guessed EA, and utilisation of its middle alone."""
    made_of = rw.Material.of_wire("locked coil", "30 mm", guesses=True)
    (EA, load) = (guesses_of(made_of)[name] for name in ("EA", "breaking_load"))
    line = rw.line(10.0, 0.0, made_of, length=10.0, gravity=9.81)
    stiff = line.with_EA(EA.high)
    pulls = max(stiff.tensions), float(stiff.rolling(20000.0).largest_tension.max())
    for pull, said in zip(pulls, (line.lines(), line.rolling(20000.0).lines()), strict=True):
        share = 100.0 * pull / load.value
        least = share * load.value / load.low
        words = (
            f"utilisation up to {percent_up(share, 3)}, "
            f"with the least of the guessed breaking load {percent_up(least, 3)}"
        )
        assert words in " ".join(said)
    known = rw.line(10.0, 0.0, made_of.replace(breaking_load=1e6), length=10.0)
    assert "of the guessed breaking load" not in str(known)
    unknown = rw.line(10.0, 0.0, made_of.replace(breaking_load=None), length=10.0)
    assert "utilisation" not in str(unknown)


@pytest.mark.slow
def test_the_range_of_a_guessed_mass_is_in_the_tensions_of_a_line() -> None:
    """At a given sag they are as the weight, and EA changes nothing."""
    line = rw.line(100.0, 0.0, "locked-coil-30", sag=2.0)
    guess = rw.rope("locked-coil-30").numbers["mass_per_length"]
    assert guess.low is not None
    assert guess.high is not None
    light, heavy = line.with_mass(guess.low), line.with_mass(guess.high)
    assert [light.sag, heavy.sag] == pytest.approx([line.sag] * 2, rel=1e-9)
    pulls = [max(one.tensions) for one in (light, line, heavy)]
    shares = [1.0 / guess.value * mass for mass in (guess.low, guess.value, guess.high)]
    assert np.array(pulls) / pulls[1] == pytest.approx(shares, rel=1e-3)
    (told,) = [note for note in line.notes() if note.startswith("mass")]
    assert f"largest tension {pulls[0] / 1e3:.4g} kN to {pulls[2] / 1e3:.4g} kN" in told
    loaded = [float(one.rolling(500.0).largest_tension.max()) for one in (light, heavy)]
    assert (
        f"with mass 4860 g/m to 5283 g/m the largest is {loaded[0] / 1e3:.4g} kN to {loaded[1] / 1e3:.4g} kN"
        in str(line.rolling(500.0))
    )
    sure = rw.line(30.0, 0.0, line.material.replace(mass_per_length=5.0), sag=1.0)
    assert "mass" not in "".join(sure.notes() + sure.rolling(80.0).notes())


def test_a_line_tells_what_both_guesses_at_once_make_of_it() -> None:
    """Each alone was told, and neither is the worst: 781.1 kN and 760.9 kN for 781.8."""
    coil = rw.Material.of_wire("locked coil", "30 mm", guesses=True)
    marks = guesses_of(coil)
    most = coil.replace(EA=marks["EA"].high, mass_per_length=marks["mass_per_length"].high)
    head = "with the greatest of both guesses, EA and mass, the largest tension is "
    for given in ({"sag": "2 %"}, {"length": 99.9}):
        line, worst = (rw.line(100.0, 0.0, made, **given) for made in (coil, most))
        assert f"{head}{max(worst.tensions) / 1e3:.4g} kN" in str(line)
        assert ("length to cut 99.9 to 99.9 m" in str(line)) is False
        if "sag" in given:
            assert "MN: length to cut 100." in str(line)
            pull = float(worst.rolling(20e3).largest_tension.max())
            rolled = str(line.rolling(20e3))
            assert f"{head}{pull / 1e3:.4g} kN" in rolled
            share = 100.0 * pull / marks["breaking_load"].low
            assert rolled.rstrip().endswith(
                f"with the least of the guessed breaking load {percent_up(share, 3)}"
            )
    known = coil.replace(EA=9e7)
    assert "both guesses" not in str(rw.line(100.0, 0.0, known, sag="2 %"))
