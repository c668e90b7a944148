"""An engine: one set of arrays that moves together, and all that its method needs."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from ropewalk.core import arrays
from ropewalk.core.addresses import handed
from ropewalk.core.arrays import BENDING, TENSION_ONLY, Floats, Ints, State, System, pooled
from ropewalk.core.elimination import tied_network
from ropewalk.core.network import Network
from ropewalk.core.status import BROKEN, HONEST, LAST, UNSOLVED, ZERO
from ropewalk.engine import broken, unsolved
from ropewalk.engine.crawl import Crawl, ends_of
from ropewalk.engine.met_before import is_as
from ropewalk.engine.slices import Slices
from ropewalk.engine.start import set_first_reactions
from ropewalk.engine.untying import suit_dampers
from ropewalk.laws.ledger import gravity_energy
from ropewalk.laws.winch import joined
from ropewalk.lowering import Model
from ropewalk.lowering.link_lengths import has_links
from ropewalk.methods import adaptive
from ropewalk.methods.adaptive import Walk
from ropewalk.methods.controller import (
    ACCEPTED,
    BEGUN,
    END,
    LONGEST,
    REJECTED,
    SHORTEST,
    make_control,
)
from ropewalk.methods.loop import prepare, prepare_links
from ropewalk.methods.recording import Recording
from ropewalk.methods.registry import METHODS
from ropewalk.methods.scratch import make_look
from ropewalk.methods.verdict import energy_now
from ropewalk.methods.watch import begin_interval

#: Tells whether to stop at the last whole frame.
Asked = Callable[[], bool]


def never() -> bool:
    """Do not stop."""
    return False


class Bodies(NamedTuple):
    """How obstacles move and turn: what hands change of `obstacle.Obstacles`."""

    kind: Ints  # (k,) of motion
    params: Floats  # (k, 16)
    turning: Ints  # (k,) kind of the motion that has the angle
    angles: Floats  # (k, 16) its parameters
    spin: Floats  # (k, 3) [rad/s], start and stop [s]


class Controls(NamedTuple):
    """What hands change in the tables of anchors, winches, clamps and obstacles."""

    kinds: Ints  # (a,) kinds of motion
    drive: Floats  # (3, w) speed [m/s], start and stop [s] of the winches
    turns: Floats  # (3, a, 3) direction, axis and turn of the clamps; (3, 0, 3) without any
    bodies: Bodies


class Fall(NamedTuple):
    """An island that broke, or found no solution."""

    island: int
    ropes: tuple[str, ...]
    status: int
    why: str  # what is broken, or where there is no solution


class Moved(NamedTuple):
    """How far a call has come."""

    status: int
    good: int  # frames
    taken: int  # steps, or tries of one
    falls: tuple[Fall, ...] = ()  # those that have ended the call

    @property
    def why(self) -> str:
        """What is broken, or where there is no solution."""
        return self.falls[0].why if self.falls else ""


def controls_of(system: System) -> Controls:
    """Return a copy of what hands can change."""
    winches, bending = system.winches, system.bending
    drive = np.stack((winches.speed, winches.start, winches.stop))
    turns = np.stack((bending.direction, bending.axis, bending.turn))
    bodies = arrays.copy(bodies_of(system))
    return Controls(system.anchors.kind.copy(), drive, turns, bodies)


def bodies_of(system: System) -> Bodies:
    """Return how obstacles move in some tables."""
    table = system.node.obstacle
    motion, turns = table.motion, table.turns
    return Bodies(motion.kind, motion.params, turns.kind, turns.params, table.spin)


def controlled(system: System, controls: Controls) -> System:
    """Return tables with these controls in them, and flags of their own."""
    speed, start, stop = controls.drive
    direction, axis, turn = controls.turns
    kind, params, turning, angles, spin = controls.bodies
    table = system.node.obstacle
    table = table._replace(
        motion=table.motion._replace(kind=kind, params=params),
        turns=table.turns._replace(kind=turning, params=angles),
        spin=spin,
        damping=table.damping.copy(),
    )
    return system._replace(
        node=system.node._replace(obstacle=table),
        bending=system.bending._replace(direction=direction, axis=axis, turn=turn),
        flags=system.flags.copy(),
        anchors=system.anchors._replace(kind=controls.kinds),
        winches=system.winches._replace(speed=speed, start=start, stop=stop),
    )


class Handed:
    """What an engine hands to its method's kernel."""

    def __init__(self, system: System, state: State, tableau: Any) -> None:
        self._common, self._kept, self._for = (system, state, tableau), tuple[Any, ...](), None

    def __reduce__(self) -> tuple[Any, ...]:
        """Let a copy have addresses of its own."""
        return type(self), self._common

    def of(self, scratch: Any) -> tuple[Any, ...]:
        """Return system, state, the working arrays that the engine has now, and coefficients."""
        if self._for is not scratch:
            system, state, tableau = self._common
            self._kept, self._for = handed(system, state, scratch), scratch
            named = hasattr(tableau, "_fields")
            self._kept += handed(tableau) if named else (tableau,)
        return self._kept


