"""What `check` says of nodes that start so near an obstacle, and so fast, that it throws them back.

A contact brakes from the gap g = 2 u sqrt(m/k) on what comes at it with u (`laws.closing`): its damper is the
critical one, so that with w = sqrt(k/m) the way is g(t) = (g0 + (w g0 - u) t) exp(-w t), which comes to 0 at
last from g0 = 2 u / w, and from all g0 >= u / w. What starts nearer goes in, and leaves, in the skin, with
    (1 - s) exp(-2 - s / (1 - s)) u,   s = w g0 / u.
Beyond the skin the damper is z = 0.3 of the critical one. A linear contact of that throws back
    exp(-z / sqrt(1 - z^2) (pi - atan(2 z sqrt(1 - z^2) / (1 - 2 z^2)))) u = 0.45 u
(Schwager & Poeschel 2007, Granular Matter 9:465); while the slope still rises it is more, the more the harder
the contact gets, as it is of a node with more mass than its damper is made for (the mean of its rope). So it
is integrated, for a node that nothing else holds. Beside an obstacle with a restitution what is more than
that is told.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.laws.closing import closing
from ropewalk.laws.hardening import along_surface, squeezed
from ropewalk.laws.obstacle import Obstacles
from ropewalk.laws.obstacle_places import surface_near
from ropewalk.laws.striking import HARD
from ropewalk.lowering import Model
from ropewalk.lowering.touching import within_reach
from ropewalk.theory.borrowed import load_scipy

_LEFT = 0.01  # [1] share of its speed from which on a node is thrown back
_ON = 1e-9  # [m] a gap below it is rounding's
_TOWARDS = 0.1  # [1] share of its speed over the surface below which a node goes along it


def near_start_warnings(model: Model) -> list[str]:
    """Return a sentence for every obstacle beside which nodes start so, of the one that is nearest for it.

    The model is as its run starts: of ropes at rest that are kicked, or obstacles that move at once, too.
    """
    if not model.scene.obstacles:
        return []
    table, state = model.system.node.obstacle, model.state
    free = np.flatnonzero(state.inverse_mass > 0.0)
    speed, over, near = within_reach(table, free, state.x, state.v, 0.0)
    worst = dict[int, _Start]()
    for o, j in np.argwhere(near).tolist():
        i, moves = int(free[j]), speed[o, j]
        gap, *direction, ax, ay, az, ca, cb = surface_near(table, o, state.x[:, i], 0.0)
        room, rise = gap - float(table.thickness[i]), float(np.array(direction) @ moves)
        if not rise < -_TOWARDS * float(np.linalg.norm(moves)):
            continue
        way = tuple(map(float, over[o, j]))
        fast = -closing(rise, room, tuple(direction), (ax, ay, az), ca, cb, way)[0]
        reach = float(table.ratio[o] * table.damping[o, i] / table.stiffness[o, i]) * fast
        room = room if abs(room) > _ON else 0.0
        if room < reach:
            mass, weight = float(state.mass[i]), -float(np.array(direction) @ model.system.gravity)
            here = _Start(room / reach, -fast, -mass, i, room, reach, weight)
            worst[o] = min(worst.get(o, here), here)
    return [note for o, start in sorted(worst.items()) if (note := _note(model, o, start))]


class _Start(NamedTuple):
    """How a node starts beside an obstacle; the least is thrown back with most."""

    share: float  # gap over that from which on it is braked [1]
    speed: float  # out of the surface [m/s]
    minus: float  # less its mass [kg]
    node: int
    room: float  # gap [m]
    reach: float  # that from which on it is braked [m]
    weight: float  # acceleration into the surface [m/s^2]


def _note(model: Model, o: int, start: _Start) -> str:
    """Return what is said of a node that starts so beside obstacle `o`; "": it is not thrown back."""
    table, (_, minus, mass, i, room, reach, weight) = model.system.node.obstacle, start
    strikes = -mass if table.firmness[i] <= HARD else None

    def share(gap: float) -> float:
        return thrown_back(table, o, i, -minus, gap, weight, strikes)

    body = model.scene.obstacles[o]
    found, kept = share(room), body.restitution
    if found - kept < _LEFT:
        return ""
    near, far = room, reach
    while far - near > 0.002 * reach:
        middle = 0.5 * (near + far)
        near, far = (middle, far) if share(middle) - kept >= _LEFT else (near, middle)
    rope, number = model.layout.rope_of(i)
    gap = f"{1e3 * room:.3g} mm off it" if room > 0.0 else "on it"
    given = f" (its restitution is {kept:g})" if kept > 0.0 else ""
    off = "" if model.scene.run.start == "at-rest" else f"{1e3 * far:.3g} mm off, or "
    return (
        f"obstacle {body.name!r}: node {number} of rope {rope!r} starts {gap} and comes "
        f"at it with {-minus:.3g} m/s: it is thrown back, with about {found:.2g} of that{given}, as a "
        f"contact stops only what it has braked from farther out; let it start {off}more slowly"
    )


def thrown_back(
    table: Obstacles,
    o: int,
    i: int,
    speed: float,
    room: float,
    weight: float = 0.0,
    mass: float | None = None,
) -> float:
    """Return with which share of its `speed` [m/s] node `i` leaves obstacle `o` from a gap of `room` [m].

    0 where its `weight`, the acceleration into the surface [m/s^2], holds it down. Its `mass` [kg] is that
    which its damper is made for if none is given, as of rigid links, which push at once.
    """
    k, c, ratio = float(table.stiffness[o, i]), float(table.damping[o, i]), float(table.ratio[o])
    m = 0.25 * c * c / k if mass is None else mass

    def push(_: float, y: Floats) -> float:
        depth = -float(y[0])
        pressed, damper = squeezed(table, o, i, depth)[0], along_surface(table, o, i, depth)[1]
        return float(pressed - ratio * damper * y[1])

    def moves(t: float, y: Floats) -> tuple[float, float]:
        return float(y[1]), push(t, y) / m - weight

    push.terminal, push.direction = True, -1.0  # type: ignore[attr-defined]
    start, most = (room, -speed), 60.0 * math.sqrt(m / k)
    load_scipy("integrate")
    from scipy.integrate import solve_ivp

    run = solve_ivp(moves, (0.0, most), start, events=push, rtol=1e-5, atol=1e-8 * speed * most)
    ends = run.y_events[0]
    return max(float(ends[0][1]), 0.0) / speed if len(ends) else 0.0
