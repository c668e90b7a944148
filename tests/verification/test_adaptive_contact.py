"""Ropes that touch each other, or slide, by `adaptive`: its steps meet what happens on their way."""

from __future__ import annotations

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.core.arrays import Floats
from ropewalk.scene import (
    Anchor,
    Contact,
    Material,
    Plane,
    Rope,
    RunSettings,
    Scene,
    Straight,
    Velocity,
)
from ropewalk.simulation import Simulation
from verification.heaps import Heap, watch
from verification.tangles import tangle

STUFF = Material(EA=2000.0, mass_per_length=0.1, axial_damping=2.0)
THICK = 0.01  # [m]


def lowered(settings: RunSettings) -> Scene:
    """A taut line that is lowered across another and pushes it down by 5 cm, without weight."""
    lines = {
        "under": Straight(start=(-0.5, 0.0, 0.0), direction=(1, 0, 0)),
        "over": Straight(start=(0.02, -0.5, THICK + 0.002), direction=(0, 1, 0)),
    }
    own = {"segments": 9, "length": 1.0, "diameter": THICK, "made_of": STUFF}
    ropes = [Rope(name=name, shape=shape, **own) for name, shape in lines.items()]
    down = {"motion": Velocity(velocity=(0, 0, -0.05))}
    anchors = [
        Anchor(rope=name, node=node, **(down if name == "over" else {}))
        for name in lines
        for node in (0, -1)
    ]
    contact = Contact(friction=0.3)
    return Scene(ropes=ropes, anchors=anchors, contact=contact, gravity=(0, 0, 0), run=settings)


def end_of(**settings: object) -> Floats:
    """Where its nodes are after a second, (n, 3) [m]."""
    run = RunSettings(duration=1.0, frame_rate=10.0, **settings)
    result = rw.simulate(lowered(run))
    assert result.status == "finished"
    places: Floats = result.positions[-1]
    return places


def test_it_comes_to_what_short_steps_come_to() -> None:
    """The nearer, the smaller its tolerance; the line below would lie 25 mm higher if nothing touched it."""
    reference = end_of(method="esdirk3", time_step=1.0 / 4000.0)
    assert reference[:10, 2].min() < -0.02
    off = [
        float(np.abs(end_of(method="adaptive", tolerance=size) - reference).max())
        for size in (1e-4, 1e-5, 1e-6)
    ]
    assert off[0] < 5e-3  # [m]: both lines swing from being struck, for nothing damps them
    assert off[1] < 0.6 * off[0]
    assert off[2] < 0.2 * off[1]


def test_its_walk_is_the_same_however_it_is_recorded_and_called() -> None:
    """To the last bit: what contacts remember are whole numbers, too, and -1 among them is no float.

    It began anew with every call, and where a frame took more tries than a call has it never came to its end.
    """
    found = {}
    for rate in (10.0, 20.0):
        run = RunSettings(duration=0.4, frame_rate=rate, method="adaptive")
        found[rate] = rw.simulate(lowered(run)).positions
    np.testing.assert_array_equal(found[20.0][::2], found[10.0])
    simulation = Simulation(lowered(RunSettings(duration=0.4, frame_rate=10.0, method="adaptive")))
    for frame in range(1, 5):
        simulation.advance_frames(1)
        np.testing.assert_array_equal(simulation.positions, found[10.0][frame])


def test_being_struck_makes_up_no_energy() -> None:
    """A free line is thrown at a held one at 2 m/s: what the method errs is little, and falls with it."""
    errs = []
    for size in (1e-5, 1e-6):
        scene = lowered(
            RunSettings(method="adaptive", tolerance=size, duration=0.4, frame_rate=500.0)
        )
        first, second = scene.ropes
        kicks = [{"node": i, "velocity": (0, 0, -2.0)} for i in range(10)]
        thrown = scene.replace(
            ropes=[first, second.replace(kicks=kicks)], anchors=scene.anchors[:2]
        )
        result = rw.simulate(thrown)
        total = result.energy["total"]
        assert result.status == "finished"
        assert total[0] == pytest.approx(0.2)  # [J]
        risen = total - np.minimum.accumulate(total)
        assert risen.max() < 1e-3 * total[0]  # what contacts had stored, and give back
        assert result.energy_error.max() < 1e-6 * total[0]
        assert float(result.work["contact"][-1]) < -0.1 * total[0]  # they have struck
        assert result.table["largest balance residual [J]"] < 1e-12
        errs.append(result.table["largest energy error [J]"])
    assert errs[0] < 0.02 * total[0]  # all of it lost
    assert errs[1] < 0.5 * errs[0]


@pytest.mark.slow
def test_nothing_passes_in_a_tangle() -> None:
    """Three loops among each other, to rest, by a count that knows no contacts."""
    scene = tangle(0, 1, False)
    settings = scene.run.model_dump(exclude_unset=True) | {"method": "adaptive"}
    del settings["time_step"]
    heap = watch(scene.replace(run=RunSettings(**settings)), Heap("tangle", 0, False), 7.0)
    assert heap.unsolved == 0
    assert heap.passed == 0
    assert heap.changed == 0
    assert heap.contacts > 5
    assert heap.deepest < 0.1
    assert heap.lying < 1e-6


@pytest.mark.parametrize("friction", [0.0, 0.3])
def test_what_slides_meets_nothing_on_its_way(friction: float) -> None:
    """Down a slope at g (sin - mu cos), with and without friction: no step is refused for a stop."""
    slope = np.radians(40.0)
    along = (float(np.cos(slope)), 0.0, -float(np.sin(slope)))
    rope = Rope(
        segments=2, length=0.2, diameter=THICK, made_of=STUFF,
        shape=Straight(start=(0.0, 0.0, 0.5 * THICK / float(np.cos(slope))), direction=along),
    )  # fmt: skip
    plane = Plane(normal=(float(np.sin(slope)), 0.0, float(np.cos(slope))), friction=friction)
    run = RunSettings(duration=1.0, frame_rate=10.0, method="adaptive")
    result = rw.simulate(Scene(ropes=[rope], obstacles=[plane], run=run))
    speed = float(result.velocities[-1, 1] @ np.array(along))
    rate = 9.81 * float(np.sin(slope) - friction * np.cos(slope))
    assert speed == pytest.approx(rate, rel=1e-3)
    counts = result.facts.step_counts
    assert counts["rejected"] < 0.2 * counts["accepted"] + 5
    assert counts["accepted"] < 400