class Engine:
    """A model in motion by its plan's method. The clock is the caller's."""

    by_frames = False  # whether a call is of one frame at most

    def __init__(
        self,
        model: Model,
        controls: Controls,
        *,
        ledger: bool,
        room: tuple[State, Floats] | None = None,
    ) -> None:
        """Take up a started model; `room` is a state to fill, whose arrays lie in one, and that one."""
        self.model, self.ledger, self.controls = model, ledger, controls
        self.system = controlled(model.system, controls)
        self._method = METHODS[model.plan.method]
        plan, limited = model.plan, model.scene.limiter is not None
        rigid = limited or has_links(model.state)
        self._tableau = self._method.coefficients(model.scene.run.spectral_radius, rigid)
        after = model.scene.winches or (limited and not self._method.implicit)
        self._extras = None if self.system.rare is None else int(bool(after))
        self.state, here = own_state(model) if room is None else room
        self.walk = adaptive.no_walk()
        if plan.tolerance is None or plan.longest is None:
            self._scratch = self._method.make_scratch(self.system, self.state)
        else:
            limits = plan.tolerance, plan.longest
            self._scratch = adaptive.adapt(self.system, self.state, here, *limits)
            self.walk = self._scratch.walk
        self._tied: Ints | None = None
        self._tie()
        slack = bool(self.system.flags[TENSION_ONLY])
        self.crawl = Crawl(plan.tolerance, ends_of(model.scene, slack=slack))
        self.inner = np.zeros(0)  # nothing but the state, the controls and the walk
        self._handed = Handed(self.system, self.state, self._tableau)

    def _tie(self) -> None:
        """Find out anew what is coupled, where joints were cut or tied since."""
        tied = self._tied
        known = tied is not None and not (tied.size and (tied != self.state.tied).any())
        if known:
            return
        self._tied = self.state.tied.copy()
        suit_dampers(self.model, self.system.node.obstacle, self.state)
        if not self._method.implicit:
            return
        alive, bends = joined(self.system, self.state), bool(self.system.flags[BENDING])
        memory = self.state.memory
        groups = len(memory.slide.group) + len(memory.contact.pair)
        network = tied_network(self.system.joints, self._tied, alive, bends, groups)
        self._scratch = with_network(self._scratch, network)

    # -- the beginning -------------------------------------------------------------------

    def begin(self) -> None:
        """Evaluate forces and reactions at time zero, take a first look, and note the energy."""
        self.prepare(0.0)
        set_first_reactions(self.system, self.state)
        begin_interval(self.system, self.state, make_look(self.state), 0.0, self.ledger)
        self._set_balance()

    def prepare(self, time: float) -> None:
        """Evaluate the forces at the state itself, tensions of rigid links included."""
        self._tie()
        if self._method.implicit:
            prepare_links(self.system, self.state, time, self._scratch.stage.saddle)
        else:
            prepare(self.system, self.state)

    def count_errors(self, time: float) -> None:
        """Count errors of the energy, and extremes, from the present state of a `time` [s] on.

        As at the very start: that kernel is compiled already, and no other is for this alone.
        """
        begin_interval(self.system, self.state, make_look(self.state), time, self.ledger)

    def _set_balance(self) -> None:
        """Write the energy at the start, from which gains count, and what of it may turn into motion."""
        state, balance = self.state, self.state.balance
        balance[ZERO] = balance[LAST] = energy_now(self.system, state)
        height = gravity_energy(state.x, state.mass, self.system.gravity)
        height -= float((state.forces.applied * state.x).sum())
        balance[HONEST] = balance[ZERO] - height + self.energy_scale()

    def energy_scale(self) -> float:
        """Weight and constant forces times length of all ropes [J], and a little elastic energy without.

        The length is that of all in a row, hung up by an end: springs of no length have only its stretch.
        """
        state = self.state
        pull = float(np.linalg.norm(self.system.gravity) * state.mass.sum())
        pull += float(np.linalg.norm(state.forces.applied, axis=0).sum())
        gives = np.isfinite(state.stiffness) & (state.stiffness > 0.0)
        stiffness, own = state.stiffness[gives], state.rest_length[gives]
        length = float(state.rest_length.sum()) + pull * float((1.0 / stiffness).sum())
        return pull * length + 0.5e-6 * float((stiffness * own**2).sum())

    @property
    def scratch(self) -> Any:
        """What the method needs besides the state."""
        return self._scratch

    @property
    def tableau(self) -> Any:
        """The method's coefficients."""
        return self._tableau

    @property
    def kernel(self) -> Any:
        """The method's kernel."""
        return self._method.advance

    def is_plain(self) -> bool:
        """Tell whether springs, vector friction, weight, anchors and hands are all that ever acts."""
        alone = self.system.rare is None and self._extras is None
        by_scene = self.model.system.flags.any()  # a hand's force comes and goes
        return alone and self._method.fixed and not by_scene

    # -- moving on -----------------------------------------------------------------------

    def call(
        self,
        now: Floats,
        frames: int,
        most: int,
        out: Recording,
        stop: bool,
        asked: Asked = never,
    ) -> Moved:
        """Call the kernel once, for `frames` frames or, where steps vary, `most` tries of one.

        `now` holds start of the present step length [s], the step [s], steps since, steps per frame, and the
        edges of `slices.Edges`. It is brought forward with the state, whatever is raised. Nobody is asked:
        a call is short.
        """
        self._tie()
        system, state, scratch, tableau = self._handed.of(self._scratch)
        common = system, state, scratch, self._extras, now, frames, self.ledger
        fixed = self._method.fixed
        if not fixed:
            self._scratch.strides[0] = most
        status, good = self._method.advance(*common, out, stop, tableau)
        taken = int(now[3]) * good if fixed else most - int(self._scratch.strides[0])
        if not fixed:
            self.crawl.note(taken, float(self.walk.control[END]))
        return self.moved(status, good, taken, now)

    def moved(self, status: int, good: int, taken: int, now: Floats) -> Moved:
        """Return how far a call has come that ended so; bring the clock to where the state stands."""
        if status == UNSOLVED:
            clock = float(now[0]), float(now[1]), int(now[2])
            why = unsolved.describe(self.model, self.state, clock, self._scratch)
            now[0], now[2] = unsolved.standing(clock, self._scratch)
            return Moved(status, good, taken, self._fall(status, why))
        if status == BROKEN:
            model = self.model
            why = broken.reason(self.system, self.state, model.layout, model.scene, model.plan)
            return Moved(status, good, taken, self._fall(status, why))
        return Moved(status, good, taken)

    def _fall(self, status: int, why: str) -> tuple[Fall]:
        return (Fall(0, tuple(span.name for span in self.model.layout.ropes), status, why),)

    def island(self, number: int) -> Engine:
        """Return the engine of an island: all is one here."""
        return self

    def end(self, numbers: list[int]) -> bool:
        """End some islands where others go on, see `Islands.end`: here nothing would be left."""
        return False

    def show_peaks(self) -> None:
        """What was seen is in the state already."""

    def make_slices(self, ropes: int = 1) -> Slices:
        """Return how to cut long calls, which move so many such ropes."""
        return Slices(ropes * self.model.layout.nodes, self._method.cost, self._method.fixed)

    def restore(self, inner: Floats, walk: Walk) -> None:
        """Go back to a walk; the state is the caller's.

        Raises ValueError, with nothing changed, for that of a method of another kind.
        """
        if is_as(self.walk, walk):
            arrays.assign(self.walk, walk)
        else:
            self.begin_anew(None)

    def note_bodies(self) -> bool:
        """One engine evaluates anew whatever hands have changed: nothing to note."""
        return True

    def begin_anew(self, row: int | None) -> None:
        """Let the adaptive method walk on from the state that is shown, as anchor `row` was taken in hand.

        None: as an obstacle was.
        """
        self.walk.control[BEGUN:] = 0.0


def own_state(model: Model) -> tuple[State, Floats]:
    """Return what `pooled` does of a model's state, in arrays that the model does not have."""
    state, pool = pooled(model.state)
    return state._replace(peaks=arrays.copy(state.peaks)), pool


def with_network(scratch: Any, network: Network) -> Any:
    """Return the working arrays of a method that solves with another network in them."""
    saddle = scratch.stage.saddle._replace(network=network)
    stage = scratch.stage._replace(saddle=saddle)
    if hasattr(scratch, "solver"):
        return scratch._replace(stage=stage, solver=scratch.solver._replace(stage=stage))
    return scratch._replace(stage=stage)


def counts(walk: Walk) -> dict[str, float]:
    """Return how many steps were accepted and rejected, and the shortest and longest [s].

    `walk` is that of one engine, or those of several one after another; {} for steps of one length.
    """
    if not walk.control.size:
        return {}
    control = walk.control.reshape(-1, make_control().size)
    accepted = int(control[:, ACCEPTED].sum())
    return {
        "accepted": accepted,
        "rejected": int(control[:, REJECTED].sum()),
        "shortest": float(control[:, SHORTEST].min()) if accepted else 0.0,
        "longest": float(control[:, LONGEST].max()),
    }
