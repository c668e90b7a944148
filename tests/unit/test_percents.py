"""Per cents in sentences: never as powers of ten that nobody reads."""

from __future__ import annotations

import pytest

from ropewalk.words.percents import percent


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (0.2345, "0.23 %"),
        (99.4, "99 %"),
        (99.6, "100 %"),  # was 1e+02 %
        (103.56, "104 %"),
        (-1234.5, "-1234 %"),
        (0.0, "0 %"),
        (1.2e-7, "1.2e-07 %"),
        (3e9, "3e+09 %"),
    ],
)
def test_per_cents_are_written_out(value: float, text: str) -> None:
    assert percent(value) == text


def test_digits_and_signs() -> None:
    assert percent(103.56, 3) == "104 %"
    assert percent(1035.6, 3) == "1036 %"
    assert percent(150.0, sign="+") == "+150 %"
    assert percent(0.0, sign="+") == "+0 %"
