"""A mass that falls into a rope that relaxes, the standard linear solid, and the rope that a label describes.

    m x'' = m g - F,   F L = EA x + EA1 (x - q),   q' = (x - q) / tau,
    x(0) = q(0) = 0,   x'(0) = sqrt(2 g h)

x is the stretch [m], q that of the arm's damper, from the moment when the rope is straight until it is slack
again; the rope's own mass is left out. The motion about rest is a sum of three exponentials exp(r t),
    r^3 + r^2 / tau + r (EA + EA1) / (m L) + EA / (m L tau) = 0 ,
whose largest stretch and force are found on a grid of times, and between two of them. A rope that is never
slack swings about a place that creeps towards rest, so a later top may be the highest: tops lie under
    x_rest + A exp(-b t) + C exp(-c t),   b, c the decay of the swing and of the creep,
which for C < 0 and b < c is highest at exp((c - b) t) = -c C / (b A), later than the grid where tau is long.
Source: Findley, Lai & Onaran, Creep and Relaxation of Nonlinear Viscoelastic Materials, ch. 5; for climbing
ropes Pavier, Sports Engineering 1 (1998) 79.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ropewalk.theory.given import need
from ropewalk.words.safe_side import inwards, rounded_down, within

if TYPE_CHECKING:
    from ropewalk.core.arrays import Floats

_FALL_FACTOR, _LENGTH = 1.77, 2.8  # of EN 892 [1], [m]
_ROUNDS = 80  # of a search for a root, at most
_TIMES = np.concatenate([[0.0], np.geomspace(1e-6, 0.05, 60), np.linspace(0.055, 3.0, 300)])


@dataclass(frozen=True)
class SolidFall:
    """What a fall does to a rope that relaxes, and to its fixed point."""

    force: float  # largest force on the fixed point [N]
    stretch: float  # largest stretch of the rope over its length [1]
    time_of_force: float  # after the rope is straight [s]
    time_of_stretch: float  # [s]; inf where the rope creeps on to rest
    time_of_slack: float  # when it carries nothing again [s]
    returned: float  # kinetic energy of the mass then, over the work of its weight to the lowest point [1]

    def __repr__(self) -> str:
        return (
            f"SolidFall: {self.force:.4g} N on the fixed point, stretched by {100 * self.stretch:.3g} %, "
            f"{100 * self.returned:.3g} % of the energy returned."
        )


def root_of(f: Callable[[float], float], low: float, high: float) -> float:
    """Return where `f` is zero between two places with values of different signs, to rounding.

    Source: Illinois rule, Dahlquist & Bjorck, Numerical Methods in Scientific Computing I, 6.2.2.
    """
    at_low, at_high, side, middle = f(low), f(high), 0, low
    for _ in range(_ROUNDS):
        if at_low == at_high:
            break
        middle = (low * at_high - high * at_low) / (at_high - at_low)
        value = f(middle)
        if abs(high - low) <= 1e-13 * (abs(low) + abs(high)) or value == 0.0:
            break
        if (value > 0.0) == (at_high > 0.0):
            at_low = 0.5 * at_low if side == 1 else at_low
            if abs(high - middle) <= 1e-13 * abs(middle):
                break
            high, at_high, side = middle, value, 1
        else:
            at_high = 0.5 * at_high if side == -1 else at_high
            if abs(middle - low) <= 1e-13 * abs(middle):
                break
            low, at_low, side = middle, value, -1
    return middle


class _Motion:
    """The sum of exponentials: rows of shapes are x, x', q about rest."""

    def __init__(
        self,
        EA: float,
        arm: float,
        time: float,
        mass: float,
        factor: float,
        length: float,
        g: float,
    ) -> None:
        k, k1 = EA / length, arm / length
        matrix = np.array(
            [[0.0, 1.0, 0.0], [-(k + k1) / mass, 0.0, k1 / mass], [1.0 / time, 0.0, -1.0 / time]]
        )
        self.rest, self.k, self.k1, self.length = mass * g / k, k, k1, length
        self.speed = math.sqrt(2.0 * g * factor * length)
        self.roots, shapes = np.linalg.eig(matrix)
        start = np.array([-self.rest, self.speed, -self.rest])
        self.terms = shapes * np.linalg.solve(shapes, start)
        self.times = _TIMES * 2.0 * math.pi * math.sqrt(mass / k)

    def at(self, t: Floats, order: int = 0) -> Floats:
        """Return stretch [m], speed [m/s] and the damper's stretch [m], or their derivatives, (3, ...)."""
        decays = self.roots[:, None] ** order * np.exp(np.multiply.outer(self.roots, t))
        found: Floats = (self.terms @ decays).real
        if order == 0:
            found[0] += self.rest
            found[2] += self.rest
        return found

    def force(self, t: Floats, order: int = 0) -> Floats:
        """Return the force of the rope [N], or its derivative."""
        x, _, q = self.at(t, order)
        return np.asarray(self.k * x + self.k1 * (x - q))

    def swings(self) -> Floats:
        """Return times [s] between which a rope that is never slack is longest: a grid, and a later one."""
        creep = int(np.argmin(np.abs(self.roots.imag)))
        swing = int(np.argmax(self.roots.imag))
        c, b = -float(self.roots[creep].real), -float(self.roots[swing].real)
        C, A = float(self.terms[0, creep].real), 2.0 * abs(self.terms[0, swing])
        if not (self.roots[swing].imag > 0.0 and 0.0 < b < c and C < 0.0 and A > 0.0):
            return self.times
        period = 2.0 * math.pi / float(self.roots[swing].imag)
        middle = math.log(-c * C / (b * A)) / (c - b)
        window = middle + period * np.linspace(-1.5, 1.5, 301)
        return np.unique(np.concatenate([self.times, window[window > 0.0]]))

    def longest(self) -> tuple[float, float]:
        """Return the largest stretch of a rope that is never slack [m], and when [s]: at rest inf."""
        found = self.rest, math.inf
        times = self.swings()
        speed = self.at(times)[1]
        for i in np.flatnonzero((speed[1:] <= 0.0) & (speed[:-1] > 0.0)):
            time = self._fall_of(lambda t: np.asarray(self.at(t)[1]), times[i], times[i + 1])
            found = max(found, (float(self.at(np.array([time]))[0, 0]), time))
        return found

    @staticmethod
    def _fall_of(what_at: Callable[[Floats], Floats], low: float, high: float) -> float:
        return root_of(lambda t: float(what_at(np.array([t]))[0]), float(low), float(high))

    def first(self, what_at: Callable[[Floats], Floats]) -> float:
        """Return the first time after zero at which something falls through zero [s], inf: it does not."""
        what = what_at(self.times)
        falls = np.flatnonzero((what[1:] <= 0.0) & (what[:-1] > 0.0))
        if not falls.size:
            return math.inf
        return self._fall_of(what_at, self.times[falls[0]], self.times[falls[0] + 1])


