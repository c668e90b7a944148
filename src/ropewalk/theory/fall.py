"""A mass that falls into a rope: spring and damper side by side, between a fixed point and the mass.

    m x'' = m g - F,   F = EA x / L + c x' / L,   x(0) = 0,   x'(0) = sqrt(2 g h)

from the moment when the rope is straight until it is slack again; x is the stretch. The rope's own mass
is left out. With the complex root r of m r^2 + c r / L + EA / L = 0 the motion about the rest stretch is
the real part of C exp(r t), so that the times of the largest stretch and force are arcs of a circle.
Source: Thomson, Theory of Vibration with Applications, sec. 2.6; for climbing ropes Pavier, Sports
Engineering 1 (1998) 79.
"""

from __future__ import annotations

import cmath
import math
from dataclasses import dataclass

from ropewalk.theory.given import need
from ropewalk.words.safe_side import inwards, rounded_down, within

_FALL_FACTOR = 1.77  # of EN 892: about 4.96 m of free fall on 2.8 m of rope
_LENGTH = 2.8  # m
_ROUNDS = 200  # of a bisection
_ROUNDING = 1e-9  # [rad] an angle of a zero that is there at the start


@dataclass(frozen=True)
class Fall:
    """What a fall does to rope and fixed point."""

    force: float  # largest force on the fixed point [N], the damper's part with it
    stretch: float  # largest stretch of the rope over its length [1]
    time_of_force: float  # after the rope is straight [s]
    time_of_stretch: float  # [s]
    static: float  # stretch at rest under the mass [1]

    def __repr__(self) -> str:
        return (
            f"Fall: {self.force:.4g} N on the fixed point, stretched by {100 * self.stretch:.3g} %."
        )


def rope_fall(
    EA: float,
    axial_damping: float,
    mass: float,
    *,
    factor: float = _FALL_FACTOR,
    length: float = _LENGTH,
    gravity: float = 9.81,
) -> Fall:
    """Return what a mass that falls into a rope of stiffness and damping does.

    Args:
        EA: axial stiffness [N].
        axial_damping: tension per strain rate [N s], below the critical one, 2 sqrt(EA L m).
        mass: that falls [kg].
        factor: height of the free fall over the length of the rope [1]; 0 of a load that is let go at once.
        length: of the rope [m].
        gravity: [m/s^2].

    Raises ValueError for other numbers that are not positive, and for a damping above the critical one.

    Source: Thomson, Theory of Vibration with Applications, sec. 2.6.
    """
    need("EA", EA, "N")
    need("mass", mass, "kg")
    if not (math.isfinite(factor) and factor >= 0.0):
        raise ValueError(f"factor: {factor!r} - must be a number, not negative")
    need("length", length, "m")
    need("gravity", gravity, "m/s^2")
    k, c = EA / length, axial_damping / length
    if not 0.0 <= c < 2.0 * math.sqrt(k * mass):
        most = rounded_down(2.0 * math.sqrt(EA * length * mass), 6)
        raise ValueError(
            f"axial_damping: {axial_damping:g} - must be from 0 to below {most} N s, the critical one"
        )
    delta = 0.5 * c / mass
    omega = math.sqrt(k / mass - delta * delta)
    rest = mass * gravity / k
    speed = math.sqrt(2.0 * gravity * factor * length)
    root = complex(-delta, omega)
    C = complex(-rest, -(speed - delta * rest) / omega)  # y = Re(C exp(root t)), y = x - rest

    def first(power: int) -> float:
        """The first time after zero at which the derivative of that order is zero."""
        turn = (0.5 * math.pi - cmath.phase(C * root**power)) % math.pi
        at_zero = speed == 0.0 and turn < _ROUNDING
        return (math.pi if at_zero else turn) / omega

    def derivative(power: int, t: float) -> float:
        return (C * root**power * cmath.exp(root * t)).real

    longest = first(1)
    hardest = first(3)
    force = mass * (gravity - derivative(2, hardest))
    at_once = c * speed
    if at_once >= force:
        force, hardest = at_once, 0.0
    stretch = (rest + derivative(0, longest)) / length
    return Fall(force, stretch, hardest, longest, rest / length)


def rope_from_fall(
    force: float,
    stretch: float,
    mass: float,
    *,
    factor: float = _FALL_FACTOR,
    length: float = _LENGTH,
    gravity: float = 9.81,
) -> tuple[float, float]:
    """Return the EA [N] and axial damping [N s] with which a fall has this force and this stretch.

    The inverse of `rope_fall`, by bisection on the retardation time: of all that give the stretch, more
    damping gives less force, down to a least one.

    Args:
        force: largest, on the fixed point [N].
        stretch: largest, over the rope's length [1].
        mass: that falls [kg].
        factor: height of the free fall over the length of the rope [1].
        length: of the rope [m].
        gravity: [m/s^2].

    Raises ValueError for numbers that are not positive, and for a force that no damping gives at this
    stretch, with the range of those that are possible.

    Source: Thomson, Theory of Vibration with Applications, sec. 2.6.
    """
    need("force", force, "N")
    need("stretch", stretch, "1")
    need("mass", mass, "kg")
    need("factor", factor, "1")
    need("length", length, "m")
    need("gravity", gravity, "m/s^2")
    softest = mass * gravity / stretch  # at rest it would stretch so
    stiffest = 2.0 * softest * (factor / stretch + 1.0)  # without damping it does

    def fall(share: float) -> tuple[Fall, float, float]:
        """The fall that has the stretch, with a damping that is this share of the critical one."""
        low, high = softest, stiffest
        for _ in range(_ROUNDS):
            EA = math.sqrt(low * high)
            damping = 2.0 * share * math.sqrt(EA * length * mass)
            found = rope_fall(EA, damping, mass, factor=factor, length=length, gravity=gravity)
            low, high = (EA, high) if found.stretch > stretch else (low, EA)
        return found, EA, damping

    least = min((0.01 * i for i in range(100)), key=lambda share: fall(share)[0].force)
    most_force, least_force = fall(0.0)[0].force, fall(least)[0].force
    if not within(least_force, force, most_force):
        above, below = inwards(least_force, most_force)
        raise ValueError(
            f"force: {force:g} - must be from {above} to {below} N: a fall of {mass:g} kg "
            f"that stretches the rope by {100.0 * stretch:.3g} % has no other force with spring and damper"
        )
    low, high = 0.0, least
    for _ in range(60):
        share = 0.5 * (low + high)
        found, EA, damping = fall(share)
        low, high = (share, high) if found.force > force else (low, share)
    return EA, damping
