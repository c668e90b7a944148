"""Solution of a banded system of equations, with row exchanges, for matrices that are not definite.

Row i keeps its entries from column i - below on: `matrix[i, j - i + below]` is the entry (i, j). Row
exchanges fill up to `below` more columns on the right, so that a row has 2 below + above + 1 places.
Source: Golub and Van Loan, Matrix Computations, sec. 4.3.
"""

from __future__ import annotations

from ropewalk.core.jit import kernel


@kernel
def solve_band(matrix, right, below, above):
    """Overwrite `right` (n,) with the solution, `matrix` with its factors; return the least pivot.

    The least pivot is relative to the largest one; it is 0 for a singular matrix, and `right` is then
    of no use.
    """
    n = right.shape[0]
    reach = below + above
    smallest, largest = 1e300, 0.0
    for c in range(n):
        last = min(c + below, n - 1)
        best, size = c, abs(matrix[c, below])
        for r in range(c + 1, last + 1):
            value = abs(matrix[r, c - r + below])
            if value > size:
                best, size = r, value
        if not size > 0.0:
            return 0.0
        smallest, largest = min(smallest, size), max(largest, size)
        if best != c:
            shift = c - best + below
            for j in range(reach + 1):
                kept = matrix[c, below + j]
                matrix[c, below + j] = matrix[best, shift + j]
                matrix[best, shift + j] = kept
            kept = right[c]
            right[c] = right[best]
            right[best] = kept
        pivot = matrix[c, below]
        for r in range(c + 1, last + 1):
            shift = c - r + below
            factor = matrix[r, shift] / pivot
            if factor != 0.0:
                for j in range(1, reach + 1):
                    matrix[r, shift + j] -= factor * matrix[c, below + j]
                right[r] -= factor * right[c]
    for c in range(n - 1, -1, -1):
        total = right[c]
        for j in range(1, min(reach, n - 1 - c) + 1):
            total -= matrix[c, below + j] * right[c + j]
        right[c] = total / matrix[c, below]
    return smallest / largest
