"""Random scenes of ropes on drums, posts, floors, edges and lines, for `working_scenes`."""

from __future__ import annotations

import math

import numpy as np

from ropewalk.scene import (
    Anchor,
    Box,
    Cylinder,
    Kick,
    Load,
    Plane,
    Points,
    Polyline,
    Slack,
    Slide,
    Spin,
    Straight,
    Velocity,
    Winch,
)
from verification.random_scenes import Random, _between, _chance
from verification.working_parts import Parts, g, mass_of, material_of, place_of, rope_of


def _over(radius: float, left: float, right: float, segments: int) -> tuple[Points, float]:
    """Nodes on a line that hangs over a cylinder about y, and the length of its segments [m]."""
    turn = math.pi * radius
    part = (left + turn + right) / segments
    places = []
    for along in np.linspace(0.0, left + turn + right, segments + 1):
        if along < left:
            places.append((-radius, 0.0, along - left))
        elif along < left + turn:
            angle = math.pi - (along - left) / radius
            places.append((radius * math.cos(angle), 0.0, radius * math.sin(angle)))
        else:
            places.append((radius, 0.0, left + turn - along))
    return Points(points=places), part


def drum(random: Random) -> Parts:
    """A line over a drum that is fixed, driven or free, with a load at each end or one end held."""
    stuff, radius = material_of(random, 3e3, 3e5), float(random.uniform(0.1, 0.4))
    left, right = (float(random.uniform(1.0, 3.0)) for _ in range(2))
    line = rope_of(random, "rope", stuff, 1.0, Straight(), segments=int(random.integers(24, 41)))
    gap = radius + 0.5 * line.diameter
    shape, part = _over(gap, left, right, line.segments)
    mass = mass_of(random, stuff, 5e-4, 0.01)
    held = _chance(random, 0.4)
    loads = [Load(node=-1, mass=mass)]
    if not held:
        loads.append(Load(node=0, mass=mass * float(random.uniform(0.4, 1.0))))
    rope = line.replace(length=part * line.segments, shape=shape, loads=loads)
    more: Parts = {}
    kind = random.choice(["fixed", "driven", "free"])
    if kind == "driven":
        more["spin"] = Spin(rate=float(random.uniform(-6.0, 6.0)))
    if kind == "free":
        more["spin"] = Spin(free=True, inertia=_between(random, 0.01, 0.5) * mass * radius**2)
    drum = Cylinder(
        name="drum", start=(0, -0.3, 0), end=(0, 0.3, 0), radius=radius,
        friction=float(random.uniform(0.0, 0.4)), **more,
    )  # fmt: skip
    anchors = [Anchor(rope="rope", node=0)] if held else []
    if held:
        rope = rope.replace(kicks=[Kick(node=-1, velocity=(0, 0, -_between(random, 0.3, 4.0)))])
    return {"ropes": [rope], "anchors": anchors, "obstacles": [drum]}


def landing(random: Random) -> Parts:
    """A load, or a rope's end, comes down on a floor or against a post."""
    stuff, length = material_of(random, 3e3, 1e5), float(random.uniform(1.0, 4.0))
    if _chance(random, 0.5):  # a pendulum against a post
        end = place_of(length * 0.97 * np.array([1.0, 0.0, random.uniform(-0.5, 0.2)]))
        rope = rope_of(
            random, "rope", stuff, length, Slack(end=end), mass=mass_of(random, stuff, 5e-4, 5e-3)
        )
        height = -length * float(random.uniform(0.3, 0.7))
        post = Cylinder(
            name="post", start=(0, -0.5, height), end=(0, 0.5, height),
            radius=float(random.uniform(0.05, 0.2)), friction=float(random.uniform(0.0, 0.4)),
        )  # fmt: skip
        return {"ropes": [rope], "anchors": [Anchor(rope="rope", node=0)], "obstacles": [post]}
    mass = mass_of(random, stuff, 5e-4, 5e-3) if _chance(random, 0.6) else 0.0
    rope = rope_of(random, "rope", stuff, length, Straight(end=(0.0, 0.0, -length)), mass=mass)
    floor = Plane(
        name="floor", point=(0, 0, -length - random.uniform(0.1, 1.0)),
        friction=float(random.uniform(0.0, 0.5)),
    )  # fmt: skip
    anchors = [Anchor(rope="rope", node=0)]
    anchors[0] = anchors[0].replace(
        release_time=float(random.uniform(0.1, 0.6)) if _chance(random, 0.5) else None,
        **(
            {}
            if _chance(random, 0.3)
            else {"motion": Velocity(velocity=(0, 0, -random.uniform(0.5, 2)))}
        ),
    )
    return {"ropes": [rope], "anchors": anchors, "obstacles": [floor]}


