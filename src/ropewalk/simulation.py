"""The host loop: a scene in motion, frame by frame."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import partial
from importlib import import_module
from typing import TYPE_CHECKING, Any, NamedTuple, cast

import numpy as np

from ropewalk import broken, unsolved
from ropewalk.block import Block
from ropewalk.build import Model, build
from ropewalk.build.links import has_links
from ropewalk.build.plan import divide
from ropewalk.core import arrays
from ropewalk.core.arrays import APPLIED, TENSION_ONLY, Floats, Ints, State
from ropewalk.core.status import BROKEN, OK, UNSOLVED
from ropewalk.crawl import Crawl
from ropewalk.drive import Driven, Goal
from ropewalk.drum import WinchHandle
from ropewalk.hand import AnchorHandle
from ropewalk.laws.ledger import gravity_energy
from ropewalk.methods import adaptive
from ropewalk.methods.adaptive import Walk
from ropewalk.methods.controller import BEGUN, END
from ropewalk.methods.loop import prepare, prepare_links
from ropewalk.methods.recording import ENERGIES, Recording, make_recording, record_frame
from ropewalk.methods.registry import METHODS
from ropewalk.methods.scratch import make_sums
from ropewalk.methods.verdict import HONEST, LAST, ZERO, energy_now
from ropewalk.methods.watch import begin_interval, watch
from ropewalk.motions.table import HAND
from ropewalk.scene import Scene
from ropewalk.slices import Edges, Slices
from ropewalk.start import set_first_reactions, started

if TYPE_CHECKING:
    from ropewalk.live.view import View

GRAVITY = ENERGIES.index("gravity")
_ROUNDING = 1e-12  # [1]
_VIEW = "ropewalk.live.view"  # a layer above this one, so it is looked up when it is needed
BLOCK_BYTES = 16_000_000  # positions and velocities of one block of frames
LONGEST_BLOCK = 2048  # frames


class Broken(RuntimeError):  # noqa: N818 - it is what happened, not a mistake
    """The simulation broke: a coordinate is not finite or a segment absurdly long."""


class Snapshot(NamedTuple):
    """All that a simulation needs to go on to the same bits."""

    state: State
    start: float  # [s] time at step 0 of the present step length
    dt: float  # [s]
    step: int
    motion_kinds: Ints  # (a,) which anchors have been taken in hand
    winch_drive: Floats  # (3, w) speed [m/s], start and stop [s] of the winches
    walk: Walk  # of the adaptive method
    clamp_turns: Floats  # (3, a, 3) direction, axis and turn of the clamps, see `arrays.Bending`


class Simulation(Driven):
    """A scene in motion.

    Either the caller owns the loop (`step`), or frames are taken as the scene plans them (`frames`).
    Positions are views, (nodes, 3) [m], of all ropes one after another (`layout` says where each is).
    """

    def __init__(self, scene: Scene | Model, *, ledger: bool = True) -> None:
        """Build the scene. With `ledger` the work of every law is added up in every step.

        Raises SceneError when the scene cannot be planned, or starts at rest and has no rest shape.
        """
        self.model = started(scene if isinstance(scene, Model) else build(scene))
        self.scene, self.layout, self.plan = self.model.scene, self.model.layout, self.model.plan
        system = self.model.system
        self._kinds = system.anchors.kind.copy()
        winches = system.winches
        self._drive = np.stack((winches.speed, winches.start, winches.stop))
        speed, start, stop = self._drive
        clamps = (system.bending.direction, system.bending.axis, system.bending.turn)
        self._turns = np.stack(clamps)
        directions, axes, turns = self._turns
        self._goals: dict[int, Goal] = {}
        self._due = 0.0
        self._first = None
        self.system = system._replace(
            bending=system.bending._replace(direction=directions, axis=axes, turn=turns),
            flags=system.flags.copy(),
            anchors=system.anchors._replace(kind=self._kinds),
            winches=winches._replace(speed=speed, start=start, stop=stop),
        )
        self._state: State = arrays.copy(self.model.state)
        self.ledger = ledger
        self._method = METHODS[self.plan.method]
        limited = self.scene.limiter is not None
        rigid = limited or has_links(self._state)
        self._tableau = self._method.coefficients(self.scene.run.spectral_radius, rigid)
        self._walk = adaptive.no_walk()
        if self.plan.tolerance is None or self.plan.longest is None:
            self._scratch = self._method.make_scratch(self._state)
        else:
            limits = self.plan.tolerance, self.plan.longest
            self._state, self._scratch = adaptive.adapt(self.system, self._state, *limits)
            self._walk = self._scratch.walk
        self.failure = ""  # set where an implicit method finds no solution of a step
        self.slices = Slices(self.layout.nodes, self._method.cost, self._method.fixed)
        self.crawl = Crawl(self.plan.tolerance, self.system.flags[TENSION_ONLY] == 1)
        self._winches = len(self.scene.winches) > 0
        self._extras = 1 if self._winches or (limited and not self._method.implicit) else None
        self._start, self._dt, self._step = 0.0, self.plan.dt, 0
        self._prepare()
        set_first_reactions(self.system, self._state)
        begin_interval(self.system, self._state, *self._looking(), 0.0)
        self._gravity_zero = 0.0
        self._gravity_zero = self._zero_of_gravity()
        self.reason = ""  # set by a break: what is broken, and where
        self._set_balance()
        self.anchors = {
            name: AnchorHandle(self, row) for row, name in enumerate(self.layout.anchor_names)
        }
        self.winches = {
            winch.name: WinchHandle(self, row) for row, winch in enumerate(self.scene.winches)
        }

    def _prepare(self) -> None:
        """Evaluate the forces at the state itself, tensions of rigid links included."""
        if self._method.implicit:
            prepare_links(self.system, self._state, self.time, self._scratch.stage.saddle)
        else:
            prepare(self.system, self._state)

    def _set_balance(self) -> None:
        """Write the energy at the start, from which gains count, and what of it may turn into motion."""
        balance = self._state.balance
        balance[ZERO] = balance[LAST] = energy_now(self.system, self._state)
        state = self._state
        weight = gravity_energy(state.x, state.mass, self.system.gravity)
        balance[HONEST] = balance[ZERO] - weight + self._energy_scale()

    def _energy_scale(self) -> float:
        """Weight times length of all ropes [J], and a little elastic energy where nothing weighs."""
        state = self._state
        weight = float(np.linalg.norm(self.system.gravity) * state.mass.sum())
        gives = np.isfinite(state.stiffness)
        elastic = 0.5 * state.stiffness * state.rest_length**2
        return weight * float(state.rest_length.sum()) + 1e-6 * float(elastic[gives].sum())

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
        taken = (
            self._kinds.copy(), self._drive.copy(), arrays.copy(self._walk), self._turns.copy()
        )  # fmt: skip
        return Snapshot(arrays.copy(self._state), self._start, self._dt, self._step, *taken)

    @property
    def step_counts(self) -> dict[str, float]:
        """Steps accepted and rejected so far, shortest and longest [s]; empty for fixed steps."""
        return adaptive.counts(self._walk)

    def restore(self, snapshot: Snapshot) -> None:
        """Go back (or forth) to a snapshot of this simulation; places still to go to are forgotten."""
        self._goals.clear()
        arrays.assign(self._state, snapshot.state)
        self._start, self._dt, self._step = snapshot.start, snapshot.dt, snapshot.step
        self._kinds[:], self._drive[:] = snapshot.motion_kinds, snapshot.winch_drive
        self._turns[:] = snapshot.clamp_turns
        arrays.assign(self._walk, snapshot.walk)
        self.system.flags[APPLIED] = int(self._state.forces.applied.any())

    def _looking(self) -> tuple[Floats, Floats]:
        """Return working space for a look at the state."""
        return np.zeros((2, self.layout.segments)), make_sums()

    def recording(self) -> Block:
        """Return the present state as one frame, extremes since the last call that moved it on included."""
        out = make_recording(self._state, 1, self._winches)
        watch(self.system, self._state, *self._looking(), self.time)
        record_frame(self.system, self._state, self.ledger, make_sums(), 0, out)
        out.energy[:, GRAVITY] -= self._gravity_zero
        return Block(np.array([self.time]), out)

    # -- moving on ----------------------------------------------------------------------

    def step(self, duration: float | None = None) -> None:
        """Advance by `duration` [s] (default: one frame), in equal steps no longer than the plan's.

        Raises Broken when the simulation breaks: the state is then the broken one, or that before
        the step, or the part of it, without solution; `time` is the state's. ValueError for a
        duration that is not positive and finite.
        """
        if duration is None or duration == self.plan.frame_interval:
            count, dt = self.plan.steps_per_frame, self.plan.dt
        else:
            if not (math.isfinite(duration) and duration > 0.0):
                raise ValueError(f"duration: {duration!r} - must be a positive number of seconds")
            count, dt = divide(duration, self.plan.dt, "divide")
        if dt != self._dt:
            self._start, self._dt, self._step = self.time, dt, 0
        self.failure = self.reason = ""
        self._set_off(count * dt)
        status, _ = self._advance(count, 1, make_recording(self._state, 0, False))
        if status != OK:
            text = f"the simulation broke before t = {self.time:g} s: {self.reason}"
            raise Broken(self.failure or text)
        self._arrive()

    def advance_steps(self, steps: int) -> int:
        """Advance by so many steps of the present length; return OK, or why not: the state is broken.

        `failure` then says where an implicit method found no solution; the state is that before.
        """
        self.failure = self.reason = ""
        self._set_off(steps * self._dt)
        status = self._advance(steps, 1, make_recording(self._state, 0, False))[0]
        self._arrive()
        return status

    def advance_frames(
        self, frames: int, *, keep_going: bool = False, out: Recording | None = None
    ) -> Block:
        """Advance by `frames` frames of the plan and return them, in buffers `out` of that length if given.

        When a frame is broken the block ends before it with status BROKEN, and the simulation stands at
        its last good frame; with `keep_going` it records on. It ends early where `slices.asked` says so.
        """
        if self._dt != self.plan.dt:  # after a step of another length
            self._start, self._dt, self._step = self.time, self.plan.dt, 0
        self._set_off(frames * self.plan.frame_interval)
        before = self.state if not keep_going else None
        self.failure = self.reason = ""
        out = out or make_recording(self._state, frames, self._winches)
        start, first = self._start, self._step
        status, good = self._advance(self.plan.steps_per_frame, frames, out, not keep_going)
        steps = first + self.plan.steps_per_frame * np.arange(1, frames + 1)
        block = Block(np.asarray(start + steps * self._dt, dtype=np.float64), out, status)
        if status == OK or (before is None and status == BROKEN):
            self._arrive()
            return block.head(good) if status == OK and good < frames else block
        if before is None:
            return block.head(good)
        self.restore(before)
        if good > 0:
            with self.slices.unasked():  # the state must come to the frames that are returned
                self._advance(self.plan.steps_per_frame, good, out.part(0, 0))
        return block.head(good)

    def frames(self, frames: int | None = None, *, keep_going: bool = False) -> Iterator[Block]:
        """Yield blocks of frames, `frames` in all (default: the rest of the plan), until one breaks.

        With `keep_going` they go on into the break.
        """
        left = self.frames_left if frames is None else frames
        while left > 0:
            block = self.advance_frames(min(left, self.block_frames), keep_going=keep_going)
            yield block
            if block.status != OK:
                return
            left -= block.frames

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
        clock = np.array([self._start, self._dt, self._step, steps, *edges], dtype=np.float64)
        common = (self.system, self._state, self._scratch, self._extras, clock, frames)
        fixed = self._method.fixed
        if not fixed:
            self._scratch.strides[0] = self.slices.most
        try:
            status, good = self._method.advance(*common, self.ledger, out, stop, self._tableau)
        finally:  # a signal's handler may raise as soon as the kernel is back
            self._step = int(clock[2])
        taken = steps * good if fixed else self.slices.most - int(self._scratch.strides[0])
        if not fixed:
            self.crawl.note(taken, float(self._walk.control[END]))
        if status == UNSOLVED:
            self.failure = unsolved.describe(self.model, self._state, self.clock, self._scratch)
            self._start, self._step = unsolved.standing(self.clock, self._scratch)
        if status == BROKEN:
            self.reason = broken.reason(self.system, self._state, self.layout)
        return status, good, taken

    # -- hands --------------------------------------------------------------------------

    def take_in_hand(self, row: int) -> None:
        """Let the anchor in a `row` be moved by its velocity from now on, whatever its motion was."""
        self._kinds[row] = HAND
        self._begin_anew()

    def turn_by_hand(self, row: int, speed: float) -> None:
        """Let the winch in a `row` turn at `speed` [m/s] from now on, whatever the scene told it."""
        self._drive[:, row] = speed, -math.inf, math.inf
        self._begin_anew()

    def _begin_anew(self) -> None:
        """Let the adaptive method walk on from the state that is shown."""
        self._walk.control[BEGUN:] = 0.0

    def view(self, *, open_browser: bool = True, port: int | None = None) -> View:
        """Show the simulation in the browser, or here in a notebook, and return the view.

        The loop stays with your program: call `view.update()` once a frame. Hands on the page can move
        anchors, pull and kick nodes. `open_browser` opens one at once (never in a notebook); `port` of the
        server is by default one that is free.

        Raises RunError when the packages of `ropewalk[view]` are missing, or the port is taken.
        """
        made = import_module(_VIEW).view_simulation(self, open_browser=open_browser, port=port)
        return cast("View", made)

    def __repr__(self) -> str:
        name = self.scene.name
        return (
            f"<Simulation of {name!r}: {self.layout.nodes} nodes at t = {self.time:.6g} s, "
            f"{self.plan.method}, {self.plan.pace}>"
        )


__all__ = ["BROKEN", "Broken", "Simulation", "Snapshot"]
