"""Random scenes in which ropes are thrown at bodies, at each other and at themselves."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, Phase, assume, given, settings
from hypothesis import strategies as st

from bodies import moved, outside
from ropewalk.record.simulate import simulate_in_memory
from ropewalk.scene import Scene, SceneError, dumps, loads
from ropewalk.simulation import Simulation
from touching_strategies import THICK, bodies, touching

RELAXED = settings(
    max_examples=25,
    deadline=None,
    suppress_health_check=[HealthCheck.too_slow, HealthCheck.filter_too_much],
    phases=(Phase.explicit, Phase.reuse, Phase.generate),  # shrinking whole runs takes minutes
    derandomize=True,
)
MOST_STEPS = 3000


def room_in(body: Any) -> float:
    """Return how deep a solid lets a node's surface come [m]: three quarters of its least half thickness."""
    if body.kind == "plane":
        return math.inf  # it has no other side
    thin = {
        "sphere": lambda: body.radius,
        "torus": lambda: body.bar_radius,
        "box": lambda: min(body.half_sizes),
        "capsule": lambda: body.radius,
        "cylinder": lambda: min(body.radius, 0.5 * math.dist(body.start, body.end)),
    }[body.kind]()
    return 0.75 * (thin + 0.5 * THICK)


def depths(body: Any, result: Any, good: int) -> np.ndarray:
    """Return how deep the surfaces of nodes that no anchor holds are in a body [m], (good, nodes)."""
    places = result.positions[:good] - moved(body, result.time[:good])[:, None, :]
    found = 0.5 * THICK - outside(body, places)
    found[:, list(result.layout.anchor_nodes)] = -np.inf
    return found


def holds(scene: Scene) -> None:
    """A run ends or says why not, frames are finite, books close, and no node goes too deep, or unsaid.

    To the first end of a rope, where others went on.
    """
    try:
        simulation = Simulation(scene)
    except SceneError as error:
        told = str(error)
        assert ": " in told
        return
    assume(simulation.plan.steps <= MOST_STEPS)
    result = simulate_in_memory(scene)
    good = min([result.good_frames, *(end.frames for end in result.ends)])
    assert all(end.why for end in result.ends)
    assert result.status in ("finished", "broke")
    assert (result.status == "finished") == (result.diagnosis == "")
    for name in ("positions", "velocities", "tension"):
        assert np.isfinite(result.read(name, 0, good)).all()
    size = result.energy["kinetic"][:good].max() + 1e-3
    steps = simulation.plan.steps_per_frame * good
    assert np.abs(result.balance_residual[:good]).max() <= 1e-11 * size * steps
    for body in scene.obstacles:
        deep = depths(body, result, good)
        assert deep.max() < 1.001 * room_in(body)
        inside = deep > THICK  # the middle, and well so
        if (inside & result.contact_force[:good].any(axis=2)).any():
            assert "about the obstacles" in result.table


@RELAXED
@given(touching())
def test_ropes_that_are_thrown_at_things(scene: Scene) -> None:
    holds(scene)


@pytest.mark.slow
@settings(RELAXED, max_examples=200)
@given(touching(methods=("implicit-euler", "esdirk3", "adaptive")))
def test_many_ropes_that_are_thrown_at_things(scene: Scene) -> None:
    holds(scene)


@settings(RELAXED, max_examples=60)
@given(touching())
def test_such_a_scene_is_read_as_written(scene: Scene) -> None:
    assert loads(dumps(scene)) == scene


@given(bodies("body"), st.integers(0, 2**32 - 1))
def test_distances_of_the_tests_own_end_on_the_surface(body: object, seed: int) -> None:
    """Against the gradient of a distance, by its size: that is on the surface. The twin: by half of it."""
    x = np.random.default_rng(seed).uniform(-1.0, 1.0, (40, 3))
    found, h = outside(body, x), 1e-6
    there = [(outside(body, x + h * e) - outside(body, x - h * e)) / (2.0 * h) for e in np.eye(3)]
    slope, clear = np.stack(there, axis=-1), found > 0.01
    left = np.abs(outside(body, x - found[:, None] * slope))[clear]
    assert np.quantile(left, 0.9) < 1e-6  # some may lie on a ridge
    half = np.abs(outside(body, x - 0.5 * found[:, None] * slope))[clear]
    assert half.min() > 1e-3
