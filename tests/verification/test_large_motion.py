"""Pendulums and spinning ropes: motion with large rotations."""

from __future__ import annotations

import math

import numpy as np
import pytest

from ropewalk.methods.registry import METHODS
from ropewalk.scene import Material, Rope
from verification.setups import (
    ALL,
    DOWN,
    chain,
    g,
    hold,
    off,
    run,
    scene,
    springs,
)


def pendulum(theta: float, k: float, *, dt: float, steps: int, method: str, gravity=DOWN):
    """A mass on a stiff spring of 1 m, let go at rest at the angle theta [rad] from below."""
    tip = (math.sin(theta), -math.cos(theta), 0.0)
    rope = chain(np.array([(0, 0, 0), tip]), springs(k, 1.0, 1.0))
    return run(scene(rope, hold(0), dt=dt, steps=steps, method=method, gravity=gravity))


def elliptic_period(theta: float) -> float:
    """T = 4 sqrt(L/g) K(sin^2(theta/2)) = 2 pi sqrt(L/g) / agm(1, cos(theta/2)) (Gauss)."""
    a, b = 1.0, math.cos(theta / 2)
    for _ in range(40):
        a, b = 0.5 * (a + b), math.sqrt(a * b)
    return 2 * math.pi * math.sqrt(1 / g) / a


def period_of(film) -> float:
    """Twice the time between the first two crossings of the vertical, by cubic interpolation."""
    x, t = film.x[:, 1, 0], film.t
    zeros = []
    for i in np.flatnonzero(x[:-1] * x[1:] < 0.0)[:2]:
        there = slice(i - 3, i + 5)
        zeros.append(np.polyval(np.polyfit(x[there], t[there] - t[i], 5), 0.0) + t[i])
    return 2.0 * (zeros[1] - zeros[0])


@pytest.mark.parametrize(
    ("degrees", "period"),
    [(1, 2.006104874), (30, 2.04098989), (90, 2.367841948), (150, 3.535098186)],
)
@pytest.mark.parametrize("method", ["verlet", "rk4"])
def test_the_period_at_large_amplitude(method: str, degrees: int, period: float) -> None:
    """Closed forms 4.1 (Lamb; Whittaker, sec. 44). With k = 1e6 N/m the spring is up to 3 m g / k =
    3e-5 longer, the period up to half of that; Verlet at dt = 1e-4 adds (w dt)^2 / 24 < 1e-8.
    """
    theta = math.radians(degrees)
    assert elliptic_period(theta) == pytest.approx(period, rel=1e-9)
    steps = round(0.85 * period / 1e-4)
    film = pendulum(theta, 1e6, dt=1e-4, steps=steps, method=method)
    assert period_of(film) == pytest.approx(period, rel=2.5e-5)
    # twins: g 0.1 % larger; the small-angle period
    heavier = pendulum(theta, 1e6, dt=1e-4, steps=steps, method=method, gravity=(0, -1.001 * g, 0))
    assert abs(period_of(heavier) / period - 1.0) > 2e-4
    if degrees > 1:
        assert abs(period_of(film) / (2 * math.pi / math.sqrt(g)) - 1.0) > 1e-2


def test_the_tension_at_the_bottom_is_three_weights() -> None:
    """m g (3 cos th - 2 cos th0) = 3 m g at the bottom from 90 degrees (closed forms 4.1); the
    breathing of the spring (it starts unstretched) stays small when it starts at rest sideways.
    """
    film = pendulum(math.pi / 2, 1e5, dt=1e-4, steps=7000, method="rk4")
    lowest = int(np.argmin(film.x[:, 1, 1]))
    tension = film.block.recording.tension
    smooth = tension[lowest - 400 : lowest + 400, 0].mean()
    angle = np.arctan2(film.x[:, 1, 0], -film.x[:, 1, 1])[lowest - 400 : lowest + 400]
    assert smooth == pytest.approx(g * (3 * np.cos(angle)).mean(), rel=2e-3)
    assert abs(smooth / (2 * g) - 1.0) > 0.1


