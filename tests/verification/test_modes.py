"""Normal modes of chains: frequencies from the simulator's own forces, and in time."""

from __future__ import annotations

import math

import numpy as np
import pytest

from ropewalk.scene import Material, Rope, Straight
from ropewalk.simulation import Simulation
from verification.setups import (
    ALL,
    along_x,
    chain,
    forces_at,
    hold,
    mode_history,
    off,
    run,
    scene,
    springs,
)

K, M, L = 1000.0, 0.01, 0.05  # closed forms 1.1: N = 20


def frequencies(simulation: Simulation, axis: int, size: float) -> np.ndarray:
    """Angular frequencies [rad/s] from the simulator's forces.

    Central differences at `size` and half of it, extrapolated (error of order size^4).
    """
    x = simulation.positions.copy()
    mass, free = simulation.arrays.mass, simulation.arrays.inverse_mass > 0.0
    nodes = np.flatnonzero(free)

    def columns(h: float) -> list[np.ndarray]:
        found = []
        for i in nodes:
            there, back = x.copy(), x.copy()
            there[i, axis] += h
            back[i, axis] -= h
            rise = forces_at(simulation, there) - forces_at(simulation, back)
            found.append(-rise[nodes, axis] / (2.0 * h))
        return found

    K = (4.0 * np.array(columns(0.5 * size)) - np.array(columns(size))) / 3.0
    root = np.sqrt(mass[nodes])
    values = np.linalg.eigvalsh(0.5 * (K + K.T) / np.outer(root, root))
    return np.sqrt(np.maximum(values, 0.0))


def straight(masses: int, end: str, *, mass: float = M) -> Simulation:
    """The chains of closed forms 1.1, at rest length along x."""
    free_ends = 2 if end == "free-free" else 1
    nodes = masses + 2 if end == "fixed-fixed" else masses + (0 if free_ends == 2 else 1)
    held = {"fixed-fixed": (0, nodes - 1), "free-free": ()}.get(end, (0,))
    if end == "fixed-free, half":
        made_of = Material(EA=K * L, mass_per_length=mass / L)
        rope = Rope(segments=masses, made_of=made_of, length=masses * L)
    else:
        rope = chain(along_x(L * np.arange(nodes)), springs(K, mass, L))
    return Simulation(scene(rope, hold(*held), dt=1e-3, steps=1))


def theory(masses: int, end: str) -> np.ndarray:
    """2 sqrt(k/m) sin(..) of closed forms 1.1 (Lagrange 1788; Born & von Karman 1912)."""
    j, n = np.arange(1, masses + 1), masses
    angle = {
        "fixed-fixed": j * math.pi / (2 * (n + 1)),
        "fixed-free": (2 * j - 1) * math.pi / (2 * (2 * n + 1)),
        "fixed-free, half": (2 * j - 1) * math.pi / (4 * n),
        "free-free": (j - 1) * math.pi / (2 * n),
    }[end]
    return 2.0 * math.sqrt(K / M) * np.sin(angle)


ENDS = ("fixed-fixed", "fixed-free", "fixed-free, half", "free-free")
PUBLISHED = {  # rad/s, N = 20
    "fixed-fixed": {0: 47.2634611, 1: 94.26260575, 2: 140.7345957, 19: 630.6870581},
    "fixed-free": {0: 24.22477581, 1: 72.53216683, 2: 120.4139102, 19: 630.5997818},
    "fixed-free, half": {0: 24.83008766, 1: 74.33717724, 2: 123.3859534, 19: 631.9679317},
    "free-free": {1: 49.62188913, 2: 98.93784282, 19: 630.5058827},
}


@pytest.mark.parametrize(
    ("end", "masses"),
    [(end, n) for end in ENDS for n in (1, 2, 7, 20) if (end, n) != ("free-free", 1)],
)
def test_longitudinal_frequencies(end: str, masses: int) -> None:
    """Closed forms 1.1, to 1e-9 (rounding of the differences); exact in N."""
    found = frequencies(straight(masses, end), 0, 0.02 * L)
    expected = theory(masses, end)
    low = 1 if end == "free-free" else 0  # the rigid motion has frequency zero, to rounding
    assert off(found[low:] / expected[low:], 1.0) < 1e-9
    if masses == 20:
        for mode, value in PUBLISHED[end].items():
            assert found[mode] == pytest.approx(value, rel=1e-9)
        # twins: the same masses with the ends of every other case; half the mass
        for other in ENDS:
            if other != end:
                assert off(found[low:] / np.maximum(theory(masses, other)[low:], 1.0), 1.0) > 1e-6
        half = frequencies(straight(masses, end, mass=0.5 * M), 0, 0.02 * L)
        assert off(half[low:] / expected[low:], 1.0) > 0.1


