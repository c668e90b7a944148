"""Obstacles that hands move in a session: refused in words, undone at once, kept as a motion of the scene."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from live.drive import do, refused
from live.test_solids import ROPE
from ropewalk.live import describe
from ropewalk.live.bodies import SAFE
from ropewalk.live.hands import FASTEST
from ropewalk.live.keeper import Keeper, parts
from ropewalk.live.relive import relive
from ropewalk.live.replay import ReplayBroadcast
from ropewalk.live.session import Session
from ropewalk.record.result import Result
from ropewalk.scene import Scene, loads

TABLE = """
[[obstacle]]
name = "table"
kind = "box"
center = [0, 0, 2.88]
half_sizes = [0.6, 0.3, 0.1]
edge_radius = 0.02
[[obstacle]]
name = "drum"
kind = "cylinder"
from = [0, -1, 0]
to = [0, 1, 0]
radius = 0.2
"""


def scene() -> Scene:
    return loads((ROPE + TABLE).replace("duration = 0.02", "duration = 1.0"))


def steps(session: Session, seconds: float) -> None:
    session.advance(round(seconds / session.main.dt))


def test_a_hand_lifts_a_rope_on_its_table() -> None:
    session = Session(scene())
    steps(session, 0.1)
    before = session.main.simulation.positions[2].copy()
    do(session, "obstacle", obstacle="table", target=(0.0, 0.0, 2.9), pace=4.0)
    steps(session, 0.6)
    table = session.main.simulation.obstacles["table"]
    assert table.position == pytest.approx([0.0, 0.0, 2.9], abs=1e-9)
    assert session.main.simulation.positions[2] - before == pytest.approx([0, 0, 0.02], abs=1e-3)
    # A hand that carries on about another thing carries its places over; undo puts it back.
    do(session, "load", node=2, mass=0.1)
    assert session.main.simulation.obstacles["table"].position[2] == pytest.approx(2.9)
    do(session, "undo")
    do(session, "undo")
    assert session.main.simulation.obstacles["table"].position[2] == pytest.approx(2.88)


def test_a_stroke_is_undone_at_once() -> None:
    session = Session(scene())
    for k in range(5):
        target = (0.0, 0.0, 2.88 + 0.01 * k)
        do(session, "obstacle", obstacle="table", target=target, begin=k == 0)
        steps(session, 0.1)
    assert session.undo.word == "moving the obstacle"
    do(session, "undo")
    assert session.main.simulation.obstacles["table"].position[2] == pytest.approx(2.88)
    assert session.undo.word == ""


def test_a_hand_is_no_faster_than_the_step_can_follow() -> None:
    session = Session(scene())
    do(session, "obstacle", obstacle="table", target=(50.0, 0.0, 2.88))
    table = session.main.simulation.obstacles["table"]
    assert 0.0 < np.linalg.norm(table.velocity) < table.fastest


def test_a_disc_is_dragged_faster_in_its_own_plane() -> None:
    """What would jump over nodes is its radius there, and half its thickness along its axis."""
    flat = TABLE.replace("[0, -1, 0]", "[0, -0.005, 0]").replace("[0, 1, 0]", "[0, 0.005, 0]")
    speeds = []
    for target in ((0.0, 0.0, -50.0), (0.0, 50.0, 0.0)):
        session = Session(loads((ROPE + flat).replace("duration = 0.02", "duration = 1.0")))
        drum = session.main.simulation.obstacles["drum"]
        do(session, "obstacle", obstacle="drum", target=target)
        most = drum.fastest_along(np.subtract(target, drum.position))
        speeds.append(float(np.linalg.norm(drum.velocity)))
        assert speeds[-1] == pytest.approx(min(FASTEST, SAFE * most))
    assert speeds[0] > 2.0 * speeds[1]


def test_what_cannot_be_is_refused_in_words() -> None:
    session = Session(scene())
    assert "there is table, drum" in refused(session, "obstacle", obstacle="tables", angle=1.0)
    do(session, "obstacle", obstacle="drum", angle=1.0)


def test_a_table_tilts_no_faster_than_it_may() -> None:
    """Its edges go at the rate times their reach: it is led at half of what would jump over nodes."""
    session = Session(scene())
    do(session, "obstacle", obstacle="table", angle=0.4)
    table = session.main.simulation.obstacles["table"]
    assert 0.0 < table.rate <= min(12.0, 0.5 * table.fastest_turn) * (1.0 + 1e-9)
    steps(session, 0.4 / table.rate + 0.1)
    assert table.angle == pytest.approx(0.4)
    assert table.rate == 0.0


def test_the_folder_knows_where_it_was(tmp_path: Path) -> None:
    session = Session(scene())
    keeper = Keeper(session, tmp_path / "run")
    steps(session, 0.2)
    do(session, "obstacle", obstacle="table", target=(0.05, 0.0, 2.9))
    do(session, "obstacle", obstacle="drum", angle=0.4)
    steps(session, 0.5)
    do(session, "obstacle", obstacle="table", target=(0.0, 0.0, 2.88))
    steps(session, 0.2)
    keeper.close()
    assert keeper.failure is None
    folders = parts(tmp_path / "run")
    assert len(folders) == 3  # a part for each that was taken
    last = Result.open(folders[-1])
    places = last.obstacle_positions()[:, 0]
    assert places[0] == pytest.approx([0.0, 0.0, 2.88])
    middle = int(np.searchsorted(last.time, 0.6))
    assert places[middle] == pytest.approx([0.05, 0.0, 2.9], abs=1e-9)
    assert places[-1] == pytest.approx([0.0, 0.0, 2.88], abs=1e-9)
    assert len(last.scene.obstacles[0].motion.times) < 20  # where it rests there are no rows
    shown = ReplayBroadcast(tmp_path / "run").layout(len(folders) - 1)["obstacles"]
    assert shown[0]["motion"]["kind"] == "table"
    assert shown[1]["turns"][-1][1] == pytest.approx(0.4)
    assert "motion" not in ReplayBroadcast(tmp_path / "run").layout(0)["obstacles"][0]
    again = relive(tmp_path / "run")
    assert (again.main.simulation.positions == session.main.simulation.positions).all()


def test_pages_are_told_how_it_moves() -> None:
    session = Session(scene())
    still = describe.obstacles(session)
    assert "motion" not in still[0]
    do(session, "obstacle", obstacle="table", target=(0.05, 0.0, 2.9))
    do(session, "obstacle", obstacle="drum", angle=0.4)
    moving = describe.obstacles(session)
    assert moving[0]["motion"]["kind"] == "velocity"
    assert [row[1] for row in moving[1]["turns"]] == pytest.approx([0.0, 0.4])


def test_what_its_weight_turns_is_led_nowhere() -> None:
    """It was answered with an error of the program's own."""
    swing = """
[[obstacle]]
name = "gate"
kind = "box"
center = [0, 0, 1]
half_sizes = [0.2, 0.2, 0.2]
edge_radius = 0.02
spin = { free = true, pivot = [0, 0, 1.3], inertia = 0.2, mass = 1.0, center_of_mass = [0, 0, 1] }
"""
    session = Session(loads(ROPE + TABLE + swing))
    assert "its weight turns it" in refused(session, "obstacle", obstacle="gate", target=(1, 0, 1))
    assert "turns freely" in refused(session, "obstacle", obstacle="gate", angle=1.0)
    assert [one["movable"] for one in describe.obstacles(session)] == [True, True, False]
    assert not session.main.simulation.obstacles["gate"].moves
