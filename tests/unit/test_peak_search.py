"""The search for the farthest of what was kept, against one number after the other."""

from __future__ import annotations

import math

import numpy as np
import pytest

from ropewalk import Anchor, Rope, Scene, Simulation, Springs
from ropewalk.core.peaks import EXTREMES, PLACE, SINCE, UNTIL, VALUE
from ropewalk.methods.peak_search import search
from ropewalk.methods.peaks import root
from ropewalk.methods.scratch import LANES, SUMS

WHICH, SINCE_TIME, UNTIL_TIME = 3, 1.0, 2.0
LONG = SUMS * LANES


def one_by_one(values: np.ndarray, live: np.ndarray, sign: float, best: float) -> tuple[float, int]:
    """Return the farthest finite number beyond `best` and its first place; -1: there is none."""
    place = -1
    for j, value in enumerate(values):
        if live[j] and np.isfinite(value) and sign * value > sign * best:
            best, place = float(value), j
    return best, place


def some_numbers(size: int, seed: int) -> np.ndarray:
    """Numbers with ties, zeros of both signs and what is not finite among them."""
    rng = np.random.default_rng(seed)
    values = rng.integers(-4, 5, size) * rng.choice([0.25, 1.0, 3.0], size)
    odd = np.array([np.inf, -np.inf, np.nan, 0.0, -0.0])
    mixed = rng.random(size) < 0.2
    values[mixed] = rng.choice(odd, int(mixed.sum()))
    return np.asarray(values, dtype=np.float64)


@pytest.mark.parametrize(
    "size", [0, 1, 50, LANES, LANES + 1, LONG - 1, LONG, LONG + 1, 3 * LONG + 7]
)
def test_the_farthest_is_that_of_a_search_one_by_one(size: int) -> None:
    sums, found_any = np.full(LONG, 1e9), 0  # whatever was summed up there before
    for seed in range(12):
        values = some_numbers(size, seed)
        lengths, stiffness = np.full(size, 0.5), np.ones(size)
        dead = np.random.default_rng(seed + 100).random(size) < 0.3
        lengths[dead] = stiffness[dead] = 0.0
        for sign in (1.0, -1.0):
            for best in (-sign * np.inf, -sign * 20.0, 0.0, sign * 2.0, sign * 20.0):
                for segments in (True, False):
                    found = np.full((4, len(EXTREMES)), -7.0)
                    found[VALUE, WHICH] = best
                    real = (lengths, stiffness) if segments else (None, None)
                    times = SINCE_TIME, UNTIL_TIME
                    search(values, *real, sign, WHICH, found, *times, sums)
                    live = ~dead if segments else np.ones(size, dtype=bool)
                    value, place = one_by_one(values, live, sign, best)
                    told = (value, float(place), *times) if place >= 0 else (best, -7.0, -7.0, -7.0)
                    got = [found[row, WHICH] for row in (VALUE, PLACE, SINCE, UNTIL)]
                    assert got == list(told)
                    found_any += place >= 0
    assert found_any > 0 or size == 0


@pytest.mark.parametrize("method", ["semi-implicit-euler", "verlet", "sdirk2"])
@pytest.mark.parametrize("ropes", [1, 6])  # sdirk2: alone and abreast
def test_what_hands_change_between_calls_is_in_the_next_interval(method: str, ropes: int) -> None:
    springs = Springs(spring_constant=1e3, node_mass=0.05, segment_length=0.5)
    names = [f"rope{k}" for k in range(ropes)]
    step = 1e-3 if method == "sdirk2" else 1e-4
    scene = Scene(
        ropes=[Rope(name=name, segments=4, made_of=springs) for name in names],
        anchors=[Anchor(rope=name, node=0) for name in names],
        run={"duration": 1.0, "frame_rate": 1.0 / step, "time_step": step, "method": method},
    )
    simulation = Simulation(scene)
    simulation.advance_frames(3)
    simulation.arrays.v[:, 3] = 4.0, 3.0, 0.0
    simulation.arrays.x[2, 2] += 0.1
    x = simulation.arrays.x.copy()
    pull = 1e3 * (np.linalg.norm(x[:, 2] - x[:, 1]) - 0.5)  # at its most now: node 2 goes back
    first = simulation.advance_frames(2, keep_going=True).recording
    assert first.speed_high[0, 3] >= 5.0
    assert first.highest[0, 2] >= x[2, 2]
    assert first.tension_high[0, 1] >= pull * (1.0 - 1e-12) > 5.0
    assert first.speed_high[1, 3] >= np.linalg.norm(first.v[0, :, 3]) * (1.0 - 1e-12)


def test_a_greatest_square_of_nothing_has_no_root() -> None:
    """Of a rope that broke before a frame; compiled it gave NaN, uncompiled it refused."""
    assert math.isnan(root(-math.inf))
    assert math.isnan(root(math.nan))
    assert [root(0.0), root(4.0)] == [0.0, 2.0]
