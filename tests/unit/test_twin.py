"""Two numbers in one register: each is rounded as it would be alone."""

from __future__ import annotations

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.core.jit import kernel
from ropewalk.core.twin import Twin, first, second, twin


def formula(a, b, c):  # type: ignore[no-untyped-def]
    """Use every operation, of two and of one with a number on either side."""
    return -(a * b + c) / (a - 2.0 * b) * (1.0 / c) - (1.0 - b) * 3.0 + c / 7.0


FORMULA = kernel(formula)


@kernel
def both(rows, found):  # type: ignore[no-untyped-def]
    """Write the formula of columns 0 and 1 of `rows`, (k, 3, 2), once side by side and once alone."""
    for k in range(rows.shape[0]):
        a, b, c = rows[k, 0], rows[k, 1], rows[k, 2]
        result = FORMULA(twin(a[0], a[1]), twin(b[0], b[1]), twin(c[0], c[1]))
        found[0, k, 0], found[0, k, 1] = first(result), second(result)
        for lane in range(2):
            found[1, k, lane] = FORMULA(a[lane], b[lane], c[lane])


def rows() -> Floats:
    """Return numbers of both signs and all sizes, zero and infinity among them."""
    rng = np.random.default_rng(5)
    numbers = rng.normal(size=(500, 3, 2)) * 10.0 ** rng.integers(-12, 12, (500, 3, 2))
    numbers[7, 0, 1], numbers[8, 1, 0], numbers[9, 2, 1] = 0.0, np.inf, 0.0
    return numbers


def test_a_twin_has_the_bits_of_two_numbers() -> None:
    numbers = rows()
    found = np.zeros((2, len(numbers), 2))
    with np.errstate(all="ignore"):
        both(numbers, found)
    np.testing.assert_array_equal(found[0], found[1])
    assert len(np.unique(found[0])) > 900  # the lanes are not mixed up
    assert not np.array_equal(found[0][:, 0], found[0][:, 1])


def test_without_the_compiler_it_does_the_same() -> None:
    numbers = rows()
    found = np.zeros((2, len(numbers), 2))
    both(numbers, found)
    for lanes, compiled in zip(numbers.tolist(), found[0], strict=True):
        if np.isfinite(compiled).all() and 0.0 not in np.ravel(lanes):  # Python raises there
            plain = formula(*(Twin(*pair) for pair in lanes))  # type: ignore[no-untyped-call]
            assert plain.numbers == tuple(compiled)
