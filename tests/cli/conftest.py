"""How the tests call the command line: in this process, or as a process of its own."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from patience import PATIENCE
from ropewalk import loads, simulate
from ropewalk.cli import main

SCENE = """\
name = "small"
[run]
duration = 0.5
time_step = 0.002
[[rope]]
segments = 6
[rope.made_of]
kind = "springs"
spring_constant = 500.0
node_mass = 0.05
spring_friction = 0.05
segment_length = 0.5
[[anchor]]
node = 0
[[anchor]]
node = -1
"""

Call = Callable[..., Result]


@pytest.fixture(scope="session", autouse=True)
def compiled() -> None:
    """Compile both variants of the default method, so that no test is the first run on this machine."""
    simulate(loads(SCENE))
    simulate(loads(SCENE).replace(ground={"height": -1e3}))


@pytest.fixture
def ropewalk(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Call:
    """Call the command line in this process, in an empty folder."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", "160")

    def call(*arguments: object) -> Result:
        return CliRunner().invoke(main, [str(argument) for argument in arguments])

    return call


@pytest.fixture
def scene(tmp_path: Path) -> Path:
    """A small scene file."""
    path = tmp_path / "scene.toml"
    path.write_text(SCENE)
    return path


@pytest.fixture
def process(tmp_path: Path) -> Callable[..., subprocess.CompletedProcess[str]]:
    """Call the command line as a process of its own, its output piped."""

    def call(*arguments: object, **options: object) -> subprocess.CompletedProcess[str]:
        return subprocess.run(
            [sys.executable, "-m", "ropewalk", *map(str, arguments)],
            capture_output=True,
            text=True,
            check=False,
            cwd=tmp_path,
            env=os.environ
            | {
                "PYTHONWARNINGS": "error::ResourceWarning",
                "PYTHONDONTWRITEBYTECODE": "1",  # a limit on file size would cut it short for good
            },
            timeout=PATIENCE,
            **options,  # type: ignore[call-overload]
        )

    return call
