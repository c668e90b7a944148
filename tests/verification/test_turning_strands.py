"""Strands that lie along each other and turn together do not rub: coils, and drums that wind in layers."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from ropewalk import simulate
from ropewalk.laws.pairs.force import pair_forces
from ropewalk.laws.pairs.offsets import FADES
from ropewalk.laws.pairs.pair_memory import remember_pairs
from ropewalk.laws.pairs.table import CONTACTS, LEVER, PUSH, SPRING
from ropewalk.lowering import build
from ropewalk.record.result import Result
from ropewalk.scene import (
    Anchor,
    Contact,
    Cylinder,
    Load,
    Material,
    Orbit,
    Rope,
    RunSettings,
    Scene,
    Spin,
    Straight,
)

D = 0.01
WINDS = 3.0  # rad/s
RADIUS = 0.05


def strands() -> Scene:
    """Two strands that press each other by 1 % of a diameter all along."""
    stuff = Material(EA=1e4, mass_per_length=0.1)
    ropes = [
        Rope(
            name=name,
            segments=5,
            length=0.1,
            diameter=D,
            made_of=stuff,
            shape=Straight(
                start=(0.004 * k, 0, 0.99 * D * k), end=(0.1 + 0.004 * k, 0, 0.99 * D * k)
            ),
        )
        for k, name in enumerate(("below", "above"))
    ]
    run = RunSettings(method="implicit-euler", time_step=1e-3, frame_rate=1000)
    return Scene(gravity=(0, 0, 0), ropes=ropes, contact=Contact(friction=0.3), run=run)


def pressed() -> tuple[Any, Any, Any]:
    """Table, state and memory of both, their contacts found and pressed."""
    model = build(strands(), drawn=False)
    state, table = model.state, model.system.node.contact
    memory = state.memory.contact
    remember_pairs(state.x, state.v, 50.0 * FADES, table, memory, state.tied)
    assert memory.tally[CONTACTS] >= 5
    return table, state, memory


def turned(x: np.ndarray, angle: float) -> np.ndarray:
    """Return places (3, n) after a rigid turn about y."""
    c, s = math.cos(angle), math.sin(angle)
    return np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]]) @ x


def rubbed(*, levers: bool, steps: int = 40, angle: float = 0.4) -> float:
    """Return the share of what friction can carry that it carries after a rigid turn [1]."""
    table, state, memory = pressed()
    start, most = state.x.copy(), 0.0
    for step in range(1, steps + 1):
        state.x[...] = turned(start, angle * step / steps)
        if not levers:
            memory.grip[:, LEVER:] = 0.0
        remember_pairs(state.x, state.v, 1e-3, table, memory, state.tied)
        grip = memory.grip[: memory.tally[CONTACTS]]
        carries = grip[:, PUSH] > 0.0
        size = np.linalg.norm(grip[carries, SPRING : SPRING + 3], axis=1)
        most = max(most, float((size / (0.3 * grip[carries, PUSH])).max()))
    return most


def test_a_rigid_turn_does_not_rub() -> None:
    """Two parallel strands turned by 0.4 rad as one; without the levers they slip at once."""
    assert rubbed(levers=True) < 0.05
    assert rubbed(levers=False) > 0.99


def test_friction_of_parallel_strands_keeps_the_angular_momentum() -> None:
    """Its torque is 0 to what presses, times the overlap; with forces at the centre lines it is not."""
    table, state, memory = pressed()
    state.x[0, 6:] += 1e-5  # one is drawn along the other
    x = state.x

    def torque() -> tuple[float, float]:
        force = np.zeros((6, x.shape[1]))
        pair_forces(x, np.zeros_like(x), table, memory, force, 0, x.shape[1])
        about = np.cross(x.T, force[3:].T).sum(axis=0)
        return float(np.linalg.norm(about)), float(np.abs(force[3, :6]).sum()) * D

    about, size = torque()
    assert size > 0.0
    assert about < 0.03 * size  # the strands overlap by 1 %
    memory.grip[:, LEVER:] = 0.0
    about, size = torque()
    assert about > 0.5 * size


def drum(friction: float, turns: float) -> Result:
    """1 kg on a cord that a turning drum winds up, layer upon layer in one plane."""
    cord = Material(EA=2e4, mass_per_length=0.1, axial_damping=50.0)
    reach = RADIUS + 0.5 * D
    rope = Rope(
        segments=107,
        length=1.6,
        diameter=D,
        made_of=cord,
        shape=Straight(start=(reach, 0, 0), end=(reach, 0, -1.6)),
        loads=[Load(node=-1, mass=1.0)],
    )
    hook = Orbit(center=(0, 0, 0), axis=(0, -1, 0), frequency=WINDS / (2 * math.pi))
    body = Cylinder(
        start=(0, 0.1, 0), end=(0, -0.1, 0), radius=RADIUS, friction=0.3, spin=Spin(rate=WINDS)
    )
    run = RunSettings(
        method="esdirk3", time_step=1 / 240, frame_rate=60, duration=turns * 2 * math.pi / WINDS
    )
    return simulate(
        Scene(
            ropes=[rope],
            anchors=[Anchor(node=0, motion=hook)],
            obstacles=[body],
            contact=Contact(friction=friction),
            run=run,
        )
    )


@pytest.mark.slow
def test_a_drum_winds_layers_on_itself() -> None:
    """The load rises with rate times the layer's radius, R + d/2 + k d, and no layer chokes those below.

    The weight is 10 N with the cord's own. A step up from layer to layer takes some 20 degrees.
    """
    result = drum(0.3, 2.9)
    time, height = result.time, result.positions[:, -1, 2]
    turn = WINDS * time / (2 * math.pi)
    for layer in range(3):
        inside = (turn > layer + 0.2) & (turn < layer + 0.85)
        speed = float(np.polyfit(time[inside], height[inside], 1)[0])
        assert speed == pytest.approx(WINDS * (RADIUS + (0.5 + layer) * D), rel=0.01)
    later = turn > 0.2
    assert result.tension[later].max() < 30.0
    assert np.abs(result.positions[:, :, 1]).max() == 0.0
