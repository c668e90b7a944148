"""What damps what, and how fast: spring friction in both forms, air."""

from __future__ import annotations

import math

import numpy as np
import pytest

from ropewalk.scene import Air, Rope, Straight
from verification.setups import (
    ALL,
    DOWN,
    along_x,
    chain,
    hold,
    mode_history,
    off,
    run,
    scene,
    springs,
)

K, M, L = 1000.0, 0.01, 0.05


def transverse(
    form: str, c: float, j: int, *, dt: float, steps: int, n: int = 19, method: str = "verlet"
) -> np.ndarray:
    """Amplitude of transverse mode j of a taut chain of n free masses, after every step."""
    i = np.arange(n + 2)
    shape = np.sin(j * math.pi * i / (n + 1))
    points = along_x(L * i)
    points[:, 1] = 1e-4 * L * shape
    rope = chain(points, springs(K, M, 0.8 * L, c, friction=form))
    film = run(scene(rope, hold(0, n + 1), dt=dt, steps=steps, method=method))
    return film.x[:, :, 1] @ shape / (shape @ shape) / (1e-4 * L)


def mu_of(j: int, n: int = 19) -> float:
    return 4.0 * math.sin(j * math.pi / (2 * (n + 1))) ** 2


def decay_rate(x: np.ndarray, dt: float) -> float:
    """Rate [1/s] of a decaying cosine sampled every dt, from its recurrence."""
    matrix = np.stack([x[1:-1], x[:-2]], axis=1)
    minus_det = np.linalg.lstsq(matrix, x[2:], rcond=None)[0][1]
    return -0.5 * math.log(-minus_det) / dt


@pytest.mark.parametrize("j", [1, 2, 5, 19])
def test_vector_friction_damps_transverse_modes(j: int) -> None:
    """tau_j = 2 m / (c mu_j), mu_j = 4 sin^2(j pi / (2 (n + 1))) (seed document 3.4).

    The method's own error in a decay rate is (omega dt)^2, at most 2e-2 here; the scheme's own
    history is met to 1e-6: amplitude 1e-4 l changes the tension by 1e-8 EA / T times the phase.
    """
    dt, c = 2e-4, 0.05
    x = transverse("vector", c, j, dt=dt, steps=400)
    a = 0.2 * K * mu_of(j) * dt * dt / M
    assert off(x, mode_history("verlet", a, c * mu_of(j) * dt / M, 400)) < 1e-5
    rate = c * mu_of(j) / (2 * M)
    assert decay_rate(x, dt) == pytest.approx(rate, rel=2e-3 + a + c * mu_of(j) * dt / M)
    # twins: half the friction decays half as fast (claim C7); no friction at all
    half = decay_rate(transverse("vector", 0.5 * c, j, dt=dt, steps=400), dt)
    assert half == pytest.approx(0.5 * rate, rel=2e-2)
    assert abs(decay_rate(transverse("vector", 0.0, j, dt=dt, steps=400), dt)) < 1e-3 * rate


@pytest.mark.parametrize("j", [1, 3, 19])
def test_axial_friction_damps_no_transverse_mode(j: int) -> None:
    """dl/dt is of second order in the amplitude (closed forms 3.6b): < 1e-6 per cycle at 1e-4.

    The twin is the vector form, which is seen at once.
    """
    period = 2 * math.pi / math.sqrt(0.2 * K * mu_of(j) / M)
    dt = min(2e-4, period / 40)
    steps = round(5 * period / dt)

    def loss(form: str) -> float:
        x = transverse(form, 0.5, j, dt=dt, steps=steps)
        return decay_rate(x, dt) * period

    assert abs(loss("axial")) < 1e-6
    assert loss("vector") > 1e-2


