"""One simulation of a live session, with the scene that it is now and the hands on it."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from copy import copy
from typing import Any

import numpy as np

from ropewalk.core.arrays import Floats, Ints
from ropewalk.core.status import OK
from ropewalk.laws.ledger import wound_energy
from ropewalk.live import edits
from ropewalk.live.carry import carry_over
from ropewalk.live.changes import same
from ropewalk.live.ear import Ear
from ropewalk.live.edits import Edit
from ropewalk.live.energy_off import Balance, step_of, weigh
from ropewalk.live.gaps import Parted, gaps, located, unknown
from ropewalk.live.hands import CONTROL, Hands, held_around
from ropewalk.live.losses import driven_work, losses_and_gifts
from ropewalk.live.parameters import named, refusal
from ropewalk.live.saved import Saved
from ropewalk.live.seen import Interval
from ropewalk.live.touch import Rubbed
from ropewalk.live.wound_ropes import WHILE_WOUND, WOUND_FIXED, is_wound
from ropewalk.lowering import Plan, build, with_all_laws
from ropewalk.lowering.joint_tables import tied_with
from ropewalk.methods.partings import time_of_news
from ropewalk.methods.recording import Recording, bends
from ropewalk.record.body_energies import unaccounted, weight_turns
from ropewalk.scene import Scene, SceneError
from ropewalk.scene.faults import Fault
from ropewalk.simulation import Simulation
from ropewalk.simulation.block import Block
from ropewalk.statics import NoRest

# What would break the lengths of rigid links, or what they do not have.
RIGID_FIXED = {"spring_constant", "EA", "length", "segments", "tension_only"}
# Names of one and the same number.
ALIKE = ({"spring_constant", "EA"}, {"time_step", "steps_per_frame"})
WITH_LINKS = "while a rope of rigid links is in the scene"

on_drums = getattr(wound_energy, "py_func", wound_energy)  # a few numbers: not worth compiling


class Track:
    """A scene in motion that can be changed."""

    def __init__(self, scene: Scene, label: str = "", changes: Mapping[str, Any] | None = None):
        """Start a scene at time zero, its time step as it is planned now.

        Raises SceneError when it cannot be planned, or starts at rest and no rest is found.
        """
        try:
            simulation = Simulation(with_all_laws(build(scene, endless=True)))
        except NoRest as error:
            raise SceneError([Fault("run.start", scene.run.start, str(error))]) from None
        self._begin(simulation, label, changes or {})

    @classmethod
    def of(cls, simulation: Simulation) -> Track:
        """Return a track around a simulation that is there already."""
        made = cls.__new__(cls)
        made._begin(simulation, "as it is", {})
        return made

    def _begin(self, simulation: Simulation, label: str, changes: Mapping[str, Any]) -> None:
        scene = simulation.scene
        self.label, self.changes, self.given = label, dict(changes), False  # label given by hand
        self.shown, self.recorded = Interval(), Interval()  # since the last frame shown, recorded
        self._recorded_at = simulation.time
        self._watch(simulation)
        self.scene = edits.neutral(planned(scene, self.simulation.plan))
        self.hands = Hands()
        self.ear: Ear | None = None
        self.count, self.edited = 0, 0.0  # steps done, energy put in by changes [J]
        self.parted: tuple[Parted, ...] = ()  # what has parted until now
        self.first_energy = self.energy
        begin = simulation.recording().recording
        self.first_gravity = float(begin.energy[0, 1])  # [J]
        self.rubbed, self.balance = (
            Rubbed(simulation),
            Balance.begun(float(begin.energy[0, 2:].sum())),
        )
        self._first_works = self._works(begin)
        self.begun = self.save()  # when the present simulation began

    def _watch(self, simulation: Simulation) -> None:
        """Take a simulation for one's own."""
        self.simulation = simulation
        simulation.watchers = [self.shown, self.recorded]

    @property
    def energy(self) -> float:
        """Kinetic, gravity and elastic energy together [J], and what no law accounts for in bodies'."""
        return self._energy(self.simulation.recording().recording)

    def _energy(self, now: Recording) -> float:
        ropes = float(now.energy[0].sum())
        return ropes + (float(unaccounted(now.wheel[0])) if weight_turns(self.scene) else 0.0)

    def _gravity_zero(self) -> float:
        """Energy of gravity as it is counted, less that over the origin [J], what is on drums left out."""
        state, system = self.simulation.arrays, self.simulation.system
        counted = float(self.simulation.recording().recording.energy[0, 1]) - self._on_drums
        return counted + float((state.mass * (system.gravity @ state.x)).sum())

    @property
    def _on_drums(self) -> float:
        """Energy of what has gone on to drums [J], which is a part of the winches' work as well."""
        return float(on_drums(self.simulation.system, self.simulation.arrays))

    @property
    def dt(self) -> float:
        """Length of a step [s]."""
        return self.simulation.plan.dt

    def control_steps(self, speed: float = 1.0) -> int:
        """Return the steps between two updates of the hands, at a speed that is asked for."""
        return max(1, math.floor(CONTROL * self.hands.pace(speed) / self.dt + 1e-9))

    # -- moving on ----------------------------------------------------------------------

    def advance(self, steps: int, speed: float = 1.0) -> int:
        """Advance by so many steps; return OK, or BROKEN and the broken state."""
        every = self.control_steps(speed)
        while steps > 0:
            now = steps
            if self.hands.active:
                if self.hands.fresh or self.count % every == 0:
                    self.hands.update(self.simulation, every * self.dt, speed)
                now = min(steps, every - self.count % every)
            if self.ear is not None:
                now = min(now, self.ear.steps(self.dt))
            status = self.simulation.advance_steps(now)
            if status != OK:
                return status
            self.count += now
            steps -= now
            if self.ear is not None:
                self.ear.hear(self)
        return OK

    def follow(self, time: float, speed: float) -> int:
        """Advance up to a time [s] by whole steps, not beyond it."""
        steps = math.floor((time - self.simulation.time) / self.dt + 1e-6)
        return self.advance(steps, speed) if steps > 0 else OK

    def frame(self) -> Block:
        """Return the present state as a frame to record, and begin the next interval.

        The simulation knows what its last call has seen, the track what all have since the last frame.
        """
        block = self.simulation.recording()
        self.recorded.widen(
            block.recording, self.simulation.arrays, self._recorded_at, block.time[0]
        )
        self.recorded.begin()
        self._recorded_at = self.simulation.time
        return block

    # -- changing -----------------------------------------------------------------------

    def edit(self, change: Edit) -> None:
        """Go over into another scene without a jump. Raises SceneError."""
        before, zero = self.energy - self._on_drums, self._gravity_zero()
        plan = self.simulation.plan
        made = carry_over(self.simulation, change.scene, change.source, change.parted)
        self.hands.renumber(change.source)
        self._watch(made)
        self.scene = change.scene
        self.hands.targets = {
            name: target for name, target in self.hands.targets.items() if name in made.anchors
        }
        shift = self._gravity_zero() - zero  # gravity counts from the ropes' drawn shapes
        self.first_energy += shift
        self.first_gravity += shift
        self.edited += self.energy - self._on_drums - before - shift
        if step_of(made.plan) != step_of(plan):
            self.balance = self.balance.again()
        self._weigh()
        self.begun = self.save()

    def set(self, name: str, value: Any, rope: str | None = None) -> None:
        """Change a parameter. Raises SceneError with the allowed range."""
        parameter = named(name)
        ropes = [self.scene.ropes[i].name for i in parameter.ropes(self.scene, rope)]
        if name in WOUND_FIXED and any(is_wound(self.scene, one) for one in ropes):
            raise refusal(name, value, f"cannot be changed {WHILE_WOUND}")
        if name in RIGID_FIXED and any(one.rigid for one in self.scene.ropes):
            raise refusal(name, value, f"cannot be changed {WITH_LINKS}")
        if name == "time_step" and value == "auto":
            value = automatic_step(self.scene)
        scene = parameter.apply(self.scene, value, rope)
        if scene == self.scene:
            return
        if name == "ground" and value:
            scene = named("ground_height").apply(scene, self._floor())
        layout = edits.layout_of(scene)
        self.edit(Edit(scene, edits.matched(self.simulation.layout, layout)))

    def keeps(self, name: str) -> bool:
        """Tell whether a parameter is what this variant differs in, under this name or another."""
        return any(
            name in group for one in self.changes for group in (*ALIKE, {one}) if one in group
        )

    def keep_changes(self, before: Scene) -> None:
        """Set what this variant differs in as it was before a change of all that has changed that, too.

        A piece of a cut rope keeps its own part of it.
        """
        for name, value in self.changes.items():
            one = named(name)
            for i in one.ropes(before, None) if value != "auto" else ():
                was = one.get(before, i)
                if not same(was, one.get(self.scene, i)):
                    self.set(name, was, before.ropes[i].name if one.per_rope else None)

    def _floor(self) -> float:
        """Where a new ground may lie without pushing [m]: at zero, or a little below the rope."""
        heights = self.simulation.positions @ np.array(self.scene.up)
        size = float(np.ptp(self.simulation.positions, axis=0).max())
        low = float(heights.min())
        return 0.0 if low >= 0.0 else low - 0.1 * size

    def restructure(self, make: Callable[[Scene, Any], Edit]) -> str:
        """Pin, cut or load: `make` takes scene and layout. Return a note. Raises SceneError."""
        change = make(self.scene, self.simulation.layout)
        self.edit(change)
        return change.note

    def look(self) -> bool:
        """Note what has parted since the last look; tell whether there was anything."""
        if not self.scene.parts:
            return False
        found = unknown(gaps(self.simulation).values(), self.parted)
        layout, rest = self.simulation.layout, self.simulation.arrays.rest_length
        new = [located(one, self.scene, layout.span(one.rope), rest) for one in found]
        self.parted = (*self.parted, *sorted(new))
        return bool(new)

    def tear(self) -> bool:
        """Make two ropes of every one that has parted since; tell whether there was any.

        Where a rope cannot be cut in two, as one that a winch winds, what has parted stays a gap in it.
        """
        if not self.scene.parts:
            return False
        known = [j for j in self._parted() if self._is_old_news(j)]
        if not known:
            return False
        change = edits.cut_all(self.scene, self.simulation.layout, known)
        if change.scene is self.scene:
            return False
        self.edit(change)
        return True

    def _parted(self) -> list[int]:
        """Return the segments that have parted, as indices of the arrays."""
        parted = self.simulation.arrays.memory.parting.time
        return [int(j) for j in np.flatnonzero(np.isfinite(parted))]

    def _is_old_news(self, j: int) -> bool:
        """Tell whether all of the rope has heard of a parting: until then nothing else of it may part."""
        simulation = self.simulation
        span = simulation.layout.span(simulation.layout.rope_of(j)[0])
        since = simulation.time - float(simulation.arrays.memory.parting.time[j])
        passing = simulation.system.node.parting.passing
        last = span.last - 1
        return bool(since >= time_of_news(last - span.first, passing[last] - passing[span.first]))

    def kick(self, index: int, velocity: Floats) -> None:
        """Add a velocity [m/s] to a node and what a hand holds with it. Raises SceneError for a held one."""
        edits.at_node(self.simulation.layout, index)
        name = self.holder(index)
        if name is not None:
            raise refusal("node", index, f"is held by anchor {name!r}")
        nodes = self._held(index)
        self._give(nodes, self.simulation.arrays.v[:, nodes] + velocity[:, None])

    def throw(self, index: int, velocity: Floats) -> None:
        """Give what a hand holds the velocity [m/s] with which it lets go, unless an anchor holds it."""
        if self.holder(index) is None:
            self._give(self._held(index), velocity[:, None])

    def _held(self, index: int) -> Ints:
        """Return the nodes that a hand at a node holds, with those that are tied to them."""
        tied, joints = self.simulation.arrays.tied, self.simulation.system.joints
        nodes = held_around(self.simulation, index).tolist()
        return np.unique(np.concatenate([tied_with(joints, tied, node) for node in nodes]))

    def _give(self, nodes: Ints, velocities: Floats) -> None:
        before = self.energy
        self.simulation.arrays.v[:, nodes] = velocities
        self.simulation.arrays.past[0] = 0.0  # a multistep method begins anew
        self.simulation.push({})  # brings forces and accelerations up to date
        self.edited += self.energy - before
        self._weigh()

    def _weigh(self) -> None:
        """Count what a change has put in as turned over: much of it may be gone by the next frame."""
        weigh(self, self.simulation.recording().recording)

    def holder(self, index: int) -> str | None:
        """Return the name of the anchor that holds a node, or one that is tied to it, if one does."""
        state = self.simulation.arrays
        nodes = tied_with(self.simulation.system.joints, state.tied, index)
        for name, handle in self.simulation.anchors.items():
            row = self.simulation.layout.anchor_names.index(name)
            if handle.holds and state.anchor_node[row] in nodes:
                return name
        return None

    # -- books --------------------------------------------------------------------------

    def books(self, now: Recording) -> tuple[float, float, float]:
        """Return lost, put in, and the method's error [J], from what is recorded of the present frame."""
        works, before = self._works(now), self._first_works
        losses, gifts = works[0] - before[0], works[1] - before[1] + self.edited
        return -losses, gifts, self._energy(now) - self.first_energy - losses - gifts

    def _works(self, now: Recording) -> tuple[float, float]:
        """Return losses and gifts since the simulation began [J], from what is recorded of now."""
        simulation = self.simulation
        driven = driven_work(now.books[0, : len(self.scene.obstacles)], now.wheel[0])
        return losses_and_gifts(
            now.work[0], bends(simulation.arrays), simulation.layout.more, driven
        )

    def save(self) -> Saved:
        """Return everything, to `restore`."""
        return Saved(
            self.scene,
            self.simulation,
            self.simulation.state,
            self.hands.copy(),
            self.count,
            self.first_energy,
            self.edited,
            self.first_gravity,
            self.balance,
            (self.shown.kept, self.recorded.kept),
            self.label,
            dict(self.changes),
        )

    def restore(self, saved: Saved, *, undo: bool = False) -> None:
        """Go back to what was saved. Steps are counted on, unless these are to be as if not done."""
        self.scene = saved.scene
        self.label, self.changes = saved.label, dict(saved.changes)
        self._watch(saved.simulation)
        self.simulation.restore(saved.snapshot)
        self.hands = saved.hands.copy()
        if undo:
            self.count = saved.steps
            self.shown.kept, self.recorded.kept = saved.seen
        else:
            self.hands.fresh = True
            self.shown.begin()
            self.recorded.begin()
            self._recorded_at = self.simulation.time
        self.first_energy, self.edited = saved.first_energy, saved.edited
        self.first_gravity, self.balance = saved.first_gravity, saved.balance
        now, there = self.simulation.time, set(gaps(self.simulation).values())
        self.parted = tuple(  # one that was cut now may be undone now
            one for one in self.parted if one.parting.time < now or one.parting in there
        )

    def clone(self, label: str, changes: Mapping[str, Any]) -> Track:
        """Return a second track that stands where this one stands, with some parameters changed.

        Raises SceneError.
        """
        made = copy(self)
        made.label, made.changes, made.ear = label, dict(changes), None
        made.hands = self.hands.copy()
        made.hands.fresh = True
        made.shown, made.recorded, old = Interval(), Interval(), self.simulation
        made._watch(carry_over(old, self.scene, edits.same_nodes(old.layout)))
        for name, value in changes.items():
            made.set(name, value)
        return made


def planned(scene: Scene, plan: Plan) -> Scene:
    """Return the scene with its method by name and its time step as a number of seconds."""
    scene = scene.replace(run=scene.run.replace(method=plan.method))
    return named("time_step").apply(scene, plan.dt)


def automatic_step(scene: Scene) -> float:
    """Return the step that "auto" means for a scene now [s]. Raises SceneError."""
    run = scene.run.replace(time_step="auto", steps="divide")
    return build(scene.replace(run=run), endless=True).plan.dt
