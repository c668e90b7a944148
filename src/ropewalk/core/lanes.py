"""As many ropes' numbers side by side as `WIDTH`, for loops that do the same to equal ropes.

`Lanes` are one vector of LLVM's, as a `Twin` is: every lane is rounded as its number alone would be. They
lie one after another in a whole array of one axis, and are loaded and stored by the place of the first.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from llvmlite import ir
from numba.core import cgutils, types
from numba.extending import intrinsic

from ropewalk.core.arrays import Floats
from ropewalk.core.elements import View
from ropewalk.core.jit import PLAIN
from ropewalk.core.largest import order
from ropewalk.core.vectors import make_vector, spread_out

WIDTH = 8
LINE = 64  # [bytes] of a line of the processor's cache

LANES, _VECTOR, Lanes = make_vector("Lanes", WIDTH)
_WHOLE = ir.VectorType(ir.IntType(64), WIDTH)


def room(size: int) -> Floats:
    """Return zeros, (size,), of which the first lies where a line of the processor's cache begins."""
    more = LINE // 8
    found = np.zeros(size + more)
    first = -(found.ctypes.data // 8) % more
    return found[first : first + size]


def _place(context: Any, builder: Any, kind: Any, array: Any, index: Any) -> Any:
    data = View(context, builder, kind, array).data
    return builder.bitcast(builder.gep(data, [index]), _VECTOR.as_pointer())


@intrinsic
def _load(_context: Any, array: Any, place: Any) -> Any:
    def emit(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        return builder.load(_place(context, builder, sig.args[0], *args), align=8)

    return LANES(array, types.intp), emit


@intrinsic
def _store(_context: Any, array: Any, place: Any, value: Any) -> Any:
    def emit(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        builder.store(args[2], _place(context, builder, sig.args[0], *args[:2]), align=8)
        return context.get_dummy_value()

    return types.void(array, types.intp, LANES), emit


@intrinsic
def _spread(_context: Any, number: Any) -> Any:
    def emit(_cx: Any, builder: Any, _sig: Any, args: Any) -> Any:
        return spread_out(builder, args[0], WIDTH)

    return LANES(types.float64), emit


def _calling(name: str) -> Any:
    """Return the intrinsic of LLVM's function of one number, lane by lane."""

    @intrinsic
    def call(_context: Any, value: Any) -> Any:
        def emit(_cx: Any, builder: Any, _sig: Any, args: Any) -> Any:
            kind = ir.FunctionType(_VECTOR, [_VECTOR])
            found = cgutils.get_or_insert_function(builder.module, kind, f"{name}.v{WIDTH}f64")
            return builder.call(found, args)

        return LANES(LANES), emit

    return call


@intrinsic
def _pick(_context: Any, one: Any, other: Any, less: Any, more: Any) -> Any:
    def emit(_cx: Any, builder: Any, _sig: Any, args: Any) -> Any:
        return builder.select(builder.fcmp_ordered("<", args[0], args[1]), args[2], args[3])

    return LANES(LANES, LANES, LANES, LANES), emit


@intrinsic
def _greater(_context: Any, one: Any, other: Any) -> Any:
    def emit(_cx: Any, builder: Any, _sig: Any, args: Any) -> Any:
        first, second = (builder.bitcast(value, _WHOLE) for value in args)
        return builder.select(builder.icmp_signed(">", first, second), *args)

    return LANES(LANES, LANES), emit


def _plain_load(array: Floats, place: int) -> Any:
    return Lanes(*array[place : place + WIDTH])


def _plain_store(array: Floats, place: int, value: Any) -> None:
    array[place : place + WIDTH] = value.numbers


def _plain_pick(one: Any, other: Any, less: Any, more: Any) -> Any:
    each = zip(one.numbers, other.numbers, less.numbers, more.numbers, strict=True)
    return Lanes(*(c if a < b else d for a, b, c, d in each))


def _plain_greater(one: Any, other: Any) -> Any:
    each = zip(one.numbers, other.numbers, strict=True)
    return Lanes(*(a if order(a) > order(b) else b for a, b in each))


load: Any = _plain_load if PLAIN else _load
"""load(array, place): return the lanes that begin at `place`."""
store: Any = _plain_store if PLAIN else _store
"""store(array, place, lanes): write them."""
spread: Any = (lambda number: Lanes(*(number,) * WIDTH)) if PLAIN else _spread
"""spread(number): return it in every lane."""
root: Any = (
    (lambda value: Lanes(*map(math.sqrt, value.numbers))) if PLAIN else _calling("llvm.sqrt")
)
"""root(lanes): return the square roots."""
size: Any = (lambda value: Lanes(*map(abs, value.numbers))) if PLAIN else _calling("llvm.fabs")
"""size(lanes): return the lanes without their signs."""
pick: Any = _plain_pick if PLAIN else _pick
"""pick(a, b, less, more): return `less` in lanes where a < b, else `more`."""
greater: Any = _plain_greater if PLAIN else _greater
"""greater(a, b): return the greater ones of numbers that are not negative, see `largest`."""
