"""Anchors: path and velocity of every motion, release, ground, hand."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.interpolate import CubicSpline

from ropewalk.scene import (
    Anchor,
    Ground,
    Hand,
    Orbit,
    Rope,
    Shake,
    Straight,
    Table,
    Velocity,
)
from ropewalk.simulation import Simulation
from verification.setups import ALL, DOWN, g, hold, off, run, scene, springs

START = (0.3, 0.2, -0.1)
DT = 1e-3


def path(motion, *, method: str = "semi-implicit-euler", steps: int = 1000, **more):
    """Times, places and velocities of an anchored node moved by `motion` from START."""
    rope = Rope(segments=1, made_of=springs(1.0, 1.0, 1.0), shape=Straight(start=START))
    film = run(
        scene(rope, [Anchor(node=0, motion=motion)], dt=DT, steps=steps, method=method, **more)
    )
    return film.t, film.x[:, 0], film.v[:, 0]


def test_a_velocity_during_an_interval() -> None:
    """x0 + u clamp(t - start, 0, stop - start), wherever the steps fall."""
    u = np.array([2.0, -1.0, 0.5])
    t, x, v = path(Velocity(velocity=u, start=0.2005, stop=0.7003))
    elapsed = np.clip(t - 0.2005, 0.0, 0.7003 - 0.2005)[:, None]
    assert off(x, START + u * elapsed) < 1e-15
    inside = ((t >= 0.2005) & (t < 0.7003))[:, None]
    assert off(v, u * inside) == 0.0
    assert off(x, START + u * np.clip(t - 0.2, 0.0, 0.5)[:, None]) > 1e-4  # the twin: whole steps


TIMES = np.array([0.1, 0.25, 0.3, 0.62, 0.9])
PLACES = np.random.default_rng(5).normal(size=(5, 3))


def natural_spline(t: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Value and slope of the natural cubic spline, from its definition: cubic pieces through the
    points, equal slopes and curvatures inside, no curvature at the ends (one dense solve).
    """
    n = len(TIMES) - 1
    h = np.diff(TIMES)
    A, right, row = np.zeros((4 * n, 4 * n)), np.zeros((4 * n, 3)), 0

    def put(entries: dict[int, float], value=0.0) -> None:
        nonlocal row
        for column, entry in entries.items():
            A[row, column] = entry
        right[row] = value
        row += 1

    for i in range(n):
        a = 4 * i
        put({a: 1.0}, PLACES[i])
        put({a + p: h[i] ** p for p in range(4)}, PLACES[i + 1])
        if i < n - 1:
            put({a + 1: 1, a + 2: 2 * h[i], a + 3: 3 * h[i] ** 2, a + 5: -1})
            put({a + 2: 2, a + 3: 6 * h[i], a + 6: -2})
    put({2: 2.0})
    put({4 * n - 2: 2.0, 4 * n - 1: 6 * h[-1]})
    c = np.linalg.solve(A, right).reshape(n, 4, 3)
    i = np.clip(np.searchsorted(TIMES, t, side="right") - 1, 0, n - 1)
    s = (t - TIMES[i])[:, None]
    value = c[i, 0] + s * (c[i, 1] + s * (c[i, 2] + s * c[i, 3]))
    return value, c[i, 1] + s * (2 * c[i, 2] + s * 3 * c[i, 3])


def test_a_table_with_a_cubic_spline() -> None:
    """The natural spline (de Boor, A Practical Guide to Splines, ch. IV); held outside the table."""
    t, x, v = path(Table(times=TIMES, positions=PLACES, interpolation="cubic"))
    inside = (t > TIMES[0]) & (t < TIMES[-1] - 1e-9)
    value, slope = natural_spline(t[inside])
    assert off(x[inside], value) < 1e-12
    assert off(v[inside], slope) < 1e-11
    assert off(x[t <= TIMES[0]], PLACES[0]) < 1e-15
    assert off(x[t >= TIMES[-1] + 1e-9], PLACES[-1]) < 1e-15
    assert off(v[(t < TIMES[0]) | (t > TIMES[-1] + 1e-9)], 0.0) == 0.0
    linear = np.stack([np.interp(t, TIMES, PLACES[:, k]) for k in range(3)], axis=1)
    assert off(x, linear) > 1e-2