def solid_fall(
    EA: float,
    relaxing_EA: float,
    relaxation_time: float,
    mass: float,
    *,
    factor: float = _FALL_FACTOR,
    length: float = _LENGTH,
    gravity: float = 9.81,
) -> SolidFall:
    """Return what a mass that falls into a rope that relaxes does.

    Args:
        EA: axial stiffness of the rope at rest [N].
        relaxing_EA: that of the arm beside it [N].
        relaxation_time: of the arm [s].
        mass: that falls [kg].
        factor: height of the free fall over the length of the rope [1].
        length: of the rope [m].
        gravity: [m/s^2].

    Raises ValueError for numbers that are not positive, and for a rope so lossy that its stretch has no top.

    Source: Findley, Lai & Onaran, Creep and Relaxation of Nonlinear Viscoelastic Materials, ch. 5.
    """
    need("EA", EA, "N")
    need("relaxing_EA", relaxing_EA, "N")
    need("relaxation_time", relaxation_time, "s")
    need("mass", mass, "kg")
    need("factor", factor, "1")
    need("length", length, "m")
    need("gravity", gravity, "m/s^2")
    motion = _Motion(EA, relaxing_EA, relaxation_time, mass, factor, length, gravity)
    longest = motion.first(lambda t: np.asarray(motion.at(t)[1]))
    hardest = motion.first(lambda t: motion.force(t, 1))
    if not math.isfinite(longest + hardest):
        raise ValueError(
            f"relaxing_EA: {relaxing_EA:g} - takes so much that the rope's stretch has no top"
        )
    slack, back = motion.first(motion.force), 0.0
    largest = float(motion.at(np.array([longest]))[0, 0]) / length
    if math.isfinite(slack):
        speed = float(motion.at(np.array([slack]))[1, 0])
        back = 0.5 * speed**2 / (gravity * length * (factor + largest))
    else:
        highest, time = motion.longest()
        if highest > largest * length:
            largest, longest = highest / length, time
    return SolidFall(
        float(motion.force(np.array([hardest]))[0]),
        largest,
        hardest,
        longest,
        slack,
        back,
    )


