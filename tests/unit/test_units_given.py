"""Quantities with units at the door: TOML, command line and Python; stored in SI."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pint
import pytest
from click.testing import CliRunner

import ropewalk as rw
import ropewalk.scene as scene_module
from ropewalk.cli import main
from ropewalk.scene import Kick, Points, SceneError, Shake, apply_overrides, dumps, loads
from ropewalk.scene.as_given import as_given
from ropewalk.scene.units import WrongUnit, in_unit

TEXT = """
[run]
duration = "2 min"
time_step = "0.5 ms"
frame_rate = "30 Hz"
[[rope]]
segments = 10
length = "30 ft"
diameter = "12 mm"
[rope.made_of]
kind = "material"
EA = "5.65 MN"
mass_per_length = "63 g/m"
[rope.shape]
kind = "straight"
start = ["1 ft", 0, "10 cm"]
[[rope.force]]
node = 3
force = ["80 kgf", 0.0, "1 lbf"]
[[anchor]]
node = 0
"""


def test_a_file_gives_quantities_in_any_unit_and_stores_si() -> None:
    scene = loads(TEXT)
    rope = scene.ropes[0]
    assert rope.made_of.EA == 5.65e6  # type: ignore[union-attr]
    assert rope.made_of.mass_per_length == 0.063  # type: ignore[union-attr]
    assert rope.diameter == 0.012
    assert rope.length == pytest.approx(9.144, rel=1e-15)
    assert rope.shape.start == pytest.approx((0.3048, 0.0, 0.1), rel=1e-15)  # type: ignore[union-attr]
    assert rope.forces[0].force == pytest.approx((80 * 9.80665, 0.0, 4.4482216152605), rel=1e-14)
    assert (scene.run.duration, scene.run.time_step, scene.run.frame_rate) == (120.0, 0.0005, 30.0)
    assert loads(dumps(scene)) == scene
    assert "MN" not in dumps(scene)


def test_python_takes_texts_and_pints_own_quantities() -> None:
    units = pint.UnitRegistry()
    given = rw.Material(EA="25 kN", mass_per_length=65 * units.gram / units.meter)  # type: ignore[arg-type]
    assert given == rw.Material(EA=25e3, mass_per_length=0.065)
    assert given.EA == 25e3
    vector = Kick(node=0, velocity=[3.6, 0, 0] * units.kilometer / units.hour)  # type: ignore[arg-type]
    assert vector.velocity == pytest.approx((1.0, 0.0, 0.0))
    assert rw.Rope(segments=2, made_of=given, length=2.0).length == 2.0


def test_the_command_line_takes_them() -> None:
    done = CliRunner().invoke(
        main,
        ["check", "r4", "--json", "--duration", "500 ms", "--set", "rope.made_of.node_mass=40 g"],
    )
    found = json.loads(done.stdout)
    assert found["duration"] == pytest.approx(0.5)
    plain = CliRunner().invoke(
        main, ["check", "r4", "--json", "--duration", "0.5", "--set", "rope.made_of.node_mass=0.04"]
    )
    assert found["ropes"] == json.loads(plain.stdout)["ropes"]


@pytest.mark.parametrize(
    ("field", "given", "said"),
    [
        ("EA", "5.65 m", "is of another kind: a quantity in N is needed"),
        ("EA", "80 kg", "a weight is written in kgf or lbf"),
        ("EA", "5,65 MN", "with a point for the decimals"),
        ("EA", "11/2 MN", "with a point for the decimals"),
        ("EA", "5.65 MNN", "unit that is not known, 'MNN'"),
        ("EA", "5.65 cm%", "has % beside another unit"),
        ("EA", "5.65", "must be a number (N)"),
        ("EA", "lots", "must be a number (N)"),
        ("EA", "-3 kN", "must be greater than 0"),
        ("EA", "3 m^9999999", "is no number with a unit"),
        ("EA", "3 " + "m*" * 500 + "m", "is no number with a unit"),
        ("EA", "1 000", "is more than one number; write a list, [1, 000], or one alone"),
        ("EA", "1,2,3", "is more than one number; write a list, [1, 2, 3], or one alone"),
        # took half a minute, and thirty times longer with each further number
        ("EA", "1000  " * 8 + "m", "is no number with a unit"),
        ("mass_per_length", "63 g", "a quantity in kg/m is needed"),
        # was of 2000 lb, 907 kg, without a word
        ("mass_per_length", "1 ton/m", "may be of 1000 kg or of 2000 lb: write it in t, kg or lb"),
        ("mass_per_length", "2 ktons/m", "may be of 1000 kg or of 2000 lb"),
    ],
)
def test_what_is_no_such_quantity_is_refused_as_given(field: str, given: str, said: str) -> None:
    values: dict[str, Any] = {"EA": 1e4, "mass_per_length": 0.1, field: given}
    with pytest.raises(rw.SceneError) as raised:
        rw.Material(**values)
    text = str(raised.value)
    assert field in text
    assert said in text
    assert len(raised.value.faults) == 1
    if len(given) < 20 and not given.startswith("-"):
        assert given in text


def test_faults_are_still_told_together() -> None:
    with pytest.raises(rw.SceneError) as raised:
        rw.Material(EA="1 m", mass_per_length="1 s", EI=-1.0)  # type: ignore[arg-type]
    assert {fault.path for fault in raised.value.faults} == {"EA", "mass_per_length", "EI"}
    with pytest.raises(rw.SceneError, match=r"time_step.*a quantity in s is needed"):
        rw.RunSettings(time_step="3 m")  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("given", "unit", "number"),
    [
        ("5 Nm", "N m", 5.0),  # a count of yarn to pint
        ("5 kNm", "N m", 5e3),
        ("5 daNm", "N m", 50.0),
        ("5 mNm", "N m", 5e-3),
        ("5 Nm/rad", "N m/rad", 5.0),
        ("5 Nm^2", "N m^2", 5.0),
        ("5 Nm²", "N m^2", 5.0),
        ("5 kNm**2", "N m^2", 5e3),
        ("5 Nms", "N m s", 5.0),
        ("5 Nm s", "N m s", 5.0),
        ("5 Ns", "N s", 5.0),  # newtons to pint
        ("5 Ns/m", "N s/m", 5.0),
        ("5 kNs/m", "N s/m", 5e3),
        ("5 rad/Nm", "rad/(N m)", 5.0),
        ("5 1/Nms", "1/(N m s)", 5.0),
        ("5 Nmm", "N m", None),  # no sign between, and nothing guessed
        ("5 N/ms", "N/s", 5e3),
        ("5 newtons", "N", 5.0),
        ("5 t", "kg", 5e3),
        ("5 tonnes", "kg", 5e3),
    ],
)
def test_newtons_run_on_into_metres_and_seconds(
    given: str, unit: str, number: float | None
) -> None:
    found = in_unit(given, unit)
    if number is None:
        assert isinstance(found, WrongUnit)
        return
    assert found == pytest.approx(number, rel=1e-12)


def test_long_lists_have_units_too() -> None:
    """Lists of more than 64 parts were refused as no numbers, texts and all."""
    rope = rw.Rope(segments=99, made_of="wire-7x19-10", length=99.0)
    inches = rope.replace(shape=Points(points=[(f"{12 * i} in", 0.0, "1 ft") for i in range(100)]))
    assert inches.shape.points[99] == pytest.approx((99 * 0.3048, 0.0, 0.3048))
    with pytest.raises(rw.SceneError, match=r'points.*"1 s" - is of another kind'):
        rope.replace(shape=Points(points=[(0.0, 0.0, "1 s") for _ in range(100)]))
    numbers = [(float(i), 0.0, 0.0) for i in range(100)]
    assert in_unit(numbers, "m") is numbers  # not copied


def test_turns_are_no_numbers_per_second() -> None:
    """pint takes 60 rpm for 6.28 Hz, and 1 Hz for 1 rad/s: both are refused."""
    assert isinstance(in_unit("60 rpm", "1/s"), WrongUnit)
    assert isinstance(in_unit("1 Hz", "rad/s"), WrongUnit)
    assert in_unit("60 rpm", "rad/s") == pytest.approx(6.283185307, rel=1e-9)
    assert in_unit("90 deg", "rad") == pytest.approx(1.5707963268, rel=1e-9)
    assert in_unit("5 %", "1") == pytest.approx(0.05)
    shaken = Shake(axis=(0, 0, 1), amplitude="10 cm", frequency="2 Hz")  # type: ignore[arg-type]
    assert (shaken.amplitude, shaken.frequency) == (0.1, 2.0)


def test_every_unit_of_the_scene_is_known_to_pint() -> None:
    units = set()
    for model in vars(scene_module).values():
        for field in getattr(model, "model_fields", {}).values():
            if isinstance(field.json_schema_extra, dict) and "unit" in field.json_schema_extra:
                units.add(str(field.json_schema_extra["unit"]))
    assert {"N", "m", "kg/m", "N/m", "s"} <= units
    for unit in units - {"1"}:
        assert in_unit(f"2.5 {unit}", unit) == 2.5, unit


def test_plain_numbers_need_no_pint() -> None:
    code = "import sys, ropewalk as rw; rw.preset('r4'); print('pint' in sys.modules)"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.stdout.strip() == "False", done.stderr


def test_a_weight_for_a_mass_says_how_a_mass_is_written() -> None:
    with pytest.raises(rw.SceneError, match="in kg is needed; a mass is written in kg or lb"):
        rw.Load(node=0, mass="80 kgf")  # type: ignore[arg-type]


def test_quantities_of_a_file_are_shown_as_they_were_given(tmp_path: Path) -> None:
    """In check and on the sheet; what a flag has made another, and plain numbers, are not among them."""
    file = tmp_path / "job.toml"
    file.write_text(TEXT, encoding="utf-8")
    found = {one.path: (one.given, one.stored) for one in as_given(file, loads(TEXT))}
    assert found["rope[0].length"] == ("30 ft", "9.144 m")
    assert found["rope[0].made_of.EA"] == ("5.65 MN", "5.65e+06 N")
    assert found["rope[0].shape.start"] == ("(1 ft, 0, 10 cm)", "(0.3048, 0, 0.1) m")
    assert found["rope[0].force[0].force"] == ("(80 kgf, 0, 1 lbf)", "(784.532, 0, 4.44822) N")
    assert found["run.time_step"] == ("0.5 ms", "0.0005 s")
    assert len(found) == 9
    done = CliRunner().invoke(main, ["check", str(file), "--set", "rope.length=5"])
    assert "as given: rope[0].diameter = 12 mm, 0.012 m" in done.stdout
    assert "rope[0].length" not in done.stdout
    told = json.loads(CliRunner().invoke(main, ["check", str(file), "--json"]).stdout)["as_given"]
    assert {"path": "run.duration", "given": "2 min", "stored": "120 s"} in told
    sheet = rw.sheet(file, run=False, convergence=False)
    assert "30 ft" in str(sheet.section("As given"))
    assert as_given("r4", rw.preset("r4")) == []
    plain = as_given(file, loads(TEXT))
    file.write_text(TEXT, encoding="utf-8-sig")  # as some editors begin a file
    assert as_given(file, loads(TEXT)) == plain
    with pytest.raises(KeyError, match="As given"):
        rw.sheet("hanging-rope", run=False, convergence=False).section("As given")


def test_a_share_is_shown_as_a_plain_number(tmp_path: Path) -> None:
    """It read "30 %, 0.3 1"."""
    text = TEXT + '\n[[obstacle]]\nkind = "plane"\npoint = [0, 0, -9]\nfriction = "30 %"\n'
    file = tmp_path / "job.toml"
    file.write_text(text, encoding="utf-8")
    found = {one.path: str(one) for one in as_given(file, loads(text))}
    assert found["obstacle[0].friction"] == "obstacle[0].friction = 30 %, 0.3"
    flag = "obstacle[0].friction=5 %"
    found = {
        one.path: str(one) for one in as_given(file, apply_overrides(loads(text), [flag]), [flag])
    }
    assert found["obstacle[0].friction"] == "obstacle[0].friction = 5 %, 0.05"


def test_quantities_of_flags_are_shown_as_they_were_given(tmp_path: Path) -> None:
    """Of a preset, too. A flag takes the place of the file's; of two the last one stands."""
    file = tmp_path / "job.toml"
    file.write_text(TEXT, encoding="utf-8")
    sets = ["--set", 'rope.length="40 ft"', "--set", "rope.made_of.EA=3 MN", "--duration", "3 min"]
    done = CliRunner().invoke(main, ["check", str(file), *sets])
    assert "as given: rope[0].length = 40 ft, 12.192 m" in done.stdout
    assert "as given: rope[0].made_of.EA = 3 MN, 3e+06 N" in done.stdout
    assert "as given: run.duration = 3 min, 180 s" in done.stdout
    assert "30 ft" not in done.stdout
    flags = ["rope.length=40 ft", "rope.length=50 ft", "gravity[2]=-32 ft/s^2", "rope.segments=30"]
    scene = apply_overrides(rw.preset("hanging-rope"), flags)
    found = {one.path: one.given for one in as_given("hanging-rope", scene, flags)}
    assert found == {"rope[0].length": "50 ft", "gravity[2]": "-32 ft/s^2"}
    flags = [
        'rope.made_of={EA="5.65 MN", mass_per_length="63 g/m", kind="material"}',
        'rope.loads=[{node=3, mass="10 lb"}, {node=4, mass=2}]',
        'rope.shape={kind="straight", end=["40 ft", 0, 0]}',
    ]
    scene = apply_overrides(rw.preset("hanging-rope"), flags)
    found = {one.path: one.given for one in as_given("hanging-rope", scene, flags)}
    assert found == {  # tables given whole had nothing shown
        "rope[0].made_of.EA": "5.65 MN",
        "rope[0].made_of.mass_per_length": "63 g/m",
        "rope[0].load[0].mass": "10 lb",
        "rope[0].shape.end": "(40 ft, 0, 0)",
    }
    asked = ["sheet", "hanging-rope", "--at-rest", "--no-convergence", "--json", "-o"]
    told = CliRunner().invoke(
        main, [*asked, str(tmp_path / "a.html"), "--set", "rope.length=40 ft"]
    )
    assert "40 ft" in told.stdout