def test_a_cubic_table_is_scipys_natural_spline() -> None:
    """An independent implementation, also of uneven and many times, to rounding. Twins: the other
    ends that such tables may have, not-a-knot and clamped, and straight lines.
    """
    rng = np.random.default_rng(3)
    many = np.cumsum(rng.uniform(0.005, 0.08, 30)) - 0.02
    for times, places in ((TIMES, PLACES), (many, rng.normal(size=(30, 3)))):
        t, x, v = path(Table(times=times, positions=places, interpolation="cubic"))
        inside = (t > times[0]) & (t < times[-1] - 1e-9)
        spline = CubicSpline(times, places, bc_type="natural")
        speed = np.abs(spline(t[inside], 1)).max()
        assert off(x[inside], spline(t[inside])) < 1e-12 * max(1.0, speed)
        assert off(v[inside], spline(t[inside], 1)) < 1e-11 * max(1.0, speed)
        for ends in ("not-a-knot", "clamped"):
            assert off(x[inside], CubicSpline(times, places, bc_type=ends)(t[inside])) > 1e-3


def test_a_table_with_straight_lines() -> None:
    """np.interp between the times; velocity the slope of the line that begins there."""
    t, x, v = path(Table(times=TIMES, positions=PLACES))
    linear = np.stack([np.interp(t, TIMES, PLACES[:, k]) for k in range(3)], axis=1)
    assert off(x, linear) < 1e-13
    slope = np.diff(PLACES, axis=0) / np.diff(TIMES)[:, None]
    clear = (t > 0.301) & (t < 0.619)
    assert off(v[clear], slope[2]) < 1e-12
    assert off(v[clear], slope[1]) > 1e-2
    inside = (t > 0.11) & (t < 0.89)
    assert off(x[inside], natural_spline(t[inside])[0]) > 1e-2


def test_shaking() -> None:
    """x0 + A e (sin(2 pi f t + phase) - sin(phase)), e the unit axis."""
    t, x, v = path(Shake(axis=(0, 3, 4), amplitude=0.2, frequency=2.5, phase=0.6))
    e, w = np.array([0, 0.6, 0.8]), 2 * math.pi * 2.5
    assert off(x, START + np.outer(0.2 * (np.sin(w * t + 0.6) - math.sin(0.6)), e)) < 1e-14
    assert off(v, np.outer(0.2 * w * np.cos(w * t + 0.6), e)) < 1e-12
    assert off(x, START + np.outer(0.2 * np.sin(w * t + 0.6), e)) > 0.05  # the twin: it would jump


def test_orbiting() -> None:
    """Rotation about the axis through the centre, right-handed; the distance along it stays."""
    t, x, v = path(Orbit(center=(1, 0, 0.5), axis=(0, 0, 2), frequency=1.5))
    w, d = 2 * math.pi * 1.5, complex(START[0] - 1, START[1])
    z = d * np.exp(1j * w * t)
    circle = np.stack([1 + z.real, z.imag, np.full_like(t, START[2])], axis=1)
    assert off(x, circle) < 1e-14
    dz = 1j * w * z
    assert off(v, np.stack([dz.real, dz.imag, 0 * t], axis=1)) < 1e-12
    other = path(Orbit(center=(1, 0, 0.5), axis=(0, 0, 2), frequency=-1.5))[1]
    assert off(other, circle) > 0.1
    # a tilted axis: distance to the centre and height along the axis stay
    e = np.array([1.0, 2.0, 2.0]) / 3
    _, x, v = path(Orbit(center=(1, 0, 0.5), axis=(1, 2, 2), frequency=1.5))
    r = x - np.array([1, 0, 0.5])
    assert off(r @ e, r[0] @ e) < 1e-14
    assert off(v, w * np.cross(e, r)) < 1e-12


@pytest.mark.parametrize("method", ALL)
def test_anchors_are_where_their_motion_says_with_every_method(method: str) -> None:
    """At the end of a step the node is at the motion's place, whatever the stages did."""
    motion = Shake(axis=(1, 0, 0), amplitude=0.2, frequency=2.5)
    t, x, v = path(motion, method=method, steps=100)
    w = 5 * math.pi
    assert off(x[:, 0], START[0] + 0.2 * np.sin(w * t)) < 1e-14
    assert off(v[:, 0], 0.2 * w * np.cos(w * t)) < 1e-12
    assert off(x[:-1, 0], START[0] + 0.2 * np.sin(w * t[1:])) > 1e-4  # the twin: one step late


