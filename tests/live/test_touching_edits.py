"""Live edits of ropes that touch: what would press them into each other is refused in words."""

from __future__ import annotations

import pytest

from ropewalk.laws.pairs.table import CONTACTS, PUSH
from ropewalk.live.carry import carry_over
from ropewalk.live.edits import same_nodes
from ropewalk.scene import Contact, Scene, SceneError
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
