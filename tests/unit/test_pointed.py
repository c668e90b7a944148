"""What kernels are handed, and how they take numbers out of arrays: as Python does."""

from __future__ import annotations

from collections.abc import Iterator
from copy import deepcopy
from typing import Any, NamedTuple

import numpy as np
import pytest
from numba.core.errors import TypingError

from ropewalk.core import cache
from ropewalk.core.addresses import Kept, handed
from ropewalk.core.jit import PLAIN, kernel


class Inner(NamedTuple):
    """A tuple in a tuple."""

    numbers: Any
    count: int


class Outer(NamedTuple):
    """All kinds of members."""

    table: Any
    inner: Inner
    each: tuple[Any, Any]
    nothing: None
    factor: float
    flag: bool


@kernel
def read(outer, out):
    """Read every member, some of them in a branch and in a loop."""
    out[0] = outer.table[1, 2] + outer.table[-1, -1]
    for i in range(outer.inner.count):
        if outer.flag:
            out[1] += outer.inner.numbers[i] * outer.factor
    out[2] = outer.each[0][0] + outer.each[1][1, 0]
    out[3] = 1.0 if outer.nothing is None else 0.0
    out[4] = outer[1][0][1] + outer[-2]


@kernel
def read_inner(inner, out):
    """Hand a tuple of a tuple on."""
    out[5] = inner.numbers[inner.count - 1]


@kernel
def hand_on(outer, out):
    """Hand tuples on to other kernels."""
    read(outer, out)
    read_inner(outer.inner, out)


@kernel
def count_sizes(outer, out):
    """Count what is there."""
    out[0], out[1], out[2] = outer.table.size, outer.table.shape[1], outer.inner.numbers.size


@kernel
def take(row, table, cube, lo, hi, i, out):
    """Take elements, rows and ranges out of arrays."""
    some, others = row[lo:hi], table[i, lo:hi]
    out[0], out[1] = some.shape[0], others.shape[0]
    for k in range(some.shape[0]):
        out[2] += some[k] * (k + 1.0)
    for k in range(others.shape[0]):
        out[3] += others[k] * (k + 1.0)
    whole, flat = table[i], cube[i]
    out[4], out[5] = whole[-1], flat[1, -1]
    out[6], out[7] = cube[i, 1, -2], cube[i, 1][2]
    rest = row[lo:]
    out[8] = rest.shape[0]


@kernel
def put(table, whole, i, value):
    """Write elements."""
    table[i, -1] = value
    table[i][0] = 2 * value
    whole[i] = 7


@pytest.fixture(autouse=True, scope="module")
def own_cache(tmp_path_factory: pytest.TempPathFactory) -> Iterator[None]:
    folder = tmp_path_factory.mktemp("kernels")
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(cache, "cache_folder", lambda: folder)
        yield


def outer(table: Any, numbers: Any) -> Outer:
    return Outer(
        table, Inner(numbers, 3), (np.array([5.0]), np.eye(2)[::-1].copy()), None, 0.5, True
    )


def expected(value: Outer) -> np.ndarray:
    table, numbers = value.table, value.inner.numbers
    first = table[1, 2] + table[-1, -1]
    return np.array([first, 0.5 * numbers[:3].sum(), 6.0, 1.0, numbers[1] + 0.5, numbers[2]])


@pytest.mark.parametrize("how", ["whole", "turned", "stepped"])
def test_members_are_what_they_are(how: str) -> None:
    """Of every kind of member, in arrays of every layout."""
    base, line = np.arange(24.0).reshape(4, 6), np.arange(10.0) + 0.25
    value = {
        "whole": outer(base.copy(), line.copy()),
        "turned": outer(np.asfortranarray(base), line[2:8]),
        "stepped": outer(base[::2, ::-1], line[::3]),
    }[how]
    out = np.zeros(6)
    hand_on(value, out)
    assert np.array_equal(out, expected(value))
    count_sizes(value, out)
    table = value.table
    assert out[:3].tolist() == [table.size, table.shape[1], value.inner.numbers.size]


def test_a_tuple_with_new_arrays_is_read_anew() -> None:
    """Nothing is kept of a tuple from one call to the next."""
    for shift in (0.0, 100.0):
        value = outer(np.arange(24.0).reshape(4, 6) + shift, np.arange(4.0) + shift)
        out = np.zeros(6)
        hand_on(value, out)
        assert np.array_equal(out, expected(value))


