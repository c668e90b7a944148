"""Obstacles as live objects: read where they are, move and turn them by hand.

A hand gives a body a velocity, or a rate about its axis, from now on or for a while: a motion as a scene may
have it, in place of the scene's own. So contacts see the velocity of its surface, and what it gives to
ropes is booked as that of any obstacle that moves.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from ropewalk.core.arrays import Floats
from ropewalk.hands.ahead import rate_ahead, speed_ahead
from ropewalk.hands.hand import three
from ropewalk.laws.obstacle_places import reach_of
from ropewalk.lowering.obstacle_checks import radius_with_rope, thin_along
from ropewalk.motions.kind import ORIGIN
from ropewalk.motions.registry import CODES
from ropewalk.motions.velocity import INTERVAL, WAY
from ropewalk.motions.whereabouts import place_now
from ropewalk.scene.obstacles import has_mass, is_free, name_of
from ropewalk.words.annotations import unquoted
from ropewalk.words.safe_side import rounded_down

if TYPE_CHECKING:
    from ropewalk.laws.obstacle import Obstacles
    from ropewalk.scene.obstacles import Obstacle
    from ropewalk.simulation import Simulation

_VELOCITY = CODES["velocity"]
_LATE = 1e-13  # [1] of the time
_EVEN = (
    1e-9  # [1] of a step: what is no more than this beyond a whole number of steps is that number
)


@unquoted
class ObstacleHandle:
    """One obstacle of a running simulation."""

    __slots__ = ("_row", "_simulation")  # so that a slip of a name is refused

    def __init__(self, simulation: Simulation, row: int) -> None:
        self._simulation = simulation
        self._row = row

    @property
    def position(self) -> Floats:
        """Where its middle is, of a plane or a half-pipe the point that the scene gives [m], (3,), a copy."""
        return self._now[:3].copy()

    @property
    def velocity(self) -> Floats:
        """Its velocity [m/s], (3,), a copy.

        Set it to move the obstacle from now on, whatever motion it had. Raises ValueError for anything but
        three finite numbers, for one that has a mass, and for a speed at which it would jump over nodes
        within a step.
        """
        return self._now[3:].copy()

    @velocity.setter
    def velocity(self, value: ArrayLike) -> None:
        self._move(three("velocity", value, "m/s"), math.inf)

    def move_to(self, position: ArrayLike, duration: float) -> None:
        """Let it go to a `position` [m], (3,), straight and evenly, in `duration` [s], and rest there.

        `Simulation.step` of that duration ends there. Whatever motion it had is forgotten.

        Raises ValueError for anything but three finite numbers, for a duration that is not positive and
        finite, for one that has a mass, and for a speed at which it would jump over nodes within a step.
        """
        way = three("position", position, "m") - self.position
        seconds, stop = self._whole(duration)
        self._move(way / seconds, stop)

    @property
    def angle(self) -> float:
        """How far it has turned about its axis since time zero [rad]."""
        return self._turned[0]

    @property
    def rate(self) -> float:
        """The rate at which it turns about its axis [rad/s].

        Set it to turn the obstacle from now on, whatever the scene told it. Raises ValueError for anything
        but a finite number, for an obstacle that turns freely, for more than half a turn in a step, and for a
        rate at which one that is not round would jump over nodes within a step.
        """
        return self._turned[1]

    @rate.setter
    def rate(self, value: float) -> None:
        self._turn(_finite("rate", value, "rad/s"), math.inf)

    def turn_to(self, angle: float, duration: float) -> None:
        """Let it turn evenly to an `angle` [rad], counted as `angle` is, in `duration` [s], and rest there.

        Raises ValueError as `rate` does, and for a duration that is not positive and finite.
        """
        seconds, stop = self._whole(duration)
        self._turn((_finite("angle", angle, "rad") - self.angle) / seconds, stop)

    @property
    def fastest(self) -> float:
        """The largest speed at which it jumps over no node within a step, whatever way it goes [m/s].

        Turning as it will. See `fastest_along`.
        """
        if (reach := self._reach) == 0.0:
            return self._limit
        table, row, time = self._table, self._row, self._simulation.time
        rate = abs(self.rate) if table.wheel[row] >= 0 else rate_ahead(table, row, time)
        return max(self._limit - rate * reach, 0.0)

    def fastest_along(self, way: ArrayLike) -> float:
        """The same along a `way` [m], (3,), however long [m/s]: a disc goes faster in its own plane.

        Raises ValueError for anything but three finite numbers.
        """
        ways, system = [three("way", way, "m")], self._simulation.system
        thin = float(thin_along(system, self._row, self._body, ways)[0])
        if math.isinf(thin):  # a plane: nothing is jumped over
            return self.fastest
        return self.fastest + (thin - radius_with_rope(system, self._body)) / self._step

    @property
    def fastest_turn(self) -> float:
        """The largest rate at which it does so, moving as it will, and by half a turn in a step [rad/s].

        Friction turns with a body within a step: beyond half a turn it would point backwards.
        """
        if (reach := self._reach) == 0.0:
            return self._half_turn
        speed = speed_ahead(self._table.motion, self._row, self._simulation.time)
        return min(max(self._limit - speed, 0.0) / reach, self._half_turn)

    @property
    def turns(self) -> bool:
        """Whether a hand can turn it: it does not turn freely."""
        return not is_free(self._body)

    @property
    def moves(self) -> bool:
        """Whether a hand can move it: it has no mass that would swing."""
        return not has_mass(self._body)

    @property
    def _step(self) -> float:
        """The longest step that its method takes [s]."""
        plan = self._simulation.plan
        return float(self._simulation.clock[1]) if plan.longest is None else plan.longest

    @property
    def _limit(self) -> float:
        """The largest speed at which a surface jumps over no node within a step [m/s]."""
        simulation = self._simulation
        return radius_with_rope(simulation.system, self._body) / self._step

    @property
    def _half_turn(self) -> float:
        """Half a turn in a step [rad/s]."""
        return math.pi / self._step

    @property
    def _reach(self) -> float:
        """How far from its axle turning moves its surface [m]; 0 of what is round."""
        table = self._table
        return reach_of(table, self._row) if table.sweeps[self._row] else 0.0

    @property
    def taken(self) -> tuple[bool, bool]:
        """Whether its motion, and its turning, are no longer those of the scene."""
        bodies, row = self._simulation.bodies, self._row
        own = self._simulation.model.system.node.obstacle
        moved = not np.array_equal(bodies.params[row], own.motion.params[row])
        turned = not np.array_equal(bodies.angles[row], own.turns.params[row])
        return moved, turned

    @property
    def _table(self) -> Obstacles:
        found: Obstacles = self._simulation.system.node.obstacle
        return found

    @property
    def _body(self) -> Obstacle:
        return self._simulation.scene.obstacles[self._row]

    @property
    def _now(self) -> Floats:
        return np.array(place_now(self._table.motion, self._row, self._simulation.time))

    @property
    def _turned(self) -> tuple[float, float]:
        """Angle [rad] and rate [rad/s] now."""
        simulation, row = self._simulation, self._row
        table, time = self._table, simulation.time
        wheel = int(table.wheel[row])
        if wheel >= 0:
            angle, rate = simulation.arrays.memory.obstacle.wheel[wheel, :2]
            return float(angle), float(rate)
        by_motion = place_now(table.turns, row, time)
        rate, start, stop = table.spin[row]
        angle = float(by_motion[0] + rate * min(max(time - start, 0.0), stop - start))
        return angle, float(by_motion[3] + (rate if start <= time < stop else 0.0))

    def _whole(self, duration: float) -> tuple[float, float]:
        """Return a duration [s], and when it ends [s]: as it is, or one that comes with a step's end to that.

        What is no whole number of the present steps is left as it is, for `Simulation.step` cuts it anew.
        """
        seconds = _finite("duration", duration, "s")
        if not seconds > 0.0:
            raise ValueError(f"duration: {duration!r} - must be a positive number of seconds")
        start, step, done = self._simulation.clock
        count = max(1, round(seconds / step))
        whole = abs(seconds / step - count) <= _EVEN
        stop = start + (done + count) * step if whole else self._simulation.time + seconds
        late = stop * (1.0 + _LATE)  # a step that ends there sees the velocity before it
        return late - self._simulation.time, late

    def _move(self, velocity: Floats, stop: float) -> None:
        speed, fastest = float(np.linalg.norm(velocity)), self.fastest_along(velocity)
        if not self.moves:
            rule = "its weight turns it, and what moves its pivot would, too; no hand can move it"
            raise ValueError(f"velocity: {speed:.4g} m/s - {rule}")
        if speed > fastest * (1.0 + _EVEN):
            most = rounded_down(fastest, 4)
            rule = f"in steps of {self._step:.3g} s it would jump over nodes; at most {most} m/s"
            raise ValueError(f"velocity: {speed:.4g} m/s - {rule}")
        bodies, row, place = self._simulation.bodies, self._row, self.position
        bodies.kind[row] = _VELOCITY
        self._set(bodies.params[row], place, velocity, stop)

    def _turn(self, rate: float, stop: float) -> None:
        if not self.turns:
            rule = "it turns freely, as ropes turn it; no hand can turn it"
            raise ValueError(f"rate: {rate:g} rad/s - {rule}")
        if abs(rate) > (most := self.fastest_turn) * (1.0 + _EVEN):
            step = self._step
            does = "jump over nodes" if most < self._half_turn else "turn by more than half"
            rule = (
                f"in steps of {step:.3g} s it would {does}; at most {rounded_down(most, 4)} rad/s"
            )
            raise ValueError(f"rate: {rate:.4g} rad/s - {rule}")
        bodies, row, angle = self._simulation.bodies, self._row, self.angle
        bodies.turning[row] = _VELOCITY
        bodies.spin[row] = 0.0, 0.0, 0.0
        self._set(bodies.angles[row], np.array([angle, 0.0, 0.0]), np.array([rate, 0.0, 0.0]), stop)

    def _set(self, params: Floats, place: Floats, velocity: Floats, stop: float) -> None:
        params[...] = 0.0
        params[ORIGIN], params[WAY], params[INTERVAL] = (
            place,
            velocity,
            (self._simulation.time, stop),
        )
        self._simulation.set_off_bodies()

    def __repr__(self) -> str:
        x, y, z = self.position
        return f"<Obstacle {name_of(self._body, self._row)!r} at ({x:.4g}, {y:.4g}, {z:.4g}) m>"


def _finite(name: str, value: float, unit: str) -> float:
    """Return a finite number. Raises ValueError for anything else."""
    try:
        found = float(value)
    except (TypeError, ValueError):
        found = math.nan
    if not math.isfinite(found):
        raise ValueError(f"{name}: {value!r} - must be a finite number [{unit}]")
    return found


def handles(simulation: Simulation) -> dict[str, ObstacleHandle]:
    """Return the handles of all obstacles, by name."""
    return {
        name_of(body, row): ObstacleHandle(simulation, row)
        for row, body in enumerate(simulation.scene.obstacles)
    }
