"""The energy balance: to round-off for every law and method, and to the method's order in energy."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from ropewalk.scene import (
    Air,
    Anchor,
    Ground,
    Limiter,
    Material,
    Rope,
    Shake,
    Velocity,
    Winch,
)
from ropewalk.simulation import Simulation
from verification.setups import (
    ALL,
    DOWN,
    EXPLICIT,
    chain,
    hold,
    mode_history,
    off,
    run,
    scene,
    springs,
)

BENT = np.array([(0.3 * i, 0.1 * math.sin(2.0 * i), 0.05 * i * i / 8) for i in range(9)])
FIXED = hold(0)
MOVED = [
    *hold(0),
    Anchor(node=6, motion=Velocity(velocity=(0.5, 1.0, -0.2), start=0.031, stop=0.1)),
]
SHAKEN = [
    *hold(8),
    Anchor(node=0, motion=Shake(axis=(1, 2, 0), amplitude=0.05, frequency=2.0, phase=0.4)),
]
LINE = Air(density=1.2, normal_coefficient=40.0, tangential_coefficient=5.0, wind=(3, 0, 1))


def bent(c: float = 0.0, form: str = "vector", **more: Any) -> Rope:
    made_of = springs(150.0, 0.08, 0.28, c, friction=form, tension_only=more.pop("slack", False))
    kicks = [{"node": 4, "velocity": (1.0, 2.0, -1.0)}]
    return chain(BENT, made_of, diameter=0.02, kicks=kicks, **more)


def wound() -> Rope:
    """A material on a winch; the winch's end is node 0."""
    made_of = Material(EA=40.0, mass_per_length=0.3, axial_damping=0.01)
    places = {"kind": "points", "points": BENT.tolist()}
    return Rope(segments=8, length=2.3, made_of=made_of, shape=places)


# what acts, and the law whose work a broken ledger forgets
CASES: dict[str, tuple[dict[str, Any], str]] = {
    "springs": ({"rope": bent(), "anchors": FIXED}, "elastic"),
    "slack": ({"rope": bent(slack=True), "anchors": FIXED}, "elastic"),
    "weight": ({"rope": bent(), "anchors": []}, "weight"),
    "vector friction": ({"rope": bent(0.2), "anchors": FIXED}, "friction"),
    "axial friction": ({"rope": bent(0.2, "axial"), "anchors": FIXED}, "friction"),
    "slack friction": ({"rope": bent(0.2, slack=True), "anchors": FIXED}, "friction"),
    "linear drag": ({"rope": bent(), "anchors": FIXED, "air": Air(node_drag=0.1)}, "air"),
    "quadratic drag": (
        {"rope": bent(), "anchors": FIXED, "air": Air(node_drag_quadratic=0.1, wind=(1, 2, 0))},
        "air",
    ),
    "line drag": ({"rope": bent(), "anchors": FIXED, "air": LINE}, "air"),
    "ground": ({"rope": bent(0.1), "anchors": FIXED, "ground": Ground(height=0.05)}, "ground"),
    "moved anchor": ({"rope": bent(0.1), "anchors": MOVED}, "anchors"),
    "shaken anchor": ({"rope": bent(0.1), "anchors": SHAKEN}, "anchors"),
    "released anchor": (
        {"rope": bent(0.1), "anchors": [SHAKEN[0], SHAKEN[1].replace(release_time=0.1)]},
        "anchors",
    ),
    "limiter": (
        {
            "rope": bent(0.1),
            "anchors": FIXED,
            "limiter": Limiter(min_stretch=0.95, max_stretch=1.05),
        },
        "limiter",
    ),
    "pay out": (
        {"rope": wound(), "anchors": FIXED, "winches": [Winch(end="start", speed=2.0)]},
        "winch",
    ),
    "reel in": (
        {"rope": wound(), "anchors": FIXED, "winches": [Winch(end="start", speed=-2.0)]},
        "winch",
    ),
    "applied force": ({"rope": bent(0.1), "anchors": FIXED}, "applied"),
}


def built(
    name: str, method: str, *, dt: float = 1e-3, steps: int = 200, every: int = 1
) -> Simulation:
    parts = dict(CASES[name][0])
    rope, anchors = parts.pop("rope"), parts.pop("anchors")
    made = scene(
        rope, anchors, dt=dt, steps=steps, every=every, method=method, gravity=DOWN, **parts
    )
    simulation = Simulation(made)
    if name == "applied force":
        simulation.apply_force(5, (1.0, -2.0, 3.0))
    return simulation


@pytest.mark.parametrize(
    ("method", "name"),
    [(m, name) for m in ALL for name in CASES if name != "limiter" or m in EXPLICIT],
)
def test_the_works_of_all_laws_add_up_to_the_kinetic_energy(method: str, name: str) -> None:
    """m (v1^2 - v0^2) / 2 = h F . (v0 + v1) / 2 is exact for any mean force F (ledger): round-off,
    200 steps of works of up to some 10 J. The twin forgets one law's work.
    """
    film = run(built(name, method))
    scale = max(1.0, film.block.recording.energy[:, 0].max())
    assert off(film.residual(), 0.0) < 2e-12 * scale
    assert off(film.residual(without=CASES[name][1]), 0.0) > 1e-4


SMOOTH = ("springs", "axial friction", "vector friction", "linear drag", "line drag", "shaken anchor",
          "applied force")  # fmt: skip


