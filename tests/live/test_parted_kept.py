"""A rope that parts in a session that is kept: the folder tells of it, and a replay of the folder does."""

from __future__ import annotations

from pathlib import Path

import pytest

import ropewalk as rw
from live.drive import do, slack_rope
from live.test_wound_ropes import hung, strong
from ropewalk.live.keeper import Keeper, parts
from ropewalk.live.relive import relive
from ropewalk.live.replay import ReplayBroadcast
from ropewalk.live.session import Session
from ropewalk.record.result import Result


def pulled(strength: float) -> rw.Scene:
    """A rope whose end is drawn away from it."""
    scene = slack_rope(20)
    made_of = scene.ropes[0].made_of.replace(breaking_load=strength, parts=True)
    rope = scene.ropes[0].replace(made_of=made_of)
    pull = rw.Anchor(
        name="right", node=-1, motion={"kind": "velocity", "velocity": (4.0, 0.0, 0.0)}
    )
    return scene.replace(ropes=[rope], anchors=[scene.anchors[0], pull])


def kept(folder: Path, strength: float) -> Session:
    session = Session(pulled(strength))
    keeper = Keeper(session, folder)
    session.advance(round(0.7 / session.main.dt))
    keeper.close()
    assert keeper.failure is None
    return session


def test_a_folder_tells_what_has_parted(tmp_path: Path) -> None:
    session = kept(tmp_path / "run", 300.0)
    known = [one.parting for one in session.main.parted]
    assert known
    folders = parts(tmp_path / "run")
    assert len(folders) > 1  # two ropes have arrays of another shape
    told = [one for folder in folders for one in Result.open(folder).partings]
    assert told == known
    broadcast = ReplayBroadcast(tmp_path / "run")
    last = broadcast.layout(len(folders) - 1)["variants"][0]
    assert [one["time"] for one in last["parted"]] == pytest.approx([one.time for one in known])
    again = relive(tmp_path / "run")
    assert (again.main.simulation.positions == session.main.simulation.positions).all()
    # The twin: a rope that holds, whose folder tells of nothing.
    kept(tmp_path / "strong", 1e6)
    assert Result.open(tmp_path / "strong").partings == ()
    assert len(parts(tmp_path / "strong")) == 1


def test_a_folder_tells_of_a_wound_rope_that_was_cut(tmp_path: Path) -> None:
    """In arrays of the same shape, and a session of the folder goes the same way."""
    session = Session(strong(hung(-0.5)))
    keeper = Keeper(session, tmp_path / "run")
    session.advance(round(0.35 / session.main.dt))
    do(session, "cut", segment=session.main.simulation.layout.nodes - 3)
    session.advance(20)
    do(session, "set", name="EA", value=80.0)
    session.advance(20)
    keeper.close()
    assert keeper.failure is None
    known = [one.parting for one in session.main.parted]
    folders = parts(tmp_path / "run")
    assert len(known) == 1
    assert [one for folder in folders for one in Result.open(folder).partings] == known
    broadcast = ReplayBroadcast(tmp_path / "run")
    last = broadcast.layout(len(folders) - 1)["variants"][0]
    assert [one["time"] for one in last["parted"]] == pytest.approx([one.time for one in known])
    again = relive(tmp_path / "run")
    assert (again.main.simulation.positions == session.main.simulation.positions).all()
    assert again.main.parted == session.main.parted
