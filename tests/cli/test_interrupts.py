"""Ctrl-C that falls where Python cannot raise is still an interruption, not a fault of Ropewalk."""

from __future__ import annotations

import ctypes
import signal
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import click
import pytest

from ropewalk.cli.app import RopewalkGroup


def status_of(action: Callable[[], None]) -> int:
    """Run a command that does something; return its exit status."""
    group = RopewalkGroup("ropewalk", commands={"do": click.Command("do", callback=action)})
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        with pytest.raises(SystemExit) as ended:
            group.main(["do"])
    finally:
        signal.signal(signal.SIGINT, before)
    assert isinstance(ended.value.code, int)
    return ended.value.code


def in_a_callback_of_compiled_code() -> None:
    """Interrupt where the exception is lost."""
    callback = ctypes.CFUNCTYPE(None)(lambda: signal.raise_signal(signal.SIGINT))
    callback()


def test_a_lost_interrupt_explains_the_error_after_it(capfd: pytest.CaptureFixture[str]) -> None:
    def action() -> None:
        in_a_callback_of_compiled_code()
        raise RuntimeError("no compiled object yet")

    assert status_of(action) == 130
    assert capfd.readouterr().err == "interrupted\n"


def test_without_an_interrupt_it_is_a_fault(capfd: pytest.CaptureFixture[str]) -> None:
    def action() -> None:
        raise RuntimeError("no compiled object yet")

    assert status_of(action) == 1
    assert "error in Ropewalk itself" in capfd.readouterr().err


def test_an_interrupt_is_one_as_ever(capfd: pytest.CaptureFixture[str]) -> None:
    assert status_of(lambda: signal.raise_signal(signal.SIGINT)) == 130
    assert "interrupted" in capfd.readouterr().err


def test_nothing_is_collected_at_the_end_of_the_process() -> None:
    """It took 0.6 s of processor time after a run, more than all else from Ctrl-C to the end. The twin:
    without the command nothing keeps Python from it.
    """
    look = "import atexit, gc; atexit.register(lambda: print('frozen', gc.get_freeze_count()))"  # called last
    run = "from ropewalk.cli import main; main(['--version'])"
    counts = []
    for program in (f"{look}; {run}", look):
        done = subprocess.run(
            [sys.executable, "-c", program], capture_output=True, text=True, check=True
        )
        counts.append(int(done.stdout.rpartition("frozen")[2]))
    assert counts[0] > 1000
    assert counts[1] == 0


WATCHED = """
import atexit, sys
from ropewalk.cli import main
from ropewalk.record.run import Recorder
real, seen = Recorder.record, set()
def watched(recorder, progress):
    seen.update(sys.modules)
    return real(recorder, progress)
Recorder.record = watched
atexit.register(lambda: print("late:", *[m for m in sys.modules if m.startswith("rich") and m not in seen]))
main(["run", "r4", "--duration", "0.05", "-o", sys.argv[1]])
"""


def test_tables_are_loaded_before_the_run(tmp_path: Path) -> None:
    """That at the end needs forty modules, which Ctrl-C would wait for."""
    program = [sys.executable, "-c", WATCHED, str(tmp_path / "run")]
    said = subprocess.run(program, capture_output=True, text=True, check=True).stdout
    assert "largest tension" in said
    assert said.splitlines()[-1].strip() == "late:"
