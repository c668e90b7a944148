"""Random scenes as engineers write them: falls, hoists, spans, slings, tows, ropes on drums, edges, pulleys.

Ropes from a soft cord to a wire, 10 to 40 segments, 1 to 3 s: for the claim that a number that is printed
is right, or that a note says that it may not be. A seed gives one scene; its kind is the seed's remainder.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from ropewalk.scene import (
    Air,
    Anchor,
    Clamp,
    Contact,
    Hanging,
    Joint,
    Kick,
    Limiter,
    Load,
    Rope,
    RunSettings,
    Scene,
    Slack,
    Straight,
    Table,
    Tie,
    Velocity,
    Winch,
)
from verification.random_scenes import Random, _between, _chance
from verification.working_obstacles import drum, edge, landing, trolley
from verification.working_parts import (
    Parts,
    g,
    mass_of,
    material_of,
    place_of,
    rope_of,
    shake_of,
    way_of,
)

#: What a user may choose: method and step [s].
CHOICES: tuple[tuple[str, float | str], ...] = (
    ("auto", "auto"),
    ("adaptive", "auto"),
    *(
        (method, 1.0 / rate)
        for method in (
            "esdirk3", "sdirk2", "bdf2", "implicit-euler", "implicit-midpoint", "generalized-alpha",
        )
        for rate in (60.0, 240.0)
    ),
)  # fmt: skip


def _fall(random: Random) -> Parts:
    """A load falls into a rope that is slack, or straight and just about to catch it."""
    stuff, length = material_of(random, 3e3, 3e5), float(random.uniform(1.0, 6.0))
    mass = mass_of(random, stuff)
    if _chance(random, 0.3):
        speed = math.sqrt(2.0 * g * float(random.uniform(0.1, 1.8)) * length)
        segments = int(random.integers(10, 41))
        kicks = [
            Kick(node=i, velocity=(0.0, 0.0, -speed * i / segments)) for i in range(1, segments + 1)
        ]
        shape: Any = Straight(end=(0.0, 0.0, -length))
        rope = rope_of(
            random, "rope", stuff, length, shape, segments=segments, mass=mass, kicks=kicks
        )
    else:
        end = place_of(length * random.uniform(0.2, 0.9) * way_of(random))
        rope = rope_of(random, "rope", stuff, length, Slack(end=end), mass=mass)
    return {"ropes": [rope], "anchors": [Anchor(rope="rope", node=0)]}


def _hoist(random: Random) -> Parts:
    """A winch lowers or hoists a load, sets off and halts at once."""
    stuff, length = material_of(random, 1e4), float(random.uniform(3.0, 15.0))
    rope = rope_of(random, "rope", stuff, length, Hanging(), mass=mass_of(random, stuff))
    start = float(random.uniform(0.0, 0.5))
    speed = _between(random, 0.1, 3.0) * (1.0 if _chance(random, 0.6) else -1.0)
    winch = Winch(
        rope="rope", end="start", speed=speed, start=start, stop=start + random.uniform(0.2, 1.0)
    )
    return {
        "ropes": [rope],
        "anchors": [Anchor(rope="rope", node=0)],
        "winches": [winch],
        "start": "at-rest",
    }


def _span(random: Random) -> Rope:
    """A rope between two points, with a load somewhere."""
    stuff, length = material_of(random), float(random.uniform(2.0, 20.0))
    end = place_of(
        length * random.uniform(0.85, 1.0) * np.array([1.0, 0.0, random.uniform(-0.3, 0.3)])
    )
    rope = rope_of(random, "rope", stuff, length, Slack(end=end))
    if _chance(random, 0.6):
        node = int(random.integers(1, rope.segments))
        rope = rope.replace(loads=[Load(node=node, mass=mass_of(random, stuff, 5e-4, 5e-3))])
    return rope


def _shaken(random: Random) -> Parts:
    """A span, or a load that hangs, of which an anchor is shaken."""
    if _chance(random, 0.5):
        rope = _span(random)
        ends = [0, -1]
    else:
        stuff = material_of(random)
        rope = rope_of(
            random,
            "rope",
            stuff,
            float(random.uniform(1.0, 8.0)),
            Hanging(),
            mass=mass_of(random, stuff),
        )
        ends = [0]
    motion = shake_of(random, rope.length_unstretched)
    anchors = [Anchor(rope="rope", node=0, motion=motion)]
    anchors += [Anchor(rope="rope", node=node) for node in ends[1:]]
    return {"ropes": [rope], "anchors": anchors, "start": "at-rest"}


def _moved(random: Random) -> Parts:
    """An anchor of a span or of a load that hangs sets off and stops at once, or the other lets go."""
    rope = _span(random)
    speed = place_of(_between(random, 0.2, 5.0) * way_of(random))
    start = float(random.choice([0.0, random.uniform(0.0, 0.6)]))
    stop = start + float(random.uniform(0.1, 0.7))
    motion: Any = Velocity(velocity=speed, start=start, stop=stop)
    if _chance(random, 0.3):
        way = np.array(speed) * (stop - start)
        begin = np.array(rope.shape.start)  # type: ignore[union-attr]
        back = stop + float(random.uniform(0.05, 0.5))
        times = (0.0, start + 0.01, stop + 0.01, back + 0.02, 9.0)
        places = [place_of(begin + part * way) for part in (0.0, 0.0, 1.0, 0.0, 0.0)]
        motion = Table(times=times, positions=places)
    other = {"release_time": float(random.uniform(0.2, 1.0))} if _chance(random, 0.2) else {}
    anchors = [Anchor(rope="rope", node=0, motion=motion), Anchor(rope="rope", node=-1, **other)]
    return {"ropes": [rope], "anchors": anchors, "start": "at-rest"}


def _tow(random: Random) -> Parts:
    """A slack rope is pulled taut, seen from above."""
    stuff, length = material_of(random), float(random.uniform(2.0, 10.0))
    speed = _between(random, 0.3, 4.0)
    slack = min(random.uniform(0.02, 0.2) * length, 0.7 * speed)
    shape = Slack(end=(length - slack, 0.0, 0.0))
    rope = rope_of(random, "rope", stuff, length, shape).replace(
        loads=[Load(node=0, mass=mass_of(random, stuff))]
    )
    pull = Anchor(rope="rope", node=-1, motion=Velocity(velocity=(speed, 0.0, 0.0)))
    return {"ropes": [rope], "anchors": [pull], "gravity": (0.0, 0.0, 0.0)}


def _sling(random: Random) -> Parts:
    """Legs from anchors to a joint from which a load hangs; it falls, is kicked, or a leg is let go."""
    legs = int(random.integers(2, 4))
    stuff = material_of(random, 5e3)
    length, drop = float(random.uniform(1.0, 4.0)), float(random.uniform(0.5, 3.0))
    width = length * float(random.uniform(0.3, 0.8))
    depth = math.sqrt(length**2 - width**2)
    falls = _chance(random, 0.5)
    knot = np.array([0.0, 0.0, -depth * (0.8 if falls else 1.0)])
    ropes, anchors = [], []
    for leg in range(legs):
        angle = 2.0 * math.pi * leg / legs
        top = width * np.array([math.cos(angle), math.sin(angle), 0.0])
        shape = Slack(start=place_of(top), end=place_of(knot))
        ropes.append(rope_of(random, f"leg{leg}", stuff, length * 1.001, shape, segments=10))
        anchors.append(Anchor(name=f"top{leg}", rope=f"leg{leg}", node=0))
    below = knot - drop * np.array([0.0, 0.3, 0.6] if falls else [0.0, 0.0, 1.0])
    lower_stuff = stuff if _chance(random, 0.5) else material_of(random, 5e3)
    kick = (
        []
        if falls
        else [Kick(node=-1, velocity=place_of(_between(random, 0.5, 6.0) * way_of(random)))]
    )
    lower = (Slack if falls else Straight)(start=place_of(knot), end=place_of(below))
    ropes.append(
        rope_of(
            random, "lower", lower_stuff, drop, lower,
            segments=10, mass=mass_of(random, lower_stuff, 5e-4, 0.01), kicks=kick,
        )
    )  # fmt: skip
    if _chance(random, 0.3):
        anchors[0] = anchors[0].replace(release_time=float(random.uniform(0.1, 1.0)))
    ties = [Tie(rope=f"leg{leg}", node=-1) for leg in range(legs)] + [Tie(rope="lower", node=0)]
    return {"ropes": ropes, "anchors": anchors, "joints": [Joint(points=ties)]}


def _beam(random: Random) -> Parts:
    """A rope that is stiff in bending, clamped at one end, let go straight or shaken."""
    stuff, length = material_of(random, 1e4, 1e6), float(random.uniform(0.5, 3.0))
    stuff["tension_only"] = False
    stuff["EI"] = _between(random, 0.05, 3.0) * stuff["mass_per_length"] * g * length**3
    stuff["bending_damping"] = stuff["EI"] * _between(random, 1e-4, 1e-2)
    way = way_of(random)
    load = float(random.uniform(0.1, 2.0)) * stuff["mass_per_length"] * length
    shape = Straight(end=place_of(length * way))
    rope = rope_of(
        random, "rope", stuff, length, shape, segments=int(random.integers(10, 25)), mass=load
    )
    clamp = Clamp(direction=place_of(way))
    more = {"motion": shake_of(random, length)} if _chance(random, 0.5) else {}
    return {"ropes": [rope], "anchors": [Anchor(rope="rope", node=0, clamp=clamp, **more)]}


KINDS = (
    _fall, _hoist, _shaken, _moved, _tow, _sling, _beam, drum, landing, edge, trolley,
)  # fmt: skip
_BARE = (_fall, _shaken, _moved, _tow, _sling)  # what may have what is rare besides


def _with(random: Random, kind: Any, parts: Parts) -> None:
    """Add air, a limiter, rigid links, bending or contact of ropes."""
    if _chance(random, 0.2):
        wind = (
            place_of(random.uniform(0.0, 12.0) * way_of(random))
            if _chance(random, 0.5)
            else (0, 0, 0)
        )
        parts["air"] = Air(density=1.2, wind=wind)
    if kind not in _BARE:
        return
    if _chance(random, 0.1):
        parts["limiter"] = Limiter(
            min_stretch=0.0, max_stretch=float(random.choice([1.02, 1.1, 1.3]))
        )
        parts["start"] = "shape"
    elif _chance(random, 0.06):
        stuff = {"EA": math.inf, "axial_damping": 0.0, "tension_only": False}
        parts["ropes"] = [
            rope.replace(made_of=rope.made_of.replace(**stuff)) for rope in parts["ropes"]
        ]
    elif _chance(random, 0.15):
        EI = _between(random, 1e-3, 0.3)
        parts["ropes"] = [
            rope.replace(
                made_of=rope.made_of.replace(
                    EI=EI * rope.made_of.mass_per_length,
                    bending_damping=0.01 * EI * rope.made_of.mass_per_length,
                )
            )
            for rope in parts["ropes"]
        ]
    if len(parts["ropes"]) > 1 and _chance(random, 0.15):
        parts["contact"] = Contact(friction=0.2)


def working_scene(seed: int) -> Scene:
    """Return the scene of a seed, with method and step of its own choice."""
    random = np.random.default_rng([seed, 3])
    kind = KINDS[seed % len(KINDS)]
    parts = kind(random)
    _with(random, kind, parts)
    run = RunSettings(duration=float(random.uniform(1.0, 3.0)), start=parts.pop("start", "shape"))
    return Scene(name=f"{kind.__name__.lstrip('_')} {seed}", run=run, **parts)


def as_run(scene: Scene, method: str, time_step: float | str) -> Scene:
    """Return a scene with a method and a step [s]."""
    return scene.replace(run=scene.run.replace(method=method, time_step=time_step))