TIPS = {  # closed forms 4.2: L = 1 m, N equal masses on N rigid links, from the horizontal at rest
    (2, 0.5): (0.1675646063, -0.9858610498),
    (2, 1.0): (-0.9761647724, -0.09344773705),
    (5, 0.25): (0.8902667708, -0.3065604042),
    (5, 0.5): (-0.05666454127, -0.9758023266),
    (10, 0.25): (0.8824586694, -0.3065624997),
}


@pytest.mark.parametrize(("n", "time"), TIPS)
def test_chains_of_links_released_from_the_horizontal(n: int, time: float) -> None:
    """Closed forms 4.2 (Lagrange's equations at 1e-13). Springs k = 4e6 N/m on masses of 0.1 kg:
    stretch of order N m g / k; RK4 at w_max dt < 0.7. The error must fall as 1/k.
    """

    def tip(k: float, gravity=DOWN, m: float = 0.1) -> np.ndarray:
        i = np.arange(n + 1) / n
        places = np.stack([i, 0 * i, 0 * i], axis=1)
        dt = time / math.ceil(time / (0.6 * math.sqrt(m / k)))
        steps = round(time / dt)
        rope = chain(places, springs(k, m, 1.0 / n))
        film = run(
            scene(rope, hold(0), dt=dt, steps=steps, every=steps, method="rk4", gravity=gravity)
        )
        return film.x[-1, -1, :2]

    expected = np.array(TIPS[n, time])
    stiff = off(tip(4e6), expected)
    assert stiff < 5e-5
    assert off(tip(1e5), expected) > 8 * stiff
    # twins: gravity upside down; a mass twice as heavy at the tip only is another pendulum
    assert off(tip(4e6, gravity=(0, g, 0)), expected) > 0.1
    assert off(tip(4e6, gravity=(0, -1.01 * g, 0)), expected) > 1e-3


def spun(n: int, form: str, c: float, m: float, length: float, t: float, *, method="verlet", k=1e6):
    """A free straight chain spinning at 60 rad/s about its middle; film with 51 frames."""
    s = length * (np.arange(n + 1) - n / 2)
    places = np.stack([s, 0 * s, 0 * s], axis=1)
    kicks = [{"node": i, "velocity": (0.0, 60.0 * float(s[i]), 0.0)} for i in range(n + 1)]
    rope = chain(places, springs(k, m, length, c, friction=form), kicks=kicks)
    dt = 0.25 * math.sqrt(m / k)
    every = max(1, round(t / dt / 50))
    dt = t / (50 * every)
    return run(scene(rope, dt=dt, steps=50 * every, every=every, method=method))


@pytest.mark.parametrize("method", ["semi-implicit-euler", "verlet"])
def test_axial_friction_keeps_angular_momentum(method: str) -> None:
    """Rigid rotation: central forces make no torque (closed forms 3.6c). These two schemes keep the
    angular momentum of central pair forces exactly (kicks along, drifts keep x cross v): round-off.

    The vector form loses Omega = Omega_0 exp(-c n l^2 t / I): 0.2728859604 after 1 s for 20 springs,
    c 0.5, m 0.01, l 0.05, I = 0.01925 kg m^2 - the scheme's first-order error is c dt / m.
    """
    L = spun(20, "axial", 0.5, 0.01, 0.05, 1.0, method=method).block.recording.angular_momentum
    friction_error = 1e-12 if method == "semi-implicit-euler" else 1e-6
    assert off(L[:, 2] / L[0, 2], 1.0) < friction_error
    assert off(L[:, :2], 0.0) < 1e-15
    assert L[0, 2] == pytest.approx(60 * 0.01925, rel=1e-9)
    film = spun(20, "vector", 0.5, 0.01, 0.05, 1.0, method=method)
    left = film.block.recording.angular_momentum[:, 2] / (60 * 0.01925)
    assert left[-1] == pytest.approx(0.2728859604, rel=0.02)
    assert off(left, np.exp(-0.5 * 20 * 0.0025 * film.t / 0.01925)) < 0.02
    # the twins: the formula without its factor n, and the other form
    assert off(left, np.exp(-0.5 * 0.0025 * film.t / 0.01925)) > 0.1
    assert off(left, 1.0) > 0.1


