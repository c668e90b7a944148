"""The `@kernel` decorator: numba without fast-math, cached under a hash of the package's own sources.

numba's own disk cache looks at one file's time stamp only and misses edits in the files a kernel calls
(numba issue 1833). Here the stamp of every cached kernel is a hash over all sources of the package, so
that stale machine code can never run.
"""

from __future__ import annotations

import contextlib
import hashlib
import os
import shutil
import sys
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import numba
from numba.core import caching, ir, ir_utils
from numba.core.compiler import CompilerBase, DefaultPassBuilder
from numba.core.compiler_machinery import FunctionPass, register_pass
from numba.core.untyped_passes import ReconstructSSA

PACKAGE = Path(__file__).resolve().parent.parent
KERNEL_FOLDERS = ("core", "laws", "methods", "motions")
KEPT_CACHES = 4


@cache
def source_hash() -> str:
    """Return a hash of every source file that can hold a kernel, and of numba's version."""
    digest = hashlib.sha256(numba.__version__.encode())
    for folder in KERNEL_FOLDERS:
        for path in sorted((PACKAGE / folder).rglob("*.py")):
            digest.update(str(path.relative_to(PACKAGE)).encode())
            digest.update(path.read_bytes())
    return digest.hexdigest()[:16]


def cache_root() -> Path:
    """Return the folder of compiled kernels: `ROPEWALK_CACHE_DIR`, or the user's cache folder."""
    if chosen := os.environ.get("ROPEWALK_CACHE_DIR"):
        return Path(chosen)
    if sys.platform == "win32":
        base = Path(os.environ.get("LOCALAPPDATA", Path.home() / "AppData" / "Local"))
    elif sys.platform == "darwin":
        base = Path.home() / "Library" / "Caches"
    else:
        base = Path(os.environ.get("XDG_CACHE_HOME", Path.home() / ".cache"))
    return base / "ropewalk"


@cache
def cache_folder() -> Path | None:
    """Return this version's own cache folder, made if need be; None where nothing can be written."""
    folder = cache_root() / source_hash()
    try:
        folder.mkdir(parents=True, exist_ok=True)
        os.utime(folder)
        probe = folder / f".probe-{os.getpid()}"
        probe.write_bytes(b"")
        probe.unlink()
    except OSError:
        return None
    _drop_old_caches(folder)
    return folder


def _drop_old_caches(current: Path) -> None:
    with contextlib.suppress(OSError):
        old = [entry for entry in current.parent.iterdir() if entry.is_dir() and entry != current]
        old.sort(key=lambda entry: entry.stat().st_mtime, reverse=True)
        for entry in old[KEPT_CACHES - 1 :]:
            shutil.rmtree(entry, ignore_errors=True)


def is_compiled(function: Any) -> bool:
    """Tell whether `function` has machine code, in this process or on disk."""
    if function.signatures:
        return True
    folder = cache_folder()
    code = function.py_func.__code__
    stem = Path(code.co_filename).stem
    name = f"{stem}.{function.py_func.__qualname__}-{stem}-{code.co_firstlineno}."
    version = f"py{sys.version_info.major}{sys.version_info.minor}"  # as numba names its files
    return folder is not None and any(folder.glob(f"{name}{version}*.nbi"))


class _SourceHashLocator(caching._CacheLocator):
    """Locate cached kernels in the folder that carries the hash of all sources."""

    def __init__(self, py_func: Callable[..., Any], py_file: str) -> None:
        self._stem = Path(py_file).stem
        self._line = py_func.__code__.co_firstlineno

    def get_cache_path(self) -> str:
        return str(cache_folder())

    def get_source_stamp(self) -> str:
        return source_hash()

    def get_disambiguator(self) -> str:
        return f"{self._stem}-{self._line}"

    @classmethod
    def from_function(cls, py_func: Callable[..., Any], py_file: str) -> _SourceHashLocator:
        return cls(py_func, py_file)


class _KernelCacheImpl(caching.CompileResultCacheImpl):
    _locator_classes = [_SourceHashLocator]  # noqa: RUF012 - numba reads this class attribute


class _KernelCache(caching.FunctionCache):
    _impl_class = _KernelCacheImpl

    def _index_key(self, sig: Any, codegen: Any) -> Any:
        # The source hash stands for the code. numba adds a hash of what a closure holds, which for a
        # compiled function is another in every process.
        return sig, codegen.magic_tuple()


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
    if hasattr(compiled, "_cache") and cache_folder() is not None:
        compiled._cache = _KernelCache(function)
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
