"""Passes of numba that read a function, without what they look for that kernels have not.

numba looks through every function for `with`, for dictionaries that are put together and for generators,
finds out where its variables live, and tells whoever listens of each call of LLVM, a hundred thousand.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from llvmlite.binding import ffi
from numba.core import interpreter, ir
from numba.core.compiler_machinery import FunctionPass, register_pass
from numba.core.rewrites.registry import rewrite_registry

_IDLE = {"peep_hole_delete_with_exit", "peep_hole_fuse_dict_add_updates"}


class _Interpreter(interpreter.Interpreter):
    """Reads byte code, and looks for no `with` and no dictionaries."""

    def post_process(self, peepholes: list[Any], func_ir: Any) -> Any:
        """Rewrite what is in kernels."""
        wanted = [one for one in peepholes if one.__name__ not in _IDLE]
        return super().post_process(wanted, func_ir)


@register_pass(mutates_CFG=True, analysis_only=False)
class ReadByteCode(FunctionPass):
    """Read a function."""

    _name = "ropewalk_read_byte_code"

    def __init__(self) -> None:
        FunctionPass.__init__(self)

    def run_pass(self, state: Any) -> bool:
        state.func_ir = _Interpreter(state.func_id).interpret(state.bc)
        return True


@register_pass(mutates_CFG=True, analysis_only=False)
class Rewrite(FunctionPass):
    """Rewrite what has constants, as numba, without finding out where variables live then."""

    _name = "ropewalk_rewrite"

    def __init__(self) -> None:
        FunctionPass.__init__(self)

    def run_pass(self, state: Any) -> bool:
        func_ir = state.func_ir
        for kind in rewrite_registry.rewrites["before-inference"]:
            rewrite, waiting = kind(state), list(func_ir.blocks.items())
            while waiting:
                label, block = waiting.pop()
                if rewrite.match(func_ir, block, state.typemap, state.calltypes):
                    func_ir.blocks[label] = rewrite.apply()
                    waiting.append((label, func_ir.blocks[label]))
        return True


def variables_of(statement: Any) -> list[Any]:
    """Return the variables in a statement, as its `list_vars`."""
    return variables_in(vars(statement).values())


def variables_in(values: Iterable[Any]) -> list[Any]:
    """Return the variables among values and in those that are put together."""
    found: list[Any] = []
    for value in values:
        kind = type(value)
        if kind is ir.Var:
            found.append(value)
        elif kind is ir.Expr:
            found += variables_in(value._kws.values())
        elif kind is list or kind is tuple:
            found += variables_in(value)
        elif kind is dict:
            found += variables_in(value.values())
        elif isinstance(value, ir.Inst):
            found += value.list_vars()
    return found


def tell_nobody() -> None:
    """Have numba tell nobody of calls of LLVM: it took longer than most of them."""
    heard = ffi.lib._lock._cblist
    for acquired, released in list(heard):
        if acquired.__module__ == "numba.core.base":
            ffi.unregister_lock_callback(acquired, released)
