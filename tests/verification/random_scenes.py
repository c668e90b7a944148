"""Random scenes for the claim that a step within the bound does not break.

One to three ropes of springs or of a material, with loads, bending stiffness, clamps, air, ground, a
limiter, slack segments and moved anchors, to be run by the explicit methods. A seed gives one scene.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from ropewalk.scene import (
    Air,
    Anchor,
    Clamp,
    Ground,
    Limiter,
    Load,
    Material,
    Orbit,
    Rope,
    RunSettings,
    Scene,
    Shake,
    Slack,
    Springs,
    Straight,
    Velocity,
)

METHODS = ("semi-implicit-euler", "verlet", "rk4", "heun", "euler")
_WEIGHTS = (0.3, 0.3, 0.24, 0.08, 0.08)
Random = np.random.Generator


def _between(random: Random, low: float, high: float) -> float:
    """A number whose logarithm is uniform."""
    return float(math.exp(random.uniform(math.log(low), math.log(high))))


def _chance(random: Random, share: float) -> bool:
    return bool(random.random() < share)


def _vector(random: Random, size: float) -> tuple[float, float, float]:
    x, y, z = random.uniform(-size, size, 3)
    return float(x), float(y), float(z)


def _axis(random: Random) -> tuple[float, float, float]:
    x, y, z = random.normal(size=3)
    return float(x), float(y), float(z) + 1e-3


def _springs(random: Random, method: str, segments: int) -> Springs:
    k, m = _between(random, 30.0, 2e4), _between(random, 0.005, 0.5)
    needs = method in ("euler", "heun")
    rubs = needs or _chance(random, 0.5)
    return Springs(
        spring_constant=k,
        node_mass=m,
        segment_length=_between(random, 0.02, 0.5),
        spring_friction=_between(random, 0.003, 0.5) * math.sqrt(k * m) if rubs else 0.0,
        friction="vector" if needs or _chance(random, 0.7) else "axial",
        tension_only=_chance(random, 0.35),
    )


def _material(random: Random, method: str, length: float, segments: int) -> Material:
    EA, line = _between(random, 50.0, 3e5), _between(random, 0.01, 1.0)
    needs = method in ("euler", "heun")
    rubs = needs or _chance(random, 0.5)
    part = length / segments
    critical = part * math.sqrt(EA / part * line * part)  # N s, of a segment and a node
    EI = _between(random, 1e-7, 1e-2) * EA * part * part if _chance(random, 0.3) else 0.0
    return Material(
        EA=EA,
        mass_per_length=line,
        axial_damping=_between(random, 0.003, 0.5) * critical if rubs else 0.0,
        EI=EI,
        bending_damping=EI * _between(random, 1e-5, 1e-3) if EI and _chance(random, 0.5) else 0.0,
        friction="vector" if needs else "axial",
        tension_only=_chance(random, 0.35),
    )


def _rope(random: Random, method: str, name: str, offset: float) -> Rope:
    segments = int(_between(random, 2, 60))
    length: float | None = None
    made_of: Springs | Material
    if _chance(random, 0.5):
        made_of = _springs(random, method, segments)
        own = segments * made_of.segment_length
    else:
        own = length = _between(random, 0.5, 10.0)
        made_of = _material(random, method, own, segments)
    start = (0.0, offset, float(random.uniform(0.0, 1.0)))
    reach = own * (random.uniform(0.9, 1.15) if _chance(random, 0.6) else random.uniform(0.2, 0.9))
    towards = np.array([1.0, *random.uniform(-0.5, 0.5, 2)])
    end = tuple(float(v) for v in start + reach * towards / np.linalg.norm(towards))
    velocity = _vector(random, 3.0) if _chance(random, 0.2) else (0.0, 0.0, 0.0)
    shape = (Slack if reach < 0.9 * own else Straight)(start=start, end=end, velocity=velocity)
    node_mass = made_of.node_mass if isinstance(made_of, Springs) else 0.0
    if isinstance(made_of, Material):
        node_mass = made_of.mass_per_length * own / segments
    loads = [
        Load(
            node=int(random.integers(0, segments + 1)),
            mass=_between(random, 0.5, 100.0) * node_mass,
        )
        for _ in range(int(random.integers(0, 3)))
    ]
    return Rope(
        name=name,
        segments=segments,
        made_of=made_of,
        length=length,
        diameter=_between(random, 0.002, 0.03),
        shape=shape,
        loads=loads,
    )


def _lowest(rope: Rope) -> float:
    """A height that the rope's shape does not reach [m]."""
    ends = min(rope.shape.start[2], rope.shape.end[2])  # type: ignore[union-attr]
    return float(ends) - (0.5 * rope.length_unstretched if rope.shape.kind == "slack" else 0.0)


