"""The ground: every method against the closed forms of a bounce, and against each other; its damper."""

from __future__ import annotations

import math

import numpy as np
import pytest

from matrices import stiffness_and_friction
from ropewalk.core import arrays
from ropewalk.core.band import dense
from ropewalk.lowering import build
from ropewalk.methods.loop import prepare
from ropewalk.methods.registry import METHODS
from ropewalk.scene import Ground, Material, Points, Rope, RunSettings, Scene
from ropewalk.simulation import Simulation
from verification.setups import ALL, DOWN, chain, g, springs

MASS, STIFF = 0.2, 80.0  # kg, N/m: the ground rings at 20 rad/s
RATE = math.sqrt(STIFF / MASS)
EVERY = (*ALL, "adaptive")
IMPLICIT = tuple(name for name in EVERY if METHODS[name].implicit)


def pair(
    method: str,
    ground: Ground,
    *,
    height: float = 0.0,
    speed: float = 0.0,
    gravity: tuple[float, float, float] = DOWN,
    dt: float = 1e-3,
    duration: float = 0.4,
    frames: int = 40,
) -> tuple[np.ndarray, np.ndarray]:
    """Times, and heights and speeds upward (frames, 2), of a mass thrown onto the ground.

    It is one of two, side by side, joined by a spring that stays at rest.
    """
    points = np.array([(0.0, height, 0.0), (1.0, height, 0.0)])
    rope = chain(points, springs(50.0, MASS, 1.0))
    rope = rope.replace(shape=rope.shape.replace(velocity=(0.0, speed, 0.0)))
    run = RunSettings(duration=duration, frame_rate=frames / duration, method=method)
    run = run.replace(tolerance=1e-7) if method == "adaptive" else run.replace(time_step=dt)
    simulation = Simulation(Scene(ropes=[rope], gravity=gravity, ground=ground, run=run))
    block = simulation.advance_frames(frames)
    assert block.status == 0
    x, v = block.recording.x, block.recording.v
    assert np.abs(x[:, 1, 0] - x[:, 1, 1]).max() < 1e-12
    assert np.abs(x[:, [0, 2], 0]).max() < 1e-12
    return block.time, np.stack([x[:, 1, 0], v[:, 1, 0]], axis=1)


def bounce(time: np.ndarray, height: float) -> np.ndarray:
    """Height and speed of a mass dropped on elastic ground, (t, 2): free, ringing, free again."""
    begin = math.sqrt(2.0 * height / g)
    hit, sag = g * begin, g / RATE**2
    phase = math.atan2(hit / RATE, sag)  # y = -sag + reach cos(RATE s - turn), y(0) = 0
    reach = math.hypot(sag, hit / RATE)
    lasts = (2.0 * math.pi - 2.0 * phase) / RATE
    s = time - begin
    fall = np.stack([height - 0.5 * g * time**2, -g * time], axis=1)
    angle = RATE * s + phase
    ring = np.stack([-sag + reach * np.cos(angle), -RATE * reach * np.sin(angle)], axis=1)
    u = s - lasts
    rise = np.stack([hit * u - 0.5 * g * u**2, hit - g * u], axis=1)
    return np.where((s < 0.0)[:, None], fall, np.where((u < 0.0)[:, None], ring, rise))


@pytest.mark.parametrize("method", EVERY)
def test_a_mass_bounces_as_the_closed_form_says(method: str) -> None:
    """Free above the ground, ringing in it, free again, at the speed it came with.

    Methods of order one in steps of 1 ms damp or lift the ringing by RATE^2 dt / 2 per second; an impact
    costs the others an order, too. Twin: without the ground the mass falls on.
    """
    ground = Ground(height=0.0, repulsion=STIFF, friction=0.0, absorption=0.0)
    time, found = pair(method, ground, height=0.1)
    exact = bounce(time, 0.1)
    above = time < math.sqrt(0.2 / g)
    first = METHODS[method].order == 1
    assert np.abs(found[above] - exact[above])[:, 0].max() < (2e-3 if first else 1e-9)
    assert np.abs(found - exact)[:, 0].max() < (0.02 if first else 5e-4)
    assert np.abs(found - exact)[:, 1].max() < (0.3 if first else 0.02)
    assert exact[:, 0].min() < -0.05
    assert (exact - [0.1, 0.0])[-1, 0] + 0.5 * g * time[-1] ** 2 > 0.5


def chain_on_ground(method: str, **more: float) -> np.ndarray:
    """Places of a hanging chain after it fell on the ground, (nodes, 3)."""
    points = np.array([(0.05 * i, 0.1 + 0.12 * i, 0.0) for i in range(6)])
    rope = chain(points, springs(300.0, 0.05, 0.13, 0.3))
    ground = Ground(height=0.0, repulsion=200.0, friction=0.4, absorption=1.0, **more)
    run = RunSettings(duration=0.25, frame_rate=4.0, method=method)
    run = run.replace(tolerance=1e-6) if method == "adaptive" else run.replace(time_step=5e-4)
    simulation = Simulation(Scene(ropes=[rope], gravity=DOWN, ground=ground, run=run))
    return simulation.advance_frames(1).recording.x[0].T


