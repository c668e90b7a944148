"""One mass on a spring (claim C1): the scheme's own frequency, decay and sag."""

from __future__ import annotations

import math

import numpy as np
import pytest

from verification.setups import (
    ALL,
    DOWN,
    EXPLICIT,
    SYMPLECTIC,
    along_x,
    chain,
    g,
    hold,
    mode_history,
    off,
    run,
    scene,
    springs,
    step_matrix,
)

K, M, C = 1e4, 0.05, 0.05  # the report's
STEPS = 400


def vibrate(method: str, dt: float, *, k: float = K, m: float = M, c: float = C) -> np.ndarray:
    """Amplitudes along x after every step, in units of the first (1e-3 of the rest length 1 m)."""
    rope = chain(along_x([0.0, 1.001]), springs(k, m, 1.0, c))
    film = run(scene(rope, hold(0), dt=dt, steps=STEPS, method=method))
    return (film.x[:, 1, 0] - 1.0) / 1e-3


def step_of(method: str) -> float:
    return 2e-5 if method in ("euler", "heun") else 2e-3


@pytest.mark.parametrize("method", ALL)
def test_vibration_follows_the_schemes_own_matrix(method: str) -> None:
    """x_s = M^s x_0, M of k dt^2 / m and c dt / m (seed document 3.3; closed forms 1.2, 1.4).

    Along the spring the force is linear, so only rounding is left: 1e-16 m per 1e-3 m and step.
    """
    dt = step_of(method)
    exact = mode_history(method, K * dt * dt / M, C * dt / M, STEPS)
    assert off(vibrate(method, dt), exact) < 1e-10
    # twins: half the mass, no friction, 1 % of stiffness, and every other scheme
    assert off(vibrate(method, dt, m=0.5 * M), exact) > 1e-3
    assert off(vibrate(method, dt, c=0.0), exact) > 1e-3
    assert off(vibrate(method, dt, k=1.01 * K), exact) > 1e-3
    for other in ALL:
        if other != method and dt > 1e-4:
            assert (
                off(vibrate(method, dt), mode_history(other, K * dt * dt / M, C * dt / M, STEPS))
                > 0.1
            )


def fitted(x: np.ndarray) -> tuple[float, float]:
    """Angle [rad] and factor per step of x_s = A r^s cos(s theta + phi), by its recurrence."""
    matrix = np.stack([x[1:-1], x[:-2]], axis=1)
    trace, minus_det = np.linalg.lstsq(matrix, x[2:], rcond=None)[0]
    factor = math.sqrt(-minus_det)
    return math.acos(trace / (2.0 * factor)), factor


def test_the_reports_own_frequency_and_decay() -> None:
    """C1: cos(omega_d dt) = (1 - a/2 - b/2) / sqrt(1 - b), amplitude factor sqrt(1 - c dt / m).

    omega 447.21 rad/s becomes the scheme's 463.65 at dt = 2 ms (463.65 is for c -> 0: 1e-3 apart).
    """
    dt = 2e-3
    angle, factor = fitted(vibrate("semi-implicit-euler", dt))
    a, b = K * dt * dt / M, C * dt / M
    assert math.sqrt(K / M) == pytest.approx(447.21, abs=5e-3)
    assert angle == pytest.approx(math.acos((1 - a / 2 - b / 2) / math.sqrt(1 - b)), abs=1e-9)
    assert angle / dt == pytest.approx(463.65, rel=2e-3)
    assert factor == pytest.approx(0.998999, abs=5e-7)
    assert factor == pytest.approx(math.sqrt(1 - b), abs=1e-9)
    # the twins: the continuous frequency and decay are not what the scheme has
    assert abs(angle / dt - 447.21) > 10.0
    assert abs(factor - math.exp(-0.5 * b)) > 1e-7
    assert abs(fitted(vibrate("semi-implicit-euler", dt, c=2 * C))[1] - math.sqrt(1 - b)) > 1e-4


