"""The documentation tells the truth: its commands parse, its scenes load, its Python runs."""

from __future__ import annotations

import ast
import inspect
import re
import shlex
import tomllib
from pathlib import Path
from typing import Any

import click
import pytest

from ropewalk.analysis.check import check
from ropewalk.cli import main
from ropewalk.scene import Scene, SceneError, loads
from ropewalk.scene.presets import preset_text
from ropewalk.simulation import Simulation

ROOT = Path(__file__).resolve().parents[2]
PAGES = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").rglob("*.md"))]
BLOCK = re.compile(r"^```(\w+)\n(.*?)^```", re.MULTILINE | re.DOTALL)
PRINTED = re.compile(r"# (<.*>|-?\d[-\d., ]*)$")  # beside a `print`: what it shows
INLINE = re.compile(r"`(ropewalk [^`]+)`")
BASE = """
[[rope]]
segments = 20
[rope.made_of]
kind = "springs"
spring_constant = 1000.0
node_mass = 0.05
segment_length = 0.5
[[anchor]]
name = "left"
node = 0
[[anchor]]
name = "right"
node = -1
"""


def blocks(page: Path, language: str) -> list[str]:
    """Return a page's code blocks of one language."""
    text = page.read_text(encoding="utf-8").replace("    ```", "```")
    return [body for name, body in BLOCK.findall(text) if name == language]


def commands(page: Path) -> list[str]:
    """Return the lines of a page's shell blocks that call ropewalk, and inline commands."""
    bodies = [body for shell in ("bash", "sh", "console") for body in blocks(page, shell)]
    lines = "\n".join(bodies).replace("\\\n", " ").splitlines()
    lines = [line.removeprefix("$ ") for line in lines]
    found = [line for line in lines if re.match(r"(\.venv/bin/)?ropewalk\b", line)]
    return found + INLINE.findall(page.read_text(encoding="utf-8"))


def parse(line: str) -> None:
    """Raise click.UsageError when a command or an option of the line does not exist."""
    words = shlex.split(line, comments=True)
    for end in ("|", ">", "&&", "2>"):
        words = words[: words.index(end)] if end in words else words
    if len(words) < 2 or words[1].startswith("-"):
        return
    assert isinstance(main, click.Group)
    context = click.Context(main, info_name="ropewalk")
    name, command, rest = main.resolve_command(context, words[1:])
    assert command is not None
    own = click.Context(command, info_name=name, parent=context)
    values, left, _ = command.make_parser(own).parse_args(list(rest))
    if left:
        raise click.UsageError(f"too much: {left}")
    for parameter in command.params:
        if isinstance(parameter.type, click.Choice) and parameter.name in values:
            given: Any = values[parameter.name]
            for value in given if isinstance(given, list | tuple) else [given]:
                if isinstance(value, str):
                    parameter.type.convert(value, parameter, own)


def in_digits(number: float, shown: str) -> str:
    """Return a number with as many digits behind the point as another is shown with."""
    return f"{number:.{len(shown.partition('.')[2])}f}"


def run_python(page: Path, block: str, names: dict[str, Any]) -> list[str]:
    """Run a block of a page; check what its lines print that say so beside it, and return what they say."""
    said, lines = [], block.splitlines()

    def told(*values: object) -> None:
        frame = inspect.currentframe()
        assert frame is not None
        assert frame.f_back is not None
        found = PRINTED.search(lines[frame.f_back.f_lineno - 1])
        if found is None:
            return
        said.append(found[1])
        if found[1].startswith("<"):
            assert str(*values) == found[1]
            return
        wanted = found[1].split(", ")
        assert [in_digits(float(str(v)), w) for v, w in zip(values, wanted, strict=True)] == wanted

    names["print"] = told
    exec(compile(block, str(page), "exec"), names)
    return said


def merged(base: dict[str, Any], part: dict[str, Any]) -> dict[str, Any]:
    """Put a piece of a scene, as a page shows it, into a whole one."""
    made = dict(base)
    for key, value in part.items():
        if key == "rope" and isinstance(value, list) and "segments" not in value[0]:
            made[key] = [made[key][0] | value[0]]
        else:
            made[key] = value
    return made


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.relative_to(ROOT).as_posix())
def test_commands_exist(page: Path) -> None:
    for line in commands(page):
        try:
            parse(line)
        except click.UsageError as error:
            pytest.fail(f"{line}: {error.format_message()}")


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.relative_to(ROOT).as_posix())
def test_scenes_load(page: Path, tmp_path: Path) -> None:
    (tmp_path / "path.csv").write_text("time,x,y,z\n0,0,0,0\n1,1,0,0\n2,1,0,1\n")
    points = "\n".join(f"{0.5 * i},0,0" for i in range(21))
    (tmp_path / "points.csv").write_text(f"x,y,z\n{points}\n")
    for block in blocks(page, "toml"):
        scene = merged(tomllib.loads(BASE), tomllib.loads(block))
        try:
            Scene.model_validate(scene, context={"folder": str(tmp_path)})
        except SceneError as error:
            pytest.fail(f"{error}\n{block}")


