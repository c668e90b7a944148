"""What a run says while it runs: a bar on a terminal, nothing elsewhere."""

from __future__ import annotations

import functools
import math
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from typing import TYPE_CHECKING, Any

from ropewalk.cli.console import load_tables, tell
from ropewalk.display.bar import Bar

if TYPE_CHECKING:
    from ropewalk.scene import Scene
    from ropewalk.simulation.block import Block


def is_compiled(method: str, rare: int | None, scene: Scene) -> bool:
    """Whether the machine code that moves a scene's ropes is there already, in this process or on disk."""
    from ropewalk.engine.crews import are_compiled
    from ropewalk.methods.registry import METHODS

    return are_compiled(METHODS[method], rare, scene)


def tell_compiling(method: str, scene: Scene, *, live: bool = False) -> None:
    """Say that the first steps will take a while, when they will; nothing of "auto", not yet chosen."""
    from ropewalk.lowering.variant import rare_of
    from ropewalk.methods.registry import METHODS

    rare = 1 if live else rare_of(scene)  # a live scene may get any law
    if method in METHODS and not is_compiled(method, rare, scene):
        which = f"{method} with rarer laws" if rare else method
        tell(
            f"compiling {which}: the first run on this machine takes a minute or two, "
            "later ones begin at once"
        )


@contextmanager
def listening_to_compiling(tell: Callable[[str], None]) -> Iterator[None]:
    """Call `tell` with the name of every kernel of which machine code has to be made."""
    from numba.core import event

    class Listener(event.Listener):
        def on_start(self, event: Any) -> None:
            tell(event.data["dispatcher"].py_func.__name__)

        def on_end(self, event: Any) -> None:
            pass

    with event.install_listener("numba:compile", Listener()):
        yield


@contextmanager
def telling_of_compiling() -> Iterator[None]:
    """Say so, once, when machine code has to be made."""

    @functools.cache
    def tell_once() -> None:
        tell("compiling: the first time on this machine takes a minute or two, later ones none")

    with listening_to_compiling(lambda _: tell_once()):
        yield


def energy_error(block: Block, scene: Scene) -> float:
    """Return, for the last frame, total energy less the work of all laws without a potential [J].

    Up to a constant: the energy at the run's start. With what bodies err by that their weight turns.
    """
    from ropewalk.methods.recording import CONSERVATIVE, ENERGIES, work_names
    from ropewalk.record.body_energies import unaccounted, weight_turns

    work, energy = block.recording.work[-1], block.recording.energy[-1]
    laws = work_names(len(energy) > len(ENERGIES))
    potential = [laws.index(law) for law in CONSERVATIVE if law in laws]
    done = work.sum() - sum(work[i] for i in potential)
    turned = unaccounted(block.recording.wheel[-1]) if weight_turns(scene) else 0.0
    return float(energy.sum() - done + turned)


def facts_of(now: float, end: float, speed: float, drift: float) -> tuple[str, ...]:
    """Return what stands behind the bar, what matters most first.

    Args:
        now, end: simulated time, and where it ends [s].
        speed: simulated over wall time [1].
        drift: of the energy [J].
    """
    return f"{now:.4g}/{end:.4g} s", f"{speed:.2g}x real time", f"energy {drift:+.1e} J"


class RunProgress:
    """A bar with simulated time, speed against real time and time left; on a wide terminal energy drift, too.

    Use as a context manager; call it with frames done, frames planned and the newest block. Silent
    when `quiet` or when stderr is no terminal.
    """

    def __init__(self, scene: Scene, *, quiet: bool = False) -> None:
        from ropewalk.core.deferred import clock

        self._scene = scene
        self._bar = Bar(scene.name, shown=not quiet)
        self._held = ExitStack()
        self._clock = clock
        self._begun = clock()
        self._compiled = 0  # pieces of machine code
        self._first = 0.0  # energy error of the first frame [J]
        self._from: float | None = None  # simulated time where this part of the run began [s]

    def __enter__(self) -> RunProgress:
        load_tables()
        self._held.enter_context(self._bar)
        self._held.enter_context(listening_to_compiling(self._say_compiling))
        return self

    def _say_compiling(self, name: str) -> None:
        """Say what is compiled and how far that is; how many pieces there are, only the end tells."""
        self._compiled += 1
        spent = self._clock() - self._begun
        self._bar.say(f"compiling {name}, piece {self._compiled}, {spent:.0f} s so far")

    def __call__(self, done: int, planned: int, block: Block) -> None:
        """Show that `done` of `planned` frames are done."""
        if not block.frames:
            return
        now = float(block.time[-1])
        frame = now / done if done else 0.0
        if self._from is None:
            self._from = now - frame * block.frames
            self._first = energy_error(block.head(1), self._scene)
            self._bar.begin(done - block.frames, planned)
        spent = self._clock() - self._begun
        speed = (now - self._from) / spent if spent > 0.0 else math.inf
        drift = energy_error(block, self._scene) - self._first
        self._bar.show(done, planned, facts_of(now, frame * planned, speed, drift))

    def __exit__(self, *error: Any) -> None:
        self._held.__exit__(*error)


@contextmanager
def counting(title: str, things: str) -> Iterator[Callable[[int, int], None]]:
    """Give a function to call with the things done and those in all; a bar on a terminal."""
    with Bar(title) as bar:
        yield lambda done, planned: bar.show(done, planned, [f"{done} of {planned} {things}"])
