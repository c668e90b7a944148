"""What a program that owns the loop drives and reads: anchors by pose, forces and tensions as arrays."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from ropewalk.core.arrays import APPLIED, Floats, Ints, State, System
from ropewalk.lowering.joint_tables import tied_with
from ropewalk.motions.registry import HAND

if TYPE_CHECKING:
    from ropewalk.engine.engine import Bodies, Engine, Fall
    from ropewalk.engine.islands import Islands
    from ropewalk.lowering import Layout, Model
    from ropewalk.simulation import Snapshot
    from ropewalk.simulation.block import Block

_ROUNDING = 1e-9  # [1] of the places: what lies this near to a goal has reached it
_OPPOSITE = 1e-9  # [rad] from the opposite direction: no way round is the shortest


@dataclass
class Goal:
    """Where an anchor is to be at the end of the next step."""

    position: Floats | None = None  # (3,) [m]
    direction: Floats | None = None  # (3,) unit vector of the clamp
    way: float = 0.0  # [m] along the axis on which it is farthest, when it sets off


class Driven:
    """The part of a Simulation that a robot's program drives."""

    model: Model
    layout: Layout
    ledger: bool
    apart: bool
    system: System
    _state: State
    _engine: Engine | Islands
    _kinds: Ints
    _drive: Floats
    _bodies: Bodies
    _goals: dict[int, Goal]
    _due: float  # [s] time at which the goals are reached
    _first: Snapshot | None  # the beginning, once `reset` was asked for
    failure: str
    reason: str
    falls: tuple[Fall, ...]

    if TYPE_CHECKING:

        def __init__(self, scene: Model, *, ledger: bool = True, apart: bool = False) -> None: ...
        def _forget_break(self) -> None: ...
        @property
        def time(self) -> float: ...
        @property
        def state(self) -> Snapshot: ...
        def restore(self, snapshot: Snapshot) -> None: ...
        def recording(self) -> Block: ...
        def _begin_anew(self, row: int | None) -> None: ...
        def _prepare(self) -> None: ...

    # -- again ---------------------------------------------------------------------------

    def reset(self) -> None:
        """Go back to time zero, to the same bits as a new simulation of the scene."""
        if self._first is None:
            made = type(self)(self.model, ledger=self.ledger, apart=self.apart)
            self._first = made.state
        self.restore(self._first)
        self._forget_break()

    def count_errors(self) -> None:
        """Count errors of the energy, and extremes, from the present state on."""
        self._engine.count_errors(self.time)

    @property
    def bodies(self) -> Bodies:
        """How obstacles move now; see `hands.body`."""
        return self._bodies

    def set_off_bodies(self) -> None:
        """Take up what a hand has changed in `bodies`."""
        self._state.past[0] = 0.0  # a multistep method begins anew
        self._prepare()
        self._begin_anew(None)

    def __reduce__(self) -> tuple[Any, ...]:
        """Let a copy be a simulation of its own that stands where this one does; nobody watches it."""
        goals = {row: replace(goal) for row, goal in self._goals.items()}
        said = {"failure": self.failure, "reason": self.reason, "falls": self.falls}
        own = {"_goals": goals, "_due": self._due, **said}
        return _again, (type(self), self.model, self.ledger, self.apart, self.state, own)

    # -- forces --------------------------------------------------------------------------

    @property
    def tension(self) -> Floats:
        """Tension that the rope carries along each segment now [N], (segments,), as a result has it."""
        return np.array(self.recording().recording.tension[0])

    @property
    def reactions(self) -> Floats:
        """Force of each anchor on the rope [N], (anchors, 3), a copy.

        Mean over the last of the equal steps that a call of `step` takes, not over the call.
        """
        return np.array(self._state.reaction)

    @property
    def applied_forces(self) -> Floats:
        """Forces applied to all nodes on top of the scene's own [N], (nodes, 3), a copy.

        Set it to apply others from now on, to all nodes at once, in the order of `positions`.

        Raises ValueError when it is set to anything but finite numbers of that shape.
        """
        return np.array((self._state.forces.applied - self.model.state.forces.applied).T)

    @applied_forces.setter
    def applied_forces(self, forces: ArrayLike) -> None:
        array = np.asarray(forces, dtype=np.float64)
        shape = (self.layout.nodes, 3)
        if array.shape != shape:
            raise ValueError(f"applied_forces: an array {array.shape} - must be {shape}, in N")
        if not np.isfinite(array).all():
            node = int(np.argmin(np.isfinite(array).all(axis=1)))
            raise ValueError(f"applied_forces[{node}]: {array[node]} - must be finite numbers [N]")
        applied = self._state.forces.applied
        applied[...] = self.model.state.forces.applied + array.T
        self.system.flags[APPLIED] = int(applied.any())
        self._prepare()

    def apply_force(self, node: int, force: ArrayLike, rope: str | None = None) -> None:
        """Apply a force [N], (3,), to a node from now on, in place of the one applied before.

        Raises KeyError and IndexError for the rope and the node, ValueError for the force.
        """
        vector = np.asarray(force, dtype=np.float64)
        if vector.shape != (3,) or not np.isfinite(vector).all():
            raise ValueError(f"force: {force!r} - must be three finite numbers [N]")
        self.push({self.layout.node(node, rope): vector})

    def push(self, forces: Mapping[int, Floats]) -> None:
        """Apply forces [N], each (3,), to nodes by their index in the arrays, as `apply_force` does.

        They come on top of the scene's own.
        """
        applied, given = self._state.forces.applied, self.model.state.forces.applied
        for index, vector in forces.items():
            applied[:, index] = given[:, index] + vector
        self.system.flags[APPLIED] = int(applied.any())
        self._prepare()

    # -- anchors, winches and clamps -----------------------------------------------------

    def take_in_hand(self, row: int) -> None:
        """Let the anchor in a `row` be moved by its velocity from now on, whatever its motion was."""
        self._kinds[row] = HAND
        self._begin_anew(row)

    def turn_by_hand(self, row: int, speed: float) -> None:
        """Let the winch in a `row` turn at `speed` [m/s] from now on, whatever the scene told it."""
        self._drive[:, row] = speed, -math.inf, math.inf
        self._begin_anew(int(self.system.winches.anchor[row]))

    def set_goal(
        self, row: int, *, position: Floats | None = None, direction: Floats | None = None
    ) -> None:
        """Let the anchor in a `row` be at a `position` [m] or a clamp at a `direction` [1], (3,), next."""
        goal = self._goals.setdefault(row, Goal())
        goal.position = goal.position if position is None else position
        goal.direction = goal.direction if direction is None else direction

    def forget_position(self, row: int) -> None:
        """Forget where the anchor in a `row` was to be."""
        if row in self._goals:
            self._goals[row].position = None

    def turn_clamp(self, row: int, spin: Floats) -> None:
        """Turn the clamp in a `row` by its angular velocity `spin` [rad/s], (3,), from now on."""
        if row in self._goals:
            self._goals[row].direction = None
        rate = float(np.linalg.norm(spin))
        self._state.clamp_direction[row] /= np.linalg.norm(self._state.clamp_direction[row])
        self._turn(row, spin / rate if rate > 0.0 else np.array([0.0, 0.0, 1.0]), rate)

    def clamp_spin(self, row: int) -> Floats:
        """Return the angular velocity of the clamp in a `row` now [rad/s], (3,)."""
        rate, start, stop = self.system.bending.turn[row]
        turns = start <= self.time < stop
        return np.array(self.system.bending.axis[row] * (rate if turns else 0.0))

    def _turn(self, row: int, axis: Floats, rate: float) -> None:
        """Let a clamp turn about a unit vector from where it is now on."""
        bending = self.system.bending
        bending.direction[row] = self._state.clamp_direction[row]
        bending.axis[row] = axis
        bending.turn[row] = rate, self.time, math.inf
        self._state.clamp_spin[row] = rate * axis
        self._prepare()  # the next step begins with this spin
        self._begin_anew(row)

    def _set_off(self, duration: float) -> None:
        """Give what is to be somewhere in `duration` [s] the velocity that leads there."""
        self._due = self.time + duration
        for row, goal in self._goals.items():
            if not self._state.held[row]:
                continue
            if goal.position is not None:
                self.take_in_hand(row)
                way = goal.position - self._state.anchor_x[row]
                self._state.anchor_v[row] = way / duration
                goal.way = float(np.abs(way).max())
            if goal.direction is not None:
                axis, angle = shortest_turn(self._state.clamp_direction[row], goal.direction)
                self._turn(row, axis, angle / duration)

    def _arrive(self) -> None:
        """Let what has reached its goal rest there, to the last bit."""
        if not self._goals or self.time < self._due - _ROUNDING * max(abs(self._due), 1e-3):
            return
        state = self._state
        for row, goal in self._goals.items():
            if not state.held[row]:
                continue
            place = goal.position
            if place is not None:
                state.anchor_v[row] = 0.0
                size = max(goal.way, float(np.abs([place, state.anchor_x[row]]).max()))
                little = _ROUNDING * size
                if np.abs(state.anchor_x[row] - place).max() <= little:  # not held up by the ground
                    nodes = tied_with(self.system.joints, state.tied, int(state.anchor_node[row]))
                    state.anchor_x[row] = place
                    state.x[:, nodes] = place[:, None]
            if goal.direction is not None:
                state.clamp_direction[row] = goal.direction
                self._turn(row, self.system.bending.axis[row].copy(), 0.0)
            self._begin_anew(row)
        self._goals.clear()


def _again(
    kind: type[Driven],
    model: Model,
    ledger: bool,
    apart: bool,
    state: Snapshot,
    own: dict[str, Any],
) -> Driven:
    """Return a simulation of a model in a state, with what `own` says of it."""
    made = kind(model, ledger=ledger, apart=apart)
    made.restore(state)
    vars(made).update(own)
    return made


def shortest_turn(old: Floats, new: Floats) -> tuple[Floats, float]:
    """Return axis [1], (3,), and angle [rad] of the shortest turn from one unit vector to another.

    Raises ValueError for opposite ones.
    """
    cross = np.cross(old, new)
    sine, cosine = float(np.linalg.norm(cross)), float(np.dot(old, new))
    angle = math.atan2(sine, cosine)
    if angle > math.pi - _OPPOSITE:
        rule = (
            "is opposite to where the clamp points: go there in two steps, to say which way round"
        )
        raise ValueError(f"direction: {new} - {rule}")
    axis = cross / sine if sine > 0.0 else np.array([0.0, 0.0, 1.0])
    return axis, angle
