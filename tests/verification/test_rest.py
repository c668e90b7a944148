"""Hanging and taut chains come to rest in their exact static shapes."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest
from scipy.optimize import brentq

from ropewalk.scene import Air, Material, Rope, Scene, Slack, Straight
from ropewalk.statics import static_shape
from ropewalk.theory import catenary
from verification.setups import DOWN, SYMPLECTIC, chain, g, hold, off, run, scene, springs


def funicular(H: float, V: float, n: int, w: float, k: float, length: float) -> np.ndarray:
    """Nodes (n + 1, 2) of n springs from (0, 0) with horizontal force H and first vertical force V.

    V_(i+1) = V_i - w, T_i = sqrt(H^2 + V_i^2), l_i = l0 + T_i / k (closed forms 2.2; V is positive
    where the rope goes down).
    """
    down = V - w * np.arange(n)
    tension = np.hypot(H, down)
    stretched = length + tension / k
    steps = stretched[:, None] * np.stack([np.full(n, H), -down], axis=1) / tension[:, None]
    return np.concatenate([np.zeros((1, 2)), np.cumsum(steps, axis=0)])


def equilibrium(n: int, m: float, k: float, length: float, X: float, Y: float = 0.0):
    """Solve (H, V) for the far end at (X, Y) by damped Newton steps; return nodes, H and V."""
    w = m * g
    force = np.array([max(w * n, 1e-3 * k * length), 0.5 * (n - 1) * w])
    target = np.array([X, Y])

    def miss(f: np.ndarray) -> np.ndarray:
        return funicular(f[0], f[1], n, w, k, length)[-1] - target

    for _ in range(200):
        now = miss(force)
        h = 1e-7 * np.maximum(np.abs(force), w)
        J = np.array([(miss(force + d) - now) / d.sum() for d in np.diag(h)]).T
        step = np.linalg.solve(J, -now)
        share = 1.0
        while share > 1e-6:
            trial = force + share * step
            if trial[0] > 0 and np.linalg.norm(miss(trial)) <= np.linalg.norm(now):
                break
            share *= 0.5
        force = force + share * step
        if np.linalg.norm(now) < 1e-14 * n:
            break
    return funicular(force[0], force[1], n, w, k, length), force[0], force[1]


def test_the_reference_solver_has_the_published_numbers() -> None:
    """Seed document 3.5 and closed forms 2.2: lowest node and H."""
    for n, k, sag, H in [
        (10, 100.0, 1.3503, 4.446),
        (20, 100.0, 3.4350, 6.910),
        (20, 200.0, 2.6937, 8.911),
        (20, 1e4, 0.7181, 34.094),
        (40, 1e4, 1.8099, 54.057),
    ]:
        nodes, found, _ = equilibrium(n, 0.05, k, 1.0, float(n))
        assert -nodes[:, 1].min() == pytest.approx(sag, abs=6e-5)
        assert found == pytest.approx(H, abs=6e-4)
    nodes, H, _ = equilibrium(79, 0.05, 1e4, 0.05, 3.95)
    assert nodes[:, 1].min() == pytest.approx(-0.6235371441, abs=1e-9)
    assert pytest.approx(29.8135164, abs=1e-6) == H
    nodes, H, _ = equilibrium(20, 0.01, 1000.0, 0.05, 0.8)
    assert nodes[:, 1].min() == pytest.approx(-0.2783790277, abs=1e-9)
    assert pytest.approx(0.6296854707, abs=1e-9) == H


def at_rest(
    rope: Rope, anchors: list, *, dt: float, steps: int, drag: float, method: str = "verlet"
):
    """Run under heavy air until nothing moves; return the film."""
    film = run(
        scene(
            rope,
            anchors,
            dt=dt,
            steps=steps,
            every=steps,
            gravity=DOWN,
            air=Air(node_drag=drag),
            method=method,
        )
    )
    assert np.abs(film.v[-1]).max() < 1e-11, "not at rest yet"
    return film


def hung(
    n: int, *, k: float = 1000.0, m: float = 0.01, length: float = 0.05, method: str = "verlet"
):
    places = np.zeros((n + 1, 3))
    places[:, 1] = -length * np.arange(n + 1)
    slowest = math.sqrt(k / m) * math.pi / (2 * n + 1)
    dt = 0.3 * math.sqrt(m / k)
    steps = round(40 / (slowest * dt))
    rope = chain(places, springs(k, m, length))
    return at_rest(rope, hold(0), dt=dt, steps=steps, drag=2 * m * slowest, method=method)


@pytest.mark.parametrize("method", [*SYMPLECTIC, "heun", "rk4"])
def test_a_chain_under_its_own_weight(method: str) -> None:
    """e_i = (N - i + 1) m g / k from the top (closed forms 2.1; claim C2): N 20, m 0.01, k 1000:
    tip at 1.020601 m, top spring 1.962 N. The static solution is the same for every scheme: 1e-12.
    """
    film = hung(20, method=method)
    i = np.arange(1, 21)
    depth = np.cumsum(0.05 + (20 - i + 1) * 0.01 * g / 1000.0)
    assert off(-film.x[-1, 1:, 1] / depth, 1.0) < 1e-12
    assert -film.x[-1, -1, 1] == pytest.approx(1.020601, abs=1e-9)
    assert film.block.recording.tension[-1, 0] == pytest.approx(1.962, rel=1e-11)
    reaction = film.block.recording.reaction[-1, 0]
    assert reaction == pytest.approx([0.0, 21 * 0.01 * g, 0.0], abs=1e-11)
    # twins: half the mass at the end (1.01962 m), half the stiffness
    half_end = np.cumsum(0.05 + (20 - i + 0.5) * 0.01 * g / 1000.0)
    assert off(-film.x[-1, 1:, 1] / half_end, 1.0) > 1e-5
    assert off(-hung(20, k=500.0).x[-1, 1:, 1] / depth, 1.0) > 1e-3


@pytest.mark.parametrize(
    ("n", "k", "m", "length", "X", "Y"),
    [
        (20, 1000.0, 0.01, 0.05, 0.8, 0.0),  # A slack
        (20, 1000.0, 0.01, 0.05, 0.6, 0.5),  # B unequal heights
        (20, 1000.0, 0.01, 0.05, 1.0, 0.0),  # C pins at the rest length
        (20, 1000.0, 0.01, 0.05, 1.02, 0.0),  # D stretched by 2 %
        (20, 1e4, 0.05, 1.0, 20.0, 0.0),  # the report's section, sag 0.7181 m
        (10, 100.0, 0.05, 1.0, 10.0, 0.0),
        (20, 1e4, 0.05, 1.0, 15.0, 0.0),  # the report's slack loop, 5.9004 m
    ],
)
def test_a_pinned_chain_rests_in_its_funicular_polygon(
    n: int, k: float, m: float, length: float, X: float, Y: float
) -> None:
    """Closed forms 2.2, all nodes to 1e-10 m; both reactions carry half the weight, at H."""
    expected, H, V = equilibrium(n, m, k, length, X, Y)
    slack = math.hypot(X, Y) < n * length * (1 - 1e-9)
    shape = (Slack if slack else Straight)(start=(0, 0, 0), end=(X, Y, 0))
    rope = Rope(segments=n, made_of=springs(k, m, length, 0.05), shape=shape)
    slowest = min(math.pi / (n * length) * math.sqrt(H * length / m), math.sqrt(g / (n * length)))
    dt = 0.6 * math.sqrt(m / k)
    steps = round(60 / (slowest * dt))
    film = at_rest(rope, hold(0, n), dt=dt, steps=steps, drag=2 * m * slowest)
    assert off(film.x[-1, :, :2], expected) < 1e-10
    first, last = film.block.recording.reaction[-1]
    assert first == pytest.approx([-H, V + m * g, 0.0], rel=1e-8, abs=1e-9)
    assert first + last == pytest.approx([0.0, (n + 1) * m * g, 0.0], rel=1e-9, abs=1e-9)
    # twins: springs 1 % stiffer, masses a tenth lighter, a chain of rigid links
    for wrong in (
        equilibrium(n, m, 1.01 * k, length, X, Y),
        equilibrium(n, 0.9 * m, k, length, X, Y),
    ):
        assert off(film.x[-1, :, :2], wrong[0]) > 1e-6


def elastic_catenary(L0: float, w: float, EA: float, X: float) -> tuple[float, float]:
    """H and the depth of the middle between level pins (closed forms 2.4, Irvine 1981), by bisection."""
    V = 0.5 * w * L0

    def span(H: float) -> float:
        return H * L0 / EA + 2.0 * H / w * math.asinh(V / H)

    low, high = 1e-9, EA
    for _ in range(200):
        H = 0.5 * (low + high)
        low, high = (H, high) if span(H) < X else (low, H)
    s = 0.5 * L0
    depth = w * s / EA * (V / w - 0.5 * s) + H / w * (math.sqrt(1 + (V / H) ** 2) - 1.0)
    return H, depth


def test_the_chain_converges_to_the_elastic_catenary() -> None:
    """Closed forms 2.4: L0 1, w 1.962, EA 50, X 0.8: H 0.6300720579 N, middle -0.2780142628 m; the
    error falls as N^-2. The twin: nodes with the masses of springs (whole ones in the span, a pin's
    half added to it) do not change a pinned chain, but a rope 1 % heavier misses the limit.
    """
    H, depth = elastic_catenary(1.0, 1.962, 50.0, 0.8)
    assert pytest.approx(0.6300720579, rel=1e-9) == H
    assert depth == pytest.approx(0.2780142628, rel=1e-9)

    def error(n: int, mu: float = 0.2) -> float:
        made_of = Material(EA=50.0, mass_per_length=mu, axial_damping=0.01)
        shape = Slack(start=(0, 0, 0), end=(0.8, 0, 0))
        rope = Rope(segments=n, length=1.0, made_of=made_of, shape=shape)
        dt = 0.5 * math.sqrt(mu / 50.0) / n
        film = at_rest(rope, hold(0, n), dt=dt, steps=round(20 / dt), drag=1.2 / n)
        return abs(-film.x[-1, n // 2, 1] - depth)

    errors = [error(n) for n in (10, 20, 40)]
    for coarse, fine in pairwise(errors):
        assert math.log2(coarse / fine) == pytest.approx(2.0, abs=0.03)
    assert errors[2] < 1e-3 * depth
    heavier = [error(n, 0.25) for n in (20, 40)]
    assert abs(math.log2(heavier[0] / heavier[1])) < 1.0


def test_the_inextensible_catenary_is_the_limit_of_chains_of_rigid_links() -> None:
    """Closed forms 2.3: sqrt(L^2 - Y^2) = 2 a sinh(X / 2a), depth a (cosh(X / 2a) - 1) = 0.2654375091 m for
    L 1, X 0.8. The library's closed form has that number and a's own equation, and a scene of rigid links at
    rest reaches both: N^-2. The twin: EA = 50 N.
    """
    a = brentq(lambda a: 2.0 * a * math.sinh(0.4 / a) - 1.0, 0.1, 10.0, xtol=1e-15)
    cable = catenary(1.0, 0.8, weight=0.2 * g)
    assert cable.horizontal == pytest.approx(0.2 * g * a, rel=1e-12)
    assert cable.sag == pytest.approx(a * (math.cosh(0.4 / a) - 1.0), rel=1e-12)
    assert cable.sag == pytest.approx(0.2654375091, abs=1e-10)

    def resting(n: int, EA: float = math.inf) -> tuple[float, float]:
        """Depth [m] and horizontal force [N] of the equilibrium of a scene."""
        shape = Slack(start=(0, 0, 0), end=(0.8, 0, 0))
        rope = Rope(
            segments=n, length=1.0, made_of=Material(EA=EA, mass_per_length=0.2), shape=shape
        )
        found = static_shape(Scene(ropes=rope, anchors=hold(0, n), run={"method": "bdf2"}))
        return -float(found.positions[:, 2].min()), found.spans[0].horizontal

    errors = np.abs([np.subtract(resting(n), (cable.sag, cable.horizontal)) for n in (10, 20, 40)])
    for coarse, fine in pairwise(errors):
        np.testing.assert_allclose(np.log2(coarse / fine), 2.0, atol=0.02)
    assert abs(resting(40, 50.0)[0] - cable.sag) > 5e-3


@pytest.mark.parametrize("node", [-1, 5])
def test_a_load_stretches_what_is_above_it(node: int) -> None:
    """w L^2 / (2 EA) + M g s / EA with the load at depth s (closed forms 2.1): exact at any N."""

    def tip(n: int, load: float) -> float:
        made_of = Material(EA=50.0, mass_per_length=0.2)
        at = n if node == -1 else n // 4
        rope = Rope(
            segments=n,
            length=1.0,
            made_of=made_of,
            shape={"kind": "hanging"},
            loads=[{"node": at, "mass": load}] if load else [],
        )
        dt = 0.4 * math.sqrt(0.2 / 50.0) / n
        film = at_rest(rope, hold(0), dt=dt, steps=round(12 / dt), drag=2.0 / n)
        return float(-film.x[-1, -1, 1])

    share = 1.0 if node == -1 else 0.25
    for n in (4, 8, 16):
        expected = 1.0 + 0.2 * g / 100.0 + 0.1 * g * share / 50.0
        assert tip(n, 0.1) == pytest.approx(expected, abs=1e-11)
    assert abs(tip(4, 0.05) - expected) > 1e-3
