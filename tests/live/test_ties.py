"""Points tied by hand: what brings them together, what it does to energy, what cannot be tied."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from live.drive import do, refused, slack_rope
from ropewalk.live import describe
from ropewalk.live.frozen import scene_now
from ropewalk.live.keeper import Keeper
from ropewalk.live.pictures import Compared, pictures
from ropewalk.live.relive import relive
from ropewalk.live.session import Session
from ropewalk.scene import (
    Anchor,
    Contact,
    Hand,
    Material,
    Rope,
    RunSettings,
    Scene,
    Straight,
    Winch,
    dumps,
    loads,
)


def two(method: str = "semi-implicit-euler", apart: float = 1.0, **more: object) -> Scene:
    """Two ropes that hang side by side, so far apart [m]."""
    made_of = Material(EA=2e4, mass_per_length=0.2, axial_damping=2.0)
    ropes = [
        Rope(
            name=name,
            segments=10,
            length=2.0,
            diameter=0.01,
            made_of=made_of,
            shape=Straight(start=(x, 0.0, 0.0), end=(x, 0.0, -2.0)),
        )
        for name, x in (("a", 0.0), ("b", apart))
    ]
    anchors = [Anchor(name=f"{name}0", rope=name, node=0) for name in "ab"]
    run = RunSettings(duration=5.0, time_step=2e-4, method=method)
    return Scene(ropes=ropes, anchors=anchors, run=run, **more)  # type: ignore[arg-type]


A_END, B_END = 10, 21


def tie(session: Session, seconds: float = 10.0, node: int = A_END, other: int = B_END) -> str:
    """Tie two nodes and go on until that is over; return what was said then."""
    do(session, "tie", node=node, other=other)
    end = session.time + seconds
    while session.time < end:
        session.advance(10)
        if (note := session.end_ties()) is not None:
            return note
    raise AssertionError("hands are still at it")


@pytest.mark.parametrize("method", ["semi-implicit-euler", "implicit-euler"])
def test_two_ends_are_brought_together_and_tied_without_a_jump(method: str) -> None:
    session = Session(two(method))
    assert "1 m apart" in do(session, "tie", node=A_END, other=B_END)
    track = session.main
    fastest, places = 0.0, track.simulation.positions
    while not session.main.hands.over(track.simulation):
        before, last = places.copy(), session.time
        session.advance(5)
        places = session.main.simulation.positions
        moved = np.linalg.norm(places - before, axis=1)[[A_END, B_END]].max()
        fastest = max(fastest, float(moved) / (session.time - last))
    assert 0.5 < fastest <= 1.01  # [m/s]
    x, v = places.copy(), track.simulation.velocities.copy()
    assert np.linalg.norm(x[A_END] - x[B_END]) <= 2e-6
    energy = track.energy
    assert session.end_ties() == ""
    assert np.abs(session.main.simulation.positions - x).max() <= 2e-6
    assert np.abs(session.main.simulation.velocities - v).max() <= 1e-9
    assert abs(session.main.energy - energy) < 1e-3
    (variant,) = describe.layout(session)["variants"]
    assert variant["joints"] == [{"name": "knot1", "nodes": [A_END, B_END]}]
    assert [one["name"] for one in variant["anchors"]] == ["a0", "b0"]
    session.advance(2000)
    places = session.main.simulation.positions
    assert np.array_equal(places[A_END], places[B_END])  # to the last bit
    assert session.undo.word == "the tie"
    do(session, "undo")
    assert describe.layout(session)["variants"][0]["joints"] == []
    apart = session.main.simulation.positions[[A_END, B_END]]
    assert np.ptp(apart[:, 0]) == 1.0  # as they hung before
    assert session.main.hands.pulls == []


def test_the_work_of_the_hands_is_booked() -> None:
    """The error of the energy stays that of a run that nobody touches."""

    def error(session: Session) -> float:
        return abs(session.main.books(session.main.simulation.recording().recording)[2])

    session, twin = Session(two()), Session(two())
    assert tie(session) == ""
    session.advance(2000)
    twin.advance(session.count)
    lifted = session.main.energy - session.main.first_energy - twin.main.energy
    assert lifted > 0.1  # [J]
    assert error(session) < 0.02 * lifted


def test_an_edit_that_moves_nothing_leaves_the_energies_where_they_are() -> None:
    """Gravity counts from the shapes that a scene draws, which an edit puts aside."""
    session = Session(two())
    session.advance(50)

    def shown() -> tuple[float, float]:
        (one,) = pictures(session.tracks, Compared())
        return one.scalars["gravity"], one.scalars["put_in"]

    before = shown()
    do(session, "pin", node=5)
    gravity, put_in = shown()
    assert gravity == pytest.approx(before[0], abs=1e-9)
    assert abs(put_in) < 1e-3  # the pinned node's motion; it was -7.8 J
    do(session, "undo")
    assert shown() == pytest.approx(before, abs=1e-9)


def test_a_point_goes_to_one_that_an_anchor_holds() -> None:
    session = Session(two())
    assert tie(session, node=A_END, other=11) == ""
    places = session.main.simulation.positions
    assert np.array_equal(places[A_END], places[11])
    assert places[11] == pytest.approx([1.0, 0.0, 0.0], abs=1e-12)
    assert session.main.holder(A_END) == "b0"


def test_what_cannot_come_together_is_let_go_and_says_why() -> None:
    """The anchor of rope b is carried off while hands are at it."""
    scene = two()
    session = Session(
        scene.replace(anchors=[scene.anchors[0], scene.anchors[1].replace(motion=Hand())])
    )
    do(session, "move", anchor="b0", velocity=[4.0, 0.0, 0.0])
    note = tie(session)
    assert "not tied: still" in note
    assert "20 times the ropes' weight" in note
    assert [one.name for one in session.scene.anchors] == ["a0", "b0"]
    assert not session.scene.joints
    session.advance(500)
    assert np.isfinite(session.main.simulation.positions).all()


def test_letting_go_of_everything_gives_it_up() -> None:
    session = Session(two())
    do(session, "tie", node=A_END, other=B_END)
    session.advance(100)
    do(session, "let_go", client=2)
    assert session.end_ties() is None  # that was another's hand
    do(session, "let_go")
    assert "not tied" in str(session.end_ties())
    assert [one.name for one in session.scene.anchors] == ["a0", "b0"]
    # The twin: a hand that loses its point.
    do(session, "tie", node=A_END, other=B_END)
    do(session, "unpin", anchor="tie1")
    assert "has lost its point" in str(session.end_ties())
    assert [one.name for one in session.scene.anchors] == ["a0", "b0"]


def test_a_joint_takes_in_what_is_tied_to_its_nodes() -> None:
    session = Session(two())
    tie(session)
    assert "are tied already, by joint 'knot1'" in refused(session, "tie", node=A_END, other=B_END)
    assert tie(session, node=A_END, other=16) == ""
    (variant,) = describe.layout(session)["variants"]
    assert variant["joints"] == [{"name": "knot1", "nodes": [A_END, 16, B_END]}]
    # The scene as it stands can be written, and opened again.
    again = loads(dumps(scene_now(session)))
    assert Session(again).main.simulation.positions == pytest.approx(
        session.main.simulation.positions, abs=1e-12
    )


def test_refusals_name_the_points_and_the_reason() -> None:
    session = Session(two())
    assert "one and the same" in refused(session, "tie", node=3, other=3)
    assert "node 3 of 'a' and node 4 of 'a'" in refused(session, "tie", node=3, other=4)
    assert "are neighbours" in refused(session, "tie", node=3, other=4)
    assert "let one of the two go first" in refused(session, "tie", node=0, other=11)
    assert "must be from 0 to 21" in refused(session, "tie", node=0, other=22)
    assert (session.scene.joints, session.main.hands.pulls) == ((), [])
    touching = Session(two(contact=Contact()))
    assert "where ropes touch each other" in refused(touching, "tie", node=A_END, other=B_END)
    wound = Session(two("implicit-euler", winches=[Winch(rope="a", end="start", speed=0.0)]))
    said = refused(
        wound,
        "tie",
        node=wound.main.simulation.layout.span("a").start,
        other=wound.main.simulation.layout.span("b").end,
    )
    assert "is on a winch's drum: choose a point off it" in said
    reeling = Session(two("implicit-euler", winches=[Winch(rope="a", end="start", speed=-0.5)]))
    span = reeling.main.simulation.layout.span("a")
    while reeling.main.simulation.arrays.winch_exit[0] < span.start + 2:
        reeling.advance(10)
    for node in (span.start + 1, span.start + 2):  # on the drum, and where rope leaves it
        assert "is on a winch's drum: choose" in refused(
            reeling, "tie", node=node, other=span.end + 11
        )
    assert reeling.main.hands.pulls == []


def test_a_tie_is_played_again_to_the_same_bits(tmp_path: Path) -> None:
    session = Session(two())
    keeper = Keeper(session, tmp_path / "run")
    assert tie(session) == ""
    session.advance(300)
    keeper.close()
    again = relive(tmp_path / "run")
    assert [one.name for one in again.scene.joints] == ["knot1"]
    assert np.array_equal(again.main.simulation.positions, session.main.simulation.positions)
    assert (tmp_path / "run" / "part-3").is_dir()  # hands, then the joint


def test_a_picture_follows_that_has_other_anchors_than_what_was_seen() -> None:
    """Hands go within a tick, after steps that a page has not seen yet."""
    session = Session(two(apart=0.02))
    assert tie(session) == ""
    kept = session.main.shown.kept
    assert kept is not None
    assert kept.reaction.size == 4
    (shown,) = pictures(session.tracks, Compared())
    assert shown.seen.greatest_force.shape == (2,)
    session.advance(session.frame_steps)
    assert session.main.frame().recording.reaction_high.shape[1] == 2


def test_both_variants_of_a_comparison_are_tied() -> None:
    session = Session(slack_rope())
    do(session, "compare", variants=[{"changes": {"segments": 20}}])
    do(session, "tie", node=18, other=22)
    for _ in range(3000):
        session.advance(10)
        session.end_ties()
        if not any(track.hands.pulls for track in session.tracks):
            break
    assert [len(track.scene.joints) for track in session.tracks] == [1, 1]


def test_a_point_meets_one_that_an_anchor_carries_about() -> None:
    scene = two()
    session = Session(
        scene.replace(anchors=[scene.anchors[0], scene.anchors[1].replace(motion=Hand())])
    )
    do(session, "move", anchor="b0", velocity=[0.2, 0.0, 0.1])
    assert tie(session, node=A_END, other=11) == ""
    assert session.main.holder(A_END) == "b0"
    session.advance(100)
    places, speeds = session.main.simulation.positions, session.main.simulation.velocities
    assert np.array_equal(places[A_END], places[11])
    assert speeds[A_END] == pytest.approx([0.2, 0.0, 0.1])


def test_points_that_ropes_hold_too_far_apart_are_refused_at_once() -> None:
    session = Session(slack_rope())
    said = refused(session, "tie", node=10, other=30)
    assert "cannot meet: anchors 'left' and 'right' are 8 m apart" in said
    assert session.main.hands.pulls == []
