"""A session is kept as a run like any other, and its log replays to the same bits."""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np
import pytest

from live.drive import do, r4, slack_rope
from ropewalk.live.frame import SCALARS
from ropewalk.live.keeper import Keeper, parts
from ropewalk.live.relive import relive
from ropewalk.live.replay import ReplayBroadcast
from ropewalk.live.session import Session
from ropewalk.record.errors import RunError
from ropewalk.record.result import Result
from ropewalk.record.resume import resume_run
from ropewalk.record.run import record_run
from ropewalk.scene import loads
from ropewalk.scene.presets import preset


def all_bits(session: Session) -> list[np.ndarray]:
    """Return everything that evolves, of all variants."""
    found = []
    for track in session.tracks:
        state = track.simulation.arrays
        found += [state.x, state.v, state.work.friction, state.work.applied, state.anchor_x]
        found.append(np.array([track.simulation.time, track.edited, track.count]))
    return found


def lively(session: Session) -> None:
    """Do a bit of everything."""
    session.advance(301)
    do(session, "grab", node=10, target=[10.0, 3.0, 0.0])
    session.advance(37)
    do(session, "grab", node=10, target=[11.0, 3.5, 0.0])
    do(session, "drag", anchor="right", target=[42.0, 1.0, 0.0])
    session.advance(55)
    do(session, "set", name="mass", value=3.0)
    do(session, "pin", node=30)
    session.advance(100)
    do(session, "let_go")
    do(session, "set", name="segments", value=60)
    do(session, "set", name="time_step", value=0.001)
    do(session, "speed", value=0.25)
    do(session, "move", anchor="left", velocity=[3.0, 0.0, 0.0])
    session.advance(200)
    do(session, "cut", segment=50)
    do(session, "kick", node=20, velocity=[0.0, 5.0, 0.0])
    do(session, "compare", variants=[{"changes": {"method": "verlet", "time_step": 0.0007}}])
    session.advance(333)
    do(session, "compare", variants=[])
    do(session, "set", name="spring_constant", value=400_000.0)
    while session.broken is None and session.time < 20.0:
        session.advance(17)
    assert session.broken is not None
    do(session, "remedy", remedy="step")
    session.advance(400)
    do(session, "reset")
    session.advance(120)


@pytest.mark.parametrize("start", ["shape", "at-rest"])
def test_the_log_replays_to_the_same_bits(tmp_path: Path, start: str) -> None:
    session = Session(preset("r4").replace(**{"run.start": start}), "r4")
    keeper = Keeper(session, tmp_path / "run")
    lively(session)
    keeper.close()
    assert keeper.failure is None
    again = relive(tmp_path / "run")
    for mine, other in zip(all_bits(session), all_bits(again), strict=True):
        assert np.array_equal(mine, other)
    assert again.changes == session.changes


def test_a_log_with_another_value_does_not(tmp_path: Path) -> None:
    session = r4()
    keeper = Keeper(session, tmp_path / "run")
    session.advance(100)
    do(session, "set", name="mass", value=3.0)
    session.advance(100)
    keeper.close()
    path = tmp_path / "run" / "events.jsonl"
    path.write_text(path.read_text().replace('"value": 3.0', '"value": 3.0001'))
    again = relive(tmp_path / "run")
    assert not np.array_equal(again.main.simulation.positions, session.main.simulation.positions)


def test_every_part_is_a_run_that_opens(tmp_path: Path) -> None:
    session = r4()
    keeper = Keeper(session, tmp_path / "run")
    session.advance(180)
    do(session, "pin", node=10)
    session.advance(90)
    do(session, "cut", segment=5)
    session.advance(90)
    keeper.close()
    folders = parts(tmp_path / "run")
    assert len(folders) == 3
    results = [Result.open(folder) for folder in folders]
    assert [one.frames for one in results] == [21, 11, 11]
    assert results[0].status == "finished"
    assert results[1].time[0] == pytest.approx(180 * session.main.dt)
    # a part begins where the one before it ends
    assert np.array_equal(results[1].positions[0], results[0].positions[-1])
    assert np.array_equal(results[2].positions[-1], session.main.simulation.positions)
    assert [span.name for span in results[2].layout.ropes] == ["rope-1", "rope-2"]
    events = [json.loads(line) for line in (folders[0] / "events.jsonl").read_text().splitlines()]
    assert [e["command"]["type"] for e in events if e["event"] == "command"] == ["pin", "cut"]


