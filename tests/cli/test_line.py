"""`ropewalk line`: a line by its sag, pretension or length, and a load along it."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

import ropewalk as rw
from ropewalk.scene import load


def test_a_line_with_a_load(ropewalk: Any, tmp_path: Path) -> None:
    done = ropewalk(
        "line", "wire-7x19-12", "--span", "300 m", "--sag", "2 %", "--load", "80 kg", "-o", "a.png"
    )
    assert done.exit_code == 0
    for words in (
        "sag 6 m, 2 %",
        "safety factor 9.77",
        "largest tension 14.39 kN",
        "utilisation %",
    ):
        assert words in done.stdout
    assert (tmp_path / "a.png").stat().st_size > 10_000


def test_a_line_as_json_and_as_a_scene(ropewalk: Any, tmp_path: Path) -> None:
    done = ropewalk(
        "line", "wire-7x19-12", "--span", "300", "--rise=-5", "--pretension", "15 kN", "--json",
        "--load", "80", "-o", "b.toml",
    )  # fmt: skip
    found = json.loads(done.stdout)
    assert found["tensions"][0] == pytest.approx(15e3)
    assert len(found["rolling"]) == 41
    scene = load(tmp_path / "b.toml")
    assert scene.ropes[0].length == pytest.approx(found["length"])
    assert scene.ropes[0].made_of.library == "wire-7x19-12"
    assert [(load.node, load.mass) for load in scene.ropes[0].loads] == [(30, 80.0)]


def test_the_scene_of_a_line_has_its_load_in_the_middle(ropewalk: Any, tmp_path: Path) -> None:
    """Without it, whoever makes a sheet of the scene signs half of the tension."""
    options = ("--span", "150", "--sag", "3 m", "--load", "100")
    done = ropewalk("line", "wire-7x19-12", *options, "-o", "job.toml")
    assert "hangs still at the middle, node 30" in done.stdout
    most = float(done.stdout.split("largest tension ")[1].split(" kN")[0])
    rest = rw.equilibrium(load(tmp_path / "job.toml"))
    assert rest.tension.max() == pytest.approx(1e3 * most, rel=0.01)
    done = ropewalk("line", "wire-7x19-12", *options[:-2], "-o", "bare.toml")
    assert "hangs still" not in done.stdout
    assert not load(tmp_path / "bare.toml").ropes[0].loads


def test_bad_lines(ropewalk: Any) -> None:
    for options, words in (
        (("--span", "300"), "give one of sag"),
        (("--span", "300 kg", "--sag", "2"), "of another kind"),
        (("--span", "300", "--sag", "2", "-o", "x.pdf"), "needs a load"),
        (("--span", "300", "--sag", "2", "-o", "x.doc"), "must end in"),
        (("--span", "300", "--sag", "2", "--load", "x"), "must be a number of kg"),
        (("--span", "300", "--sag", "2", "--load", "80 kgf"), "load: "),
        (("--span", "300", "--sag", "2", "--rise", "3 kg"), "rise: "),
    ):
        done = ropewalk("line", "wire-7x19-12", *options)
        assert done.exit_code == 2
        assert words in done.stderr
