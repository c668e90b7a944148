"""Kernels that other kernels call by address: compiled when the first call of a process reaches them.

A kernel that is linked into its callers is compiled with each of them, whether a scene calls it or not. Of
a deferred one the callers know what it takes and returns, and a place for its address, empty as a process
begins. Who finds it empty asks Python, which compiles the kernel or takes it from the cache.
"""

from __future__ import annotations

import ctypes
import hashlib
import importlib
import io
import pickle
import signal
import threading
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import Any

import llvmlite.binding as llvm
from llvmlite import ir
from numba.core import cgutils
from numba.core.callconv import RETCODE_EXC
from numba.core.typing import signature  # type: ignore[attr-defined]

from ropewalk.core.pointed import Pointed, known

_ASK = "ropewalk_address_of"
_BYTES, _LENGTH = ir.IntType(8).as_pointer(), ir.IntType(64)


class _Pickler(pickle.Pickler):
    """Writes the types of a kernel's arguments; those of tuples that go by address by their names alone."""

    def persistent_id(self, obj: Any) -> Any:
        return obj.name if isinstance(obj, Pointed) else None


class _Unpickler(pickle.Unpickler):
    """Reads them; the tuples are those of the call from Python that runs."""

    def persistent_load(self, name: Any) -> Any:
        return known(name)


def _word_for(entry: Any, args: tuple[Any, ...]) -> bytes:
    """Return what tells a kernel and the types of its arguments in every process."""
    function, file = entry.py_func, io.BytesIO()
    _Pickler(file).dump((function.__module__, function.__qualname__, args))
    return file.getvalue()


# -- when a kernel is called ---------------------------------------------------------------


class _Waits:
    """How long kernels have waited for others, in whatever threads."""

    def __init__(self) -> None:
        self._lock, self._waiting, self._since, self._before = threading.Lock(), 0, 0.0, 0.0

    @contextmanager
    def wait(self) -> Iterator[None]:
        """Count the time inside."""
        self._count(1)
        try:
            yield
        finally:
            self._count(-1)

    def _count(self, more: int) -> None:
        with self._lock:
            now = time.perf_counter()
            if self._waiting == 0:
                self._since = now
            self._waiting += more
            if self._waiting == 0:
                self._before += now - self._since

    def clock(self) -> float:
        """Return the time without them [s]."""
        with self._lock:
            now = self._since if self._waiting else time.perf_counter()
            return now - self._before


_waits = _Waits()
clock = _waits.clock
"""clock(): the wall time without what was spent on making deferred kernels ready [s]."""

_addresses: dict[bytes, int] = {}
_late = (
    threading.local()
)  # what could not be raised while a kernel ran: `error`, `pressed` for Ctrl-C


def _make_ready(word: bytes) -> None:
    module, name, args = _Unpickler(io.BytesIO(word)).load()
    entry = importlib.import_module(module)
    for part in name.split("."):
        entry = getattr(entry, part)
    entry.compile(args)
    result = entry.overloads[args]
    _addresses[word] = result.library.get_pointer_to_function(result.fndesc.llvm_func_name)


@contextmanager
def _undisturbed() -> Iterator[None]:
    """Keep Ctrl-C back, which cannot pass through a kernel: `raise_late` has it raised."""
    before = signal.getsignal(signal.SIGINT)
    if threading.current_thread() is not threading.main_thread() or not callable(before):
        yield
        return

    def note(*_: Any) -> None:
        _late.pressed = True

    signal.signal(signal.SIGINT, note)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)


def _answer(start: int, length: int) -> int:
    """Return the address of a kernel, 0 where it cannot be compiled."""
    word = ctypes.string_at(start, length)
    if word not in _addresses:
        try:
            with _undisturbed(), _waits.wait():
                _make_ready(word)
        except BaseException as error:
            _late.error = error
    return _addresses.get(word, 0)


_callback = ctypes.CFUNCTYPE(ctypes.c_void_p, ctypes.c_void_p, ctypes.c_int64)(_answer)
llvm.add_symbol(_ASK, ctypes.cast(_callback, ctypes.c_void_p).value)


def raise_late() -> None:
    """Raise what came up while a kernel ran that has returned."""
    found = vars(_late)
    if not found:
        return
    error, pressed = found.pop("error", None), found.pop("pressed", False)
    if pressed:
        signal.raise_signal(signal.SIGINT)
    if error is not None:
        raise error from None


# -- how a call is compiled ------------------------------------------------------------------


class _Call:
    """The code of calls of a kernel with arguments of some types."""

    libs = ()

    def __init__(self, entry: Any, args: tuple[Any, ...]) -> None:
        self.signature = signature(entry.returns, *args)
        self._word = _word_for(entry, args)
        code = hashlib.sha1(self._word).hexdigest()[:12]
        self._name = f"ropewalk.deferred.{entry.py_func.__name__}.{code}"

    def __call__(self, context: Any, builder: Any, called: Any, args: Sequence[Any]) -> Any:
        convention = context.call_conv
        kind = convention.get_function_type(called.return_type, called.args)
        stub = cgutils.get_or_insert_function(builder.module, kind, self._name)
        if stub.is_declaration:
            self._fill(stub)
        status, found = convention.call_function(
            builder, stub, called.return_type, called.args, args
        )
        with cgutils.if_unlikely(builder, status.is_error):
            convention.return_status_propagate(builder, status)
        return found

    def _fill(self, stub: Any) -> None:
        """Write the function of a module that finds the address, and goes on there."""
        module, null = stub.module, ir.Constant(_BYTES, None)
        stub.linkage = "linkonce_odr"
        stub.attributes.add("noinline")
        slot = ir.GlobalVariable(module, _BYTES, f"{self._name}.address")
        slot.linkage, slot.initializer = "internal", null
        text = cgutils.make_bytearray(self._word)
        word = cgutils.global_constant(module, f"{self._name}.word", text)
        begin, ask, failed, go = (stub.append_basic_block() for _ in range(4))
        builder = ir.IRBuilder(begin)
        there = builder.load(slot)
        builder.cbranch(builder.icmp_unsigned("==", there, null), ask, go)
        builder.position_at_end(ask)
        asking = ir.FunctionType(_BYTES, [_BYTES, _LENGTH])
        asked = cgutils.get_or_insert_function(module, asking, _ASK)
        found = builder.call(asked, [builder.bitcast(word, _BYTES), _LENGTH(len(self._word))])
        builder.store(found, slot)
        builder.cbranch(builder.icmp_unsigned("==", found, null), failed, go)
        builder.position_at_end(failed)
        builder.ret(RETCODE_EXC)
        builder.position_at_end(go)
        address = builder.phi(_BYTES)
        address.add_incoming(there, begin)
        address.add_incoming(found, ask)
        kernel = builder.bitcast(address, stub.type)
        builder.ret(builder.call(kernel, stub.args, tail=True))


def calls_of(entry: Any, args: tuple[Any, ...]) -> Any:
    """Return what numba finds the code of calls by."""
    key, call = object(), _Call(entry, args)
    entry.targetdescr.target_context.insert_func_defn([(call, key, args)])
    return key
