"""Single laws by hand: ground, air, wind, limiter, tension-only, loads, kicks, applied forces."""

from __future__ import annotations

import math

import numpy as np
import pytest

from ropewalk.scene import Air, Anchor, Ground, Limiter, Rope, Straight, Velocity
from ropewalk.simulation import Simulation
from verification.setups import (
    ALL,
    DOWN,
    EXPLICIT,
    NO_GRAVITY,
    along_x,
    chain,
    forces_at,
    g,
    hold,
    off,
    run,
    scene,
    springs,
)


def pair(at, velocity, *, k: float = 10.0, c: float = 0.0, **more) -> np.ndarray:
    """Forces on two nodes, the first at the origin at rest, the second at `at` with `velocity`."""
    made_of = more.pop("made_of", springs(k, 1.0, 1.0, c, friction=more.pop("form", "vector")))
    rope = chain(np.array([(0, 0, 0), (1, 0, 0)]), made_of, diameter=0.02)
    simulation = Simulation(scene(rope, dt=1e-3, steps=1, **more))
    x = np.array([(0, 0, 0), at], dtype=float)
    return forces_at(simulation, x, np.array([(0, 0, 0), velocity], dtype=float))


def test_spring_friction_in_both_forms() -> None:
    """Vector: -c (v1 - v2) whole; axial: its part along the segment (seed document 1.2, 2.1)."""
    at, v = (0.6, 0.8, 0.0), (1.0, 2.0, 3.0)
    vector = pair(at, v, c=0.5)
    assert off(vector[0], 0.5 * np.array(v)) < 1e-15
    axial = pair(at, v, c=0.5, form="axial")
    along = 0.5 * (0.6 * 1 + 0.8 * 2) * np.array(at)
    assert off(axial[0], along) < 1e-15
    for forces in (vector, axial):
        assert off(forces.sum(axis=0), 0.0) < 1e-15
    assert off(vector[0], along) > 0.1  # the twin: each form by the other's formula


def test_hooke_and_tension_only() -> None:
    """F = k (r - L) along the segment; a tension-only segment neither pushes nor rubs when short."""
    assert off(pair((0, 1.5, 0), (0, 0, 0))[0], [0, 5.0, 0]) < 1e-15
    assert off(pair((0, 0.4, 0), (0, 0, 0))[0], [0, -6.0, 0]) < 1e-15
    rope = springs(10.0, 1.0, 1.0, 0.5, tension_only=True)
    assert off(pair((0, 1.5, 0), (0, 0, 0), made_of=rope)[0], [0, 5.0, 0]) < 1e-15
    assert off(pair((0, 0.4, 0), (3, 2, 1), made_of=rope), 0.0) == 0.0
    assert off(pair((0, 0.4, 0), (3, 2, 1), c=0.5), 0.0) > 1.0  # the twin: a spring


@pytest.mark.parametrize("method", ALL)
def test_a_slack_segment_flies_freely(method: str) -> None:
    """A tension-only rope thrown together: straight flight at constant speed until it is taut."""

    def film(tension_only: bool):
        made_of = springs(100.0, 1.0, 1.0, 0.3, tension_only=tension_only)
        rope = chain(along_x([0, 0.5]), made_of, kicks=[{"node": 1, "velocity": (1.0, 0, 0)}])
        return run(scene(rope, hold(0), dt=1e-3, steps=900, method=method))

    x = film(True).x[:, 1, 0]
    assert off(x[:490], 0.5 + 1e-3 * np.arange(490)) < 1e-12
    assert x.max() < 1.2  # then it is held
    assert off(film(False).x[:490, 1, 0], 0.5 + 1e-3 * np.arange(490)) > 0.1


def test_ground_forces_by_hand() -> None:
    """NeHe lesson 40 (seed document 1.2), height -1.5 m, up y: repulsion 100 N/m times depth; slide
    friction -0.2 (vx, 0, vz) whatever the depth; absorption -2 vy only while sinking.
    """
    ground = Ground(height=-1.5)

    def force(y: float, v: tuple[float, float, float], gravity=DOWN) -> np.ndarray:
        return pair((0, y, 0), v, k=1e-9, gravity=gravity, ground=ground)[1] - np.array(gravity)

    sinking = force(-1.51, (3.0, -2.0, 1.0))
    assert off(sinking, [-0.6, 100 * 0.01 + 2 * 2.0, -0.2]) < 1e-8
    rising = force(-1.51, (3.0, 2.0, 1.0))
    assert off(rising, [-0.6, 1.0, -0.2]) < 1e-8
    assert off(force(-1.5, (3.0, -2.0, 1.0)), 0.0) < 1e-8  # strictly below only
    # twins: absorption on the way out too, and friction in proportion to the load (Coulomb)
    assert abs(rising[1] - (1.0 - 2 * 2.0)) > 1.0
    assert abs(force(-1.6, (3.0, 0.0, 0.0))[0] / force(-1.51, (3.0, 0.0, 0.0))[0] - 1.0) < 1e-7
    # up follows gravity: along z it is z that counts
    up_z = pair((0, 0, -1.6), (1, 0, 0), k=1e-9, gravity=(0, 0, -g), ground=ground)[1]
    assert off(up_z, [-0.2, 0, 10.0 - g]) < 1e-8


