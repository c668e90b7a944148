"""An elastic law for tests and for whoever writes one: a rope that softens as it stretches, and relaxes.

    g = (1 - a) h + a (e - d),   e = h + b h^2 for h > 0, else h;   d' = (e - d) / tau
    G = (1 - a) (h^2 / 2 + 2 b h^3 / 3) + a (e - d)^2 / 2

Both g of e and e of g are closed forms. `test_added_elastic_law` puts this file into a copy of the package,
as `ropewalk/laws/soft.py`.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.core.jit import part, small
from ropewalk.laws.elastic_law import ElasticLaw
from ropewalk.laws.segment_law import along

TRUE_SHARE = 1.0  # of the slope in the tangent; the twin has less


class Soft(NamedTuple):
    """What softens, by segment; 0 where nothing does."""

    bend: Floats  # (s,) b [1]
    arm: Floats  # (s,) a [1]
    late: Floats  # (s,) tau [s], inf without an arm
    reach: Floats  # (s,) [1] no segment is strained by more


def says(rope: Any) -> tuple[float, ...] | None:
    """Return the numbers of a rope's section."""
    own = getattr(rope, "soft", None)
    return None if own is None else (own.bend, own.arm, own.time, own.reach)


def lower(said: tuple[Any, ...], layout: Any) -> Soft:
    """Return the table of what every rope says."""
    b, a, time, reach = (
        along(layout, tuple(0.0 if one is None else one[k] for one in said)) for k in range(4)
    )
    return Soft(b, a, np.where(a > 0.0, time, math.inf), reach)


@small
def softened(bend, strain):
    """Return h, its slope and its energy at a strain [1]."""
    if strain <= 0.0 or bend == 0.0:
        return strain, 1.0, 0.5 * strain * strain
    root = math.sqrt(1.0 + 4.0 * bend * strain)
    h = 2.0 * strain / (1.0 + root)
    return h, 1.0 / root, h * h * (0.5 + 2.0 / 3.0 * bend * h)


@part
def pull(soft, j, strain, inner, c):
    """Return g, its slope and G."""
    follows = 1.0 + c / soft.late[j]
    a, shift = soft.arm[j], strain - inner
    h, slope, stored = softened(soft.bend[j], strain)
    own = a / follows
    return (
        (1.0 - a) * h + own * shift,
        (1.0 - a) * slope + own,
        (1.0 - a) * stored + 0.5 * own * shift * shift / follows,
    )


@part
def strain(soft, j, pull, inner, c):
    """Return the strain of g and the slope there: own b h^2 + (1 - a + own) h = g + own d."""
    a, b = soft.arm[j], soft.bend[j]
    own = a / (1.0 + c / soft.late[j])
    whole, line = pull + own * inner, 1.0 - a + own
    h, e, slope = whole / line, whole / line, line
    if whole > 0.0:
        h = 2.0 * whole / (line + math.sqrt(line * line + 4.0 * own * b * whole))
        e, slope = h + b * h * h, (1.0 - a) / (1.0 + 2.0 * b * h) + own
    return e, TRUE_SHARE * slope


@part
def rate(soft, j, strain, inner, c):
    """Return d'."""
    return (strain - inner) / (soft.late[j] + c)


@part
def heat(soft, j, change, dt):
    """Return what the damper takes."""
    return soft.arm[j] * soft.late[j] * change * change / dt if soft.arm[j] > 0.0 else 0.0


def least(soft: Soft) -> Floats:
    """Return the slope at the end of the reach."""
    slope: Floats = (1.0 - soft.arm) / np.sqrt(1.0 + 4.0 * soft.bend * soft.reach)
    return slope


SOFT = ElasticLaw(
    name="soft",
    says=says,
    lower=lower,
    pull=pull,
    strain=strain,
    least=least,
    time=lambda soft: soft.late,
    rate=rate,
    heat=heat,
)