@pytest.mark.parametrize(
    "page",
    [page for page in PAGES if blocks(page, "python")],
    ids=lambda page: page.relative_to(ROOT).as_posix(),
)
def test_python_runs(page: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    import matplotlib as mpl

    mpl.use("Agg")
    monkeypatch.chdir(tmp_path)
    (tmp_path / "scene.toml").write_text(BASE + "[run]\nduration = 0.5\n")
    names: dict[str, Any] = {"__name__": "page"}
    said = [one for block in blocks(page, "python") for one in run_python(page, block, names)]
    assert said == [
        found[1]
        for block in blocks(page, "python")
        for line in block.splitlines()
        if "print(" in line and (found := PRINTED.search(line))
    ]


def test_what_a_page_says_is_printed_is_compared() -> None:
    run_python(ROOT, "print(26.46, 35.41)  # 26.5, 35.4", {})
    for wrong in ("print(26.44)  # 26.5", "print('<A>')  # <B>", "print(1.0, 2.0)  # 1.0"):
        with pytest.raises((AssertionError, ValueError)):
            run_python(ROOT, wrong, {})
    assert run_python(ROOT, "print(1.0)  # N, the force", {}) == []


@pytest.mark.parametrize("name", ["obstacles", "pulleys", "touching", "pile"])
def test_what_touches_begins_without_a_jerk(name: str) -> None:
    """No segment carries more at the start than all weighs: an end that set off at once gave 552 N for 1 kg.

    Across a corner of what is drawn segments were so much shorter that they threw the rope about.
    """
    texts = blocks(ROOT / f"docs/how-to/{name}.md", "toml")
    if name == "pile":
        texts.append(preset_text("pile"))
    for text in texts:
        scene = loads(text)
        loads_on = [load.mass for rope in scene.ropes for load in rope.loads]
        weight = 9.81 * (sum(rope.own_mass for rope in scene.ropes) + sum(loads_on))
        pulled = Simulation(scene).recording().recording.tension
        assert abs(pulled).max() < 1.2 * weight, text


@pytest.mark.parametrize("name", ["obstacles", "pulleys", "touching", "pile"])
def test_no_scene_of_a_page_has_segments_that_check_calls_too_long(name: str) -> None:
    """The lever's rope lay on its plank in segments of 50 mm, of which `check` said at most 20 mm."""
    for text in blocks(ROOT / f"docs/how-to/{name}.md", "toml"):
        warnings = check(loads(text), measure=False).warnings
        assert not [said for said in warnings if "take more segments" in said], text


def test_contributing_names_files_and_targets_that_are_there() -> None:
    text = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
    named = re.findall(r"(?:src|tests|docs)/[\w/.*-]+", text)
    assert len(named) > 40
    for name in named:
        if "NAME" not in name:
            assert list(ROOT.glob(name.rstrip("."))), name
    targets = re.findall(r"^([a-z-]+):", (ROOT / "Makefile").read_text(), re.MULTILINE)
    for target in re.findall(r"make ([a-z-]+)[`\s]", text):
        assert target in targets, target


def test_every_command_is_documented() -> None:
    text = "\n".join(page.read_text(encoding="utf-8") for page in PAGES)
    assert isinstance(main, click.Group)
    for name in main.commands:
        assert f"ropewalk {name}" in text


def notes_of_tables() -> set[str]:
    """Return the rows `about ...` that tables of results may have."""
    folder, rows = ROOT / "src/ropewalk/record", set[str]()
    titles, noted = dict[str, str](), set[str]()
    for path in folder.glob("*.py"):
        rows |= set(re.findall(r'"(about (?:the|these|hard) [a-z ]+)"', path.read_text("utf-8")))
    texts = [(folder / name).read_text("utf-8") for name in ("summary.py", "note_kinds.py")]
    for node in (one for text in texts for one in ast.walk(ast.parse(text))):
        if isinstance(node, ast.Dict):
            keys = [key.value for key in node.keys if isinstance(key, ast.Constant)]
            if "highest point" in keys:  # what each extreme is called
                found = zip(keys, (ast.unparse(value) for value in node.values), strict=True)
                titles |= {key: text.strip("f'").partition(" [")[0] for key, text in found}
            elif "greatest stretch" in keys:  # those of which there is something to be said
                noted |= set(keys)
    named = {titles[key].replace("{result.tension_name}", "tension") for key in noted}
    return rows | {f"about the {name}" for name in named}


def test_what_tables_say_of_their_numbers_is_explained() -> None:
    rows = notes_of_tables()
    assert {"about the energy", "about hard stops", "about the largest clamp moment"} <= rows
    page = (ROOT / "docs/concepts/energy.md").read_text("utf-8")
    assert rows == set(re.findall(r"^\| `(about [a-z ]+)` \|", page, re.MULTILINE))


def test_a_wrong_command_is_seen() -> None:
    with pytest.raises(click.UsageError):
        parse("ropewalk walk scene.toml")
    with pytest.raises(click.UsageError):
        parse("ropewalk run scene.toml --no-such-option")
