"""Kernels that are compiled when another kernel first calls them."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import threading
from pathlib import Path
from types import SimpleNamespace
from typing import Any, NamedTuple

import numpy as np
import pytest
from numba.core import event, types
from numba.core.errors import TypingError

from ropewalk.core import compiler
from ropewalk.core.deferred import clock, uncounted
from ropewalk.core.jit import OPTIONS, PLAIN, deferred, kernel, part

pytestmark = pytest.mark.skipif(PLAIN, reason="nothing is compiled")


class Pair(NamedTuple):
    """A tuple that goes by its address."""

    numbers: Any
    out: Any


def fresh(function: Any, returns: str = "none", count: int = 0) -> Any:
    """Return a deferred kernel that nothing keeps on disk."""
    kind = getattr(types, returns)
    return compiler.deferred(function, OPTIONS, types.UniTuple(kind, count) if count else kind)


def _add(pair, factor, first=0):
    total = 0.0
    for i in range(first, pair.numbers.shape[0]):
        total += pair.numbers[i] * factor
    return total


def _write(pair, value):
    pair.out[0] = value


def _says(pair):
    return pair.numbers[0] > 0.0


def _counts(pair):
    return pair.numbers.shape[0]


add = fresh(_add, "float64")
write = fresh(_write)
says = fresh(_says, "boolean")
counts = fresh(_counts, "int64")
"""Found by these names, with the functions' own: see `_named`."""
for one in (add, write, says, counts):
    one.py_func.__qualname__ = one.py_func.__name__[1:]


@part
def _put_in(pair, factor):
    return add(pair, factor) + 10.0 * add(pair, factor, 1)


@kernel
def top(pair, factor, wanted):
    """Call all of them, many times, where that is wanted."""
    found = -1.0
    if wanted:
        for _ in range(3):
            found = _put_in(pair, factor)
        if says(pair):
            write(pair, found + counts(pair))
    return found


def test_a_deferred_kernel_is_compiled_when_it_is_called() -> None:
    pair = Pair(np.array([1.0, 2.0, 3.0]), np.zeros(1))
    assert top(pair, 2.0, False) == -1.0
    assert add.signatures == write.signatures == []
    assert top(pair, 2.0, True) == 112.0
    assert pair.out[0] == 115.0
    assert len(add.signatures) == 2  # with the first and without
    assert add(pair, 2.0, 2) == 6.0  # Python calls it, too


def _fails(pair):
    return pair.nothing


fails = fresh(_fails)
fails.py_func.__qualname__ = "fails"


@kernel
def call_fails(pair):
    """Call what numba cannot compile."""
    pair.out[0] += 1.0
    fails(pair)
    pair.out[0] += 1.0


def test_what_cannot_be_compiled_says_so_and_nothing_goes_on() -> None:
    pair = Pair(np.ones(1), np.zeros(1))
    for times in (1.0, 2.0):
        with pytest.raises(TypingError, match="nothing"):
            call_fails(pair)
        assert pair.out[0] == times


def _promises(pair):
    return pair.numbers[0]


promises = fresh(_promises, "int64")
promises.py_func.__qualname__ = "promises"


@kernel
def call_promises(pair):
    """Call what returns something else than it says."""
    return promises(pair)


def test_what_returns_something_else_is_not_called() -> None:
    with pytest.raises(TypeError, match="promises returns float64, and is said to return int64"):
        call_promises(Pair(np.ones(1), np.zeros(1)))


def _both_ends(pair):
    return pair.numbers[0], pair.numbers[2]


both_ends = fresh(_both_ends, "float64", 2)
both_ends.py_func.__qualname__ = "both_ends"


@kernel
def between_ends(pair):
    """Return how much more the last number is than the first."""
    first, last = both_ends(pair)
    return last - first


def test_several_numbers_come_back() -> None:
    assert between_ends(Pair(np.array([1.0, 2.0, 5.0]), np.zeros(1))) == 4.0


def test_the_decorator_tells_how_many_come_back() -> None:
    assert deferred("float64", 2)(_both_ends).returns == types.UniTuple(types.float64, 2)


def test_a_function_in_a_function_is_refused() -> None:
    def inside(pair):
        pair.out[0] = 1.0

    with pytest.raises(TypeError, match="inside"):
        deferred()(inside)


def _slow(pair):
    pair.out[0] = 1.0


slow = fresh(_slow)
slow.py_func.__qualname__ = "slow"


@kernel
def call_slow(pair):
    """Do something before and after."""
    slow(pair)
    pair.out[1] = 2.0


