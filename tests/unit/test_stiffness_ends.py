"""Sheets of ropes whose stiffness is a guess: both ends of it are computed, and told on the safe side."""

from __future__ import annotations

import re

import ropewalk as rw
from ropewalk.lowering import build
from ropewalk.scene import Anchor, Load, Rope, RunSettings, Scene, Winch
from ropewalk.scene.guess import Guess
from ropewalk.scene.shapes import Hanging, Straight
from ropewalk.sheets.stiffness_ends import stiffness_ends
from ropewalk.sheets.trust import Variant, _verdict
from unit.test_sheets import LINE, table, warnings


def taut(*marks: Guess, **stuff: object) -> Scene:
    """A rope without weight over 5.05 m, of 5 m: 1 % of its EA pulls at both anchors."""
    made_of = LINE.replace(EA=4e4, guessed=marks, **stuff)
    rope = Rope(
        segments=4, length=5.0, made_of=made_of, shape=Straight(start=(0, 0, 0), end=(5.05, 0, 0))
    )
    run = RunSettings(duration=0.05, method="verlet", time_step=1e-3)
    ends = [Anchor(node=0), Anchor(node=-1)]
    return Scene(ropes=[rope], anchors=ends, run=run, gravity=(0, 0, 0))


def test_both_ends_of_a_guessed_stiffness_are_computed() -> None:
    """It said "compute both ends of it" and did not: 1 % of 20 kN and of 2 MN, at rest and in the run."""
    guess = Guess(of="EA", value=4e4, low=2e4, high=2e6)
    job = rw.sheet(taut(guess))
    rows = {row[0]: row[1:] for row in table(job.section("Guessed stiffness")).rows}
    for what in ("largest tension", "largest force on an anchor"):
        for when in ("at rest", "in the run"):
            told = [cell.partition(" (")[0] for cell in rows[f"{what}, {when}"]]
            assert told == ["400 N", "200 N", "20 kN"]
    told = " ".join(warnings(job))
    assert (
        "at rest, largest tension 200 N to 20 kN, largest force on an anchor 200 N to 20 kN" in told
    )
    assert "compute both ends of it" not in told
    assert "both ends of it are computed under Guessed stiffness" in told
    alone = rw.sheet(taut(guess), convergence=False)
    assert "compute both ends of it" in " ".join(warnings(alone))
    for one in (alone, rw.sheet(taut()), rw.sheet(taut(guess.replace(value=3e4)))):
        assert "Guessed stiffness" not in [section.title for section in one.sections]


def test_how_near_to_breaking_a_guessed_stiffness_may_bring_a_rope_is_told() -> None:
    """The reader had to divide: 400 N of 100 kN in the sheet, 20 kN at the stiff end."""
    guess = Guess(of="EA", value=4e4, low=2e4, high=2e6)
    job = rw.sheet(taut(guess, breaking_load=1e5))
    assert "largest utilisation up to 20 % (safety factor 5)" in " ".join(warnings(job))
    rows = {row[0]: row[1:] for row in table(job.section("Guessed stiffness")).rows}
    told = ("0.4 % (safety factor 250)", "0.2 % (safety factor 500)", "20 % (safety factor 5)")
    assert rows["largest utilisation, in the run"] == rows["largest utilisation, at rest"] == told


def test_numbers_of_the_ends_are_on_the_safe_side_and_written_out() -> None:
    """1.23e+03 % stood there, and 20 kN as the most of 20.005."""
    guess = Guess(of="EA", value=4e4, low=20007.0, high=2.0005e6)
    job = rw.sheet(taut(guess, breaking_load=1629.0), run=False)
    rows = {row[0]: row[1:] for row in table(job.section("Guessed stiffness")).rows}
    assert rows["largest utilisation, at rest"][2] == "1229 % (safety factor 0.0814)"
    told = " ".join(warnings(job))
    assert "largest tension 200 N to 20.01 kN" in told
    assert "largest utilisation up to 1229 % (safety factor 0.0814)" in told


def test_what_forces_change_by_at_most_is_rounded_up() -> None:
    names = ("largest tension", "largest force on an anchor")
    base = dict.fromkeys(names, 100.0)
    changed = Variant("half the step", dict.fromkeys(names, 102.41))
    assert _verdict(base, [changed]).words.startswith(
        "The forces change by at most 2.5 % with half the step."
    )


