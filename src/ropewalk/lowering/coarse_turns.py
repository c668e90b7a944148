"""How far tensions err where a rope with friction turns on few nodes.

A node that turns by a [rad], pressed along the normal n, slips one way at the ratio of tensions
    cos(a/2 + e - p) / cos(a/2 - e + p),   tan p = mu', see `contact`,
e the angle of n off the middle of the turn. With e = 0 that is exp(mu a), as on a curve. The first and the
last node on a round have e != 0, which depends on how far from its begin they happen to lie: with d the angle
of a segment on it they turn by a in (0, d) with e = -(d - a)/2 and (d - a)/2. The worst is, for small d,
    d^2/8 of the logarithm of the ratio, with a = d/2 at one end and all at the other.
Where flat faces lead to an edge, nodes on them are pressed, too, and turn by what the next segment cuts off:
they have e = -a/2 before it and a/2 after it. That has no short form, all phases are tried. What is said is
the worst of all: a rope that moves on meets it, and one at rest may have.
"""

from __future__ import annotations

import math
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats, Ints
from ropewalk.laws.obstacle import Obstacles
from ropewalk.laws.obstacle_places import surface_near
from ropewalk.laws.obstacle_shapes import BOX, HALF_PIPE, MESH, PLANE
from ropewalk.laws.triangles import ROUNDING
from ropewalk.lowering.touching import Contacts
from ropewalk.words.percents import percent
from ropewalk.words.safe_side import percent_up, rounded_down, rounded_up

ALLOWED = math.log(1.03)  # of what goes unsaid: a ratio that errs by 3 %
_LEVEL = 1e-3  # [rad] a node that turns by less lies straight
_FLAT = 1e-6  # [rad] a segment's angle on a surface that is flat along it
_RIGHT = 0.5 * math.pi  # [rad] of one edge
_FINE = 0.25  # [1] segment over radius below which edges are rounds
_PHASES, _HALVINGS = 121, 30
# Some lengths fit an edge better than shorter ones do, and are not trusted to: segments stretch.
_SHORTER = (1.0, 0.92, 0.84, 0.76)
_LEAST = 1e-4  # [1] of a segment: what is finer is no advice
_CUT = 1.6  # [1] way along an edge over its chord, at most


class CoarseTurn(NamedTuple):
    """How a stretch of a rope on an obstacle is resolved."""

    error: float = (
        0.0  # by how much the logarithm of the ratio of tensions may err [1], inf: no bound
    )
    segment: float = 0.0  # length of the rope's segments as they are made [m]
    wanted: float = math.inf  # ... with which the ratio errs by 3 % at most [m]

    @property
    def is_told(self) -> bool:
        """Whether it errs by more than 3 %."""
        return self.error > ALLOWED

    @property
    def most(self) -> str:
        """By how much the ratio of tensions may err, in words, never too little."""
        if math.isinf(self.error):
            return "without bound"
        factor = math.exp(self.error)
        if factor >= 1.5:
            return f"by a factor of up to {rounded_up(factor, 2)}"
        return f"by up to {percent_up(100.0 * (factor - 1.0))}"

    @property
    def remedy(self) -> str:
        """With which segments it errs by 3 % at most, in words."""
        least = percent(100.0 * math.expm1(ALLOWED), 2)
        return (
            f"take segments of at most {rounded_down(1e3 * self.wanted)} mm in place of "
            f"{1e3 * self.segment:.4g} mm, and it is {least} at most"
        )


FINE = CoarseTurn()


class _Turn(NamedTuple):
    """Nodes side by side that turn, as an arc."""

    step: float  # longest segment there over the radius [1]
    angle: float  # of all [rad], of an edge at most a right angle
    edges: int  # how many such there are
    flat: bool  # whether flat faces lead to it


def coarse_turn(
    table: Obstacles,
    contacts: Contacts,
    rows: Ints,
    x: Floats,
    friction: float,
    segment: float,
    t: float = 0.0,
) -> CoarseTurn:
    """Return how a stretch of a rope is resolved, from rows of its contacts with one obstacle.

    At places `x` (3, n) [m] and time `t` [s]; `segment` is the length of its segments as they are made [m].
    """
    if not friction > 0.0 or not (contacts.turn[rows] > _LEVEL).any():
        return CoarseTurn(segment=segment)
    found = _turns(table, contacts, rows, x, t)

    def error(share: float) -> float:
        return sum(one.edges * _worst(share * one.step, one, friction) for one in found)

    whole, share = error(1.0), 1.0
    while error(share) > ALLOWED and share > _LEAST:
        share *= 0.93
    return CoarseTurn(whole, segment, share * segment if share < 1.0 else math.inf)


def _turns(table: Obstacles, contacts: Contacts, rows: Ints, x: Floats, t: float) -> list[_Turn]:
    """Return the turns of a stretch; of a plane or a trough, which no rope is drawn over, none."""
    o, nodes = int(contacts.obstacle[rows[0]]), contacts.node[rows]
    kind = int(table.kind[o])
    if kind in (PLANE, HALF_PIPE):
        return []
    bends, gaps = np.array([_bend(table, o, x, int(i), t) for i in nodes]).T
    turn, normal = contacts.turn[rows], contacts.normal[rows]
    edge = {BOX: 3, MESH: int(ROUNDING)}.get(kind)
    rounded = 0.0 if edge is None else float(table.size[o, edge])
    turning, found = np.flatnonzero(turn > _LEVEL), []
    for run in np.split(turning, np.flatnonzero(np.diff(nodes[turning]) > 2) + 1):
        ends = np.stack([nodes[run] - 1, nodes[run]])
        length = float(np.linalg.norm(x[:, ends + 1] - x[:, ends], axis=0).max())
        near = np.arange(max(run[0] - 1, 0), min(run[-1] + 2, len(rows)))
        flat = bool((bends[near] * length < _FLAT).any())
        angle, most = float(turn[run].sum()), float(bends[run].max())
        sharp = rounded + max(float(gaps[run].min()), 0.0)  # as far as nodes are pressed in
        radius = 1.0 / most if most * length > _FLAT else sharp
        edges = max(math.ceil(angle / _RIGHT - 0.05), 1) if flat else 1
        if kind == MESH:  # many a facet: how far it turns from one node to the next
            facing = (normal[near][1:] * normal[near][:-1]).sum(axis=1)
            between = float(np.arccos(np.clip(facing, -1.0, 1.0)).max(initial=0.0))
            angle, edges, flat = max(float(turn[run].max()), between), 1, True
            radius = sharp
        step = length / radius if radius > 0.0 else math.inf
        found.append(_Turn(step, min(angle / edges, _RIGHT) if flat else angle, edges, flat))
    return found


