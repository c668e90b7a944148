"""Initial shapes: the slack curve has the rope's length and is an equilibrium in the limit."""

from __future__ import annotations

import math

import numpy as np
import pytest

from ropewalk.lowering import build
from ropewalk.scene import Hanging, Material, Polyline, Rope, Slack, Straight
from ropewalk.simulation import Simulation
from verification.setups import DOWN, forces_at, g, hold, off, scene

STUFF = Material(EA=1e7, mass_per_length=0.3)


def points(shape, n: int = 40, length: float = 10.0, gravity=DOWN) -> np.ndarray:
    rope = Rope(segments=n, length=length, made_of=STUFF, shape=shape)
    return build(scene(rope, hold(0), dt=1e-3, steps=1, gravity=gravity)).state.x.T


SPANS = [
    ((0, 0, 0), (8, 2, 0)),
    ((1, 2, 3), (4, 0, 6)),
    ((0, 0, 0), (9.9, 0, 0)),
    ((0, 1, 0), (0.01, -3, 0)),
]


@pytest.mark.parametrize(("start", "end"), SPANS)
def test_a_slack_curve_has_the_ropes_length(start, end) -> None:
    """Ends in place; nodes evenly spaced along the arc, so that the chords' sum tends to the length as
    N^-2 (a plumb loop has its fold between two nodes, at most one segment short).
    """
    missing = []
    for n in (100, 200):
        x = points(Slack(start=start, end=end), n)
        assert off(x[[0, -1]], [start, end]) < 1e-12
        chords = np.linalg.norm(np.diff(x, axis=0), axis=1)
        assert chords.max() <= 10.0 / n * (1 + 1e-9)
        missing.append(10.0 - chords.sum())
    plumb = end[0] == 0.01
    if plumb:
        assert missing[1] <= 10.0 / 200 + 1e-9
    else:
        assert missing[1] < 0.02
        assert math.log2(missing[0] / missing[1]) == pytest.approx(2.0, abs=0.1)
    straight = points(Straight(start=start, end=end), 200)  # the twin: no slack at all
    assert 10.0 - np.linalg.norm(np.diff(straight, axis=0), axis=1).sum() > 0.09


def test_a_slack_curve_is_the_catenary() -> None:
    """Closed forms 2.3, L 10, X 8, Y 2: a = 3.555186541 m, the lowest point 1.622676437 m below the
    first support; y = a cosh((x - x0) / a) + const at every node. The twin: the parabola through the
    same three points.
    """
    x = points(Slack(start=(0, 0, 0), end=(8, 2, 0)), 400)
    a = 3.555186541
    x0 = 4.0 - a * math.atanh(0.2)
    y = a * np.cosh((x[:, 0] - x0) / a)
    assert off(x[:, 1], y - y[0]) < 1e-8
    assert -x[:, 1].min() == pytest.approx(1.622676437, abs=2e-4)
    parabola = np.polyval(np.polyfit(x[[0, 200, 400], 0], x[[0, 200, 400], 1], 2), x[:, 0])
    assert off(x[:, 1], parabola) > 1e-2


def test_a_slack_curve_is_an_equilibrium_in_the_limit() -> None:
    """Tension w (y - y_low + a) along the tangents carries every node's weight: the force left on a
    node falls as N^-2 of its weight. A straight line under the same tensions leaves all of it.
    """

    def left(n: int) -> float:
        x = points(Slack(start=(0, 0, 0), end=(8, 2, 0)), n)
        d = np.diff(x, axis=0)
        a, w = 3.555186541, 0.3 * g
        middle = 0.5 * (x[1:, 1] + x[:-1, 1])
        T = w * (middle + 1.622676437 + a)
        pull = T[:, None] * d / np.linalg.norm(d, axis=1)[:, None]
        force = pull[1:] - pull[:-1] - np.array([0, w * 10.0 / n, 0])
        return float(np.abs(force).max() / (w * 10.0 / n))

    assert left(80) < 2e-3
    assert math.log2(left(40) / left(80)) == pytest.approx(2.0, abs=0.2)
    assert left(40) < 0.1 * 1.0


def test_slack_follows_gravity() -> None:
    """It hangs along gravity, whatever its direction; without gravity along -z."""
    for gravity in ((0, 0, -g), (3.0, 0, 0), (0, 0, 0)):
        x = points(Slack(start=(0, 0, 0), end=(0, 6, 0)), 20, gravity=gravity)
        way = (
            np.array(gravity) / np.linalg.norm(gravity) if any(gravity) else np.array([0, 0, -1.0])
        )
        sag = x[10] - np.array([0, 3.0, 0])
        assert sag @ way == pytest.approx(np.linalg.norm(sag), rel=1e-9)
        assert sag @ way > 2.0


def test_straight_hanging_and_polyline() -> None:
    """At rest length no segment has any force; polyline nodes are even along the corners' path."""
    for shape in (Straight(start=(1, 1, 1), direction=(1, 2, 2)), Hanging(start=(0, 3, 0))):
        rope = Rope(segments=30, length=10.0, made_of=STUFF, shape=shape)
        simulation = Simulation(scene(rope, dt=1e-6, steps=1))
        x = simulation.positions.copy()
        assert off(forces_at(simulation, x), 0.0) < 1e-6  # EA times rounding, 1e7 x 1e-14
        assert off(forces_at(simulation, 1.001 * x), 0.0) > 1e3
    hanging = points(Hanging(start=(0, 3, 0)), 10)
    assert off(hanging[:, 1], 3.0 - np.arange(11)) < 1e-12
    corners = [(0, 0, 0), (3, 0, 0), (3, 7, 0)]
    x = points(Polyline(points=corners), 10)
    assert off(x[:4, 0], [0, 1, 2, 3]) < 1e-12
    assert off(x[3:, 1], np.arange(8)) < 1e-12
