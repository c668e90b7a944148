"""A session that is broadcast: commands from pages come in, frames and messages go out, time goes on.

All here runs in one thread, the player's or the user's own; what other threads bring waits in a queue.
"""

from __future__ import annotations

import math
import sys
import time
import traceback
from collections.abc import Callable, Sequence
from concurrent.futures import Future
from functools import partial
from typing import Any

from ropewalk.live import describe, going
from ropewalk.live.aside import aside
from ropewalk.live.audience import Audience, Nobody
from ropewalk.live.bodies import Told
from ropewalk.live.commands import COMMANDS, Back, Command, LetGo, Remedy, SceneCommand
from ropewalk.live.ear import Ear
from ropewalk.live.explainer import Explainer
from ropewalk.live.frame import encode
from ropewalk.live.inbox import Inbox, Item, Reply
from ropewalk.live.messages import error_message
from ropewalk.live.meter_thread import MeterThread
from ropewalk.live.opening import OF_HANDS, Opened, Opening
from ropewalk.live.pace import BUDGET, Pace
from ropewalk.live.pictures import Compared, combiner, pictures
from ropewalk.live.session import Session
from ropewalk.live.sources import address
from ropewalk.live.stepper import Steps, advance_within
from ropewalk.live.toil import note_of_compiling, takes_long
from ropewalk.record.errors import RunError
from ropewalk.scene import Fault, SceneError
from ropewalk.scene.faults import NO_VALUE

STATUS_SECONDS = 0.25
LIVE = "live"
# What ends the steps that are still to be taken.
_JUMPS = frozenset(["play", "pause", "reset", "back", "undo", "remedy"])