def test_axial_friction_damps_longitudinal_modes() -> None:
    """zeta_j = c w_j / (2 k): amplitude ratio after 10 cycles 0.683499833 at zeta_1 = 0.006056193954
    (closed forms 3.6a; N 20, m 0.01, k 1000, c 0.5, fixed-free). RK4 at omega dt = 0.005: 1e-8.
    """
    n = 20
    w = 2 * math.sqrt(K / M) * math.sin(math.pi / (2 * (2 * n + 1)))
    zeta = 0.5 * w / (2 * K)
    assert zeta == pytest.approx(0.006056193954, rel=1e-9)
    wd = w * math.sqrt(1 - zeta**2)
    steps = 8000
    dt = 10 * (2 * math.pi / wd) / steps

    def ratio(c: float) -> float:
        i = np.arange(n + 1)
        shape = np.sin(math.pi * i / (2 * n + 1))
        rope = chain(along_x(L * i + 1e-3 * L * shape), springs(K, M, L, c, friction="axial"))
        # start with the velocity of the mode itself, exp(-zeta w t) cos(wd t)
        rope = rope.replace(
            kicks=[
                {"node": int(k), "velocity": (-zeta * w * 1e-3 * L * shape[k], 0, 0)} for k in i[1:]
            ]
        )
        film = run(scene(rope, hold(0), dt=dt, steps=steps, every=steps, method="rk4"))
        return float((film.x[-1, :, 0] - L * i) @ shape / (shape @ shape) / (1e-3 * L))

    assert ratio(0.5) == pytest.approx(0.683499833, abs=1e-7)
    assert abs(ratio(0.25) - 0.683499833) > 0.1


@pytest.mark.parametrize("method", ALL)
def test_air_damps_every_mode_alike(method: str) -> None:
    """exp(-b t / 2m), w_d = sqrt(w^2 - (b/2m)^2) whatever the mode (closed forms 3.7): 0.2 1/s for
    b 0.02, m 0.05. Compared with the scheme's own decay, then with the formula to (w dt)^order.
    """
    k, m, b, n = 100.0, 0.05, 0.02, 9
    dt, steps = (5e-6 if method == "euler" else 1e-3), 1000
    for j in (1, 4, 9):
        mu = 4.0 * math.sin(j * math.pi / (2 * (n + 1))) ** 2
        i = np.arange(n + 2)
        shape = np.sin(j * math.pi * i / (n + 1))
        rope = chain(along_x(i + 1e-3 * shape), springs(k, m, 1.0))

        def decay(drag: float, rope: Rope = rope, shape: np.ndarray = shape) -> np.ndarray:
            air = Air(node_drag=drag)
            film = run(scene(rope, hold(0, n + 1), dt=dt, steps=steps, method=method, air=air))
            return (
                (film.x[:, :, 0] - film.x[0, :, 0] + 1e-3 * shape) @ shape / (shape @ shape) / 1e-3
            )

        x = decay(b)
        own = mode_history(method, k * mu * dt * dt / m, b * dt / m, steps)
        assert off(x, own) < 1e-9
        if method in ("verlet", "rk4", "semi-implicit-euler"):
            # the method's own: semi-implicit log(1 - b dt/m) / 2, Verlet (w dt)^2, RK4 (w dt)^4
            w = math.sqrt(k * mu / m)
            allowed = {"rk4": 2e-5, "verlet": w * w * dt * dt}.get(method, b * dt / m)
            assert decay_rate(x, dt) == pytest.approx(0.2, rel=allowed + 1e-3 * allowed)
            assert decay_rate(decay(2 * b), dt) == pytest.approx(0.4, rel=0.02)  # the twin
        assert off(decay(0.0), own) > 1e-4 * (dt / 1e-3)


def test_terminal_speed() -> None:
    """m g / b (closed forms 3.7): NeHe's rope 24.5 m/s; quadratic sqrt(m g / a). exp(-b t / m) left."""

    def speed(air: Air, m: float = 0.05) -> float:
        rope = Rope(segments=3, made_of=springs(100.0, m, 0.1), shape=Straight())
        film = run(scene(rope, dt=5e-3, steps=16000, every=16000, gravity=DOWN, air=air))
        return float(-film.v[-1, 0, 1])

    assert speed(Air(node_drag=0.02)) == pytest.approx(0.05 * 9.81 / 0.02, rel=1e-10)
    assert speed(Air(node_drag=0.02)) == pytest.approx(24.5, abs=0.03)
    quadratic = speed(Air(node_drag_quadratic=0.01))
    assert quadratic == pytest.approx(math.sqrt(0.05 * 9.81 / 0.01), rel=1e-10)
    # twins: half the mass, and each law by the other's formula
    assert abs(speed(Air(node_drag=0.02), 0.025) / 24.525 - 1.0) > 0.1
    assert abs(quadratic / (0.05 * 9.81 / 0.01) - 1.0) > 0.1
