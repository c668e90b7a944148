"""How far a session's energy is off, of what it has turned over."""

from __future__ import annotations

import math

from ropewalk.live.energy_off import Balance


def share(balance: Balance) -> float:
    """Return the error of what has changed most [1]."""
    told = balance.scalars
    return told["energy_off"] / told["energy_turned"]


def test_it_is_a_share_of_what_has_changed_most_since_the_begin() -> None:
    begun = Balance.begun(50.0)
    assert begun.scalars == {"energy_off": 0.0, "energy_turned": 0.0}
    later = begun.later((2.0, -4.0, 51.0, 0.0), -0.4)
    assert share(later) == 0.1  # of 4 J of gravity, not of the 50 J that it was stretched with
    assert share(later.later((0.0, -8.0, 51.0, 0.0), 0.1)) == 0.05  # the largest error stays
    assert share(later.later((0.0, -4.0, 50.0, 8.0), 0.1)) == 0.05  # of what friction took


def test_rounding_where_nothing_moves_is_none_nor_is_a_step_that_broke() -> None:
    still = Balance.begun(1.0).later((0.0, 0.0, 1.0 + 1e-9, 0.0), 6e-7)
    assert still.scalars["energy_off"] == 0.0
    broken = still.later((math.nan, 0.0, 1.0, math.nan), math.inf)
    assert broken.scalars == still.scalars


def test_a_shorter_step_is_judged_by_what_it_does_itself() -> None:
    coarse = Balance.begun(0.0).later((2.0, 0.0, 0.0, 0.0), 0.5)
    fine = coarse.again().later((2.0, 0.0, 0.0, 0.0), 0.51)
    assert abs(share(fine) - 0.005) < 1e-12
