"""The commands that need only the scene: check, presets, new, schema; help and version."""

from __future__ import annotations

import json
import re
import tomllib
from pathlib import Path
from typing import Any

import pytest

from ropewalk import __version__
from ropewalk.cli import main
from ropewalk.cli.commands.new import starter
from ropewalk.scene import Springs, load, loads, presets, schema

COMMANDS = [
    "demo", "view", "presets", "ropes", "line", "new", "check", "settle", "modes", "run", "sweep", "resume",
    "info", "plot", "movie", "share", "lab", "compare", "export", "sheet", "report", "schema",
]  # fmt: skip


def test_every_command_is_there_and_has_help(ropewalk: Any) -> None:
    assert list(main.commands) == COMMANDS
    page = ropewalk("--help").stdout
    for name in COMMANDS:
        assert re.search(rf"^  {name} ", page, re.M)
        done = ropewalk(name, "--help")
        assert done.exit_code == 0
        assert done.stdout.startswith(f"Usage: ropewalk {name}")


def test_version(ropewalk: Any) -> None:
    assert ropewalk("--version").stdout == f"ropewalk {__version__}\n"


def test_a_command_that_is_not_there(ropewalk: Any) -> None:
    done = ropewalk("chek", "r4")
    assert done.exit_code == 2
    assert 'there is no command "chek"; did you mean "check"?' in done.stderr


def test_check_says_what_to_expect(ropewalk: Any) -> None:
    done = ropewalk("check", "r4")
    assert done.exit_code == 0
    lines = done.stdout.splitlines()
    order = ("sag", "tension", "strain", "the run:", "10800 steps", "stable at 1.852 ms")
    places = [next(i for i, line in enumerate(lines) if text in line) for text in order]
    assert max(places[:3]) < places[3] == places[4] < places[5]
    assert "rk4" not in done.stdout
    assert done.stderr == ""


def test_check_tells_of_all_methods_when_asked(ropewalk: Any) -> None:
    done = ropewalk("check", "r4", "--all")
    for text in ("stable at 1.852 ms", "rk4", "bdf2", "waves along it", "rad/s", "stability meter"):
        assert text in done.stdout


def test_check_of_a_run_that_will_break(ropewalk: Any) -> None:
    done = ropewalk("check", "r6")
    assert done.exit_code == 3
    assert "will break" in done.stdout
    assert "warning: the run will break" in done.stderr
    assert "time_step <=" in done.stderr


def test_check_as_json(ropewalk: Any) -> None:
    done = ropewalk("check", "r4", "--json", "--set", "rope.made_of.spring_constant=100")
    found = json.loads(done.stdout)
    assert found["ok"] is True
    assert found["scene"] == "r4"
    assert found["stability"]["largest_step"]["semi-implicit-euler"] > 0.01
    assert json.loads(ropewalk("check", "r6", "--json").stdout)["ok"] is False


def test_flags_of_the_run_reach_the_scene(ropewalk: Any, scene: Path) -> None:
    done = ropewalk(
        "check", scene, "--json", "--method", "rk4", "--time-step", "0.001", "--duration", "2",
        "--set", "rope.segments=12",
    )  # fmt: skip
    found = json.loads(done.stdout)
    assert found["stability"]["method"] == "rk4"
    assert found["stability"]["step"] == pytest.approx(1 / 60 / 17)
    assert found["duration"] == pytest.approx(2.0)
    assert found["ropes"][0]["segments"] == 12


def test_presets_lists_all_of_them(ropewalk: Any) -> None:
    done = ropewalk("presets")
    for name in presets.names():
        assert re.search(rf"^ ?{name} ", done.stdout, re.M)
        assert presets.preset(name).description in done.stdout
    listed = json.loads(ropewalk("presets", "--json").stdout)["presets"]
    assert [one["name"] for one in listed] == presets.names()


def test_presets_shows_one(ropewalk: Any) -> None:
    assert ropewalk("presets", "r4").stdout == presets.preset_text("r4").rstrip("\n") + "\n"
    done = ropewalk("presets", "r44")
    assert done.exit_code == 2
    assert 'did you mean "r4"?' in done.stderr


def test_new_writes_the_preset_of_that_name(ropewalk: Any, tmp_path: Path) -> None:
    done = ropewalk("new", "r4")
    assert done.exit_code == 0
    assert (tmp_path / "r4.toml").read_text() == presets.preset_text("r4")
    assert "ropewalk run r4.toml" in done.stdout


