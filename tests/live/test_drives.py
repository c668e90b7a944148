"""What an obstacle's drive gives the ropes is put in, and no loss that is less than nothing."""

from __future__ import annotations

import numpy as np
import pytest

import ropewalk as rw
from live.drive import do
from ropewalk.live.pictures import picture
from ropewalk.live.recorded import Recorded
from ropewalk.live.session import Session
from ropewalk.record.result import Result
from ropewalk.scene import Scene
from ropewalk.scene.presets import preset


def capstan(duration: float = 1.5) -> Scene:
    """A drum that turns from 1 s on and lifts 12 kg."""
    scene = preset("capstan")
    return scene.replace(run=scene.run.replace(duration=duration))


@pytest.fixture(scope="module")
def run() -> Result:
    return rw.simulate(capstan())


def motor_of(result: Result) -> float:
    """Return what the drum's drive has done by the books of contacts [J]."""
    return float(result.read("contact_work", result.frames - 1, result.frames)[0, 0, 0])


def test_what_a_driven_drum_gives_is_put_in(run: Result) -> None:
    """Lost read -4.4 J, where friction took 0.28 J."""
    found = Recorded(run).picture(run.frames - 1).scalars
    assert motor_of(run) > 4.0
    assert found["put_in"] == pytest.approx(motor_of(run), rel=1e-9)
    friction = run.read("contact_work", 0, run.frames)[-1, 0, 2]
    assert 0.9 * -friction < found["lost"] < 1.3 * -friction


def test_a_session_shows_it_as_a_replay_does_and_it_balances(run: Result) -> None:
    session = Session(capstan())
    first = picture(session.main).scalars
    session.advance(round(1.5 / session.main.dt))
    found, played = picture(session.main).scalars, Recorded(run).picture(run.frames - 1).scalars
    assert found["time"] == pytest.approx(played["time"])
    for name in ("lost", "put_in"):
        assert found[name] == pytest.approx(played[name], rel=1e-6)
    gained = sum(found[name] - first[name] for name in ("kinetic", "gravity", "elastic"))
    given = found["put_in"] - found["lost"] + found["energy_error"]
    assert gained == pytest.approx(given, rel=1e-9)
    assert abs(found["energy_error"]) < 1e-3 * found["put_in"]
    before = picture(session.main).scalars
    do(session, "set", name="gravity", value=[0.0, 0.0, -9.8])  # the books of contacts begin anew
    after = picture(session.main).scalars
    assert after["lost"] == pytest.approx(before["lost"], abs=1e-6)
    do(session, "reset")
    assert picture(session.main).scalars["put_in"] == pytest.approx(0.0, abs=1e-9)


def test_a_part_goes_on_from_what_the_drives_of_the_one_before_have_given(run: Result) -> None:
    class Later(Recorded):
        """The same run, as if it went on from the end of the other."""

        @property
        def time(self) -> np.ndarray:
            return np.asarray(run.time) + run.time[-1]

    first, second = Recorded(run), Later(run)
    second.follow(first)
    for reader in (second, second.again()):
        found = reader.picture(0).scalars
        assert found["put_in"] == pytest.approx(motor_of(run), rel=1e-9)


def test_a_wheel_that_turns_freely_puts_nothing_in() -> None:
    """Its books name what its surface does a motor's work, which comes from the ropes."""
    scene = preset("pulley")
    result = rw.simulate(scene.replace(run=scene.run.replace(duration=0.3)))
    found = Recorded(result).picture(result.frames - 1).scalars
    assert abs(motor_of(result)) > 1e-3
    assert abs(found["put_in"]) < 0.02 * abs(motor_of(result))