def test_the_least_of_a_guessed_breaking_load_counts_at_the_stiff_end() -> None:
    """20 % stood for 25: the summary of the ends took the breaking load as it was guessed."""
    stiff = Guess(of="EA", value=4e4, low=2e4, high=2e6)
    load = Guess(of="breaking_load", value=1e5, low=8e4, high=1.2e5)
    job = rw.sheet(taut(stiff, load, breaking_load=1e5), run=False)
    told = " ".join(warnings(job))
    assert "with the least of a guessed breaking load up to 25 % (safety factor 4)" in told
    rows = {row[0]: row[1:] for row in table(job.section("Guessed stiffness")).rows}
    worst = rows["largest utilisation with the least of a guessed breaking load, at rest"]
    assert [one.partition(" (")[0] for one in worst] == ["0.5 %", "0.25 %", "25 %"]
    known = rw.sheet(taut(stiff, breaking_load=1e5), run=False)
    assert "least of a guessed" not in " ".join(warnings(known))


def test_an_end_that_no_rope_can_have_is_said_to_fail() -> None:
    relaxes = {"relaxing_EA": 1e4, "relaxation_time": 0.1}
    guess = Guess(of="relaxing_EA", value=1e4, low=0.0, high=2e4)
    job = rw.sheet(taut(guess, **relaxes))
    told = " ".join(warnings(job))
    assert "In the run, least stiffness: the scene cannot be made with it." in told
    assert table(job.section("Guessed stiffness")).rows[0][2] == ""
    (summary,) = (text for text in warnings(job) if "over its range" in text)
    assert summary.count("of the least stiffness nothing, for it FAILED") == 2  # at rest, and run


def test_a_rope_that_parts_at_an_end_of_its_stiffness_is_told() -> None:
    """It bears no more, so that its tension there is no largest one; twin: one that may not part."""
    guess = Guess(of="EA", value=4e4, low=2e4, high=2e6)
    for parts in (True, False):
        told = " ".join(warnings(rw.sheet(taut(guess, breaking_load=1000.0, parts=parts))))
        assert ("with the greatest stiffness a rope PARTS" in told) is parts
        assert "with the least stiffness a rope PARTS" not in told


def paid_out(**run: object) -> Scene:
    """30 kg that a winch pays out and stops: a jerk, which long steps blur."""
    ends = {"low": 3.99e4, "high": 4.01e4}
    made_of = LINE.replace(EA=4e4, guessed=(Guess(of="EA", value=4e4, **ends),))
    loads = [Load(node=-1, mass=30.0)]
    rope = Rope(
        segments=8, length=1.0, made_of=made_of, shape=Hanging(start=(0, 0, 0)), loads=loads
    )
    winch = Winch(name="w", end="start", speed=1.0, on_drum=1.0, max_length=1.3)
    settings = RunSettings(**({"duration": 0.4, "start": "at-rest"} | run))
    return Scene(ropes=[rope], anchors=[Anchor(node=0)], winches=[winch], run=settings)


def test_both_ends_are_stepped_as_the_sheet_is() -> None:
    """Ends that are a 400th off the guess change tensions by no more than that. A method that "auto" had
    chosen, called by its name, took longer steps than the sheet, and made 19 % less of a jerk: too little
    at both ends. So for a time step that is given, of which "auto" takes a part. The twin: a method and a
    step that the scene has.
    """
    for run in ({}, {"time_step": 0.02}, {"method": "esdirk3", "time_step": 0.01}):
        scene = paid_out(frame_rate=25.0, **run)
        plan = build(scene).plan
        assert plan.method == "esdirk3"
        assert plan.dt <= 0.01
        ends = stiffness_ends(scene, None, rw.simulate(scene), lambda _: None)
        assert ends is not None
        rows = {row[0]: row[1:] for row in table(ends.section).rows}
        changes = re.findall(r"\(([-+]?[\d.]+) %\)", " ".join(rows["largest tension, in the run"]))
        assert len(changes) == 2
        assert max(abs(float(one)) for one in changes) < 0.25, rows
