"""`ropewalk sheet`: the report of a job."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from cli.conftest import SCENE


@pytest.fixture
def job(tmp_path: Path) -> str:
    (tmp_path / "job.toml").write_text(SCENE, encoding="utf-8")
    return "job.toml"


def test_a_sheet_as_html_and_pdf(ropewalk: Any, job: str, tmp_path: Path) -> None:
    done = ropewalk("sheet", job, "-o", "a.html", "-o", "a.pdf")
    assert done.exit_code == 0
    assert done.stdout == "a.html\na.pdf\n"
    assert "small" in (tmp_path / "a.html").read_text(encoding="utf-8")
    assert (tmp_path / "a.pdf").read_bytes().startswith(b"%PDF")


def test_a_sheet_has_a_name_of_its_own_and_replaces_nothing(
    ropewalk: Any, job: str, tmp_path: Path
) -> None:
    for name in ("job-sheet.html", "job-sheet-2.html"):
        assert ropewalk("sheet", job, "--at-rest", "--no-convergence").stdout == f"{name}\n"
    done = ropewalk("sheet", job, "-o", "job-sheet.html")
    assert done.exit_code == 2
    assert "exists already" in done.stderr


def test_a_sheet_as_json(ropewalk: Any, job: str) -> None:
    done = ropewalk("sheet", job, "--no-convergence", "--json")
    found = json.loads(done.stdout)
    assert found["files"] == ["job-sheet.html"]
    assert found["sections"]["Ropes"]["tables"][0]["unstretched length"] == "3 m"
    assert found["sections"]["Ropes"]["tables"][0]["what"] == "rope 'rope'"  # whose table it is
    assert "Forces of the ropes on the anchors" in found["sections"]["At rest"]["notes"][0]
    assert "Not looked at" in found["sections"]["Convergence"]["texts"][0]


def test_a_sheet_of_a_broken_run_is_written_and_told(
    ropewalk: Any, job: str, tmp_path: Path
) -> None:
    done = ropewalk("sheet", job, "--time-step", "0.1", "-o", "b.html")
    assert done.exit_code == 3
    assert "THE RUN BROKE" in (tmp_path / "b.html").read_text(encoding="utf-8")


def test_bad_sheets(ropewalk: Any, job: str) -> None:
    for options, text in (
        (("-o", "a.doc"), "must end in .html or .pdf"),
        (("-o", "job.toml/a.html"), "is a file, not a folder"),
        (("--uncertain", "rope.length"), "--uncertain: 'rope.length'"),
        (("--uncertain", "rope.length"), "such as rope.made_of.EA=10%"),
        (("--uncertain", "rope.length=3..x"), "--uncertain: 'rope.length=3..x'"),
        (("--uncertain", "rope.length=0%"), "must be per cents above 0 and up to 100"),
        (("--uncertain", "rope.length=3"), "or per cents such as 10 %"),
        (("--uncertain", "EA=10%"), "EA: unknown key here; write rope.made_of.EA"),
        (("--set", "EA=1e4"), "EA: unknown key here; write rope.made_of.EA"),
        (("--set", "rope.segments=0"), "segments: 0 - must be at least 1"),
    ):
        done = ropewalk("sheet", job, *options)
        assert done.exit_code == 2, options
        assert text in done.stderr
        assert "Traceback" not in done.stderr
        assert "at rest" not in done.output  # before anything is computed
