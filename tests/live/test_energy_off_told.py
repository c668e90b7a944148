"""How far energy is off is told from a session's begin on, whenever a page or a replay looks."""

from __future__ import annotations

from pathlib import Path

import pytest

from live.drive import do, slack_rope
from ropewalk.live.commands import parse
from ropewalk.live.keeper import Keeper
from ropewalk.live.pictures import picture
from ropewalk.live.recorded import Recorded
from ropewalk.live.replay import ReplayBroadcast
from ropewalk.live.session import Session
from ropewalk.record.result import Result
from ropewalk.record.turnover import share_turned
from ropewalk.scene.presets import preset

FRAMES = 60
EDITS = [
    ("pulley", 66, {"type": "pin", "node": 20}),
    ("pulley", 66, {"type": "set", "name": "gravity", "value": [0.0, 0.0, -9.0]}),
]
TOLD = ("energy_off", "energy_turned")


def told(scalars: dict[str, float]) -> list[float]:
    """Return error and what was turned over [J]."""
    return [scalars[name] for name in TOLD]


def swing() -> Session:
    """Return a session of a rope that swings, with steps that lose much of its energy."""
    scene = slack_rope(8)
    run = scene.run.replace(method="implicit-euler", time_step=0.02, frame_rate=50.0)
    return Session(scene.replace(run=run))


def test_who_comes_late_is_told_what_was_turned_over() -> None:
    """It took the first frame that it saw for the begin, and the error from the begin on."""
    session, watched = swing(), []
    late = swing()
    for _ in range(FRAMES):
        session.advance(session.frame_steps)
        watched.append(picture(session.main).scalars)
    late.advance(FRAMES * late.frame_steps)
    seen = picture(late.main).scalars
    assert told(seen) == told(watched[-1])
    assert seen["energy_off"] == max(abs(one["energy_error"]) for one in watched) > 1.0
    eased = watched[0]["elastic"] - min(one["elastic"] for one in watched)
    assert seen["energy_turned"] > 10.0 * eased  # most of it before the first frame


def test_it_goes_back_with_the_session_and_begins_anew_with_a_step_or_a_reset() -> None:
    session = swing()
    session.advance(4 * session.frame_steps)
    do(session, "kick", node=5, velocity=[0.0, 2.0, 1.0])
    before = told(picture(session.main).scalars)
    session.advance(4 * session.frame_steps)
    assert told(picture(session.main).scalars) != before
    do(session, "undo")
    assert told(picture(session.main).scalars) == before
    error = picture(session.main).scalars["energy_error"]
    do(session, "set", name="time_step", value=0.001)
    session.advance(session.frame_steps)
    scalars = picture(session.main).scalars
    assert scalars["energy_off"] < 0.2 * abs(error)
    assert 0.0 < scalars["energy_turned"] < before[1]  # since the step was chosen, as the error
    do(session, "reset")
    assert told(picture(session.main).scalars)[0] == 0.0


def test_a_fall_long_ago_does_not_hide_what_a_step_errs_in_small_motions() -> None:
    """A kick that a long step took at once was 1.7 % of the fall before, so nothing was said."""
    session = Session(preset("hanging-rope"), "hanging-rope")
    session.advance(round(2.0 / session.main.dt))
    do(session, "set", name="spring_friction", value=2.0)
    session.advance(round(20.0 / session.main.dt))
    fall = told(picture(session.main).scalars)[1]
    do(session, "set", name="method", value="implicit-euler")
    do(session, "set", name="time_step", value=1.0 / 60.0)
    do(session, "kick", node=session.main.simulation.layout.nodes // 2, velocity=[0.2, 0.0, 0.0])
    session.advance(round(1.0 / session.main.dt))
    error, turned = told(picture(session.main).scalars)
    assert error < 0.05 * fall
    assert error > 0.5 * turned


@pytest.mark.parametrize(
    "change",
    [
        {"type": "set", "name": "length", "value": 3.5},
        {"type": "kick", "node": 20, "velocity": [0.0, 60.0, 0.0]},
    ],
)
def test_what_a_change_puts_in_counts_before_a_frame_has_seen_it(change: dict[str, object]) -> None:
    """17 kJ of a pressed rope were gone by the next frame: the step was "off by 5350 %"."""
    session = Session(preset("bollard"), preset="bollard")
    session.advance(6 * session.frame_steps)
    main = session.main
    error, put_in = main.balance.last, main.edited
    session.apply(parse(change), 1)
    assert main.balance.last == pytest.approx(error, abs=1e-9)  # it takes none itself
    put_in = main.edited - put_in
    session.advance(session.frame_steps)
    off, turned = told(picture(main).scalars)
    assert turned > 0.9 * put_in > 10.0
    assert off < 0.2 * turned


def test_a_replay_tells_the_same_at_every_frame(tmp_path: Path) -> None:
    """Of a part that goes on from another, too, wherever one jumps to."""
    session = swing()
    keeper = Keeper(session, tmp_path / "run")
    session.advance(FRAMES * session.frame_steps)
    first = told(picture(session.main).scalars)
    do(session, "pin", node=3)
    session.advance(FRAMES * session.frame_steps)
    last = told(picture(session.main).scalars)
    keeper.close()
    parts = ReplayBroadcast(tmp_path / "run", playing=False).parts
    assert len(parts) == 2
    shown = [told(part.again().picture(part.frames - 1).scalars) for part in parts]
    assert shown[0] == pytest.approx(first, rel=1e-6)
    assert shown[1] == pytest.approx(last, rel=1e-6)
    alone = Recorded(Result.open(tmp_path / "run"))
    assert told(alone.picture(FRAMES).scalars) == pytest.approx(first, rel=1e-6)


@pytest.mark.parametrize(("name", "frames", "change"), EDITS)
def test_it_warns_as_the_table_of_the_run_does(
    tmp_path: Path, name: str, frames: int, change: dict[str, object]
) -> None:
    """Loads on a wheel turn over much by falling, and an edit takes no error back."""
    session = Session(preset(name), preset=name)
    keeper = Keeper(session, tmp_path / "run")
    for _ in range(frames):
        session.advance(session.frame_steps)
    first = told(picture(session.main).scalars)
    session.apply(parse(change), 1)
    assert told(picture(session.main).scalars)[0] == pytest.approx(first[0])
    session.advance(4 * session.frame_steps)
    last = told(picture(session.main).scalars)
    assert last[0] >= (1.0 - 1e-9) * first[0] > 0.01 * first[1]
    keeper.close()
    table = share_turned(Result.open(tmp_path / "run"))
    assert 100.0 * first[0] / first[1] == pytest.approx(table, rel=0.05)
    parts = ReplayBroadcast(tmp_path / "run", playing=False).parts
    assert told(parts[0].picture(parts[0].frames - 1).scalars) == pytest.approx(first, rel=1e-6)
    assert told(parts[1].picture(parts[1].frames - 1).scalars) == pytest.approx(last, rel=0.01)
