"""The force at the first anchor, for pages that play it: of every piece of a tick, and it changes nothing."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from live.drive import slack_rope
from ropewalk.live.ear import RATE, Ear
from ropewalk.live.session import Session


class Told:
    """An audience that keeps what it is told."""

    size = 1

    def __init__(self) -> None:
        self.messages: list[dict[str, Any]] = []

    def show(self, number: int, frame: bytes, combine: Any = None) -> None:
        """Show nothing."""

    def tell(self, message: dict[str, Any]) -> None:
        """Keep a message."""
        self.messages.append(message)


def test_what_is_heard_is_the_force_of_the_anchor_step_by_step() -> None:
    session, twin = Session(slack_rope()), Session(slack_rope())
    ear, told = Ear(), Told()
    ear.listen(7, True)
    ear.attend(session.main)
    session.advance(100)
    ear.tell(told, session.main.dt, 0.5)
    (message,) = told.messages
    every = ear.steps(twin.main.dt)
    assert message["seconds"] == pytest.approx(2.0 * every * twin.main.dt)  # at half speed
    forces = []
    for _ in range(100 // every):
        twin.advance(every)
        forces.append(twin.main.simulation.anchors["left"].reaction[2])
    assert message["forces"] == pytest.approx(forces, abs=1e-6)
    assert np.ptp(forces) > 0.01
    # and the rope moves as if nobody listened, to the bit
    assert np.array_equal(session.main.simulation.positions, twin.main.simulation.positions)


def test_steps_that_are_too_short_are_not_all_heard() -> None:
    assert Ear().steps(1e-3) == 1
    assert Ear().steps(1e-5) == round(1e5 / RATE)


def test_nobody_hears_what_nobody_wants_to() -> None:
    session, ear, told = Session(slack_rope()), Ear(), Told()
    ear.listen(7, True)
    ear.attend(session.main)
    ear.listen(7, False)
    ear.attend(session.main)
    session.advance(50)
    ear.tell(told, session.main.dt, 1.0)
    assert told.messages == []
