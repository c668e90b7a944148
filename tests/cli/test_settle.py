"""`ropewalk settle`."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from cli.conftest import Call


def test_settle_prints_what_is_asked_for(ropewalk: Call, scene: Path) -> None:
    done = ropewalk("settle", scene)
    assert done.exit_code == 0, done.output
    assert "small: at rest" in done.stdout
    for words in (
        "largest tension",
        "largest force left",
        "0 to 6",
        "sag",
        "anchor1",
        "Newton steps",
    ):
        assert words in done.stdout
    assert done.stderr == ""
    assert sorted(path.name for path in scene.parent.iterdir()) == ["scene.toml"]


def test_settle_json_meets_the_weight(ropewalk: Call, scene: Path) -> None:
    done = ropewalk("settle", scene, "--json", "--set", "rope.segments=10")
    found = json.loads(done.stdout)
    up = sum(force[2] for force in found["anchors"].values())
    assert up == pytest.approx(11 * 0.05 * 9.81, rel=1e-12)
    assert found["residual"] < 1e-9
    assert found["spans"][0]["last"] == 10
    assert found["folder"] is None


def test_settle_writes_a_folder_that_others_read(ropewalk: Call, scene: Path) -> None:
    done = ropewalk("settle", scene, "-o", "rest")
    assert done.exit_code == 0, done.output
    assert "run folder: rest" in done.stdout
    assert "at rest" in ropewalk("info", "rest").stdout
    plotted = ropewalk("plot", "rest")
    assert plotted.stdout == "rest/figures/forces.png\n"
    assert ropewalk("export", "rest", "--to", "csv").exit_code == 0
    again = ropewalk("settle", scene, "-o", "rest")
    assert again.exit_code == 2
    assert "holds a run already" in again.stderr
    assert ropewalk("settle", scene, "-o", "rest", "--overwrite").exit_code == 0
    resumed = ropewalk("resume", "rest")
    assert resumed.exit_code == 2
    assert "holds an equilibrium, not a run" in resumed.stderr


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("--set", "anchor=[]"), "no anchor holds it, and there is no ground: it falls"),
        (
            ("--set", "gravity=[0,0,0]", "--set", "rope.shape={kind='straight', end=[1,0,0]}"),
            "slack",
        ),
        (("--set", "rope.segments=0"), "rope[0].segments: 0 - must be at least 1"),
    ],
)
def test_settle_refuses(
    ropewalk: Call, scene: Path, arguments: tuple[str, ...], words: str
) -> None:
    done = ropewalk("settle", scene, *arguments)
    assert done.exit_code == 2
    assert words in done.stderr
    assert done.stdout == ""


def test_settle_warns_of_a_limiter(ropewalk: Call) -> None:
    done = ropewalk("settle", "h2")
    assert done.exit_code == 0, done.output
    assert "the stretch limiter takes no part" in done.stderr