def test_new_with_a_name_of_ones_own(ropewalk: Any, tmp_path: Path) -> None:
    assert ropewalk("new", 'my "long" rope').exit_code == 0
    assert load(tmp_path / "my-long-rope.toml").name == 'my "long" rope'
    told = ropewalk("new", "plain", "-o", "my own.toml").stdout  # as it can be typed
    assert "ropewalk check 'my own.toml'" in told
    assert "ropewalk run 'my own.toml'" in told
    assert ropewalk("new", "bell", "--from", "r2", "-o", "deep/er/bell.toml").exit_code == 0
    made = load(tmp_path / "deep/er/bell.toml")
    assert made.name == "bell"
    assert made.ropes == presets.preset("r2").ropes
    assert "# R2:" in (tmp_path / "deep/er/bell.toml").read_text()


@pytest.mark.parametrize(
    ("name", "meant"),
    [("R4", "r4"), ("r44", "r4"), ("falling-chian", "falling-chain"), ("r4", ""), ("nosuch", "")],
)
def test_new_says_which_preset_may_be_meant(
    ropewalk: Any, tmp_path: Path, name: str, meant: str
) -> None:
    """The scene is written all the same: any name may be one's own."""
    done = ropewalk("new", name)
    assert done.exit_code == 0
    assert (tmp_path / f"{name}.toml").is_file()
    note = f'note: "{name}" is no preset; did you mean the preset "{meant}"?\n'
    assert done.stderr == (note if meant else "")
    assert ropewalk("new", name, "--from", "r2", "-o", "b.toml").stderr == ""


def test_new_never_overwrites(ropewalk: Any, tmp_path: Path) -> None:
    path = tmp_path / "r4.toml"
    path.write_text("mine")
    done = ropewalk("new", "r4")
    assert done.exit_code == 2
    assert "r4.toml: exists already" in done.stderr
    assert path.read_text() == "mine"
    assert ropewalk("new", "r4", "--overwrite").exit_code == 0
    assert path.read_text() != "mine"


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("new", ""), "printable"),
        (("new", "x\ny"), "printable"),
        (("new", "x", "--from", "r44"), 'did you mean "r4"?'),
        (("new", "r4", "-o", "."), "is a folder"),
        (("new", "r4", "-o", "file/scene.toml"), "file is a file, not a folder"),
        (("schema", "-o", "file/schema.json"), "file is a file, not a folder"),
        (("schema", "-o", "file"), "exists already"),
    ],
)
def test_files_that_cannot_be_written(
    ropewalk: Any, tmp_path: Path, arguments: tuple[str, ...], said: str
) -> None:
    (tmp_path / "file").write_text("mine")
    done = ropewalk(*arguments)
    assert done.exit_code == 2
    assert said in done.stderr
    assert "Traceback" not in done.output
    assert [path.name for path in tmp_path.iterdir()] == ["file"]
    assert (tmp_path / "file").read_text() == "mine"


def optional_parts(text: str) -> dict[str, tuple[str, str]]:
    """The parts of the starter that are commented out: by name, as they stand and switched on."""
    found = {}
    for part in re.split(r"\n\n", text):
        if part.startswith(("# [", "# release_time")) or "\n# release_time" in part:
            switched = re.sub(r"^# (?=\[|\w+ = )", "", part, flags=re.M)
            found[switched.split("]")[0].strip("[")] = (part, switched)
    return found


def test_every_part_of_the_starter_can_be_switched_on() -> None:
    text = starter()
    assert loads(text).name == "my rope"
    parts = optional_parts(text)
    expected = {"rope.made_of", "rope.load", "rope.kick", "anchor", "air", "ground", "limiter"}
    assert set(parts) == expected | {"winch", "anchor.clamp", "obstacle"}
    assert text.index("[[obstacle]]") < text.index("[ground]")  # the one that sticks comes first
    assert loads(text.replace(*parts["obstacle"])).obstacles[0].kind == "plane"
    _, springs = parts.pop("rope.made_of")
    part, clamp = parts.pop("anchor.clamp")  # holds only what resists bending
    assert loads(text.replace("# EI =", "EI =").replace(part, clamp)).anchors[0].clamp is not None
    for part, switched in parts.values():
        assert "# release_time" not in switched
        assert loads(text.replace(part, switched)) != loads(text)
    all_on = text
    for part, switched in parts.values():
        all_on = all_on.replace(part, switched)
    assert loads(all_on).winches
    start, end = text.index("[rope.made_of]"), text.index("[rope.shape]")
    in_springs = text[:start].replace("length = 10.0", "# ") + springs + "\n\n" + text[end:]
    assert loads(in_springs).ropes[0].made_of.kind == "springs"
    assert tomllib.loads(springs)["rope"]["made_of"].keys() == Springs.model_fields.keys() - {
        "friction",
        "tension_only",
        "breaking_load",
        "parts",
    }


def test_schema(ropewalk: Any, tmp_path: Path) -> None:
    assert json.loads(ropewalk("schema").stdout) == schema()
    assert ropewalk("schema", "-o", "scene.json").exit_code == 0
    assert json.loads((tmp_path / "scene.json").read_text()) == schema()
