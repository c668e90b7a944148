"""Rigid links in steps of varying length: against exact motions, with tensions of each frame's instant."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Any

import numpy as np
import pytest

from ropewalk.scene import Anchor, RunSettings, Scene, Shake, Velocity
from verification.setups import Film, chain, g, run, springs
from verification.test_rigid_links import double_pendulum, lengths_error

TOLERANCES = (1e-4, 1e-5, 1e-6, 1e-7)
MASS = 0.2  # of every node [kg]
ACROSS, DOWN = np.array([1.0, 0.0, 0.0]), np.array([0.0, -1.0, 0.0])


def links(
    count: int, length: float, tolerance: float, along: np.ndarray = ACROSS, **more: Any
) -> Scene:
    """Links of `length` [m] in a straight line from a held node; y is up."""
    settings = RunSettings(
        duration=more.pop("duration", 1.2),
        frame_rate=100.0,
        method="adaptive",
        tolerance=tolerance,
    )
    points = length * np.arange(count + 1)[:, None] * along
    rope = chain(points, springs(math.inf, MASS, length))
    return Scene(ropes=rope, anchors=Anchor(node=0, **more), gravity=(0.0, -g, 0.0), run=settings)


def pendulum(tolerance: float) -> Film:
    return run(links(1, 0.7, tolerance))


def test_a_pendulum_obeys_its_exact_relations_at_every_frame() -> None:
    """Let go from the horizontal it has v^2 = 2 g h and pulls with 3 m g h / L, h the fall so far: place,
    speed, tension and reaction go to that with the tolerance, and the length holds to rounding.
    """
    places, pulls = [], []
    for tolerance in TOLERANCES:
        film = pendulum(tolerance)
        x, v = film.x[:, 1], film.v[:, 1]
        fallen = -x[:, 1]
        assert lengths_error(film.x, 0.7) < 1e-13
        places.append(np.abs((v**2).sum(axis=1) - 2.0 * g * fallen).max() / (2.0 * g * 0.7))
        exact = 3.0 * MASS * g * fallen / 0.7
        tension = film.block.recording.tension[:, 0]
        pulls.append(np.abs(tension - exact).max() / (3.0 * MASS * g))
        pull = tension[:, None] * x / 0.7  # on the held node
        force = film.block.recording.reaction[:, 0] + np.array([0.0, -MASS * g, 0.0])
        assert np.abs(force + pull).max() < 1e-9
    for errors in (places, pulls):
        assert all(fine < 0.5 * coarse for coarse, fine in pairwise(errors))
    assert places[-1] < 1e-4
    assert pulls[-1] < 1e-4


def test_a_double_pendulum() -> None:
    """The places of scipy's solution in the angles, with the tolerance. Twin: links of 0.501 m."""
    exact = double_pendulum(1.2)
    errors = []
    for tolerance in TOLERANCES:
        film = run(links(2, 0.5, tolerance))
        errors.append(float(np.abs(film.x[-1, 1:] - exact).max()))
    assert all(fine < 0.5 * coarse for coarse, fine in pairwise(errors))
    assert errors[-1] < 1e-4
    assert np.abs(run(links(2, 0.501, 1e-7)).x[-1, 1:] - exact).max() > 1e-3


@pytest.mark.parametrize("what", ["shaken", "started"])
def test_a_string_below_an_anchor_that_moves_up_and_down(what: str) -> None:
    """It hangs straight down and pulls with m (g + a) for each mass below, a the anchor's acceleration at
    that instant; with no acceleration where a motion starts or stops, which is an impulse.
    """
    motion: Any = Velocity(velocity=(0.0, 0.5, 0.0), start=0.0505, stop=0.5)
    if what == "shaken":
        motion = Shake(axis=(0.0, 1.0, 0.0), amplitude=0.01, frequency=3.0)
    made = links(3, 0.2, 1e-6, DOWN, motion=motion, duration=0.6)
    film = run(made)
    rate = 2.0 * math.pi * 3.0
    a = -0.01 * rate**2 * np.sin(rate * film.t) if what == "shaken" else np.zeros_like(film.t)
    below = MASS * np.array([3.0, 2.0, 1.0])
    exact = below * (g + a[:, None])
    assert np.abs(film.block.recording.tension - exact).max() < 1e-4 * below[0] * g
    whole = 4.0 * MASS * (g + a)
    assert np.abs(film.block.recording.reaction[1:, 0, 1] - whole[1:]).max() < 1e-4 * whole[0]
    if what == "shaken":
        assert np.abs(a).max() > 0.3 * g  # the twin: it is seen
