"""The scene as it stands now, to take along: what moves and lets go counts its time from now on."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from ropewalk.live.bodies import Spot, spots, ways_of, with_ways
from ropewalk.live.frozen import Frozen
from ropewalk.live.session import Session
from ropewalk.live.turned import PLACES, turned
from ropewalk.motions.kind import ORIGIN
from ropewalk.scene import Anchor, Hand, Scene
from ropewalk.scene.motions import Fixed
from ropewalk.scene.obstacles import name_of
from ropewalk.scene.spin import Spin, Tumbling

Triple = tuple[float, float, float]
_EVER = 1e6  # [s] for which a body that never stops is told to turn


@dataclass(frozen=True)
class Turned:
    """Where a body is, how far it has turned, and how fast it turns."""

    moved: Triple  # since time zero [m]
    angle: float  # [rad]
    rate: float  # [rad/s]


@dataclass(frozen=True)
class Standing:
    """A copy of all that a scene of now is made of: quickly taken, and made into a scene by any thread."""

    frozen: Frozen
    time: float  # [s]
    gone: frozenset[str]  # anchors that have let go
    off: frozenset[str]  # slides that have run off their ropes
    led: frozenset[str]  # anchors that hands have moved
    clamps: Mapping[str, Triple]  # directions of the clamps
    spots: Mapping[str, Spot]  # of bodies that hands have moved
    bodies: Mapping[str, Turned]

    @classmethod
    def of(cls, session: Session) -> Standing:
        """Take the first variant of a session."""
        track = session.main
        simulation = track.simulation
        state, names = simulation.arrays, simulation.layout.anchor_names
        kinds, own = simulation.state.motion_kinds, simulation.model.system.anchors.kind
        clamped = zip(names, state.clamp_direction, strict=False)
        table = simulation.system.node.obstacle
        bodies = {
            name: Turned(
                _triple(handle.position - table.motion.params[row][ORIGIN]),
                float(handle.angle),
                float(handle.rate),
            )
            for row, (name, handle) in enumerate(simulation.obstacles.items())
        }
        return cls(
            Frozen.of(session),
            simulation.time,
            frozenset(one for one, held in zip(names, state.held, strict=True) if not held),
            frozenset(
                slide.name
                for slide, since in zip(track.scene.slides, state.memory.slide.off, strict=True)
                if np.isfinite(since)
            ),
            frozenset(one for one, a, b in zip(names, kinds, own, strict=True) if a != b),
            {name: _triple(direction) for name, direction in clamped},
            spots(simulation),
            bodies,
        )

    def scene(self) -> Scene:
        """Return the scene, which begins now; of one with winches that which begins at time zero."""
        made = self.frozen.thaw()
        if self.frozen.fresh:
            return made
        anchors = [self._anchor(one) for one in made.anchors if one.name not in self.gone]
        bodies = [self._body(name_of(one, row), one) for row, one in enumerate(made.obstacles)]
        # A slide begins where its node is drawn now, not where it began.
        slides = [one.replace(at=None) for one in made.slides if one.name not in self.off]
        made = made.replace(anchors=anchors, obstacles=bodies, slides=slides)
        return with_ways(made, ways_of(self.spots))

    def _anchor(self, anchor: Anchor) -> Anchor:
        motion = Hand() if anchor.name in self.led else later(anchor.motion, self.time)
        changes: dict[str, Any] = {"motion": motion}
        if anchor.release_time is not None:
            changes["release_time"] = max(anchor.release_time - self.time, 0.0)
        clamp = anchor.clamp
        if clamp is not None and anchor.name in self.clamps:
            turns = _interval(clamp, self.time) or {"turn_rate": 0.0, "start": 0.0}
            changes["clamp"] = clamp.replace(direction=self.clamps[anchor.name], **turns)
        return anchor.replace(**changes)

    def _body(self, name: str, body: Any) -> Any:
        # What hands have taken is told by its way.
        moved, by_hand = self.spots[name].taken if name in self.spots else (False, False)
        now, changes = self.bodies[name], dict[str, Any]()
        shifts = not moved and body.motion.kind in ("velocity", "shake", "orbit")
        away = now.moved if shifts else (0.0, 0.0, 0.0)
        if body.motion.kind != "fixed" and not moved:
            changes = {
                one: _plus(place, away) for one in PLACES if (place := getattr(body, one, None))
            }
            changes["motion"] = later(body.motion, self.time)
        spin = getattr(body, "spin", None)
        if by_hand and spin is not None and spin.pivot is not None:
            changes["spin"] = spin.replace(pivot=_plus(spin.pivot, away))
        elif spin is not None and not by_hand:
            changes["spin"] = self._spin(body, spin, now, away)
        body = body.replace(**changes)
        return turned(body, now.angle) if spin is not None and spin.free else body

    def _spin(self, body: Any, spin: Spin, now: Turned, away: Triple) -> Spin | None:
        parts = ("pivot", "center_of_mass")
        moved: dict[str, Any] = {
            one: _plus(place, away) for one in parts if (place := getattr(spin, one))
        }
        if spin.free:
            return spin.replace(rate=now.rate, **moved)
        if spin.times:
            return spin.replace(times=[one - self.time for one in spin.times], **moved)
        left = _interval(spin, self.time) or {"start": 0.0, "stop": 0.0}
        if spin.pivot is None and not isinstance(
            body, Tumbling
        ):  # it looks the same at every angle
            return spin.replace(**left, **moved) if left["stop"] > 0.0 else None
        end = min(left["stop"], left["start"] + _EVER)
        times = [left["start"], end if end > left["start"] else left["start"] + 1.0]
        angles = [now.angle, now.angle + (spin.rate or 0.0) * (end - left["start"])]
        return Spin(times=times, angles=angles, axis=spin.axis, **moved)


def later(motion: Any, time: float) -> Any:
    """Return a motion as it goes on from a time [s], counted from there."""
    if motion.kind == "velocity":
        left = _interval(motion, time)
        return Fixed() if left is None else motion.replace(**left)
    if motion.kind == "table":
        return motion.replace(file=None, times=[one - time for one in motion.times])
    if motion.kind == "shake":
        turns = motion.phase / (2.0 * math.pi) + motion.frequency * time
        return motion.replace(phase=2.0 * math.pi * (turns - math.floor(turns)))
    return motion


def _interval(moving: Any, time: float) -> dict[str, float] | None:
    """Return start and stop [s] of what moves for a while, counted from a time; None: it is over."""
    if moving.stop <= time:
        return None
    return {"start": max(moving.start - time, 0.0), "stop": moving.stop - time}


def _triple(values: np.ndarray[Any, Any]) -> Triple:
    x, y, z = (float(one) for one in values)
    return x, y, z


def _plus(place: Triple, away: Triple) -> Triple:
    return _triple(np.add(place, away))
