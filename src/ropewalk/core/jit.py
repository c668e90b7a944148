"""The `@kernel` decorator: numba without fast-math, cached under a hash of the package's own sources."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numba
from numba.core import ir, ir_utils
from numba.core.compiler import CompilerBase, DefaultPassBuilder
from numba.core.compiler_machinery import FunctionPass, register_pass
from numba.core.untyped_passes import ReconstructSSA

from ropewalk.core.cache import KernelCache


@register_pass(mutates_CFG=False, analysis_only=False)
class _ForwardCopies(FunctionPass):
    """Use a variable itself in place of its copies.

    numba copies the arguments of a function that it inlines. A copy of a named tuple of a hundred arrays
    is a thousand loads and stores to LLVM: without this pass a step took three times as long to compile.
    """

    _name = "ropewalk_forward_copies"

    def __init__(self) -> None:
        FunctionPass.__init__(self)

    def run_pass(self, state: Any) -> bool:
        blocks, definitions = state.func_ir.blocks, state.func_ir._definitions
        phis = [phi for block in blocks.values() for phi in block.find_exprs("phi")]
        merged = {
            value.name for phi in phis for value in phi.incoming_values if isinstance(value, ir.Var)
        }

        def stays(variable: Any) -> bool:
            """Whether it is given one value, and not by a phi, which becomes several assignments."""
            given = definitions[variable.name]
            return len(given) == 1 and given[0] not in phis

        copies: dict[str, Any] = {}
        for block in blocks.values():
            for statement in block.find_insts(ir.Assign):
                source, target = statement.value, statement.target
                if isinstance(source, ir.Var) and stays(source) and stays(target):
                    if target.name not in merged:
                        copies[target.name] = source
        for name in copies:
            while copies[name].name in copies:
                copies[name] = copies[copies[name].name]
        for block in blocks.values():
            block.body = [
                statement
                for statement in block.body
                if not (isinstance(statement, ir.Assign) and statement.target.name in copies)
            ]
        ir_utils.replace_vars(blocks, copies)
        return bool(copies)


class _Compiler(CompilerBase):
    """numba's own passes and ours."""

    def define_pipelines(self) -> list[Any]:
        manager = DefaultPassBuilder.define_nopython_pipeline(self.state)
        manager.add_pass_after(_ForwardCopies, ReconstructSSA)
        manager.finalize()
        return [manager]


def _njit(**options: Any) -> Any:
    # `_nrt` is not in numba's type stubs; it is what numba's own allocation-free code uses.
    options |= {
        "nogil": True,
        "error_model": "numpy",
        "_nrt": False,
        "no_cfunc_wrapper": True,
        "pipeline_class": _Compiler,
    }
    return numba.njit(**options)


def kernel(function: Callable[..., Any]) -> Any:
    """Compile `function` on its first call; keep the machine code on disk for the next process.

    No fast-math: the same inputs give the same bits. Division by zero gives inf, never an exception.
    Without numba's runtime (`_nrt`): nothing can be allocated, and no array is reference-counted, which
    took ten times as long as the physics of a short rope.
    """
    compiled = _njit()(function)
    if hasattr(compiled, "_cache"):
        compiled._cache = KernelCache(function)
    return compiled


def part(function: Callable[..., Any]) -> Any:
    """Compile `function` into its callers: for parts of kernels that take named tuples.

    A call hands over every array of a tuple one by one; on the step's path that costs more than
    the work on a short rope. Not for calls from the host: nothing of it is cached.
    """
    return _njit(inline="always")(function)


def small(function: Callable[..., Any]) -> Any:
    """Compile `function` so that LLVM puts it into its callers.

    For arithmetic on a few numbers, and for loops over a rope so short that handing over the arrays shows.
    """
    return _njit(forceinline=True)(function)
