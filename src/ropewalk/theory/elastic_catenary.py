"""The elastic catenary between two points: Hooke's law on the unstretched length.

Two equations for H and V, the ends' places in `Cable.position`. They are the gradient of the
complementary energy, which is convex, so that there is one solution, and Newton's method with a line
search on the residual finds it from anywhere.
Source: Irvine, Cable Structures (1981), sec. 1.4; Jayaraman and Knudson, Comput. Struct. 14 (1981) 301.
"""

from __future__ import annotations

import math

from ropewalk.theory.cable import Cable, asinh_difference
from ropewalk.theory.catenary import catenary, parameter
from ropewalk.theory.given import need, need_ends, need_stiff
from ropewalk.theory.parabola import parabola

_CLOSED = 1e-11  # of the cable's size: what may be left open at most [1]


def elastic_catenary(
    length: float, across: float, rise: float = 0.0, weight: float = 1.0, EA: float = math.inf
) -> Cable:
    """Return the elastic catenary of a cable between two points.

    Args:
        length: unstretched [m]; it may be shorter than the distance of the ends.
        across: horizontal distance of the ends [m]; 0 hangs it as two plumb lines.
        rise: how much higher the second end is [m].
        weight: per unstretched length [N/m]; 0 is allowed for a cable that is stretched.
        EA: axial stiffness [N]; inf makes it the inextensible `catenary`.

    Raises ValueError for an inextensible cable that does not reach, for a slack one without weight
    (its shape is not determined), and for numbers that are not positive and finite.

    Source: Irvine, Cable Structures (1981), sec. 1.4; Jayaraman and Knudson, Comput. Struct. 14 (1981) 301.
    """
    if weight != 0.0:
        need("weight", weight, "N/m")
    need("length", length, "m")
    need_ends(across, rise)
    need_stiff(EA)
    if math.isinf(EA):
        return catenary(length, across, rise, weight)
    if weight == 0.0:
        return _weightless(length, across, rise, EA)
    if across == 0.0:
        return Cable(length, 0.0, rise, weight, EA, 0.0, _plumb(length, rise, weight, EA))
    H, V = _solve(length, across, rise, weight, EA)
    return Cable(length, across, rise, weight, EA, H, V)


def _weightless(length: float, across: float, rise: float, EA: float) -> Cable:
    distance = math.hypot(across, rise)
    if distance < length:
        raise ValueError(
            f"weight: 0 - must be positive for a cable of {length:g} m that is longer than the "
            f"distance of its ends, {distance:g} m: nothing gives it a shape"
        )
    pull = EA * (distance / length - 1.0)
    return Cable(length, across, rise, 0.0, EA, pull * across / distance, -pull * rise / distance)


def _plumb(length: float, rise: float, weight: float, EA: float) -> float:
    """Return V of a cable whose ends are one above the other [N]; its depth is linear in V."""
    total, soft = weight * length, length / EA
    V = 0.5 * total - rise / (soft + 2.0 / weight)
    if total < V:  # all of it hangs down from the first end and is pulled on below
        return 0.5 * total - (rise + length) / soft
    if V < 0.0:
        return 0.5 * total - (rise - length) / soft
    return V


def _start(
    length: float, across: float, rise: float, weight: float, EA: float
) -> tuple[float, float]:
    """Guess H and V: the stretched shallow cable, or the slack inextensible one."""
    H = parabola(length, across, rise, weight, EA).horizontal
    V = 0.5 * weight * length - H * rise / across
    if length > math.hypot(across, rise):
        a = parameter(length, across, rise)
        if weight * a < H:
            found = catenary(length, across, rise, weight)
            return found.horizontal, found.vertical
    return H, V


def _solve(
    length: float, across: float, rise: float, weight: float, EA: float
) -> tuple[float, float]:
    H, V = _start(length, across, rise, weight, EA)
    given = (length, across, rise, weight, EA)
    (f, g), jacobian = _closing(H, V, *given)
    left = math.hypot(f, g)
    for _ in range(200):
        (a, b), (c, d) = jacobian
        determinant = a * d - b * c
        if left == 0.0 or not determinant > 0.0:
            break
        dh, dv = -(d * f - b * g) / determinant, -(a * g - c * f) / determinant
        factor = min(1.0, -0.9 * H / dh) if dh < 0.0 else 1.0
        for _ in range(60):
            trial = H + factor * dh, V + factor * dv
            (f, g), jacobian = _closing(*trial, *given)
            if math.hypot(f, g) < left:
                break
            factor *= 0.5
        else:
            break
        H, V = trial
        left = math.hypot(f, g)
    if left > _CLOSED * (length + across + abs(rise)):
        raise ArithmeticError(f"the elastic catenary did not close: {left:.3g} m are left open")
    return H, V


def _closing(
    H: float, V: float, length: float, across: float, rise: float, weight: float, EA: float
) -> tuple[tuple[float, float], tuple[tuple[float, float], tuple[float, float]]]:
    """Return what is left open at the second end [m], and its derivatives by H and V [m/N]."""
    end, soft = V - weight * length, length / EA
    first, last = math.hypot(H, V), math.hypot(H, end)
    turned = float(asinh_difference(V / H, end / H, weight * length / H))
    x = H * soft + H / weight * turned
    depth = soft * (V - 0.5 * weight * length) + length * (V + end) / (first + last)
    slope = (V / first - end / last) / weight
    cross = H / weight * (last - first) / (first * last)
    return (x - across, depth + rise), (
        (soft + max(turned / weight - slope, 0.0), cross),
        (cross, soft + slope),
    )