def _motion(random: Random, size: float) -> Any:
    which = random.random()
    if which < 0.5:
        return None
    if which < 0.85:
        return Shake(
            axis=_axis(random),
            amplitude=_between(random, 0.001, 0.1) * size,
            frequency=_between(random, 0.3, 5.0),
        )
    if which < 0.93:
        return Velocity(velocity=_vector(random, 0.5), stop=float(random.uniform(0.2, 1.0)))
    return Orbit(
        center=_vector(random, 0.2 * size), axis=_axis(random), frequency=_between(random, 0.2, 1.5)
    )


def _anchors(random: Random, rope: Rope) -> list[Anchor]:
    ends = [(0,), (0, rope.segments), (rope.segments,), ()][
        int(random.choice(4, p=[0.4, 0.4, 0.1, 0.1]))
    ]
    if rope.segments > 4 and _chance(random, 0.15):
        ends = (*ends, int(random.integers(1, rope.segments)))
    found = []
    for node in ends:
        more: dict[str, Any] = {}
        if (motion := _motion(random, rope.length_unstretched)) is not None:
            more["motion"] = motion
        if rope.bending_stiffness > 0.0 and _chance(random, 0.4):
            turning = {"turn_rate": float(random.uniform(-3.0, 3.0)), "turn_axis": _axis(random)}
            along = np.asarray(rope.shape.end) - np.asarray(rope.shape.start)  # type: ignore[union-attr]
            more["clamp"] = Clamp(
                direction=tuple(along), **(turning if _chance(random, 0.3) else {})
            )
        if _chance(random, 0.1):
            more["release_time"] = float(random.uniform(0.1, 1.0))
        found.append(Anchor(name=f"{rope.name}-{node}", rope=rope.name, node=node, **more))
    return found


def random_scene(seed: int, *, method: str | None = None, time_step: Any = "auto") -> Scene:
    """Return the scene of a seed; `method` and `time_step` [s] in place of its own."""
    random = np.random.default_rng(seed)
    own = str(random.choice(METHODS, p=_WEIGHTS))
    ropes = [
        _rope(random, own, f"rope{i}", 0.3 * i)
        for i in range(int(random.choice([1, 2, 3], p=[0.6, 0.25, 0.15])))
    ]
    air = ground = limiter = None
    if own in ("euler", "heun") or _chance(random, 0.35):
        air = Air(
            node_drag=_between(random, 1e-4, 0.1)
            if own in ("euler", "heun") or _chance(random, 0.5)
            else 0.0,
            node_drag_quadratic=_between(random, 1e-4, 0.1) if _chance(random, 0.3) else 0.0,
            density=1.2 if _chance(random, 0.6) else 0.0,
            wind=_vector(random, 5.0) if _chance(random, 0.4) else (0.0, 0.0, 0.0),
        )
    if _chance(random, 0.3):
        ground = Ground(
            height=min(map(_lowest, ropes)) - float(random.uniform(0.0, 1.0)),
            repulsion=_between(random, 30.0, 1e4),
            friction=_between(random, 0.01, 1.0),
            absorption=_between(random, 0.01, 3.0) if _chance(random, 0.6) else 0.0,
        )
    if _chance(random, 0.2):
        limiter = Limiter(
            min_stretch=float(random.choice([0.0, 0.5, 0.9, 1.0])),
            max_stretch=float(random.choice([1.0, 1.01, 1.1, 1.3])),
            passes=int(random.integers(1, 5)),
        )
    return Scene(
        name=f"random {seed}",
        gravity=(0.0, 0.0, -9.81) if _chance(random, 0.85) else (0.0, 0.0, 0.0),
        ropes=ropes,
        anchors=[anchor for rope in ropes for anchor in _anchors(random, rope)],
        air=air,
        ground=ground,
        limiter=limiter,
        run=RunSettings(
            method=method or own,
            time_step=time_step,
            duration=float(random.uniform(2.0, 6.0)),
            frame_rate=60.0,
        ),
    )
