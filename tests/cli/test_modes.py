"""`ropewalk modes`, and runs that start at rest."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from cli.conftest import Call


def test_modes_prints_a_table(ropewalk: Call, scene: Path) -> None:
    done = ropewalk(
        "modes", scene, "--count", 4, "--set", "rope.shape={kind='straight', end=[3.1,0,0]}"
    )
    assert done.exit_code == 0, done.output
    assert "small: modes about its equilibrium" in done.stdout
    assert done.stdout.count(" Hz ") == 4
    assert "out of plane, 1" in done.stdout
    assert [path.name for path in scene.parent.iterdir()] == ["scene.toml"]


def test_modes_as_json_and_as_a_figure(ropewalk: Call, scene: Path) -> None:
    done = ropewalk("modes", scene, "--json", "--about", "start", "-o", "modes.png")
    found = json.loads(done.stdout)
    assert found["about"] == "start"
    assert len(found["modes"]) == 10
    assert {"frequency [Hz]", "damping ratio [1]", "motion"} <= set(found["modes"][0])
    assert (scene.parent / "modes.png").stat().st_size > 10_000
    again = ropewalk("modes", scene, "-o", "modes.png")
    assert again.exit_code == 2
    assert "exists already" in again.stderr


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("--count", "0"), "0 is not in the range"),
        (("-o", "modes.txt"), "must end in .png"),
        (("--about", "rest"), "rest"),
        (("--set", "anchor=[]"), "no anchor holds it"),
        (
            (
                *("--about", "start", "--set", "rope.made_of.tension_only=true"),
                *("--set", "rope.shape={kind='straight', end=[1, 0, 0]}"),
            ),
            "where it starts all its segments are slack",
        ),
    ],
)
def test_modes_refuses(ropewalk: Call, scene: Path, arguments: tuple[str, ...], words: str) -> None:
    done = ropewalk("modes", scene, *arguments)
    assert done.exit_code == 2
    assert words in done.stderr
    assert done.stdout == ""


def test_a_run_starts_at_rest_and_rings(ropewalk: Call, scene: Path) -> None:
    rest, ring = "run.start='at-rest'", "run.ring={mode=2, speed=0.1}"
    done = ropewalk("run", scene, "-o", "still", "--set", rest, "--json")
    assert done.exit_code == 0, done.output
    assert json.loads(done.stdout)["results"]["largest speed [m/s]"] < 1e-6
    done = ropewalk("run", scene, "-o", "ring", "--set", rest, "--set", ring, "--json")
    assert done.exit_code == 0, done.output
    assert 0.09 < json.loads(done.stdout)["results"]["largest speed [m/s]"] < 0.2
    text = (scene.parent / "ring" / "scene.toml").read_text()
    assert 'start = "at-rest"' in text
    assert "[run.ring]" in text
    refused = ropewalk("run", scene, "--set", ring)
    assert refused.exit_code == 2
    assert 'needs start = "at-rest"' in refused.stderr


def test_a_process_that_rings_finds_scipy(process, scene: Path) -> None:  # type: ignore[no-untyped-def]
    rest, ring = "run.start='at-rest'", "run.ring={mode=1, speed=0.1}"
    done = process("run", scene, "-o", "ring", "-q", "--set", rest, "--set", ring)
    assert done.returncode == 0, done.stderr
