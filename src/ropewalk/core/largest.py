"""The largest of many numbers that are not negative, in loops that vectorise.

Bits of such numbers are in the order of the numbers, and those of what is no number come last. LLVM takes
the greatest of integers side by side; of floats it may not, as theirs depends on the order where one is no
number.
"""

from __future__ import annotations

import struct
from typing import Any

from llvmlite import ir
from numba.core import types
from numba.extending import intrinsic

from ropewalk.core.jit import PLAIN


@intrinsic
def _order(_context: Any, number: Any) -> Any:
    def emit(_cx: Any, builder: Any, _sig: Any, args: Any) -> Any:
        return builder.bitcast(args[0], ir.IntType(64))

    return types.int64(types.float64), emit


@intrinsic
def _ordered(_context: Any, order: Any) -> Any:
    def emit(_cx: Any, builder: Any, _sig: Any, args: Any) -> Any:
        return builder.bitcast(args[0], ir.DoubleType())

    return types.float64(types.int64), emit


def _plain_order(number: float) -> int:
    """Return the place of a number that is not negative among all others."""
    return int(struct.unpack("<q", struct.pack("<d", number))[0])


def _plain_ordered(order: int) -> float:
    """Return the number of a place."""
    return float(struct.unpack("<d", struct.pack("<q", order))[0])


order: Any = _plain_order if PLAIN else _order
ordered: Any = _plain_ordered if PLAIN else _ordered
