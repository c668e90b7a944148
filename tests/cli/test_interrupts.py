"""Ctrl-C that falls where Python cannot raise is still an interruption, not a fault of Ropewalk."""

from __future__ import annotations

import ctypes
import signal
from collections.abc import Callable

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
