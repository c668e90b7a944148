"""A session's further parts: their times, the energies that go on through them, and their bodies' clocks."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from live.drive import do, slack_rope
from ropewalk.live.keeper import SETTLED, Keeper, parts
from ropewalk.live.packed_run import record
from ropewalk.live.pictures import picture
from ropewalk.live.replay import ReplayBroadcast
from ropewalk.live.session import Session
from ropewalk.record.result import Result
from ropewalk.scene import Scene, Sphere
from ropewalk.scene.motions import Velocity

STEPS = 130  # of which 83 make a frame: a part that begins then begins between two


def swinging(**more: object) -> Session:
    """Return a session of a few segments that fall, with steps short against their frames."""
    scene: Scene = slack_rope(4)
    return Session(scene.replace(**more))


def ball() -> Sphere:
    """Return a sphere that no rope touches, on its way at 1 m/s."""
    way = Velocity(velocity=(1.0, 0.0, 0.0), start=0.0, stop=9.0)
    return Sphere(name="ball", center=(0.0, 0.0, -50.0), radius=0.1, motion=way)


def test_no_time_is_lost_between_parts(tmp_path: Path) -> None:
    """What lay between the last frame of a part and the next part was left out."""
    session = swinging()
    keeper = Keeper(session, tmp_path / "run")
    for node in (1, 2):
        session.advance(STEPS)
        do(session, "pin", node=node)
    session.advance(2 * session.frame_steps - session.count % session.frame_steps)
    keeper.close()
    broadcast = ReplayBroadcast(tmp_path / "run", playing=False)
    assert len(broadcast.parts) == 3
    ends = [part.time[-1] for part in broadcast.parts]
    begins = [part.time[0] for part in broadcast.parts]
    assert begins[1] - ends[0] > 10 * session.main.dt
    assert broadcast.times[broadcast.first[:-1]] == pytest.approx(begins, rel=1e-12)
    assert broadcast.duration == pytest.approx(session.time, rel=1e-12)
    assert [broadcast.layout(number)["later"] for number in range(3)] == pytest.approx(
        [0.0] * 3, abs=1e-12
    )


def test_bodies_have_the_clock_of_their_part(tmp_path: Path) -> None:
    """After a reset they were drawn where they would have been without one."""
    session = swinging(obstacles=[ball()])
    keeper = Keeper(session, tmp_path / "run")
    session.advance(2 * session.frame_steps)
    do(session, "reset")
    session.advance(session.frame_steps)
    keeper.close()
    broadcast = ReplayBroadcast(tmp_path / "run", playing=False)
    for layout in (broadcast.layout(1), record(tmp_path / "run").header["parts"][1]["layout"]):
        own = broadcast.times[-1] - layout["later"]
        assert own == pytest.approx(session.time, rel=1e-12)
        params = layout["obstacles"][0]["motion"]["params"]
        there = params[0] + params[3] * own
        assert there == pytest.approx(session.main.simulation.obstacles["ball"].position[0])


def test_energies_go_on_through_the_parts(tmp_path: Path) -> None:
    """Gravity's was zero at the beginning of each, and so was what no law accounts for."""
    session = swinging()
    keeper = Keeper(session, tmp_path / "run")
    shown = []
    for change in ("pin", "cut", ""):
        session.advance(STEPS)
        if change:
            do(session, change, **({"node": 1} if change == "pin" else {"segment": 2}))
        shown.append(picture(session.main).scalars)
    do(session, "undo")
    shown.append(picture(session.main).scalars)
    keeper.close()
    broadcast = ReplayBroadcast(tmp_path / "run", playing=False)
    assert len(broadcast.parts) == 4
    begins = [part.picture(0).scalars for part in broadcast.parts[1:]]
    again = [part.again().picture(0).scalars for part in broadcast.parts[1:]]
    assert begins == again
    # The error was that of the frame before, and what the pin took was in nothing: 6.5 J.
    for name in ("gravity", "energy_error", "put_in", "lost"):
        live = [shown[i][name] for i in (0, 1, 3)]
        assert [one[name] for one in begins] == pytest.approx(live, rel=1e-9), name
    assert shown[0]["put_in"] < -5.0
    assert abs(shown[1]["gravity"]) > 0.1  # J: there is something to go on from


def test_a_kick_within_a_part_is_put_in_when_it_is_given(tmp_path: Path) -> None:
    """It was no part's, and so an error of 2.3 and 8.8 J, until the next one began."""
    session = swinging()
    keeper, shown = Keeper(session, tmp_path / "run"), []

    def go(frames: int) -> None:
        for _ in range(frames):
            session.advance(session.frame_steps)
            shown.append(picture(session.main).scalars)

    go(3)
    for _ in range(2):
        do(session, "kick", node=3, velocity=(0.0, 3.0, 0.0))
        go(2)
    do(session, "pin", node=1)
    go(2)
    keeper.close()
    first, second = ReplayBroadcast(tmp_path / "run", playing=False).parts
    told = [part.picture(k).scalars for part in (first, second) for k in range(1, part.frames)]
    assert len(told) == len(shown)
    assert shown[3]["put_in"] - shown[2]["put_in"] > 0.1
    for name in ("put_in", "energy_error", "lost"):
        assert [one[name] for one in told] == pytest.approx([one[name] for one in shown], abs=1e-9)


