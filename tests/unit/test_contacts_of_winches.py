"""What a winch pays out touches obstacles like the rest of its rope: tables, wraps, figures."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest

import ropewalk as rw
from ropewalk import plots
from ropewalk.plots.contact_forces import coils
from ropewalk.record.result import Result
from ropewalk.scene import Anchor, Cylinder, Load, Material, Polyline, Rope, Scene, Winch

RADIUS, THICK = 0.1, 0.01


@pytest.fixture(scope="module")
def lowered() -> Result:
    """A load on a rope over a bar, 0.2 m from the drum at the start, let down by 0.4 m."""
    reach = (RADIUS + 0.5 * THICK) / math.cos(math.pi / 24.0)  # chords touch the bar
    angles = np.linspace(0.5 * math.pi, 0.0, 7)
    round_it = [(0.2 + reach * math.cos(a), 0.0, reach * math.sin(a)) for a in angles]
    points = [(0.0, 0.0, reach), *round_it, (0.2 + reach, 0.0, -0.15)]
    length = sum(math.dist(a, b) for a, b in pairwise(points))
    made_of = Material(EA=5e3, mass_per_length=0.1, axial_damping=10.0)
    rope = Rope(
        segments=14,
        length=length,
        diameter=THICK,
        made_of=made_of,
        shape=Polyline(points=points),
        loads=[Load(node=-1, mass=1.0)],
    )
    bar = Cylinder(name="bar", start=(0.2, -1, 0), end=(0.2, 1, 0), radius=RADIUS, friction=0.2)
    run = {"duration": 0.4, "time_step": 5e-3, "method": "implicit-euler", "frame_rate": 25}
    return rw.simulate(
        Scene(
            ropes=[rope],
            anchors=[Anchor(node=0)],
            winches=[Winch(end="start", speed=1.0)],
            obstacles=[bar],
            run=run,
        )
    )


def test_a_wrap_counts_what_has_been_paid_out(lowered: Result) -> None:
    """Only nodes that were off the drum at the start counted: no wrap, no tension before it."""
    touching = np.flatnonzero(np.linalg.norm(lowered.contact_force[-1], axis=1))
    numbers = touching - lowered.layout.ropes[0].spare_start
    assert numbers[0] < -1
    wrap = lowered.wrap("bar")
    assert list(wrap.nodes[-1]) == [numbers[0], numbers[-1]]
    assert list(wrap.touches) == [False] + [True] * 10  # it starts without a force
    assert wrap.angle[-1] == pytest.approx(0.5 * math.pi, abs=0.3)
    assert wrap.before[-1] == lowered.tension[-1, touching[0] - 1] > 1.0
    assert wrap.after[-1] == lowered.tension[-1, touching[-1]] > wrap.before[-1]
    table = lowered.to_pandas("wraps", times=[0.4])
    assert list(table["first node"]) == [numbers[0]]
    assert list(table["angle [rad]"]) == [wrap.angle[-1]]
    assert list(table["tension before [N]"]) == [wrap.before[-1]]


def test_a_wrap_of_nothing_is_no_node(lowered: Result) -> None:
    """Node -1 is one that a winch pays out."""
    far = Cylinder(name="far", start=(9, -1, 0), end=(9, 1, 0), radius=RADIUS)
    scene = lowered.scene
    bodies = [*scene.obstacles, far]
    result = rw.simulate(scene.replace(obstacles=bodies, run=scene.run.replace(duration=0.04)))
    wrap = result.wrap("far")
    assert not wrap.touches.any()
    assert (wrap.nodes == [0, -1]).all()


def test_figures_show_it(lowered: Result) -> None:
    (coil,) = coils(lowered, lowered.frames - 1)
    wrap = lowered.wrap("bar")
    assert coil.first == wrap.nodes[-1, 0]
    assert coil.angle == pytest.approx(wrap.angle[-1], rel=1e-12)
    assert [coil.tension[0], coil.tension[-1]] == [wrap.before[-1], wrap.after[-1]]
    image = plots.sticking(lowered).axes[0].images[0]
    low, high = image.get_extent()[2:]
    assert low < -1.5 < 14.0 < high
    last = np.asarray(image.get_array())[:, -1]
    shown = np.flatnonzero(last) + low + 0.5
    assert list(shown) == list(range(wrap.nodes[-1, 0], wrap.nodes[-1, 1] + 1))
