"""How far off `adaptive` is where ropes hit ropes: what its page tells a user to reckon with.

Two links that cross in their middles are one body in one dimension: of their reduced mass, on the spring, the
damper and the drag of their contact, which there is from REACH on.
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from ropewalk.core.arrays import Floats
from ropewalk.laws.pairs.brake import CLOSEST, OF_ROOM, SHARPER, SOFT
from ropewalk.laws.pairs.force import squeeze
from ropewalk.laws.pairs.table import DEEPEST, HARD, LAYER, REACH
from ropewalk.scene import Contact, Material, Rope, RunSettings, Scene, Straight
from ropewalk.simulation import Simulation
from verification.setups import NO_GRAVITY

THICK, LINK, GAP, AFTER = 0.01, 0.01, 0.005, 0.03  # m, kg, m, s
FRAMES = 20
TOLERANCES = (1e-4, 1e-6)  # [m]


def crossing(speed: float, tolerance: float) -> Simulation:
    """A link that flies at another one, which is free as well."""
    x, y, z = np.array((0.1, 0, 0)), np.array((0, GAP + THICK, 0)), np.array((0, 0, 0.1))
    ropes = [
        Rope(
            name=name, segments=1, length=0.2, diameter=THICK,
            made_of=Material(EA=1e4, mass_per_length=LINK / 0.2),
            shape=Straight(start=tuple(start), end=tuple(end), velocity=(0, -fast, 0)),
        )
        for name, start, end, fast in (("still", -x, x, 0.0), ("flies", y - z, y + z, speed))
    ]  # fmt: skip
    time = GAP / speed + AFTER
    run = RunSettings(
        method="adaptive", tolerance=tolerance, duration=time, frame_rate=FRAMES / time
    )
    contact = Contact(friction=0.0)
    return Simulation(Scene(ropes=ropes, contact=contact, gravity=NO_GRAVITY, run=run))


def closed_form(simulation: Simulation, speed: float, times: Floats) -> Floats:
    """The gap and how fast it grows (t, 2)."""
    table, mass = simulation.system.node.contact, 0.5 * LINK
    i, j = np.flatnonzero(table.rope >= 0)
    soft, hard, stop = (1.0 / (one[i] + one[j]) for one in (table.soft, table.hard, table.stop))
    light = table.mass[i] * table.mass[j] / (table.mass[i] + table.mass[j])

    def rates(_: float, state: Floats) -> list[float]:
        gap, rate = state
        if gap >= (REACH - 1.0) * THICK:
            return [rate, 0.0]
        depth = max(-gap, 0.0)
        force = squeeze(-gap, soft, hard, stop, LAYER * THICK)[0]
        stiff = min(max(soft, force / depth if depth > 0.0 else soft), max(soft, hard))
        drag = 2.0 * math.sqrt(light) * max(math.sqrt(soft), HARD * math.sqrt(stiff))
        if rate < 0.0:
            room = OF_ROOM * (gap + (1.0 - DEEPEST) * THICK)
            within = min(SOFT * THICK, max(room, CLOSEST * THICK)) / SHARPER
            drag = max(drag, -mass * rate / within * min(depth / (LAYER * THICK), 1.0))
        return [rate, max(0.0, force - drag * rate) / mass]

    found = solve_ivp(
        rates,
        (0.0, times[-1]),
        [GAP, -speed],
        "LSODA",
        times,
        rtol=1e-10,
        atol=1e-13,
        max_step=2e-5,
    )
    gaps: Floats = found.y.T
    return gaps


@pytest.mark.parametrize(
    ("speed", "off"), [(0.02, 0.02), (0.1, 0.004), (0.3, 0.004), (1.0, 0.01), (5.0, 0.005)]
)
def test_speeds_after_a_hit_are_off_by_what_the_page_says(speed: float, off: float) -> None:
    """Of that with which they hit, at any tolerance; and momentum is kept.

    Where no step ended at the touch it was 0.05 of 0.02 m/s, 0.07 of 0.1 and 0.004 of 0.3.
    """
    for tolerance in TOLERANCES:
        simulation = crossing(speed, tolerance)
        film = simulation.advance_frames(FRAMES)
        expected = closed_form(simulation, speed, film.time)
        v = film.recording.v[:, 1]
        rate = v[:, 2:].mean(axis=1) - v[:, :2].mean(axis=1)
        assert abs(rate[-1] - expected[-1, 1]) < off * speed
        assert v.mean(axis=1) == pytest.approx(-0.5 * speed, rel=1e-9)
        assert 0.0 < expected[-1, 1] < 0.07 * speed
        assert 0.0 < rate[-1] < 0.07 * speed


@pytest.mark.parametrize("speed", [0.02, 0.1, 0.3])
def test_steps_end_where_links_begin_to_touch(speed: float) -> None:
    """A tenth of the tolerance and more off [m]; where none did 0.02 to 0.2 mm, at any tolerance."""
    for tolerance, off in zip(TOLERANCES, (2e-5, 6e-6), strict=True):
        simulation = crossing(speed, tolerance)
        film = simulation.advance_frames(FRAMES)
        x = film.recording.x[:, 1]
        gap = x[:, 2:].mean(axis=1) - x[:, :2].mean(axis=1) - THICK
        expected = closed_form(simulation, speed, film.time)[:, 0]
        assert np.abs(gap - expected).max() < off
        counts = simulation.step_counts
        assert counts["rejected"] < 0.7 * counts["accepted"]
