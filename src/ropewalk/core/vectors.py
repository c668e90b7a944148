"""Numbers side by side in one register, for loops that do the same to all of them.

They are one vector of LLVM's, whose lanes are rounded as numbers alone would be: the bits are the same, the
instructions fewer. Where numba is switched off they are a plain class.
"""

from __future__ import annotations

import operator
from collections.abc import Callable
from typing import Any

from llvmlite import ir
from numba.core import types
from numba.core.typing.templates import ConcreteTemplate, infer_global, signature
from numba.extending import lower_builtin, models, register_model

_PLACE = ir.IntType(32)
_OPERATIONS = (
    (operator.add, "fadd"),
    (operator.sub, "fsub"),
    (operator.mul, "fmul"),
    (operator.truediv, "fdiv"),
)


class Vector:
    """Numbers as Python sees them."""

    width: int

    def __init__(self, *numbers: float) -> None:
        self.numbers = numbers

    def _with(self, operation: Callable[[float, float], float], one: Any, other: Any) -> Vector:
        first, second = (
            value.numbers if isinstance(value, Vector) else (value,) * self.width
            for value in (one, other)
        )
        return type(self)(*map(operation, first, second))

    def __add__(self, other: Any) -> Vector:
        """Return the sums."""
        return self._with(operator.add, self, other)

    def __sub__(self, other: Any) -> Vector:
        """Return the differences."""
        return self._with(operator.sub, self, other)

    def __mul__(self, other: Any) -> Vector:
        """Return the products."""
        return self._with(operator.mul, self, other)

    def __truediv__(self, other: Any) -> Vector:
        """Return the quotients."""
        return self._with(operator.truediv, self, other)

    def __radd__(self, other: float) -> Vector:
        """Return the sums."""
        return self._with(operator.add, other, self)

    def __rsub__(self, other: float) -> Vector:
        """Return the differences."""
        return self._with(operator.sub, other, self)

    def __rmul__(self, other: float) -> Vector:
        """Return the products."""
        return self._with(operator.mul, other, self)

    def __rtruediv__(self, other: float) -> Vector:
        """Return the quotients."""
        return self._with(operator.truediv, other, self)

    def __neg__(self) -> Vector:
        """Return all with the other sign."""
        return type(self)(*map(operator.neg, self.numbers))


def spread_out(builder: Any, number: Any, width: int) -> Any:
    """Return a vector of LLVM's with a number in every lane."""
    found = ir.Constant(ir.VectorType(ir.DoubleType(), width), ir.Undefined)
    found = builder.insert_element(found, number, _PLACE(0))
    every = ir.Constant(ir.VectorType(_PLACE, width), [0] * width)
    return builder.shuffle_vector(found, found, every)


def make_vector(name: str, width: int) -> tuple[Any, Any, Any]:
    """Return numba's type of so many numbers, LLVM's, and the class of Python's.

    numba knows +, -, * and / of two vectors, and of one and a number, and the negative.
    """

    class _Type(types.Type):
        def __init__(self) -> None:
            super().__init__(name)

    kind, many = _Type(), ir.VectorType(ir.DoubleType(), width)

    @register_model(_Type)
    class _Model(models.PrimitiveModel):
        def __init__(self, dmm: Any, fe_type: Any) -> None:
            super().__init__(dmm, fe_type, many)

    def define(operation: Any, instruction: str) -> None:
        cases = [(kind, kind), (kind, types.float64), (types.float64, kind)]

        def emit(_context: Any, builder: Any, sig: Any, args: Any) -> Any:
            wide = [
                value if one == kind else spread_out(builder, value, width)
                for one, value in zip(sig.args, args, strict=True)
            ]
            return getattr(builder, instruction)(*wide)

        known = {"cases": [signature(kind, *c) for c in cases]}
        infer_global(operation)(type(instruction, (ConcreteTemplate,), known))
        for case in cases:
            lower_builtin(operation, *case)(emit)

    for operation, instruction in _OPERATIONS:
        define(operation, instruction)

    def negative(_context: Any, builder: Any, _sig: Any, args: Any) -> Any:
        return builder.fneg(args[0])

    infer_global(operator.neg)(
        type("negative", (ConcreteTemplate,), {"cases": [signature(kind, kind)]})
    )
    lower_builtin(operator.neg, kind)(negative)
    return kind, many, type(name, (Vector,), {"width": width})
