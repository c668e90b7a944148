"""A rope drawn just touching starts alike wherever it is: rounding does not tell whether it touches."""

from __future__ import annotations

import math

import numpy as np

import ropewalk as rw
from ropewalk.scene import (
    Capsule,
    Load,
    Material,
    Points,
    Rope,
    RunSettings,
    Scene,
    Spin,
)

RADIUS = 0.055  # m, of the rope's middle on the wheel
AXLE = np.array([0.0, 1.0, 0.0])


def hung(shift: tuple[float, float, float]) -> Scene:
    """Two weights on a rope over a wheel, its nodes on a circle, let go at once; all moved by a way [m]."""
    angle = np.linspace(math.pi, 0.0, 25)
    over = RADIUS * np.stack((np.cos(angle), 0.0 * angle, np.sin(angle)), axis=1)
    chord = 2.0 * RADIUS * math.sin(math.pi / 48)
    low = chord * np.arange(1, 21)[:, None] * (0.0, 0.0, -1.0)
    points = np.concatenate([(over[0] + low)[::-1], over, over[-1] + low]) + shift
    count = len(points) - 1
    rope = Rope(
        segments=count,
        length=count * chord,
        diameter=0.01,
        made_of=Material(EA=2e5, mass_per_length=1e-3, axial_damping=20.0),
        shape=Points(points=[tuple(map(float, point)) for point in points]),
        loads=[Load(node=0, mass=1.0), Load(node=-1, mass=1.3)],
    )
    wheel = Capsule(
        name="wheel",
        start=tuple(map(float, shift - AXLE)),
        end=tuple(map(float, shift + AXLE)),
        radius=0.05,
        friction=0.3,
        compliance=1e-6,
        spin=Spin(free=True, inertia=2e-3, bearing=0.01),
    )
    run = RunSettings(duration=1 / 60, frame_rate=60.0, method="esdirk3", time_step=1 / 240)
    return Scene(ropes=[rope], obstacles=[wheel], run=run)


def test_weights_let_go_over_a_wheel_turn_it_alike_wherever_it_stands() -> None:
    """It turned at 0.2863 rad/s after 1/60 s as drawn, and at 0.2820 when moved by 3 m."""
    speeds = [
        float(rw.simulate(hung(shift)).pulley("wheel").speed[-1])
        for shift in ((0.0, 0.0, 0.0), (3.0, 0.0, 0.0), (0.0, 3.0, 0.0), (3.0, -2.0, 5.0))
    ]
    assert np.ptp(speeds) < 1e-6
    assert speeds[0] > 0.2
