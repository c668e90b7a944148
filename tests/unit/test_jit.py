"""The compiler pass of our own: what it forwards must not change what a loop computes."""

from __future__ import annotations

import math

import numpy as np
import pytest
from numba.core.compiler import Flags
from numba.core.targetconfig import TargetConfig
from numba.core.typeinfer import TypeInferer

from ropewalk.core import passes
from ropewalk.core.compiler import EntryLibrary, entry
from ropewalk.core.jit import OPTIONS, PLAIN, kernel, part
from ropewalk.core.passes import Options


@part
def twice(value):
    return value + value


@kernel
def one_behind(n):
    """Return the last value but one: a copy of what the loop goes on to change."""
    before, now = -1, 0
    for _ in range(n):
        before = now
        now = now + 1
    return before


@kernel
def fibonacci(n):
    """Swap two variables in each round."""
    a, b = 0, 1
    for _ in range(n):
        a, b = b, a + b
    return a


@kernel
def behind_on_leaving(n):
    """Leave the loop with a copy taken before the last change."""
    now = 0
    while True:
        before = now
        now = now + 1
        if now > n:
            break
    return before


@kernel
def chain(n):
    """Copy a copy, call a part on it, and change the original."""
    now, total = 1, 0
    for _ in range(n):
        first = now
        second = first
        now = twice(second)
        total = total + second
    return total


@pytest.mark.parametrize("function", [one_behind, fibonacci, behind_on_leaving])
def test_copies_keep_their_values(function) -> None:
    assert [function(n) for n in range(12)] == [function.py_func(n) for n in range(12)]


def test_chains_of_copies_keep_their_values() -> None:
    assert [chain(n) for n in range(12)] == [2**n - 1 for n in range(12)]


@kernel
def sometimes_given(n):
    """Use a variable that one way through the loop leaves without a value."""
    total = 0
    for i in range(n):
        if i > 0:
            last = i
        if i > 1:
            total = total + last
    return total


def test_a_variable_may_be_given_on_one_way_only() -> None:
    assert [sometimes_given(n) for n in range(6)] == [0, 0, 0, 2, 5, 9]


def test_a_kernel_serves_python_and_kernels() -> None:
    """As an entry it has machine code; what it calls has none of its own until Python calls that."""
    called = entry(one_behind.py_func, OPTIONS)
    caller = entry(lambda n: called(n) + 1, OPTIONS)
    assert caller(5) == 5
    assert called.signatures == []
    (inner,) = called.inner.overloads.values()
    assert inner.library.get_pointer_to_function(inner.fndesc.llvm_cpython_wrapper_name) == 0
    assert called(5) == 4


def larger(a, b):
    return max(a, b) + min(a, b)


@pytest.mark.parametrize("shared", [True, False])
def test_kernels_with_equal_options_compare_none(monkeypatch, shared) -> None:
    """The second one finds what `max` is by the options of the first; the twin with its own compares them."""
    compared, equal = [], TargetConfig.__eq__

    def compare(one, other):
        compared.append(one)
        return equal(one, other)

    monkeypatch.setattr(TargetConfig, "__eq__", compare)
    if not shared:
        monkeypatch.setattr(Options, "copy", lambda self: Flags(self))
    for _ in range(2):
        assert entry(larger, OPTIONS)(2.0, 3.0) == 5.0
    assert (compared == []) == shared


def roots(numbers):
    """Return a sum of square roots."""
    total = 0.0
    for i in range(numbers.shape[0]):
        total += math.sqrt(numbers[i])
    return total


def both(count):
    """Return an entry that is called seldom and one that is not, of which each calls the same function."""
    called = entry(roots, OPTIONS)

    def caller(numbers):
        return called(numbers) + count

    return [entry(caller, OPTIONS, seldom=seldom) for seldom in (True, False)]


def shared_names(entries) -> list[set[str]]:
    """Return what each entry lets others link, but the function that Python calls."""
    found = []
    for one in entries:
        (made,) = one.overloads.values()
        code = made.library
        functions = [each for each in code._final_module.functions if not each.is_declaration]
        names = {each.name for each in functions if each.linkage.name != "internal"}
        found.append(names - {made.fndesc.llvm_cpython_wrapper_name})
    return found


@pytest.mark.skipif(PLAIN, reason="there is no machine code")
def test_entries_share_no_machine_code(monkeypatch) -> None:
    """What is compiled for the seldom call is not what the other one is linked to; numba's own way is."""
    numbers = np.random.default_rng(3).random(1000)
    entries = both(1)
    assert entries[0](numbers) == entries[1](numbers) == roots(numbers) + 1
    assert shared_names(entries) == [set(), set()]
    monkeypatch.setattr(EntryLibrary, "_keep_to_itself", lambda self: None)
    twins = both(2)
    assert twins[0](numbers) == twins[1](numbers)
    assert all(shared_names(twins))


@pytest.mark.skipif(PLAIN, reason="there is no machine code")
def test_numba_is_asked_once_what_a_sum_is(monkeypatch) -> None:
    """The second kernel asks for nothing that the first one did; with other types it asks anew."""
    asked = []
    ask = TypeInferer.resolve_call

    def note(self, function, args, named):
        asked.append((str(function), *map(str, args)))
        return ask(self, function, args, named)

    monkeypatch.setattr(TypeInferer, "resolve_call", note)
    monkeypatch.setattr(passes, "_CALLS", {})
    assert entry(lambda a, b: (a + b) * a, OPTIONS)(2.0, 3.0) == 10.0
    asked.clear()
    assert entry(lambda a, b: (a * b) + a, OPTIONS)(2.0, 3.0) == 8.0
    assert not asked
    assert entry(lambda a, b: (a * b) + a, OPTIONS)(2.0, 3) == 8.0
    assert asked


@pytest.mark.skipif(PLAIN, reason="there is no machine code")
@pytest.mark.parametrize("asked_for", [False, True])
def test_a_kernel_takes_no_option_from_the_one_that_calls_it_first(asked_for: bool) -> None:
    """Only what says so itself is put into its callers wherever it is called; numba hands that on."""
    own = {"forceinline": asked_for}
    called = entry(lambda a: a * a, OPTIONS | own)
    calls = entry(lambda a: called(a) + 1.0, OPTIONS | {"forceinline": True})
    assert calls(3.0) == 10.0
    (found,) = called.inner.overloads.values()
    assert found.fndesc.inline is asked_for
