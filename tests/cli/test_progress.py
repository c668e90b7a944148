"""The one bar of every long work: every part of it can be read, on narrow terminals, too."""

from __future__ import annotations

import os
import pty
import re
import select
import sys
from collections.abc import Callable
from io import StringIO
from pathlib import Path
from typing import Any

import numba
import pytest
from rich.console import Console

from ropewalk.cli import progress
from ropewalk.display import bar
from ropewalk.scene.presets import preset
from ropewalk.simulation import Simulation
from ropewalk.sweeps.runs_bar import RunsBar

LONG = "A rope with a name that is a little long"


def run() -> None:
    """Half of 20 frames."""
    scene = preset("r4").replace(name=LONG)
    simulation = Simulation(scene)
    with progress.RunProgress(scene) as shown:
        for done in (5, 10):
            shown(done, 20, simulation.advance_frames(5))


def sweep() -> None:
    """Half of 20 000 runs."""
    with RunsBar(LONG, 20_000, True, dict) as shown:
        shown.start(0, 0)
        shown._last -= 1.0  # what is told too often is not shown
        shown.add(10_000, 137)


def movie() -> None:
    """Half of 2000 pictures."""
    with progress.counting("movie", "pictures") as shown:
        shown(1000, 2000)


def report() -> None:
    """Half of 20 claims."""
    with bar.Bar("report") as shown:
        shown.show(10, 20, ["10 of 20", "C9 " + 10 * "a very long title of a claim "])


def compiled() -> None:
    """Two functions of which machine code has to be made."""

    def twice(x: int) -> int:
        return 2 * x

    def thrice(x: int) -> int:
        return 3 * x

    with progress.RunProgress(preset("r4").replace(name="r")):
        assert (numba.njit(twice)(2), numba.njit(thrice)(2)) == (4, 6)


WORKS = {"run": run, "sweep": sweep, "movie": movie, "report": report}
FIRST = {
    "run": f"/{20 * preset('r4').run.frame_interval:.4g} s",
    "sweep": "10000 of 20000 runs",
    "movie": "1000 of 2000 pictures",
    "report": "10 of 20",
}


def drawn(monkeypatch: pytest.MonkeyPatch, work: Callable[[], None], width: int) -> str:
    """Return the last line of a bar on a terminal of so many columns."""
    screen = StringIO()
    made = Console(file=screen, width=width, force_terminal=True, no_color=True, highlight=False)
    monkeypatch.setattr(bar, "stderr_console", lambda: made)
    monkeypatch.setattr(bar, "terminal", lambda: True)
    work()
    return last_line(screen.getvalue())


def last_line(screen: str) -> str:
    lines = [line for line in re.split(r"[\r\n]", screen) if "━" in line]
    return re.sub(r"\x1b\[[0-9;?]*[A-Za-z]", "", lines[-1])


def test_what_is_compiled_is_told_and_how_far(monkeypatch: pytest.MonkeyPatch) -> None:
    assert re.search(r"compiling thrice, piece 2, \d+ s so far", drawn(monkeypatch, compiled, 120))


@pytest.mark.parametrize("width", [60, 80, 100, 120, 200])
@pytest.mark.parametrize("work", WORKS)
def test_it_can_be_read(monkeypatch: pytest.MonkeyPatch, work: str, width: int) -> None:
    line = drawn(monkeypatch, WORKS[work], width)
    assert len(line) <= width
    assert line.startswith(("A rope with a", work))
    found = re.search("([━╸╺]+ *) 50 % ", line)  # without colours the rest of it is blank
    assert found is not None
    assert len(found[1]) >= 12
    assert FIRST[work] in line or (work, width) == ("sweep", 60)  # cut
    assert re.search(r"(\d+:\d\d|-:--)$", line.rstrip())  # time left
    assert line.count("…") <= (1 if width >= 80 else 2)  # only the name is cut
    if work == "run":
        assert ("real time" in line) == (width >= 80)
        assert ("energy" in line) == (width >= 120)
    if work == "sweep":
        assert ("137 broken" in line) == (width >= 80)


def test_a_bar_without_room_for_its_first_fact_cuts_it(monkeypatch: pytest.MonkeyPatch) -> None:
    def long() -> None:
        with bar.Bar("work") as shown:
            shown.show(1, 2, [60 * "long"])

    line = drawn(monkeypatch, long, 80)
    assert len(line) <= 80
    assert "…" in line
    assert "50 %" in line


def test_facts_are_short_for_long_runs() -> None:
    facts = progress.facts_of(123456.789, 1e6, 1234.5, float("nan"))
    assert len("  ".join(facts[:2])) <= 40


def test_a_pipe_gets_no_bar_and_a_terminal_does(process: Any, scene: Path, tmp_path: Path) -> None:
    assert process("run", scene, "-o", tmp_path / "warm").returncode == 0  # it may have to compile
    done = process("run", scene)
    assert (done.returncode, done.stderr) == (0, "")
    assert "\x1b" not in done.stdout
    out, status = on_terminal(tmp_path, "run", "scene.toml", "--set", "name=[bold]a[/b] rope")
    assert status == 0
    for text in ("0.5/0.5 s", "x real time", "energy +", "━", "[bold]a[/b] rope"):
        assert text in out
    out, status = on_terminal(tmp_path, "run", "scene.toml", columns=80)
    line = last_line(out).rstrip()
    assert len(line) <= 80
    assert all(text in line for text in ("100 %", "0.5/0.5 s", "x real time"))
    out, status = on_terminal(tmp_path, "run", "scene.toml", "--quiet")
    assert (out, status) == ("runs/scene-4\r\n", 0)


def on_terminal(folder: Path, *arguments: str, columns: int = 160) -> tuple[str, int]:
    """Call the command line on a terminal of its own; return what it shows and its status."""
    child, terminal = pty.fork()
    if child == 0:  # pragma: no cover - the other process
        os.chdir(folder)
        os.environ |= {"COLUMNS": str(columns), "TERM": "xterm"}
        os.execv(sys.executable, [sys.executable, "-m", "ropewalk", *arguments])
    shown = b""
    while True:
        select.select([terminal], [], [], 60)
        try:
            data = os.read(terminal, 65536)
        except OSError:  # the other end is closed
            break
        if not data:
            break
        shown += data
    os.close(terminal)
    return shown.decode(), os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
