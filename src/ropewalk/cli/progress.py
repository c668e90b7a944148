"""What a run says while it runs: a bar on a terminal, nothing elsewhere."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from types import TracebackType
from typing import TYPE_CHECKING, Any

from ropewalk.cli.console import tell, terminal

if TYPE_CHECKING:
    from ropewalk.block import Block
    from ropewalk.scene import Scene

_NARROW, _WIDE = 70, 110  # columns from which on more is said
_NAME = 18  # letters of a scene's name on all but wide terminals


def is_compiled(method: str) -> bool:
    """Whether the machine code of a method is there already, in this process or on disk."""
    from ropewalk.core import cache
    from ropewalk.methods.registry import METHODS

    return cache.is_compiled(METHODS[method].advance)


def tell_compiling(method: str) -> None:
    """Say that the first steps will take a while, when they will; nothing of "auto", not yet chosen."""
    from ropewalk.methods.registry import METHODS

    if method in METHODS and not is_compiled(method):
        tell(
            f"compiling {method}: the first run of a method on this machine takes a minute or two, "
            "later ones begin at once"
        )


@contextmanager
def telling_of_compiling() -> Iterator[None]:
    """Say so, once, when machine code has to be made."""
    from numba.core import event

    class Teller(event.Listener):
        told = False

        def on_start(self, _: object) -> None:
            if not self.told:
                self.told = True
                tell(
                    "compiling: the first time on this machine takes a minute or two, later ones none"
                )

        def on_end(self, _: object) -> None:
            pass

    with event.install_listener("numba:compile", Teller()):
        yield


def energy_error(block: Block) -> float:
    """Return, for the last frame, total energy less the work of all laws without a potential [J].

    Up to a constant: the energy at the run's start.
    """
    from ropewalk.methods.recording import CONSERVATIVE, ENERGIES, work_names

    work, energy = block.recording.work[-1], block.recording.energy[-1]
    laws = work_names(len(energy) > len(ENERGIES))
    potential = [laws.index(law) for law in CONSERVATIVE if law in laws]
    done = work.sum() - sum(work[i] for i in potential)
    return float(energy.sum() - done)


def shortened(text: str, most: int) -> str:
    """Return a text of at most so many letters."""
    return text if len(text) <= most else text[: most - 1] + "…"


def facts_of(now: float, end: float, speed: float, drift: float, width: int) -> str:
    """Return what stands behind the bar: no more than leaves the bar some room on the terminal.

    Args:
        now, end: simulated time, and where it ends [s].
        speed: simulated over wall time [1].
        drift: of the energy [J].
        width: of the terminal [letters].
    """
    time = f"{now:.4g}/{end:.4g} s"
    if width < _NARROW:
        return time
    if width < _WIDE:
        return f"{time}  {speed:.2g}x real time"
    return f"{time}  {speed:.3g} x real time  energy {drift:+.1e} J"


class RunProgress:
    """A bar with simulated time, speed against real time and time left; on a wide terminal energy drift, too.

    Use as a context manager; call it with frames done, frames planned and the newest block. Silent
    when `quiet` or when stderr is no terminal.
    """

    def __init__(self, scene: Scene, *, quiet: bool = False) -> None:
        self._scene = scene
        self._bar: Any = None
        self._task: Any = None
        self._quiet = quiet or not terminal()
        self._first: float | None = None
        self._begun = time.perf_counter()
        self._width = _WIDE
        self._from: float | None = None  # simulated time where this part of the run began [s]

    def __enter__(self) -> RunProgress:
        if self._quiet:
            return self
        from rich.progress import BarColumn, Progress, TextColumn, TimeRemainingColumn

        from ropewalk.cli.console import console

        made = console(stderr=True)
        self._width = made.width
        self._bar = Progress(
            TextColumn("{task.description}", markup=False),
            BarColumn(bar_width=None),
            TextColumn("{task.percentage:>3.0f} %", markup=False),
            TextColumn("{task.fields[facts]}", markup=False),
            TimeRemainingColumn(compact=True),
            console=made,
            transient=False,
            expand=True,
        )
        name = shortened(self._scene.name, _NAME if made.width < _WIDE else made.width // 4)
        self._task = self._bar.add_task(name, total=None, facts="")
        self._bar.start()
        return self

    def __call__(self, done: int, planned: int, block: Block) -> None:
        """Show that `done` of `planned` frames are done."""
        if self._bar is None or not block.frames:
            return
        now = float(block.time[-1])
        frame = now / done if done else 0.0
        if self._from is None:
            self._from = now - frame * block.frames
            self._first = energy_error(block.head(1))
            self._bar.reset(self._task, completed=done - block.frames, total=planned)
        spent = time.perf_counter() - self._begun
        speed = (now - self._from) / spent if spent > 0.0 else math.inf
        drift = energy_error(block) - (self._first or 0.0)
        facts = facts_of(now, frame * planned, speed, drift, self._width)
        self._bar.update(self._task, completed=done, total=planned, facts=facts)

    def __exit__(
        self,
        kind: type[BaseException] | None,
        value: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        if self._bar is not None:
            self._bar.stop()


@contextmanager
def counting(what: str) -> Iterator[Callable[[int, int], None]]:
    """Give a function to call with the things done and those in all; a bar on a terminal."""
    if not terminal():
        yield lambda done, planned: None
        return
    from rich.progress import Progress

    from ropewalk.cli.console import console

    with Progress(console=console(stderr=True), transient=True) as bar:
        task = bar.add_task(what, total=None)

        def show(done: int, planned: int) -> None:
            bar.update(task, completed=done, total=planned)

        yield show
