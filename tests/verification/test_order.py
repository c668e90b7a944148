"""Order of convergence of each method on a smooth nonlinear problem."""

from __future__ import annotations

import math
from functools import cache

import numpy as np
import pytest

from ropewalk.methods.registry import METHODS
from ropewalk.scene import Air, Anchor, Orbit, Shake
from verification.setups import ALL, DOWN, chain, run, scene, springs

END = 0.4  # s
PLACES = np.array([(0.25 * i, -0.05 * i * (5 - i), 0.03 * i) for i in range(6)])
STEPS = {
    "euler": 8000,
    "semi-implicit-euler": 2000,
    "verlet": 400,
    "heun": 400,
    "rk4": 400,
    "implicit-euler": 2000,
    "implicit-midpoint": 200,
    "bdf2": 400,
    "sdirk2": 200,
    "esdirk3": 100,
    "generalized-alpha": 200,
}
SMOOTH = Shake(axis=(0.3, 1.0, 0.2), amplitude=0.1, frequency=1.5, phase=0.7)


@cache
def state(method: str, steps: int, motion: Shake, form: str) -> np.ndarray:
    """Positions and velocities at END, as one vector."""
    rope = chain(
        PLACES,
        springs(60.0, 0.1, 0.25, 0.2, friction=form),
        loads=[{"node": 2, "mass": 0.15}],
        diameter=0.02,
    )
    anchors = [
        Anchor(node=0, motion=motion),
        Anchor(node=5, motion=Orbit(center=(1.2, 0.1, 0.0), axis=(0, 0, 1), frequency=0.5)),
    ]
    air = Air(node_drag=0.05, node_drag_quadratic=0.02, density=1.2, wind=(0.5, 3.0, 1.0))
    film = run(
        scene(
            rope,
            anchors,
            dt=END / steps,
            steps=steps,
            every=steps,
            method=method,
            gravity=DOWN,
            air=air,
        )
    )
    return np.concatenate([film.x[-1].ravel(), film.v[-1].ravel()])


def order(method: str, motion: Shake, form: str) -> float:
    n = STEPS[method]
    exact = state("rk4", 6400, motion, form)
    errors = [np.linalg.norm(state(method, s, motion, form) - exact) for s in (n, 2 * n)]
    return math.log2(errors[0] / errors[1])


@pytest.mark.parametrize("form", ["vector", "axial"])
@pytest.mark.parametrize("method", ALL)
def test_order_of_convergence(method: str, form: str) -> None:
    """Within 0.1 of the order, against RK4 at 6400 steps (its error there is 1e-12).

    Twins: the orders of the other methods. What starts abruptly is in `test_kinks`.
    """
    found = order(method, SMOOTH, form)
    assert found == pytest.approx(METHODS[method].order, abs=0.1)
    for wrong in {1, 2, 3, 4} - {METHODS[method].order}:
        assert abs(found - wrong) > 0.1
