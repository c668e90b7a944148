"""`ropewalk line`: a line by its sag, pretension or length, and a load along it."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

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
