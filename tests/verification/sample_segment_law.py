"""A law of segments for tests and for whoever writes one: a stiffening fibre, and a spring behind a damper.

Beside the spring, with e = r - L and s the share of the length that the damper has taken,
    T = a e^3 + b (r - s),   s' = (r - s) / tau,   U = a e^4 / 4 + b (r - s)^2 / 2.
The length is taken as linear in time since the last accepted step: second order in every method.
`test_added_segment_law` puts this file into a copy of the package, as `ropewalk/laws/fibre.py`.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.core.jit import part, small
from ropewalk.laws.segment_law import SegmentLaw, along, of_segments

TRUE_SHARE = 1.0  # of the slope in the tangent; the twin has less


class Fibre(NamedTuple):
    """The fibres of all segments; all (0,) where no rope has any."""

    cubic: Floats  # (s,) a [N/m^3]
    arm: Floats  # (s,) b [N/m]
    time: Floats  # (s,) tau [s]
    reach: Floats  # (s,) [m] no segment is stretched by more


class Kept(NamedTuple):
    """What the fibres remember."""

    length: Floats  # (s + 1,) [m] at the last accepted step
    damper: Floats  # (s + 1,) s [m]


def lower(fibres: tuple[Any, ...], layout: Any) -> Fibre:
    """Return the table of what every rope has as its fibre, or None."""
    if all(one is None for one in fibres):
        return Fibre(*(np.zeros(0) for _ in Fibre._fields))
    columns = ("cubic", "arm", "time", "reach")
    return Fibre(
        *(along(layout, tuple(getattr(one, name, 0.0) for one in fibres)) for name in columns)
    )


def acts(fibre: Fibre) -> bool:
    """Tell whether any fibre pulls."""
    return bool((fibre.cubic > 0.0).any() or (fibre.arm > 0.0).any())


@small
def move(length, damper, r, share):
    """Return s after a step, and its derivative by the length `r` at the end; `share` is time over tau."""
    if not share > 0.0:
        return damper, 0.0
    gone = -math.expm1(-share)
    late = 1.0 - gone / share
    return damper + gone * (length - damper) + late * (r - length), late


@small
def at(cubic, arm, time, rest, length, damper, r, since):
    """Return pull [N], slope [N/m] and energy [J] at length `r`, so long `since` the last step [s]."""
    e, found, late = r - rest, damper, 0.0
    if arm > 0.0:
        found, late = move(length, damper, r, since / time)
    pull = cubic * e * e * e + arm * (r - found)
    slope = TRUE_SHARE * (3.0 * cubic * e * e + arm * (1.0 - late))
    return pull, slope, 0.25 * cubic * e * e * e * e + 0.5 * arm * (r - found) * (r - found)


@part
def pull(fibre, state, j, r, rate):
    """Return the pull, its slope by length and its slope by rate."""
    kept, rest, since = state.memory.fibre, state.rest_length[j], state.now[0] - state.now[1]
    a, b, tau = fibre.cubic[j], fibre.arm[j], fibre.time[j]
    known = at(a, b, tau, rest, kept.length[j], kept.damper[j], r, since)
    return known[0], known[1], 0.0


@part
def energy(fibre, state, j, r):
    """Return what a segment's fibre stores [J]."""
    kept, rest, since = state.memory.fibre, state.rest_length[j], state.now[0] - state.now[1]
    a, b, tau = fibre.cubic[j], fibre.arm[j], fibre.time[j]
    known = at(a, b, tau, rest, kept.length[j], kept.damper[j], r, since)
    return known[2]


def memory(fibre: Fibre, lengths: Floats) -> Kept:
    """Return that the rope has long been as it is: nothing is left in the springs before the dampers."""
    if not fibre.arm.size:
        return Kept(np.zeros(0), np.zeros(0))
    start = np.append(lengths, 0.0)
    return Kept(start, start.copy())


@part
def remember(fibre, state, j, r):
    """Take the damper through the step, and keep the length."""
    kept = state.memory.fibre
    if fibre.arm[j] > 0.0:
        share = (state.now[0] - state.now[1]) / fibre.time[j]
        found = move(kept.length[j], kept.damper[j], r, share)
        kept.damper[j] = found[0]
    kept.length[j] = r


def relaxed(fibre: Fibre) -> Fibre:
    """Return the fibres alone: at rest the dampers have taken all."""
    return fibre._replace(arm=np.zeros_like(fibre.arm))


def most(fibre: Fibre, lengths: Floats) -> tuple[Floats, Floats]:
    """Return the largest slope within reach; there is no friction."""
    return 3.0 * fibre.cubic * fibre.reach**2 + fibre.arm, np.zeros_like(fibre.arm)


FIBRE = of_segments(
    SegmentLaw(
        name="fibre",
        section="fibre",
        lower=lower,
        acts=acts,
        pull=pull,
        most=most,
        energy=energy,
        memory=memory,
        remember=remember,
        relaxed=relaxed,
    )
)
