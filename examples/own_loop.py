"""The stepwise form: whoever owns the loop moves an anchor, pushes a node, and goes back in time."""

import numpy as np

from ropewalk import Anchor, Rope, RunSettings, Scene, Simulation, Springs
from ropewalk.scene import Hand, Hanging

FRAME = 1 / 60  # s


def make() -> Simulation:
    """A hanging rope whose upper end a player holds."""
    rope = Rope(
        segments=20,
        made_of=Springs(
            spring_constant=2000.0, node_mass=0.02, spring_friction=0.1, segment_length=0.1
        ),
        shape=Hanging(start=(0.0, 0.0, 3.0)),
    )
    hand = Anchor(name="hand", node=0, motion=Hand())
    return Simulation(Scene(ropes=[rope], anchors=[hand], run=RunSettings(time_step=0.002)))


def run() -> dict[str, np.ndarray]:
    """Play: carry the rope for a second, save the game, push the end, and go back to the save."""
    sim = make()
    sim.anchors["hand"].velocity = (3.0, 0.0, 0.0)  # m/s
    for _ in range(60):
        sim.step(FRAME)
    sim.anchors["hand"].velocity = (0.0, 0.0, 0.0)
    saved, before = sim.state, sim.positions.copy()
    sim.apply_force(-1, (0.0, 2.0, 0.0))  # N, until another force is set
    for _ in range(60):
        sim.step(FRAME)
    pushed = sim.positions.copy()
    sim.restore(saved)
    return {"before": before, "pushed": pushed, "restored": sim.positions.copy()}


def check(found: dict[str, np.ndarray]) -> None:
    """The hand has gone 3 m, the push goes sideways, and the restored game is the saved one."""
    assert np.allclose(found["before"][0], (3.0, 0.0, 3.0), atol=1e-9)
    assert found["pushed"][-1, 1] > 0.5
    assert np.array_equal(found["restored"], found["before"])


if __name__ == "__main__":
    places = run()
    check(places)
    for moment, positions in places.items():
        x, y, z = positions[-1]
        print(f"{moment:9} the rope's end is at ({x:6.3f}, {y:6.3f}, {z:6.3f}) m")
