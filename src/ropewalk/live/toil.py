"""Which commands may take longer than a tick: those that build large simulations anew, or compile."""

from __future__ import annotations

from ropewalk.core.cache import is_compiled
from ropewalk.live.commands import Command, Compare, Remedy, Set
from ropewalk.live.session import Session
from ropewalk.methods.registry import METHODS

MANY = 500  # nodes; to build so many anew takes some milliseconds
_BUILDING = frozenset(
    [
        "reset",
        "set",
        "pin",
        "unpin",
        "cut",
        "untie",
        "tie",
        "load",
        "compare",
        "back",
        "undo",
        "remedy",
    ]
)


def takes_long(command: Command, session: Session) -> bool:
    """Tell whether a command may take longer than a tick."""
    if command.type not in _BUILDING:
        return False
    nodes = sum(track.simulation.layout.nodes for track in session.tracks)
    return nodes > MANY or _compiles(command)


def _compiles(command: Command) -> bool:
    """Whether another method may come into play: its machine code is read from disk, or made."""
    if isinstance(command, Set):
        return command.name == "method"
    if isinstance(command, Remedy):
        return command.remedy == "implicit"
    return isinstance(command, Compare) and any("method" in one.changes for one in command.variants)


def note_of_compiling(command: Command, session: Session) -> str:
    """Say that a method will be compiled first, when it will; else ""."""
    if not isinstance(command, Set) or command.name != "method":
        return ""
    method, rare = METHODS.get(str(command.value)), session.main.simulation.system.rare
    if method is None or is_compiled(method.advance, rare):
        return ""
    return f"compiling {command.value}: the first time on this machine takes a minute or two"