@pytest.mark.parametrize("method", ALL)
def test_a_spinning_pair_loses_its_spin_to_vector_friction(method: str) -> None:
    """exp(-2 c t / m): 0.1353 after 1 s for c 0.05, m 0.05 (seed document 3.4), simulated 0.1352.

    Claim C6. Only the stretch by spinning (m w^2 l / 2k ~ 1e-6) and (c dt/m)^order remain.
    """
    dt = 2e-5 if method in ("euler", "heun") else 2e-4
    places = np.array([(-0.5, 0, 0), (0.5, 0, 0)])
    kicks = [{"node": 0, "velocity": (0, -0.5, 0)}, {"node": 1, "velocity": (0, 0.5, 0)}]

    def left(c: float, form: str = "vector") -> float:
        rope = chain(places, springs(1e4, 0.05, 1.0, c, friction=form), kicks=kicks)
        steps = round(1 / dt)
        film = run(scene(rope, dt=dt, steps=steps, every=steps, method=method))
        spin = film.block.recording.angular_momentum[:, 2]
        return float(spin[-1] / spin[0])

    first_order = METHODS[method].order == 1
    allowed = 3 * 0.05 / 0.05 * dt if first_order else 1e-5
    assert left(0.05) == pytest.approx(math.exp(-2.0), rel=allowed + 1e-5)
    kept = 5e-5 if first_order else 1e-7
    if method == "implicit-euler":  # (1 + (w dt)^2)^-steps, w = 1 rad/s
        kept = 1.01 * dt
    assert left(0.05, "axial") == pytest.approx(1.0, abs=kept)
    assert abs(left(0.025) - math.exp(-2.0)) > 0.1


@pytest.mark.parametrize(("n", "tip"), [(10, 1.064989479), (20, 1.064741977)])
def test_an_elastic_rope_spinning_about_its_end(n: int, tip: float) -> None:
    """Closed forms 4.7: L 1, EA 500, mu 0.1, w 30 rad/s; tip radius of the chain with half a tip
    mass, and in the continuum tan(qL)/q = 1.064659507. Steady over 3 turns; Verlet's dt^2 error
    moves the balance by (w dt)^2 / 12 of the stretch.
    """
    EA, mu, w = 500.0, 0.1, 30.0

    def film(spin: float):
        length = 1.0 / n
        m = np.full(n + 1, mu * length)
        m[[0, -1]] *= 0.5
        k = EA / length
        # k (r_i - r_(i-1) - l) - k (r_(i+1) - r_i - l) = m_i w^2 r_i, r_0 = 0
        A = np.zeros((n, n))
        right = np.zeros(n)
        for i in range(1, n + 1):
            A[i - 1, i - 1] = (2.0 if i < n else 1.0) * k - m[i] * w * w
            if i > 1:
                A[i - 1, i - 2] = -k
            if i < n:
                A[i - 1, i] = -k
            else:
                right[i - 1] = k * length
        r = np.concatenate([[0.0], np.linalg.solve(A, right)])
        places = np.stack([r, 0 * r, 0 * r], axis=1)
        rope = Rope(
            segments=n,
            length=1.0,
            made_of=Material(EA=EA, mass_per_length=mu),
            shape={"kind": "points", "points": places.tolist()},
            kicks=[{"node": i, "velocity": (0, 0, spin * r[i])} for i in range(1, n + 1)],
        )
        turns = 3 * 2 * math.pi / w
        return r, run(scene(rope, hold(0), dt=turns / 8000, steps=8000, every=80, method="verlet"))

    r, spinning = film(w)
    assert r[-1] == pytest.approx(tip, abs=1e-9)
    radius = np.linalg.norm(spinning.x, axis=2)
    assert off(radius, r) < 3e-6
    assert spinning.x[-1] == pytest.approx(spinning.x[0], abs=3e-5)  # three whole turns
    root = spinning.block.recording.tension[:, 0]
    assert off(root, n * EA * r[1] - EA) < 2e-2
    assert off(np.linalg.norm(film(0.99 * w)[1].x, axis=2), r) > 1e-4  # the twin: 1 % slower
