"""Run a scene into memory."""

from __future__ import annotations

from collections.abc import Callable

from ropewalk.core.deferred import clock, uncounted
from ropewalk.core.status import OK, UNSOLVED
from ropewalk.engine.spare import Spare
from ropewalk.lowering import Model
from ropewalk.methods.recording import Recording
from ropewalk.record.beyond import Beyond, look_beyond
from ropewalk.record.ends import End, in_words
from ropewalk.record.event_log import Event
from ropewalk.record.facts import BROKE, FINISHED, ROPE_BROKE, Facts, provenance
from ropewalk.record.happenings import Watch
from ropewalk.record.quantities import recorded
from ropewalk.record.result import Result
from ropewalk.record.source import Memory
from ropewalk.scene import Scene
from ropewalk.simulation import Simulation
from ropewalk.simulation.block import Block, join

#: Called after every block with the frames done, frames planned and the block.
Progress = Callable[[int, int, Block], None]
#: Says why a run broke, from a simulation that stands at its last good frame.
Explain = Callable[[Simulation], str]


def no_explanation(simulation: Simulation) -> str:
    """Say when a run broke."""
    return f"Broke after t = {simulation.time:.6g} s."


class Runner:
    """Advances a simulation and notes what happens; has a break explained, and may go on into it."""

    def __init__(
        self,
        simulation: Simulation,
        keep_going: bool,
        explain: Explain,
        *,
        resumed: bool = False,
        ends: tuple[End, ...] = (),
        frames: int = 1,
    ) -> None:
        """Take up a simulation after `frames` frames; `ends` are those of a run that is resumed."""
        self.simulation = simulation
        self._keep_going, self._explain = keep_going, explain
        self._watch = Watch(simulation, resumed=resumed)
        for end in ends:
            self._watch.leave(end.ropes)
        self._events: list[Event] = []
        self.beyond: Beyond | None = None  # set where it breaks and is not to go on
        self.ends = ends
        self._frames = frames  # so far

    @property
    def diagnosis(self) -> str:
        """Why what broke broke; "" as long as nothing has."""
        return in_words(self.ends, len(self.simulation.scene.ropes))

    def advance(self, frames: int, out: Recording | None = None) -> Block:
        """Advance by so many frames, or up to the break, where the status is then BROKEN.

        `out`: buffers for so many frames, which the block holds unless the run breaks in it.
        """
        block = self._advance(frames, out)
        self._events += self._watch.look()
        self._frames += block.frames
        return block

    def _advance(self, frames: int, out: Recording | None) -> Block:
        if self.diagnosis and self._keep_going:
            return self.simulation.advance_frames(frames, keep_going=True, out=out)
        block = self.simulation.advance_frames(frames, out=out)
        if block.status == OK:
            return block
        self._events += self._watch.look()
        if self._keep_going:
            return self._go_on_into(block, frames)
        parts = [block]
        while block.status != OK:
            done = sum(part.frames for part in parts)
            if not self._end(self._frames + done) or done == frames:
                break
            block = self.simulation.advance_frames(frames - done)
            self._events += self._watch.look()
            parts.append(block)
            if block.status == OK and block.frames < frames - done:  # asked to stop
                break
        return parts[0] if len(parts) == 1 else join(parts)

    def _go_on_into(self, block: Block, frames: int) -> Block:
        """Go on into the break of all after `block`; not where there is no solution to go on with."""
        time, names = self.simulation.time, self.simulation.layout.ropes
        why = self.simulation.failure or self._why(self.simulation)
        ropes = tuple(span.name for span in names)
        self.ends = (*self.ends, End(ropes, time, self._frames + block.frames, why))
        if block.status == UNSOLVED:
            return block
        self._events.append({"event": BROKE, "time": time, "diagnosis": why})
        rest = self.simulation.advance_frames(frames - block.frames, keep_going=True)
        return join([block, rest])

    def _end(self, frames: int) -> bool:
        """Note what broke after so many frames, and leave it behind; False where nothing is left."""
        simulation, falls = self.simulation, self.simulation.falls
        first, new = not self.ends, []
        for number, fall in enumerate(falls):
            alone = simulation.alone(fall.island)
            if alone is not simulation:
                _warm(alone)
            alone.reason = fall.why
            if fall.status == UNSOLVED:
                why = fall.why
            elif first and number == 0:
                why = self._why(alone)
            else:
                why = f"Broke after t = {simulation.time:.6g} s: {fall.why}."
            new.append(End(fall.ropes, simulation.time, frames, why))
            if first and number == 0 and fall.status != UNSOLVED:
                self.beyond = look_beyond(alone, simulation)
        self.ends = (*self.ends, *new)
        if not simulation.leave_behind():
            return False
        for end in new:
            self._watch.leave(end.ropes)
            about = {"ropes": list(end.ropes), "frames": end.frames, "diagnosis": end.why}
            self._events.append({"event": ROPE_BROKE, "time": end.time, **about})
        return True

    def _why(self, simulation: Simulation) -> str:
        """Have the break explained; whatever goes wrong with that, the run and its result stand."""
        here = simulation.state
        try:
            return self._explain(simulation)
        except Exception as error:
            simulation.restore(here)
            why = f"{type(error).__name__}: {error}".rstrip(": .")
            return f"{no_explanation(simulation)} Why could not be told ({why})."

    def take_events(self) -> list[Event]:
        """Return what has happened since this was last asked."""
        events, self._events = self._events, []
        return events

    def ending(self, status: str, frames: int) -> Event:
        """Return the last event of a run: how it ended ("ended" where something went on after a break)."""
        event = {"event": status, "time": self.simulation.time, "frames": frames}
        if status != BROKE:
            return event
        went_on = self._keep_going or any(end.frames < frames for end in self.ends)
        return event | ({"event": "ended"} if went_on else {"diagnosis": self.diagnosis})


