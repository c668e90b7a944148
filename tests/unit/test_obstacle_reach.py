"""What is out of reach presses nothing, and what is near is looked at."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from ropewalk.core.band import make_band
from ropewalk.laws.contact import contact_forces
from ropewalk.laws.contact_frame import DAMP, find_gaps
from ropewalk.laws.contact_tangent import contact_tangent
from ropewalk.laws.obstacle_reach import RUN, is_out_of_reach
from ropewalk.lowering import build
from ropewalk.scene import (
    Box,
    Capsule,
    Cylinder,
    Material,
    Plane,
    Rope,
    Scene,
    Sphere,
    Straight,
    Torus,
)

SHAPES: dict[str, Any] = {
    "plane": Plane(normal=(0.0, 0.6, 0.8)),
    "sphere": Sphere(center=(0.1, 0.0, 0.0), radius=0.3),
    "cylinder": Cylinder(start=(0, -0.2, 0), end=(0.1, 0.2, 0), radius=0.1),
    "capsule": Capsule(start=(0, -0.2, 0), end=(0.1, 0.2, 0), radius=0.1),
    "box": Box(center=(0, 0, 0), half_sizes=(0.3, 0.2, 0.4), edge_radius=0.02),
    "torus": Torus(center=(0, 0, 0), axis=(0, 0.6, 0.8), radius=0.3, bar_radius=0.05),
}


def rope_beside(body: Any, segments: int = 8) -> Any:
    """A rope of so many segments of 5 cm and an obstacle."""
    rope = Rope(
        segments=segments,
        length=0.05 * segments,
        diameter=0.01,
        made_of=Material(EA=1e4, mass_per_length=0.1),
        shape=Straight(direction=(1, 0, 0)),
    )
    return build(Scene(ropes=[rope], obstacles=[body]), drawn=False)


@pytest.mark.parametrize("name", list(SHAPES))
def test_what_is_out_of_reach_presses_nothing(name: str) -> None:
    """At random places and speeds, asked node by node; and it is found to be so of half of what is far."""
    rng, model = np.random.default_rng(0), rope_beside(SHAPES[name])
    table, memory, now = model.system.node.obstacle, model.state.memory.obstacle, np.zeros(2)
    grip, far, skipped, pressed = memory.grip[0], 0, 0, 0
    for _ in range(300):
        middle = rng.uniform(-1.0, 1.0, 3) * 10.0 ** rng.uniform(-1.0, 1.5)
        x = middle[:, None] + 10.0 ** rng.uniform(-3.0, 0.0) * rng.normal(size=(3, 9))
        v = 10.0 ** rng.uniform(-2.0, 2.0) * rng.normal(size=(3, 9))
        force = np.zeros((9, 9))
        contact_forces(x, v, table, memory, now, force, 0, 9)
        still = (0.0, 0.0, 0.0)
        off = is_out_of_reach(x, v, table, grip, 0, (1.0, 0.0), still, still, still, 0, 9)
        gaps = np.zeros((1, 9))
        find_gaps(x, table, 0.0, gaps)
        most = grip[DAMP] * np.linalg.norm(v, axis=0) - table.stiffness[0] * (
            gaps - table.thickness
        )
        skipped += off
        far += bool(gaps.min() > 2.0 and most.max() < 0.0)
        pressed += bool(np.any(force))
        assert not (off and (np.any(force) or most.max() > 0.0))
    assert pressed > 10
    assert skipped > 0.5 * far > 10


@pytest.mark.parametrize("name", list(SHAPES))
def test_so_it_is_of_what_moves_and_turns(name: str) -> None:
    """By every node's velocity over the surface, as fast as that is; the twin: beside one that stands."""
    rng, model = np.random.default_rng(1), rope_beside(SHAPES[name])
    table, memory = model.system.node.obstacle, model.state.memory.obstacle
    grip, skipped, wrong = memory.grip[0], 0, 0
    for _ in range(1000):
        middle = rng.uniform(-1.0, 1.0, 3) * 10.0 ** rng.uniform(-1.0, 1.5)
        x = middle[:, None] + 10.0 ** rng.uniform(-3.0, 0.0) * rng.normal(size=(3, 9))
        v = 10.0 ** rng.uniform(-2.0, 1.0) * rng.normal(size=(3, 9))
        moved, speed, turning = 10.0 ** rng.uniform(-1.0, 3.0, (3, 1)) * rng.normal(size=(3, 3))
        off = is_out_of_reach(x, v, table, grip, 0, (1.0, 0.0), moved, speed, turning, 0, 9)
        arm = (x - moved[:, None]).T - table.hub[0]
        over = v.T - speed - np.cross(turning, arm)
        gaps = np.zeros((1, 9))
        find_gaps(np.ascontiguousarray(x - moved[:, None]), table, 0.0, gaps)
        room = table.stiffness[0] * (gaps - table.thickness)
        skipped += off
        assert not (off and (grip[DAMP] * np.linalg.norm(over, axis=1) - room).max() > 0.0)
        still = np.zeros(3)
        there = is_out_of_reach(x, v, table, grip, 0, (1.0, 0.0), moved, still, still, 0, 9)
        wrong += there and (grip[DAMP] * np.linalg.norm(over, axis=1) - room).max() > 0.0
    assert skipped > 30
    assert wrong > 0


