"""A node that is braked well before it touches: the result says so, and with which compliance it is not."""

from __future__ import annotations

import re

import pytest

import ropewalk as rw
from ropewalk.scene import Load, Plane, Scene, Straight

ABOUT = "about the contacts"
D = 0.01


def falling(mass: float, EA: float = 500.0, frames: float = 500.0, **more: object) -> Scene:
    """A rope that falls flat on a floor at 5 m/s, a load at its middle."""
    made_of = rw.Material(EA=EA, mass_per_length=0.05, axial_damping=1.0)
    rope = rw.Rope(
        segments=6,
        length=0.6,
        diameter=D,
        made_of=made_of,
        shape=Straight(start=(0, 0, 0.4), direction=(1, 0, 0), velocity=(0, 0, -5.0)),
        loads=[Load(node=3, mass=mass)] if mass else [],
    )
    run = {"method": "implicit-euler", "time_step": 1e-3, "duration": 0.15, "frame_rate": frames}
    return Scene(ropes=[rope], obstacles=[Plane(name="floor", **more)], run=run)


@pytest.mark.parametrize("frames", [500.0, 100.0])
def test_a_heavy_load_is_braked_before_it_touches_and_that_is_told(frames: float) -> None:
    """From 2 v sqrt(m / k) on, some 15 cm of 2 kg at 5 m/s where k is what the rope's own segments bear."""
    result = rw.simulate(falling(2.0, frames=frames))
    told = result.table[ABOUT]
    found = re.search(
        r"node 3 of rope 'rope' was braked (\S+) mm before 'floor'.* compliance of (\S+) m/N", told
    )
    assert found
    frame = result.frame_at(float(re.search(r"at t = (\S+) s", told)[1]))
    assert float(found[1]) == pytest.approx(
        1e3 * (result.positions[frame, 3, 2] - 0.5 * D), rel=0.01
    )
    assert float(found[1]) > 50.0
    harder = rw.simulate(falling(2.0, compliance=float(found[2])))
    assert ABOUT not in harder.table
    # the hit is the same: all of the speed goes
    assert abs(harder.velocities[-1, 3, 2]) < 0.05


def test_a_rope_alone_is_not_told_of() -> None:
    """Its own nodes are braked 22 mm before."""
    assert ABOUT not in rw.simulate(falling(0.0, EA=5000.0)).table


@pytest.mark.parametrize("beside", [0.08, 0.04])
def test_it_is_told_of_what_brakes_not_of_what_is_nearest(beside: float) -> None:
    """A wall that nothing comes at was named for the floor, or hid it where it is as near as goes unsaid."""
    scene = falling(2.0)
    scene = scene.replace(run=scene.run.replace(time_step=2e-3, duration=0.08))
    wall = Plane(name="wall", point=(0, beside, 0), normal=(0, -1, 0))
    alone, walled = (
        rw.simulate(scene.replace(obstacles=[*scene.obstacles, *more])).table[ABOUT]
        for more in ([], [wall])
    )
    assert "before 'floor'" in alone
    assert walled == alone
