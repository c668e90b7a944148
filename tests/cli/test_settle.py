"""`ropewalk settle`."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from cli.conftest import Call


def test_settle_prints_what_is_asked_for(ropewalk: Call, scene: Path) -> None:
    ropewalk("settle", scene)  # that kernels are compiled is told, once
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


def test_forces_of_anchors_have_their_unit_in_kilonewtons_too(ropewalk: Call, scene: Path) -> None:
    assert "anchor's force [N]" in ropewalk("settle", scene).stdout
    heavy = ropewalk("settle", scene, "--set", "rope.made_of.node_mass=1000")
    assert "anchor's force [kN]" in heavy.stdout


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


def test_settle_of_tied_ropes_in_a_process_of_its_own(process: Any, tmp_path: Path) -> None:
    """A new process keeps numba from importing scipy, whose sparse matrices the statics of joints need."""
    points = {
        "left": [[-0.8, 0.0, 0.0], [0.0, 0.0, -0.5]],
        "right": [[0.8, 0.0, 0.0], [0.0, 0.0, -0.5]],
    }
    text = "".join(
        f"""
[[rope]]
name = "{name}"
segments = 4
length = 0.95
made_of = {{ kind = "material", EA = 1e4, mass_per_length = 0.1 }}
shape = {{ kind = "polyline", points = {places} }}
[[anchor]]
rope = "{name}"
node = 0
"""
        for name, places in points.items()
    )
    tied = '[[joint]]\npoints = [{ rope = "left", node = -1 }, { rope = "right", node = -1 }]\n'
    path = tmp_path / "tied.toml"
    path.write_text(text + tied)
    done = process("settle", path, "--json")
    assert done.returncode == 0, done.stderr
    up = sum(force[2] for force in json.loads(done.stdout)["anchors"].values())
    weight = 2 * 0.95 * 0.1 * 9.81
    assert up == pytest.approx(weight, rel=1e-9)


def test_clamps_have_their_moments(ropewalk: Call, scene: Path, tmp_path: Path) -> None:
    """A weightless bar of 2 m that bears 3 N at its end: 6 N m; an anchor without a clamp has none."""
    file = tmp_path / "bar.toml"
    file.write_text(
        """schema_version = 1
gravity = [0.0, 0.0, 0.0]
[[rope]]
segments = 10
length = 2.0
made_of = {kind = "material", EA = 1e7, EI = 1e6, mass_per_length = 1.0}
force = [{node = -1, force = [0.0, 0.0, -3.0]}]
[[anchor]]
name = "wall"
node = 0
clamp = {direction = [1.0, 0.0, 0.0]}
"""
    )
    done = ropewalk("settle", file)
    assert "clamp's moment [N m]" in done.stdout
    assert "largest clamp moment" in done.stdout
    (found,) = json.loads(ropewalk("settle", file, "--json").stdout)["moments"].values()
    assert found == pytest.approx([0.0, -6.0, 0.0], rel=1e-5, abs=1e-9)
    assert "clamp's moment" not in ropewalk("settle", scene).stdout
