"""Lines set up by what one knows, loads along them, and materials from data sheets."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pint
import pytest

import ropewalk as rw
from ropewalk.laws.obstacle import radius_of
from ropewalk.scene import SceneError
from ropewalk.sheets.ropes import rope_section


@pytest.mark.parametrize("rise", [0.0, -12.0, 40.0])
def test_a_line_has_what_it_was_set_up_by(rise: float) -> None:
    by_sag = rw.line("300 m", rise, "wire-7x19-12", sag="2 %")
    assert by_sag.sag == pytest.approx(6.0, rel=1e-9)
    assert rw.line(300.0, rise, "wire-7x19-12", sag=6.0).length == by_sag.length
    by_pull = rw.line(300.0, rise, "wire-7x19-12", pretension="15 kN")
    assert by_pull.tensions[0] == pytest.approx(15e3, rel=1e-9)
    again = rw.line(300.0, rise, "wire-7x19-12", length=by_pull.length)
    assert again.cable == by_pull.cable
    forces = np.array(by_pull.anchor_forces)
    weight = by_pull.cable.weight * by_pull.length
    assert forces.sum(axis=0) == pytest.approx([0.0, weight], abs=1e-6 * 15e3)
    assert by_pull.utilisation == pytest.approx(max(by_pull.tensions) / 98.78e3, rel=1e-3)
    assert by_pull.safety_factor == pytest.approx(1.0 / (by_pull.utilisation or math.nan))


def test_a_taut_line_is_shorter_than_its_span_and_runs() -> None:
    line = rw.line(300.0, 0.0, "wire-7x19-12", sag=2.0)
    assert line.length < 300.0
    rest = rw.equilibrium(line.scene(60))
    assert float(rest.tension.max()) == pytest.approx(line.tensions[0], rel=1e-3)
    assert -float(rest.positions[0, :, 2].min()) == pytest.approx(2.0, rel=1e-3)


def test_a_line_of_what_does_not_stretch() -> None:
    rigid = rw.Material(EA=math.inf, mass_per_length=0.5)
    assert rw.line(100.0, 10.0, rigid, sag=3.0).sag == pytest.approx(3.0, rel=1e-6)
    with pytest.raises(SceneError, match="does not stretch"):
        rw.line(100.0, 10.0, rigid, length=100.0)


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ({}, "give one of sag, pretension and length"),
        ({"sag": 1.0, "length": 301.0}, "sag, length"),
        ({"sag": "3 kg"}, "of another kind"),
        ({"sag": "2cm%"}, "or a share of the span such as"),
        ({"sag": -1.0}, "greater than 0"),
        ({"pretension": 10.0}, "10.0 - must be from 1.218 kN to 6.376 MN"),
        ({"pretension": "15 kgf"}, '"15 kgf" - must be from 1.218 kN'),
        ({"sag": "-2 %"}, "must be a share of the span greater than 0"),
        ({"sag": "1/2 %"}, "must be a length such as"),
        ({"length": "10 m"}, '"10 m" - must be at least'),
        ({"length": 10.0}, "set up with at most 90 % of stretch"),
        ({"length": 1e5}, "must be at most"),
        ({"sag": "x"}, "must be a number of m"),
    ],
)
def test_what_cannot_be_is_refused(given: dict[str, object], words: str) -> None:
    with pytest.raises(SceneError, match=words):
        rw.line(300.0, 0.0, "wire-7x19-12", **given)  # type: ignore[arg-type]


def test_a_sag_may_be_a_share_in_any_form() -> None:
    units = pint.UnitRegistry()
    for sag in ("2 %", "2 percent", 2 * units.percent, "6 m", 6.0, 600 * units.centimeter):
        assert rw.line(300.0, 0.0, "wire-7x19-12", sag=sag).sag == pytest.approx(6.0)  # type: ignore[arg-type]


def test_places_of_a_load_may_have_units() -> None:
    line = rw.line("300 m", 0.0, "wire-7x19-12", sag="2 %")
    one = line.rolling("80 kg", at=150.0)
    assert line.rolling("80 kg", at="150 m").table == one.table
    assert line.rolling(
        "80 kg", at=["100 m", 15000 * pint.UnitRegistry().cm]
    ).place == pytest.approx([100, 150])
    with pytest.raises(SceneError, match='at: "150 kg" - is of another kind'):
        line.rolling("80 kg", at="150 kg")
    with pytest.raises(SceneError, match="must be places in m"):
        line.rolling("80 kg", at="middle")
    with pytest.raises(ValueError, match="places: 2.5 - must be a whole number"):
        line.rolling("80 kg", places=2.5)  # type: ignore[arg-type]


def test_the_scene_of_a_line_has_its_length() -> None:
    with pytest.raises(
        SceneError, match=r"length: 3 - is that of the line, 10\.\d+ m; set up another"
    ):
        rw.line(10.0, 0.0, "wire-7x19-12", sag=1.0).scene(length=3)


def test_a_line_makes_up_no_diameter() -> None:
    """A material has none: the scene of its line has 10 mm to what it touches only where they are given."""
    wire = rw.rope("wire-7x19-12")
    for rope, given, half in (
        (wire, None, 0.006),
        (wire, "8 mm", 0.004),
        (wire.material(), "8 mm", 0.004),
        (wire.material(), None, 0.0),
    ):
        line = rw.line(300.0, 0.0, rope, sag="2 %", diameter=given)
        (made,) = line.scene().ropes
        assert radius_of(made) == half
        assert (line.diameter is None) == (half == 0.0)
        said = {row[0]: row[1] for row in rope_section(line.scene()).items[0].rows}["diameter"]  # type: ignore[union-attr]
        assert said.startswith(
            "not given: none to obstacles" if half == 0.0 else f"{2e3 * half:g} mm"
        )


@pytest.mark.parametrize(
    ("given", "words"),
    [
        (
            {"span": 300.0, "sag": 0.02},
            'is 0.00667 % of the span; a share of it is written as "2 %"',
        ),
        ({"span": 300.0, "sag": "2 %"}, ""),
        ({"span": "300 mm", "sag": "2 %"}, "the span is 25 times the rope's diameter of 12 mm"),
        ({"span": "300 km", "sag": "5 %"}, "longer than any; millimetres for metres?"),
        ({"span": 300.0, "length": 200.0}, "by 50 %; kN for N, or grams for kilograms?"),
    ],
)
def test_slips_of_units_in_a_line_are_told(given: dict[str, Any], words: str) -> None:
    line = rw.line(given.pop("span"), 0.0, "wire-7x19-12", **given)
    told = " ".join(line.notes())
    assert words in told
    assert bool(told) is bool(words)
    assert all(note in str(line) for note in line.notes())


def test_a_load_of_grams_is_told_and_rubber_may_stretch() -> None:
    webbing = rw.Material(EA=1e5, mass_per_length=0.06)
    line = rw.line(60.0, 0.0, webbing, sag="2 %")
    assert "grams for kilograms?" in str(line.rolling(80e3, at=30.0))
    assert "grams" not in str(line.rolling(80.0, at=30.0))
    stiff = rw.line(150.0, 0.0, webbing.replace(EA=math.inf, mass_per_length=0.5), sag="3 m")
    assert stiff.rolling("1 t", at=75.0).notes() == []
    told = ""
    try:
        told = str(stiff.rolling("1 Mt", at=75.0).notes())
    except ArithmeticError as error:  # no rest is found: the slip is told with that
        told = str(error)
    assert "times the line's own mass; grams for kilograms?" in told
    rubber = rw.Material(EA=75.0, mass_per_length=0.047)
    assert rw.line(2.0, 0.0, rubber, pretension=50.0).notes() == []


def test_a_climbing_rope_is_taken_as_it_is_at_rest() -> None:
    """A line is at rest, and the label's fall is no load at rest: three times the stiffness."""
    single = rw.rope("dynamic-single-9.8")
    for rope in ("dynamic-single-9.8", single):
        line = rw.line(30.0, 0.0, rope, sag="2 %")
        assert single.EA_static == line.material.EA
        assert line.material.relaxing_EA == single.relaxing_EA
    assert rw.line(30.0, 0.0, "dynamic-single-9.8:static", sag=1.0).material.relaxing_EA is None
    assert "breaking load not known" in str(line)
    rest = rw.equilibrium(line.scene(60))
    assert float(rest.tension.max()) == pytest.approx(max(line.tensions), rel=1e-3)
    half = rw.line(30.0, 0.0, "dynamic-half-8", pretension="1 kN")
    assert rw.rope("dynamic-half-8").EA_static == half.material.EA
    assert "EA 8.1 kN is a guess, from 6.08 kN to 10.5 kN" in str(half)