class At(event.Listener):
    """Does something when a kernel is compiled."""

    def __init__(self, name: str, does: Any) -> None:
        self._name, self._does = name, does

    def on_start(self, event: Any) -> None:
        """Do it."""
        if event.data["dispatcher"].py_func.__name__ == self._name:
            self._does()

    def on_end(self, event: Any) -> None:
        """Do nothing."""


def test_ctrl_c_while_it_is_compiled_waits_for_the_kernel() -> None:
    """The kernel ends as if nothing had been; then it is raised."""
    pair = Pair(np.ones(1), np.zeros(2))
    press = At("_slow", lambda: signal.raise_signal(signal.SIGINT))
    with event.install_listener("numba:compile", press), pytest.raises(KeyboardInterrupt):
        call_slow(pair)
    assert pair.out.tolist() == [1.0, 2.0]
    pair.out[:] = 0.0
    call_slow(pair)  # and only once
    assert pair.out.tolist() == [1.0, 2.0]


def _shared(pair):
    pair.out[0] += 1.0


shared = fresh(_shared)
shared.py_func.__qualname__ = "shared"


@kernel
def call_shared(pair):
    """Call it."""
    shared(pair)


def test_threads_ask_at_once() -> None:
    pairs = [Pair(np.ones(1), np.zeros(1)) for _ in range(4)]
    call = [threading.Thread(target=call_shared, args=(pair,)) for pair in pairs]
    for one in call:
        one.start()
    for one in call:
        one.join()
    assert [pair.out[0] for pair in pairs] == [1.0] * 4
    assert len(shared.signatures) == 1


EARLY = """
import os, signal, threading
import numpy as np
from ropewalk.core.jit import deferred, kernel
from numba.core import types
signal.signal(signal.SIGINT, signal.default_int_handler)

@deferred()
def late(out):
    out[0] = 1.0

@kernel
def busy(out, turns):
    for i in range(turns):
        out[1] = out[1] * 0.5 + i
    late(out)
    out[2] = 2.0

if __name__ != "__main__":
    out = np.zeros(3)
    busy.compile((types.float64[::1], types.int64))
    threading.Timer(0.2, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
    try:
        busy(out, 300_000_000)
    except KeyboardInterrupt:
        print("raised", out[0], out[2])
"""


def test_ctrl_c_before_it_is_asked_for_waits_for_the_kernel(tmp_path: Path) -> None:
    """Python then raises before anything can catch it, and what the callback returns is lost."""
    (tmp_path / "early.py").write_text(EARLY)
    own = os.environ | {"ROPEWALK_CACHE_DIR": str(tmp_path / "cache")}
    own["PYTHONPATH"] = os.pathsep.join([str(tmp_path), *sys.path])
    said = subprocess.run(
        [sys.executable, "-c", "import early"], env=own, check=True, capture_output=True, text=True
    )
    assert said.stdout.split() == ["raised", "1.0", "2.0"]


MODULE = """
import sys
from collections import namedtuple
import numpy as np
from numba.core import event
from ropewalk.core.jit import deferred, kernel
Pair = namedtuple("Pair", ["numbers", "out"])

@deferred("float64")
def first(pair):
    return pair.numbers[0]

@kernel
def top(pair):
    return first(pair)

made = []
class Listener(event.Listener):
    def on_start(self, event):
        made.append(event.data["dispatcher"].py_func.__name__)
    def on_end(self, event):
        pass

if __name__ != "__main__":
    with event.install_listener("numba:compile", Listener()):
        assert top(Pair(np.array([5.0]), np.zeros(1))) == 5.0
    print(*sorted(set(made)))
"""


def test_the_next_process_finds_it_on_disk(tmp_path: Path) -> None:
    """Its callers, from the cache, too, find it by name and by the names of the types."""
    (tmp_path / "kept_apart.py").write_text(MODULE)
    own = os.environ | {
        "ROPEWALK_CACHE_DIR": str(tmp_path / "cache"),
        "PYTHONPATH": os.pathsep.join([str(tmp_path), *sys.path]),
    }
    said = [
        subprocess.run(
            [sys.executable, "-c", "import kept_apart"],
            env=own,
            check=True,
            capture_output=True,
            text=True,
        ).stdout.split()
        for _ in range(2)
    ]
    assert said == [["first", "top"], []]


def test_what_is_not_counted_is_not_on_the_clock(monkeypatch: pytest.MonkeyPatch) -> None:
    now = [10.0]
    its_time = SimpleNamespace(perf_counter=lambda: now[0])
    monkeypatch.setattr("ropewalk.core.deferred.time", its_time)
    begun = clock()
    with uncounted():
        now[0] += 5.0
        with uncounted():
            now[0] += 2.0
    now[0] += 1.0
    assert clock() - begun == pytest.approx(1.0)
