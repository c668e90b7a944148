"""The `@kernel` decorator: numba without fast-math, cached under a hash of the package's own sources."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numba
from numba.core import types

from ropewalk.core.cache import InnerCache, KernelCache
from ropewalk.core.compiler import ApartCompiler, Compiler, entry
from ropewalk.core.compiler import deferred as make_deferred

PLAIN = bool(getattr(numba.config, "DISABLE_JIT", 0))  # numba sets its options at run time

# `_nrt` is not in numba's type stubs; it is what numba's own allocation-free code uses.
OPTIONS: dict[str, Any] = {
    "nogil": True,
    "error_model": "numpy",
    "_nrt": False,
    "no_cfunc_wrapper": True,
    "forceinline": False,  # else numba takes it from the kernel that a call is first met in
}


def kernel(function: Callable[..., Any], *, seldom: bool = False) -> Any:
    """Compile `function` on its first call; keep the machine code on disk for the next process.

    No fast-math: the same inputs give the same bits. Division by zero gives inf, never an exception.
    Without numba's runtime (`_nrt`): nothing can be allocated, and no array is reference-counted, which
    took ten times as long as the physics of a short rope.
    With NUMBA_DISABLE_JIT=1 it stays plain Python, for debuggers and for measuring coverage.
    """
    if PLAIN:
        return function
    return _cached(entry(function, OPTIONS, seldom=seldom), function)


def _cached(compiled: Any, function: Callable[..., Any]) -> Any:
    """Return a kernel that keeps its machine code, and that of its inner function, on disk."""
    compiled._cache = KernelCache(function)
    compiled.inner._cache = InnerCache(function)
    return compiled


def deferred(returns: str = "none", count: int = 0) -> Callable[[Callable[..., Any]], Any]:
    """As `kernel`, for what only some scenes call: compiled, apart from its callers, at its first call.

    `returns` is numba's name of the type of what it returns, as no caller looks into it; with `count` it is a
    tuple of so many. Nor does LLVM: this is for pieces that take longer than a call.
    """
    kind: Any = getattr(types, returns)
    if count:
        kind = types.UniTuple(kind, count)

    def decorate(function: Callable[..., Any]) -> Any:
        if PLAIN:
            return function
        return _cached(make_deferred(function, OPTIONS, kind), function)

    return decorate


def seldom(function: Callable[..., Any]) -> Any:
    """As `kernel`, for what Python calls a few times in a run: that call is compiled sooner and runs slower.

    Kernels that call it get it as fast as any.
    """
    return kernel(function, seldom=True)


def part(function: Callable[..., Any]) -> Any:
    """Compile `function` into its callers: for parts of kernels that take named tuples.

    A call hands over every array of a tuple one by one; on the step's path that costs more than
    the work on a short rope. Not for calls from the host: nothing of it is cached.
    """
    return numba.njit(inline="always", pipeline_class=Compiler, **OPTIONS)(function)


def small(function: Callable[..., Any]) -> Any:
    """Compile `function` so that LLVM puts it into its callers.

    For arithmetic on a few numbers, and for loops over a rope so short that handing over the arrays shows.
    What Python calls of it is kept on disk; its callers keep the rest.
    """
    if PLAIN:
        return function
    made = entry(function, OPTIONS | {"forceinline": True})
    made._cache = KernelCache(function)
    return made


def apart(function: Callable[..., Any]) -> Any:
    """As `small`, for loops over many arrays of which those that are written overlap no other argument."""
    return function if PLAIN else entry(function, OPTIONS | {"forceinline": True}, ApartCompiler)
