"""Momentum and angular momentum: what changes them, and what must not."""

from __future__ import annotations

import numpy as np
import pytest

from ropewalk.scene import Air, Anchor, Ground, Rope, Shake, Straight
from verification.setups import (
    ALL,
    DOWN,
    chain,
    hold,
    in_place_sweep,
    off,
    run,
    scene,
    springs,
)

RNG = np.random.default_rng(20240229)
WILD = np.cumsum(RNG.normal(size=(9, 3)), axis=0)
SPEEDS = RNG.normal(size=(9, 3))
KICKS = [{"node": i, "velocity": tuple(map(float, v))} for i, v in enumerate(SPEEDS)]


@pytest.mark.parametrize("form", ["vector", "axial"])
@pytest.mark.parametrize("method", ALL)
def test_internal_forces_keep_momentum(method: str, form: str) -> None:
    """Action and reaction cancel in every stage: sum m v is constant to round-off, whatever the step.

    The twin moves each mass at once after its own force (seed document 3.4, "in-place sweep").
    """
    rope = chain(WILD, springs(50.0, 0.2, 1.0, 0.3, friction=form), kicks=KICKS)
    film = run(scene(rope, dt=1e-3, steps=300, method=method))
    momentum = film.block.recording.momentum
    assert momentum[0] == pytest.approx(0.2 * SPEEDS.sum(axis=0), abs=1e-14)
    assert off(momentum, momentum[0]) < 1e-13
    _, v = in_place_sweep(WILD, SPEEDS, 50.0, 0.2, 1.0, 1e-3, 300)
    assert off(0.2 * v.sum(axis=0), momentum[0]) > 1e-3


@pytest.mark.parametrize("method", ["semi-implicit-euler", "verlet"])
def test_central_forces_keep_angular_momentum(method: str) -> None:
    """Both schemes kick along the segments and drift along v: sum m x cross v is exact (Hairer,
    Lubich & Wanner, Geometric Numerical Integration, IV.1). The twins: vector friction; RK4's error.
    """

    def spin(method: str, form: str, c: float) -> np.ndarray:
        rope = chain(WILD, springs(50.0, 0.2, 1.0, c, friction=form), kicks=KICKS)
        film = run(scene(rope, dt=1e-3, steps=300, method=method))
        return film.block.recording.angular_momentum

    L = spin(method, "axial", 0.0)
    x, v = WILD, SPEEDS
    assert L[0] == pytest.approx(0.2 * np.cross(x, v).sum(axis=0), abs=1e-13)
    assert off(L, L[0]) < 1e-12
    if method == "semi-implicit-euler":  # the force is evaluated at the positions it acts at
        assert off(spin(method, "axial", 0.3), L[0]) < 1e-12
    assert off(spin(method, "vector", 0.3), L[0]) > 1e-2
    assert off(spin("euler", "axial", 0.0), L[0]) > 1e-3


@pytest.mark.parametrize("method", ALL)
def test_momentum_changes_by_weight_reactions_and_outer_forces(method: str) -> None:
    """(P1 - P0) / dt = M g + sum of reactions, in every step exactly (reactions are means over it).

    The drag -b v is not an internal force: with it the same sum is off by b sum v (the twin).
    """

    def unbalanced(**more) -> float:
        rope = Rope(
            segments=8,
            made_of=springs(200.0, 0.1, 0.3, 0.05),
            shape=Straight(start=(0, 0, 0), end=(2.2, 0.4, 0.3)),
        )
        shaken = Anchor(node=3, motion=Shake(axis=(0, 1, 0), amplitude=0.05, frequency=3.0))
        film = run(
            scene(
                rope,
                [*hold(0), shaken],
                dt=5e-4,
                steps=400,
                method=method,
                gravity=DOWN,
                **more,
            )
        )
        rate = np.diff(film.block.recording.momentum, axis=0) / 5e-4
        pulls = film.block.recording.reaction[1:].sum(axis=1)
        return off(rate, 0.9 * np.array(DOWN) + pulls)

    assert unbalanced() < 1e-10
    assert unbalanced(air=Air(node_drag=0.01)) > 1e-3
    assert unbalanced(ground=Ground(height=-0.05)) > 1e-2