@pytest.mark.parametrize("method", ALL)
def test_a_released_node_falls_freely(method: str) -> None:
    """Held at a velocity until 0.1 s, then x + v t and free fall, as its method says; before, the
    anchor carries the weight, after it nothing.
    """
    moved = Anchor(node=0, motion=Velocity(velocity=(1, 0, 0)), release_time=0.1)
    rope = Rope(segments=1, made_of=springs(1e-9, 1.0, 1.0), shape=Straight(velocity=(1, 0, 0)))
    film = run(scene(rope, [moved], dt=DT, steps=300, method=method, gravity=DOWN))
    s = np.arange(201)
    shift = {"euler": -1.0, "semi-implicit-euler": 1.0, "implicit-euler": 1.0}.get(method, 0.0)
    assert off(film.x[100:, 0, 1], -0.5 * g * DT * DT * s * (s + shift)) < 1e-9
    assert off(film.x[:, 0, 0], film.t) < 1e-9
    assert off(film.x[:101, 0, 1], 0.0) == 0.0
    reaction = film.block.recording.reaction[:, 0]
    assert off(reaction[2:101], [0, g, 0]) < 1e-6
    assert off(reaction[101:], 0.0) == 0.0
    assert film.simulation.anchors["anchor0"].holds is False
    s = np.arange(300 - 99 + 1)  # the twin: released one step sooner
    assert off(film.x[99:, 0, 1], -0.5 * g * DT * DT * s * (s + shift)) > 1e-3


def test_an_anchor_stops_at_the_ground() -> None:
    """above_ground: its place is put on the ground and its way down stopped (NeHe's connection)."""
    down = Velocity(velocity=(0.5, -1.0, 0.0))
    rope = Rope(segments=1, made_of=springs(1.0, 1.0, 1.0))

    def film(above: bool):
        anchor = Anchor(node=0, motion=down, above_ground=above)
        ground = Ground(height=-0.4)
        return run(scene(rope, [anchor], dt=DT, steps=1000, gravity=DOWN, ground=ground))

    held = film(True)
    assert off(held.x[:, 0, 1], np.maximum(-held.t, -0.4)) < 1e-15
    assert off(held.x[:, 0, 0], 0.5 * held.t) < 1e-15
    assert off(held.v[402:, 0], [0.5, 0, 0]) == 0.0
    assert film(False).x[-1, 0, 1] == pytest.approx(-1.0)


@pytest.mark.parametrize("method", ALL)
def test_moving_an_anchor_by_hand(method: str) -> None:
    """sim.anchors[..].velocity: from now on the anchor moves by it; no velocity, no motion."""
    rope = Rope(segments=2, made_of=springs(10.0, 0.1, 1.0, 0.1))
    anchors = [Anchor(name="left", node=0, motion=Hand()), *hold(2)]
    simulation = Simulation(scene(rope, anchors, dt=DT, steps=400, every=100, method=method))
    simulation.step()
    assert off(simulation.anchors["left"].position, 0.0) == 0.0
    simulation.anchors["left"].velocity = (3.0, 0.0, 1.0)
    simulation.step()
    simulation.step()
    assert simulation.anchors["left"].position == pytest.approx([0.6, 0, 0.2], abs=1e-13)
    assert simulation.positions[0] == pytest.approx([0.6, 0, 0.2], abs=1e-13)
    simulation.anchors["left"].velocity = (0.0, 0.0, 0.0)
    simulation.step()
    assert simulation.positions[0] == pytest.approx([0.6, 0, 0.2], abs=1e-13)
    assert off(simulation.velocities[0], 0.0) == 0.0
    # an anchor with another motion can be taken in hand as well
    simulation.anchors["anchor1"].velocity = (0.0, 1.0, 0.0)
    simulation.step()
    assert simulation.positions[2] == pytest.approx([2.0, 0.1, 0.0], abs=1e-13)
    with pytest.raises(ValueError, match="three finite numbers"):
        simulation.anchors["left"].velocity = (math.nan, 0, 0)
