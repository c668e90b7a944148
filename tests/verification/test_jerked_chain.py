"""A chain whose end is jerked: Schroedinger's Bessel functions, and how much too high it reads a jerk.

Closed forms 1.6.
"""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.special import jv

import ropewalk as rw
from ropewalk.scene import Straight

K, M, V, N = 1000.0, 0.01, 0.05, 24  # N/m, kg, m/s, segments
RATE = 2.0 * (K / M) ** 0.5  # 1/s
SHOCK = V * (K * M) ** 0.5  # v sqrt(EA mu) of the rope that the chain stands for [N]


def jerked(method: str, step: float) -> rw.Scene:
    """Straight springs at rest, the far end held; the near one goes off at V from time zero."""
    springs = rw.Springs(spring_constant=K, node_mass=M, segment_length=0.1)
    rope = rw.Rope(segments=N, made_of=springs, shape=Straight(end=(0.1 * N, 0, 0)))
    pull = rw.Anchor(name="pull", node=0, motion={"kind": "velocity", "velocity": (-V, 0, 0)})
    run = {"method": method, "time_step": step, "duration": 0.06, "frame_rate": 500.0}
    return rw.Scene(gravity=(0, 0, 0), ropes=[rope], anchors=[pull, rw.Anchor(node=-1)], run=run)


def bessel(segment: int, time: float) -> float:
    """Tension [N] of segment j from the jerked end: v sqrt(k m) int_0^{2 w t} (2j+1) J_{2j+1}(x)/x dx.

    Of a chain without an end, so until waves come back. Schroedinger 1914, Ann. Phys. 349:916.
    """
    order = 2 * segment + 1
    return SHOCK * quad(lambda x: order * jv(order, x) / x, 0.0, RATE * time, limit=200)[0]


@pytest.mark.parametrize(
    ("method", "step"), [("verlet", 5e-5), ("esdirk3", 1e-4), ("semi-implicit-euler", 5e-5)]
)
def test_a_jerked_chain(method: str, step: float) -> None:
    """Every segment at every frame, until the front has gone to the far end."""
    result = rw.simulate(jerked(method, step))
    frames = [i for i, t in enumerate(result.time) if t > 0.0 and 0.5 * RATE * t < N - 6]
    assert len(frames) > 20
    for i in frames:
        exact = np.array([bessel(j, result.time[i]) for j in range(N)])
        assert np.abs(result.tension[i] - exact).max() < 5e-4 * SHOCK


def test_a_jerk_reads_too_high_by_a_fixed_part_however_fine_the_chain() -> None:
    """1.09 of v sqrt(EA mu) at the end itself, and towards 1.27, the largest integral of Airy's function."""
    result = rw.simulate(jerked("verlet", 5e-5))
    first = quad(lambda x: jv(1, x) / x, 1e-12, 3.8317060)[0]
    assert result.greatest_tension[:, 0].max() == pytest.approx(first * SHOCK, rel=2e-3)
    assert result.table["largest tension [N]"] > 1.2 * SHOCK
