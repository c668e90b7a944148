"""Hitches as points that a smooth curve goes through, from the radius of their post; all in diameters.

A post lies along z. Its foot is the line where x = 0 and y is least; there ropes come and go along x. The
angle about the post is counted from the foot, and grows as the rope goes on along +x.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from ropewalk.core.arrays import Floats


_STEP = math.pi / 9.0  # between points on a turn [rad]
_UNDER = 0.25  # angle from there to where ends leave the post [rad]
_CORNER = 2.0  # radius of a bend from one part of a hitch to another
BEYOND = 1.5  # by which a straight end goes on past the middle of the last strand about it


def _around(angle: Floats, rho: Floats | float, z: Floats | float) -> Floats:
    """Return points on turns about the post, (m, 3)."""
    rho, z = np.broadcast_to(rho, angle.shape), np.broadcast_to(z, angle.shape)
    return np.stack((rho * np.sin(angle), -rho * np.cos(angle), z), axis=1)


def _turn(start: float, angle: float, rho: float, z: float, climb: float) -> Floats:
    """Return points on a helix through `angle` [rad] from `start` on, from `z` to `z + climb`."""
    count = max(2, math.ceil(abs(angle) / _STEP)) + 1
    share = np.linspace(0.0, 1.0, count)
    return _around(start + angle * share, rho, z + climb * share)


def _bight(x: float, y: float, low: float, high: float) -> Floats:
    """Return points of a half circle from `low` to `high` along z, open towards -x."""
    angle = np.linspace(-0.5 * math.pi, 0.5 * math.pi, 9)
    r, z = 0.5 * (high - low), 0.5 * (high + low)
    return np.stack((x + abs(r) * np.cos(angle), np.full(9, y), z + r * np.sin(angle)), axis=1)


def bollard(rho: float, gap: float, turns: float) -> Floats:
    """Return turns beside each other, (m, 3)."""
    climb = gap * turns
    return _turn(0.0, 2.0 * math.pi * turns, rho, -0.5 * climb, climb)


def _over(rho: float) -> float:
    """Return half the angle over which a strand crosses the ends of a clove hitch [rad]."""
    return min(0.9, 2.4 / rho)


def clove(rho: float, gap: float) -> Floats:
    """Return two turns, both ends beneath the strand that goes from one to the other, (m, 3)."""
    over = _over(rho)
    full = 2.0 * math.pi
    first = np.array([-over - _UNDER, 0.0, over])
    low, high = over + 0.3, full - 1.9 * over
    back = np.linspace(low, high, max(2, math.ceil((high - low) / _STEP)) + 1)
    share = (back - over) / (full - 2.9 * over)
    fall = share * share * (3.0 - 2.0 * share)
    cross = np.linspace(-1.0, 1.0, 7)
    way = cross * (1.5 - 0.5 * cross * cross)  # steepest in the middle
    top = rho + gap * (1.0 - 0.75 * cross**4)
    half = [
        _around(first, rho, -0.5 * gap),
        _around(back, rho, gap * (-0.5 - fall)),
    ]
    down = np.vstack(half)
    up = down[::-1] * np.array([-1.0, 1.0, -1.0])  # turned by half a turn about y
    return np.vstack([down, _around(full + over * 1.1 * cross, top, 1.5 * gap * way), up])


def clove_ends(rho: float) -> tuple[Floats, Floats]:
    """Return the directions in which a clove hitch begins and ends, each (3,)."""
    angle = -_over(rho) - _UNDER
    return np.array([math.cos(angle), math.sin(angle), 0.0]), np.array(
        [math.cos(angle), -math.sin(angle), 0.0]
    )


def round_turn(rho: float, gap: float, own: float) -> tuple[Floats, Floats]:
    """Return one and a half turns with two half hitches about the own standing part, (m, 3), and its end.

    The end is the direction in which it goes on, (3,).

    `own` is the distance of the hitches' strands from the middle of that part.
    """
    turn = _turn(0.0, 3.0 * math.pi, rho, 0.0, -1.5 * gap)
    hitch = clove(own, gap)
    away = -(rho + _CORNER + 5.0 * gap)
    # its post is the standing part, along -x; its first end comes from the round turn, along -y
    local = np.array([[0.0, -1.0, 0.0], [0.0, 0.0, 1.0], [-1.0, 0.0, 0.0]])
    placed = hitch @ local + np.array([away - 1.5 * gap, -rho, 0.0])
    # from the post's far side on along -x, round a corner, and down to the hitches
    corner, deep = placed[0, 0], turn[-1, 2]
    high = max(rho, own + 3.0 * _CORNER - rho)
    angle = np.linspace(0.0, 0.5 * math.pi, 5)
    east, north = _CORNER * (1.0 - np.sin(angle)), _CORNER * (1.0 - np.cos(angle))
    bend = np.stack((corner + east, high - north, np.full(5, deep)), axis=1)
    way = np.linspace(0.0, 1.0, 5)[1:-1, None]
    smooth = np.hstack((way, way * way * (3.0 - 2.0 * way), way))
    straight = turn[-1] + smooth * (bend[0] - turn[-1])
    first, last = (end @ local for end in clove_ends(own))
    down = bend[-1] + way[1:2] * (placed[0] - first - bend[-1])
    return np.vstack([turn, straight, bend, down, placed]), last


def prusik(rho: float, gap: float, turns: float) -> Floats:
    """Return turns to one side, the bight back over turns and ends, and turns on the other, (m, 3)."""
    outer = rho + gap
    round_off = min(_CORNER, gap * (turns + 0.5) - 0.4)  # radius of the bend from turns to bight
    bend = round_off / outer  # its angle about the post
    full = 2.0 * math.pi * turns - bend
    angle = np.linspace(0.0, full, max(2, math.ceil(full / _STEP)) + 1)
    lift = np.clip((angle - full) / max(1.2, 2.4 / rho) + 1.0, 0.0, 1.0)
    rise = lift * lift * (3.0 - 2.0 * lift)
    z = 0.5 * gap + gap * turns * angle / full
    way = np.linspace(0.0, 0.5 * math.pi, 5)[1:]
    corner = _around(full + bend * np.sin(way), outer, z[-1] - round_off * (1.0 - np.cos(way)))
    half = np.vstack([_around(angle, rho + gap * rise, z), corner])
    leg = np.linspace(corner[-1, 2], 0.0, max(2, math.ceil(corner[-1, 2])) + 1)[1:]
    half = np.vstack([half, _around(np.full(len(leg), full + bend), outer, leg)])
    return np.vstack([half, half[-2::-1] * np.array([1.0, 1.0, -1.0])])


def munter(rho: float, gap: float) -> Floats:
    """Return a turn, a bight, and a turn back, whose end lies between the bight's legs, (m, 3).

    Two like loops, folded together as a book is closed.
    """
    full = 2.0 * math.pi
    one = _turn(0.0, full, rho, -1.5 * gap, gap)
    other = _turn(full, -full, rho, 1.5 * gap, -gap)
    leg = 0.5 * rho + 1.0
    legs = [[[leg, -rho, z]] for z in (-0.5 * gap, 1.5 * gap)]
    bight = _bight(rho + 2.0, -rho, -0.5 * gap, 1.5 * gap)
    return np.vstack([one, legs[0], bight, legs[1], other])


def bent(points: Floats, radius: float) -> Floats:
    """Return points about a straight post as they lie about a ring of that radius in the y-z plane, (m, 3).

    The post's axis becomes the ring's middle line; its centre is at y = radius, and the feet lie outside.
    """
    x, y, z = points.T
    angle = z / radius
    return np.stack(
        (x, radius - (radius - y) * np.cos(angle), (radius - y) * np.sin(angle)), axis=1
    )
