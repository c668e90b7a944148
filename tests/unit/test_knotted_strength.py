"""A breaking load is that of a rope without a knot, and tables and checks of a knotted one say so."""

from __future__ import annotations

import pytest

import ropewalk as rw
from ropewalk.analysis.check import check
from ropewalk.record.margins import doubt_words, margin_of
from ropewalk.record.note_kinds import kinds
from ropewalk.scene.guess import Guess
from ropewalk.scene.knotted import both_doubt, knot_doubt
from ropewalk.sheets.content import Table
from ropewalk.sheets.stiffness_ends import stiffness_ends
from ropewalk.words.safe_side import percent_up

TOLD = (
    "without the knot, which leaves a rope some 45 to 75 % of its strength: with the least of it "
)
BOTH = "with the least of guess and knot together "


def test_a_knot_takes_its_part_of_the_breaking_load() -> None:
    """The twins: a rope that is straight, and turns on a bollard."""
    straight = rw.Rope(segments=4, made_of="semistatic-10.5", length=1.0)
    scene = rw.preset("overhand")
    rope = scene.ropes[0].model_copy(update={"made_of": straight.made_of})
    scene = scene.model_copy(update={"ropes": (rope,)})
    words = doubt_words(scene, margin_of(scene, {rope.name: 0.0893}))
    assert words.endswith(f"{TOLD}19.9 %, safety factor 5.03")
    run = {"duration": 0.1, "method": "implicit-euler", "time_step": 1 / 240}
    table = rw.simulate(scene.model_copy(update={"run": rw.RunSettings(**run)})).table
    assert TOLD in table["about the largest utilisation of the breaking load"]
    assert knot_doubt(straight, 0.0893) == ""
    assert knot_doubt(rw.preset("bollard").ropes[0], 0.0893) == ""


def test_a_guess_and_a_knot_are_told_together() -> None:
    """Of 40 % each alone left 44.5 and 88.9 %, both below 1: 98.8 % was told by nothing."""
    scene = beside_a_knot(1e4, 1e4, least=0.9)
    rope = scene.ropes[1]
    words = doubt_words(scene, margin_of(scene, {rope.name: 0.4}))
    assert "with the least of it 44.5 %, safety factor 2.25" in words
    assert f"{TOLD}88.9 %, safety factor 1.12; {BOTH}98.8 %, safety factor 1.01" in words
    assert both_doubt(scene.ropes[0], 0.4) == ""
    assert both_doubt(rope.replace(**{"made_of.guessed": ()}), 0.4) == ""
    run = rw.simulate(scene)
    pull = [float(run.rope(name).greatest_tension.max()) for name in ("plain", "tied")]
    # The plain rope is the nearer by either alone: 70 % against 67 % with the knot, 33 % with the guess.
    nearer = rw.simulate(beside_a_knot(pull[0] / 0.7, pull[1] / 0.3, least=0.9))
    told = nearer.table["about the largest utilisation of the breaking load"]
    told = told[told.index("rope 'tied'") :]  # after what is said of the largest tension
    assert told == f"rope 'tied' may come nearer: {BOTH}74.1 %, safety factor 1.35"
    row = (
        "largest utilisation with the least of a guessed breaking load, and of what its knot leaves"
    )
    assert nearer.table[f"{row} [%]"] == pytest.approx(100.0 * 0.3 / (0.9 * 0.45))
    assert nearer.table[f"{row}, of"] == "rope 'tied'"
    assert {"guess", "knot"} <= set(kinds(nearer))
    figure = " ".join(text.get_text() for text in nearer.plot.tension().texts)
    assert told in " ".join(figure.split())
    # The twin, with nothing guessed.
    known = rw.simulate(beside_a_knot(pull[0] / 0.7, pull[1] / 0.3))
    assert "come nearer" not in known.table.get(
        "about the largest utilisation of the breaking load", ""
    )
    assert f"{row} [%]" not in known.table
    assert not {"guess", "knot"} & set(kinds(known))


def test_a_check_warns_of_what_a_guess_and_a_knot_leave_together() -> None:
    """At 42.4 % of a breaking load a rope may carry more than is left; each alone leaves enough."""
    stuff = rw.Material(EA=1e6, mass_per_length=0.1, breaking_load=1e3)
    for least, warned in ((900.0, True), (1e3, False)):
        guess = Guess(of="breaking_load", value=1e3, low=least, high=1e3)
        scene = beside_a_knot(1e4, 1e4)
        tied = scene.ropes[1].replace(
            made_of=stuff.replace(guessed=[guess]),
            loads=[{"node": -1, "mass": 420.0 / 9.81}],
        )
        found = check(scene.replace(ropes=[scene.ropes[0], tied]), measure=False)
        said = [text for text in found.warnings if "its breaking load" in text]
        assert bool(said) is warned
        assert not warned or f"{BOTH}105 %, safety factor 0.956" in said[0]


