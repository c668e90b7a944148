"""Ropes that relax: a spring and a damper in series, the arm, beside the spring or curve of every segment.

    T = EA g(e) + EA1 (e - d),   d' = (e - d) / tau,   energy of the arm  EA1 L (e - d)^2 / 2

e the strain and d that of the arm's damper: the standard linear solid, where g is straight. `State.stiffness`
is (EA + EA1) / L, that of a sudden stretch; at rest d = e, and EA alone is left. Where d = d^ + c d',
    e - d = (e - d^) / (1 + c / tau):
the arm is a spring of EA1 / (1 + c / tau) about d^. The damper takes EA1 L tau (d1 - d0)^2 / h in a step of
h, the mean force times the way, as the ledger has it.
Source: Findley, Lai & Onaran, Creep and Relaxation of Nonlinear Viscoelastic Materials, ch. 5.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats, Ints
from ropewalk.core.jit import part, small
from ropewalk.laws.curved import at_strain, at_tension, least, of_each, pieces_of, put_together
from ropewalk.laws.elastic_law import ElasticLaw

_SHORT = 1e-3  # [1] a step over the relaxation time below which a series is exact


class Solid(NamedTuple):
    """Curves at rest and arms beside them, and which every segment has."""

    which: Ints  # (s,) -1: none
    first: Ints  # (c + 1,) where the pieces of a curve begin
    piece: Floats  # (p, 5), see `curved.Curve`
    arm: Floats  # (c,) slope of the arm [1]
    time: Floats  # (c,) [s]


@part
def pull(solid, j, strain, inner, c):
    """See `ElasticLaw.pull`."""
    which = solid.which[j]
    follows = 1.0 + c / solid.time[which]
    own, shift = solid.arm[which] / follows, strain - inner
    g, slope, stored = at_strain(solid.piece, solid.first, which, strain)
    return g + own * shift, slope + own, stored + 0.5 * own * shift * shift / follows


@part
def strain(solid, j, pull, inner, c):
    """See `ElasticLaw.strain`."""
    which = solid.which[j]
    own = solid.arm[which] / (1.0 + c / solid.time[which])
    return at_tension(solid.piece, solid.first, which, pull + own * inner, own)


@part
def rate(solid, j, strain, inner, c):
    """See `ElasticLaw.rate`."""
    return (strain - inner) / (solid.time[solid.which[j]] + c)


@part
def move(solid, j, inner, first, last, dt):
    """Take the damper through a step exactly, the strain being linear in time."""
    return moved(inner, first, last, dt / solid.time[solid.which[j]])


@small
def moved(inner, first, last, share):
    """Return d after a step of a `share` of the relaxation time."""
    gone = -math.expm1(-share)
    late = 1.0 - gone / share
    if share < _SHORT:
        late = share * (0.5 - share * (1.0 / 6.0 - share / 24.0))
    return inner + gone * (first - inner) + late * (last - first)


@part
def heat(solid, j, change, dt):
    """See `ElasticLaw.heat`."""
    which = solid.which[j]
    return solid.arm[which] * solid.time[which] * change * change / dt


def says(rope: Any) -> tuple[Floats, float, float] | None:
    """Return a rope's pieces at rest [N], (p, 5), and what relaxes beside them [N, s]."""
    made_of = rope.made_of
    if not rope.relaxes or made_of.relaxation_time is None:
        return None
    pieces = pieces_of(rope)
    if pieces is None:
        pieces = np.array([[0.0, 0.0, made_of.EA, 0.0, 0.0]])
    return pieces, made_of.relaxing_EA, made_of.relaxation_time


def lower(said: tuple[tuple[Floats, float, float] | None, ...], layout: Any) -> Solid:
    """Return the tables of what ropes say, over their stiffness for a sudden stretch."""
    curve = put_together(tuple(None if one is None else one[:2] for one in said), layout)
    arms = []
    for one in said:
        if one is not None:
            slope = float(one[0][:, 2].max())
            arms.append((one[1] / (slope + one[1]), one[2]))
    return Solid(*curve, *np.array(arms).reshape(-1, 2).T.copy())


SOLID = ElasticLaw(
    name="solid",
    says=says,
    lower=lower,
    pull=pull,
    strain=strain,
    least=least,
    time=lambda solid: of_each(solid.which, solid.time, math.inf),
    rate=rate,
    move=move,
    heat=heat,
)