def test_the_depth_at_rest_on_the_ground() -> None:
    """m g / k_g = 4.905 mm for NeHe's masses (seed document 1.2)."""

    def depth(m: float) -> float:
        rope = Rope(
            segments=3, made_of=springs(100.0, m, 0.1, 0.1), shape=Straight(start=(0, 0, 0))
        )
        film = run(scene(rope, dt=1e-3, steps=8000, every=8000, gravity=DOWN, ground=Ground()))
        assert off(film.v[-1], 0.0) < 1e-9
        return float(-film.x[-1, 0, 1])

    assert depth(0.05) == pytest.approx(4.905e-3, rel=1e-6)
    assert abs(depth(0.1) - 4.905e-3) > 1e-3


def test_quadratic_drag_by_hand() -> None:
    """Per node -a |v - w| (v - w) (Habrador). Per segment, u at its middle relative to the wind:
    -rho d/2 (Cn |un| un + pi Ct |ut| ut) r, half to each end (Morison; Sumer & Fredsoe).
    """
    wind, v = np.array([1.0, -2.0, 0.5]), np.array([3.0, 1.0, -1.0])
    node = pair((1, 0, 0), v, air=Air(node_drag_quadratic=0.1, wind=wind))
    for i, speed in enumerate((np.zeros(3), v)):
        u = speed - wind
        assert off(node[i], -0.1 * np.linalg.norm(u) * u) < 1e-14
    air = Air(density=1.2, normal_coefficient=1.1, tangential_coefficient=0.03, wind=wind)
    r, along = 1.0, np.array([0.6, 0.0, 0.8])
    line = pair(along, v, air=air)
    u = 0.5 * v - wind
    ut = (u @ along) * along
    un = u - ut
    expected = -0.5 * 1.2 * 0.02 * r * (
        1.1 * np.linalg.norm(un) * un + math.pi * 0.03 * np.linalg.norm(ut) * ut
    )  # fmt: skip
    for end in line:
        assert off(end, 0.5 * expected) < 1e-14
    # twins: without the wind, with the parts exchanged, on the unstretched length
    assert off(pair(along, v, air=air.replace(wind=(0, 0, 0)))[0], 0.5 * expected) > 1e-3
    swapped = air.replace(normal_coefficient=0.03, tangential_coefficient=1.1)
    assert off(pair(along, v, air=swapped)[0], 0.5 * expected) > 1e-3
    stretched = pair(2 * along, v, k=1e-12, air=air)[0]
    assert off(stretched, expected) < 1e-11
    assert off(stretched, 0.5 * expected) > 1e-3


@pytest.mark.parametrize(
    "law", [{"node_drag": 0.5}, {"node_drag_quadratic": 0.5}, {"density": 900.0}]
)
def test_a_free_rope_drifts_with_the_wind(law: dict[str, float]) -> None:
    """Drag is relative: with the wind there is no force; a rope at rest is taken along."""
    wind = (1.0, 2.0, 0.0)
    rope = Rope(segments=3, made_of=springs(50.0, 0.1, 0.2), shape=Straight(velocity=wind))
    film = run(scene(rope, dt=1e-3, steps=200, air=Air(wind=wind, **law)))
    assert off(film.v, wind) < 1e-12
    still = rope.replace(shape=Straight())
    film = run(scene(still, dt=1e-3, steps=200, air=Air(wind=wind, **law)))
    taken = film.v[-1].mean(axis=0)
    assert taken[0] > 0.02
    assert taken[1] > taken[0]