@pytest.mark.parametrize("y", [0.1, 0.5])
@pytest.mark.parametrize("method", EXPLICIT)
def test_undamped_frequency_and_growth(method: str, y: float) -> None:
    """Closed forms 1.4, y = omega dt: leapfrog sin(theta/2) = y/2, no growth; explicit Euler
    atan y, (1 + y^2)^(1/2); Heun atan(y / (1 - y^2/2)), (1 + y^4/4)^(1/2); RK4 from 1 + iy - ...
    Rounding only.
    """
    dt = y / math.sqrt(K / M)
    rope = chain(along_x([0.0, 1.001]), springs(K, M, 1.0))
    film = run(scene(rope, hold(0), dt=dt, steps=30, method=method), keep_going=True)
    angle, factor = fitted(film.x[:, 1, 0] - 1.0)
    z = 1 + 1j * y - y**2 / 2 - 1j * y**3 / 6 + y**4 / 24
    theory = {
        "euler": (math.atan(y), math.sqrt(1 + y * y)),
        "heun": (math.atan2(y, 1 - y * y / 2), math.sqrt(1 + y**4 / 4)),
        "rk4": (float(np.angle(z)), abs(z)),
    }.get(method, (2 * math.asin(y / 2), 1.0))
    assert angle == pytest.approx(theory[0], abs=1e-9)
    assert factor == pytest.approx(theory[1], abs=1e-9)
    wrong = {"rk4": (y, 1.0), "heun": (math.atan(y), 1.0)}.get(method, (y, math.exp(-y)))
    assert abs(angle - wrong[0]) > 3e-9
    assert abs(factor - wrong[1]) > 3e-9


def test_published_period_ratios() -> None:
    """Closed forms 1.4: T~/T leapfrog 0.9995830378 (y 0.1), 0.9893927005 (0.5), RK4 1.000475355 (0.5)."""
    for y, method, ratio in [
        (0.1, "verlet", 0.9995830378),
        (0.5, "semi-implicit-euler", 0.9893927005),
        (0.5, "rk4", 1.000475355),
    ]:
        dt = y / math.sqrt(K / M)
        rope = chain(along_x([0.0, 1.001]), springs(K, M, 1.0))
        film = run(scene(rope, hold(0), dt=dt, steps=30, method=method))
        angle, _ = fitted(film.x[:, 1, 0] - 1.0)
        assert y / angle == pytest.approx(ratio, abs=1e-9)
        assert abs(y / angle - 1.0) > 1e-4  # the twin: without the scheme's phase error


@pytest.mark.parametrize("method", [*SYMPLECTIC, "rk4"])
def test_static_stretch(method: str) -> None:
    """C1: m g / k = 49.05 um, where the mass comes to rest; exact for every scheme at rest."""

    def sag(mass: float) -> float:
        rope = chain(np.array([[0, 0, 0], [0, -1.0, 0]]), springs(K, mass, 1.0, 20.0))
        film = run(
            scene(rope, hold(0), dt=5e-4, steps=2000, every=2000, method=method, gravity=DOWN)
        )
        return -1.0 - film.x[-1, 1, 1]

    assert sag(M) == pytest.approx(M * g / K, rel=1e-9)
    assert sag(M) == pytest.approx(49.05e-6, rel=1e-9)
    assert abs(sag(0.5 * M) - 49.05e-6) > 1e-5  # the twin: half the mass


def test_the_step_matrices_have_the_published_characteristic_polynomials() -> None:
    """Seed document 3.3: lambda^2 - (2 - a - b) lambda + (1 - b); the twin has b on the other side."""
    a, b = 0.8, 0.002
    assert off(np.poly(step_matrix("semi-implicit-euler", a, b)), [1, -(2 - a - b), 1 - b]) < 1e-14
    assert off(np.poly(step_matrix("semi-implicit-euler", a, -b)), [1, -(2 - a - b), 1 - b]) > 1e-3
