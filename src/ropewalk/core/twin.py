"""Two numbers side by side in one register, for loops that do the same to both ends of a rope.

A `Twin` is one vector of LLVM's, whose lanes are rounded as two numbers alone would be: the bits are the
same, the instructions half as many. Where numba is switched off it is a plain class.
"""

from __future__ import annotations

import operator
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from llvmlite import ir
from numba.core import types
from numba.core.typing.templates import ConcreteTemplate, infer_global, signature
from numba.extending import intrinsic, lower_builtin, models, register_model

from ropewalk.core.jit import PLAIN


@dataclass(frozen=True)
class Twin:
    """Two numbers as Python sees them."""

    first: float
    second: float

    def _with(self, operation: Callable[[float, float], float], other: Any) -> Twin:
        other = _both(other)
        return Twin(operation(self.first, other.first), operation(self.second, other.second))

    def __add__(self, other: Any) -> Twin:
        """Return the sums."""
        return self._with(operator.add, other)

    def __sub__(self, other: Any) -> Twin:
        """Return the differences."""
        return self._with(operator.sub, other)

    def __mul__(self, other: Any) -> Twin:
        """Return the products."""
        return self._with(operator.mul, other)

    def __truediv__(self, other: Any) -> Twin:
        """Return the quotients."""
        return self._with(operator.truediv, other)

    def __rsub__(self, other: float) -> Twin:
        """Return the differences."""
        return _both(other) - self

    def __rmul__(self, other: float) -> Twin:
        """Return the products."""
        return _both(other) * self

    def __rtruediv__(self, other: float) -> Twin:
        """Return the quotients."""
        return _both(other) / self

    def __neg__(self) -> Twin:
        """Return both with the other sign."""
        return Twin(-self.first, -self.second)


def _both(number: Any) -> Any:
    return number if isinstance(number, Twin) else Twin(number, number)


class TwinType(types.Type):
    """numba's type of a `Twin`."""

    def __init__(self) -> None:
        super().__init__("Twin")


TWIN = TwinType()
_LANE = ir.IntType(32)


@register_model(TwinType)
class _TwinModel(models.PrimitiveModel):
    def __init__(self, dmm: Any, fe_type: Any) -> None:
        super().__init__(dmm, fe_type, ir.VectorType(ir.DoubleType(), 2))


def _pack(builder: Any, first: Any, second: Any) -> Any:
    both = ir.Constant(ir.VectorType(ir.DoubleType(), 2), ir.Undefined)
    both = builder.insert_element(both, first, _LANE(0))
    return builder.insert_element(both, second, _LANE(1))


@intrinsic
def _twin(_context: Any, first: Any, second: Any) -> Any:
    def emit(_cx: Any, builder: Any, _sig: Any, args: Any) -> Any:
        return _pack(builder, *args)

    return TWIN(types.float64, types.float64), emit


def _lane(number: int) -> Any:
    @intrinsic
    def lane(_context: Any, both: Any) -> Any:
        def emit(_cx: Any, builder: Any, _sig: Any, args: Any) -> Any:
            return builder.extract_element(args[0], _LANE(number))

        return types.float64(TWIN), emit

    return lane


def _define(operation: Any, name: str) -> None:
    """Let numba know `operation` on two twins, and on a twin and a number."""
    cases = [(TWIN, TWIN), (TWIN, types.float64), (types.float64, TWIN)]

    def emit(_context: Any, builder: Any, sig: Any, args: Any) -> Any:
        wide = [
            value if kind == TWIN else _pack(builder, value, value)
            for kind, value in zip(sig.args, args, strict=True)
        ]
        return getattr(builder, name)(*wide)

    template = type(name, (ConcreteTemplate,), {"cases": [signature(TWIN, *c) for c in cases]})
    infer_global(operation)(template)
    for case in cases:
        lower_builtin(operation, *case)(emit)


for _operation, _name in (
    (operator.add, "fadd"),
    (operator.sub, "fsub"),
    (operator.mul, "fmul"),
    (operator.truediv, "fdiv"),
):
    _define(_operation, _name)


@infer_global(operator.neg)
class _Negative(ConcreteTemplate):
    cases = [signature(TWIN, TWIN)]  # noqa: RUF012 - as numba has it


@lower_builtin(operator.neg, TWIN)
def _negative(_context: Any, builder: Any, _sig: Any, args: Any) -> Any:
    return builder.fneg(args[0])


twin: Any = Twin if PLAIN else _twin
first: Any = operator.attrgetter("first") if PLAIN else _lane(0)
second: Any = operator.attrgetter("second") if PLAIN else _lane(1)
