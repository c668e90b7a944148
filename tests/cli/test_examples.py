"""Every example runs and passes its own check, and the check can fail."""

from __future__ import annotations

import runpy
from pathlib import Path
from typing import Any

import pytest

FOLDER = Path(__file__).resolve().parents[2] / "examples"
SCRIPTS = sorted(FOLDER.glob("*.py"))


@pytest.mark.parametrize("script", SCRIPTS, ids=lambda path: path.stem)
def test_example(script: Path, capsys: pytest.CaptureFixture[str]) -> None:
    names: dict[str, Any] = runpy.run_path(str(script), run_name="__main__")
    assert capsys.readouterr().out
    assert names["check"].__doc__


def test_every_example_is_listed() -> None:
    page = (FOLDER / "README.md").read_text(encoding="utf-8")
    assert len(SCRIPTS) == 10
    for script in SCRIPTS:
        assert f"[`{script.name}`]({script.name})" in page


def test_a_check_can_fail() -> None:
    mesh = runpy.run_path(str(FOLDER / "mesh.py"))
    with pytest.raises(AssertionError):
        mesh["check"]({"material": {20: 1.0, 80: 1.1}, "springs": {20: 1.0, 80: 3.0}})