def test_a_block_is_taken_for_its_tuple() -> None:
    """What its arrays hold now; tuples of other types, and that one itself, are handed over beside it."""
    value = outer(np.arange(24.0).reshape(4, 6), np.arange(4.0))
    other = outer(np.asfortranarray(np.ones((4, 6))), np.arange(8.0)[::2])
    blocks = handed(value, other, value.inner)
    value.table[1, 2] = 77.0
    for one, block in zip((value, other), blocks[:2], strict=True):
        for given in (one, block, one):
            out = np.zeros(6)
            hand_on(given, out)
            assert np.array_equal(out, expected(one))
    out = np.zeros(6)
    read_inner(blocks[2], out)
    assert out[5] == value.inner.numbers[2]


@pytest.mark.skipif(PLAIN, reason="Python has no addresses")
def test_a_copy_of_what_is_kept_has_its_own_arrays() -> None:
    kept = Kept(outer(np.arange(24.0).reshape(4, 6), np.arange(4.0)))
    twin = deepcopy(kept)
    kept.value.table[1, 2] = 77.0
    for one in (kept, twin):
        out = np.zeros(6)
        hand_on(one.block, out)
        assert np.array_equal(out, expected(one.value))
    assert twin.value.table[1, 2] == 8.0


@kernel
def add_numbers(inner, out):
    """Read two numbers that stand in a tuple."""
    out[0] = inner.numbers + inner.count


@pytest.mark.parametrize("kind", [np.int8, np.int32, np.uint16, np.int64, np.float32, np.float64])
def test_numbers_of_every_length_are_what_they_are(kind: Any) -> None:
    for value in (kind(101), kind(-7) if np.issubdtype(kind, np.signedinteger) else kind(7)):
        out = np.zeros(1)
        add_numbers(Inner(value, 3), out)
        assert out[0] == value + 3.0


@pytest.mark.skipif(PLAIN, reason="Python has numbers of any length")
def test_a_number_that_is_too_long_is_refused() -> None:
    with pytest.raises(OverflowError):
        add_numbers(Inner(np.uint64(2**64 - 1), 3), np.zeros(1))


@pytest.mark.skipif(PLAIN, reason="without types nothing is refused")
def test_other_types_are_compiled_for() -> None:
    value = outer(np.arange(24).reshape(4, 6), np.arange(4, dtype=np.int64))
    out = np.zeros(6)
    hand_on(value, out)
    assert np.array_equal(out, expected(value))
    with pytest.raises(TypingError):
        hand_on(value._replace(table="words"), out)


@pytest.mark.parametrize("seed", range(40))
def test_indices_mean_what_they_mean_to_python(seed: int) -> None:
    """Elements, rows and ranges, from the end, beyond the ends and empty ones, too."""
    random = np.random.default_rng(seed)
    n = int(random.integers(3, 9))
    row, table, cube = random.random(n), random.random((3, n)), random.random((3, 2, n))
    lo, hi = (int(random.integers(-2 * n, 2 * n)) for _ in range(2))
    i = int(random.integers(-3, 3))
    out = np.zeros(9)
    take(row, table, cube, lo, hi, i, out)
    some, others = row[lo:hi], table[i, lo:hi]
    weighed = [float(part @ np.arange(1.0, part.size + 1.0)) for part in (some, others)]
    sizes = [some.size, others.size]
    elements = [table[i, -1], cube[i, 1, -1], cube[i, 1, -2], cube[i, 1, 2]]
    assert out == pytest.approx([*sizes, *weighed, *elements, row[lo:].size], rel=1e-14)


@pytest.mark.parametrize("i", [-3, -1, 0, 2])
def test_elements_are_written_where_python_writes_them(i: int) -> None:
    table, whole = np.zeros((3, 4)), np.zeros(3, dtype=np.int64)
    put(table, whole, i, 1.5)
    expected = np.zeros((3, 4))
    expected[i, -1], expected[i, 0] = 1.5, 3.0
    assert np.array_equal(table, expected)
    assert whole[i] == 7
    assert np.count_nonzero(whole) == 1