@pytest.mark.parametrize("name", SMOOTH)
@pytest.mark.parametrize("method", EXPLICIT)
def test_the_energy_error_converges(method: str, name: str) -> None:
    """Energy minus works falls as dt^p: p the method's order where only potentials act; with other
    works at most 2, as these are booked with mean force times mean velocity (a trapezoid).
    """
    order = {"euler": 1, "semi-implicit-euler": 1, "verlet": 2, "heun": 2, "rk4": 4}[method]
    order = order if name == "springs" else min(order, 2)

    def error(steps: int) -> float:
        film = run(built(name, method, dt=0.128 / steps, steps=steps, every=steps // 8))
        return float(np.abs(film.energy_error()).max())

    n = 256 if method in ("verlet", "rk4") else 4096
    coarse, fine = error(n), error(2 * n)
    assert math.log2(coarse / fine) > order - 0.15
    # the twin: the error of a ledger that forgets half of a real work does not converge
    film = run(built(name, method, dt=0.128 / n, steps=n, every=n // 8))
    law = CASES[name][1]
    if law != "elastic":
        assert off(film.energy_error() + 0.5 * film.work(law), 0.0) > 3 * coarse


@pytest.mark.parametrize("method", EXPLICIT)
def test_an_undamped_rope_keeps_its_energy_as_its_method_can(method: str) -> None:
    """Claims C4, C8 and closed forms 1.5, one mode: explicit Euler multiplies the energy by
    1 + y^2 per step, Heun by 1 + y^4/4, RK4 by 1 - y^6/72 + y^8/576; Verlet's error stays between 0
    and -y^2/4 for ever; semi-implicit Euler's within +-y/2 / (1 - y/2).
    """
    k, m, y = 100.0, 1.0, 0.5
    dt, steps = y / math.sqrt(k / m), 400 if method == "euler" else 4000
    rope = chain(np.array([(0, 0, 0), (1e-3, 0, 0)]), springs(k, m, 0.0))
    film = run(scene(rope, hold(0), dt=dt, steps=steps, method=method), keep_going=True)
    ratio = film.total / film.total[0]
    growth = {"euler": 1 + y**2, "heun": 1 + y**4 / 4, "rk4": 1 - y**6 / 72 + y**8 / 576}
    if method in growth:
        expected = growth[method] ** np.arange(len(ratio))
        assert off(ratio / expected, 1.0) < 1e-10
        assert off(ratio, 1.0) > 0.4  # the twin: no energy-keeping method
    elif method == "verlet":
        assert ratio.max() < 1.0 + 1e-12
        assert ratio.min() > 1.0 - y * y / 4 - 1e-12
        assert ratio.min() == pytest.approx(1.0 - y * y / 4, rel=1e-3)
        damped = mode_history(method, y * y, 1e-3, steps)
        assert np.abs(damped[-100:]).max() ** 2 < 0.1  # the twin: hidden damping would show
    else:
        assert ratio.max() < 1.0 / (1.0 - y / 2)
        assert ratio.min() > 1.0 / (1.0 + y / 2) - 1e-12


@pytest.mark.parametrize("method", ["semi-implicit-euler", "verlet"])
def test_the_modified_energy_is_constant(method: str) -> None:
    """Closed forms 1.5 (Hairer, Lubich & Wanner, IX.3), linear force -K x: 2 H~ = v'Mv + x'Kx -
    dt v'Kx (kick, drift) and v'Mv + x'Kx - dt^2/4 x'K M^-1 K x (Verlet); 1e-12 over 2e4 steps, and
    4e-12 over 1e5 (rounding, 2e-17 a step).

    Springs of no rest length make a chain that is linear in space. Twins: the plain energy, and the
    formula with the other sign.
    """
    rng = np.random.default_rng(7)
    n, k = 6, 300.0
    places = np.cumsum(rng.normal(size=(n + 1, 3)), axis=0)
    places -= places[0]
    kicks = [
        {"node": i, "velocity": tuple(map(float, rng.normal(size=3)))} for i in range(1, n + 1)
    ]
    rope = chain(places, springs(k, 0.02, 0.0), kicks=kicks, loads=[{"node": 3, "mass": 0.05}])
    dt = 0.8 * math.sqrt(0.02 / k)
    film = run(scene(rope, hold(0), dt=dt, steps=100_000, every=500, method=method))
    m = np.array([0.02, 0.02, 0.07, 0.02, 0.02, 0.02])
    K = k * (2 * np.eye(n) - np.eye(n, k=1) - np.eye(n, k=-1))
    K[-1, -1] = k
    x, v = film.x[:, 1:], film.v[:, 1:]

    def form(a: np.ndarray, A: np.ndarray, b: np.ndarray) -> np.ndarray:
        return np.einsum("fik,ij,fjk->f", a, A, b)

    plain = form(v, np.diag(m), v) + form(x, K, x)
    if method == "verlet":
        correction = -dt * dt / 4 * form(x, K @ np.diag(1 / m) @ K, x)
    else:
        correction = -dt * form(v, K, x)
    energy = plain + correction
    assert off(energy[:40] / energy[0], 1.0) < 1e-12
    assert off(energy / energy[0], 1.0) < 4e-12
    assert off(plain / plain[0], 1.0) > 1e-3
    wrong = plain - correction
    assert off(wrong / wrong[0], 1.0) > 1e-3