def _warm(simulation: Simulation) -> None:
    """Have compiled, outside the clock, what moves a rope by itself that has moved abreast."""
    here = simulation.state
    with uncounted():
        simulation.advance_frames(0)
    simulation.restore(here)


def simulate_in_memory(
    scene: Scene | Model,
    *,
    keep_going: bool = False,
    progress: Progress | None = None,
    ledger: bool = True,
    explain: Explain = no_explanation,
    spare: Spare | None = None,
) -> Result:
    """Run a scene to its end or its break and return what it recorded, the initial frame included.

    `spare` has arrays that the run may work in.

    Raises SceneError when the scene cannot be planned, MemoryError when the frames do not fit.
    """
    simulation = Simulation(scene, ledger=ledger, apart=True, spare=spare)
    runner = Runner(simulation, keep_going, explain)
    plan = simulation.plan
    if spare is None:  # who makes many runs asks for no clock
        simulation.advance_frames(0)  # compiles, where it is not done yet, outside the clock
    begun = clock()
    blocks = [simulation.recording()]
    events: list[Event] = []
    done = 0
    while done < plan.frames and blocks[-1].status == OK:
        blocks.append(runner.advance(min(simulation.block_frames, plan.frames - done)))
        done += blocks[-1].frames
        events += runner.take_events()
        if progress is not None:
            progress(done, plan.frames, blocks[-1])
    status = BROKE if runner.diagnosis else FINISHED
    facts = Facts(
        plan,
        ledger,
        keep_going,
        status,
        runner.diagnosis,
        clock() - begun,
        provenance(plan, ledger, keep_going),
        (*events, runner.ending(status, done + 1)),
        simulation.step_counts,
        runner.ends,
    )
    names = tuple(q.name for q in recorded(simulation.layout, simulation.scene))
    source = Memory(blocks, names, ledger)
    return Result(simulation.scene, simulation.layout, source, facts, beyond=runner.beyond)
