"""A session on the stage: commands from pages come in, frames and messages go out, time goes on.

Everything here runs in one thread, the player's or the user's own; what comes from other threads waits
in a queue.
"""

from __future__ import annotations

import queue
import sys
import time
import traceback
from collections.abc import Callable
from typing import Any, Protocol

from ropewalk.core.cache import is_compiled
from ropewalk.live import breaks, describe
from ropewalk.live.commands import Back, Command, Remedy, SceneCommand, Set
from ropewalk.live.frame import BROKEN, GRABBED, PLAYING, SLOW, Clockwork, encode
from ropewalk.live.messages import error_message
from ropewalk.live.meter_thread import MeterThread
from ropewalk.live.pace import Pace
from ropewalk.live.pictures import Compared, pictures
from ropewalk.live.session import Session
from ropewalk.live.sources import address
from ropewalk.methods.registry import METHODS
from ropewalk.scene import Fault, SceneError
from ropewalk.scene.errors import NO_VALUE

Reply = Callable[[dict[str, Any]], None]
STATUS_SECONDS = 0.25
LIVE = "live"
_PLAYER = frozenset(["play", "pause", "step", "speed"])
_COALESCED = frozenset(["set", "drag", "grab", "move"])


class Audience(Protocol):
    """Whoever looks on: pages behind a server."""

    @property
    def size(self) -> int:
        """How many look on."""

    def show(self, number: int, frame: bytes) -> None:
        """Show a frame to all."""

    def tell(self, message: dict[str, Any]) -> None:
        """Send a message to all."""


class Nobody:
    """An audience of none."""

    size = 0

    def show(self, number: int, frame: bytes) -> None:
        """Show a frame to nobody."""

    def tell(self, message: dict[str, Any]) -> None:
        """Tell nobody."""