@pytest.mark.parametrize("axis", [1, 2])
def test_transverse_frequencies_of_a_taut_chain(axis: int) -> None:
    """w_n = 2 sqrt(T / (m l)) sin(n pi / (2 n_s)) (closed forms 3.1), with k -> T / l.

    L 1 m, mu 0.02 kg/m, T 50 N, EA 5000 N, 50 springs: w_1 157.0537954, w_2 313.9525976, w_5
    782.1723252 rad/s. Differences of transverse forces carry rounding of T / step: 1e-8.
    """

    def taut(tension: float) -> np.ndarray:
        n, length = 50, 1.0 / 50
        rest = length / (1.0 + tension / 5000.0)
        made_of = springs(5000.0 / rest, 0.02 * length, rest)
        rope = chain(along_x(length * np.arange(n + 1)), made_of)
        simulation = Simulation(scene(rope, hold(0, n), dt=1e-3, steps=1))
        return frequencies(simulation, axis, 1e-3 * length)

    w = taut(50.0)
    n = np.arange(1, 50)
    expected = 2.0 * math.sqrt(50.0 / (0.0004 * 0.02)) * np.sin(n * math.pi / 100)
    assert off(w / expected, 1.0) < 1e-8
    assert w[[0, 1, 4]] == pytest.approx([157.0537954, 313.9525976, 782.1723252], rel=1e-8)
    # twins: the continuous string; a force that forgets the rest length (T = k l: 10 times as stiff)
    assert abs(w[4] / 785.3981634 - 1.0) > 1e-3
    assert off(taut(25.0) / expected, 1.0) > 0.1


def start_in_mode(end: str, j: int, size: float, *, n: int = 12) -> tuple[np.ndarray, np.ndarray]:
    """Shape of longitudinal mode j over all nodes and the rest places, for n free masses."""
    if end == "fixed-fixed":
        i = np.arange(n + 2)
        return size * np.sin(math.pi * j * i / (n + 1)), L * i
    i = np.arange(n + 1)
    return size * np.sin((2 * j - 1) * math.pi * i / (2 * n + 1)), L * i


@pytest.mark.parametrize("end", ["fixed-fixed", "fixed-free"])
@pytest.mark.parametrize("method", ALL)
def test_a_mode_evolves_as_the_schemes_matrix_says(method: str, end: str) -> None:
    """Mode j has stiffness k mu_j and friction c mu_j (closed forms 1.3), and follows M^s.

    Straight chain, linear force: rounding only (1e-17 m of 1e-4 m and step, 300 steps -> 1e-10).
    Both forms of friction are the same along a straight chain.
    """
    n, steps, c = 12, 300, 0.2
    dt = 2e-4 if method in ("euler", "heun") else 2e-3
    for j, form in [(1, "vector"), (3, "axial"), (n, "vector")]:
        shape, places = start_in_mode(end, j, 1e-4)
        held = (0, n + 1) if end == "fixed-fixed" else (0,)
        rope = chain(along_x(places + shape), springs(K, M, L, c, friction=form))
        film = run(scene(rope, hold(*held), dt=dt, steps=steps, method=method))
        amplitude = (film.x[:, :, 0] - places) @ shape / (shape @ shape)
        N = n + 1 if end == "fixed-fixed" else n + 0.5
        at = j if end == "fixed-fixed" else j - 0.5
        mu = 4.0 * math.sin(at * math.pi / (2 * N)) ** 2
        expected = mode_history(method, K * mu * dt * dt / M, c * mu * dt / M, steps)
        assert off(amplitude, expected) < 1e-10
        left = film.x[:, :, 0] - places - expected[:, None] * shape
        assert off(left, 0.0) < 1e-14  # nothing leaks into other modes
        # twins: the frequency of the neighbouring mode, and of N springs instead of N + 1
        wrong = 4.0 * math.sin(at * math.pi / (2 * (N - 1))) ** 2
        if j != n:
            other = mode_history(method, K * wrong * dt * dt / M, c * wrong * dt / M, steps)
            assert off(amplitude, other) > 1e-2
        undamped = mode_history(method, K * mu * dt * dt / M, 0.0, steps)
        assert off(amplitude, undamped) > 1e-3


