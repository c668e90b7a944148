"""An overhand knot that is pulled tight: it stays a trefoil, whatever the pull."""

from __future__ import annotations

import numpy as np
import pytest

from ropewalk.core.arrays import Floats
from ropewalk.scene import Anchor, Contact, Material, Points, Rope, RunSettings, Scene, Velocity
from ropewalk.simulation import Simulation
from verification.topology import determinant

DIAMETER = 0.005
FAR = 10.0  # [m]


def overhand(touch: bool = True) -> Scene:
    """A loose one between two anchors that go apart; no weight."""
    t = np.linspace(-2.02, 2.02, 1500)  # Shastri 1992, Tohoku Math. J. 44:11
    curve = np.stack((t**3 - 3.0 * t, t**4 - 4.0 * t**2, 0.06 * (t**5 - 10.0 * t)), axis=1)
    curve *= 1.6 * DIAMETER / 0.2066  # strands are 1.6 diameters apart
    tail = 12.0 * DIAMETER * np.array([1.0, 0.0, 0.0])
    curve = np.vstack([curve[0] - tail, curve, curve[-1] + tail])
    arc = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(curve, axis=0), axis=1))])
    segments = int(arc[-1] / (1.2 * DIAMETER))
    at = np.linspace(0.0, arc[-1], segments + 1)
    points = np.stack([np.interp(at, arc, curve[:, k]) for k in range(3)], axis=1)
    length = float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum())
    rope = Rope(
        segments=segments,
        length=length,
        diameter=DIAMETER,
        made_of=Material(EA=1e4, mass_per_length=0.02, axial_damping=0.5),
        shape=Points(points=points.tolist()),
    )
    ends = [
        Anchor(node=node, motion=Velocity(velocity=(speed, 0, 0)))
        for node, speed in ((0, -0.5), (-1, 0.5))
    ]
    run = RunSettings(method="implicit-euler", time_step=1 / 60, frame_rate=60)
    contact = Contact(friction=0.3) if touch else None
    return Scene(gravity=(0, 0, 0), ropes=[rope], anchors=ends, contact=contact, run=run)


def knot_of(x: Floats) -> set[int]:
    """Its determinants in two projections, the rope closed far away; (3, n)."""
    ends = [[FAR, x[1, -1], x[2, -1]], [FAR, FAR, x[2, -1]], [-FAR, FAR, x[2, 0]]]
    closed = np.vstack([x.T, ends, [[-FAR, x[1, 0], x[2, 0]]]])
    return {determinant(closed, turn) for turn in (0.3, 1.1)}


def pulled(scene: Scene, force: float) -> tuple[Simulation, float]:
    """The knot pulled until the rope carries a force [N], and the rope left in it, over its diameter."""
    simulation, rope = Simulation(scene), scene.ropes[0]
    for _ in range(80):
        simulation.step(1.0 / 60.0)
        state = simulation.arrays
        pull = state.tension
        apart = np.linalg.norm(state.x[:, -1] - state.x[:, 0])
        left = (rope.length_unstretched * (1.0 + pull.mean() / 1e4) - apart) / DIAMETER
        if pull.max() > force:
            return simulation, float(left)
    raise AssertionError("it never got taut")


@pytest.mark.slow
def test_an_overhand_knot_pulled_tight_stays_one() -> None:
    """At 200 N ten diameters of rope at least are in it, and it has the determinant of a trefoil."""
    scene = overhand()
    assert knot_of(Simulation(scene).arrays.x) == {3}
    simulation, left = pulled(scene, 200.0)
    assert knot_of(simulation.arrays.x) == {3}
    assert 10.0 < left < 14.0


@pytest.mark.slow
def test_the_twin_without_contact_is_pulled_straight() -> None:
    """Else the test above would show nothing."""
    simulation, left = pulled(overhand(touch=False), 200.0)
    assert knot_of(simulation.arrays.x) == {1}
    assert abs(left) < 0.5
