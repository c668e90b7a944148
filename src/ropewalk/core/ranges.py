"""Ranges of nodes: kernels of laws work on nodes `lo` to `hi - 1` and on the segments that begin there.

A view is taken before a loop, and the loop runs from 0: an index that numba cannot prove to be positive
would keep the loop from being vectorised.
"""

from __future__ import annotations

from ropewalk.core.jit import part

ALL = 1 << 62  # the end of a range without an end


@part
def rows(a, lo, hi):
    """Return the three rows of a vector array (3, m) from column `lo` to `hi - 1`, as views."""
    return a[0, lo:hi], a[1, lo:hi], a[2, lo:hi]