@pytest.mark.parametrize(
    "method", ["semi-implicit-euler", "bdf2"]
)  # of two ropes bdf2 makes islands
def test_the_largest_energy_error_of_a_part_is_its_own(tmp_path: Path, method: str) -> None:
    """It was the friction of the time before: 0.2 J where the method errs by a millionth of that."""
    session = swinging(**{"run.method": method})
    keeper = Keeper(session, tmp_path / "run")
    session.advance(20 * session.frame_steps)
    lost = picture(session.main).scalars["lost"]
    do(session, "pin", node=1)
    do(session, "cut", segment=2)
    session.advance(session.frame_steps)
    keeper.close()
    errors = [np.abs(Result.open(one).energy_errors).max() for one in parts(tmp_path / "run")]
    assert len(errors) == 3
    assert max(errors[1:]) < 0.01 * lost


@pytest.mark.parametrize("frames", [1, 4])
def test_after_an_undone_reset_energies_go_on_from_before_it(tmp_path: Path, frames: int) -> None:
    """They went on from the part that the reset had begun."""
    session = swinging()
    keeper = Keeper(session, tmp_path / "run")
    for word, count in (("pin", 6), ("reset", 6), ("undo", frames)):
        session.advance(count * session.frame_steps)
        do(session, word, **({"node": 1} if word == "pin" else {}))
    shown = picture(session.main).scalars
    session.advance(session.frame_steps)
    keeper.close()
    broadcast = ReplayBroadcast(tmp_path / "run", playing=False)
    assert len(broadcast.parts) == 4
    second, last = broadcast.parts[1], broadcast.parts[3]
    told, before = last.picture(0).scalars, second.picture(second.frames - 1).scalars
    assert told["gravity"] == pytest.approx(shown["gravity"], rel=1e-9)
    assert told["energy_error"] == pytest.approx(before["energy_error"], rel=1e-9)


def test_constants_are_those_of_their_time(tmp_path: Path) -> None:
    """A replay had the first ones to its end: a legend of "Tension / EA" was four times too large."""
    session = swinging()
    keeper = Keeper(session, tmp_path / "run")
    session.advance(2 * session.frame_steps)
    do(session, "set", name="EA", value=8e4)
    do(session, "set", name="gravity", value=[0.0, 0.0, 4.0])
    do(session, "load", node=2, mass=0.5)
    session.advance(round((SETTLED + 0.1) / session.main.dt))
    do(session, "set", name="method", value="rk4")
    session.advance(session.frame_steps)
    keeper.close()
    broadcast = ReplayBroadcast(tmp_path / "run", playing=False)
    told = [broadcast.layout(number) for number in range(len(broadcast.parts))]
    first, then = (one["variants"][0] for one in told[:2])
    assert [one["ropes"][0]["EA"] for one in (first, then)] == pytest.approx([2e4, 8e4])
    assert [one["up"][2] for one in told[:2]] == [1.0, -1.0]
    assert (first["loads"], [one["mass"] for one in then["loads"]]) == ([], [0.5])
    assert [one["variants"][0]["method"] for one in told] == 2 * ["semi-implicit-euler"] + ["rk4"]
    last = broadcast.parts[-1]
    told_last, shown = last.picture(last.frames - 1).scalars, picture(session.main).scalars
    assert session.main.edited > 50.0  # J: what the changes gave is no error of the method
    for name in ("energy_error", "put_in", "lost"):
        assert told_last[name] == pytest.approx(shown[name], abs=0.2), name
    again = last.again().picture(last.frames - 1).scalars
    assert again["put_in"] == told_last["put_in"]
    assert np.diff(broadcast.times).max() < 1.5 * session.loaded.run.frame_interval


def test_a_slider_makes_few_parts(tmp_path: Path) -> None:
    session = swinging()
    keeper = Keeper(session, tmp_path / "run")
    frames = round(2.0 * SETTLED / session.loaded.run.frame_interval)
    for k in range(frames):
        do(session, "set", name="mass", value=2.0 + 0.01 * k)
        session.advance(session.frame_steps)
    session.advance(frames * session.frame_steps)
    keeper.close()
    scenes = [Result.open(one).scene for one in parts(tmp_path / "run")]
    assert 2 < len(scenes) < 6
    masses = [one.ropes[0].own_mass for one in (scenes[-1], session.scene)]
    assert masses[0] == pytest.approx(masses[1])


def test_a_load_begins_a_part_however_soon_it_comes(tmp_path: Path) -> None:
    """Within half a second of another change it came into no part, nor did the last value."""
    session = swinging()
    keeper = Keeper(session, tmp_path / "run")
    do(session, "set", name="EA", value=4e4)
    session.advance(3 * session.frame_steps)
    do(session, "load", node=2, mass=3.0)
    session.advance(3 * session.frame_steps)
    do(session, "set", name="EA", value=8e4)
    do(session, "kick", node=2, velocity=[0.0, 1.0, 0.0])  # which is no reason for a part
    session.advance(3 * session.frame_steps)
    keeper.close()
    found = [Result.open(one) for one in parts(tmp_path / "run")]
    loads = [[one.mass for one in result.scene.ropes[0].loads] for result in found]
    assert loads == [[], [], [3.0], [3.0]]
    stiff = [result.scene.ropes[0].made_of.EA for result in found]  # type: ignore[union-attr]
    assert stiff == pytest.approx([2e4, 4e4, 4e4, 8e4])
    assert [result.frames for result in found] == [1, 3, 6, 1]
    assert len(ReplayBroadcast(tmp_path / "run", playing=False).parts) == 4
