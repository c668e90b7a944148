"""Random trolleys on random lines: they end, their books close, friction only takes."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.laws.slides.slide_force import bound_of, rate_of, slide_energy
from ropewalk.laws.slides.table import PER_PLACE
from ropewalk.scene import Slack, Straight

g = 9.81
METHODS = ("sdirk2", 2e-3), ("esdirk3", 2e-3), ("bdf2", 1e-3)


def scene(seed: int) -> rw.Scene:
    """One or two trolleys on 5 to 100 m of line, some with contact, a winch, air, friction, brakes."""
    draw = np.random.default_rng(seed)
    span, EA = 10.0 ** draw.uniform(math.log10(5.0), 2.0), 10.0 ** draw.uniform(4.0, 7.0)
    mass = min(draw.uniform(0.001, 0.01) * EA / g, 100.0)
    drop, slack = draw.uniform(-0.1, 0.2) * span, draw.uniform(1.002, 1.05)
    length = math.hypot(span, drop) * slack
    stuff = {"EA": EA, "mass_per_length": 0.02 + 3e-8 * EA, "axial_damping": 1e-4 * EA * span}
    line = rw.Rope(
        name="line",
        segments=int(draw.integers(8, 30)),
        length=length,
        diameter=0.01,
        made_of=rw.Material(**stuff),
        shape=Slack(start=(0, 0, 0), end=(span, 0, -drop)),
    )
    rubs = {
        "brake": draw.choice([0.0, 0.02, 0.1]) * mass * g,
        "friction": draw.choice([0.0, 0.02, 0.1]),
    }
    riders, slides = [], []
    for i in range(int(draw.integers(1, 3))):
        rider = rw.Rope(
            name=f"rider{i}",
            segments=2,
            length=0.6,
            diameter=0.02,
            made_of=rw.Material(EA=3e4, mass_per_length=0.1, axial_damping=50.0),
            shape=Straight(end=(0, 0, -0.6)),
            loads=[rw.Load(node=0, mass=0.1 * mass), rw.Load(node=-1, mass=mass)],
        )
        riders.append(rider)
        slides.append(
            rw.Slide(name=f"slide{i}", rope=rider.name, at=(0.3 + 0.4 * i) * length, **rubs)
        )
    more: dict[str, Any] = {}
    if draw.random() < 0.4:
        more["contact"] = rw.Contact(friction=0.2)
    if draw.random() < 0.3:
        speed = draw.choice([-0.2, 0.2])
        end = "start" if seed % 2 else "end"
        more["winches"] = [rw.Winch(rope="line", end=end, speed=speed)]
    if draw.random() < 0.3:
        more["air"] = {"density": 1.2}
    method, step = METHODS[seed % len(METHODS)]
    return rw.Scene(
        ropes=[line, *riders],
        anchors=[rw.Anchor(rope="line", node=node) for node in (0, -1)],
        slides=slides,
        run={"method": method, "time_step": step, "duration": 1.0, "frame_rate": 50.0},
        **more,
    )


def rubbed_at_most(simulation: rw.Simulation, until: float) -> float:
    """What the force that friction and brake may have would take on the way past the line [J]."""
    state, table, total = simulation.arrays, simulation.system.node.slide, 0.0
    memory, before = state.memory.slide, 0.0
    while simulation.time < until - 1e-9:
        start = simulation.time
        simulation.advance_steps(1)
        slide_energy(state.x, table, memory)  # which looks where they are
        now = sum(
            bound_of(table, memory.sight, row)
            * abs(rate_of(state.v, memory, row) * memory.sight[row, PER_PLACE])
            for row in range(table.node.size)
        )
        total += 0.5 * (before + now) * (simulation.time - start)
        before = now
    return total


@pytest.mark.slow
@pytest.mark.parametrize("seed", [*range(9), 27])  # 5, 27: contact, and a winch at the start
def test_a_random_trolley_keeps_its_books(seed: int) -> None:
    given = scene(seed)
    result = rw.simulate(given)
    assert result.status == "finished"
    turned = float(np.ptp(result.energy["kinetic"]) + np.ptp(result.energy["total"]))
    assert turned > 1.0
    assert result.table["largest balance residual [J]"] < 1e-12 * turned
    assert result.table["largest energy error [J]"] < 0.02 * turned
    assert result.work["slide"].max() < 1e-6 * turned
    simulation = rw.Simulation(given)
    most = rubbed_at_most(simulation, 1.0)
    state, table = simulation.arrays, simulation.system.node.slide
    stored = slide_energy(state.x, table, state.memory.slide)
    taken = -float(state.work.node.slide.sum())
    if table.friction.any() or table.brake.any():
        # 1.3 % above are seen, as the load shakes within steps; below is what sticks
        assert 0.75 * most < taken - stored < 1.03 * most
    else:  # it has what it took, but for what the method loses
        assert taken == pytest.approx(stored, abs=0.02 * turned)
