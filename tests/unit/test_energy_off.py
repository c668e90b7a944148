"""How far a session's energy is off, of what it has turned over."""

from __future__ import annotations

import math

import pytest

from ropewalk.live.carried_pieces import Carried
from ropewalk.live.energy_off import Balance, Now


def share(balance: Balance) -> float:
    """Return the error of what has changed most [1]."""
    told = balance.scalars
    return told["energy_off"] / told["energy_turned"]


def test_it_is_a_share_of_what_has_changed_most_since_the_begin() -> None:
    begun = Balance.begun(50.0)
    assert begun.scalars == {"energy_off": 0.0, "energy_turned": 0.0}
    later = begun.later(Now(2.0, -4.0, 51.0), -0.4)
    assert share(later) == 0.1  # of 4 J of gravity, not of the 50 J that it was stretched with
    assert share(later.later(Now(0.0, -8.0, 51.0), 0.1)) == 0.05  # the largest error stays


def test_friction_counts_as_far_as_it_had_taken_when_the_error_came() -> None:
    """Friction that goes on and on later would hide any error."""
    early = Balance.begun(50.0).later(Now(2.0, -4.0, 50.0), 0.4)
    assert share(early.later(Now(2.0, -4.0, 50.0, 8.0), 0.1)) == 0.1
    assert share(early.later(Now(2.0, -4.0, 50.0, 8.0), 0.8)) == 0.1  # with it
    assert share(early.later(Now(2.0, -4.0, 50.0, 8.0), 1.6)) == 0.2


def test_what_pieces_have_as_wholes_hides_no_error() -> None:
    """A load that falls turns over any energy; what falls freely has an account of its own."""
    fall = Now(90.0, -100.0, 1.0, 0.0, Carried(89.0, -98.0))
    assert share(Balance.begun(0.0).later(fall, 0.4)) == pytest.approx(0.2)
    free = Now(105.0, -100.0, 1.0, 0.0, Carried(104.0, -100.0, 4.0))
    assert share(Balance.begun(0.0).later(free, 4.0)) == pytest.approx(4.0 / 105.0)


def test_rounding_where_nothing_moves_is_none_nor_is_a_step_that_broke() -> None:
    still = Balance.begun(1.0).later(Now(0.0, 0.0, 1.0 + 1e-9), 6e-7)
    assert still.scalars["energy_off"] == 0.0
    broken = still.later(Now(math.nan, 0.0, 1.0, math.nan), math.inf)
    assert broken.scalars == still.scalars


def test_a_shorter_step_is_judged_by_what_it_does_itself() -> None:
    coarse = Balance.begun(0.0).later(Now(2.0, 0.0, 0.0), 0.5)
    fine = coarse.again().later(Now(2.0, 0.0, 0.0), 0.51)
    assert abs(share(fine) - 0.005) < 1e-12
