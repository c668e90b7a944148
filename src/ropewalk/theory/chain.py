"""The exact rest shape of a chain of masses and springs (or rigid links) between two points.

The segments between two held nodes carry the force vectors t_i = (H, V_i) with H constant and
V_{i+1} = V_i + m_i g (the funicular polygon). A segment of stiffness k and rest length L under the
tension T = |t| has the length L + T/k along t, so that the closing conditions

    sum (L_i + T_i/k_i) H / T_i = X        sum (L_i + T_i/k_i) V_i / T_i = Y

are two equations for (H, V_1). They are the gradient of the complementary energy
sum (L T + T^2 / 2k) - H X - V_1 Y, which is convex, so there is one solution. It is found by damped
Newton steps in the tension and the slope of the lowest segment, in which the equations stay smooth
when that segment goes slack. Nothing is approximated: the result is the equilibrium of the masses
and springs. Rigid links are springs of infinite k.

Source: Irvine, Cable Structures (1981), ch. 1, for the continuum; elementary statics.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ropewalk.theory.catenary import parameter
from ropewalk.theory.given import need_ends
from ropewalk.words.annotations import unquoted

Floats = NDArray[np.float64]


@unquoted
class Hung(NamedTuple):
    """A chain of s segments at rest, in the upright plane through its two ends."""

    along: Floats  # (s,) horizontal length of each segment [m]
    upward: Floats  # (s,) vertical length of each segment [m]
    tension: Floats  # (s,) [N]
    horizontal: float  # H [N]
    vertical: Floats  # (s,) V_i [N], upward part of the force towards the next node

    @property
    def positions(self) -> Floats:
        """Places of the s + 1 nodes, across and up from the first one [m], (s + 1, 2)."""
        steps = np.stack([self.along, self.upward], axis=1)
        return np.concatenate([np.zeros((1, 2)), np.cumsum(steps, axis=0)])


def lumped_chain(
    weights: ArrayLike, stiffness: ArrayLike, length: ArrayLike, across: float, rise: float = 0.0
) -> Hung:
    """Return the exact equilibrium of a chain of point weights between two points.

    Args:
        weights: of the s - 1 nodes between the ends [N], not negative; 0 beside others counts as 1e-9 of the
            largest, which decides where what hangs loose lies.
        stiffness: of the segments [N/m], (s,) or one for all; inf makes them rigid links.
        length: rest length of the segments [m], (s,) or one for all.
        across: horizontal distance of the ends [m].
        rise: how much higher the second end is [m].

    A spring alone that is longer than the distance of the ends is pressed: its tension is negative.

    Raises ValueError for rigid links that do not reach, or one alone that does not fit, for shapes that do
    not fit, and for numbers that are not positive.

    Source: the funicular polygon; Irvine, Cable Structures (1981), ch. 1, for the continuum.
    """
    weights = np.atleast_1d(np.asarray(weights, dtype=np.float64))
    segments = weights.size + 1
    need_ends(across, rise)
    try:
        k = np.broadcast_to(np.asarray(stiffness, dtype=np.float64), (segments,))
        rest = np.broadcast_to(np.asarray(length, dtype=np.float64), (segments,))
    except ValueError:
        rule = f"must be one number or {segments}, one more than the weights"
        raise ValueError(f"stiffness, length: {rule}") from None
    if not np.all(k > 0.0):
        raise ValueError("stiffness: must be positive")
    if not (np.all(rest >= 0.0) and np.all(np.isfinite(rest))):
        raise ValueError("length: must be finite and not negative")
    if not (np.all(weights >= 0.0) and np.all(np.isfinite(weights))):
        raise ValueError("weights: must be finite and not negative")
    distance = math.hypot(across, rise)
    if segments == 1 and math.isinf(k[0]) and rest[0] > distance * (1.0 + 1e-9):
        raise ValueError(
            f"length: {rest[0]:g} m - must be the distance of the ends, {distance:g} m: one rigid link alone "
            "does not turn aside"
        )
    carried: Floats = np.maximum(weights, 1e-9 * weights.max(initial=0.0))
    return hang(carried, k, rest, across, rise)


def hanging_chain(weights: ArrayLike, stiffness: ArrayLike, length: ArrayLike) -> Hung:
    """Return the equilibrium of a chain that hangs straight down from its first node.

    Args:
        weights: of the s nodes below the first one [N].
        stiffness: of the segments [N/m], (s,) or one for all; inf makes them rigid links.
        length: rest length of the segments [m], (s,) or one for all.

    Segment i carries all weights below it: T_i = sum of w_j, j >= i, and is L_i + T_i/k_i long
    (Timoshenko, Strength of Materials I).

    Source: elementary statics: every segment carries the weights below it.
    """
    weights = np.atleast_1d(np.asarray(weights, dtype=np.float64))
    tension: Floats = np.cumsum(weights[::-1])[::-1]
    size = np.asarray(length, dtype=np.float64) + tension / np.asarray(stiffness, dtype=np.float64)
    return Hung(np.zeros(weights.size), -size, tension, 0.0, -tension)


def hang(weights: Floats, stiffness: Floats, length: Floats, across: float, rise: float) -> Hung:
    """Return the rest shape of s segments between two points, as `lumped_chain` with arrays only.

    Args:
        weights: m g of the s - 1 nodes between [N], not negative.
        stiffness: of each segment [N/m].
        length: rest length of each segment [m].
        across: horizontal distance X between the ends [m], not negative.
        rise: Y, how much higher the second end is [m].

    Where no weight acts and the ends are closer than the segments reach, the shape is not
    determined; the segments then lie on the straight line, shortened alike, without tension.
    """
    carried = np.concatenate([[0.0], np.cumsum(weights)])
    reach = float(length.sum())
    distance = math.hypot(across, rise)
    rigid = bool(np.isinf(stiffness).all())
    if rigid and reach <= distance * (1.0 - 1e-12 * (length.size == 1)):
        raise ValueError(
            f"length: {reach:g} m - must be more than the distance of the ends, {distance:g} m: "
            "rigid links are not stretched"
        )
    if length.size == 1:
        size = max(distance, 1e-300)
        pull = 0.0 if rigid else float(stiffness[0]) * (distance - reach)
        ends = np.array([across]), np.array([rise])
        x, y = pull * across / size, pull * rise / size
        return Hung(*ends, np.array([pull]), x, np.array([y]))
    if carried[-1] == 0.0:
        return _weightless(stiffness, length, across, rise, reach, distance)
    if across <= 1e-13 * max(reach, distance):
        across = 0.0
    chain = _Chain(carried, stiffness, length, across, rise)
    lowest, gap = _lowest(chain)
    if math.hypot(across, gap) <= length[lowest]:
        return _slack(chain, lowest, gap)
    if across == 0.0:
        return _plumb(chain)
    return _solve(chain, lowest, gap)


class _Chain(NamedTuple):
    carried: Floats  # weight up to each segment [N]
    stiffness: Floats
    length: Floats
    across: float
    rise: float

    @property
    def softness(self) -> float:
        return float((1.0 / self.stiffness).sum())


def _weightless(
    stiffness: Floats, length: Floats, across: float, rise: float, reach: float, distance: float
) -> Hung:
    tension = max(distance - reach, 0.0)
    tension = tension / float((1.0 / stiffness).sum()) if tension > 0.0 else 0.0
    size = length + tension / stiffness
    if tension == 0.0:
        size = size * (distance / reach if reach > 0.0 else 0.0)
    x, y = (across / distance, rise / distance) if distance > 0.0 else (1.0, 0.0)
    force = np.full(length.size, tension)
    return Hung(size * x, size * y, force, tension * x, force * y)


def _lowest(chain: _Chain) -> tuple[int, float]:
    """Return the segment at the bottom of two plumb lines, and the height that it has to close.

    The others hang straight down from the two ends; with segment j at the bottom they leave the
    height gap_j = Y - sum of their own, which grows with j.
    """

    def gap(j: int) -> float:
        vertical = chain.carried - chain.carried[j]
        plumb = np.sign(vertical) * chain.length + vertical / chain.stiffness
        plumb[j] = 0.0
        return chain.rise - float(plumb.sum())

    low, high = 0, chain.length.size - 1
    while low < high:
        j = (low + high) // 2
        if gap(j) >= -chain.length[j]:
            high = j
        else:
            low = j + 1
    return low, gap(low)


def _slack(chain: _Chain, lowest: int, gap: float) -> Hung:
    """Two plumb lines, with one segment between their ends that is longer than their distance."""
    vertical = chain.carried - chain.carried[lowest]
    upward = np.sign(vertical) * chain.length + vertical / chain.stiffness
    upward[lowest] = gap
    along = np.zeros(vertical.size)
    along[lowest] = chain.across
    return Hung(along, upward, np.abs(vertical), 0.0, vertical)


def _plumb(chain: _Chain) -> Hung:
    """Both ends on one vertical: H = 0, the first j segments go down and the others up."""
    carried, stiffness, length = chain.carried, chain.stiffness, chain.length
    s = length.size
    below = np.concatenate([[0.0], np.cumsum(length)])
    missing = chain.rise - (below[-1] - 2.0 * below) - float((carried / stiffness).sum())
    first = missing / chain.softness
    # How far the sign of any segment's force contradicts its direction; 0 for the right j.
    wrong = np.zeros(s + 1)
    wrong[1:] = np.maximum(first[1:] + carried, 0.0)
    wrong[:-1] = np.maximum(wrong[:-1], -(first[:-1] + carried))
    j = int(np.argmin(wrong))
    vertical = first[j] + carried
    upward = np.where(np.arange(s) < j, -1.0, 1.0) * length + vertical / stiffness
    return Hung(np.zeros(s), upward, np.abs(vertical), 0.0, vertical)


def _solve(chain: _Chain, lowest: int, gap: float) -> Hung:
    """Solve for the tension and slope of the lowest segment."""
    horizontal, first = _descend(chain, *_start(chain))
    for j, h, v in (
        (int(np.argmin(np.abs(first + chain.carried))), horizontal, first),
        _just_taut(chain, lowest, gap),
    ):
        found = _hung(chain, j, *_newton(chain, j, h, v))
        left = math.hypot(found.along.sum() - chain.across, found.upward.sum() - chain.rise)
        size = float((chain.length + np.abs(found.tension) / chain.stiffness).sum())
        if left <= 1e-11 * (size + chain.across + abs(chain.rise)):
            return found
    raise ArithmeticError(f"the rest shape did not close: {left:.3g} m are left open")


def _just_taut(chain: _Chain, lowest: int, gap: float) -> tuple[int, float, float]:
    """Guess (H, V_1) of two plumb lines that the segment between them pulls a little together."""
    cosine, sine = chain.across, gap
    size = math.hypot(cosine, sine)
    cosine, sine = cosine / size, sine / size
    offset = np.delete(chain.carried - chain.carried[lowest], lowest)
    turning = float((np.delete(chain.length, lowest) / np.abs(offset)).sum())
    pull = (size - float(chain.length[lowest])) / (turning * cosine**2 + chain.softness)
    return lowest, pull * cosine, pull * sine - float(chain.carried[lowest])


def _hung(chain: _Chain, lowest: int, pull: float, slope: float) -> Hung:
    offset = chain.carried - chain.carried[lowest]
    horizontal, vertical = pull * math.cos(slope), pull * math.sin(slope) + offset
    tension = np.hypot(horizontal, vertical)
    tension[lowest] = pull
    ratio = chain.length / np.maximum(tension, 1e-300) + 1.0 / chain.stiffness
    along, upward = horizontal * ratio, vertical * ratio
    bottom = chain.length[lowest] + pull / chain.stiffness[lowest]
    along[lowest], upward[lowest] = bottom * math.cos(slope), bottom * math.sin(slope)
    return Hung(along, upward, tension, horizontal, vertical)


def _descend(chain: _Chain, horizontal: float, first: float) -> tuple[float, float]:
    """Return (H, V_1) near the least complementary energy, by damped Newton steps."""
    length, soft = chain.length, 1.0 / chain.stiffness

    def energy(h: float, v: float) -> float:
        tension = np.hypot(h, v + chain.carried)
        stored = float((tension * (length + 0.5 * soft * tension)).sum())
        return stored - h * chain.across - v * chain.rise

    here = energy(horizontal, first)
    for _ in range(200):
        vertical = first + chain.carried
        tension = np.maximum(np.hypot(horizontal, vertical), 1e-300)
        ratio = length / tension + soft
        f = horizontal * float(ratio.sum()) - chain.across
        g = float((vertical * ratio).sum()) - chain.rise
        bend = length / tension**3
        hh = float((bend * vertical * vertical).sum()) + chain.softness
        hv = -float((bend * vertical).sum()) * horizontal
        vv = float(bend.sum()) * horizontal * horizontal + chain.softness
        determinant = hh * vv - hv * hv
        if not (math.isfinite(determinant) and determinant > 0.0):
            break
        dh, dv = -(vv * f - hv * g) / determinant, -(hh * g - hv * f) / determinant
        slope, factor = f * dh + g * dv, 1.0
        while factor > 1e-12:
            there = energy(horizontal + factor * dh, first + factor * dv)
            if there <= here + 1e-4 * factor * slope:
                break
            factor *= 0.5
        else:
            break
        horizontal, first = horizontal + factor * dh, first + factor * dv
        if here - there <= 1e-14 * abs(here):
            break
        here = there
    return abs(horizontal), first


def _newton(chain: _Chain, j: int, horizontal: float, first: float) -> tuple[float, float]:
    """Return the tension [N] and slope [rad] of segment j that close the chain best."""
    vertical = first + float(chain.carried[j])
    pull = max(math.hypot(horizontal, vertical), 1e-12 * float(chain.carried[-1]))
    slope = math.atan2(vertical, horizontal)
    offset = np.delete(chain.carried - chain.carried[j], j)
    others = _Chain(
        offset, np.delete(chain.stiffness, j), np.delete(chain.length, j), chain.across, chain.rise
    )
    own = float(chain.length[j]), 1.0 / float(chain.stiffness[j])
    rounding = 4.0 * float(np.finfo(float).eps) * float(chain.length.sum())
    f, g, jacobian = _closing(others, own, pull, slope)
    for _ in range(100):
        size = math.hypot(f, g)
        (a, b), (c, d) = jacobian
        determinant = a * d - b * c
        if determinant == 0.0 or not math.isfinite(determinant):
            break
        dp, ds = -(d * f - b * g) / determinant, -(a * g - c * f) / determinant
        factor = 1.0
        if dp < -0.9 * pull:
            factor = -0.9 * pull / dp
        room = 0.5 * math.pi - abs(slope)
        if ds * slope > 0.0 and abs(ds) * factor > 0.9 * room:
            factor = 0.9 * room / abs(ds)
        for _ in range(40):
            trial = pull + factor * dp, slope + factor * ds
            if trial == (pull, slope):
                return trial
            if abs(trial[1]) < 0.5 * math.pi:
                f, g, jacobian = _closing(others, own, *trial)
                if math.hypot(f, g) < size:
                    break
                if size <= rounding:
                    return pull, slope
            factor *= 0.5
        else:
            break
        pull, slope = trial
    return pull, slope


def _closing(
    others: _Chain, own: tuple[float, float], pull: float, slope: float
) -> tuple[float, float, tuple[tuple[float, float], tuple[float, float]]]:
    """Return what is left open, across and in height [m], and its derivatives."""
    cosine, sine = math.cos(slope), math.sin(slope)
    horizontal = pull * cosine
    vertical = pull * sine + others.carried
    tension = np.hypot(horizontal, vertical)
    soft = 1.0 / others.stiffness
    ratio = others.length / tension + soft
    bend = others.length / tension**3
    size = own[0] + pull * own[1]
    f = horizontal * float(ratio.sum()) + size * cosine - others.across
    g = float((vertical * ratio).sum()) + size * sine - others.rise
    slack = float(soft.sum())
    hh = float((bend * vertical * vertical).sum()) + slack
    hv = -float((bend * vertical).sum()) * horizontal
    vv = float(bend.sum()) * horizontal * horizontal + slack
    first = (
        hh * cosine + hv * sine + cosine * own[1],
        pull * (hv * cosine - hh * sine) - size * sine,
    )
    second = (
        hv * cosine + vv * sine + sine * own[1],
        pull * (vv * cosine - hv * sine) + size * cosine,
    )
    return f, g, (first, second)


def _start(chain: _Chain) -> tuple[float, float]:
    """Guess (H, V_1): the catenary of the same weight, or the taut cord that sags by stretching."""
    reach, distance = float(chain.length.sum()), math.hypot(chain.across, chain.rise)
    weight, across, soft = float(chain.carried[-1]), chain.across, chain.softness
    taut = (distance - reach) / soft if distance > reach else 0.0
    # H^3 = k w^2 X^2 / 24 of a cord whose ends are its own length apart (Irvine, sec. 2).
    cord = max((weight**2 * across / soft / 24.0) ** (1.0 / 3.0), taut) if soft else math.inf
    if reach <= 1.02 * distance and soft:
        return cord * across / distance, -0.5 * weight + cord * chain.rise / distance
    a = parameter(reach, across, chain.rise)
    horizontal = min(max(weight / reach * a, 1e-12 * weight), cord)
    return horizontal, 0.5 * weight * (chain.rise / reach - 1.0)