def test_guesses_of_a_line_are_told_with_what_they_make_of_it() -> None:
    line = rw.line(30.0, 0.0, "semistatic-10.5", sag="2 %")
    guess = rw.rope("semistatic-10.5").numbers["EA"]
    assert guess.low is not None
    assert guess.high is not None
    soft, stiff = line.with_EA(guess.low), line.with_EA(guess.high)
    assert soft.sag == pytest.approx(line.sag, rel=1e-9)
    assert soft.length < line.length < stiff.length
    assert f"length to cut {soft.length:.6g} to {stiff.length:.6g} m" in str(line)
    pulls = [one.rolling(80.0).largest_tension.max() for one in (soft, line, stiff)]
    assert pulls[0] < pulls[1] < pulls[2]
    assert f"the largest is {pulls[0] / 1e3:.4g} kN to {pulls[2] / 1e3:.4g} kN" in str(
        line.rolling(80)
    )
    for sure in (
        rw.line(30.0, 0.0, "wire-7x19-12", sag=1.0),
        rw.line(30.0, 0.0, line.material.replace(EA=25e3), sag=1),  # its own number is no guess
    ):
        assert "guess" not in str(sure)
        assert "with EA" not in str(sure.rolling(80.0))
    assert "EA 32.2 kN is a guess" in str(rw.line(30.0, 0.0, line.material, sag=1))
    # where an end of the range cannot be set up nothing was said, as of what is known
    short = rw.line(10.0, 0.0, "bungee-8", pretension="300 N")
    assert "EA 512 N is a guess, from 250 N to 1 kN" in str(short)
    assert "EA is a guess" in str(short.rolling(5.0))


