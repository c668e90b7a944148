"""Where an obstacle, an anchor or a load presses a rope into another, the result says so."""

from __future__ import annotations

import re

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.scene import Box, Plane, Scene, Shake, Spin, Straight, Velocity

ABOUT = "about the obstacles"
D = 0.01
BED = Plane(name="bed")


def lying(height: float = 0.5 * D, **more: object) -> Scene:
    """A rope of 10 mm along x."""
    made_of = rw.Material(EA=2e4, mass_per_length=0.1, axial_damping=20.0)
    ends = [(x, 0.0, height) for x in (-0.25, 0.25)]
    shape = Straight(start=ends[0], end=ends[1])
    rope = rw.Rope(segments=10, length=0.5, diameter=D, made_of=made_of, shape=shape)
    run = {"method": "esdirk3", "time_step": 0.004, "duration": 1.0, "frame_rate": 50.0}
    return Scene(ropes=[rope], run=run, **more)


def ram(speed: float) -> Plane:
    """A plate above the rope that comes down on it, 20 mm above the bed at first."""
    down = Velocity(velocity=(0, 0, -speed))
    return Plane(name="ram", point=(0, 0, 2.0 * D), normal=(0, 0, -1), motion=down)


def test_a_rope_pressed_flat_is_told() -> None:
    """Between plates that meet 10 mm below the surface of one: 5.97 kN a node, and not a word of it."""
    result = rw.simulate(lying(obstacles=[BED, ram(0.04)]))
    told = result.table[ABOUT]
    found = re.match(
        r"at t = 1 s node \d+ of rope 'rope' was squeezed by 30 mm between 'bed' and 'ram', which overlap by "
        r"20 mm there: a rope has no room there",
        told,
    )
    assert found
    assert "compliance" not in told  # stiffer bodies leave it no more room


@pytest.mark.parametrize(("speed", "lacks"), [(0.0149, 4.9), (0.0112, 1.2), (0.0108, None)])
def test_a_rope_with_less_room_than_it_is_thick_is_told(speed: float, lacks: float | None) -> None:
    """Its middle is in neither body: a half of its thickness was squeezed away without a word."""
    result = rw.simulate(lying(obstacles=[BED, ram(speed)]))
    if lacks is None:  # less than a tenth
        assert ABOUT not in result.table
        return
    told = result.table[ABOUT]
    assert f"squeezed by {lacks:g} mm between 'bed' and 'ram'" in told
    assert f"a rope of 10 mm a gap of {10.0 - lacks:g} mm" in told


def test_check_foresees_bodies_that_come_together() -> None:
    said = [
        w for w in rw.check(lying(obstacles=[BED, ram(0.0149)])).warnings if "starts between" in w
    ]
    assert len(said) == 1
    assert "'bed' and 'ram', which leave a rope of 10 mm a gap of 5.1 mm at t = 1 s" in said[0]
    for quiet in ([BED, ram(0.0108)], [BED, ram(-0.02)], [BED]):
        assert not [w for w in rw.check(lying(obstacles=quiet)).warnings if "starts between" in w]
    aside = Box(  # not where the rope starts
        name="ram",
        center=(1.0, 0, 0.04),
        half_sizes=(0.2, 0.2, 0.02),
        edge_radius=0.005,
        motion=Velocity(velocity=(0, 0, -0.0149)),
    )
    assert not [
        w for w in rw.check(lying(obstacles=[BED, aside])).warnings if "starts between" in w
    ]


def test_check_foresees_what_swings_in_step_with_even_looks() -> None:
    """At 63 even times in 10 s a plate of 6.3 Hz is where it starts: 4 mm were squeezed, and nothing said."""
    for hertz in (6.3, 12.6, 5.5, 8.9, 19.2):
        swings = Shake(axis=(0, 0, 1), amplitude=0.014, frequency=hertz)
        press = Plane(name="press", point=(0, 0, 2.0 * D), normal=(0, 0, -1), motion=swings)
        scene = lying(obstacles=[BED, press])
        scene = scene.replace(run=scene.run.replace(duration=10.0))
        (said,) = [w for w in rw.check(scene, measure=False).warnings if "starts between" in w]
        room = float(said.split("a gap of ")[1].split(" mm")[0])
        assert room == pytest.approx(6.0, abs=0.2)


