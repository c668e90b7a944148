"""A live session: one scene, or several variants of it driven by the same hand, and all that is done to it.

The session knows nothing of clocks, threads or pages. Everything that changes it is a command that takes
effect at a counted step, so that its log replays to the same bits.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from itertools import count
from typing import Any

from ropewalk.core.status import BROKEN, OK
from ropewalk.live import edits
from ropewalk.live.actions import ACTIONS
from ropewalk.live.changes import Key, changes_between, label_of, loaded_value, same
from ropewalk.live.commands import PHYSICAL, Command, Knot
from ropewalk.live.energy_off import weigh
from ropewalk.live.history import EVERY, History, Moment
from ropewalk.live.parameters import Parameter, named, refusal
from ropewalk.live.saved import Saved
from ropewalk.live.track import Track, planned
from ropewalk.live.undo import WORDS, Undo
from ropewalk.scene import Scene
from ropewalk.simulation import Simulation


@dataclass(frozen=True)
class Break:
    """Where a session broke: the variant, and what it was just before and after its last good step."""

    variant: int
    chunk: int  # steps in which it broke
    revision: int = 0  # of the session, when it broke
    simulation: Simulation | None = (
        None  # that broke; not that of the variant any more once it is changed
    )


class Session:
    """A running simulation with its variants, changed by commands."""

    def __init__(self, scene: Scene, preset: str | None = None, track: Track | None = None) -> None:
        """Start a scene at time zero. Raises SceneError when it cannot be planned."""
        self.on_command: Callable[[int, int, Command], None] = lambda count, client, command: None
        self.on_break: Callable[[int, int], None] = lambda count, variant: None
        self.on_frame: Callable[[Session], None] = lambda session: None
        self._numbers = count()  # of the moments of history and undo together
        self.history = History()
        self.undo = Undo()
        self.revision = 0  # counts all that a page must be told of
        self.speed = 1.0
        self.broken: Break | None = None
        self.start = (scene, preset)  # what the program was started with
        self.tracks: list[Track] = []
        self.preset, self.loaded = preset, scene
        self.changes: dict[Key, Any] = {}
        if track is None:
            self.open(scene, preset)
        else:
            self._take(track, scene, preset)

    @classmethod
    def of(cls, simulation: Simulation) -> Session:
        """Return a session around a simulation that somebody else steps."""
        return cls(simulation.scene, None, Track.of(simulation))

    def open(self, scene: Scene, preset: str | None) -> None:
        """Take another scene in place of the present one. Raises SceneError."""
        edits.check_size(scene)
        self._take(Track(scene, "as it is"), scene, preset)

    def adopt(self, other: Session) -> None:
        """Take the scene of another session, and all that was changed in it, in place of the present one."""
        other.main.count = self.count
        self.tracks = [other.main]
        self.preset, self.loaded, self.changes = other.preset, other.loaded, dict(other.changes)
        self.broken = None
        self.undo.clear()
        self.remember(clear=True)
        self.changed()

    def _take(self, track: Track, scene: Scene, preset: str | None) -> None:
        track.count = self.count if self.tracks else 0
        self.tracks = [track]
        self.preset = preset
        self.loaded = planned(scene, track.simulation.plan)
        self.changes = {}
        self.undo.clear()
        self.remember(clear=True)
        self.changed()

    def changed(self) -> None:
        """Count a change of the scene, of its structure or of a constant."""
        self.revision += 1

    # -- what it is now -----------------------------------------------------------------

    @property
    def main(self) -> Track:
        """The first variant: the scene as it is."""
        return self.tracks[0]

    @property
    def count(self) -> int:
        """Steps of the first variant since the session began."""
        return self.main.count

    @property
    def time(self) -> float:
        """Simulated time [s]."""
        return self.main.simulation.time

    @property
    def scene(self) -> Scene:
        """The scene as it is now, without its shapes."""
        return self.main.scene

    # -- moving on ----------------------------------------------------------------------

    def advance(self, steps: int) -> int:
        """Advance by so many steps of the first variant, the others up to the same time.

        When one breaks, all stand where they were before the present part of the steps, `broken`
        says which, and BROKEN is returned.
        """
        while steps > 0 and self.broken is None:
            frame = self.frame_steps
            every = frame * max(1, round(EVERY / (frame * self.main.dt)))
            now = min(steps, frame - self.count % frame)
            before = tuple(track.save() for track in self.tracks)
            broken = self._advance_all(now)
            if broken is not None:
                for track, saved in zip(self.tracks, before, strict=True):
                    track.restore(saved, undo=True)
                self.broken = Break(broken, now, self.revision, self.tracks[broken].simulation)
                self.on_break(self.count, broken)
                return BROKEN
            steps -= now
            if self.count % frame == 0:
                self.look()
                self._tear()
                for track in self.tracks:
                    weigh(track, track.simulation.recording().recording)
                self.on_frame(self)
            if self.count % every == 0:
                self.remember()
        return OK if self.broken is None else BROKEN

    def _advance_all(self, steps: int) -> int | None:
        if self.main.advance(steps, self.speed) != OK:
            return 0
        time = self.main.simulation.time
        for number, track in enumerate(self.tracks[1:], start=1):
            if track.follow(time, self.speed) != OK:
                return number
        return None

    def look(self) -> None:
        """Note what has parted: pages are told of it."""
        for track in self.tracks:
            if track.look():
                self.changed()

    def _tear(self) -> None:
        """Make two ropes of those that have parted: at frames, so that a log replays to the same bits."""
        for track in self.tracks:
            if track.tear():
                self.changed()

    @property
    def frame_steps(self) -> int:
        """Steps of the first variant from one recorded frame to the next."""
        return max(1, round(self.loaded.run.frame_interval / self.main.dt))

    # -- going back ---------------------------------------------------------------------

    def remember(self, *, clear: bool = False) -> None:
        """Keep the present moment in the history."""
        if clear:
            self.history.clear()
        self.history.add(self._moment())

    def _moment(self) -> Moment:
        saved = tuple(track.save() for track in self.tracks)
        about = (self.loaded, self.preset, dict(self.changes), list(self.tracks))
        return Moment(self.time, saved, about, next(self._numbers))

    def go_back(self, moment: Moment) -> None:
        """Go back to a moment of the history. Hands let go."""
        self._put(moment)
        self.history.forget_after(moment)
        self.undo.forget_after(moment)

    def undo_last(self) -> bool:
        """Go to just before what was done last; tell whether there was anything. Hands let go."""
        moment = self.undo.take()
        if moment is None:
            return False
        self._put(moment)
        self.broken = None
        self.remember(clear=True)
        return True

    def _put(self, moment: Moment) -> None:
        self.loaded, self.preset, changes, tracks = moment.session
        count = self.count
        self.changes, self.tracks = dict(changes), list(tracks)
        for track, saved in zip(self.tracks, moment.tracks, strict=True):
            track.restore(saved)
            # What they held then they may have let go of since.
            track.hands.let_go(track.simulation, None)
            track.hands.stop(track.simulation, None)
        self.main.count = count
        self.changed()

    # -- commands -----------------------------------------------------------------------

    def apply(
        self, command: Command, client: int = 0, ready: Callable[[Session], str] | None = None
    ) -> str:
        """Carry out a command that changes the simulation; return a note, or "".

        All or nothing: when it is refused (SceneError), nothing has changed. `ready` puts in place what the
        command asks for, where that was built already.
        """
        if command.type not in PHYSICAL:
            raise KeyError(command.type)
        count = self.count
        before = self._everything()
        begins = getattr(command, "begin", True)  # of a stroke all is undone at once
        moment = self._moment() if command.type in WORDS and begins else None
        try:
            note = ready(self) if ready else ACTIONS[command.type](self, command, client)
        except BaseException:
            self._put_back(before)
            raise
        if moment is not None:
            self.undo.note(command.type, moment)
        self.on_command(count, client, command)
        return note

    def end_ties(self) -> str | None:
        """Tie what hands have brought together, let go what they could not; None: there is neither.

        Else a note, or "".
        """
        if any(track.hands.over(track.simulation) for track in self.tracks):
            return self.apply(Knot(type="knot"))
        return None

    def _everything(self) -> tuple[Any, ...]:
        saved = tuple(track.save() for track in self.tracks)
        about = (self.loaded, self.preset, dict(self.changes), self.speed, self.broken)
        return list(self.tracks), saved, about

    def _put_back(self, before: tuple[Any, ...]) -> None:
        tracks, saved, about = before
        self.tracks = list(tracks)
        self.loaded, self.preset, self.changes, self.speed, self.broken = about
        one: Saved
        for track, one in zip(self.tracks, saved, strict=True):
            track.restore(one, undo=True)

    def set(self, name: str, value: Any, rope: str | None, variant: int | None) -> None:
        """Change a parameter of all variants, or of one. Raises SceneError."""
        parameter, default = named(name), value is None
        if why := parameter.barred(self.loaded):
            raise refusal(name, value, why)
        for number, track in enumerate(self.tracks):
            if number == variant or (variant is None and not track.keeps(name)):
                before = track.scene
                wanted = _wanted(parameter, value, rope, self.loaded, track.scene)
                for one, its in wanted:
                    track.set(name, its, one)
                if variant is None:
                    track.keep_changes(before)
                elif number > 0:
                    _note(track, parameter, wanted, f"variant {number}")
                if track.scene is not before:
                    self.changed()
        known = rope is None or rope in [one.name for one in self.loaded.ropes]
        if known and (variant is None or variant == 0):
            self.changes.pop((name, rope), None)
            if default and rope is None:
                for each in self.loaded.ropes:
                    self.changes.pop((name, each.name), None)
            if not default:
                self.changes[name, rope] = _resolved(name, value, self.scene)
            self.changes = changes_between(self.loaded, self.scene, self.changes)


def _wanted(
    parameter: Parameter, value: Any, rope: str | None, loaded: Scene, scene: Scene
) -> list[tuple[str | None, Any]]:
    """Return the ropes to set, None for all, each with its value: for None that of the scene as loaded."""
    if value is not None:
        return [(rope, value)]
    if not parameter.per_rope:
        return [(rope, parameter.get(loaded, 0))]
    names = [scene.ropes[i].name for i in parameter.ropes(scene, rope)]
    return [(name, loaded_value(parameter, loaded, name)) for name in names]


def _note(
    track: Track, parameter: Parameter, wanted: list[tuple[str | None, Any]], called: str
) -> None:
    """Note what was changed in one copy alone, `called` so by its number; a label given by hand stays."""
    name, names = parameter.name, {one.name for one in track.scene.ropes}
    ropes = {one: its for one, its in wanted if one is not None and parameter.per_rope}
    track.changes.pop(name, None)
    if set(ropes) in (set(), names) and all(same(its, wanted[0][1]) for _, its in wanted):
        track.changes[name], ropes = _resolved(name, wanted[0][1], track.scene), {}
    if not track.given:
        told = {(name, one): its for one, its in ropes.items()}
        track.label = label_of(track.changes, told) or called


def _resolved(name: str, value: Any, scene: Scene) -> Any:
    """The value as a number, where it was given as a word."""
    return named(name).get(scene, 0) if value == "auto" else value