@pytest.mark.parametrize("method", ALL)
def test_a_transverse_mode_of_a_taut_chain_evolves_as_the_matrix_says(method: str) -> None:
    """k -> T / l (closed forms 1.1). Amplitude 1e-6 l: the tension changes by (a/l)^2 EA / T,
    about 1e-11 of itself, so that 200 steps stay within 1e-8.
    """
    n, steps, size = 10, 200, 1e-6 * L
    rest, tension = 0.8 * L, K * 0.2 * L
    dt = 2e-4 if method in ("euler", "heun") else 2e-3

    def swing(form_mass: float = M) -> np.ndarray:
        i = np.arange(n + 2)
        shape = np.sin(2 * math.pi * i / (n + 1))
        points = along_x(L * i)
        points[:, 2] = size * shape
        rope = chain(points, springs(K, form_mass, rest))
        film = run(scene(rope, hold(0, n + 1), dt=dt, steps=steps, method=method))
        return film.x[:, :, 2] @ shape / (shape @ shape) / size

    mu = 4.0 * math.sin(2 * math.pi / (2 * (n + 1))) ** 2
    expected = mode_history(method, tension / L * mu * dt * dt / M, 0.0, steps)
    assert off(swing(), expected) < 1e-8
    assert off(swing(0.9 * M), expected) > 1e-3  # the twin: lighter masses
    without_rest_length = mode_history(method, K * mu * dt * dt / M, 0.0, steps)
    assert off(swing(), without_rest_length) > 1e-2  # the twin: k in place of T / l


def test_the_magic_time_step() -> None:
    """At dt sqrt(k/m) = 1 the dispersions of lattice and leapfrog cancel: a pulse on 41 springs is
    its own inverted mirror image after 41 steps (closed forms 1.4). The twin steps 1 % shorter.
    """

    def pulse(courant: float) -> tuple[np.ndarray, np.ndarray]:
        i = np.arange(42)
        shape = 1e-4 * np.exp(-(((i - 14.0) / 2.0) ** 2))
        shape[[0, -1]] = 0.0
        rope = chain(along_x(L * i + shape), springs(K, M, L))
        dt = courant * math.sqrt(M / K)
        film = run(scene(rope, hold(0, 41), dt=dt, steps=41, method="verlet"))
        return shape, film.x[-1, :, 0] - L * i

    shape, later = pulse(1.0)
    assert off(later, -shape[::-1]) < 1e-12
    shape, later = pulse(0.99)
    assert off(later, -shape[::-1]) > 1e-7


def test_a_standing_wave_needs_the_mass_of_its_material() -> None:
    """Half masses at the ends of a material (closed forms, traps): free-free w_1 of the rod,
    pi/L sqrt(EA/mu), is met as N^-2; with whole end masses only as 1/N (the twin).
    """
    rod = math.pi * math.sqrt(K * L / (M / L)) / 1.0

    def error(n: int, material: bool) -> float:
        length = 1.0 / n
        if material:
            made_of = Material(EA=K * L, mass_per_length=M / L)
            rope = Rope(segments=n, made_of=made_of, length=1.0, shape=Straight())
        else:
            rope = chain(
                along_x(length * np.arange(n + 1)), springs(K * L / length, M / L * length, length)
            )
        found = frequencies(Simulation(scene(rope, dt=1e-3, steps=1)), 0, 0.02 * length)
        return abs(found[1] / rod - 1.0)

    assert math.log2(error(10, True) / error(20, True)) == pytest.approx(2.0, abs=0.05)
    assert math.log2(error(10, False) / error(20, False)) == pytest.approx(1.0, abs=0.2)