def test_a_parts_scene_begins_where_the_part_begins(tmp_path: Path) -> None:
    session = Session(slack_rope(20))
    keeper = Keeper(session, tmp_path / "run")
    session.advance(500)
    do(session, "pin", node=10)
    state = session.main.simulation.state.state
    keeper.close()
    scene = loads((tmp_path / "run" / "part-2" / "scene.toml").read_text())
    fresh = Session(scene).main.simulation
    assert np.array_equal(fresh.positions, state.x.T)
    assert np.array_equal(fresh.velocities[1:-1], state.v.T[1:-1])


def test_a_run_in_place_of_a_session_takes_the_place_of_all_its_parts(tmp_path: Path) -> None:
    """A replay played the new run, and then the old session's second part."""
    session = Session(slack_rope(20))
    keeper = Keeper(session, tmp_path / "run")
    session.advance(50)
    do(session, "pin", node=10)
    session.advance(50)
    keeper.close()
    scene = slack_rope(20)
    scene = scene.replace(run=scene.run.replace(duration=0.1))
    record_run(scene, tmp_path / "run" / "part-7")  # somebody's own
    assert len(parts(tmp_path / "run")) == 2
    record_run(scene, tmp_path / "run", overwrite=True)
    assert parts(tmp_path / "run") == [tmp_path / "run"]
    assert Result.open(tmp_path / "run" / "part-7").status == "finished"


def test_a_session_is_not_resumed_as_a_run(tmp_path: Path) -> None:
    session = Session(slack_rope(20))
    keeper = Keeper(session, tmp_path / "run")
    session.advance(50)
    do(session, "pin", node=10)
    keeper.close()
    for folder in parts(tmp_path / "run"):
        with pytest.raises(RunError, match=rf"view {re.escape(str(tmp_path / 'run'))} --continue"):
            resume_run(folder)


def test_a_killed_session_goes_on_at_its_last_frame(tmp_path: Path) -> None:
    """Not at its last command, which may be long before."""
    session = Session(slack_rope(20))
    keeper = Keeper(session, tmp_path / "run")
    do(session, "kick", node=10, velocity=[0.0, 2.0, 0.0])
    session.advance(60 * session.frame_steps)
    keeper.close()
    log = tmp_path / "run" / "events.jsonl"
    lines = log.read_text().splitlines(keepends=True)
    assert '"ended"' in lines[-1]
    log.write_text("".join(lines[:-1]))  # as SIGKILL leaves it
    again = relive(tmp_path / "run")
    assert again.count == session.count
    assert np.array_equal(again.main.simulation.positions, session.main.simulation.positions)


def test_a_session_goes_on_in_its_folder(tmp_path: Path) -> None:
    session = r4()
    keeper = Keeper(session, tmp_path / "run")
    session.advance(90)
    do(session, "set", name="mass", value=3.0)
    keeper.close()
    second = relive(tmp_path / "run")
    keeper = Keeper(second, tmp_path / "run", go_on=True)
    second.advance(90)
    do(second, "kick", node=10, velocity=[0.0, 1.0, 0.0])
    second.advance(90)
    keeper.close()
    third = relive(tmp_path / "run")
    for mine, other in zip(all_bits(second), all_bits(third), strict=True):
        assert np.array_equal(mine, other)
    assert third.count == 270


def test_a_plain_run_has_no_session(tmp_path: Path) -> None:
    import ropewalk as rw

    rw.run(slack_rope(5).replace(run=slack_rope().run.replace(duration=0.1)), tmp_path / "run")
    with pytest.raises(RunError, match="is no live session"):
        relive(tmp_path / "run")


def test_a_replay_shows_what_was_recorded(tmp_path: Path) -> None:
    session = r4()
    keeper = Keeper(session, tmp_path / "run")
    session.advance(180)
    do(session, "pin", node=10)
    session.advance(90)
    keeper.close()
    broadcast = ReplayBroadcast(tmp_path / "run", playing=False)
    assert len(broadcast.times) == 32
    assert broadcast.duration == pytest.approx(270 * session.main.dt)
    data = b"".join(broadcast.frames_between(0, 40, 1))
    first = np.frombuffer(data, "<f4", 3 * 41, 48 + 4 * len(SCALARS)).reshape(41, 3)
    assert np.allclose(first, Result.open(tmp_path / "run").positions[0], atol=1e-6)
    sizes = [broadcast.layout(part)["bytes"] for part in (0, 1)]
    assert len(data) == 21 * sizes[0] + 11 * sizes[1]


def test_a_large_scene_is_recorded_at_a_megabyte_a_second(tmp_path: Path) -> None:
    """It was twice that."""
    session = Session(slack_rope(700))
    keeper = Keeper(session, tmp_path / "run")
    frame = sum(array.nbytes for array in session.main.frame().recording)
    keeper.close()
    rate = session.loaded.run.frame_rate / keeper._every
    assert keeper._every > 1
    assert 0.7e6 < frame * rate < 1.3e6
