"""Random scenes whose anchors stop, turn back or let go at once while stiff friction holds the ropes.

Ropes as those of `random_scenes`, but with friction from a tenth of the critical one of a segment up to
thirty times, axial or vector, for explicit methods in their automatic step and for implicit ones in steps
that are long beside it; not for `generalized-alpha`, which promises nothing for large motions. A seed gives
one scene.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from ropewalk.scene import (
    Air,
    Anchor,
    Load,
    Material,
    Rope,
    RunSettings,
    Scene,
    Slack,
    Springs,
    Straight,
    Table,
    Velocity,
)
from verification.random_scenes import Random, _between, _chance, _vector

EXPLICIT = ("semi-implicit-euler", "verlet", "rk4", "heun")
IMPLICIT = ("esdirk3", "sdirk2", "bdf2", "implicit-euler")
METHODS = (*EXPLICIT, *IMPLICIT, "adaptive")
_LAST = 1.5  # [s] nothing stops after it; a run goes on for half a second


def _rope(random: Random, name: str, offset: float, *, mild: bool) -> Rope:
    segments = int(_between(random, 2, 40))
    length, line = _between(random, 0.3, 8.0), _between(random, 0.01, 1.0)
    part = length / segments
    EA = _between(random, 200.0, 1e5)
    critical = math.sqrt(EA / part * line * part)  # N s/m, of a segment and a node
    share = _between(random, 0.1, 1.0 if mild else 30.0)
    friction, slack = ("vector", "axial")[_chance(random, 0.6)], _chance(random, 0.4)
    made_of: Springs | Material
    if _chance(random, 0.5):
        made_of = Springs(
            spring_constant=EA / part,
            node_mass=line * part,
            segment_length=part,
            spring_friction=share * critical,
            friction=friction,
            tension_only=slack,
        )
    else:
        made_of = Material(
            EA=EA,
            mass_per_length=line,
            axial_damping=share * critical * part,
            EI=1e-3 * EA * part * part if _chance(random, 0.2) else 0.0,
            friction=friction,
            tension_only=slack,
        )
    start = np.array([0.0, offset, 0.0])
    reach = length * float(random.choice([0.6, 0.95, 1.0, 1.02], p=[0.2, 0.2, 0.5, 0.1]))
    towards = random.normal(size=3) - np.array([0.0, 0.0, 1.0])
    end = start + reach * towards / np.linalg.norm(towards)
    loads = [
        Load(node=-1, mass=_between(random, 0.5, 300.0) * line * part)
        for _ in range(_chance(random, 0.5))
    ]
    return Rope(
        name=name,
        segments=segments,
        made_of=made_of,
        length=length if isinstance(made_of, Material) else None,
        shape=(Slack if reach < 0.9 * length else Straight)(start=tuple(start), end=tuple(end)),
        loads=loads,
    )


def _speed(random: Random) -> tuple[float, float, float]:
    return _vector(random, _between(random, 0.2, 4.0))


def _stops(random: Random, place: Any) -> dict[str, Any]:
    """An anchor's fields: it stops, goes there and back, stands still at once, or lets go on its way."""
    kind, stop = random.choice(["velocity", "table", "steps"]), float(random.uniform(0.1, _LAST))
    if _chance(random, 0.5):  # at the end of a step
        stop = max(1, round(60.0 * stop)) / 60.0
    found: dict[str, Any] = {}
    if kind == "velocity":
        found["motion"] = Velocity(velocity=_speed(random), start=0.0, stop=stop)
    else:
        times = np.unique(np.round(random.uniform(0.0, _LAST, int(random.integers(2, 6))), 4))
        times = np.array([0.0, *times[times > 0.02], _LAST + 0.01])
        rates = np.array([_speed(random) for _ in times[1:]])
        if kind == "steps":  # stands every other piece
            rates[1::2] = 0.0
        places = place + np.vstack([np.zeros(3), np.cumsum(np.diff(times)[:, None] * rates, 0)])
        found["motion"] = Table(times=tuple(times), positions=[tuple(p) for p in places])
    if _chance(random, 0.3):
        found["release_time"] = float(random.uniform(0.05, _LAST))
    return found


def _anchors(random: Random, rope: Rope) -> list[Anchor]:
    shape: Any = rope.shape
    first = Anchor(rope=rope.name, node=0, **_stops(random, np.array(shape.start)))
    if _chance(random, 0.6):
        return [first]
    more = _stops(random, np.array(shape.end)) if _chance(random, 0.5) else {}
    return [first, Anchor(rope=rope.name, node=-1, **more)]


def stopping_scene(seed: int, *, method: str | None = None) -> Scene:
    """Return the scene of a seed; `method` in place of its own."""
    random = np.random.default_rng([seed, 2])
    own = method or METHODS[seed % len(METHODS)]
    ropes = [
        _rope(random, f"rope{i}", 0.3 * i, mild=own in EXPLICIT)
        for i in range(int(random.choice([1, 2], p=[0.8, 0.2])))
    ]
    step = 1.0 / float(random.choice([60.0, 240.0, 1000.0])) if own in IMPLICIT else "auto"
    weightless = _chance(random, 0.15)
    return Scene(
        name=f"stopping {seed}",
        gravity=(0.0, 0.0, 0.0 if weightless else -9.81),
        ropes=ropes,
        anchors=[anchor for rope in ropes for anchor in _anchors(random, rope)],
        air=Air(node_drag=0.01) if own == "heun" else None,
        run=RunSettings(
            method=own,
            time_step=step,
            duration=_LAST + 0.5,
            frame_rate=60.0,
            start="shape" if weightless or _chance(random, 0.5) else "at-rest",
            tolerance=_between(random, 1e-6, 1e-3),
        ),
    )
