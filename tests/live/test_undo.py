"""Undo: cuts, pins, loads, kicks and resets are as if not done, to the bit; hands throw what they let go."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from live.drive import do, r4, refused, slack_rope
from ropewalk.live.hands import FASTEST, soft_spring
from ropewalk.live.keeper import Keeper
from ropewalk.live.relive import relive
from ropewalk.live.session import Break, Session
from ropewalk.live.undo import LONGEST

DONE = [
    ("cut", {"segment": 12}, "the cut"),
    ("pin", {"node": 12}, "the pin"),
    ("unpin", {"anchor": "right"}, "letting go"),
    ("load", {"node": 9, "mass": 3.0}, "the load"),
    ("kick", {"node": 9, "velocity": [0.0, 0.0, 7.0]}, "the kick"),
    ("reset", {}, "the reset"),
]


@pytest.mark.parametrize(("kind", "keys", "word"), DONE)
def test_what_is_undone_is_as_if_it_had_not_been_done(kind: str, keys: object, word: str) -> None:
    session, twin = Session(slack_rope()), Session(slack_rope())
    for one in (session, twin):
        one.advance(2000)
    do(session, kind, **keys)  # type: ignore[arg-type]
    session.advance(777)
    assert session.undo.word == word
    do(session, "undo")
    assert session.time == twin.time
    assert session.scene == twin.scene
    for one in (session, twin):
        one.advance(500)
    assert np.array_equal(session.main.simulation.positions, twin.main.simulation.positions)
    assert session.undo.word == ""


def test_one_goes_back_by_step_after_step_and_no_further() -> None:
    session = r4()
    do(session, "pin", node=10)
    session.advance(50)
    do(session, "cut", segment=20)
    session.advance(50)
    do(session, "reset")
    assert [session.undo.word, len(session.scene.ropes)] == ["the reset", 1]
    do(session, "undo")
    assert [session.undo.word, len(session.scene.ropes)] == ["the cut", 2]
    do(session, "undo")
    assert [session.undo.word, len(session.scene.ropes)] == ["the pin", 1]
    do(session, "undo")
    assert "nothing to undo" in refused(session, "undo")
    for _ in range(LONGEST + 5):
        do(session, "kick", node=10, velocity=[0.0, 0.0, 0.1])
    for _ in range(LONGEST):
        do(session, "undo")
    assert session.undo.word == ""


def test_a_refused_command_and_another_scene_leave_nothing_to_undo() -> None:
    session = r4()
    assert "must be" in refused(session, "cut", segment=9999)
    assert session.undo.word == ""
    do(session, "cut", segment=20)
    do(session, "scene", preset="r3")
    assert session.undo.word == ""


def test_what_was_done_after_a_moment_gone_back_to_is_not_undone() -> None:
    session = Session(slack_rope())
    session.advance(5000)
    do(session, "kick", node=9, velocity=[0.0, 0.0, 1.0])
    session.advance(2000)
    do(session, "back", seconds=1.0)
    assert session.undo.word == ""


def test_what_was_done_at_the_time_that_is_gone_back_to_is_not_undone() -> None:
    """Times were compared, and the pin stayed to be undone: half a second was thrown away for nothing."""
    session = Session(slack_rope())
    session.advance(2520)  # 0.5 s, which is kept
    do(session, "pin", node=12)
    session.advance(1100)
    do(session, "back", seconds=0.2)
    assert (session.time, session.undo.word) == (pytest.approx(0.5), "")
    assert [one.name for one in session.scene.anchors] == ["left", "right"]
    assert "nothing to undo" in refused(session, "undo")


def test_a_reset_is_undone_after_one_has_gone_back_since() -> None:
    """It was done at 1 s, which is later than all that came after it."""
    session = Session(slack_rope())
    session.advance(5040)  # 1 s
    do(session, "reset")
    session.advance(3000)
    do(session, "back", seconds=0.2)
    assert session.undo.word == "the reset"
    do(session, "undo")
    assert session.time == pytest.approx(1.0)


@pytest.mark.parametrize("way", ["undo", "back", "remedy"])
def test_who_goes_back_lets_go_of_what_was_held_then(way: str) -> None:
    """A hand of the past pulled on, though the page that it was of had let go, or was gone."""
    session = Session(slack_rope())
    do(session, "grab", node=20, target=[4.0, 0.0, 1.0])
    do(session, "move", anchor="left", velocity=[-1.0, 0.0, 0.0])
    do(session, "drag", anchor="right", target=[9.0, 0.0, 1.0])
    session.advance(100)
    session.remember(clear=True)
    if way == "undo":
        do(session, "cut", segment=5)
    do(session, "let_go")
    session.advance(500)
    if way == "remedy":
        session.broken = Break(0, 1)
    do(session, way, **{"back": {"seconds": 0.05}, "remedy": {"remedy": "back"}}.get(way, {}))
    assert session.time == pytest.approx(100 * session.main.dt)
    hands, anchors = session.main.hands, session.main.simulation.anchors
    assert (hands.grabs, hands.targets, hands.movers) == ([], {}, {})
    assert not np.any([one.velocity for one in anchors.values()])
    session.advance(1)
    assert not session.main.simulation.applied_forces.any()


def test_a_session_with_undo_replays_to_the_same_bits(tmp_path: Path) -> None:
    session = Session(slack_rope())
    keeper = Keeper(session, tmp_path / "run")
    session.advance(500)
    do(session, "cut", segment=12)
    session.advance(300)
    do(session, "grab", node=30, target=[5.0, 0.0, 1.0], limit=3.0, pace=0.2)
    session.advance(300)
    do(session, "let_go", node=30, velocity=[1.0, 0.0, 2.0])
    session.advance(100)
    do(session, "undo")
    session.advance(200)
    keeper.close()
    again = relive(tmp_path / "run")
    assert again.count == session.count
    assert np.array_equal(again.main.simulation.positions, session.main.simulation.positions)


def test_a_throw_gives_the_node_the_velocity_of_the_hand() -> None:
    session = Session(slack_rope())
    session.advance(100)
    do(session, "grab", node=20, target=[4.0, 0.0, 1.0])
    session.advance(100)
    put_in = session.main.edited
    energy = session.main.energy
    do(session, "let_go", node=20, velocity=[3.0, 0.0, 4.0])
    assert np.array_equal(session.main.simulation.velocities[20], [3.0, 0.0, 4.0])
    assert session.main.edited - put_in == pytest.approx(session.main.energy - energy)
    do(session, "grab", node=20, target=[4.0, 0.0, 1.0])
    do(session, "let_go", node=20, velocity=[300.0, 0.0, 400.0])
    assert np.allclose(session.main.simulation.velocities[20], [0.6 * FASTEST, 0.0, 0.8 * FASTEST])


def test_nobody_throws_what_he_does_not_hold() -> None:
    session = Session(slack_rope())
    do(session, "let_go", node=20, velocity=[3.0, 0.0, 4.0])
    assert not session.main.simulation.velocities.any()


def test_a_hand_pulls_no_harder_than_it_may() -> None:
    session = Session(slack_rope())
    forces = {}
    for limit in (None, 5.0):
        do(session, "grab", node=20, target=[4.0, 0.0, 50.0], limit=limit)
        session.advance(200)
        (grab,) = session.main.hands.grabs
        forces[limit] = float(np.linalg.norm(grab.force))
        assert forces[limit] == pytest.approx(grab.most, rel=1e-9)
    assert forces[None] == pytest.approx(20.0 * 2.0 * 9.81, rel=0.01)  # the rope's weight
    assert forces[5.0] == pytest.approx(5.0)
    assert "must be at least 0" in refused(
        session, "grab", node=20, target=[4.0, 0.0, 50.0], limit=-1.0
    )


def test_a_hand_is_as_quick_on_the_clock_where_the_simulation_is_slow() -> None:
    """Half a second on the clock after the pointer has jumped, anchor and node are there."""
    away, pace = {}, 0.05
    for told in (pace, 1.0):
        session = Session(slack_rope())
        do(session, "drag", anchor="right", target=[8.0, 0.0, 0.5], pace=told)
        do(session, "grab", node=20, target=[4.0, 0.0, -2.0], pace=told)
        simulation = session.main.simulation
        before = (simulation.anchors["right"].position, simulation.positions[20].copy())
        session.advance(round(0.5 * pace / session.main.dt))
        after = (simulation.anchors["right"].position, simulation.positions[20])
        targets = ([8.0, 0.0, 0.5], [4.0, 0.0, -2.0])
        away[told] = [
            np.linalg.norm(now - target) / np.linalg.norm(then - target)
            for now, then, target in zip(after, before, targets, strict=True)
        ]
    # the twin that is told nothing is behind, the node by more than half of the way
    assert all(here < 0.5 * there for here, there in zip(away[pace], away[1.0], strict=True))
    assert away[1.0][1] > 0.5


def test_a_quick_spring_stays_within_its_bounds() -> None:
    session = Session(slack_rope())
    mass, interval = session.main.simulation.arrays.mass[20], 1e-3
    stiffness, damping, _ = soft_spring(session.main.simulation, 20, interval, 0.01)
    assert stiffness <= 0.25 * mass / interval**2
    assert damping >= 0.5 * stiffness * interval
