"""Obstacles that hands move and turn: how fast, and the way that they went, as a motion of a scene.

A hand gives a body a target; it goes there straight and evenly within `FOLLOW` of the user's time, or as
fast as `FASTEST` and the run's step allow. What a hand did is kept in the scene of the recorded part: as a
table of places and angles at its frames, from which figures, replays and tables know where the body was.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.hands.body import ObstacleHandle
from ropewalk.live.hands import FASTEST, SLOWEST
from ropewalk.live.parameters import refusal
from ropewalk.scene import Scene
from ropewalk.scene.motions import Table
from ropewalk.scene.obstacles import name_of
from ropewalk.scene.spin import Spin
from ropewalk.simulation import Simulation

FOLLOW = 0.05  # [s] of the user's time in which a body reaches its target
SAFE = 0.5  # [1] of the speed at which it would jump over nodes
FASTEST_TURN = 12.0  # [rad/s]
_SLOW = 1e-9  # [m/s, rad/s] what is left to a body whose other motion is as fast as may be


def lead(handle: ObstacleHandle, target: Floats | None, angle: float | None, pace: float) -> None:
    """Have a body go to a place [m] and turn to an angle [rad].

    `pace`: simulated seconds in one of the user's.
    Raises SceneError for one that no hand can turn, or move.
    """
    if target is not None and not handle.moves:
        rule = "cannot be moved: its weight turns it, and what moves its pivot would, too"
        raise refusal("target", None, rule)
    follow = FOLLOW * max(pace, SLOWEST)
    if angle is not None:
        if not handle.turns:
            raise refusal("angle", angle, "cannot be turned: it turns freely, as ropes turn it")
        fastest = max(min(FASTEST_TURN, SAFE * handle.fastest_turn), _SLOW)
        handle.turn_to(angle, max(follow, abs(angle - handle.angle) / fastest))
    if target is not None:
        far = float(np.linalg.norm(way := target - handle.position))
        fastest = max(min(FASTEST, SAFE * handle.fastest_along(way)), _SLOW)
        handle.move_to(target, max(follow, far / fastest))


class Told:
    """How bodies moved when pages were last told of it."""

    def __init__(self) -> None:
        self._known: tuple[bytes, ...] = ()

    def moved(self, simulation: Simulation) -> bool:
        """Tell whether hands have changed that since; it is known from now on."""
        now = tuple(part.tobytes() for part in simulation.bodies)
        changed, self._known = now != self._known, now
        return changed


class Spot(NamedTuple):
    """Where a body is, and how far it has turned."""

    time: float  # [s]
    place: tuple[float, float, float]  # [m]
    angle: float  # [rad]
    taken: tuple[bool, bool]  # whether hands have moved it, and turned it


def spots(simulation: Simulation) -> dict[str, Spot]:
    """Return where those bodies are that hands have taken, by name."""
    found = {}
    for name, handle in simulation.obstacles.items():
        if any(taken := handle.taken):
            x, y, z = map(float, handle.position)
            found[name] = Spot(simulation.time, (x, y, z), handle.angle, taken)
    return found


@dataclass
class Way:
    """The way of one body while a part is recorded: its corners only, where it rests in between."""

    spots: list[Spot] = field(default_factory=list)

    def add(self, spot: Spot) -> bool:
        """Add where it is at a later time; tell whether it has moved."""
        known = self.spots
        rests = len(known) > 1 and all(one[1:] == spot[1:] for one in known[-2:])
        if rests:
            known[-1] = spot
        elif not known or spot.time > known[-1].time:
            known.append(spot)
        return not rests

    def told(self, body: Any) -> Any:
        """Return the body with its way as a motion, and its angles as a table."""
        first, *_, last = *self.spots, self.spots[-1]
        corners = (
            self.spots if last.time > first.time else [first, first._replace(time=first.time + 1.0)]
        )
        times = [one.time for one in corners]
        moved, turned = last.taken
        if moved:
            motion = Table(times=times, positions=[one.place for one in corners])
            body = body.replace(motion=motion)
        if turned:
            angles, spin = [one.angle for one in corners], getattr(body, "spin", None)
            own = {
                one: v for one in ("pivot", "axis") if (v := getattr(spin, one, None)) is not None
            }
            body = body.replace(spin=Spin(times=times, angles=angles, **own))
        return body


def ways_of(spots: Mapping[str, Spot]) -> dict[str, Way]:
    """Return ways that begin at these spots."""
    return {name: Way([spot]) for name, spot in spots.items()}


def with_ways(scene: Scene, ways: Mapping[str, Way]) -> Scene:
    """Return the scene in which bodies move as hands moved them."""
    if not ways:
        return scene
    names = [name_of(body, row) for row, body in enumerate(scene.obstacles)]
    bodies: Sequence[Any] = scene.obstacles
    pairs: Iterable[tuple[str, Any]] = zip(names, bodies, strict=True)
    return scene.replace(
        obstacles=[ways[name].told(body) if name in ways else body for name, body in pairs]
    )
