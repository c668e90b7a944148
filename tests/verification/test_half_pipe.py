"""Troughs: a rope that lies along one swings in it as a pendulum, and stays where friction holds it."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.plots.outlines import outlines_of
from ropewalk.plots.sight import sight
from ropewalk.scene import Box, HalfPipe, Material, Points, Rope, RunSettings, Scene, SceneError

g, RADIUS, THICK = 9.81, 0.5, 0.02
ARM = RADIUS - 0.5 * THICK


def trough(degrees: float, friction: float, **run: object) -> Scene:
    """A rope of 0.3 m along a trough, as far up its side."""
    a = math.radians(degrees)
    place = [(ARM * math.sin(a), 0.05 * i, -ARM * math.cos(a)) for i in range(7)]
    made_of = Material(EA=1e3, mass_per_length=0.1)
    rope = Rope(segments=6, length=0.3, made_of=made_of, shape=Points(points=place), diameter=THICK)
    body = HalfPipe(start=(0, -1, 0), end=(0, 1, 0), radius=RADIUS, friction=friction)
    settings = {"duration": 1.0, "frame_rate": 60.0, "time_step": 1.0 / 480.0, "method": "esdirk3"}
    return Scene(ropes=[rope], obstacles=[body], run=RunSettings(**(settings | run)))


def test_without_friction_it_swings_as_a_pendulum() -> None:
    """From 5 degrees: angle = 5 cos(w t), w^2 = g / (R - d/2), slower by 5^2/16 [rad] of its part."""
    result = rw.simulate(trough(5.0, 0.0))
    angle = np.arcsin(result.positions[:, 3, 0] / ARM)
    first = math.radians(5.0)
    rate = math.sqrt(g / ARM) * (1.0 - first**2 / 16.0)
    np.testing.assert_allclose(angle, first * np.cos(rate * result.time), atol=0.01 * first)
    assert np.abs(result.positions[:, :, 0]).max() < 1.01 * ARM * math.sin(first)


@pytest.mark.parametrize(("degrees", "holds"), [(16.0, True), (18.0, False)])
def test_it_stays_below_the_angle_of_friction(degrees: float, holds: bool) -> None:
    """atan 0.3 is 16.7 degrees."""
    places = rw.simulate(trough(degrees, 0.3)).positions
    moved = np.abs(places[-1] - places[12]).max()
    assert moved < 1e-8 if holds else moved > 1e-3


def test_its_walls_stand_upright_above_the_round() -> None:
    """A rope thrown against one stops there, half a diameter off it."""
    scene = trough(0.0, 0.0)
    rope = scene.ropes[0]
    points = tuple((0.3, y, 0.5) for _, y, _ in rope.shape.points)
    thrown = rope.shape.replace(points=points, velocity=(2.0, 0.0, 0.0))
    scene = scene.replace(ropes=[rope.replace(shape=thrown)], run=scene.run.replace(duration=0.2))
    places = rw.simulate(scene).positions[..., 0]
    assert places.max() == pytest.approx(ARM, abs=1e-3)
    assert places[-1] == pytest.approx(ARM, abs=1e-3)


def test_it_is_drawn_where_it_is_seen_along_its_axis() -> None:
    result = rw.simulate(trough(5.0, 0.0, duration=0.05))
    (outline,) = outlines_of(result, sight(result, "xz"))
    low = outline.outer[np.abs(outline.outer).max(axis=1) < 1.01 * RADIUS]
    np.testing.assert_allclose(np.hypot(*low.T), RADIUS)
    assert outlines_of(result, sight(result, "yz")) == ()


def test_what_is_no_trough_is_refused_in_words() -> None:
    with pytest.raises(ValueError, match="open_to.*must not lie along its axis"):
        HalfPipe(start=(0, 0, 0), end=(0, 0, 1), radius=1.0)
    with pytest.raises(SceneError, match="inside obstacle"):
        rw.simulate(trough(0.0, 0.0).replace(obstacles=[
            HalfPipe(start=(0, -1, 0), end=(0, 1, 0), radius=0.4)
        ]))  # fmt: skip


def test_a_trough_beside_a_box_is_outlined_from_any_side() -> None:
    """Rows of sizes are as wide as the widest body's: of its own a trough takes three."""
    scene = trough(5.0, 0.0, duration=0.02)
    box = Box(center=(0, 0, -3), half_sizes=(0.1, 0.1, 0.1), edge_radius=0.01, rotation=(0, 0.3, 0))
    beside = scene.replace(obstacles=[*scene.obstacles, box], gravity=(3.0, 0.0, -9.0))
    result = rw.simulate(beside)
    seen = sight(result)
    tilted = replace(seen, across=np.array([0.8, 0.0, 0.6]), up=np.array([-0.6, 0.0, 0.8]))
    found = outlines_of(result, tilted)
    assert len(found) == 2
    assert all(np.isfinite(one.outer).all() for one in found)
