"""Grabs and drags: stable at any step, bounded, booked, and the same however time is cut up."""

from __future__ import annotations

import numpy as np
import pytest

from live.drive import do, r4, refused, slack_rope
from ropewalk.live.hands import CONTROL, FASTEST, held_around, soft_spring
from ropewalk.live.session import Session
from ropewalk.scene import Air, Anchor, Hanging, Material, Rope, RunSettings, Scene


def free_node(mass_per_length: float = 0.2, gravity: float = 0.0, air: float = 0.0) -> Session:
    """Return a session of a rope that hangs from its upper end."""
    rope = Rope(
        segments=20,
        length=2.0,
        made_of=Material(EA=500.0, mass_per_length=mass_per_length, axial_damping=0.5),
        shape=Hanging(),
    )
    scene = Scene(
        gravity=(0.0, 0.0, -gravity),
        ropes=[rope],
        anchors=[Anchor(node=0)],
        air=Air(node_drag=air),
        run=RunSettings(time_step=5e-4, method="semi-implicit-euler"),
    )
    return Session(scene)


def test_a_grabbed_node_comes_to_its_target() -> None:
    session = free_node(air=0.02)  # without air the rope, just not taut, swings across for minutes
    do(session, "grab", node=20, target=[1.2, 0.0, -1.6])
    session.advance(20_000)  # 10 s
    simulation = session.main.simulation
    # the target is as far from the anchor as the rope is long, so rope and spring are at rest
    assert np.allclose(simulation.positions[20], [1.2, 0.0, -1.6], atol=0.02)
    assert np.linalg.norm(session.main.hands.grabs[0].force) < 0.05


def test_the_force_of_a_grab_balances_what_it_lifts() -> None:
    session = free_node(gravity=9.81)
    do(session, "grab", node=20, target=[0.0, 0.0, 10.0])
    session.advance(40_000)  # 20 s: the rope stands above its anchor
    simulation = session.main.simulation
    force = session.main.hands.grabs[0].force
    # statics: the hand carries what the anchor does not; the anchor pulls down
    weight = 0.4 * 9.81
    anchor = simulation.anchors["anchor0"].reaction[2]
    assert force[2] + anchor == pytest.approx(weight, rel=0.01)
    stiffness, _, most = soft_spring(simulation, 20, 2 * 5e-4)
    stretch = 10.0 - simulation.positions[20, 2]
    assert force[2] == pytest.approx(min(stiffness * stretch, most), rel=0.01)


@pytest.mark.parametrize("method", ["semi-implicit-euler", "verlet", "rk4"])
def test_a_grab_is_stable_on_a_rope_without_friction(method: str) -> None:
    scene = slack_rope(40)
    made_of = scene.ropes[0].made_of.replace(axial_damping=0.0)
    scene = scene.replace(ropes=[scene.ropes[0].replace(made_of=made_of)])
    session = Session(scene)
    do(session, "set", name="method", value=method)
    session.advance(1000)
    x, y, z = session.main.simulation.positions[20]
    do(session, "grab", node=20, target=[x, y, z + 1.0])
    largest = 0.0
    for _ in range(20):
        assert session.advance(500) == 0
        largest = max(largest, session.main.simulation.recording().recording.energy[0, 0])
    # the grab lifts about half of 2 kg by less than a metre: tens of joules, never more
    assert largest < 50.0


def test_a_spring_that_is_too_stiff_would_not_be() -> None:
    session = free_node()
    stiffness, damping, _ = soft_spring(session.main.simulation, 20, 1e-3)
    mass = session.main.simulation.arrays.mass[20]
    assert stiffness <= 0.25 * mass / 1e-3**2
    assert 0.5 * stiffness * 1e-3 <= damping <= max(0.25 * mass / 1e-3, 0.5 * stiffness * 1e-3)
    assert soft_spring(session.main.simulation, 20, 1.0)[0] < stiffness


def test_a_hand_does_no_work_unseen() -> None:
    session = r4()
    do(session, "set", name="time_step", value=1e-4)  # the method's own error is of first order
    do(session, "grab", node=10, target=[10.0, 4.0, 0.0])
    session.advance(18_500)
    simulation = session.main.simulation
    block = simulation.recording().recording
    _, put_in, error = session.main.books(block)
    assert simulation.arrays.work.applied.sum() > 1.0
    assert put_in > 1.0
    assert abs(error) < 0.02 * put_in


def test_letting_go_ends_the_force() -> None:
    session = r4()
    do(session, "grab", node=10, target=[10.0, 4.0, 0.0])
    session.advance(100)
    assert session.main.simulation.arrays.forces.applied.any()
    do(session, "let_go")
    assert not session.main.simulation.arrays.forces.applied.any()
    assert session.main.hands.grabs == []


def test_another_pages_grab_stays() -> None:
    session = r4()
    do(session, "grab", client=1, node=10, target=[10.0, 4.0, 0.0])
    do(session, "grab", client=2, node=30, target=[30.0, 4.0, 0.0])
    do(session, "drag", client=2, anchor="right", target=[42.0, 0.0, 0.0])
    do(session, "let_go", client=1)
    assert [one.node for one in session.main.hands.grabs] == [30]
    assert "right" in session.main.hands.targets


