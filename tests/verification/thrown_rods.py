"""Random rods that are thrown at bodies which stand: straight, bent to an arc, a zigzag, a coil, or on end.

A seed gives one scene. What acts on the rod may only take energy; steps are far too long for most of them.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.methods.verdict import energy_now
from ropewalk.scene import (
    Anchor,
    Box,
    Contact,
    Cylinder,
    HalfPipe,
    Kick,
    Material,
    Plane,
    Points,
    Rope,
    RunSettings,
    Scene,
    Sphere,
    Straight,
)
from ropewalk.simulation import Simulation
from verification.random_scenes import Random, _between, _chance

METHODS = ("implicit-euler", "sdirk2", "bdf2", "esdirk3")
RATES = (60, 120, 240, 480)  # [1/s]
BODIES = ("cylinder", "half-pipe", "sphere", "box", "floor")
FORMS = ("straight", "arc", "zigzag", "coil", "on end")


def _of(random: Random, choices: Any) -> Any:
    return choices[int(random.integers(0, len(choices)))]


def _unit(vector: Floats) -> Floats:
    return np.asarray(vector / np.linalg.norm(vector))


def _line(random: Random, form: str, segments: int, length: float, along: Floats) -> Floats:
    """The nodes of a rod about the origin, (n, 3) [m]."""
    aside = _unit(np.cross(along, random.normal(size=3)))
    across = np.cross(along, aside)
    k, turn, pitch = np.arange(segments), random.uniform(0.05, 0.8), _between(random, 0.3, 3.0)
    angle = np.zeros(segments)
    if form == "arc":
        angle = (k - 0.5 * segments) * min(turn, 6.0 / segments)
    elif form == "zigzag":
        angle = turn * (-1.0) ** k
    elif form == "coil":
        angle = np.full(segments, turn)
    phase = pitch * k if form == "coil" else np.zeros(segments)
    side = np.cos(phase)[:, None] * aside + np.sin(phase)[:, None] * across
    ways = np.cos(angle)[:, None] * along + np.sin(angle)[:, None] * side
    if form == "on end":
        ways = np.column_stack(
            (0.02 * np.sin(turn * k), 0.02 * np.cos(turn * k), np.ones(segments))
        )
        ways /= np.linalg.norm(ways, axis=1)[:, None]
    places = np.vstack((np.zeros(3), np.cumsum(ways, axis=0))) * (length / segments)
    return np.asarray(places - places.mean(axis=0))


def _body(random: Random, kind: str, radius: float, friction: float) -> list[Any]:
    ends = {"start": (0.0, -3.0, 0.0), "end": (0.0, 3.0, 0.0)}
    bodies: list[Any] = []
    if kind == "cylinder":
        bodies.append(Cylinder(**ends, radius=radius, friction=friction))
    elif kind == "half-pipe":
        bodies.append(HalfPipe(**ends, radius=radius, friction=friction))
    elif kind == "sphere":
        bodies.append(Sphere(center=(0, 0, 0), radius=radius, friction=friction))
    elif kind == "box":
        sizes = (0.5 * radius, 0.7 * radius, 0.4 * radius)
        turned = tuple(float(a) for a in random.uniform(-0.5, 0.5, 3))
        bodies.append(
            Box(
                center=(0, 0, 0),
                half_sizes=sizes,
                edge_radius=0.1 * radius,
                rotation=turned,
                friction=friction,
            )
        )
    if kind == "floor" or _chance(random, 0.5):
        low = 0.0 if kind == "floor" else -radius - _between(random, 0.02, 0.3)
        bodies.append(Plane(point=(0, 0, low), friction=friction))
    return bodies


def thrown_rod(seed: int) -> Scene:
    """Return the scene of a seed: a rod, and bodies that stand."""
    random = np.random.default_rng(seed)
    kind, form, method = _of(random, BODIES), _of(random, FORMS), _of(random, METHODS)
    rate, friction = _of(random, RATES), _of(random, (0.0, 0.1, 0.3, 0.6))
    segments, thick = int(random.integers(4, 49)), _between(random, 0.003, 0.02)
    length, radius = _between(random, 0.2, 2.0), _between(random, 0.03, 0.4)
    radius = max(radius, 0.15) if kind == "half-pipe" else radius
    form = "straight" if (kind, form) == ("half-pipe", "on end") else form
    along = random.normal(size=3)
    if kind == "half-pipe":
        along = np.array([0.2 * random.normal(), 1.0, 0.2 * random.normal()])
    places = _line(random, form, segments, length, _unit(along))
    if kind == "half-pipe":
        places *= min(1.0, 0.9 * (radius - 0.6 * thick) / np.hypot(*places[:, [0, 2]].T).max())
        length = float(np.linalg.norm(np.diff(places, axis=0), axis=1).sum())
        towards = random.normal(size=3) * (1.0, 0.3, 1.0)
    else:
        top = 0.0 if kind == "floor" else radius
        places[:, 2] += top + thick + _between(random, 0.01, 0.2) - places[:, 2].min()
        towards = np.array([0.3 * random.normal(), 0.3 * random.normal(), -1.0])
    speed = _between(random, 0.3, 10.0) * _unit(towards)
    stuff = Material(
        EA=_between(random, 1e3, 1e6),
        EI=_between(random, 1e-4, 0.5),
        mass_per_length=_between(random, 0.03, 0.5),
        axial_damping=_between(random, 0.1, 3.0) if _chance(random, 0.5) else 0.0,
    )
    shape = Points(points=places.tolist(), velocity=tuple(speed.tolist()))
    rope = Rope(segments=segments, length=length, diameter=thick, made_of=stuff, shape=shape)
    return Scene(
        ropes=[rope],
        obstacles=_body(random, kind, radius, friction),
        contact=Contact(friction=friction) if _chance(random, 0.3) else None,
        run=RunSettings(method=method, time_step=1.0 / rate, duration=1.0),
    )


def kicked_rod(seed: int) -> Scene:
    """Return a straight rod of which some nodes are kicked, free or held by an end, with no body near."""
    random = np.random.default_rng(seed)
    segments, method, rate = int(random.integers(3, 31)), _of(random, METHODS), _of(random, RATES)
    nodes = sorted({int(node) for node in random.integers(1, segments + 1, 3)})
    kicks = [
        Kick(node=node, velocity=tuple(float(u) for u in _between(random, 0.3, 8.0) * way))
        for node, way in zip(nodes, random.normal(size=(3, 3)), strict=False)
    ]
    stuff = Material(
        EA=_between(random, 1e3, 1e6),
        EI=_between(random, 1e-4, 0.5),
        mass_per_length=_between(random, 0.03, 0.5),
        axial_damping=_between(random, 0.1, 3.0) if _chance(random, 0.5) else 0.0,
    )
    rope = Rope(
        segments=segments,
        length=_between(random, 0.3, 2.0),
        made_of=stuff,
        shape=Straight(direction=(1, 0, 0)),
        kicks=kicks,
    )
    return Scene(
        ropes=[rope],
        anchors=[Anchor(node=0)] if _chance(random, 0.5) else [],
        gravity=(0, 0, 0) if _chance(random, 0.5) else (0, 0, -9.81),
        run=RunSettings(method=method, time_step=1.0 / rate, duration=1.0),
    )


def most_risen(scene: Scene, seconds: float = 0.6) -> float:
    """Return by how much the energy rises above the least so far [1], over what there is at first.

    Of motion, stretch and bending, and what the rod's weight turns over.
    """
    simulation, step = Simulation(scene), float(scene.run.time_step)
    system, state = simulation.system, simulation.arrays
    weight = -state.mass * system.gravity[2]
    high = float(weight @ state.x[2])
    there = energy_now(system, state) - high
    least, most, low = there + high, 0.0, high
    for _ in range(round(seconds / step)):
        simulation.step(step)
        energy = energy_now(system, state)
        least, low = min(least, energy), min(low, float(weight @ state.x[2]))
        most = max(most, energy - least)
    return most / (there + high - low)
