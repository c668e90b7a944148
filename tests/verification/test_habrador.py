"""Habrador's three ropes, the presets H1 to H3: the tutorial's numbers, and what theory adds to them."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from ropewalk.lowering.chains import chains
from ropewalk.methods.bound import largest_step
from ropewalk.scene import Scene
from ropewalk.scene.presets import preset
from verification.setups import along_x, chain, g, hold, off, run, scene, springs
from verification.test_seeds import exact


def tutorial(steps: int, dt: float = 0.02) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """H1 as the tutorial steps it: Heun, then lengths forced into 90..110 %, top down, lower node only.

    Returns positions and velocities (7, 3) and masses; an implementation of its own.
    """
    x, v, m = np.zeros((7, 3)), np.zeros((7, 3)), np.full(7, 0.2)
    x[:, 1] = np.arange(7) - 6.0
    m[0] += 1.0

    def acceleration(x: np.ndarray, v: np.ndarray) -> np.ndarray:
        force = -0.05 * np.linalg.norm(v, axis=1)[:, None] * v
        force[:, 1] -= g * m
        s = np.diff(x, axis=0)
        r = np.linalg.norm(s, axis=1)[:, None]
        rate = np.sum(np.diff(v, axis=0) * s / r, axis=1)[:, None]
        pull = (40.0 * (r - 1.0) + 2.0 * rate) * s / r
        force[:-1] += pull
        force[1:] -= pull
        force[-1] = 0.0
        return force / m[:, None]

    for _ in range(steps):
        a = acceleration(x, v)
        ahead = v + dt * a
        b = acceleration(x + dt * v, ahead)
        x, v = x + 0.5 * dt * (v + ahead), v + 0.5 * dt * (a + b)
        for _ in range(2):
            for i in range(6, 0, -1):
                s = x[i] - x[i - 1]
                r = np.linalg.norm(s)
                x[i - 1] += (r - np.clip(r, 0.9, 1.1)) / r * s
    return x, v, m


def test_h1_hangs_still_on_its_limiter() -> None:
    """Seed document 2.1: every section rests at 1.10, and the bottom node moves at -9.1 m/s, the next
    at -7.6, -6.5, -5.4, -4.1, -2.4, 65 J in all, for a rope that hangs still. Ours rests at the same
    places without motion, and the support carries all the weight; the tutorial's own step is the twin.
    """
    x, v, m = tutorial(500)
    assert v[:, 1] == pytest.approx([-9.1, -7.6, -6.5, -5.4, -4.1, -2.4, 0.0], abs=0.05)
    assert 0.5 * m @ (v**2).sum(axis=1) == pytest.approx(65.0, abs=0.05)
    film = run(preset("h1"))
    assert off(film.x[-1], x) < 1e-9
    assert off(film.x[-1, :, 1], 1.1 * (np.arange(7) - 6.0)) < 1e-9
    assert off(film.v[-1], 0.0) < 1e-9
    assert film.block.recording.energy[-1, 0] < 1e-15
    # the seventh mass, at the support, is carried too; within a step each node falls at up to g dt
    drag = 6 * 0.05 * (g * 0.02) ** 2
    assert film.block.recording.reaction[-1, 0] == pytest.approx([0, 2.4 * g, 0], abs=drag)


def test_h1_without_the_limiter_stretches_to_the_springs_own_lengths() -> None:
    """1 + 1.2 g / 40 = 1.29 at the bottom and 1 + 2.2 g / 40 = 1.54 at the top (seed document 2.1);
    the slowest mode, about 2.5 rad/s with zeta = w d / (2 k) = 0.06, is at exp(-9) after a minute.
    """
    made = preset("h1").replace(limiter=None)
    film = run(made.replace(run=made.run.replace(duration=60.0)))
    stretch = np.diff(film.x[-1, :, 1])
    assert stretch == pytest.approx(1 + (1.2 + 0.2 * np.arange(6)) * g / 40.0, abs=1e-3)
    assert stretch[[0, -1]] == pytest.approx([1.29, 1.54], abs=6e-3)
    assert off(stretch, 1.1) > 0.15  # the twin rests on its limiter


@pytest.mark.parametrize(("method", "limit"), [("euler", 100.0), ("heun", 307.0)])
def test_h1_limits_of_the_spring_constant(method: str, limit: float) -> None:
    """Without load: forward Euler k < d / dt = 100, Heun k < about 307, for d 2, m 0.2, dt 0.02 (seed
    document 2.1): the step matrix of the stiffest of the modes says so, and runs 3 % below and above.
    """

    def made(k: float, steps: int = 20000) -> Scene:
        x = np.arange(7.0)
        x[1:] += 1e-6 * np.random.default_rng(7).normal(size=6)
        rope = chain(along_x(x), springs(k, 0.2, 1.0, 2.0, friction="axial"))
        return scene(rope, hold(0), dt=0.02, steps=steps, every=min(steps, 100), method=method)

    def bound(k: float) -> float:
        simulation = run(made(k, 1)).simulation
        found = chains(simulation.system, simulation.arrays)["in the air"]
        return largest_step(method, found._replace(sideways=False))

    low, high = 0.5 * limit, 2.0 * limit
    for _ in range(40):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if bound(middle) > 0.02 else (low, middle)
    long_chain = 4.0 * math.sin(11 * math.pi / 26) ** 2 / 4.0  # mu of 6 masses over that of many
    assert low == pytest.approx(limit, rel=0.002 if method == "euler" else 1.05 - long_chain)

    def swing(k: float) -> float:
        film = run(made(k), ok=False)
        return math.inf if film.block.status else float(np.abs(film.v[1:]).max() / 1e-6)

    assert swing(0.97 * low) < 1e3
    assert swing(1.03 * low) > 1e4


def links(n: int, length: float, times: list[float]) -> np.ndarray:
    """Tip (x, y) of n links released from the horizontal, in numbers: Lagrange's equations

    sum_j a_ij cos(th_i - th_j) th_j'' = - sum_j a_ij sin(th_i - th_j) th_j'^2 - (g/l) b_i sin th_i,
    a_ij = n - max(i, j), b_i = n - i (closed forms 4.2), by DOP853 at 1e-12.
    """
    i = np.arange(n)
    a, b = n - np.maximum.outer(i, i), n - i

    def rate(_: float, y: np.ndarray) -> np.ndarray:
        angle, speed = y[:n], y[n:]
        apart = angle[:, None] - angle
        right = -(a * np.sin(apart)) @ speed**2 - g / length * b * np.sin(angle)
        return np.concatenate([speed, np.linalg.solve(a * np.cos(apart), right)])

    start = np.concatenate([np.full(n, math.pi / 2), np.zeros(n)])
    found = solve_ivp(
        rate, (0, times[-1]), start, method="DOP853", rtol=1e-12, atol=1e-12, t_eval=times
    )
    angle = found.y[:n]
    return length * np.stack([np.sin(angle).sum(axis=0), -np.cos(angle).sum(axis=0)], axis=1)


def test_h2_keeps_its_lengths_and_falls_as_links_do() -> None:
    """Sections of 0.5 m, restored exactly in every step (seed document 2.2), with g dt^2 a step and not
    g dt, which would be 50 times as much. Released from the horizontal the rope is a chain of 14 links:
    the tip comes within first order in the step of Lagrange's equations. Twin: gravity 50 times.
    """
    assert links(2, 0.5, [0.5, 1.0])[0] == pytest.approx([0.1675646063, -0.9858610498], abs=1e-8)
    film = run(preset("h2"))
    assert off(np.linalg.norm(np.diff(film.x, axis=1), axis=2), 0.5) < 1e-12
    times = [0.5, 1.0, 1.2]
    expected = links(14, 0.5, times)

    def errors(dt: float, **changes) -> np.ndarray:
        tip = run(exact("h2", dt, 1.2, **changes)).x[[round(t / dt) for t in times], 14, :2]
        return np.linalg.norm(tip - expected, axis=1)

    coarse, middle, fine = errors(0.01), errors(0.005), errors(0.0025)
    assert middle / fine == pytest.approx(2.0, rel=0.1)
    assert coarse / middle == pytest.approx(2.0, rel=0.15)
    assert (errors(0.02)[:2] < 0.02).all()  # the tutorial's step, up to a second
    assert errors(0.0025, gravity=(0.0, -50 * g, 0.0)).min() > 1.0


def spring_constant(length: float) -> float:
    """(wire mass + load) g / 1 cm, wire 7750 kg/m^3 with a radius of 2 cm, load 100 kg (tutorial)."""
    return (7750.0 * math.pi * 0.02**2 * length + 100.0) * 9.81 / 0.01


def test_h3_stretches_by_a_centimetre() -> None:
    """k = 107 654 N/m for 1 m, 145 869 for 5 m (the source: about 146 000) and 289 178 for 20 m (seed
    document 2.3), chosen for a static stretch of 1 cm. The damper, 0.8 k, lets it creep there at
    k / c = 1.25 1/s. Twin: the spring of 5 m of wire.
    """
    for length, k in [(1.0, 107654.0), (5.0, 145869.0), (20.0, 289178.0)]:
        assert spring_constant(length) == pytest.approx(k, abs=0.6)
    made = preset("h3")
    rope = made.ropes[0]
    assert rope.made_of.spring_constant == pytest.approx(spring_constant(1.0), abs=0.6)

    def stretch(scene: Scene) -> float:
        winch = scene.winches[0].replace(start=9.0)
        film = run(scene.replace(winches=[winch], run=scene.run.replace(duration=8.0)))
        assert film.x[25, -1, 1] + 1.0 == pytest.approx(
            (film.x[-1, -1, 1] + 1.0) * (1 - math.exp(-1.25 * 0.5)), rel=0.01
        )
        return float(-1.0 - film.x[-1, -1, 1])

    # 0.02 kg of rounding in the wire's mass of 9.739 kg, and exp(-10)
    assert stretch(made) == pytest.approx(0.01, rel=1e-4)
    stiffer = rope.made_of.replace(
        spring_constant=spring_constant(5.0), spring_friction=0.8 * spring_constant(5.0)
    )
    assert abs(stretch(made.replace(ropes=[rope.replace(made_of=stiffer)])) - 0.01) > 1e-3


def test_h3_pays_out_from_1_to_20_metres() -> None:
    """2 m/s from 0.5 s on: L = 1 + 2 (t - 0.5) until 20 m are out at 10 s (seed document 2.3), and a
    load that comes down at 2 m/s and the creep of what is out. Twins: stopped before, reeled in.
    """
    film = run(preset("h3"))
    out = film.block.recording.rest_length.sum(axis=1)
    assert off(out, np.clip(1.0 + 2.0 * (film.t - 0.5), 1.0, 20.0)) < 1e-9
    at = (film.t > 3.0) & (film.t < 9.9)
    speed = -np.polyfit(film.t[at], film.x[at, -1, 1], 1)[0]
    strain = 0.01 * (100 + 9.739 * 20) / (100 + 9.739)  # at most, at the drum
    assert 2.0 < speed < 2.0 * (1 + strain)
    weight = film.simulation.arrays.mass.sum() * g
    assert film.simulation.arrays.mass.sum() == pytest.approx(100 + 9.739 * (20 + 1), rel=1e-9)
    # still creeping: what is missing is the damper's share of the last metre's strain rate
    assert film.block.recording.reaction[-1, 0, 1] == pytest.approx(weight, rel=2e-3)
    assert film.residual()[-1] == pytest.approx(0.0, abs=1e-7)
    made = preset("h3")
    short = run(made.replace(winches=[made.winches[0].replace(max_length=15.0)]))
    assert off(short.block.recording.rest_length.sum(axis=1), out) > 4.9