def _bend(table: Obstacles, o: int, x: Floats, i: int, t: float) -> tuple[float, float]:
    """Return how much a surface is bent along a rope at a node [1/m], 0: not towards it; and the gap [m]."""
    gap, nx, ny, nz, ax, ay, az, c, other = surface_near(table, o, x[:, i], t)
    along = x[:, min(i + 1, x.shape[1] - 1)] - x[:, max(i - 1, 0)]
    normal, across = np.array([nx, ny, nz]), np.array([ax, ay, az])
    along = along - normal * float(normal @ along)
    size = float(along @ along)
    if not size > 0.0:
        return 0.0, gap
    part = float(along @ across) ** 2 / size
    return max(float(c * (1.0 - part) + other * part), 0.0), gap


def _worst(step: float, turn: _Turn, friction: float) -> float:
    """Return the largest error of the logarithm of the ratio with such a segment over the radius [1]."""
    angle, flat = float(rounded_up(turn.angle)), turn.flat
    return max(_worst_of(float(rounded_up(n * step)), angle, friction, flat) for n in _SHORTER)


@lru_cache(maxsize=4096)
def _worst_of(step: float, angle: float, friction: float, flat: bool) -> float:
    found = _edge(step, angle, friction) if flat and step > _FINE else _round(step, angle, friction)
    return float(np.abs(found).max())


def _gain(into: Floats, out: Floats, normal: Floats, friction: float) -> Floats:
    """Return the logarithm of the ratio at which nodes slip; directions are angles from one way [rad]."""
    turn = out - into
    off, half = normal - 0.5 * (into + out), 0.5 * np.maximum(turn, 1e-9)
    holds = np.arctan(np.tanh(friction * half) / np.tan(half))
    before, after = 0.5 * turn + off - holds, 0.5 * turn - off + holds
    with np.errstate(invalid="ignore", divide="ignore"):
        found = np.log(np.cos(before) / np.cos(after))
    found = np.where(before >= _RIGHT, -np.inf, found)
    jams: Floats = np.where(after >= _RIGHT, np.inf, found)
    return jams


def _round(step: float, angle: float, friction: float) -> Floats:
    """Return how the logarithm of the ratio errs on a round, with one end as bad as it can be."""
    segment = 2.0 * math.asin(min(0.5 * step, 1.0))
    turn = np.linspace(0.0, min(angle, segment), _PHASES + 1)[1:]
    straight, end = np.zeros_like(turn), np.full_like(turn, 0.5 * segment)
    gain = [_gain(straight, turn, normal, friction) for normal in (end, turn - end)]
    found: Floats = np.array(gain) - friction * turn
    return found


def _edge(step: float, angle: float, friction: float) -> Floats:
    """Return how the logarithm of the ratio errs over an edge between flat faces, by phase."""
    s = _first_nodes(step, angle)
    into, gain = np.zeros_like(s), np.zeros_like(s)
    while (s < angle).any():
        (px, py), low, high = _on_edge(s, angle), s + 0.999 * step, s + _CUT * step
        for _ in range(_HALVINGS):
            middle = 0.5 * (low + high)
            qx, qy = _on_edge(middle, angle)
            short = np.hypot(qx - px, qy - py) < step
            low, high = np.where(short, middle, low), np.where(short, high, middle)
        qx, qy = _on_edge(high, angle)
        out = np.where(s >= angle, angle, np.maximum(np.arctan2(py - qy, qx - px), into))
        gain += _gain(into, out, np.clip(s, 0.0, angle), friction)
        into, s = out, high
    gain += _gain(into, np.full_like(s, angle), np.full_like(s, angle), friction)
    found: Floats = gain - friction * angle
    return found


def _first_nodes(step: float, angle: float) -> Floats:
    """Return where the last node on the first face may be, as ways to the edge's begin over the radius [1].

    Evenly, and so that the next one is on the edge, which of a small one would else be missed.
    """
    on_it = np.linspace(0.0, angle, _PHASES)
    rise = 1.0 - np.cos(on_it)
    reaches = step > rise
    back = np.sqrt(np.maximum(step**2 - rise**2, 0.0)) - np.sin(on_it)
    reaches &= (back >= 0.0) & (back < step)
    return np.concatenate([-step * np.linspace(0.0, 1.0, _PHASES), -back[reaches]])


def _on_edge(s: Floats, angle: float) -> tuple[Floats, Floats]:
    """Return places on a face, an edge of radius 1 and the next face, by the way from the edge's begin."""
    arc, before, after = np.clip(s, 0.0, angle), np.minimum(s, 0.0), np.maximum(s - angle, 0.0)
    x = np.sin(arc) + before + after * math.cos(angle)
    return x, np.cos(arc) - after * math.sin(angle)
