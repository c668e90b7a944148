"""The host loop: a scene in motion, frame by frame."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from functools import partial
from importlib import import_module
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from ropewalk.core import arrays
from ropewalk.core.arrays import APPLIED, Floats, State
from ropewalk.core.status import BROKEN, OK, UNSOLVED
from ropewalk.engine.beginning import make_engine
from ropewalk.engine.engine import Fall, counts
from ropewalk.engine.slices import Edges
from ropewalk.engine.spare import Spare
from ropewalk.hands.body import handles
from ropewalk.hands.drive import Driven, Goal
from ropewalk.hands.drum import WinchHandle
from ropewalk.hands.hand import AnchorHandle
from ropewalk.lowering import Model, build
from ropewalk.lowering.contact_checks import refuse_untying
from ropewalk.lowering.plan import divide
from ropewalk.methods.recording import ENERGIES, Recording, make_recording, record_frame
from ropewalk.methods.registry import METHODS
from ropewalk.methods.scratch import make_look
from ropewalk.methods.watch import look_now
from ropewalk.scene import Scene
from ropewalk.simulation.block import Block, make_frames, refuse_unless_count
from ropewalk.simulation.far_apart import FarApart
from ropewalk.simulation.rope_contacts import touched
from ropewalk.simulation.snapshot import Snapshot
from ropewalk.simulation.watcher import Watcher
from ropewalk.words.annotations import unquoted
from ropewalk.words.named import Named

if TYPE_CHECKING:
    from ropewalk.live.view import View

GRAVITY = ENERGIES.index("gravity")
_ROUNDING = 1e-12  # [1]
_VIEW = "ropewalk.live.view"  # a layer above this one, so it is looked up when it is needed
BLOCK_BYTES = 16_000_000  # positions and velocities of one block of frames
LONGEST_BLOCK = 2048  # frames

#: What a Simulation offers to those who step it; `dir` shows these alone.
PUBLIC = (
    "advance_frames", "advance_steps", "anchors", "applied_forces", "apply_force", "cut_joint", "failure",
    "frames", "layout", "ledger", "obstacles", "plan", "positions", "reactions", "reason", "reset",
    "restore", "scene", "state", "step", "step_counts", "tension", "time", "velocities", "view", "winches",
)  # fmt: skip


class Broken(RuntimeError):  # noqa: N818 - it is what happened, not a mistake
    """The simulation broke: a coordinate is not finite or a segment absurdly long."""


@unquoted
class Simulation(Driven):
    """A scene in motion.

    Either the caller owns the loop (`step`), or frames are taken as the scene plans them (`frames`).
    Positions are views, (nodes, 3) [m], of all ropes one after another (`layout` says where each is).
    """

    def __init__(
        self,
        scene: Scene | Model,
        *,
        ledger: bool = True,
        apart: bool = False,
        spare: Spare | None = None,
    ) -> None:
        """Build the scene. With `ledger` the work of every law is added up in every step.

        With `apart`, as in a run, ropes break one by one in all methods, and steps suit the scene's duration,
        else whatever moves later, too. The state lies in `spare` where it fits: what had it cannot go on.

        Raises SceneError when the scene cannot be planned, or starts at rest and has no rest shape.
        """
        model = scene if isinstance(scene, Model) else build(scene, endless=not apart)
        self._engine, self.apart = make_engine(model, ledger, apart, spare), apart
        self.model = self._engine.model
        self.scene, self.layout, self.plan = self.model.scene, self.model.layout, self.model.plan
        self.system, self._state = self._engine.system, self._engine.state
        self._kinds, self._drive, self._turns, self._bodies = self._engine.controls
        self._goals: dict[int, Goal] = {}
        self._due, self._first = 0.0, None
        self._by_frames = self.scene.contact is not None or self._engine.by_frames
        self.ledger = ledger
        self.failure = ""  # set where an implicit method finds no solution of a step
        self.reason = ""  # set by a break: what is broken, and where
        self.falls: tuple[Fall, ...] = ()  # the islands that have ended the last call
        self.watchers: list[Watcher] = []
        self.slices, self._far = self._engine.make_slices(), FarApart(self._engine)
        self._lengths = self.scene.lengths_change
        self._start, self._dt, self._step = 0.0, self.plan.dt, 0
        self._engine.begin()
        self._gravity_zero = 0.0
        self._gravity_zero = self._zero_of_gravity()
        anchors, winches = self.layout.anchor_names, self.scene.winches
        self.anchors = Named(
            "anchor", {name: AnchorHandle(self, i) for i, name in enumerate(anchors)}
        )
        self.winches = Named(
            "winch", {one.name: WinchHandle(self, i) for i, one in enumerate(winches)}
        )
        self.obstacles = Named("obstacle", handles(self))

    def __dir__(self) -> list[str]:
        """What completion shows: not what recorders and pages use besides."""
        return list(PUBLIC)

    def _prepare(self) -> None:
        self._engine.prepare(self.time)

    def _zero_of_gravity(self) -> float:
        """Gravity's potential in the scene's own shape [J]: exactly the start's, where that is it."""
        first = float(self.recording().recording.energy[0, GRAVITY])
        state, zero = self._state, self.model.gravity_zero
        size = float((np.abs(self.system.gravity) @ (np.abs(state.x) * state.mass)).sum())
        return first if abs(first - zero) <= _ROUNDING * size else zero

    # -- what it is now -----------------------------------------------------------------

    @property
    def time(self) -> float:
        """Simulated time [s]: start + step * dt, never a running sum."""
        return self._start + self._step * self._dt

    @property
    def clock(self) -> tuple[float, float, int]:
        """Start of the present step length [s], the step [s], and steps since: what `time` is made of."""
        return self._start, self._dt, self._step

    @property
    def positions(self) -> Floats:
        """Positions of all nodes [m], (nodes, 3), a view."""
        return self._state.x.T

    @property
    def velocities(self) -> Floats:
        """Velocities of all nodes [m/s], (nodes, 3), a view."""
        return self._state.v.T

    @property
    def arrays(self) -> State:
        """The live state arrays; see `core.arrays.State`."""
        return self._state

    @property
    def state(self) -> Snapshot:
        """A copy of everything that evolves; `restore` goes back to it, to the same bits."""
        return self._shown(arrays.copy)

    def _shown(self, taken: Callable[[Any], Any]) -> Snapshot:
        own = (self._kinds, self._drive, self._engine.walk, self._turns, self._bodies)
        parts = map(taken, (self._state, *self.clock, *own))
        return Snapshot._make((*parts, self._engine.inner, self.layout.mark))

    @property
    def step_counts(self) -> dict[str, float]:
        """Steps accepted and rejected so far, shortest and longest [s]; empty for fixed steps."""
        return counts(self._engine.walk)

    def restore(self, snapshot: Snapshot) -> None:
        """Go to a snapshot of this simulation; goals are forgotten. ValueError for one of another scene."""
        snapshot = snapshot.fitting(self._shown(lambda part: part), self._by_frames)
        self._engine.restore(snapshot.inner, snapshot.walk)  # raises before anything has changed
        self._goals.clear()
        arrays.assign(self._state, snapshot.state)
        self._start, self._dt, self._step = snapshot.start, snapshot.dt, snapshot.step
        self._kinds[:], self._drive[:] = snapshot.motion_kinds, snapshot.winch_drive
        self._turns[:] = snapshot.clamp_turns
        arrays.assign(self._bodies, snapshot.bodies)
        self._engine.note_bodies()
        self.system.flags[APPLIED] = int(self._state.forces.applied.any())

    def recording(self) -> Block:
        """Return the present state as one frame, extremes since the last call that moved it on included."""
        out, look = make_recording(self._state, 1, self._lengths), make_look(self._state)
        self._engine.show_peaks()
        look_now(self.system, self._state, look, self.time)
        record_frame(self.system, self._state, self.ledger, look, 0, out)
        out.energy[:, GRAVITY] -= self._gravity_zero
        return Block(np.array([self.time]), out, OK, *touched(self.system, self._state, out, 1))

    # -- moving on ----------------------------------------------------------------------

    def step(self, duration: float | None = None) -> None:
        """Advance by `duration` [s] (default: one frame), in equal steps no longer than the plan's.

        Raises Broken when the simulation breaks: the state is then the broken one, or that before
        the step, or the part of it, without solution; `time` is the state's. ValueError for a
        duration that is not positive and finite.
        """
        if duration is None or (duration := float(duration)) == self.plan.frame_interval:
            count, dt = self.plan.steps_per_frame, self.plan.dt
        else:
            if not (math.isfinite(duration) and duration > 0.0):
                raise ValueError(f"duration: {duration!r} - must be a positive number of seconds")
            count, dt = divide(duration, self.plan.dt, "divide")
        if dt != self._dt:
            self._start, self._dt, self._step = self.time, dt, 0
        self._forget_break()
        self._set_off(count * dt)
        status, _ = self._advance(count, 1, make_recording(self._state, 0, False))
        if status != OK:
            more = "" if METHODS[self.plan.method].implicit else "; check tells stable steps"
            text = f"the simulation broke before t = {self.time:g} s: {self.reason}{more}"
            raise Broken(self.failure or text)
        self._arrive()
        self._tell()

    def advance_steps(self, steps: int) -> int:
        """Advance by so many steps of the present length; return OK, or why not: the state is broken.

        `failure` then says where an implicit method found no solution; the state is that before.
        """
        refuse_unless_count("steps", steps)
        self._forget_break()
        if steps == 0:
            return OK
        self._set_off(steps * self._dt)
        status = self._advance(steps, 1, make_recording(self._state, 0, False))[0]
        self._arrive()
        if status == OK:
            self._tell()
        return status

    def _tell(self) -> None:
        """Tell whoever watches of the extremes of a call."""
        if self.watchers:
            self._engine.show_peaks()
            for watcher in self.watchers:
                watcher.take(self._state.peaks)

    def advance_frames(
        self, frames: int, *, keep_going: bool = False, out: Recording | None = None
    ) -> Block:
        """Advance by `frames` frames of the plan and return them, in buffers `out` of that length if given.

        When a frame is broken the block ends before it with status BROKEN, and the simulation stands at
        its last good frame; with `keep_going` it records on. It ends early where `slices.asked` says so.
        """
        out = out or make_frames(self._state, frames, self._lengths)
        if self._dt != self.plan.dt:  # after a step of another length
            self._start, self._dt, self._step = self.time, self.plan.dt, 0
        if frames > 1 and self._by_frames:
            return self._far.advance(self, frames, out, keep_going)
        if frames:  # none lead nowhere: goals stay
            self._set_off(frames * self.plan.frame_interval)
        before = None if keep_going or not frames else self.state
        self._forget_break()
        block, good = self._block(frames, out, not keep_going)
        status = block.status
        if status == OK or (before is None and status == BROKEN):
            if frames:
                self._arrive()
            return self._told(block.head(good) if status == OK and good < frames else block)
        if before is None:
            return self._told(block.head(good))
        self.restore(before)
        if good > 0:
            with self.slices.unasked():  # the state must come to the frames that are returned
                self._advance(self.plan.steps_per_frame, good, out.part(0, 0))
        return self._told(block.head(good))

    def _block(self, frames: int, out: Recording, stop: bool) -> tuple[Block, int]:
        """Advance by `frames` frames; return all, and how many are good."""
        start, first = self._start, self._step
        status, good = self._advance(self.plan.steps_per_frame, frames, out, stop)
        steps = first + self.plan.steps_per_frame * np.arange(1, frames + 1)
        times = np.asarray(start + steps * self._dt, dtype=np.float64)
        return Block(times, out, status, *touched(self.system, self._state, out, frames)), good

    def _told(self, block: Block) -> Block:
        """Tell whoever watches of frames, and return them."""
        for watcher in self.watchers if block.frames else ():
            watcher.take_frames(block.recording)
        return block

    def frames(self, frames: int | None = None, *, keep_going: bool = False) -> Iterator[Block]:
        """Yield blocks of frames, `frames` in all (default: the rest of the plan), until one breaks.

        With `keep_going` they go on into the break. Raises ValueError for what is no whole number from 0 on.
        """
        left, status = self.frames_left if frames is None else frames, OK
        refuse_unless_count("frames", left)
        while left > 0 and status == OK:
            block = self.advance_frames(min(left, self.block_frames), keep_going=keep_going)
            yield block
            left, status = left - block.frames, block.status

    @property
    def frames_left(self) -> int:
        """Frames that lead from now to the end of the plan, or beyond it by part of a frame."""
        left = (self.plan.duration - self.time) / self.plan.frame_interval
        return max(0, math.ceil(left * (1.0 - 1e-12) - 1e-6))

    @property
    def block_frames(self) -> int:
        """Frames in one block: about 16 MB of positions and velocities, which get large pages."""
        return max(1, min(LONGEST_BLOCK, BLOCK_BYTES // (48 * self.layout.nodes)))

    def _advance(self, steps: int, frames: int, out: Any, stop: bool = True) -> tuple[int, int]:
        """Advance frames of so many steps, in slices; return the status and the number of good frames.

        Fewer than `frames` with status OK: `slices.asked` said so.
        """
        found = self.slices.run(
            self._call, lambda: partial(self.restore, self.state), steps, frames, out, stop
        )
        out.energy[:, GRAVITY] -= self._gravity_zero
        return found

    def _call(
        self, steps: int, frames: int, out: Recording, stop: bool, edges: Edges
    ) -> tuple[int, int, int]:
        """Call the kernel once; return its status, the number of good frames and the steps taken."""
        now = np.array([self._start, self._dt, self._step, steps, *edges], dtype=np.float64)
        asked = self.slices.is_asked
        try:
            moved = self._engine.call(now, frames, self.slices.most, out, stop, asked)
        finally:  # a signal's handler may raise as soon as the kernel is back
            self._start, self._step = float(now[0]), int(now[2])
        self.falls = moved.falls or self.falls
        if moved.status == UNSOLVED:
            self.failure = moved.why
        elif moved.status == BROKEN:
            self.reason = moved.why
        return moved.status, moved.good, moved.taken

    def _forget_break(self) -> None:
        self.failure, self.reason, self.falls = "", "", ()

    def leave_behind(self) -> bool:
        """Let the islands that have ended the last call stay as they are, where others can go on.

        Of their frames all but places and sums is NaN from now on. Return False where none is left to go on.
        """
        return self._engine.end([fall.island for fall in self.falls])

    def alone(self, island: int) -> Simulation:
        """Return a simulation of nothing but an island, as it is now; this one where all is one island."""
        engine = self._engine.island(island)
        if engine is self._engine:
            return self
        found = Simulation(engine.model, ledger=self.ledger)
        kinds, drive, turns, bodies = engine.controls
        state, walk = engine.state, engine.walk
        inner = np.zeros(0)  # all in one, as they are here
        found.restore(Snapshot(state, *self.clock, kinds, drive, walk, turns, bodies, inner))
        return found

    # -- hands --------------------------------------------------------------------------

    def cut_joint(self, name: str) -> None:
        """Let the nodes of the joint called `name` go their own ways from now on.

        Raises KeyError where there is none of that name, SceneError where ropes touch each other.
        """
        refuse_untying(self.scene)
        joints, state, scene = self.system.joints, self._state, self.scene
        j = scene.joints.index(scene.joint_named(name))
        member = joints.member[joints.first[j] : joints.first[j + 1]]
        state.tied[j], state.past[0] = 0, 0.0
        held = state.anchor_node[state.held == 1]
        state.inverse_mass[member] = 1.0 / state.mass[member]
        state.inverse_mass[held] = 0.0
        self._prepare()

    def _begin_anew(self, row: int | None) -> None:
        """Let the adaptive method walk on from the state that is shown, where anchor `row` holds a rope.

        None: wherever an obstacle may be touched.
        """
        self._engine.begin_anew(row)

    def view(self, *, open_browser: bool = True, port: int | None = None) -> View:
        """Show the simulation in the browser, or here in a notebook, and return the view.

        The loop stays with your program: call `view.update()` once a frame. Hands on the page can move
        anchors, pull and kick nodes. `open_browser` opens one at once (never in a notebook); `port` of the
        server is by default one that is free.

        Raises RunError when the packages of `ropewalk[view]` are missing, or the port is taken.
        """
        show = import_module(_VIEW).view_simulation
        return cast("View", show(self, open_browser=open_browser, port=port))

    def __repr__(self) -> str:
        about = f"{self.layout.nodes} nodes at t = {self.time:.6g} s"
        return f"<Simulation of {self.scene.name!r}: {about}, {self.plan.method}, {self.plan.pace}>"


__all__ = ["BROKEN", "Broken", "Simulation", "Snapshot"]
