"""The stability bound from both sides: 1 % below it 10^5 steps are calm, 1 % above they break."""

from __future__ import annotations

import math

import numpy as np
import pytest

from ropewalk.lowering.chains import chains
from ropewalk.methods.bound import largest_step
from ropewalk.scene import Air, Anchor, Rope, Scene
from ropewalk.simulation import Simulation
from verification.setups import EXPLICIT, along_x, chain, hold, run, scene, springs

K, M, L = 1000.0, 0.01, 0.05
STEPS = 100_000


def shaken_up(
    rope: Rope, anchors: list[Anchor], method: str, dt: float, steps: int, **more
) -> Scene:
    return scene(rope, anchors, dt=dt, steps=steps, every=min(steps, 100), method=method, **more)


def rope_of(n: int, c: float, form: str, loads: tuple[tuple[int, float], ...]) -> Rope:
    """A straight chain of n segments with every node a little out of place along itself."""
    x = L * np.arange(n + 1)
    x[1:] += 1e-6 * L * np.random.default_rng(n).normal(size=n)
    made_of = springs(K, M, L, c, friction=form)
    return chain(along_x(x), made_of, loads=[{"node": i, "mass": m} for i, m in loads])


def c_for(method: str, share: float) -> float:
    """Friction strong enough that euler and heun leave their region at a visible rate."""
    return share * math.sqrt(K * M) * (1.0 if method in ("euler", "heun") else 0.3)


CASES = {
    # segments, friction share, form, loads, air drag, held
    "fixed-free, vector": (8, 0.35, "vector", (), 0.0, (0,)),
    "fixed-fixed, axial": (9, 0.35, "axial", (), 0.0, (0, 9)),
    "unequal masses": (7, 0.35, "vector", ((2, 0.03), (5, 0.004)), 0.0, (0,)),
    "free": (6, 0.35, "axial", (), 0.0, ()),
    "drag": (6, 0.35, "vector", (), 0.3, (0, 6)),
    "drag, unequal masses": (6, 0.35, "vector", ((3, 0.03),), 0.3, (0,)),
    "no friction": (8, 0.0, "vector", (), 0.0, (0,)),
}
COMBINATIONS = [
    (method, name)
    for method in EXPLICIT
    for name in CASES
    # explicit Euler and Heun have no stable step without friction; where friction is proportional
    # to neither mass nor stiffness the bounds of heun and rk4 are enclosures, not exact
    if not (name == "no friction" and method in ("euler", "heun"))
    and not (name == "drag, unequal masses" and method in ("heun", "rk4"))
]


def bound_and_growth(method: str, name: str):
    n, share, form, loads, drag, held = CASES[name]
    rope, anchors = rope_of(n, c_for(method, share), form, loads), hold(*held)
    more = {"air": Air(node_drag=drag)} if drag else {}
    simulation = Simulation(shaken_up(rope, anchors, method, 1e-4, 1, **more))
    found = chains(simulation.system, simulation.arrays)["in the air"]._replace(sideways=False)
    bound = largest_step(method, found)

    def growth(factor: float, steps: int) -> float:
        film = run(shaken_up(rope, anchors, method, factor * bound, steps, **more), ok=False)
        if film.block.status:
            return math.inf
        elastic = film.block.recording.energy[:, [0, 2]].sum(axis=1)
        return float(elastic.max() / elastic[0])

    return bound, growth


@pytest.mark.parametrize(("method", "name"), COMBINATIONS)
def test_the_bound_from_both_sides(method: str, name: str) -> None:
    """Jury's conditions of the scheme's characteristic polynomial for every mode (closed forms 1.2,
    1.3). The chain is straight, so the motion is linear and the bound exact.

    Just below the bound the energy of a non-normal map may swell (up to 1 / (1 - y^2/4) ~ 50), not
    grow for ever. The twin of each side is the other side.
    """
    bound, growth = bound_and_growth(method, name)
    assert 0.0 < bound < math.inf
    assert growth(0.99, STEPS) < 200.0
    assert growth(1.01, STEPS) > 1e6


@pytest.mark.parametrize(
    ("method", "bound"),
    [("semi-implicit-euler", 0.002325498951), ("euler", 0.001), ("rk4", 0.004462902574)],
)
def test_published_bounds(method: str, bound: float) -> None:
    """Closed forms 1.3, fixed-free, N 20, m 0.01, k 1000, c 1: semi-implicit Euler 2.325498951 ms,
    explicit Euler c/k = 1 ms, RK4 4.462902574 ms.
    """
    n = 20
    rope = chain(along_x(L * np.arange(n + 1)), springs(K, M, L, 1.0))
    simulation = Simulation(scene(rope, hold(0), dt=1e-4, steps=1))
    found = chains(simulation.system, simulation.arrays)["in the air"]
    assert largest_step(method, found) == pytest.approx(bound, rel=1e-9)
    soft = found._replace(damping_vector=0.5 * found.damping_vector)
    assert abs(largest_step(method, soft) / bound - 1.0) > 1e-3  # the twin: half the friction