def solid_from_fall(
    force: float,
    stretch: float,
    EA: float,
    mass: float,
    *,
    factor: float = _FALL_FACTOR,
    length: float = _LENGTH,
    gravity: float = 9.81,
) -> tuple[float, float]:
    """Return the arm's EA [N] and relaxation time [s] with which a fall has this force and this stretch.

    Of all arms that give the stretch, the sooner one relaxes the less the force.

    Args:
        force: largest, on the fixed point [N].
        stretch: largest, over the rope's length [1].
        EA: axial stiffness of the rope at rest [N], such as a load over its static elongation.
        mass: that falls [kg].
        factor: height of the free fall over the length of the rope [1].
        length: of the rope [m].
        gravity: [m/s^2].

    Raises ValueError for numbers that are not positive, and for a force that no arm gives, with what may be.

    Source: as `solid_fall`.
    """
    given = (
        ("force", force, "N"),
        ("stretch", stretch, "1"),
        ("EA", EA, "N"),
        ("mass", mass, "kg"),
    )
    for name, value, unit in given:
        need(name, value, unit)
    whole = mass * gravity * (factor + stretch)  # work of the weight over the rope's length [N]
    if not 0.5 * EA * stretch * stretch < whole:
        raise ValueError(
            f"EA: {EA:g} - must be below {rounded_down(2.0 * whole / stretch**2, 4)} N to stretch so"
        )
    reach = 1e-6 * EA, 1e6 * whole / stretch

    def fall(arm: float, time: float) -> SolidFall:
        return solid_fall(EA, arm, time, mass, factor=factor, length=length, gravity=gravity)

    def arm_of(time: float) -> float:
        return find_arm(lambda arm: fall(arm, time).stretch, stretch, *reach)

    catch = math.sqrt(length * mass * stretch**2 / whole)  # a time of it [s]
    time = find_time(lambda time: fall(arm_of(time), time).force, force, catch)
    return arm_of(time), time


def find_time(force_of: Callable[[float], float], force: float, catch: float) -> float:
    """Return the relaxation time with which the force is this one [s]; a catch takes about `catch` [s].

    Raises ValueError for a force that none gives.
    """
    times = catch * np.geomspace(1e3, 1e-2, 31)
    forces: list[float] = []
    for one in times:
        forces.append(force_of(float(one)))
        if len(forces) > 1 and forces[-1] > forces[-2]:
            break
    least = int(np.argmin(forces))
    if not within(forces[least], force, forces[0]):
        above, below = inwards(forces[least], forces[0])
        raise ValueError(
            f"force: {force:g} - must be from {above} to {below} N: a rope that relaxes "
            "and has this EA and stretch has no other"
        )
    low, high = math.log(times[least]), math.log(times[0])
    force = min(max(force, forces[least]), forces[0])
    return math.exp(root_of(lambda size: force_of(math.exp(size)) - force, low, high))


def find_arm(
    stretch_of: Callable[[float], float], stretch: float, softest: float, stiffest: float
) -> float:
    """Return the arm between these two [N] that gives the stretch."""

    def too_long(size: float) -> float:
        try:
            return stretch_of(math.exp(size)) - stretch
        except ValueError:  # it creeps
            return -stretch

    return math.exp(root_of(too_long, math.log(softest), math.log(stiffest)))
