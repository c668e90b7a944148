"""What goes wrong, as one clear message and an exit status. The only place that does this."""

from __future__ import annotations

import os
import re
import signal
import sys
import tempfile
import traceback
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from threading import current_thread, main_thread
from types import FrameType
from typing import Any, TextIO

import click

from ropewalk.cli.console import warn

BUG, BAD_INPUT, BROKE, INTERRUPTED = 1, 2, 3, 130
#: A line that stands for many: of sweeps, of run folders, of scenes.
_MORE = re.compile(r"(?:^|: )and (\d+) more(?: faults, not told here|, of \d+ chunks)?$")

# What the package says to those who call it from Python, as flags.
_IN_FLAGS = {
    "or allow to overwrite (overwrite=True)": "or give --overwrite",
    "or allow to overwrite": "or give --overwrite",
    "or overwrite": "or give --overwrite",
    "or force it": "or give --force",
}


@contextmanager
def interrupts() -> Iterator[list[int]]:
    """Collect the signals of Ctrl-C, which interrupt as ever.

    One that falls into a callback of compiled code is lost there, and what comes after it fails.
    """
    noted: list[int] = []

    def note(number: int, _: FrameType | None) -> None:
        noted.append(number)
        raise KeyboardInterrupt

    def unraisable(lost: Any) -> None:
        if not isinstance(lost.exc_value, KeyboardInterrupt):
            sys.__unraisablehook__(lost)

    before, hook = signal.getsignal(signal.SIGINT), sys.unraisablehook
    if before is not signal.default_int_handler or current_thread() is not main_thread():
        yield noted
        return
    signal.signal(signal.SIGINT, note)
    sys.unraisablehook = unraisable
    try:
        yield noted
    finally:
        signal.signal(signal.SIGINT, before)
        sys.unraisablehook = hook


@dataclass
class Settings:
    """What holds for the whole call."""

    debug: bool = False
    scenes: list[str] = field(default_factory=list)  # what the command has loaded, as it was named

    @property
    def scene(self) -> str | None:
        """The one scene of the command, None where it has several or none."""
        return self.scenes[0] if len(self.scenes) == 1 else None


class Refusal(click.ClickException):
    """Something given cannot be used; the message says what, why and what is allowed."""

    exit_code = BAD_INPUT


def refuse_closed_stdout() -> None:
    """Raise Refusal where there is no stdout: its number would be the next file's that is opened."""
    if sys.stdout is None:  # as Python has it after `>&-`
        raise Refusal("standard output is closed; send it somewhere, such as > /dev/null")


def report(error: Exception, settings: Settings) -> int:
    """Print the message of an error on stderr; return the exit status."""
    status, text = explain(error, settings.scene)
    if status == BUG:
        text = f"{text}\n{_keep_traceback(error, settings)}"
    elif settings.debug:
        traceback.print_exception(error)
    if text:
        click.echo(text, err=True)
    if isinstance(error, BrokenPipeError):
        _silence_stdout()
    return status


def explain(error: Exception, scene: str | None = None) -> tuple[int, str]:
    """Return the exit status and the message of an error.

    What is found wrong with a scene only when it is built, or that it has no rest, tells its file or preset.
    """
    if isinstance(error, click.Abort):
        return INTERRUPTED, "interrupted"
    if isinstance(error, click.UsageError):
        return BAD_INPUT, _usage(error)
    if isinstance(error, click.ClickException):
        return error.exit_code, _error_lines(error.format_message())
    if isinstance(error, BrokenPipeError):
        return BUG + 140, ""  # 141, as of a process that SIGPIPE ended
    if isinstance(error, OSError):
        return BAD_INPUT, _error_lines(_system(error))
    if isinstance(error, MemoryError):
        text = "not enough memory: take fewer segments, or fewer frames (run.frame_rate)"
        return BAD_INPUT, _error_lines(text)
    if _is_refusal(error):
        text = str(_named(error, scene))
        for words, flag in _IN_FLAGS.items():
            text = text.replace(words, flag)
        return BAD_INPUT, _error_lines(text)
    for module, failure in (("ropewalk.statics", "NoRest"), ("ropewalk.vibration", "NoModes")):
        known = sys.modules.get(module)
        if known is not None and isinstance(error, getattr(known, failure)):
            return BROKE, _error_lines(f"{scene}: {error}" if scene else str(error))
    name = type(error).__name__
    return BUG, f"error in Ropewalk itself: {name}: {error}"


def show_warning(
    message: Warning | str,
    category: type[Warning],
    filename: str,
    lineno: int,
    file: TextIO | None = None,
    line: str | None = None,
) -> None:
    """Print what the package warns of; the warnings of others are for those who write programs."""
    if issubclass(category, UserWarning):
        warn(str(message))


def _is_refusal(error: Exception) -> bool:
    """Whether the error is one that the package raises for what it was given."""
    from ropewalk.scene.faults import SceneError

    if isinstance(error, SceneError):
        return True
    library = sys.modules.get("ropewalk.library")  # not loaded: not raised
    if library is not None and isinstance(error, library.UnknownRope):
        return True
    known = sys.modules.get("ropewalk.record.errors")
    return known is not None and isinstance(error, (known.RunError, known.InputError))


def _named(error: Exception, scene: str | None) -> Exception:
    """Return a refusal that tells of which scene it is; that of a file alone does by itself."""
    from ropewalk.scene.faults import SceneError

    if isinstance(error, SceneError) and error.source is None:
        return SceneError(error.faults, scene)
    return error


def _error_lines(text: str) -> str:
    lines = text.splitlines() or ["unknown error"]
    if len(lines) == 1:
        return f"error: {lines[0]}"
    count = sum(int(more[1]) if (more := _MORE.search(line)) else 1 for line in lines)
    return "\n".join([f"error: {count} things are wrong", *(f"  {line}" for line in lines)])


def _usage(error: click.UsageError) -> str:
    text = f"error: {error.format_message()}"
    if error.ctx is not None:
        text += f"\nsee: {error.ctx.command_path} --help"
    return text


def _system(error: OSError) -> str:
    """What the system refused, in words."""
    from ropewalk.record.files import reason

    return f"{error.filename}: {reason(error)}" if error.filename is not None else reason(error)


def _keep_traceback(error: Exception, settings: Settings) -> str:
    text = "".join(traceback.format_exception(error))
    if settings.debug:
        return text.rstrip()
    try:
        handle, name = tempfile.mkstemp(prefix="ropewalk-error-", suffix=".txt")
        with os.fdopen(handle, "w", encoding="utf-8") as file:
            file.write(f"{' '.join(sys.argv)}\n\n{text}")
    except OSError:
        return "run the same command with --debug to see the traceback, and please report it"
    return f"the traceback is in {Path(name)}; please report it with the scene"


def _silence_stdout() -> None:
    """Keep Python from complaining, at its end, that nobody reads stdout any more."""
    null = os.open(os.devnull, os.O_WRONLY)
    os.dup2(null, sys.stdout.fileno())