def test_a_sheet_tells_both_at_the_ends_of_a_guessed_stiffness() -> None:
    EA = Guess(of="EA", value=1e6, low=9e5, high=1.1e6)
    for least in (0.9, 1.0):
        scene = beside_a_knot(1e6, 100.0, least=least)
        tied = scene.ropes[1]
        tied = tied.replace(made_of=tied.made_of.replace(guessed=[*tied.made_of.guessed, EA]))
        run = rw.simulate(scene.replace(ropes=[scene.ropes[0], tied]))
        ends = stiffness_ends(run.scene, None, run, lambda _: None)
        assert ends is not None
        used = next(one for one in ends.section.items if isinstance(one, Table)).rows
        (row,) = [one for one in used if "and the least that a knot leaves" in one[0]]
        share = run.table[
            "largest utilisation with the least of a guessed breaking load, and of what its knot leaves [%]"
        ]
        assert row[1].startswith(percent_up(share, 3))


def beside_a_knot(plain: float, tied: float, least: float | None = None) -> rw.Scene:
    """A straight rope and one in an overhand knot, each with a load, of these breaking loads [N].

    `least`: what share of its own the tied one's may be [1], a guess; None of none.
    """
    marks = (
        ()
        if least is None
        else (Guess(of="breaking_load", value=tied, low=least * tied, high=tied),)
    )
    stuff = {"EA": 1e6, "mass_per_length": 0.1}
    loads = [{"node": -1, "mass": 10.0}]
    straight = {"kind": "straight", "start": (0, 5, 0), "direction": (0, 0, -1)}
    shapes = {"plain": (straight, plain), "tied": ({"kind": "knot", "knot": "overhand"}, tied)}
    ropes = [
        rw.Rope(
            name=name, segments=40, length=3.5, diameter=0.06, shape=shape, loads=loads,
            made_of=rw.Material(**stuff, breaking_load=load, guessed=marks if name == "tied" else ()),
        )
        for name, (shape, load) in shapes.items()
    ]  # fmt: skip
    run = rw.RunSettings(duration=0.1, frame_rate=50.0, method="implicit-euler", time_step=1 / 240)
    anchors = [{"rope": name, "node": 0} for name in shapes]
    return rw.Scene(ropes=ropes, anchors=anchors, run=run)


def test_a_knotted_rope_that_is_not_the_nearest_may_be_with_its_knot() -> None:
    """Of 65 % in a plain rope and 61 % in a tied one nothing was said; the knot makes 136 % of those."""
    run = rw.simulate(beside_a_knot(1e4, 1e4))
    pull = [float(run.rope(name).greatest_tension.max()) for name in ("plain", "tied")]
    nearer = rw.simulate(beside_a_knot(pull[0] / 0.65, pull[1] / 0.61))
    assert nearer.table["largest utilisation of the breaking load [%]"] == pytest.approx(65.0)
    words = nearer.table["about the largest utilisation of the breaking load"]
    words = words[words.index("rope 'tied'") :]
    assert words.startswith("rope 'tied' may come nearer: its breaking load is told without the ")
    assert words.endswith(f"{TOLD}136 %, safety factor 0.737")
    assert "knot" in kinds(nearer)
    figure = " ".join(text.get_text() for text in nearer.plot.tension().texts)
    assert words in " ".join(figure.split())
    # The twin: a tied rope that with the least of its strength is not as near as the plain one.
    far = rw.simulate(beside_a_knot(pull[0] / 0.65, pull[1] / 0.29))
    assert "come nearer" not in far.table.get(
        "about the largest utilisation of the breaking load", ""
    )
    assert "knot" not in kinds(far)


def test_a_check_says_nothing_of_a_shape_of_rest_that_settle_does_not_find() -> None:
    """Without weight all are. The twin: a loop that may be drawn taut."""
    for name in ("overhand", "reef"):
        text = str(check(rw.preset(name)))
        assert "every shape is at rest" in text
        assert "settle" not in text
    assert "settle` looks for it" in str(check(rw.preset("bowline")))
