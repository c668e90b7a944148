"""Live edits of what touches: ropes are not pressed into each other, contacts are at once the new ones."""

from __future__ import annotations

import numpy as np
import pytest

from live.drive import do, slack_rope
from property.test_islands_kept import on_floor
from ropewalk.laws.contact_frame import DAMP, STIFF
from ropewalk.laws.pairs.table import CONTACTS, LEVER, MORE, PUSH, SPRING
from ropewalk.live import describe
from ropewalk.live.carry import carry_over
from ropewalk.live.edits import cut, same_nodes
from ropewalk.live.session import Session
from ropewalk.scene import (
    Anchor,
    Contact,
    Kick,
    Material,
    Plane,
    Points,
    Rope,
    RunSettings,
    Scene,
    SceneError,
    Straight,
    Velocity,
)
from ropewalk.simulation import Simulation
from unit.test_pair_memory import crossed


def lying() -> Simulation:
    """A bar that lies on a rope, pressed by some hundredths of a millimetre."""
    simulation = Simulation(crossed(0.05))
    simulation.step(0.5)
    return simulation


def thicker(scene: Scene, diameter: float) -> Scene:
    """The scene with another diameter of the bar."""
    ropes = [scene.ropes[0], scene.ropes[1].replace(diameter=diameter)]
    return scene.replace(ropes=ropes)


def test_a_rope_that_would_be_pressed_into_another_is_not_made_thicker() -> None:
    """3 mm more are 1.6 mm inside the other, which no step could undo; a tenth more carries on."""
    simulation = lying()
    source = same_nodes(simulation.layout)
    with pytest.raises(SceneError, match=r"rope\[1\].diameter: .* mm inside segment 0 of rope 'a'"):
        carry_over(simulation, thicker(simulation.scene, 0.013), source)
    made = carry_over(simulation, thicker(simulation.scene, 0.011), source)
    made.step(0.1)
    memory = made.arrays.memory.contact
    assert memory.tally[CONTACTS] == 1
    assert memory.grip[0, PUSH] > 0.0


def test_contact_is_not_switched_on_where_ropes_lie_in_each_other() -> None:
    """Without contact the bar went half way into the rope; with it that is refused."""
    scene = crossed(0.05, speed=0.01)
    simulation = Simulation(scene.replace(contact=None))
    simulation.step(0.5)
    with pytest.raises(SceneError, match="inside segment 0 of rope 'a'"):
        carry_over(simulation, scene.replace(contact=Contact()), same_nodes(simulation.layout))


def falling(compliance: float, method: str) -> Scene:
    """A level rope 10 cm over a floor that comes down at 1 m/s."""
    rope = Rope(
        segments=4,
        length=0.4,
        diameter=0.01,
        made_of=Material(EA=100.0, mass_per_length=0.06),
        shape=Points(points=[(0.1 * i, 0.0, 0.105) for i in range(5)]),
        kicks=[Kick(node=i, velocity=(0.0, 0.0, -1.0)) for i in range(5)],
    )
    run = RunSettings(method=method, duration=1.0, frame_rate=240.0)
    return Scene(ropes=[rope], obstacles=[Plane(compliance=compliance)], run=run)


@pytest.mark.parametrize("method", ["verlet", "implicit-euler"])
def test_a_floor_that_is_made_softer_does_not_stop_what_is_over_it(method: str) -> None:
    """The damper of the stiffer one reached half a metre up, and held a falling rope for a step."""
    simulation = Simulation(falling(1e-7, method))
    simulation.advance_frames(5)
    source = same_nodes(simulation.layout)
    made = carry_over(simulation, falling(1e-2, method), source)
    made.advance_frames(1)
    assert np.allclose(made.velocities[:, 2], -1.0 - 9.81 * 6 / 240, rtol=1e-6)


@pytest.mark.parametrize("ropes", [1, 2])
def test_an_edit_books_no_slip_on_a_floor_that_moves_sideways(ropes: int) -> None:
    """Of two ropes that nothing ties the floor's whole way since t = 0 was slip in the step after."""
    scene = on_floor(Velocity(velocity=(0.1, 0.0, 0.0)), ropes, friction=0.9)
    simulation, other = Simulation(scene), Simulation(scene)
    simulation.advance_frames(40)
    other.advance_frames(40)
    made = carry_over(simulation, scene, same_nodes(simulation.layout))
    for one in (made, other):
        one.advance_frames(2)
    assert np.allclose(made.positions, other.positions, rtol=0.0, atol=1e-12)
    works = [one.recording().recording.work[-1] for one in (made, other)]
    assert np.allclose(*works, rtol=0.0, atol=1e-9)


def test_contacts_that_an_edit_leaves_alone_carry_on_as_hard_as_they_are() -> None:
    """What the last step's depth says of them holds for the next step, too."""
    scene = falling(1e-7, "implicit-euler")
    scene = scene.replace(obstacles=[Plane()])
    simulation = Simulation(scene)
    simulation.advance_frames(5)
    grip = simulation.arrays.memory.obstacle.grip
    grip[:, [STIFF, DAMP], 2] = 1234.0, 56.0
    made = carry_over(simulation, scene.replace(gravity=(0, 0, -1)), same_nodes(simulation.layout))
    assert (made.arrays.memory.obstacle.grip[0, [STIFF, DAMP], 2] == (1234.0, 56.0)).all()


