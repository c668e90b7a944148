"""Free bodies whose torque depends on their angle, at rest: turned until their bearings hold them.

That is what is not round about its axis, and what has a mass off it. From how it is drawn a body is turned
the way it is driven, the ropes at rest at each angle, until it is driven no more; the angle is then found
between the last two (regula falsi with halved ends, the Illinois method). No step takes a surface
past a node (`passing`). Contacts begin anew at each angle, as if the body slid under the ropes: with
friction it is one rest of many. Bodies take turns.
Source: Dowell & Jarratt 1971, BIT 11:168.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace

import numpy as np

from ropewalk.core import arrays
from ropewalk.core.arrays import Floats
from ropewalk.laws.wheel_rows import ANGLE
from ropewalk.lowering import Model
from ropewalk.statics.passing import clear_turn, passes
from ropewalk.statics.pulleys import Pulley

_STEP, _LEAST = 0.05, 1e-4  # [rad] by which a body is turned at a time
_FARTHEST, _STEPS = 2.0 * math.pi, 400  # how far, and by how many rests
_ASIDE = 1e-3  # turn that tells whether a body tips [rad]
_SURE = 10.0  # torque that drives it then, over what counts as none [1]
_MISSES = 2  # steps without a rest after which there is none: each takes long
_ROOT, _ROUNDS = 80, 50  # looks between two angles, and turns of all bodies
_CLOSE = 1e-9  # of the torque at first [1]

Solve = Callable[[Model], tuple[Floats, tuple[Pulley, ...]] | None]


def turned_to_rest(model: Model, solve: Solve) -> Model:
    """Return the model with its free bodies at the angles, and its ropes about the places, of rest.

    `solve` returns places (3, n) [m] of the ropes at rest and what turns the bodies then, None for no rest.
    The model itself where they stand as they are drawn, or come to no rest.
    """
    wheels = [w for w in range(len(model.system.node.obstacle.inertia)) if _depends(model, w)]
    found = model
    for _ in range(_ROUNDS if wheels else 0):
        before = found
        for w in wheels:
            after = _turned(found, w, solve)
            if after is None:
                return model
            found = after
        if found is before or len(wheels) == 1:
            return found
    return model


def _depends(model: Model, w: int) -> bool:
    table = model.system.node.obstacle
    row = int(np.flatnonzero(table.wheel == w)[0])
    return bool(table.sweeps[row]) or bool(table.weight[w].any())


def _at(model: Model, w: int, angle: float, x: Floats) -> Model:
    """Return the model with a body at an angle [rad] and its ropes at places (3, n) [m]."""
    state = arrays.copy(model.state)
    state.x[...] = x
    state.memory.obstacle.wheel[w, ANGLE] = angle
    return replace(model, state=state)


def tipping(model: Model, solve: Solve) -> frozenset[int]:
    """Return the free bodies that stand, but that a turn by a thousandth either way drives farther on."""
    wheels = [w for w in range(len(model.system.node.obstacle.inertia)) if _depends(model, w)]
    begun = solve(model) if wheels else None
    if begun is None:
        return frozenset()
    found = set[int]()
    for w in wheels:
        body = begun[1][w]
        if not body.stands or body.bearing > 0.0:
            continue
        for side in (1.0, -1.0):
            there = solve(_at(model, w, body.angle + side * _ASIDE, begun[0]))
            if there is not None and side * there[1][w].torque > _SURE * there[1][w].close:
                found.add(w)
    return frozenset(found)


def _turned(model: Model, w: int, solve: Solve) -> Model | None:
    """Return the model with one body where its bearing holds it; itself where it does, None for no angle."""
    first = float(model.state.memory.obstacle.wheel[w, ANGLE])
    begun = solve(model)
    if begun is None:
        return None
    at_first = begun[1][w]
    if at_first.stands:
        return model
    side = math.copysign(1.0, at_first.torque)
    row = int(np.flatnonzero(model.system.node.obstacle.wheel == w)[0])

    def driven(angle: float, x: Floats) -> tuple[float, Floats] | None:
        """How much more drives it that way than its bearing holds [N m], and the places there."""
        found = solve(_at(model, w, angle, x))
        if found is None or passes(_at(model, w, low, x), _at(model, w, angle, found[0]), row):
            return None
        return side * found[1][w].torque - at_first.bearing, found[0]

    low, over, x, most = first, side * at_first.torque - at_first.bearing, begun[0], _STEP
    high, under, misses = low, over, 0
    for _ in range(_STEPS):
        step = min(most, clear_turn(_at(model, w, low, x), row))
        if step < _LEAST or misses > _MISSES:
            return None
        found = driven(low + side * step, x)
        if found is None:
            most, misses = 0.5 * step, misses + 1
            continue
        high, under = low + side * step, found[0]
        if under <= 0.0:
            break
        low, over, x = high, under, found[1]
        if abs(low - first) > _FARTHEST:
            return None
    if under > 0.0:
        return None
    close = _CLOSE * (over + abs(under))
    angle = _root(lambda one: driven(one, x), (low, over), (high, under), close)
    if angle is None:
        return None
    there = _at(model, w, angle, x)
    held = solve(there)  # not where a contact that ends lets the torque jump
    return there if held is not None and held[1][w].stands else None


def _root(
    driven: Callable[[float], tuple[float, Floats] | None],
    one: tuple[float, float],
    other: tuple[float, float],
    close: float,
) -> float | None:
    """Return the angle between two [rad] at which what drives is nothing, but for `close` [N m]."""
    (a, fa), (b, fb) = one, other
    kept = 0
    for _ in range(_ROOT):
        c = b - fb * (b - a) / (fb - fa)
        found = driven(c)
        if found is None:
            return None
        fc = found[0]
        if abs(fc) <= close or c in (a, b):
            return c
        if fc > 0.0:
            a, fa = c, fc
            fb *= 0.5 if kept == 1 else 1.0
            kept = 1
        else:
            b, fb = c, fc
            fa *= 0.5 if kept == -1 else 1.0
            kept = -1
    return None
