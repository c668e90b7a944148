"""Waves across a rope at rest, wave by wave."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.report.runs import Run, at_rest, changed, record, with_points


@dataclass(frozen=True)
class Ringing:
    """Out-of-plane waves of a rope between two pins that hangs at rest."""

    run: Run
    amplitude: Floats  # (f, modes) [m]
    rates: Floats  # (modes,) measured decay rates [1/s]


def ring(friction: float, duration: float, modes: int = 3, swing: float = 0.01) -> Ringing:
    """Let R3 ring sideways in its first modes and measure how fast each dies down.

    The rope starts in its rest shape, with a sideways sine of each mode; the decay rate is the
    slope of the logarithm of the mode's peaks.
    """
    scene, statics = at_rest(
        changed("r3", f"rope.made_of.spring_friction={friction}", f"duration={duration}")
    )
    points = statics.positions.copy()
    node = np.arange(len(points))
    shapes = np.array([np.sin(j * np.pi * node / node[-1]) for j in range(1, modes + 1)])
    points[:, 2] += swing * shapes.sum(axis=0)
    points[[0, -1], 2] = 0.0
    run = record(with_points(scene, points))
    amplitude = run.x[:, :, 2] @ shapes.T * (2.0 / node[-1])
    rates = np.array([_rate(run.time, amplitude[:, j]) for j in range(modes)])
    return Ringing(run, amplitude, rates)


def _rate(time: Floats, swing: Floats) -> float:
    """Decay rate of a swing from its peaks, as long as they stand out [1/s]."""
    size = np.abs(swing)
    peaks = np.flatnonzero((size[1:-1] >= size[:-2]) & (size[1:-1] > size[2:])) + 1
    peaks = peaks[size[peaks] > 0.02 * size[0]]
    if len(peaks) < 3:
        return float("nan")
    return float(-np.polyfit(time[peaks], np.log(size[peaks]), 1)[0])


def short_wave_share(v: Floats, first: int, last: int) -> float:
    """Share of the kinetic energy in the shorter half of the waves between two pins [1].

    `v` is (f, n, 3) [m/s]; sine transform over the free nodes from `first` to `last`.
    """
    part = v[:, first + 1 : last]
    count = part.shape[1]
    grid = np.outer(np.arange(1, count + 1), np.arange(1, count + 1))
    sines = np.sin(np.pi * grid / (count + 1))
    power = (np.einsum("jn,fnk->fjk", sines, part) ** 2).sum(axis=(0, 2))
    return float(power[count // 2 :].sum() / power.sum())
