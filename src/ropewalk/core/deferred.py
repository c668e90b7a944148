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
import sys
import threading
import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from typing import Any, TypeVar

import llvmlite.binding as llvm
from llvmlite import ir
from numba.core import cgutils, types
from numba.core.callconv import RETCODE_EXC
from numba.core.typing import signature  # type: ignore[attr-defined]

from ropewalk.core.pointed import Pointed, known

T = TypeVar("T")
R = TypeVar("R")
_ASK = "ropewalk_address_of"
_FAILED = 1  # no address
_BYTES, _LENGTH = ir.IntType(8).as_pointer(), ir.IntType(64)


class _Pickler(pickle.Pickler):
    """Writes the types of a kernel's arguments; those of tuples that go by address by their names alone."""

    def persistent_id(self, obj: Any) -> Any:
        return obj.name if isinstance(obj, Pointed) else None

    def reducer_override(self, obj: Any) -> Any:
        """Leave out a type's number, another one in each process."""
        if not isinstance(obj, types.Type):
            return NotImplemented
        reduced: Any = obj.__reduce__()
        function, (make, args, state) = reduced
        return function, (make, args, {k: v for k, v in state.items() if k != "_code"})


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

_own = threading.local()  # `waited`: for deferred kernels, in this thread [s]


def waited() -> float:
    """Return how long this thread has waited for deferred kernels so far [s]."""
    return getattr(_own, "waited", 0.0)


def wait_too(seconds: float) -> None:
    """Count, for this thread, what those have waited that it waited for [s]."""
    _own.waited = waited() + seconds


@contextmanager
def uncounted() -> Iterator[None]:
    """Count what is done inside as waited for, by this thread."""
    begun = clock()
    try:
        yield
    finally:
        wait_too(clock() - begun)


def each(go: Callable[[T], R], items: Iterable[T]) -> tuple[list[R], float]:
    """Return what `go` returns of each, and how long this thread has waited for deferred kernels [s]."""
    before = waited()
    return [go(one) for one in items], waited() - before


def clock() -> float:
    """Return the wall time without what this thread has waited for deferred kernels [s]."""
    return time.perf_counter() - waited()


_addresses: dict[bytes, int] = {}
_late = threading.local()  # what could not be raised in a kernel: `error`, `pressed` (Ctrl-C)


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
        if not getattr(_late, "pressed", False):
            print("interrupted: ends when this step's kernels are compiled", file=sys.stderr)
        _late.pressed = True

    signal.signal(signal.SIGINT, note)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)


def _answer(start: int, length: int, place: int, again: int) -> None:
    """Write the address of a kernel to a place, FAILED where it cannot be compiled.

    Where nothing is written it is asked again: a signal's handler has raised where nothing here could catch
    it, and ctypes has dropped that.
    """
    if again:
        _late.pressed = True
    word, found = ctypes.string_at(start, length), _FAILED
    try:
        if word not in _addresses:
            began = time.perf_counter()
            try:
                with _undisturbed():
                    _make_ready(word)
            finally:
                wait_too(time.perf_counter() - began)
        found = _addresses[word]
    except KeyboardInterrupt:
        _late.pressed = True
        return
    except BaseException as error:
        _late.error = error
    ctypes.c_uint64.from_address(place).value = found


_callback = ctypes.CFUNCTYPE(
    None, ctypes.c_void_p, ctypes.c_int64, ctypes.c_void_p, ctypes.c_int64
)(_answer)
llvm.add_symbol(_ASK, ctypes.cast(_callback, ctypes.c_void_p).value)


def raise_late() -> None:
    """Raise what came up while a kernel ran that has returned."""
    found = vars(_late)
    if not found:
        return
    error, pressed = found.pop("error", None), found.pop("pressed", False)
    if pressed:
        signal.raise_signal(signal.SIGINT)
        if not callable(signal.getsignal(signal.SIGINT)):
            raise KeyboardInterrupt  # it was another signal
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
        begin, ask, told, keep, failed, go = (stub.append_basic_block() for _ in range(6))
        builder = ir.IRBuilder(begin)
        answer = builder.alloca(_BYTES)
        builder.store(null, answer)
        there = builder.load(slot)
        builder.cbranch(builder.icmp_unsigned("==", there, null), ask, go)
        builder.position_at_end(ask)
        again = builder.phi(_LENGTH)
        again.add_incoming(_LENGTH(0), begin)
        again.add_incoming(_LENGTH(1), ask)
        asking = ir.FunctionType(ir.VoidType(), [_BYTES, _LENGTH, _BYTES, _LENGTH])
        asked = cgutils.get_or_insert_function(module, asking, _ASK)
        text, place = builder.bitcast(word, _BYTES), builder.bitcast(answer, _BYTES)
        builder.call(asked, [text, _LENGTH(len(self._word)), place, again])
        found = builder.load(answer)
        builder.cbranch(builder.icmp_unsigned("==", found, null), ask, told)
        builder.position_at_end(told)
        bad = ir.Constant(_LENGTH, _FAILED).inttoptr(_BYTES)
        builder.cbranch(builder.icmp_unsigned("==", found, bad), failed, keep)
        builder.position_at_end(keep)
        builder.store(found, slot)
        builder.branch(go)
        builder.position_at_end(failed)
        builder.ret(RETCODE_EXC)
        builder.position_at_end(go)
        address = builder.phi(_BYTES)
        address.add_incoming(there, begin)
        address.add_incoming(found, keep)
        kernel = builder.bitcast(address, stub.type)
        builder.ret(builder.call(kernel, stub.args, tail=True))


def calls_of(entry: Any, args: tuple[Any, ...]) -> Any:
    """Return what numba finds the code of calls by."""
    key, call = object(), _Call(entry, args)
    entry.targetdescr.target_context.insert_func_defn([(call, key, args)])
    return key