def test_grabs_are_refused_where_they_make_no_sense() -> None:
    session = r4()
    assert "held by anchor 'middle'; drag that" in refused(
        session, "grab", node=20, target=[0, 0, 0]
    )
    assert "must be from 0 to 40" in refused(session, "grab", node=41, target=[0, 0, 0])
    for node in range(1, 9):
        do(session, "grab", node=node, target=[0, 0, 0])
    assert "8 nodes are grabbed already" in refused(session, "grab", node=9, target=[0, 0, 0])
    do(session, "grab", node=8, target=[1, 0, 0])


def test_a_dragged_anchor_reaches_the_pointer_and_no_faster_than_it_may() -> None:
    session = r4()
    do(session, "drag", anchor="right", target=[41.0, 1.0, 0.0])
    session.advance(270)  # 0.5 s, 25 times the time it follows with
    assert np.allclose(session.main.simulation.anchors["right"].position, [41, 1, 0], atol=1e-6)
    do(session, "drag", anchor="right", target=[1000.0, 1.0, 0.0])
    session.advance(2)
    velocity = session.main.simulation.anchors["right"].velocity
    assert np.linalg.norm(velocity) == pytest.approx(FASTEST)
    do(session, "drop", anchor="right")
    assert not session.main.simulation.anchors["right"].velocity.any()


def test_a_grab_follows_its_node_into_a_finer_rope() -> None:
    session = r4()
    do(session, "set", name="time_step", value=5e-4)
    do(session, "grab", node=10, target=[10.0, 4.0, 0.0])
    do(session, "set", name="segments", value=80)
    assert [one.node for one in session.main.hands.grabs] == [20]
    session.advance(20)
    assert session.main.simulation.arrays.forces.applied[:, 20].any()


@pytest.mark.parametrize("pieces", [1, 7, 100])
def test_the_pieces_in_which_time_goes_on_do_not_matter(pieces: int) -> None:
    whole, cut = r4(), r4()
    for session in (whole, cut):
        do(session, "grab", node=10, target=[10.0, 4.0, 0.0])
        do(session, "drag", anchor="right", target=[42.0, 0.0, 0.0])
    whole.advance(700)
    for _ in range(700 // pieces):
        cut.advance(pieces)
    assert np.array_equal(whole.main.simulation.positions, cut.main.simulation.positions)


def test_updates_are_as_often_as_promised() -> None:
    session = r4()
    do(session, "set", name="time_step", value=1e-4)
    assert session.main.control_steps() * 1e-4 <= CONTROL * (1 + 1e-9)
    assert session.main.control_steps() == 10


def test_updates_are_as_often_on_the_clock_where_the_simulation_is_slow() -> None:
    session = Session(slack_rope())
    do(session, "set", name="time_step", value=1e-5)
    do(session, "drag", anchor="right", target=[8.0, 0.0, 0.5])
    assert session.main.control_steps() == 104
    do(session, "drag", anchor="right", target=[8.0, 0.0, 0.5], pace=0.05)
    assert session.main.control_steps() == 5
    do(session, "drag", anchor="right", target=[8.0, 0.0, 0.5], pace=2e-4)
    assert session.main.control_steps() == 1
    target = np.array([8.0, 0.0, 0.5])
    far = np.linalg.norm(session.main.simulation.anchors["right"].position - target)
    session.advance(1)  # 50 ms on the clock
    moved = far - np.linalg.norm(session.main.simulation.anchors["right"].position - target)
    assert moved == pytest.approx(FASTEST * 1e-5)  # what an anchor may at most


def test_a_rope_of_a_thousand_pieces_is_no_harder_to_lift() -> None:
    """A hand holds a fiftieth of the rope: one node of 1000 would be let go of for its small mass."""
    lifted = {}
    for segments in (40, 1000):
        scene = slack_rope(segments)
        step = RunSettings(duration=5.0, time_step=2e-3, method="implicit-euler")
        session = Session(scene.replace(run=step))
        middle = segments // 2
        before = session.main.simulation.positions[middle].copy()
        target = before + np.array([0.0, 0.0, 1.0])
        do(session, "grab", node=middle, target=list(target), pace=0.05)
        session.advance(150)
        simulation = session.main.simulation
        grab = session.main.hands.grabs[0]
        held = held_around(simulation, middle)
        assert held.size == {40: 1, 1000: 21}[segments]
        assert np.allclose(simulation.arrays.forces.applied.sum(axis=1), grab.force)
        lifted[segments] = simulation.positions[middle, 2] - before[2]
        mass = held.size * simulation.arrays.mass[middle]
        assert soft_spring(simulation, middle, 2e-3, 0.05)[0] <= 0.25 * mass / 2e-3**2
        do(session, "let_go", node=middle, velocity=[0.0, 0.0, 2.0])
        assert not simulation.arrays.forces.applied.any()
        assert np.allclose(simulation.velocities[held], [0.0, 0.0, 2.0])
    assert 0.8 * lifted[40] < lifted[1000] < 1.25 * lifted[40]
    assert lifted[1000] > 0.5


def test_a_hand_beside_an_anchor_pulls_what_is_free() -> None:
    session = Session(slack_rope(1000))
    held = held_around(session.main.simulation, 3)
    assert held.tolist() == list(range(1, 14))  # not node 0, which an anchor has
    assert held_around(session.main.simulation, 998).tolist() == list(range(988, 1000))