def test_a_load_at_a_cut_end_does_not_take_the_ropes_own_half_segment() -> None:
    """Of a rope of 2 kg 0.1 kg was gone where a load was hung on a cut end and taken off again."""
    session = Session(slack_rope(10))
    whole = session.main.simulation.arrays.mass.sum()
    do(session, "cut", segment=4)
    assert describe.layout(session)["variants"][0]["loads"] == []  # nobody has hung one
    assert session.main.simulation.arrays.mass.sum() == pytest.approx(whole, rel=1e-12)
    for change in ("load", "segments", "load", "cut", "load"):
        node = session.main.simulation.layout.ropes[0].last
        if change == "load":
            for mass in (1.0, 2.0, 0.0):
                do(session, "load", node=node, mass=mass)
                now = session.main.simulation.arrays.mass.sum()
                assert now - mass == pytest.approx(whole, rel=1e-12)
                told = describe.layout(session)["variants"][0]["loads"]
                assert [one["mass"] for one in told] == ([mass] if mass else [])
        elif change == "segments":
            do(session, "set", name="segments", value=6)
        else:
            do(session, "cut", segment=2)


def hanging() -> Scene:
    """A rope of six segments that hangs straight from an anchor, in a scene in which ropes touch."""
    rope = Rope(
        name="idle",
        segments=6,
        length=0.6,
        diameter=0.01,
        made_of=Material(EA=2e4, mass_per_length=0.05, axial_damping=5.0),
        shape=Straight(start=(0.0, 0.0, 1.0), end=(0.0, 0.0, 0.4)),
    )
    run = RunSettings(method="implicit-euler", time_step=1 / 60, frame_rate=60.0, duration=10.0)
    return Scene(ropes=[rope], anchors=[Anchor(node=0)], contact=Contact(friction=0.3), run=run)


def test_what_is_cut_within_goes_on_as_two_ropes_that_touch() -> None:
    """Both counted as one whose segment between them was whole, and met what was to go through it."""
    simulation = Simulation(hanging())
    simulation.step(0.1)
    edit = cut(simulation.scene, simulation.layout, 3)
    made = carry_over(simulation, edit.scene, edit.source)
    assert made.arrays.memory.contact.rope.tolist() == [0, 0, 0, -1, 1, 1]
    made.step(0.3)
    fallen = simulation.positions[4:, 2] - made.positions[4:, 2]
    assert np.allclose(fallen, 0.5 * 9.81 * 0.3**2, rtol=0.1)


def test_what_is_cut_elsewhere_leaves_contacts_what_they_hold() -> None:
    """All forgot friction and offsets where any node was dropped: the bar sank anew, and slipped.

    The idle rope is the first, so that all numbers change.
    """
    scene = crossed(0.05, free=True)
    scene = scene.replace(
        ropes=[
            hanging().ropes[0].replace(shape=Straight(start=(3, 0, 1), end=(3, 0, 0.4))),
            *scene.ropes,
        ],
        anchors=[Anchor(name="idle", rope="idle", node=0), *scene.anchors],
        gravity=(0.5, 1.5, -9.81),
    )
    simulation = Simulation(scene)
    simulation.step(0.5)
    before = simulation.arrays.memory.contact
    assert before.grip[0, MORE] > 1e-5
    edit = cut(simulation.scene, simulation.layout, 5)
    made = carry_over(simulation, edit.scene, edit.source)
    after = made.arrays.memory.contact
    assert made.layout.nodes == simulation.layout.nodes - 1
    assert (after.pair[:1] == before.pair[:1] - 1).all()
    assert (after.grip[:1] == before.grip[:1]).all()
    for one in (simulation, made):
        one.step(0.1)
    assert np.allclose(made.positions[-2:], simulation.positions[-2:], rtol=0.0, atol=1e-9)


def test_contacts_whose_segments_change_places_turn_round() -> None:
    """What one side of a contact held is the other's, where its segment has the lesser number now."""
    simulation = lying()
    scene, memory = simulation.scene, simulation.arrays.memory.contact
    start, count = simulation.layout.ropes[1].start, simulation.layout.nodes
    push = memory.grip[0, PUSH]
    memory.grip[0, SPRING : SPRING + 3] = 0.1 * push, 0.2 * push, 0.0
    memory.grip[0, LEVER : LEVER + 6] = 0.1, 0.2, 0.0, 0.3, 0.05, 0.0
    swapped = scene.replace(ropes=[scene.ropes[1], scene.ropes[0]])
    source = np.array([*range(start, count), *range(start)], float)
    forces = [
        carry_over(simulation, *one).arrays.forces.node.contact
        for one in ((scene, same_nodes(simulation.layout)), (swapped, source))
    ]
    assert (np.abs(forces[0]).max(axis=1)[:5] > 0.04 * push).all()
    assert np.allclose(forces[1], forces[0][:, source.astype(int)], rtol=1e-9, atol=1e-12)


@pytest.mark.parametrize(("segments", "at"), [(8, 4), (40, 20)])
def test_a_rope_can_be_cut_beside_another_that_it_may_touch(segments: int, at: int) -> None:
    """Its runs of segments that are watched for others are not those of before."""
    ropes = [
        Rope(
            name=f"r{k}", segments=segments, length=2.0, diameter=0.02,
            made_of=Material(EA=1e3, mass_per_length=0.2, axial_damping=2.0),
            shape=Straight(start=(0, k, 0), direction=(1, 0, 0)),
        )
        for k in range(2)
    ]  # fmt: skip
    held = [Anchor(name=f"a{k}", rope=f"r{k}", node=0) for k in range(2)]
    run = RunSettings(method="implicit-euler", duration=1.0, frame_rate=60.0, time_step=1 / 60)
    session = Session(Scene(ropes=ropes, anchors=held, contact=Contact(friction=0.2), run=run))
    session.advance(3)
    do(session, "cut", segment=at)
    session.advance(3)
    assert len(session.scene.ropes) == 3