class Stage:
    """A session with its clock, its audience and the commands that wait."""

    mode = LIVE
    duration: float | None = None

    def __init__(self, session: Session, *, playing: bool = True) -> None:
        self.session, self.playing = session, playing
        self.audience: Audience = Nobody()
        self.waiting: queue.SimpleQueue[tuple[Any, int, Reply]] = queue.SimpleQueue()
        self.pace = Pace()
        self.frame_number = self.layout_number = 0
        self.text = ""
        self.on_save: Callable[[], str] | None = None
        self._shape: Any = None
        self._revision = -1
        self._sent: dict[str, dict[str, Any]] = {}
        self._last_status = 0.0
        self._address = ""
        self._told: Any = None
        self._dirty = True
        self._broken = False
        self._compared = Compared()
        self.meter = MeterThread()
        self.refresh()

    @property
    def can(self) -> list[str]:
        """The types of commands that are accepted."""
        from ropewalk.live.commands import COMMANDS

        return [name for name in COMMANDS if name not in ("seek", "ack")]

    # -- commands -----------------------------------------------------------------------

    def submit(self, item: Command | Callable[[Stage], None], client: int, reply: Reply) -> None:
        """Put a command, or something to be done on the stage, in the queue (from any thread)."""
        self.waiting.put((item, client, reply))

    def handle(self) -> None:
        """Carry out everything that waits; of many alike only the last."""
        batch: list[tuple[Any, int, Reply]] = []
        while True:
            try:
                batch.append(self.waiting.get_nowait())
            except queue.Empty:
                break
        last: dict[Any, int] = {}
        for i, (item, client, _) in enumerate(batch):
            if isinstance(item, Command) and item.type in _COALESCED:
                last[_subject(item, client)] = i
        for i, (item, client, reply) in enumerate(batch):
            if not isinstance(item, Command):
                item(self)
            elif item.type in _COALESCED and last[_subject(item, client)] != i:
                self._done(item, reply)
            else:
                self._carry_out(item, client, reply)
        if batch:
            self.refresh()

    def _carry_out(self, command: Command, client: int, reply: Reply) -> None:
        try:
            self.act(command, client, reply)
        except SceneError as error:
            reply(error_message(command.type, command.id, error))
            return
        except Exception as error:  # a fault of ours must not end the run; nothing has changed
            traceback.print_exception(error, file=sys.stderr)
            text = f"an error in Ropewalk itself: {type(error).__name__}: {error}"
            fault = SceneError([Fault(command.type, NO_VALUE, text)])
            reply(error_message(command.type, command.id, fault))
            return
        self._dirty = True
        self._done(command, reply)

    def _done(self, command: Command, reply: Reply) -> None:
        if command.id is not None:
            made = {"id": command.id, "command": command.type, "step": self.count}
            reply({"type": "done", **made, "frame": self.frame_number + 1})

    def act(self, command: Command, client: int, reply: Reply) -> None:
        """Carry out one command. Raises SceneError."""
        kind = command.type
        if kind not in self.can:
            rule = "cannot be done here; there is " + ", ".join(self.can)
            raise SceneError([Fault("type", kind, rule)])
        if kind == "save":
            folder = self.on_save() if self.on_save is not None else None
            reply({"type": "saved", "folder": folder, "replays": folder is not None})
            return
        if kind == "play":
            self.playing = self.session.broken is None
        elif kind == "pause":
            self.playing = False
        elif kind == "step":
            if not self.playing:
                self.session.advance(command.count)  # type: ignore[attr-defined]
        else:
            self._warn_of_compiling(command)
            note = self.session.apply(command, client)
            if note:
                self.audience.tell({"type": "note", "text": note})
            if isinstance(command, SceneCommand | Remedy | Back):
                back = isinstance(command, Back) or getattr(command, "remedy", "") == "back"
                self.playing = not back
        self.pace.restart()

    def _warn_of_compiling(self, command: Command) -> None:
        """Say that a method will be compiled first, when it will."""
        if isinstance(command, Set) and command.name == "method":
            name = command.value
            if isinstance(name, str) and name in METHODS and not is_compiled(METHODS[name].advance):
                text = f"compiling {name}: the first time on this machine takes a minute or two"
                self.audience.tell({"type": "note", "text": text})

    @property
    def count(self) -> int:
        """Steps done."""
        return self.session.count

    def join(self, tell: Reply) -> None:
        """Tell a new page everything."""
        for name in ("layout", "parameters"):
            tell(self._sent[name])
        tell(describe.presets(self.session))
        tell(self.status())
        if self.meter.latest is not None:
            tell(self.meter.latest)
        if "broken" in self._sent and self.session.broken is not None:
            tell(self._sent["broken"])
        self._dirty = True

    @property
    def address(self) -> str:
        """What a link to this set-up has behind #."""
        return self._address

    def close(self) -> None:
        """End what runs beside the stage."""
        self.meter.end()

    def leave(self, client: int) -> None:
        """End what a page held: its grabs, drags and keys."""
        from ropewalk.live.commands import LetGo

        if any(track.hands.holds(client) for track in self.session.tracks):
            self.session.apply(LetGo(type="let_go"), client)
            self._dirty = True

    # -- time ---------------------------------------------------------------------------

    def tick(self) -> None:
        """Carry out what waits, go on by the time that has passed, show a frame."""
        self.handle()
        if self.playing and self.session.broken is None:
            self._play()
        if self.session.broken is not None and not self._broken:
            self._show_break()
        self._broken = self.session.broken is not None
        found = self.meter.take()
        if found is not None:
            self.audience.tell(found)
        self.tell_status_now_and_then()
        if self._dirty and self.audience.size > 0:
            self.show()

    def _play(self) -> None:
        main = self.session.main
        steps = self.pace.steps(main.dt, self.session.speed)
        if steps > 0:
            with self.pace.measured(steps):
                self.session.advance(steps)
            self._dirty = True
        self.pace.note(self.session.time)

    def _show_break(self) -> None:
        self.playing = False
        self._sent["broken"] = breaks.explain(self.session)
        self.audience.tell(self._sent["broken"])
        self._tell_status(time.perf_counter())
        self._dirty = True

    # -- telling ------------------------------------------------------------------------

    def refresh(self) -> None:
        """Tell the pages of everything that has changed since the last time."""
        if self.session.revision != self._revision:
            self._revision = self.session.revision
            made = describe.layout(self.session)
            shape = _shape(made)
            if shape != self._shape:
                self._shape = shape
                self.layout_number += 1
                self._compared = Compared()
            self._tell({**made, "layout": self.layout_number})
            self._tell(describe.parameters(self.session))
            self.meter.ask([track.simulation.model for track in self.session.tracks])
            loaded = (self.session.loaded, self.session.preset)
            self._address = address(self.session.start, loaded, self.session.changes)
        now = (self.playing, self.session.speed, self.session.broken, self._address, self.text)
        if now != self._told:
            self._told = now
            self._tell_status(time.perf_counter())

    def _tell(self, message: dict[str, Any]) -> None:
        if self._sent.get(message["type"]) != message:
            self._sent[message["type"]] = message
            self.audience.tell(message)

    def tell_status_now_and_then(self) -> None:
        """Tell the pages how it goes, four times a second while it goes."""
        now = time.perf_counter()
        if self.playing and now - self._last_status >= STATUS_SECONDS:
            self._tell_status(now)

    def _tell_status(self, now: float) -> None:
        self._last_status = now
        self.audience.tell(self.status())

    def status(self) -> dict[str, Any]:
        """Return the `status` message."""
        session = self.session
        plan = session.main.simulation.plan
        slow = self.playing and self.pace.slow
        text = self.text
        if slow:
            text = (
                f"{self.pace.realtime:.2g} of real time: this computer is too slow for "
                f"{session.main.simulation.layout.nodes} nodes in steps of {1e3 * plan.dt:.3g} ms"
            )
        return {
            "type": "status",
            "playing": self.playing,
            "speed": session.speed,
            "realtime": self.pace.realtime if self.playing else 0.0,
            "slow": slow,
            "text": text,
            "time": session.time,
            "step": session.count,
            "dt": plan.dt,
            "steps_per_frame": plan.steps_per_frame,
            "method": plan.method,
            "broken": session.broken is not None,
            "clients": self.audience.size,
            "address": self._address,
            "duration": self.duration,
        }

    def show(self) -> None:
        """Make a frame and show it."""
        self._dirty = False
        self.frame_number += 1
        self.audience.show(self.frame_number, self.frame())
        self.meter.begin()

    def frame(self) -> bytes:
        """Return the present frame."""
        session = self.session
        flags = PLAYING * self.playing + BROKEN * (session.broken is not None)
        flags += SLOW * (self.playing and self.pace.slow)
        flags += GRABBED * bool(session.main.hands.grabs)
        realtime = self.pace.realtime if self.playing else 0.0
        head = Clockwork(
            self.layout_number,
            self.frame_number,
            flags,
            session.time,
            session.count,
            realtime,
            session.speed,
            self.pace.load,
        )
        return encode(head, pictures(session.tracks, self._compared))


def _subject(command: Command, client: int) -> tuple[Any, ...]:
    """What a command is about: of several in one batch only the last counts."""
    about = command.model_dump(exclude={"id", "value", "target", "velocity"})
    return (client, *sorted((key, str(value)) for key, value in about.items()))


def _shape(layout: dict[str, Any]) -> Any:
    """What decides how frames are written and drawn, of a layout message."""
    return [
        (
            one["nodes"],
            len(one["anchors"]),
            [(rope["name"], rope["first"], rope["nodes"]) for rope in one["ropes"]],
        )
        for one in layout["variants"]
    ]
