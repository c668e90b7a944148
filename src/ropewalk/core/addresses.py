"""Named tuples of arrays by address, kept between calls: many of one kind for one kernel.

A call from Python looks at the type of every array in its arguments, and writes a block of words for each
tuple (`pointed`): some 0.2 ms for what a rope and its method have. A block that is kept is good as long as
the arrays of its tuple are where they were: whoever keeps it keeps the tuple, too.
"""

from __future__ import annotations

from functools import cached_property
from typing import Any

import numpy as np
from llvmlite import ir
from numba.core import cgutils, types
from numba.extending import intrinsic

from ropewalk.core.arrays import Ints
from ropewalk.core.elements import View
from ropewalk.core.jit import PLAIN, kernel
from ropewalk.core.pointed import Pointed, block_class, mark_of, words_of

_WORD = ir.IntType(64)


@intrinsic
def _count(_context: Any, value: Any) -> Any:
    count = words_of(value)

    def emit(_cx: Any, _builder: Any, _sig: Any, _args: Any) -> Any:
        return _WORD(count)

    return types.int64(value), emit


@intrinsic
def _name(_context: Any, value: Any) -> Any:
    mark = mark_of(value)

    def emit(_cx: Any, _builder: Any, _sig: Any, _args: Any) -> Any:
        return _WORD(mark)

    return types.int64(value), emit


@intrinsic
def _write(_context: Any, value: Any, words: Any) -> Any:
    count = words_of(value)

    def emit(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        data = View(context, builder, sig.args[1], args[1]).data
        cgutils.memcpy(builder, data, args[0], ir.Constant(ir.IntType(32), count))
        return context.get_dummy_value()

    return types.void(value, words), emit


@intrinsic
def _at(_context: Any, like: Any, address: Any) -> Any:
    if not isinstance(like, Pointed):
        return None

    def emit(_cx: Any, builder: Any, _sig: Any, args: Any) -> Any:
        return builder.inttoptr(args[1], _WORD.as_pointer())

    return like(like, types.int64), emit


_words: Any = _count
_mark: Any = _name
_copy: Any = _write
at: Any = _at
"""at(like, address): return the tuple, of the type that `like` has, whose block is at an address."""


@kernel
def _kept(value, words):
    """Copy a tuple's block to `words`, (m,), where there is room; return its size and a mark of its type."""
    if words.shape[0] >= _words(value):
        _copy(value, words)
    return _words(value), _mark(value)


class Kept:
    """The block of a named tuple, and that tuple."""

    def __init__(self, value: Any, size: int = 0) -> None:
        """Make it; `size` is how many words others of its type have taken."""
        self.value = value
        self.words: Ints = np.zeros(size, np.int64)
        needed, self.mark = _kept(value, self.words)
        if needed > size:
            self.words = np.zeros(needed, np.int64)
            _kept(value, self.words)

    def __reduce__(self) -> tuple[Any, ...]:
        """Let a copy have addresses of its own."""
        return type(self), (self.value,)

    @cached_property
    def block(self) -> Any:
        """What kernels take from Python in place of the tuple."""
        return block_class(self.mark)(self.words)

    @property
    def address(self) -> int:
        """Return where the block begins."""
        return int(self.words.ctypes.data)


def handed(*values: Any) -> tuple[Any, ...]:
    """Return what to hand to kernels in place of tuples, as long as their arrays are where they are."""
    return values if PLAIN else tuple(Kept(value).block for value in values)
