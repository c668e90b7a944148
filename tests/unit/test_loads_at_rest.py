"""The table of an equilibrium tells the largest force on an obstacle and on an axle: all that hangs on it."""

from __future__ import annotations

import pytest

import ropewalk as rw
from ropewalk.scene import loads

OVER_A_BAR = """
[run]
method = "esdirk3"
time_step = 0.004
[[rope]]
segments = 40
length = 1.0
diameter = 0.004
made_of = {{ kind = "material", EA = 1e4, mass_per_length = 0.05 }}
loads = [{{ node = 0, mass = 1.0 }}, {{ node = 40, mass = 1.1 }}]
[rope.shape]
kind = "polyline"
points = [[-0.053, 0, -0.394], [-0.053, 0, 0.053], [0.053, 0, 0.053], [0.053, 0, -0.394]]
[[obstacle]]
name = "bar"
kind = "cylinder"
from = [0, -0.1, 0]
to = [0, 0.1, 0]
radius = 0.05
friction = 0.4
{spin}
"""


@pytest.mark.parametrize(
    ("spin", "title", "place"),
    [
        ("", "largest force on an obstacle", "obstacle 'bar'"),
        (
            "spin = { free = true, inertia = 1e-4, bearing = 0.5 }",
            "largest load on the axle of a pulley",
            "pulley 'bar'; its own weight is not in it",
        ),
    ],
)
def test_what_hangs_over_a_bar_is_its_load(spin: str, title: str, place: str) -> None:
    rest = rw.equilibrium(loads(OVER_A_BAR.format(spin=spin)))
    weight = 9.81 * (1.0 * 0.05 + 1.0 + 1.1)
    assert rest.table[f"{title} [N]"] == pytest.approx(weight, rel=1e-6)
    assert rest.table[f"{title} at"] == place


def test_what_nothing_presses_has_no_row() -> None:
    text = OVER_A_BAR.replace("0.1, 0]", "0.1, -2]").format(spin="")
    scene = loads(text + "\n[[anchor]]\nnode = 20\n")
    assert not [key for key in rw.equilibrium(scene).table if "force on an obstacle" in key]