class Broadcast:
    """A session with its clock, its audience and the commands that wait."""

    mode = LIVE
    duration: float | None = None

    def __init__(self, session: Session, *, playing: bool = True) -> None:
        self.session, self.playing = session, playing
        self.audience: Audience = Nobody()
        self.inbox = Inbox(self._done)
        self.wake: Callable[[], None] = lambda: None  # has the next tick come at once
        self.pace = Pace()
        self.ear = Ear()
        self.frame_number = self.layout_number = 0
        self.text = ""
        self.on_save: Callable[[], str] | None = None
        self._shape: Any = None
        self._revision = -1
        self._sent: dict[str, dict[str, Any]] = {}
        self._bodies = Told()
        self._last_status = 0.0
        self._address = ""
        self._told: Any = None
        self._dirty = True
        self._broken = False
        self._compared = Compared()
        self.meter = MeterThread()
        self._explainer = Explainer(lambda: self.wake())
        self._opening = Opening(session, lambda: self.wake())
        self._steps = Steps()
        self._lent: Future[None] | None = None  # while another thread has the session
        self._lent_for = ""  # in words
        describe.built_in()
        self.refresh()

    @property
    def can(self) -> list[str]:
        """The types of commands that are accepted."""
        without = ["ack", "knot"] if self.on_save is not None else ["ack", "knot", "save"]
        return [name for name in COMMANDS if name not in without]

    # -- commands -----------------------------------------------------------------------

    def submit(
        self, what: Command | Callable[[Broadcast], None], client: int, reply: Reply
    ) -> None:
        """Put a command, or something to be done in the broadcast, in the queue (from any thread)."""
        self.inbox.put(Item(what, client, reply))

    def handle(self, until: float = math.inf) -> None:
        """Carry out what waits, up to a time on the clock [s]; what takes long is done beside it."""
        self.inbox.gather()
        some = False
        while self._lent is None:
            ready = self._opening.take()
            if ready is not None:
                self._carry_out(ready.item, partial(self._put_in, ready), ready.also)
            elif (item := self.inbox.take(self._opening.clients)) is not None:
                self._begin(item)
            else:
                break
            some = True
            if time.perf_counter() >= until:
                self.wake()
                break
        if some and self._lent is None:
            self.refresh()

    def _begin(self, item: Item) -> None:
        """Carry out one item, or have it carried out."""
        command = item.what
        if not isinstance(command, Command):
            command(self)
        elif command.type not in self.can:
            self._carry_out(item, partial(self.act, item))
        elif Opening.takes(command, self.session):
            self._opening.ask(item)
        elif command.type == "save":
            aside(partial(self._carry_out, item, partial(self._save, item)), "save", self.wake)
        elif takes_long(command, self.session):
            self._lent_for = note_of_compiling(command, self.session)
            if self._lent_for:
                self._tell_status(time.perf_counter())
            what = partial(self._carry_out, item, partial(self.act, item, compiles=True))
            self._lent = aside(what, "lent", self.wake)
        else:
            self._carry_out(item, partial(self.act, item))

    def _carry_out(self, item: Item, what: Callable[[], bool], also: Sequence[Item] = ()) -> None:
        """Carry out an item, and `also` others of which that is all."""
        items = [item, *also]
        try:
            finished = what()
        except (SceneError, RunError) as error:
            _refuse(items, error)
            return
        except Exception as error:  # a fault of ours must not end the run; nothing has changed
            traceback.print_exception(error, file=sys.stderr)
            text = f"an error in Ropewalk itself: {type(error).__name__}: {error}"
            _refuse(items, SceneError([Fault(item.what.type, NO_VALUE, text)]))
            return
        self._dirty = True
        for one in items if finished else ():
            self._done(one.what, one.reply)

    def _done(self, command: Command, reply: Reply) -> None:
        if command.id is not None:
            made = {"id": command.id, "command": command.type, "step": self.count}
            reply({"type": "done", **made, "frame": self.frame_number + 1})

    def act(self, item: Item, *, compiles: bool = False) -> bool:
        """Carry out one command; return whether it is done with that. Raises SceneError."""
        command, kind = item.what, item.what.type
        if kind not in self.can:
            rule = "cannot be done here; there is " + ", ".join(self.can)
            raise SceneError([Fault("type", kind, rule)])
        if kind == "step":
            if self.playing or self.session.broken is not None:
                return True
            self._steps.ask(item)
            return False
        if kind in _JUMPS:
            self._end_steps()
        if kind == "play":
            self.playing = self.session.broken is None
        elif kind == "pause":
            self.playing = False
        elif kind == "listen":
            self.ear.listen(item.client, command.on)
        else:
            self._note(self.session.apply(command, item.client))
            if isinstance(command, Remedy | Back):
                back = isinstance(command, Back) or command.remedy == "back"
                self.playing = not back
            if compiles:
                for track in self.session.tracks:
                    track.simulation.advance_frames(0)
        if kind not in OF_HANDS:  # what leaves the cost of a step as it is must not hide it
            self.pace.restart()
        return True

    def _put_in(self, ready: Opened) -> bool:
        """Broadcast what was built beside. What was paused stays so, but for what a break has stopped."""
        self._end_steps()
        stopped = self.session.broken is not None
        command = ready.item.what
        self._note(self.session.apply(command, ready.item.client, ready.made.result()))
        if stopped and isinstance(command, SceneCommand):
            self.playing = True
        self.pace.restart()
        return True

    def _save(self, item: Item) -> bool:
        assert self.on_save is not None
        item.reply({"type": "saved", "folder": self.on_save(), "replays": True})
        return True

    def _note(self, text: str) -> None:
        if text:
            self.audience.tell({"type": "note", "text": text})

    def _end_steps(self) -> None:
        for item in self._steps.end():
            self._done(item.what, item.reply)

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
        if self._explainer.message is not None:
            tell(self._explainer.message)
        if self.audience.size <= 1:
            self._begin_intervals()  # nobody has asked for what was before
        self._dirty = True

    @property
    def address(self) -> str:
        """What a link to this set-up has behind #."""
        return self._address

    def close(self) -> None:
        """End what runs beside the broadcast."""
        self.meter.end()

    def leave(self, client: int) -> None:
        """End what a page held: its grabs, drags and keys."""
        self.ear.listen(client, False)
        if any(track.hands.holds(client) for track in self.session.tracks):
            self.session.apply(LetGo(type="let_go"), client)
            self._dirty = True

    # -- time ---------------------------------------------------------------------------

    def tick(self) -> None:
        """Carry out what waits, go on by the time that has passed, show a frame.

        Only what is short is done here: nothing is but a single step of a very large scene.
        """
        if self._lent is not None:
            if not self._lent.done():
                self.inbox.gather()
                return
            self._lent, self._lent_for = None, ""
            self.refresh()
        self.handle(time.perf_counter() + BUDGET)
        if self._lent is None:
            self._go_on()

    def _go_on(self) -> None:
        if self.playing and self.session.broken is None:
            self._play()
        elif self._steps:
            for item in self._steps.take(self.session, BUDGET):
                self._done(item.what, item.reply)
            self._dirty = True
            self.wake()
        self.session.look()
        if (note := self.session.end_ties()) is not None:
            self._note(note)
            self._dirty = True
        self.refresh()  # a rope may have parted, or be two now
        self._look_at_break()
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
            self.ear.attend(main)
            self.pace.begin()
            self.pace.end(advance_within(self.session, steps, BUDGET), steps)
            self.ear.tell(self.audience, main.dt, self.session.speed)
            self._dirty = True
        self.pace.note(self.session.time)

    def _look_at_break(self) -> None:
        broken = self.session.broken is not None
        if broken and not self._broken:
            self.playing, self._dirty = False, True
            self._tell_status(time.perf_counter())
        self._broken = broken
        found = self._explainer.look(self.session)
        if found is not None:
            self.audience.tell(found)

    @property
    def waits(self) -> str:
        """What pages wait for, in words, or ""."""
        return self._lent_for or self._opening.words

    # -- telling ------------------------------------------------------------------------

    def refresh(self) -> None:
        """Tell the pages of everything that has changed since the last time."""
        if self.session.revision != self._revision:
            self._revision = self.session.revision
            made = describe.layout(self.session)
            shape = describe.written(made)
            if shape != self._shape:
                self._shape = shape
                self.layout_number += 1
                self._compared = Compared()
            self._tell({**made, "layout": self.layout_number})
            self._bodies.moved(self.session.main.simulation)
            self._tell(describe.parameters(self.session))
            self.meter.ask([track.simulation.model for track in self.session.tracks])
            loaded = (self.session.loaded, self.session.preset)
            self._address = address(self.session.start, loaded, self.session.changes)
        session = self.session
        if self._bodies.moved(session.main.simulation):
            found = describe.obstacles(session)
            self._sent["layout"] = {**self._sent["layout"], "obstacles": found}
            self.audience.tell({"type": "obstacles", "obstacles": found})
        about = (session.speed, session.broken, session.undo.word)
        now = (self.playing, *about, self._address, self.text, self.waits)
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
        return going.status(self)

    def show(self) -> None:
        """Make a frame and show it."""
        self._dirty = False
        self.frame_number += 1
        self.audience.show(self.frame_number, self.frame(), combiner(self.session.tracks))
        self._begin_intervals()
        self.meter.begin()

    def _begin_intervals(self) -> None:
        """Count what is seen from now on."""
        for track in self.session.tracks:
            track.shown.begin()

    def frame(self) -> bytes:
        """Return the present frame."""
        found = pictures(self.session.tracks, self._compared, playing=self.playing)
        return encode(going.head(self), found)


def _refuse(items: Sequence[Item], error: SceneError | RunError) -> None:
    for what, _, reply in items:
        reply(error_message(what.type, what.id, error))
