"""What faulty scenes get from the command line: one clear message, status 2, nothing on disk."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

import ropewalk as rw
from cli.conftest import SCENE
from ropewalk.sweeps.function import SweepFunction

# A change of the small scene, and what the message must say of it.
FAULTS = [
    (("segments = 6", "segments = 0"), "rope[0].segments: 0 - must be at least 1"),
    (("segments = 6", "segments = -3"), "rope[0].segments: -3 - must be at least 1"),
    (("segments = 6", "segments = 6.5"), "rope[0].segments: 6.5 - must be a whole number"),
    (("segments = 6", 'segments = "six"'), 'rope[0].segments: "six" - must be a whole number'),
    (
        ("segments = 6", "segments = 10000000000000"),
        "rope[0].segments: 10000000000000 - must be at",
    ),
    (("node_mass = 0.05", "node_mass = 0"), "rope[0].made_of.node_mass: 0 - must be"),
    (("node_mass = 0.05", "node_mass = nan"), "rope[0].made_of.node_mass: nan - must be"),
    (("node_mass = 0.05", "node_mass = inf"), "rope[0].made_of.node_mass: inf - must be"),
    (("node_mass = 0.05", "node_mass = 1e300"), "rope[0].made_of.node_mass: 1e+300 - must be"),
    (("spring_friction = 0.05", "spring_friction = -1"), "spring_friction: -1 - must be"),
    (("duration = 0.5", "duration = -1.0"), "run.duration: -1.0 - must be"),
    (("duration = 0.5", "duration = 1e15"), "run.duration: 1000000000000000.0 - "),
    (("time_step = 0.002", "time_step = 0"), "run.time_step: 0 - must be"),
    (("time_step = 0.002", 'time_step = "small"'), 'run.time_step: "small" - must be'),
    (("time_step = 0.002", 'method = "rk5"'), 'run.method: "rk5" - must be one of'),
    (("node = -1", "node = 7"), "anchor[1].node: 7 - must be from 0 to 6, or from -7 to -1"),
    (("node = -1", "node = 0"), "anchor[1].node: 0 - "),
    (("node = -1", 'rope = "rpe"\nnode = -1'), 'anchor[1].rope: "rpe" - '),
    (("spring_constant", "sprng_constant"), 'did you mean "spring_constant"?'),
    (("[rope.made_of]", "[rope.made_off]"), "rope[0].made_of"),
    (
        ("[[anchor]]\nnode = 0", '[rope.shape]\nkind="straight"\nend=[0,0,0]\n[[anchor]]\nnode=0'),
        "rope[0].shape",
    ),
]


def faulty(change: tuple[str, str]) -> str:
    """The small scene with a part replaced."""
    assert change[0] in SCENE
    return SCENE.replace(*change)


def tree(folder: Path) -> list[str]:
    """Every file and folder below a folder."""
    return sorted(str(path.relative_to(folder)) for path in folder.rglob("*"))


def refused(done: Any, *said: str) -> None:
    """A call was refused: status 2, a message that says something, nothing on stdout.

    Some refusals ask kernels, which with an empty cache are compiled first, and that is said.
    """
    assert done.exit_code == 2, done.output
    for text in said:
        assert text in done.stderr
    told = [line for line in done.stderr.splitlines() if not line.startswith("compiling: ")]
    assert told[0].startswith("error: ")
    assert done.stdout == ""
    assert "Traceback" not in done.stderr


@pytest.mark.parametrize("command", ["check", "run"])
@pytest.mark.parametrize(("change", "said"), FAULTS, ids=[said[:40] for _, said in FAULTS])
def test_faults_of_a_scene(
    ropewalk: Any, scene: Path, command: str, change: tuple[str, str], said: str
) -> None:
    scene.write_text(faulty(change))
    refused(ropewalk(command, scene), f"{scene}: ", said)
    assert tree(scene.parent) == ["scene.toml"]


def test_all_faults_at_once(ropewalk: Any, scene: Path) -> None:
    text = SCENE.replace("segments = 6", "segments = 0").replace("duration = 0.5", "duration = nan")
    scene.write_text(text.replace("node = 0", "nod = 0"))
    done = ropewalk("run", scene)
    refused(done, "rope[0].segments", "run.duration", "anchor[0].nod", "things are wrong")
    assert len(done.stderr.splitlines()) == 1 + done.stderr.count(str(scene))


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (b"", "is empty"),
        (b"\x89PNG\r\n\x1a\n\x00\x00\xff\xfe", "is not a text file"),
        (b"[run]\x00", "is not a text file"),
        (b'name = "x"\n[run\nduration = 1', "line 2, column 5: TOML: "),
        (b"duration = 1..2", "line 1, column 13: TOML"),
        (b"a = 1\na = 2", "line 2, column 6: TOML"),
        (b"[" * 5000, "TOML"),
        (b"a = 1\nb = " + b"9" * 5000, "line 2: has a number of more digits than can be read"),
    ],
)
def test_files_that_are_no_scenes(ropewalk: Any, scene: Path, content: bytes, said: str) -> None:
    scene.write_bytes(content)
    refused(ropewalk("run", scene), f"{scene}: ", said)
    assert tree(scene.parent) == ["scene.toml"]


TABLE = '[anchor.motion]\nkind = "table"\nfile = "path.csv"\n'


@pytest.mark.parametrize(
    ("rows", "said"),
    [
        ("time,x,y,z\n0,0,0,0\n1,,0,0\n", "line 3, column x: the cell is missing"),
        ("time,x,y,z\n0,0,0,0\n1,0,0\n", "line 3, column z: the cell is missing"),
        (
            "time,x,y,z\n0,0,0,0\n2,1,0,0\n1,0,0,0\n",
            "line 4, column time: 1 - must be later than 2",
        ),
        ("time,x,y,z\n0,0,0,0\n1,far,0,0\n", 'line 3, column x: "far" - must be a finite number'),
        ("time,x,y,z\n0,0,0,0\n1,nan,0,0\n", 'line 3, column x: "nan" - must be a finite number'),
        ("time,x,y\n0,0,0\n1,0,0\n", "no column z"),
        ("time,x,y,z\n", "has a header but no rows"),
        ("", "has no rows"),
        (None, "no such file"),
    ],
)
def test_tables_of_an_anchor(ropewalk: Any, scene: Path, rows: str | None, said: str) -> None:
    scene.write_text(SCENE.replace("node = 0\n", f"node = 0\n{TABLE}"))
    if rows is not None:
        (scene.parent / "path.csv").write_text(rows)
    before = tree(scene.parent)
    refused(ropewalk("run", scene), f"{scene}: anchor[0].motion.file: ", "path.csv", said)
    assert tree(scene.parent) == before


@pytest.mark.parametrize(
    ("flags", "said"),
    [
        (("--duration", "-1"), "run.duration: -1 - must be"),
        (("--duration", "long"), 'run.duration: "long" - must be a number'),
        (("--duration", "nan"), "run.duration: nan - must be"),
        (("--time-step", "0"), "run.time_step: 0 - must be"),
        (("--method", "rk5"), 'run.method: "rk5" - must be one of "euler"'),
        (("--set", "rope.segmnts=8"), 'rope[0].segmnts: unknown key; did you mean "segments"?'),
        (("--set", "rope.segments"), '"rope.segments": must be written as path=value'),
        (("--set", "=3"), '"=3": must be written as path=value'),
        (("--set", "rope[3].segments=8"), "rope[3]: there is only [0]"),
        (("--set", "rope.segments=many"), 'rope[0].segments: "many" - must be a whole number'),
        (("--set", "rope.segments=0", "--set", "run.duration=0"), "2 things are wrong"),
        (("--no-such-flag",), "--no-such-flag"),
        (("more",), "more"),
    ],
)
def test_flags(ropewalk: Any, scene: Path, flags: tuple[str, ...], said: str) -> None:
    refused(ropewalk("run", scene, *flags), said)
    assert tree(scene.parent) == ["scene.toml"]


@pytest.mark.parametrize(
    ("source", "said"),
    [
        ("r44", 'r44: no such file, and no preset of that name; did you mean "r4"?'),
        ("whp", 'did you mean "whip"?'),
        ("scenes/rope.toml", "scenes/rope.toml: no such file"),
        ("rope.toml", "rope.toml: no such file"),
        ("", "must be a scene file or the name of a preset"),
        (".", "is a folder, not a scene file"),
        ("x" * 5000, "no such file"),
        ("\0", "SCENE"),
    ],
)
def test_scenes_that_are_not_there(ropewalk: Any, source: str, said: str) -> None:
    refused(ropewalk("run", source), said)
    assert tree(Path.cwd()) == []


def test_what_is_found_only_when_a_scene_is_built_names_the_file(
    ropewalk: Any, scene: Path
) -> None:
    """A winch that is too fast for the step: the file, the value, which winch, and what is allowed."""
    scene.write_text(
        scene.read_text() + '[[winch]]\nname = "hoist"\nend = "start"\nspeed = 1000.0\n'
    )
    said = f"{scene}: run.time_step: 0.001851851851851852 - must be at most 0.0001: in a step winch"
    for command in ("check", "run"):
        done = ropewalk(command, scene)
        refused(done, said)
        assert "winch 'hoist' may wind a fifth of a segment" in done.stderr
    refused(ropewalk("compare", scene, scene), said)


FLOOR = '[[obstacle]]\nname = "floor"\nkind = "plane"\npoint = [0.0, 0.0, 1.0]\n'


@pytest.mark.parametrize(
    "command",
    [
        ("check",),
        ("run",),
        ("run", "--uncertain", "run.duration=0.4..0.5"),
        ("settle",),
        ("modes",),
        ("modes", "--about", "start"),
        ("view", "--no-browser", "--no-save"),
        ("sheet",),
        ("sheet", "--at-rest"),
        ("sweep", "--vary", "run.duration=0.4,0.5"),
        ("sweep", "--rest", "--vary", "run.duration=0.4,0.5"),
        ("compare", "r4"),
        ("lab", "r4"),
    ],
    ids=" ".join,
)
def test_every_command_names_the_file_of_what_is_found_when_a_scene_is_built(
    ropewalk: Any, scene: Path, command: tuple[str, ...]
) -> None:
    scene.write_text(scene.read_text() + FLOOR)
    done = ropewalk(*command, scene)
    assert done.exit_code == 2, done.output
    said = [line for line in done.stderr.splitlines() if "inside obstacle 'floor'" in line]
    assert said
    for line in said:
        assert line.removeprefix("error:").strip().startswith(f"{scene}: rope[0].shape: "), line


def test_a_scene_without_a_rest_is_named(ropewalk: Any, scene: Path) -> None:
    falling = scene.read_text().split("[[anchor]]")[0] + FLOOR.replace("1.0]", "-1.0]")
    scene.write_text(falling.replace("point", "friction = 0.0\nnormal = [0.6, 0.0, 0.8]\npoint"))
    done = ropewalk("settle", scene)
    assert done.exit_code == 3
    assert done.stderr.splitlines()[-1].startswith(f"error: {scene}: there is no rest")


@pytest.mark.parametrize(
    "ask",
    [
        rw.simulate,
        rw.equilibrium,
        rw.modes,
        rw.check,
        rw.sheet,
        lambda file: rw.sweep(file, {"run.duration": [0.4, 0.5]}),
        lambda file: rw.uncertain(file, {"run.duration": (0.4, 0.5)}),
        lambda file: rw.calibrate(file, rw.calibrate.sag(1.0), {"rope.segment_length": (0.4, 0.6)}),
        lambda file: SweepFunction(file, "run.duration"),
    ],
)
def test_every_function_names_the_file(scene: Path, ask: Any) -> None:
    scene.write_text(scene.read_text() + FLOOR)
    with pytest.raises(rw.SceneError, match=f"^{re.escape(str(scene))}: rope"):
        ask(scene)


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("[[anchor]]\nnode = 0", "[anchor]\nnode = 0", "a list of tables has double brackets"),
        ('name = "small"', 'name = "small', "line 1, column 14: TOML: a text must end on its own"),
        (
            'name = "small"',
            'name = "a"\nname = "b"',
            "line 2, column 11: TOML: this is there already",
        ),
    ],
)
def test_toml_errors_say_what_to_do(
    ropewalk: Any, scene: Path, old: str, new: str, said: str
) -> None:
    text = scene.read_text()
    assert old in text
    scene.write_text(text.replace(old, new, 1))
    refused(ropewalk("check", scene), said)


def test_a_csv_with_more_cells_than_columns(ropewalk: Any, scene: Path) -> None:
    """A comma for a decimal point makes one cell more; it must not pass in silence."""
    text = scene.read_text()
    motion = '[[anchor]]\nnode = 0\n[anchor.motion]\nkind = "table"\nfile = "path.csv"\n'
    scene.write_text(text.replace("[[anchor]]\nnode = 0\n", motion, 1))
    path = scene.with_name("path.csv")
    path.write_text("time,x,y,z\n0,0,0,0\n1,1,0,0,5\n")
    refused(ropewalk("check", scene), '"path.csv" - line 3: has 5 cells, the first line has 4')
    path.write_text("time,x,y,z\n0,0,0,0\n1,1,0,0.5\n")
    assert ropewalk("check", scene).exit_code == 0


@pytest.mark.skipif(sys.platform == "win32", reason="needs a shell")
@pytest.mark.parametrize("command", ["presets", "check r4", "run r4", "--help"])
def test_a_closed_stdout(tmp_path: Path, command: str) -> None:
    done = subprocess.run(
        f"'{sys.executable}' -m ropewalk {command} >&-",
        shell=True,
        cwd=tmp_path,
        stderr=subprocess.PIPE,
        text=True,
        check=False,
    )
    assert done.returncode == 2
    assert done.stderr.startswith("error: standard output is closed")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("last", "count"),
    [
        ("and 5 more", 25),
        ("s.toml: rope[0]: and 5 more faults, not told here", 25),
        ("and 5 more, of 40 chunks", 25),
        ("rope.made_of: 'x' - known: a, b and 5 more", 21),
        ("one like others", 21),
    ],
)
def test_a_line_that_stands_for_many_counts_as_many(last: str, count: int) -> None:
    from ropewalk.cli.failures import Refusal, explain

    lines = [*(f"s/data.zarr/c.{i}: is damaged" for i in range(20)), last]
    status, text = explain(Refusal("\n".join(lines)))
    assert status == 2
    assert text.splitlines()[0] == f"error: {count} things are wrong"