@pytest.mark.parametrize("kind", [np.int64, np.float32, np.float64, np.array])
def test_numbers_of_numpy_are_numbers(kind: Any) -> None:
    """Whole ones, short ones and arrays of no dimension were "no number"."""
    made = rw.Material.from_elongation(kind(800), "8 %", 0.0625)
    assert rw.Material.from_elongation(800, "8 %", 0.0625) == made
    assert rw.Material.from_break(50000.0, kind(1) * 0.25, 0.0625).EA == 2e5
    line = rw.line(kind(100), kind(-5), made, sag=kind(4), gravity=kind(10))
    assert line == rw.line(100, -5, made, sag=4, gravity=10)
    assert rw.line(100, 0, made, pretension=kind(500)) == rw.line(100, 0, made, pretension=500)
    rolled = line.rolling(kind(80), places=np.int64(3))
    assert rolled.sag.tolist() == line.rolling(80, places=3).sag.tolist()
    with pytest.raises(SceneError, match=r"may be 3 % or 300 %"):
        rw.Material.from_elongation(800, kind(3), 0.0625)
    for wrong in (kind(-3), np.bool_(True)):
        with pytest.raises(SceneError, match=r"span: (-3|-3\.0|true) - must be a number of m"):
            rw.line(wrong, 0, made, sag=1.0)
