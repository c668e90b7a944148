"""The sheet of a job: its numbers are the run's, it says when they do not hold, it opens anywhere."""

from __future__ import annotations

import hashlib
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import scipy.stats
from matplotlib.figure import Figure
from matplotlib.transforms import Bbox

import ropewalk as rw
from ropewalk.plots.dimensions import dimensions
from ropewalk.record.extremes import extremes
from ropewalk.scene import (
    Anchor,
    Kick,
    Load,
    Material,
    Rope,
    RunSettings,
    Scene,
    Slack,
    Springs,
)
from ropewalk.scene.shapes import Straight
from ropewalk.sheets import trust
from ropewalk.sheets.content import Listing, Picture, Section, Table, Text
from ropewalk.sheets.html import html_page
from ropewalk.sheets.ropes import assumption_section, rope_section
from ropewalk.words.prefixes import prefixed
from ropewalk.words.safe_side import percent_up

LINE = Material(EA=4e4, mass_per_length=0.1, axial_damping=40.0, breaking_load=9e3)


def hung(segments: int = 12, duration: float = 0.5, **changes: object) -> Scene:
    """A line of 6 m over 5 m, a load at its middle."""
    rope = Rope(
        name="line",
        segments=segments,
        length=6.0,
        made_of=LINE,
        shape=Slack(start=(0, 0, 0), end=(5, 0, 1)),
        loads=[Load(node=segments // 2, mass=30.0)],
    )
    run = RunSettings(duration=duration, method="verlet")
    ends = [Anchor(name="low", node=0), Anchor(name="high", node=-1)]
    return Scene(**({"ropes": [rope], "anchors": ends, "run": run, "name": "job <1>"} | changes))


@pytest.fixture(scope="module")
def made() -> rw.Sheet:
    return rw.sheet(hung())


def words(section: Section) -> str:
    return " ".join(item.words for item in section.items if isinstance(item, Text))


def warnings(sheet: rw.Sheet) -> list[str]:
    items = [item for section in sheet.sections for item in section.items]
    return [item.words for item in items if isinstance(item, Text) and item.warning]


def table(section: Section, number: int = 0) -> Table:
    return [item for item in section.items if isinstance(item, Table)][number]


def test_the_numbers_are_those_of_the_run_and_of_the_equilibrium(made: rw.Sheet) -> None:
    result, rest = made.result, rw.equilibrium(hung())
    assert result is not None
    found = extremes(result)
    at_rest, in_run = table(made.section("Summary")).rows
    assert in_run[1] == prefixed(found["greatest tension"].value, "N", 5)
    assert in_run[2] == prefixed(found["greatest anchor force"].value, "N", 5)
    assert in_run[3] == percent_up(found["greatest tension"].value / 90.0, 3)
    assert at_rest[1] == prefixed(float(rest.tension.max()), "N", 5)
    force = float(np.linalg.norm(rest.reactions[0], axis=1).max())
    assert at_rest[2] == prefixed(force, "N", 5)
    assert warnings(made) == []


def test_the_ropes_pull_their_anchors_down_and_inward(made: rw.Sheet) -> None:
    """The forces on the anchors at rest: together the weight, downward; each toward the other."""
    rows = {row[0]: row for row in table(made.section("At rest"), 1).rows}
    low, high = rows["low"], rows["high"]
    assert not low[1].startswith("-")
    assert high[1].startswith("-")
    assert low[5].endswith("down")
    assert high[5].endswith("down")
    sizes = [float(row[3].split()[0]) for row in (low, high)]
    assert sum(sizes) == pytest.approx(-9.81 * 30.6, rel=1e-3)


def test_half_the_segments_and_half_the_step_are_told(made: rw.Sheet) -> None:
    section = made.section("Convergence")
    assert table(section).head == ("", "this sheet", "half the segments", "half the step")
    assert "change by at most" in words(section)


def test_too_coarse_a_rope_is_warned_of() -> None:
    """The twin: a heavy line of four segments, whose tension is not that of a line."""
    rope = hung(4).ropes[0].replace(loads=(), made_of=LINE.replace(mass_per_length=4.0))
    coarse = rw.sheet(hung(4, 1.0, ropes=[rope]))
    first, then = (text for text in warnings(coarse) if "half a segment's weight more" not in text)
    assert first == then
    assert first.startswith("NOT CONVERGED: the largest")
    assert first in words(coarse.section("Summary"))
    assert first in words(coarse.section("Convergence"))


def test_a_broken_run_is_said_first_and_compared_with_nothing() -> None:
    run = RunSettings(duration=2.0, method="verlet", time_step=0.02)
    broke = rw.sheet(hung(run=run))
    assert broke.result is not None
    assert broke.result.diagnosis
    assert "The run broke" in words(broke.section("Summary"))
    assert "THE RUN BROKE" in words(broke.section("The run"))
    with pytest.raises(KeyError, match="no section 'Convergence'"):
        broke.section("Convergence")


def test_a_rope_that_parts_is_said_first() -> None:
    """The twin carries as much and cannot part. It read IT WOULD HAVE PARTED of both, without a parting."""
    weak = LINE.replace(breaking_load=200.0)
    for parts in (True, False):
        rope = hung().ropes[0].replace(made_of=weak.replace(parts=parts))
        job = rw.sheet(hung(ropes=[rope]), convergence=False)
        said, run = words(job.section("Summary")), words(job.section("The run"))
        assert job.result is not None
        assert ("A ROPE PARTED: " in said) is ("A ROPE PARTED: " in run) is parts
        assert ("IT PARTED" in run) is parts
        assert ("IT WOULD HAVE PARTED" in run) is not parts
        if parts:
            assert str(job.result.partings[0]) in said


def test_an_energy_error_that_is_not_to_be_trusted_is_a_warning() -> None:
    """A soft cord that falls and goes slack; the twin in fine steps. One that hangs still has no share."""
    cord = Rope(
        segments=20,
        length=2.0,
        made_of=Material(EA=300.0, mass_per_length=0.1, tension_only=True),
        shape=Straight(start=(0, 0, 0), end=(2, 0, 0)),
    )
    for fraction, warned in ((0.8, True), (0.05, False)):
        run = RunSettings(duration=4.0, method="rk4", auto_fraction=fraction)
        job = rw.sheet(hung(ropes=[cord], anchors=[Anchor(node=0)], run=run), convergence=False)
        told = [text for text in warnings(job) if text.startswith("The energy: rk4 lost")]
        assert bool(told) is warned
    still = hung(run=RunSettings(duration=0.5, method="esdirk3", time_step=0.01, start="at-rest"))
    rows = dict(table(rw.sheet(still, convergence=False).section("Method")).rows)
    assert "of the energy turned over" not in rows["largest energy error"]


def test_forces_that_agree_do_not_make_an_untrusted_run_right() -> None:
    """A string in steps of a period: "change by at most 7.2e-05 %", beside an error of "1e+02 %"."""
    wire = Material(EA=29730.0, mass_per_length=0.001143, axial_damping=0.01, tension_only=True)
    string = Rope(
        segments=50, length=1.2, made_of=wire, shape=Straight(end=(1.203, 0.0, 0.0)),
        kick=[Kick(node=10, velocity=(0.0, 0.0, 0.5))],
    )  # fmt: skip
    ends = [Anchor(node=0), Anchor(node=-1)]
    for step, told in (("auto", True), (0.00002, False)):
        run = RunSettings(duration=0.1, method="auto", time_step=step)
        job = rw.sheet(hung(ropes=[string], anchors=ends, run=run))
        said = [text for text in warnings(job) if "does not make these numbers right" in text]
        assert bool(said) is told
        rows = dict(table(job.section("Method")).rows)
        assert ("(104 % of the energy" in rows["largest energy error"]) is told


def test_a_sheet_says_that_convergence_was_not_looked_at() -> None:
    made = rw.sheet(hung(), run=False, convergence=False)
    assert "Not looked at" in words(made.section("Convergence"))
    assert "Not looked at" not in words(rw.sheet(hung(), run=False).section("Convergence"))


def test_a_variant_that_fails_is_a_warning_in_words_of_the_sheet(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """It was plain text, with a sentence for who programs: "The error's `result` holds what there is"."""
    run = RunSettings(duration=2.0, method="verlet", time_step=0.02)
    broke = rw.simulate(hung(run=run), on_failure="return")

    def breaks(*_: object) -> dict[str, float]:
        raise rw.BrokenRun(broke)

    monkeypatch.setattr(trust, "simulate", breaks)
    section = trust.convergence_section(hung(), rw.simulate(hung()), lambda _: None)
    told = [item.words for item in section.items if isinstance(item, Text) and item.warning]
    assert told[0].startswith("half the segments: FAILED: ")
    assert told[1].startswith("half the step: FAILED: ")
    assert "`result`" not in "".join(told)


def test_at_rest_alone() -> None:
    still = rw.sheet(hung(), run=False)
    assert still.result is not None
    assert still.result.status == "at rest"
    assert table(still.section("Convergence")).head == ("", "this sheet", "half the segments")
    assert [row[0] for row in table(still.section("Summary")).rows] == ["at rest"]
    with pytest.raises(rw.SceneError, match="no anchor holds it"):
        rw.sheet(hung(anchors=[]), run=False)


def test_no_shape_of_rest_is_said_and_the_run_goes_on() -> None:
    loose = rw.sheet(hung(anchors=[], duration=0.1), convergence=False)
    assert "There is no shape of rest" in words(loose.section("At rest"))
    assert [row[0] for row in table(loose.section("Summary")).rows] == ["in the run"]


def test_springs_are_not_cut_anew() -> None:
    made_of = Springs(spring_constant=900.0, node_mass=0.1, segment_length=1.0)
    rope = Rope(segments=4, made_of=made_of)
    scene = Scene(ropes=[rope], anchors=[Anchor(node=0)], run=RunSettings(duration=0.1))
    made = rw.sheet(scene)
    assert "spring by spring" in words(made.section("Convergence"))
    assert table(made.section("Convergence")).head == ("", "this sheet", "half the step")
    assert any("No breaking load" in text for text in warnings(made))


def test_what_is_guessed_is_warned_of() -> None:
    made_of = rw.rope("dynamic-single-9.8").material(guesses=True, bending=True)
    rope = Rope(segments=4, length=3.0, made_of=made_of)
    run = RunSettings(duration=0.05, method="verlet")
    scene = Scene(ropes=[rope], anchors=[Anchor(node=0)], run=run)
    told = " ".join(warnings(rw.sheet(scene, convergence=False)))
    assert "Guessed, not measured: bending stiffness EI, breaking load." in told
    sourced = scene.replace(**{"rope.made_of": rw.rope("dynamic-single-9.8").material()})
    told = " ".join(warnings(rw.sheet(sourced, convergence=False)))
    assert "Guessed" not in told


def test_how_forces_on_anchors_at_rest_converge_is_told() -> None:
    """The row was missing: a largest one that begins at NaN is NaN."""
    still = rw.sheet(hung(), run=False)
    rows = {row[0]: row for row in table(still.section("Convergence")).rows}
    assert rows["largest force on an anchor"][1].endswith("N")


def test_rest_says_in_which_wind_and_where_what_slides_rests() -> None:
    """A line in the wind sagged by 7.7 m where its scene says 9, as if in still air."""
    made = rw.sheet("power-line-in-wind", run=False, convergence=False)
    assert "This is rest in the wind of 25 m/s" in words(made.section("At rest"))
    calm = rw.preset("power-line-in-wind").replace(air=None)
    made = rw.sheet(calm, run=False, convergence=False)
    assert "wind" not in words(made.section("At rest"))
    nothing = hung(air=rw.Air(wind=(3.0, 0.0, 0.0)))
    made = rw.sheet(nothing, run=False, convergence=False)
    assert "in the wind" not in words(made.section("At rest"))
    assert any(
        "wind of 3 m/s: it blows on nothing without air.density" in text for text in warnings(made)
    )
    assert "drags" not in words(assumption_section(nothing))
    ride = rw.preset("zip-line-ride").replace(**{"slide.at": 101.5})
    told = words(rw.sheet(ride, run=False, convergence=False).section("At rest"))
    assert "Slide 'trolley' rests at 102.32 m of rope 'wire'" in told


def test_ropes_alike_have_one_table() -> None:
    """The three guys of `guyed-mast` had three tables of the same numbers; twin: one of another length."""
    mast = rw.preset("guyed-mast")
    heads = [item.head[0] for item in rope_section(mast).items if isinstance(item, Table)]
    assert heads == ["ropes 'east', 'north-west', 'south-west', each", "number of the library"]
    east, *others = mast.ropes
    uneven = mast.replace(ropes=[east.replace(length=43.1), *others])
    heads = [item.head[0] for item in rope_section(uneven).items if isinstance(item, Table)]
    assert heads[::2] == ["rope 'east'", "ropes 'north-west', 'south-west', each"]


def test_narrow_figures_are_drawn_as_large_as_wide_ones() -> None:
    """One of 4.6 inches filled the page, with letters half as large again."""
    items = tuple(Picture(b"", width, 3.0, "it") for width in (7.2, 3.6))
    page = html_page("a", "b", [Section("c", items)])
    assert re.findall(r'style="width: (\d+)%', page) == ["100", "50"]


def test_a_number_of_two_sources_has_both_in_words() -> None:
    """It read "A1 A12"."""
    made = rw.sheet("climbing-fall", run=False, convergence=False)
    text = str(made.section("Ropes"))
    assert "A1 A12" not in text
    assert "Mammut, ropes catalogue" in text


def test_what_is_not_known_has_bands() -> None:
    made = rw.sheet(
        hung(), run=False, convergence=False, uncertain={"rope.length": (5.9, 6.1)}, samples=4
    )
    section = made.section("What is not known")
    assert "rope.length: 5.9 to 6.1" in words(section)
    assert any(row[0] == "tension_max" for row in table(section).rows)
    assert any(isinstance(item, Picture) for item in section.items)


def test_what_is_not_known_can_be_computed_again() -> None:
    """Its samples had a seed that nobody was told; a distribution by names read "norm()"."""
    spread = scipy.stats.norm(loc=6.0, scale=0.1)
    ask: dict[str, Any] = {"run": False, "convergence": False, "samples": 4}
    made = rw.sheet(hung(), uncertain={"rope.length": spread}, **ask)
    section = made.section("What is not known")
    assert "norm(loc=6.0, scale=0.1)" in words(section)
    assert "4 samples, seed 1" in words(section)
    rows = {row[0]: row[2:5] for row in table(section).rows}
    again = rw.uncertain(hung(), {"rope.length": spread}, samples=4, seed=1, what="rest")
    told = {name: (low, middle, high) for name, _, low, middle, high in again.table()}
    assert rows["tension_max"] == tuple(f"{value:.5g}" for value in told["tension_max"])


def test_the_scene_at_its_end_is_the_scene(made: rw.Sheet) -> None:
    """Read again it is the same scene, and its hash is the one that is told."""
    section = made.section("To compute it again")
    (listing,) = [item.lines for item in section.items if isinstance(item, Listing)]
    assert rw.loads(listing) == hung()
    told = dict(table(section).rows)["SHA-256 of the scene below"]
    assert told == hashlib.sha256(listing.encode()).hexdigest()


def test_files(made: rw.Sheet, tmp_path: Path) -> None:
    page = made.save(tmp_path / "new" / "job.html").read_text(encoding="utf-8")
    assert "job &lt;1&gt;" in page
    assert "<1>" not in page
    assert not re.search(r'(src|href)="(?!data:)', page)  # nothing from elsewhere
    pages = made.save(tmp_path / "job.pdf").read_bytes()
    assert pages.startswith(b"%PDF")
    assert len(re.findall(rb"/Type /Page\b", pages)) >= 3
    assert sorted(p.name for p in tmp_path.iterdir()) == ["job.pdf", "new"]
    with pytest.raises(ValueError, match=r"must end in \.html or \.pdf"):
        made.save(tmp_path / "job.doc")


def test_what_is_taken_for_granted_is_what_the_ropes_are() -> None:
    """A rope that relaxes, or has a curve, is not said to be a spring."""
    fall = rw.preset("climbing-fall")
    told = words(assumption_section(fall))
    assert "a part of the stiffness relaxes" in told
    assert "rate of strain" not in told  # it has no such friction
    rows = dict(table(rope_section(fall)).rows)
    assert rows["EA that relaxes"] == "29.27 kN"
    assert rows["relaxation time"] == "0.1922 s"
    assert rows["breaking load"].endswith("the library guesses 14.41 kN to 24.97 kN")
    assert "proportional to strain; friction along" in words(assumption_section(hung()))
    curved = Material(curve=[(0.1, 500.0), (0.2, 1500.0)], mass_per_length=0.1)
    told = words(assumption_section(hung(ropes=[hung().ropes[0].replace(made_of=curved)])))
    assert "tension follows it" in told
    assert "proportional to strain" not in told
    webbing = hung().ropes[0].replace(made_of=rw.rope("semistatic-10.5").material())
    sources = table(rope_section(hung(ropes=[webbing])), 1).rows
    assert ("axial stiffness EA", "guess", "19.1 kN to 61 kN") in [row[:3] for row in sources]


def test_a_limiter_takes_no_part_in_rest() -> None:
    for limiter, said in ({"max_stretch": 1.2}, True), (None, False):
        made = rw.sheet(hung(limiter=limiter), run=False, convergence=False)
        assert ("takes no part in rest" in words(made.section("At rest"))) is said


def test_words_of_a_drawing_keep_clear_of_axis_and_ropes() -> None:
    """The climbing fall's 80 kg stood on the axis, the names of the mast's anchors on its guys."""

    def drawn(name: str) -> tuple[Figure, dict[str, Bbox]]:
        figure = dimensions(rw.equilibrium(rw.preset(name)))
        figure.canvas.draw()
        return figure, {text.get_text(): text.get_window_extent() for text in figure.axes[0].texts}

    figure, words = drawn("climbing-fall")
    assert words["80 kg"].y0 > figure.axes[0].bbox.y0 + 2.0
    figure, words = drawn("guyed-mast")
    axes = figure.axes[0]
    for name, side in (("east-ground", -1), ("east-top, north-west-top, south-west-top", 1)):
        height = {-1: 0.0, 1: 30.48}[side]
        _, place = axes.transData.transform((0.0, height))
        assert (words[name].y1 < place) if side < 0 else (words[name].y0 > place)
    assert words["east-ground"].y0 > words["52.792 m"].y1
    assert "All 9 loads are of 2000 kg; the first 8 are named." in " ".join(
        t.get_text() for t in drawn("suspension-cable")[0].texts
    )
