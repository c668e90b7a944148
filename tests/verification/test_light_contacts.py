"""Contacts that are pressed lightly by what is heavy: it comes to rest on them."""

from __future__ import annotations

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.core.arrays import Floats
from ropewalk.scene import (
    Anchor,
    Contact,
    Force,
    Load,
    Material,
    Rope,
    RunSettings,
    Scene,
    Straight,
)

Point = tuple[float, float, float]

DIAMETER = 0.01  # [m]
PRESS = 0.02  # [N]


def cord(name: str, start: Point, end: Point, segments: int, mass: float, node: int) -> Rope:
    """A cord of 50 g/m with a load, which is pressed lightly."""
    return Rope(
        name=name,
        segments=segments,
        length=float(np.linalg.norm(np.subtract(end, start))),
        diameter=DIAMETER,
        made_of=Material(EA=1e4, mass_per_length=0.05, axial_damping=0.5),
        shape=Straight(start=start, end=end),
        loads=[Load(node=node, mass=mass)] if mass else [],
    )


def swings(scene: Scene, name: str, axis: int) -> Floats:
    """How far the last node of a rope swings along an axis in each sixth of the run, over the diameter."""
    places = rw.simulate(scene).rope(name).positions[:, -1, axis]
    sixth = len(places) // 6
    return np.array([np.ptp(places[k * sixth : (k + 1) * sixth]) for k in range(6)]) / DIAMETER


@pytest.mark.parametrize(
    ("method", "step"), [("sdirk2", 1.0 / 240.0), ("semi-implicit-euler", "auto")]
)
def test_a_loaded_link_that_presses_lightly_comes_to_rest(method: str, step: float | str) -> None:
    """Half a kilogram on either end, on a held cord."""
    link = cord("link", (0, -0.05, DIAMETER), (0, 0.05, DIAMETER), 1, 0.5, 0)
    link = link.replace(
        loads=[Load(node=node, mass=0.5) for node in (0, 1)],
        forces=[Force(node=node, force=(0, 0, -0.5 * PRESS)) for node in (0, 1)],
    )
    scene = Scene(
        ropes=[cord("held", (-0.1, 0, 0), (0.1, 0, 0), 1, 0.0, 0), link],
        anchors=[Anchor(rope="held", node=node) for node in (0, 1)],
        gravity=(0, 0, 0),
        contact=Contact(friction=0.3),
        run=RunSettings(method=method, time_step=step, duration=12.0, frame_rate=60),
    )
    found = swings(scene, "link", 2)
    assert found[0] > 0.005
    assert found[-1] < 2e-4


def test_a_plumb_that_leans_on_a_cord_comes_to_rest() -> None:
    """5 kg on half a metre of cord, in steps of 1/60 s."""
    x = -0.998 * DIAMETER
    plumb = cord("plumb", (0, 0, 0), (0, 0, -0.5), 5, 5.0, 5)
    scene = Scene(
        ropes=[
            cord("held", (x, -0.1, -0.45), (x, 0.1, -0.45), 1, 0.0, 0),
            plumb.replace(forces=[Force(node=5, force=(-PRESS, 0, 0))]),
        ],
        anchors=[
            Anchor(rope="held", node=0),
            Anchor(rope="held", node=1),
            Anchor(rope="plumb", node=0),
        ],
        contact=Contact(friction=0.3),
        run=RunSettings(
            method="implicit-euler", time_step=1.0 / 60.0, duration=15.0, frame_rate=60
        ),
    )
    found = swings(scene, "plumb", 0)
    assert found[0] > 0.005
    assert found[-1] < 2e-4


@pytest.mark.parametrize(
    ("method", "step"), [("sdirk2", 1.0 / 240.0), ("implicit-euler", 1.0 / 60.0)]
)
def test_a_lever_whose_end_moves_as_its_contact_is_pressed_up_comes_to_rest(
    method: str, step: float
) -> None:
    """100 g at the end of half a metre, over a cord at a tenth of it: 11.0 N press on that."""
    height = 0.998 * DIAMETER
    lever = cord("lever", (0, 0, height), (0.5, 0, height), 1, 0.1, 1)
    ends = [(name, node) for name, node in (("held", 0), ("held", 1), ("lever", 0))]
    scene = Scene(
        ropes=[cord("held", (0.05, -0.1, 0), (0.05, 0.1, 0), 1, 0.0, 0), lever],
        anchors=[Anchor(rope=name, node=node) for name, node in ends],
        contact=Contact(friction=0.3),
        run=RunSettings(method=method, time_step=step, duration=20.0, frame_rate=60),
    )
    found = swings(scene, "lever", 2)
    assert found[0] > 0.005
    assert found[-1] < 2e-4
