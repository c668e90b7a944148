"""What `.ci/run` says of tests that fail: the script itself, on a folder of toy tests."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

SCRIPT = Path(__file__).resolve().parents[2] / ".ci" / "run"
MAKEFILE = """
dev lint docs page-check: ; @true
test-all: ; .venv/bin/python -m pytest -m "not browser and not uncompiled"
test-uncompiled: ; .venv/bin/python -m pytest -m uncompiled
test-browser: ; .venv/bin/python -m pytest -m browser tests/browser
"""
TESTS = """
from pathlib import Path
import pytest

def passes_from(run):
    count = Path(__file__).with_suffix(".count")
    count.write_text(count.read_text() + "x" if count.exists() else "x")
    return len(count.read_text()) >= run

@pytest.mark.MARK
@pytest.mark.parametrize("name", ["a b"])
def test_that(name):
    assert passes_from(RUN)

@pytest.mark.MARK
@pytest.mark.parametrize("other", range(OTHERS))
def test_others(other):
    assert FINE
"""


def toy(folder: Path, **runs: int | str) -> Path:
    """Make a folder with the script and tests of each kind, which pass from their `runs` on."""
    (folder / ".ci").mkdir()
    shutil.copy(SCRIPT, folder / ".ci" / "run")
    (folder / "Makefile").write_text(MAKEFILE)
    marks = "\n".join(f"    {mark}: one" for mark in ("browser", "uncompiled", "fast"))
    (folder / "pytest.ini").write_text(f"[pytest]\naddopts = -ra\nmarkers =\n{marks}\n")
    programs = folder / ".venv" / "bin"
    programs.mkdir(parents=True)
    for name, does in (
        ("python", f'exec "{sys.executable}" "$@"'),
        ("chromium", "true"),
        ("npm", "true"),
    ):
        (programs / name).write_text(f"#!/bin/sh\n{does}\n")
        (programs / name).chmod(0o755)
    (folder / "tests" / "browser").mkdir(parents=True)
    for mark, where in (("fast", "tests"), ("uncompiled", "tests"), ("browser", "tests/browser")):
        made = TESTS.replace("MARK", mark).replace("RUN", str(runs.get(mark, 1)))
        made = made.replace("FINE", str(runs.get("fine", True))).replace("OTHERS", "3")
        (folder / where / f"test_{mark}.py").write_text(made)
    return folder


def run(folder: Path) -> tuple[int, str]:
    """Run it; return its exit status and its last lines."""
    env = {
        key: value
        for key, value in os.environ.items()
        if not key.startswith(("PYTEST", "COV_", "MAKE"))
    }
    env["PYTEST_DISABLE_PLUGIN_AUTOLOAD"] = "1"  # they take longer to load than all else here
    env["PATH"] = f"{folder / '.venv' / 'bin'}:{env['PATH']}"
    script = ["bash", ".ci/run"]
    done = subprocess.run(script, cwd=folder, env=env, capture_output=True, text=True, check=False)
    return done.returncode, "\n".join(done.stdout.splitlines()[-12:])


@pytest.mark.parametrize("mark", ["fast", "browser"])
def test_what_passes_twice_alone_is_named(tmp_path: Path, mark: str) -> None:
    status, said = run(toy(tmp_path, **{mark: 2}))
    assert status == 0, said
    assert "FAILED AMONG OTHERS" in said
    assert f"test_{mark}.py::test_that[a b]" in said


@pytest.mark.parametrize(
    "runs",
    [{"fast": 3}, {"browser": 99}, {"uncompiled": 2}, {"fine": False}],
    ids=["once more", "always", "uncompiled", "many"],
)
def test_other_failures_are_red_and_all_is_looked_at(tmp_path: Path, runs: dict[str, int]) -> None:
    status, said = run(toy(tmp_path, **runs))
    assert status != 0
    assert "FAILED AMONG OTHERS" not in said
    assert "make test-browser: " in said
    assert "make lint docs page-check" in said


def test_what_passes_is_green(tmp_path: Path) -> None:
    status, said = run(toy(tmp_path))
    assert status == 0, said
    assert "failed" not in said.lower()