@pytest.mark.parametrize("method", ALL)
def test_loads_kicks_and_applied_forces(method: str) -> None:
    """Loads add to their node's mass, a kick replaces its velocity, an applied force acts until it is
    changed: F t / m for the whole rope's momentum, exactly for every method.
    """
    rope = Rope(
        segments=2,
        made_of=springs(20.0, 0.1, 1.0, 0.1),
        loads=[{"node": -1, "mass": 0.7}, {"node": 2, "mass": 0.2}],
        kicks=[{"node": -2, "velocity": (0, 3, 0)}],
        shape=Straight(velocity=(1, 0, 0)),
    )
    simulation = Simulation(scene(rope, dt=1e-3, steps=100, method=method))
    assert simulation.arrays.mass == pytest.approx([0.1, 0.1, 1.0])
    assert off(simulation.velocities, [(1, 0, 0), (0, 3, 0), (1, 0, 0)]) == 0.0
    simulation.apply_force(-1, (0.0, 0.0, 2.0))
    first = simulation.advance_frames(50).recording.momentum[-1]
    assert first == pytest.approx([1.1, 0.3, 2.0 * 0.05], abs=1e-13)
    simulation.apply_force(-1, (0.0, 0.0, -1.0))  # in place of the first
    second = simulation.advance_frames(50).recording.momentum[-1]
    assert second == pytest.approx([1.1, 0.3, 0.1 - 0.05], abs=1e-13)
    assert abs(second[2] - (0.1 + 0.05)) > 0.05  # the twin: forces that pile up


def limited(velocities: bool = True, method: str = "semi-implicit-euler"):
    """A weak pendulum that the limiter must hold; without the velocity fix by undoing it."""
    rope = chain(np.array([(0, 0, 0), (0, -1.0, 0)]), springs(1.0, 1.0, 1.0))
    made = scene(rope, hold(0), dt=1e-2, steps=300, method=method, gravity=DOWN, limiter=Limiter())
    simulation = Simulation(made)
    frames = []
    for _ in range(300):
        before = simulation.velocities[1].copy()
        simulation.step()
        if not velocities:  # what Habrador's clamp does: gravity keeps adding up
            simulation.arrays.v[:, 1] = before + 1e-2 * np.array(DOWN)
        frames.append((simulation.positions[1].copy(), simulation.velocities[1].copy()))
    return frames


@pytest.mark.parametrize("method", EXPLICIT)
def test_the_limiter_holds_lengths_and_velocities(method: str) -> None:
    """A mass that the spring cannot carry falls until 1.10 and then stays, at rest: the limiter takes
    the velocity that would stretch further. The twin keeps it, as Habrador's does (seed 2.1).
    """
    frames = limited(method=method)
    assert frames[-1][0] == pytest.approx([0, -1.1, 0], abs=1e-12)
    # explicit Euler moves before it kicks: it keeps one step's kick for the limiter to take next
    allowed = g * 1e-2 if method == "euler" else 1e-12
    assert frames[-1][1] == pytest.approx([0, 0, 0], abs=allowed)
    assert max(-x[1] for x, _ in frames) < 1.1 + 1e-12
    assert -limited(velocities=False)[-1][1][1] > 20.0


@pytest.mark.parametrize("method", EXPLICIT)
def test_the_limiter_keeps_momentum_and_never_adds_energy(method: str) -> None:
    """Free ropes: both nodes give way by halves, so the momentum of equal masses stays; an inelastic
    stop loses kinetic energy. The twin: without a limiter the segments go beyond 1.1.
    """
    rng = np.random.default_rng(3)
    kicks = [{"node": i, "velocity": tuple(map(float, rng.normal(size=3)))} for i in range(6)]
    rope = chain(along_x(np.arange(6.0)), springs(5.0, 0.3, 1.0), kicks=kicks)

    def film(**more):
        return run(scene(rope, dt=5e-3, steps=400, method=method, gravity=NO_GRAVITY, **more))

    held = film(limiter=Limiter(passes=30))
    stretch = np.linalg.norm(np.diff(held.x, axis=1), axis=2)
    assert stretch.max() < 1.1 + 0.02
    assert off(held.block.recording.momentum, held.block.recording.momentum[0]) < 1e-12
    assert np.diff(held.block.recording.jump[:, 0]).max() < 1e-15
    free = np.linalg.norm(np.diff(film().x, axis=1), axis=2)
    assert free.max() > 1.3


def test_the_speed_of_an_anchor_enters_the_friction_of_its_segments() -> None:
    """An anchor that moves at v pulls its neighbour with c v (vector form) from the first step.

    x = v t (1 - exp) .. : one step of semi-implicit Euler gives exactly c v dt / m. The twin: an
    anchor that only changes its place (v = 0 in the friction).
    """

    def kick(c: float) -> float:
        pulled = Anchor(node=0, motion=Velocity(velocity=(0, 3.0, 0)))
        rope = chain(along_x([0, 1.0]), springs(1e-9, 0.05, 1.0, c))
        return float(run(scene(rope, [pulled], dt=1e-3, steps=1)).v[-1, 1, 1])

    assert kick(0.05) == pytest.approx(0.05 * 3.0 * 1e-3 / 0.05, rel=1e-12)
    assert abs(kick(0.0)) < 1e-9
