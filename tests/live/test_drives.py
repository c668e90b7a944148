"""What an obstacle's drive gives the ropes is put in, and no loss that is less than nothing."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

import ropewalk as rw
from live.drive import do
from ropewalk.live.frame import Picture
from ropewalk.live.keeper import SETTLED, Keeper
from ropewalk.live.pictures import picture
from ropewalk.live.recorded import Recorded
from ropewalk.live.replay import ReplayBroadcast
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


def turning() -> Session:
    """Return a session of the capstan whose drum turns from the beginning on."""
    scene = capstan()
    drum = scene.obstacles[0]
    assert drum.spin is not None
    return Session(scene.replace(obstacles=[drum.replace(spin=drum.spin.replace(start=0.0))]))


def kept(folder: Path, interval: float) -> tuple[Picture, list[Recorded]]:
    """Play a session with a change of constants now and then [s]; return its last picture, and its parts."""
    session = turning()
    keeper, frame = Keeper(session, folder), session.frame_steps
    for friction in (60.0, 70.0, 80.0):
        session.advance(round(interval / session.main.dt / frame) * frame)
        do(session, "set", name="spring_friction", value=friction)
    session.advance(5 * frame)
    keeper.close()
    return picture(session.main), ReplayBroadcast(folder, playing=False).parts


@pytest.mark.parametrize("often", [0.15, 1.1])  # so often that no part begins, and seldom
def test_a_replay_tells_what_a_session_does_though_constants_change_while_a_drum_drives(
    often: float, tmp_path: Path
) -> None:
    """Lost read -2.6 J where it was 0.3: the books began anew with every change, but no part of the run."""
    shown, found = kept(tmp_path / "run", often * SETTLED)
    assert len(found) == (4 if often > 1.0 else 3)
    told = found[-1].picture(found[-1].frames - 1)
    assert told.scalars["time"] == pytest.approx(shown.scalars["time"])
    for name in ("lost", "put_in"):
        assert told.scalars[name] == pytest.approx(shown.scalars[name], rel=1e-6), name
    assert told.touch.rubbed == pytest.approx(shown.touch.rubbed, rel=1e-6)


def test_parts_of_a_folder_whose_books_begin_anew_are_counted_on(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Older versions wrote such."""
    monkeypatch.setattr("ropewalk.live.carry.carry_books", lambda old, made, state: None)
    monkeypatch.setattr("ropewalk.live.keeper.BOOKS_GO_ON", "unknown")
    _, found = kept(tmp_path / "run", 1.1 * SETTLED)
    assert len(found) == 4
    for before, part in pairwise(found):
        end, begin = before.picture(before.frames - 1), part.picture(0)
        assert begin.scalars["put_in"] == pytest.approx(end.scalars["put_in"], rel=1e-9)
        assert begin.scalars["put_in"] > 0.5
        assert begin.touch.rubbed == pytest.approx(end.touch.rubbed, rel=1e-9)
