"""Live edits of what touches: ropes are not pressed into each other, contacts are at once the new ones."""

from __future__ import annotations

import numpy as np
import pytest

from live.drive import do, slack_rope
from property.test_islands import on_floor
from ropewalk.laws.contact_frame import DAMP, STIFF
from ropewalk.laws.pairs.table import CONTACTS, PUSH
from ropewalk.live import describe
from ropewalk.live.carry import carry_over
from ropewalk.live.edits import same_nodes
from ropewalk.live.session import Session
from ropewalk.scene import (
    Contact,
    Kick,
    Material,
    Plane,
    Points,
    Rope,
    RunSettings,
    Scene,
    SceneError,
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
