"""How many eigenvalues of a model lie in a disk, from determinants on its rim alone.

det P(l), P(l) = l^2 M + l C + K, turns about 0 as often on the way round a circle as it has zeros inside,
each counted as often as it is there: the principle of the argument. Those known already are divided
out, so that what is left turns little, and not at all when nothing is missing.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ropewalk.vibration.linear import Linear

Complex = NDArray[np.complex128]

_STEP = 2e-5  # of the angle, over which a turn is measured [rad]
_POINTS = (8, 20, 50)  # on half the circle; the other half mirrors it
_WHOLE = 0.1  # distance from a whole number that counts as none [1]


def missing(linear: Linear, known: Complex, radius: float, centre: float = 0.0) -> int | None:
    """Return how many eigenvalues within a radius [1/s] are not among those known; None where unclear.

    The disk is about a real centre. The known ones are all of them, both of a pair, inside or outside.
    """
    parts = _parts(linear)
    before = 0.0  # none may show at once, some must twice: with few points those just outside count
    for points in _POINTS:
        angles = (np.arange(points) + 0.5) * (np.pi / points)
        left = float(np.mean([_turn(parts, known, radius, centre, angle) for angle in angles]))
        if abs(left - round(left)) <= _WHOLE and abs(left - before) <= _WHOLE:
            return round(left)
        before = left if abs(left) > 0.5 else 0.0
    return None


def _parts(linear: Linear) -> tuple[Any, Any, Any]:
    """Return K, C and M of one size, with the tensions as unknowns."""
    from scipy.sparse import block_diag, csc_array, diags_array

    tensions = linear.soft.size
    friction = block_diag([linear.friction, csc_array((tensions, tensions))], format="csc")
    mass = diags_array(np.append(linear.mass, np.zeros(tensions))).tocsc()
    return linear.saddle(), friction, mass


def _turn(
    parts: tuple[Any, Any, Any], known: Complex, radius: float, centre: float, angle: float
) -> float:
    """Return the rate at which the phase of det P turns there, that of the known zeros taken off [1]."""
    from scipy.sparse.linalg import splu

    stiffness, friction, mass = parts
    places = [centre + radius * np.exp(1j * (angle + step)) for step in (_STEP, -_STEP)]
    both = [splu((stiffness + at * friction + at**2 * mass).tocsc()) for at in places]
    ahead, behind = (np.prod(_unit(factors.U.diagonal())) for factors in both)
    ratio = ahead / behind / np.prod(_unit((places[0] - known) / (places[1] - known)))
    orders = [factors.perm_r[factors.perm_c] for factors in both]
    if not np.array_equal(*orders):
        ratio *= _sign(orders[0]) * _sign(orders[1])
    return float(np.angle(ratio)) / (2.0 * _STEP)


def _unit(numbers: Any) -> Complex:
    return np.asarray(numbers / np.abs(numbers))


def _sign(order: Any) -> int:
    """Return 1 for an even permutation, -1 for an odd one."""
    from scipy.sparse import csr_array
    from scipy.sparse.csgraph import connected_components

    size = len(order)
    graph = csr_array((np.ones(size, np.int8), (np.arange(size), order)), shape=(size, size))
    cycles, _ = connected_components(graph, directed=False)
    return -1 if (size - cycles) % 2 else 1
