"""A taut string swings faster the wider it swings: its stretch raises its tension."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.special import ellipk

from verification.setups import along_x, chain, hold, run, scene, springs

LENGTH, MU, T = 1.0, 0.02, 50.0  # m, kg/m, N: closed forms 3.1, period 0.04 s


def swing(amplitude: float, EA: float = 5000.0, n: int = 50) -> float:
    """Frequency [rad/s] of the first planar mode of n springs, over three periods.

    Velocity Verlet at half its bound: its phase error, (w dt)^2 / 24, is 1e-6 and drops out of ratios.
    """
    piece = LENGTH / n
    rest = piece / (1 + T / EA)
    k, m = EA / rest, MU * piece
    i = np.arange(n + 1)
    shape = np.sin(math.pi * i / n)
    points = along_x(piece * i)
    points[:, 1] = amplitude * shape
    dt = 0.5 * math.sqrt(m / k)
    steps = int(3.1 * 0.04 / dt)
    film = run(
        scene(chain(points, springs(k, m, rest)), hold(0, n), dt=dt, steps=steps, method="verlet")
    )
    q = film.x[:, :, 1] @ shape * 2 / n
    down = np.flatnonzero((q[:-1] > 0) & (q[1:] <= 0))
    times = film.t[down] + dt * q[down] / (q[down] - q[down + 1])
    return float(2 * math.pi / np.diff(times).mean())


def duffing(amplitude: float, EA: float) -> float:
    """q'' + w^2 q + (pi/L)^4 EA q^3 / (4 mu) = 0, the single mode of a uniform tension: exact, by the
    complete elliptic integral (Nayfeh & Mook, Nonlinear Oscillations, 2.3 and 7.5).
    """
    w2 = (math.pi / LENGTH) ** 2 * T / MU
    cubic = (math.pi / LENGTH) ** 4 * EA / (4 * MU) * amplitude**2
    total = w2 + cubic
    return float(2 * math.pi * math.sqrt(total) / (4 * ellipk(cubic / (2 * total))))


@pytest.mark.parametrize(("EA", "widest"), [(5000.0, 0.02), (20000.0, 0.01), (80000.0, 0.005)])
def test_the_amplitude_shift_of_a_taut_string(EA: float, widest: float) -> None:
    """f = f1 (1 + (3 pi^2 / 32) (a/L)^2 EA / T + ...) (closed forms 3.1), the rest of the series from
    the exact solution. The one mode neglects that the tension takes a time to even out, T / EA of the
    shift, and the chain has (pi/n)^2 / 4 of its own.
    """
    line = math.pi / LENGTH * math.sqrt(T / MU)
    small = swing(1e-6, EA)
    for amplitude in (0.25 * widest, 0.5 * widest, widest):
        shift = swing(amplitude, EA) / small - 1
        expected = duffing(amplitude, EA) / line - 1
        assert shift == pytest.approx(expected, rel=T / EA + 0.25 * (math.pi / 50) ** 2)
        leading = 3 * math.pi**2 / 32 * (amplitude / LENGTH) ** 2 * EA / T
        assert shift == pytest.approx(leading, rel=T / EA + leading)
        # twins: half the stiffness, and the shift of a whirl, 4/3 as large
        assert abs(shift / (duffing(amplitude, 0.5 * EA) / line - 1) - 1) > 0.5
        assert abs(shift / (4 / 3 * expected) - 1) > 0.2


def test_the_published_periods() -> None:
    """0.03963522129 s at a = 0.01 and 0.03860080693 s at 0.02 (closed forms 3.1), EA 5000 N: the shift
    to 1 % (T / EA). The twin is the period of small swings, 0.04 s.
    """
    small = swing(1e-6)
    for amplitude, period in ((0.01, 0.03963522129), (0.02, 0.03860080693)):
        assert 2 * math.pi / duffing(amplitude, 5000.0) == pytest.approx(period, rel=1e-9)
        found = 0.04 * small / swing(amplitude)
        assert found - 0.04 == pytest.approx(period - 0.04, rel=0.01)
        assert abs(found / 0.04 - 1) > 5e-3