def test_a_rope_whose_one_end_touches_is_looked_at() -> None:
    """However far its middle is."""
    model = rope_beside(Plane())
    table, memory = model.system.node.obstacle, model.state.memory.obstacle
    x = np.zeros((3, 9))
    x[2] = np.abs(np.linspace(-100.0, 100.0, 9)) - 1e-3
    x[2, 0] = 4e-3  # a millimetre deep
    force = np.zeros((3, 9))
    contact_forces(x, np.zeros((3, 9)), table, memory, np.zeros(2), force, 0, 9)
    assert force[2, 0] > 0.0


@pytest.mark.parametrize("name", list(SHAPES))
def test_a_long_rope_is_pressed_as_its_nodes_are_one_by_one(name: str) -> None:
    """And forces change where nodes are pressed, and nowhere else. Some runs are out of reach, others not."""
    rng, n = np.random.default_rng(2), 8 * RUN + 5
    model = rope_beside(SHAPES[name], n - 1)
    table, memory = model.system.node.obstacle, model.state.memory.obstacle
    grip, now, still = memory.grip[0], np.zeros(2), (0.0, 0.0, 0.0)
    band, pressed, out, where = make_band(n), 0, 0, set[int]()
    for _ in range(100):
        along = np.linspace(-1.0, 1.0, n) * rng.uniform(1.0, 5.0)
        x = 0.2 * rng.normal(size=3)[:, None] + np.outer(rng.normal(size=3), along)
        v = 10.0 ** rng.uniform(-2.0, 1.0) * rng.normal(size=(3, n))
        force, alone = np.zeros((9, n)), np.zeros((9, n))
        contact_forces(x, v, table, memory, now, force, 0, n)
        for i in range(n):
            contact_forces(x, v, table, memory, now, alone, i, i + 1)
        assert np.array_equal(force, alone)
        band.diagonal[:] = 0.0
        contact_tangent(x, v, table, memory, now, 1.0, 60.0, band)
        assert np.array_equal(band.diagonal.any(axis=1), force.any(axis=0))
        runs = [(lo, min(lo + RUN, n)) for lo in range(0, n, RUN)]
        away = [
            is_out_of_reach(x, v, table, grip, 0, (1.0, 0.0), still, still, still, *run)
            for run in runs
        ]
        pressed, out = pressed + bool(force.any()), out + (0 < sum(away) < len(away))
        where |= set(np.flatnonzero(force.any(axis=0)) % RUN)
    assert pressed > 20
    assert out > 20
    assert where == set(range(RUN))