def test_an_unknown_rope_and_none() -> None:
    with pytest.raises(rw.UnknownRope, match="did you mean"):
        rw.line(300.0, 0.0, "wire-7x19-13", sag=3.0)
    with pytest.raises(SceneError, match="must be a name of the library"):
        rw.line(300.0, 0.0, 3, sag=3.0)  # type: ignore[arg-type]
    with pytest.raises(SceneError, match="one EA only"):
        rw.line(300.0, 0.0, "wire-7x19-12:static", sag=3.0)


@pytest.mark.parametrize("held", [False, True])
@pytest.mark.parametrize("length", [99.5, 100.2, 110.0])
def test_forces_on_a_rolling_load_balance(length: float, held: bool) -> None:
    line = rw.line(100.0, -5.0, "wire-7x19-8", length=length)
    found = line.rolling(80.0, held=held, places=9)
    total = found.anchor_start + found.anchor_end
    weight = line.cable.weight * line.length + 80.0 * 9.81
    assert total[:, 1] == pytest.approx(np.full(9, weight), rel=1e-6)
    # Across, what holds the load is all that is left.
    assert total[:, 0] == pytest.approx(-found.holding, abs=1e-5 * weight)
    if held:
        assert np.abs(found.holding).max() == 0.0
    else:
        assert found.tension_left == pytest.approx(found.tension_right, rel=1e-6)
    assert (found.sag >= 0.0).all()


def test_a_rolling_load_is_where_statics_has_it() -> None:
    """A load held by the rope, against a chain of masses and springs with the load at a node."""
    line = rw.line(100.0, -5.0, "wire-7x19-8", sag="2 %")
    scene = line.scene(200, loads=[{"node": 60, "mass": 80.0}])
    rest = rw.equilibrium(scene)
    found = line.rolling(80.0, held=True, at=float(rest.positions[0, 60, 0]))
    assert found.height[0] == pytest.approx(float(rest.positions[0, 60, 2]), abs=1e-3)
    assert found.largest_tension[0] == pytest.approx(float(rest.tension.max()), rel=1e-3)
    assert np.linalg.norm(rest.reactions[0, 0]) == pytest.approx(found.tension_start[0], rel=1e-3)


def test_a_rolling_load_s_table_and_figure() -> None:
    found = rw.line(100.0, -5.0, "wire-7x19-8", sag="2 %").rolling("80 kg", places=5)
    assert len(found.table) == 5
    assert found.table[2]["place [m]"] == pytest.approx(50.0)
    assert found.utilisation is not None
    assert found.table[2]["utilisation [1]"] == float(found.utilisation[2])
    figure = found.figure()
    labels = [axes.get_ylabel() for axes in figure.axes]
    assert "tension [kN]" in labels
    assert "force on the rope [kN]" in labels
    with pytest.raises(ValueError, match="places between 0 and 100"):
        rw.line(100.0, 0.0, "wire-7x19-8", sag=2.0).rolling(80.0, at=[120.0])


