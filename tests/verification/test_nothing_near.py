"""Ropes of up to 255 nodes that may touch, but have nothing near, move as those that may not, to the bits."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.laws.couplings import couples
from ropewalk.laws.pairs.table import CONTACTS
from ropewalk.record.result import Result
from ropewalk.record.simulate import simulate_in_memory
from ropewalk.scene import Contact, Plane, Straight

IMPLICIT = ("implicit-euler", "bdf2", "sdirk2", "esdirk3")
EXPLICIT = ("semi-implicit-euler", "verlet", "rk4")
FRAME = 1.0 / 60.0


def swinging(method: str, *, EI: float = 0.0, floor: bool = False) -> rw.Scene:
    """Return two ropes apart that are held at one end, and swing down for a quarter of a second."""
    bends = {"EI": EI} if EI else {}
    made_of = rw.Material(EA=1e4, mass_per_length=0.1, axial_damping=0.2, **bends)
    ropes = [
        rw.Rope(
            name=name,
            segments=24,
            length=0.48,
            diameter=0.01,
            made_of=made_of,
            shape=Straight(start=(0.0, aside, 0.0), direction=(1.0, 0.0, -0.5)),
        )
        for name, aside in (("one", 0.0), ("other", 0.2))
    ]
    step: dict[str, Any] = {"time_step": 2e-5 if method in EXPLICIT else FRAME}
    if method == "adaptive":
        step = {"tolerance": 1e-4}
    return rw.Scene(
        ropes=ropes,
        anchors=[rw.Anchor(name=rope.name, rope=rope.name, node=0) for rope in ropes],
        obstacles=[Plane(point=(0.0, 0.0, -0.4))] if floor else [],
        run=rw.RunSettings(method=method, frame_rate=60.0, duration=0.25, **step),
    )


def finished(scene: rw.Scene) -> Result:
    """Return what a scene comes to."""
    result = simulate_in_memory(scene)
    assert result.status == "finished", result.diagnosis
    return result


@pytest.mark.parametrize(
    ("floor", "EI"),
    [(False, 0.0), (True, 0.0), (False, 1e-4)],
    ids=["in the air", "with a floor", "bending"],
)
@pytest.mark.parametrize("method", [*IMPLICIT, "adaptive", *EXPLICIT])
def test_what_has_nothing_near_has_the_bits_of_ropes_that_cannot_touch(
    method: str, EI: float, floor: bool
) -> None:
    """The same solves, guesses and tolerance; on the floor limp ropes land in it, too."""
    scene = swinging(method, EI=EI, floor=floor)
    without, apart = finished(scene), finished(scene.replace(contact=Contact()))
    for name in ("positions", "velocities", "tension"):
        assert getattr(without, name).tobytes() == getattr(apart, name).tobytes(), name
    assert np.ptp(without.positions, axis=0).max() > 0.1


def test_ropes_are_coupled_from_their_first_contact_to_their_last() -> None:
    """A rope falls across another, lies on it, and is pulled off again: as many rows as couple."""
    made_of = rw.Material(EA=2e3, mass_per_length=0.05, axial_damping=0.1)
    shapes = {
        "held": Straight(start=(-0.2, 0.0, 0.0), end=(0.2, 0.0, 0.0)),
        "top": Straight(start=(0.0, -0.2, 0.03), end=(0.0, 0.2, 0.03)),
    }
    ropes = [
        rw.Rope(name=name, segments=20, length=0.4, diameter=0.01, made_of=made_of, shape=shape)
        for name, shape in shapes.items()
    ]
    up = rw.scene.Velocity(velocity=(0.0, 0.0, 1.5), start=0.2)
    ends = [
        rw.Anchor(name="a", rope="held", node=0),
        rw.Anchor(name="b", rope="held", node=-1),
        rw.Anchor(name="up", rope="top", node=-1, motion=up),
    ]
    run = rw.RunSettings(method="implicit-euler", time_step=1.0 / 240.0, duration=1.0)
    scene = rw.Scene(ropes=ropes, anchors=ends, contact=Contact(), run=run)
    simulation, seen = rw.Simulation(scene), []
    for _ in range(240):
        simulation.step()
        for engine in getattr(simulation._engine, "engines", [simulation._engine]):
            rows = int(engine.state.memory.contact.tally[CONTACTS])
            seen.append(rows > 0)
            assert bool(couples(engine.system, engine.state)) == (rows > 0)
    assert any(seen)
    assert not seen[0]
    assert not seen[-1]
