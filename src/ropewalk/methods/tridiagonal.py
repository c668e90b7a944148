"""Symmetric tridiagonal matrices: definiteness, extreme eigenvalues, extreme eigenvector; O(n).

`diagonal` has n entries and `beside` n - 1, the entries next to the diagonal. The tests for
definiteness are the signs of the pivots of L D L^T (Sylvester's law of inertia; Parlett, The
Symmetric Eigenvalue Problem, section 3.3), which bisection turns into eigenvalues.
"""

from __future__ import annotations

from ropewalk.core.arrays import Floats
from ropewalk.core.jit import kernel


@kernel
def is_positive_definite(diagonal, beside):
    """Tell whether all eigenvalues are positive."""
    pivot = diagonal[0]
    if not pivot > 0.0:
        return False
    for i in range(1, diagonal.shape[0]):
        pivot = diagonal[i] - beside[i - 1] * beside[i - 1] / pivot
        if not pivot > 0.0:
            return False
    return True


@kernel
def _is_above_all(shift, diagonal, beside):
    pivot = shift - diagonal[0]
    if not pivot > 0.0:
        return False
    for i in range(1, diagonal.shape[0]):
        pivot = (shift - diagonal[i]) - beside[i - 1] * beside[i - 1] / pivot
        if not pivot > 0.0:
            return False
    return True


@kernel
def largest_eigenvalue(diagonal, beside):
    """Return the largest eigenvalue, by bisection below Gershgorin's bound."""
    n = diagonal.shape[0]
    low = diagonal[0]
    high = diagonal[0]
    size = 0.0
    for i in range(n):
        reach = 0.0
        if i > 0:
            reach += abs(beside[i - 1])
        if i < n - 1:
            reach += abs(beside[i])
        low = max(low, diagonal[i])
        high = max(high, diagonal[i] + reach)
        size = max(size, abs(diagonal[i]) + reach)
    for _ in range(60):
        if high - low <= 4e-16 * size:
            break
        middle = 0.5 * (low + high)
        if _is_above_all(middle, diagonal, beside):
            high = middle
        else:
            low = middle
    return high


def smallest_eigenvalue(diagonal: Floats, beside: Floats) -> float:
    """Return the smallest eigenvalue."""
    return -float(largest_eigenvalue(-diagonal, beside))


@kernel
def largest_eigenvector(diagonal, beside, value, vector, work):
    """Write the eigenvector of the largest eigenvalue `value`, its largest entry 1.

    `vector` and `work` have n entries each; the start is alternating with a slope, so that it is
    orthogonal to no extreme mode of a chain.
    """
    n = diagonal.shape[0]
    size = abs(value)
    for i in range(n):
        size = max(size, abs(diagonal[i]))
        vector[i] = (1.0 + 0.3 * (i + 1.0) / n) * (1.0 if i % 2 == 0 else -1.0)
    shift = value + 1e-13 * size
    for _ in range(4):
        work[0] = shift - diagonal[0]
        for i in range(1, n):
            factor = -beside[i - 1] / work[i - 1]
            work[i] = (shift - diagonal[i]) + factor * beside[i - 1]
            if work[i] == 0.0:
                work[i] = 1e-300
            vector[i] -= factor * vector[i - 1]
        vector[n - 1] /= work[n - 1]
        for i in range(n - 2, -1, -1):
            vector[i] = (vector[i] + beside[i] * vector[i + 1]) / work[i]
        largest = 0.0
        for i in range(n):
            if abs(vector[i]) > abs(largest):
                largest = vector[i]
        if largest == 0.0:
            break
        for i in range(n):
            vector[i] /= largest