@pytest.mark.parametrize("ratio", [0.0, 0.7])
def test_implicit_methods_meet_the_explicit_one(ratio: float) -> None:
    """A falling chain, friction and absorption included, with and without the damper.

    Twin: with and without the damper the ends differ by 18 mm.
    """
    exact = chain_on_ground("rk4", damping_ratio=ratio)
    for method in IMPLICIT:
        off = np.abs(chain_on_ground(method, damping_ratio=ratio) - exact).max()
        assert off < (8e-3 if METHODS[method].order == 1 else 3e-4), method
    other = chain_on_ground("rk4", damping_ratio=0.7 - ratio)
    assert np.abs(other - exact).max() > 0.01


def restitution(ratio: float) -> float:
    """Speed after over speed before a bounce off a damped ground that never pulls [1].

    Schwager & Poeschel 2007, Granular Matter 9:465: the mass leaves when the force is zero.
    """
    if ratio == 1.0:
        return math.exp(-2.0)
    w = math.sqrt(1.0 - ratio**2)
    lasts = math.atan2(2.0 * ratio * w, 2.0 * ratio**2 - 1.0)  # times w RATE
    return math.exp(-ratio * lasts / w)


@pytest.mark.parametrize("ratio", [0.1, 0.5, 0.9, 1.0])
@pytest.mark.parametrize("method", ["semi-implicit-euler", "heun", "rk4"])
def test_the_damper_leaves_what_its_ratio_says(method: str, ratio: float) -> None:
    """Within 0.01; twins: no damper, and one that pulls on the way out. Gravity only says what is up."""
    ground = Ground(height=0.0, repulsion=STIFF, friction=0.0, absorption=0.0, damping_ratio=ratio)
    _, found = pair(method, ground, height=0.02, speed=-1.0, gravity=(0.0, -1e-6, 0.0), dt=5e-4)
    expected = restitution(ratio)
    assert found[0, 1] == pytest.approx(-1.0)
    assert found[-1, 1] == pytest.approx(expected, abs=0.01)
    assert found[-1, 0] > 0.0
    assert expected < 0.8
    if ratio < 1.0:
        pulled = math.exp(-ratio * math.pi / math.sqrt(1.0 - ratio**2))
        assert abs(pulled - expected) > (0.01 if ratio > 0.1 else 0.0)


@pytest.mark.parametrize(("rise", "pushes"), [(-0.4, True), (0.2, True), (3.0, False)])
def test_the_damper_has_its_tangent(rise: float, pushes: bool) -> None:
    """Matrices against central differences: sinking, rising, and where it takes all the push away."""
    ground = Ground(height=0.0, repulsion=STIFF, friction=0.3, absorption=0.6, damping_ratio=0.4)
    points = np.array([(0.0, -0.05, 0.0), (1.0, -0.03, 0.1), (2.0, 0.02, 0.0)])
    rope = Rope(
        segments=2,
        made_of=springs(30.0, MASS, 1.0),
        shape=Points(points=[tuple(p) for p in points], velocity=(0.3, rise, 0.1)),
    )
    model = build(Scene(ropes=[rope], gravity=DOWN, ground=ground))
    system, state = model.system, arrays.copy(model.state)
    found = [dense(band) for band in stiffness_and_friction(system, state)]
    weights = np.repeat(state.mass, 3)

    def force() -> np.ndarray:
        prepare(system, state)
        return (state.acceleration * state.mass).T.ravel()

    for matrix, unknowns in zip(found, (state.x, state.v), strict=True):
        for column in range(weights.size):
            node, k = divmod(column, 3)
            ends = []
            for sign in (1.0, -1.0):
                unknowns[k, node] += sign * 1e-6
                ends.append(force())
                unknowns[k, node] -= sign * 1e-6
            slope = (ends[1] - ends[0]) / 2e-6
            assert matrix[:, column] == pytest.approx(slope, abs=1e-5)
    force()
    assert bool(state.forces.node.ground[1, 0] > 0.0) is pushes
    assert state.forces.node.ground[1, 2] == 0.0


def reading(**more: float) -> float:
    """Impulse on a scale under a falling chain over that of the ideal one [1].

    A chain that hung just above the scale pushes with three times the weight that lies on it (Tait 1858):
    up to time t with lambda x g t, x = g t^2 / 2.
    """
    segments, line, step = 40, 0.5, 5e-5
    points = [(0.0, i / segments, 0.0) for i in range(segments + 1)]
    made_of = Material(EA=200.0, mass_per_length=line, tension_only=True, axial_damping=0.05)
    rope = Rope(segments=segments, length=1.0, made_of=made_of, shape=Points(points=points))
    ground = Ground(height=0.0, repulsion=2000.0, friction=0.0, **more)
    run = RunSettings(duration=0.4, frame_rate=2.5, time_step=step, method="semi-implicit-euler")
    simulation = Simulation(Scene(ropes=[rope], gravity=DOWN, ground=ground, run=run))
    simulation.advance_frames(1)
    state, t = simulation.arrays, simulation.time
    momentum = float(state.mass @ state.v[1])
    impulse = float(state.mass.sum()) * g * t + momentum
    return impulse / (line * 0.5 * g * t**2 * g * t)


def test_a_chain_on_a_scale_weighs_what_it_should() -> None:
    """Within 3 % with the damper; the twin is the lesson's ground, which throws the links back."""
    assert reading(absorption=0.0, damping_ratio=1.0) == pytest.approx(1.0, abs=0.03)
    assert reading(absorption=2.0) > 1.05