def test_a_run_that_ends_between_two_bodies_names_both() -> None:
    """One was named, and a shorter step or a stiffer contact advised, which cannot help."""
    half = {"half_sizes": (1.0, 1.0, 0.1), "edge_radius": 0.01}
    down = Velocity(velocity=(0, 0, -1.0))
    boxes = [
        Box(name="table", center=(0, 0, -0.1), **half),
        Box(name="press", center=(0, 0, 0.15), motion=down, **half),
    ]
    with pytest.raises(rw.BrokenRun) as broken:
        rw.simulate(lying(obstacles=boxes))
    why = str(broken.value)
    assert "has no room between obstacles 'table' and 'press'" in why
    assert "time_step" not in why
    assert "compliance" not in why


def test_an_anchor_that_goes_into_a_plane_is_told_by_its_neighbour() -> None:
    down = rw.Anchor(node=-1, motion=Velocity(velocity=(0, 0, -0.5)))
    result = rw.simulate(lying(height=0.1, obstacles=[BED], anchors=[down]))
    assert "node 9 of rope 'rope'" in result.table[ABOUT]
    still = rw.simulate(lying(obstacles=[BED], anchors=[rw.Anchor(node=-1)]))
    assert ABOUT not in still.table


def test_a_heavy_node_that_an_anchor_lets_go_inside_is_refused() -> None:
    """300 kg from 20 mm below a floor; while the anchor holds it nothing presses it, and nothing is told."""
    rope = rw.Rope(
        segments=6,
        length=0.6,
        diameter=D,
        made_of=rw.Material(EA=2e4, mass_per_length=0.1, axial_damping=20.0),
        shape=Straight(start=(0, 0, -2.0 * D), end=(0.4, 0, 0.4)),
        loads=[rw.scene.Load(node=0, mass=300.0)],
    )
    run = {"method": "esdirk3", "time_step": 0.004, "duration": 0.06, "frame_rate": 250.0}
    held = [rw.Anchor(node=0), rw.Anchor(node=-1)]
    assert (
        ABOUT not in rw.simulate(Scene(ropes=[rope], anchors=held, obstacles=[BED], run=run)).table
    )
    held = [rw.Anchor(node=0, release_time=0.03), rw.Anchor(node=-1)]
    with pytest.raises(
        rw.SceneError, match="release_time: 0.03 - lets go 25 mm inside obstacle 'bed'"
    ):
        rw.simulate(Scene(ropes=[rope], anchors=held, obstacles=[BED], run=run))


def test_a_body_is_where_it_has_turned_to() -> None:
    """A free plank is upright as a rope lands beside it, 20 mm inside where it was drawn."""
    plank = Box(
        name="plank",
        center=(0, 0, 0),
        half_sizes=(0.5, 0.5, 0.02),
        edge_radius=0.005,
        axis=(1, 0, 0),
        spin=Spin(free=True, inertia=10.0, rate=3.3),
    )
    floor = Plane(name="floor", point=(0, 0, -0.5 * D))
    scene = lying(height=1.0, obstacles=[plank, floor])
    rope = scene.ropes[0]
    aside = Straight(start=(-0.25, -0.2, 1.0), end=(0.25, -0.2, 1.0))
    run = scene.run.replace(duration=0.5)
    result = rw.simulate(scene.replace(ropes=[rope.replace(shape=aside)], run=run))
    assert result.obstacle_force[-1].any()
    assert np.abs(result.positions[-1, :, 2]).max() < 0.1 * D
    assert result.pulley("plank").angle[-1] == pytest.approx(1.65, rel=0.01)
    assert ABOUT not in result.table
