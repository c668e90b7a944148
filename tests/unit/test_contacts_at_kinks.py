"""What the table of contacts tells where a surface begins to move: force and slip are of one time."""

from __future__ import annotations

import math

import pytest

import ropewalk as rw
from ropewalk.scene import Plane, Points, Velocity

g = 9.81


@pytest.mark.parametrize("method", ["verlet", "bdf2", "esdirk3", "implicit-euler", "adaptive"])
@pytest.mark.parametrize("later", [0.0, -0.7])
def test_where_a_surface_begins_to_move_force_and_slip_are_of_one_time(
    method: str, later: float
) -> None:
    """A slope that starts downhill at 0.5 m/s under a rope at rest, at a frame or a part of a step before it.

    Up to there the rope lies still and friction holds it: with the slip after the start it gave power. What
    implicit Euler has are means over the part of the step since the start, not over all of it.
    """
    steps = {} if method in ("verlet", "adaptive") else {"time_step": 1 / 60}
    c, s = math.cos(0.1), math.sin(0.1)
    scene = rw.Scene(
        ropes=[
            rw.Rope(
                segments=4,
                length=0.2,
                made_of=rw.Material(EA=1e3, mass_per_length=0.1, axial_damping=1.0),
                shape=Points(points=[(0.05 * i * c, 0, -0.05 * i * s) for i in range(5)]),
            )
        ],
        obstacles=[
            Plane(
                normal=(s, 0, c),
                motion=Velocity(velocity=(0.5 * c, 0, -0.5 * s), start=(15 + later) / 60),
            )
        ],
        run={"duration": 0.3, "frame_rate": 60, "method": method, "start": "at-rest", **steps},
    )
    table = rw.simulate(scene).to_pandas("contacts", times=[0.25])
    slip = table["slip speed [m/s]"].to_numpy()
    if later == 0.0:
        assert set(table["mode"]) == {"sticks"}
        assert slip == pytest.approx(0.0, abs=1e-6)
    else:  # it gains mu g cos and g sin, both downhill
        gain = g * (0.3 * c + s) * 0.7 / 60
        assert set(table["mode"]) == {"slips"}
        assert slip == pytest.approx(0.5 - gain, rel=0.03)
    assert table["friction power [W]"].max() < 1e-6
