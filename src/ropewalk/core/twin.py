"""Two numbers side by side in one register, for loops that do the same to both ends of a rope."""

from __future__ import annotations

from typing import Any

from llvmlite import ir
from numba.core import types
from numba.extending import intrinsic

from ropewalk.core.jit import PLAIN
from ropewalk.core.vectors import make_vector

TWIN, _BOTH, Twin = make_vector("Twin", 2)
_LANE = ir.IntType(32)


@intrinsic
def _twin(_context: Any, first: Any, second: Any) -> Any:
    def emit(_cx: Any, builder: Any, _sig: Any, args: Any) -> Any:
        both = ir.Constant(_BOTH, ir.Undefined)
        both = builder.insert_element(both, args[0], _LANE(0))
        return builder.insert_element(both, args[1], _LANE(1))

    return TWIN(types.float64, types.float64), emit


def _lane(number: int) -> Any:
    @intrinsic
    def lane(_context: Any, both: Any) -> Any:
        def emit(_cx: Any, builder: Any, _sig: Any, args: Any) -> Any:
            return builder.extract_element(args[0], _LANE(number))

        return types.float64(TWIN), emit

    return lane


twin: Any = Twin if PLAIN else _twin
first: Any = (lambda both: both.numbers[0]) if PLAIN else _lane(0)
second: Any = (lambda both: both.numbers[1]) if PLAIN else _lane(1)