def test_materials_from_data_sheets() -> None:
    M = rw.Material
    assert pytest.approx(80 * 9.80665 / 0.08) == M.from_elongation("80 kgf", "8 %", 0.063).EA
    broken = M.from_break("50 kN", 0.04, "45 g/m", EI=0.1)
    assert (broken.EA, broken.breaking_load, broken.EI) == (pytest.approx(1.25e6), 5e4, 0.1)
    wire, known = M.of_wire("6X36-iwrc", "16 mm"), rw.rope("wire-6x36-iwrc-16")
    assert pytest.approx(known.EA, rel=1e-3) == wire.EA
    assert wire.mass_per_length == pytest.approx(known.mass_per_length, rel=1e-3)
    assert wire.breaking_load == pytest.approx(known.breaking_load, rel=1e-3)
    mean = M.from_fall(8464.0, 0.3315, 0.0649)
    assert (mean.EA, mean.axial_damping) == (
        pytest.approx(25370, rel=1e-3),
        pytest.approx(282, rel=2e-3),
    )


def test_data_sheets_that_cannot_be() -> None:
    M = rw.Material
    with pytest.raises(SceneError, match="weight is written in kgf"):
        M.from_fall("8.8 kg", "32 %", 0.06)
    with pytest.raises(SceneError, match='such as 0.08 or "8 %"'):
        M.from_elongation(800.0, "8", 0.06)
    with pytest.raises(ValueError, match=r"must be from 5339 to 102\d0 N"):
        M.from_fall(20e3, 0.32, 0.06)
    with pytest.raises(SceneError, match="32 - must be a share such as"):
        M.from_fall(8800.0, 32, 0.06)
    with pytest.raises(ValueError, match="6x36 IWRC"):
        M.of_wire("5x5", 0.01)


@pytest.mark.parametrize(
    ("made", "words"),
    [
        (
            lambda M: M.from_elongation("1 kN", 3, 0.06),
            '3 - may be 3 % or 300 %; write it as "3 %"',
        ),
        (lambda M: M.from_break("50 kN", 4.0, 0.06), "may be 4 % or 400 %"),
        (lambda M: M.from_fall(8800, 0.32, 0.06, static_elongation=9.3), "9.3 - must be a share"),
        (lambda M: M.of_wire("7x7", 16), "16 - is 16 m, and no wire rope is thicker"),
        (lambda M: M.of_wire("7x7", "16 mm", grade=17700), "17700 - must be from 200 to 3500"),
        (
            lambda M: M.from_fall(8800, 0.32, 0.06, static_elongation=0.09, later_force="6 kN"),
            '"6 kN" - must be at least impact_force, 8800 N',
        ),
        (
            lambda M: M.from_fall(8.8, 0.32, 0.06),
            '; kN for N? Write it as "8.8 kN"',
        ),
        (
            lambda M: M.from_fall("8.8 kN", "0.32 %", 0.06),
            "is 0.32 %, and no rope stretches so little in a fall; 32 %?",
        ),
        (lambda M: M.from_fall("8.8 kN", 0.32, 61), "mass_per_length: 61 - must be at most 1 kg/m"),
        (
            lambda M: M.from_fall("8.8 kN", 0.32, 0.06, length=2800),
            "must be at most 300 m; it is taken",
        ),
        (
            lambda M: M.from_fall("8.8 kN", 0.32, 0.06, factor=177),
            "factor: 177 - must be at most 10",
        ),
        (lambda M: M.from_fall("8.8 kN", 0.32, 0.06, factor="x"), 'factor: "x" - must be a number'),
        (
            lambda M: M.from_fall("8.8 kN", 0.32, 0.06, static_elongation="93 %"),
            '"93 %" - must be below dynamic_elongation, 32 %',
        ),
        (
            lambda M: M.from_fall("8.8 kN", 0.32, 0.06, static_elongation="1 %"),
            'static_elongation: "1 %" - makes a rope of EA 73526 N at rest, which must be below',
        ),
        (
            lambda M: M.from_fall("8.8 kN", 0.32, 0.06, static_elongation=0.09, edge_friction=50),
            "edge_friction: 50 - must be at most 4",
        ),
    ],
)
def test_slips_of_a_hundred_and_a_thousand_in_data_sheets(made: Any, words: str) -> None:
    with pytest.raises(SceneError) as error:
        made(rw.Material)
    assert words in str(error.value)


