"""Compiled kernels on disk: where they lie, what makes them stale, and what is done when one is damaged.

numba's own disk cache looks at one file's time stamp only and misses edits in the files a kernel calls
(numba issue 1833). Here the stamp of every cached kernel is a hash over all sources of the package, so
that stale machine code can never run; and every file begins with a hash of the rest, so that damaged
machine code can neither.
"""

from __future__ import annotations

import contextlib
import hashlib
import os
import pickle
import re
import shutil
import sys
import uuid
import warnings
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import numba
from numba.core import caching, types

from ropewalk.core.compiler import rebuild_inner, reduce_inner

PACKAGE = Path(__file__).resolve().parent.parent
KERNEL_FOLDERS = ("core", "laws", "methods", "motions")
KEPT_CACHES = 4
_DIGEST = 32  # bytes before the contents of a file


class CacheWarning(UserWarning):
    """Compiled kernels cannot be kept; every start compiles them anew."""


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
def cache_folder() -> Path:
    """Return this version's own cache folder; it is made when something is first kept in it."""
    folder = cache_root() / source_hash()
    with contextlib.suppress(OSError):
        os.utime(folder)
    return folder


def _drop_old_caches(current: Path) -> None:
    """Keep the caches of the last few versions; what is not named like one is not ours."""
    with contextlib.suppress(OSError):
        old = [
            entry
            for entry in current.parent.iterdir()
            if re.fullmatch("[0-9a-f]{16}", entry.name) and entry.is_dir() and entry != current
        ]
        old.sort(key=lambda entry: entry.stat().st_mtime, reverse=True)
        for entry in old[KEPT_CACHES - 1 :]:
            shutil.rmtree(entry, ignore_errors=True)


def is_compiled(function: Any, rare: int | None) -> bool:
    """Tell whether `function` has machine code of a variant, in this process or on disk.

    `rare` is that of `System`.
    """
    if not hasattr(function, "signatures"):  # plain Python is as ready as it gets
        return True
    wanted = rare is not None
    if any(_is_full(one) == wanted for one in function.signatures):
        return True
    code = function.py_func.__code__
    stem = Path(code.co_filename).stem
    name = f"{stem}.{function.py_func.__qualname__}-{stem}-{code.co_firstlineno}."
    version = f"py{sys.version_info.major}{sys.version_info.minor}"  # as numba names its files
    try:
        indexes = list(cache_folder().glob(f"{name}{version}*.nbi"))
    except OSError:
        return False
    found = [_contents(path) for path in indexes]
    keys = [key for index in found if isinstance(index, dict) for key in index]
    return any(_is_full(signature) == wanted for signature, *_ in keys)


def _is_full(signature: tuple[Any, ...]) -> bool | None:
    """Tell whether machine code for arguments of these types has the rare laws; None: there is no system."""
    for kind in signature:
        names = getattr(kind, "fields", ())
        if "rare" in names:
            return not isinstance(kind[names.index("rare")], types.NoneType)
    return None


def _contents(path: Path) -> Any:
    """Return what a file of the cache holds, None where it is not whole: then it goes."""
    try:
        data = path.read_bytes()
    except OSError:
        return None
    if hashlib.sha256(data[_DIGEST:]).digest() == data[:_DIGEST]:
        with contextlib.suppress(Exception):  # written whole, by a numba that had other names
            return pickle.loads(data[_DIGEST:])
    with contextlib.suppress(OSError):
        path.unlink()
    return None


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

    def ensure_cache_path(self) -> None:
        folder = cache_folder()
        if not folder.is_dir():
            folder.mkdir(parents=True, exist_ok=True)
            _drop_old_caches(folder)

    @classmethod
    def from_function(cls, py_func: Callable[..., Any], py_file: str) -> _SourceHashLocator:
        return cls(py_func, py_file)


class _KernelCacheImpl(caching.CompileResultCacheImpl):
    _locator_classes = [_SourceHashLocator]  # noqa: RUF012 - numba reads this class attribute


class _InnerLocator(_SourceHashLocator):
    """Locate the inner functions of kernels, in files of their own."""

    def get_disambiguator(self) -> str:
        return f"{super().get_disambiguator()}-inner"


class _InnerCacheImpl(caching.CompileResultCacheImpl):
    _locator_classes = [_InnerLocator]  # noqa: RUF012 - numba reads this class attribute

    def reduce(self, cres: Any) -> Any:
        return reduce_inner(cres)

    def rebuild(self, target_context: Any, payload: Any) -> Any:
        return rebuild_inner(target_context, payload)

    def check_cachable(self, cres: Any) -> bool:
        """Keep all: an address in code that is not optimised yet is seen where an entry links it in."""
        return True


class _CheckedFiles(caching.IndexDataCacheFile):
    """An index and its data files, each with a hash of its contents before them.

    A file that does not hold what its hash says goes, and counts as one that was never there. Data files
    have names of their own: two processes that fill one index cannot put one's code under the other's key.
    """

    def load(self, key: Any) -> Any:
        name = self._load_index().get(key)
        return None if name is None else self._read(name)

    def save(self, key: Any, data: Any) -> None:
        stem = self._index_name.removesuffix(".nbi")
        name = f"{stem}.{uuid.uuid4().hex[:16]}.nbc"
        self._write(name, data)
        self._write(self._index_name, {**self._load_index(), key: name})

    def _load_index(self) -> dict[Any, str]:
        found = self._read(self._index_name)
        return found if isinstance(found, dict) else {}

    def _read(self, name: str) -> Any:
        return _contents(Path(self._cache_path, name))

    def _write(self, name: str, value: Any) -> None:
        data = self._dump(value)
        with self._open_for_write(str(Path(self._cache_path, name))) as file:
            file.write(hashlib.sha256(data).digest() + data)


class KernelCache(caching.FunctionCache):
    """The cache of one kernel."""

    _impl_class: type[caching.CompileResultCacheImpl] = _KernelCacheImpl

    def __init__(self, py_func: Callable[..., Any]) -> None:
        super().__init__(py_func)
        stamp = self._impl.locator.get_source_stamp()
        self._cache_file = _CheckedFiles(self._cache_path, self._impl.filename_base, stamp)

    def save_overload(self, sig: Any, data: Any) -> None:
        try:
            super().save_overload(sig, data)
        except OSError as error:
            _warn(f"{error.strerror or error}".lower())

    def _index_key(self, sig: Any, codegen: Any) -> Any:
        # The source hash stands for the code. numba adds a hash of what a closure holds, which for a
        # compiled function is another in every process.
        return sig, codegen.magic_tuple()


class InnerCache(KernelCache):
    """The cache of what a kernel is to other kernels."""

    _impl_class: type[caching.CompileResultCacheImpl] = _InnerCacheImpl


@cache
def _warn(why: str) -> None:
    """Say once that nothing can be kept."""
    text = (
        f"{cache_folder()}: compiled kernels cannot be kept there: {why}; until they can, each start "
        "compiles them anew (ROPEWALK_CACHE_DIR names another folder)"
    )
    warnings.warn(text, CacheWarning, stacklevel=3)