def edge(random: Random) -> Parts:
    """A rope over the edge of a roof: a load that is lowered, falls into it or swings."""
    stuff = material_of(random, 5e3, 2e5)
    lying, hung = float(random.uniform(0.5, 2.0)), float(random.uniform(1.0, 4.0))
    rope = rope_of(
        random, "rope", stuff, 1.0, Straight(), segments=int(random.integers(24, 41)),
        mass=mass_of(random, stuff, 5e-4, 5e-3),
    )  # fmt: skip
    radius, half = float(random.uniform(0.02, 0.1)), 0.5 * rope.diameter
    edge = (radius + half) / math.cos(math.pi / 24.0)  # its chords touch it
    arc = [
        (edge * math.sin(a), 0.0, edge * math.cos(a) - radius)
        for a in np.linspace(0.0, 0.5 * math.pi, 7)
    ]
    points = [(-lying, 0.0, half), *arc, (edge, 0.0, -radius - hung)]
    long = float(np.linalg.norm(np.diff(np.array(points), axis=0), axis=1).sum())
    roof = Box(
        name="roof", center=(-3.0 + radius, 0, -1.0), half_sizes=(3.0, 1.0, 1.0), edge_radius=radius,
        friction=float(random.uniform(0.0, 0.4)),
    )  # fmt: skip
    speed = _between(random, 0.3, 4.0)
    way = (0.0, 0.0, -1.0) if _chance(random, 0.6) else (0.6, 0.5, -0.3)
    rope = rope.replace(
        length=long * 1.0001,
        shape=Polyline(points=points),
        kicks=[Kick(node=-1, velocity=place_of(speed * np.array(way)))],
    )
    more: Parts = {}
    if _chance(random, 0.4):
        more["winches"] = [
            Winch(
                rope="rope",
                end="start",
                speed=_between(random, 0.1, 1.5),
                stop=random.uniform(0.3, 1),
            )
        ]
    return {"ropes": [rope], "anchors": [Anchor(rope="rope", node=0)], "obstacles": [roof]} | more


def trolley(random: Random) -> Parts:
    """A load rides down a line on a trolley."""
    span = float(random.uniform(5.0, 30.0))
    stuff = material_of(random, 2e4)
    mass = mass_of(random, stuff, 3e-4, 3e-3)
    drop = float(random.uniform(0.0, 0.2)) * span
    length = math.hypot(span, drop) * float(random.uniform(1.003, 1.04))
    line = rope_of(random, "line", stuff, length, Slack(end=(span, 0, -drop)))
    hook = material_of(random, 1e4, 1e5)
    rider = rope_of(
        random, "rider", hook, 0.6, Straight(end=(0, 0, -0.6)), segments=3, mass=mass
    ).replace(loads=[Load(node=0, mass=0.1 * mass), Load(node=-1, mass=mass)])
    slide = Slide(
        rope="rider", at=float(random.uniform(0.1, 0.5)) * length,
        friction=float(random.choice([0.0, 0.05])), brake=float(random.choice([0.0, 0.05])) * mass * g,
    )  # fmt: skip
    anchors = [Anchor(name=f"end{node}", rope="line", node=node) for node in (0, -1)]
    return {"ropes": [line, rider], "anchors": anchors, "slides": [slide]}