def test_half_and_twin_ropes_taken_for_single_ones_are_told_how_they_fall() -> None:
    """A label of 55 kg, or of two strands, in the place of another."""
    M = rw.Material
    half = {"static_elongation": "9 %"}
    with pytest.raises(SceneError, match='"6 kN" - must be from .*half rope.*falling_mass=55'):
        M.from_fall("6 kN", "31 %", "42 g/m", **half)
    assert M.from_fall("6 kN", "31 %", "42 g/m", falling_mass=55, **half).relaxing_EA
    twin = {"static_elongation": "6 %", "falling_mass": 40, "static_load": 40}
    with pytest.raises(SceneError, match='"9 kN" - must be from .*twin rope.*half of it'):
        M.from_fall("9 kN", "31 %", "38 g/m", **twin)
    assert M.from_fall("4.5 kN", "31 %", "38 g/m", **twin).relaxing_EA
    with pytest.raises(SceneError, match="has no other$"):
        M.from_fall("90 kN", "31 %", "38 g/m", **half)


def test_a_wire_of_7x19_is_that_of_the_library() -> None:
    made, known = rw.Material.of_wire("7x19", "12 mm", grade=2070), rw.rope("wire-7x19-12")
    assert pytest.approx(known.EA, rel=1e-3) == made.EA
    assert made.mass_per_length == pytest.approx(known.mass_per_length, rel=1e-3)
    assert made.breaking_load == pytest.approx(known.breaking_load, rel=2e-3)
    with pytest.raises(ValueError, match="ropewalk ropes --family steel"):
        rw.Material.of_wire("1x37", "6 mm")


def test_a_strand_of_1x19_has_the_stretch_factor_and_no_breaking_load_unasked() -> None:
    made, known = rw.Material.of_wire("1x19", "6 mm"), rw.rope("wire-1x19-6")
    assert made.mass_per_length == pytest.approx(known.mass_per_length, rel=1e-3)
    assert pytest.approx(98.8e9 * 0.006**2) == made.EA
    assert pytest.approx(known.EA * 98.8 / 88.5, rel=1e-3) == made.EA  # the library's is stainless
    assert made.breaking_load is None
    asked = rw.Material.of_wire("1x19", "6 mm", guesses=True)  # of 1570 N/mm^2 by default
    metal = made.mass_per_length / 7850.0
    assert 0.8 <= asked.breaking_load / (1570e6 * metal) <= 0.92
    low = 0.477 / 0.507  # the one that was read is at the lower end of the range
    assert known.breaking_load == pytest.approx(low * asked.breaking_load, rel=0.02)


def test_locked_coil_rope_is_a_guess_and_only_there_when_asked_for() -> None:
    with pytest.raises(SceneError, match=r"without a source; guesses=True takes them"):
        rw.Material.of_wire("locked coil", "40 mm")
    made = rw.Material.of_wire("Locked-Coil", "40 mm", guesses=True)
    known = rw.rope("locked-coil-40")
    for mark in made.guessed:
        number = known.numbers[mark.of]
        ends = number.value, number.low, number.high
        assert (mark.value, mark.low, mark.high) == pytest.approx(ends, rel=4e-3)
        assert number.quality == "guess"


def test_a_share_above_one_may_be_written_with_its_unit() -> None:
    assert pytest.approx(10.0) == rw.Material.from_break("50 N", "500 %", 0.06).EA


def test_what_hoists_and_tows_pull_with() -> None:
    """v sqrt(k m) on top of the weight, and some more by the rope's own mass and damping."""
    for name, weight, speed, mass in (
        ("crane-snap", 2000 * 9.81, 0.5, 2000.0),
        ("hoist-stop", 2000 * 9.81, 1.0, 2000.0),
        ("tow", 0.0, 1.5, 1500.0),
    ):
        scene = rw.preset(name)
        rope = scene.ropes[0]
        k = rope.made_of.EA / (rope.length or math.nan)
        done = rw.simulate(scene)
        largest = float(np.linalg.norm(done.reactions, axis=2).max())
        assert largest == pytest.approx(weight + speed * math.sqrt(k * mass), rel=0.05), name
