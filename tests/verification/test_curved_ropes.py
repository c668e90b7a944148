"""Ropes whose tension follows a curve of the strain, against closed forms and against Hooke's law."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.core.arrays import flatten
from ropewalk.lowering import build
from ropewalk.lowering.steps import predicted_step
from ropewalk.methods.registry import METHODS
from ropewalk.methods.verdict import energy_now
from ropewalk.scene import (
    Anchor,
    Load,
    Material,
    NeoHookeanCurve,
    Points,
    PolynomialCurve,
    Rope,
    Scene,
    Straight,
)
from ropewalk.simulation import Simulation
from ropewalk.statics import static_shape

A, B = 1e4, 2e4  # N: T = A e + B e^2
QUADRATIC = PolynomialCurve(coefficients=(A, B), largest_strain=0.4)
START, MASS, TIME = 0.2, 1.0, 0.0125  # [1], kg, s


def spring(method: str = "rk4", step: float = 1e-4, curve: Any = QUADRATIC, **more: Any) -> Scene:
    """A mass on one segment of a metre that is stretched by a fifth and let go, without weight."""
    stuff = {"mass_per_length": 1e-9, "curve": curve} | more
    rope = Rope(
        segments=1,
        length=1.0,
        made_of=Material(**{k: v for k, v in stuff.items() if v is not None}),
        loads=[Load(node=1, mass=MASS)],
        shape=Straight(end=(1.0 + START, 0.0, 0.0)),
    )
    run = {"method": method, "time_step": step, "duration": TIME, "frame_rate": 2.0 / TIME}
    return Scene(gravity=(0, 0, 0), ropes=[rope], anchors=[Anchor(node=0)], run=run)


def potential(e: Any) -> Any:
    return A * e**2 / 2.0 + B * e**3 / 3.0


def time_to(e: float) -> float:
    """Time from the start until the strain has fallen to `e`, by quadrature of 1 / speed [s].

    e = start - (start - e) sin^2 takes the root out of the integrand's end.
    """
    nodes, weights = np.polynomial.legendre.leggauss(60)
    angle, share = np.pi / 4.0 * (nodes + 1.0), np.pi / 4.0 * weights
    fall = (START - e) * np.sin(angle) ** 2
    speed = np.sqrt(2.0 / MASS * (potential(START) - potential(START - fall)))
    return float(np.sum(share * 2.0 * (START - e) * np.sin(angle) * np.cos(angle) / speed))


#: Methods whose error at a good hundred steps is known, and that error at most [m].
ERRORS = {
    "semi-implicit-euler": 2e-3, "verlet": 5e-6, "rk4": 1e-9, "implicit-euler": 3e-3, "sdirk2": 2e-5,
}  # fmt: skip


@pytest.mark.parametrize("method", ERRORS)
def test_a_mass_on_a_quadratic_spring_gets_where_quadrature_says(method: str) -> None:
    """It is still stretched then: t(e) of the end is the time that has gone. The twin is Hooke's law."""
    result = rw.simulate(spring(method))
    end = float(result.positions[-1, 1, 0]) - 1.0
    assert 0.0 < end < 0.1
    speed = abs(float(result.velocities[-1, 1, 0]))
    assert abs(time_to(end) - TIME) * speed < ERRORS[method]
    hooke = rw.simulate(spring(method, curve=None, EA=A))
    assert abs(float(hooke.positions[-1, 1, 0]) - 1.0 - end) > 10.0 * ERRORS[method]


def test_rk4_keeps_its_order_on_a_curve() -> None:
    ends = [
        rw.simulate(spring(step=h)).positions[-1, 1, 0] for h in (TIME / 16, TIME / 32, TIME / 64)
    ]
    ratio = abs(ends[0] - ends[1]) / abs(ends[1] - ends[2])
    assert 12.0 < ratio < 22.0


def test_the_ledger_closes_and_the_energy_is_that_of_the_curve() -> None:
    result = rw.simulate(spring("verlet", 2e-5))
    assert result.energy["elastic"][0] == pytest.approx(potential(START), rel=1e-12)
    assert result.tension[0, 0] == pytest.approx(A * START + B * START**2, rel=1e-12)
    assert result.table["largest balance residual [J]"] < 1e-11 * potential(START)
    assert result.table["largest energy error [J]"] < 1e-4 * potential(START)
    assert result.table["largest tension [N]"] == pytest.approx(2800.0, rel=1e-12)


def hung(curve: Any, segments: int = 12, **more: Any) -> Scene:
    """A rope between two anchors with a load off its middle."""
    stuff = {"mass_per_length": 0.3, "tension_only": True, "curve": curve} | more
    made_of = Material(**{k: v for k, v in stuff.items() if v is not None})
    rope = Rope(
        segments=segments,
        length=6.0,
        made_of=made_of,
        loads=[Load(node=segments // 3, mass=40.0)],
        shape=Straight(end=(6.2, 0.0, 0.0)),
    )
    return Scene(ropes=[rope], anchors=[Anchor(node=0), Anchor(node=-1)])


TABLE = [(0.02, 100.0), (0.05, 500.0), (0.1, 1500.0), (0.25, 9000.0)]


def test_at_rest_every_segment_has_the_stretch_of_its_tension() -> None:
    """And the nodes balance. The twin: Hooke's law with the largest slope is elsewhere."""
    scene = hung(TABLE)
    found, curve = static_shape(scene), scene.ropes[0].made_of.curve  # type: ignore[union-attr]
    assert found.solved
    np.testing.assert_allclose(found.stretch - 1.0, curve.strain_at(found.tension), rtol=1e-11)  # type: ignore[union-attr]
    d = np.diff(found.positions, axis=0)
    pulls = found.tension[:, None] * d / np.linalg.norm(d, axis=1)[:, None]
    mass = build(scene).state.mass[1:-1]
    np.testing.assert_allclose(
        pulls[1:] - pulls[:-1], np.outer(mass, [0.0, 0.0, 9.81]), atol=1e-8 * found.tension.max()
    )
    stiff = static_shape(hung(None, EA=scene.ropes[0].made_of.EA))  # type: ignore[union-attr]
    assert abs(stiff.sag[0] - found.sag[0]) > 0.05


def test_modes_about_rest_are_those_of_the_slopes_there() -> None:
    """Against the matrix of central differences of the forces that the engine gives about the rest shape."""
    scene = hung(TABLE, segments=6)
    modes = rw.modes(scene, count=3)
    model = build(scene)
    state, free = model.state, slice(1, -1)
    x0 = np.ascontiguousarray(modes.positions.T)
    columns, h = [], 1e-6
    for i in range(1, x0.shape[1] - 1):
        for k in range(3):
            pair = []
            for sign in (1.0, -1.0):
                state.x[:] = x0
                state.x[k, i] += sign * h
                pair.append(forces(model))
            columns.append(((pair[0] - pair[1]) / (2.0 * h))[:, free].T.ravel())
    stiffness = -np.array(columns).T / np.repeat(state.mass[free], 3)[:, None]
    rates = np.sqrt(np.sort(np.linalg.eigvals(stiffness).real)[:3])
    np.testing.assert_allclose(modes.frequencies * 2.0 * np.pi, rates, rtol=1e-5)


def forces(model: Any) -> Any:
    """Return the springs' force on every node from the derivative of their energy alone, (3, n) [N]."""
    from ropewalk.laws.elastic import law_forces

    state, out = model.state, np.zeros((3, model.state.mass.size + 1))
    lengths, k = state.rest_length, state.stiffness
    floor, elastic = model.system.slack_floor, model.system.elastic
    law_forces(state.x, lengths, k, floor, elastic, state.inner, out)
    return np.diff(out, axis=1)


def test_the_force_is_the_gradient_of_the_energy() -> None:
    model = build(hung(TABLE, segments=5).replace(gravity=(0, 0, 0)))
    state, h = model.state, 1e-6
    rng = np.random.default_rng(3)
    state.x[:] += rng.normal(0.0, 0.2, state.x.shape)
    found = forces(model)
    for i in range(state.mass.size):
        for k in range(3):
            kept, ends = state.x[k, i], []
            for sign in (1.0, -1.0):
                state.x[k, i] = kept + sign * h
                ends.append(energy_now(model.system, state))
            state.x[k, i] = kept
            assert found[k, i] == pytest.approx((ends[1] - ends[0]) / (2.0 * h), abs=2e-3)


def test_a_straight_curve_moves_as_EA_to_the_bit() -> None:
    straight = [(0.1, 1000.0), (0.2, 2000.0), (0.4, 4000.0)]
    states = []
    for scene in (spring(curve=straight), spring(curve=None, EA=1e4)):
        simulation = Simulation(scene)
        simulation.advance_frames(2)
        arrays = flatten(simulation.arrays).items()
        states.append({name: np.asarray(one).tobytes() for name, one in arrays})
    assert states[0] == states[1]


def test_a_nearly_straight_curve_moves_as_EA_to_rounding() -> None:
    """The kernels of curves and those of Hooke's law agree: the bend is far below all that counts."""
    bent = PolynomialCurve(coefficients=(1e4, 1e-4), largest_strain=0.4)
    for method in ("rk4", "implicit-euler"):
        one, other = (
            rw.simulate(spring(method, **more)).positions[-1, 1, 0]
            for more in ({"curve": bent}, {"curve": None, "EA": 1e4})
        )
        assert one == pytest.approx(other, abs=1e-8)


def test_the_bound_of_the_step_is_that_of_the_largest_slope() -> None:
    """As that of a straight rope of that EA, and as the closed form of one mass says."""
    curve = PolynomialCurve(coefficients=(1e3, 0.0, 4e5), largest_strain=0.3)
    model = build(spring("semi-implicit-euler", curve=curve))
    largest = 1e3 + 3.0 * 4e5 * 0.3**2
    assert curve.slopes == (1e3, 1e3, pytest.approx(largest))
    bound = predicted_step(model.system, model.state, "semi-implicit-euler")
    assert bound == pytest.approx(2.0 / np.sqrt(largest / MASS), rel=1e-6)
    hooke = build(spring("semi-implicit-euler", curve=None, EA=largest))
    same = predicted_step(hooke.system, hooke.state, "semi-implicit-euler")
    assert bound == pytest.approx(same, rel=1e-12)


def test_a_run_beyond_the_last_point_says_so() -> None:
    short = PolynomialCurve(coefficients=(A, B), largest_strain=0.1)
    result = rw.simulate(spring("rk4", curve=short))
    assert "beyond its curve's last point, 10 %" in result.table["about the largest stretch"]
    assert "about the largest stretch" not in rw.simulate(spring("rk4")).table


def test_check_tells_of_the_curve() -> None:
    told = str(rw.check(hung([(0.01, 40.0), (0.02, 100.0)])))
    assert "a curve (table) whose slope is" in told
    assert "beyond its curve's last point, 2 % (100 N)" in told
    assert "beyond its curve's last point" not in str(rw.check(hung(TABLE)))


def test_check_tells_the_speed_of_waves_where_the_rope_hangs() -> None:
    """c = sqrt(slope / m) at the strain of rest; it was that of the largest slope. No weight but the load's:
    the strain is the same everywhere.
    """
    rope = Rope(
        segments=4,
        length=2.0,
        made_of=Material(mass_per_length=1e-6, curve=QUADRATIC),
        loads=[Load(node=-1, mass=50.0)],
        shape=Straight(end=(0.0, 0.0, -2.0)),
    )
    found = rw.check(Scene(ropes=[rope], anchors=[Anchor(node=0)])).ropes[0]
    slope = np.sqrt(A**2 + 4.0 * B * 50.0 * 9.81)  # of T = A e + B e^2 at that tension
    assert found.longitudinal == pytest.approx([np.sqrt(slope / 1e-6)] * 2, rel=1e-4)
    assert f"waves along it {found.longitudinal[0]:.4g} m/s" in found.waves()


@pytest.mark.slow
@pytest.mark.parametrize("method", METHODS)
def test_every_method_follows_the_curve(method: str) -> None:
    result = rw.simulate(spring(method, "auto" if method == "adaptive" else 2.5e-5))
    end = float(result.positions[-1, 1, 0]) - 1.0
    speed = abs(float(result.velocities[-1, 1, 0]))
    assert abs(time_to(end) - TIME) * speed < 3e-3


def bent_string(method: str, step: float) -> Scene:
    """A rope that bends and only pulls, stretched by 4 % but for its first segment, let go for 5 ms."""
    ways = [[0, 0, -1], [0.3, 0.4, -0.85], [0.5, 0.3, -0.8], [0.2, 0.6, -0.75], [0, 0.5, -0.85]]
    sizes = 0.24 * np.array([0.98, 1.04, 1.05, 1.05, 1.025])
    legs = np.array(ways) * (sizes / np.linalg.norm(ways, axis=1))[:, None]
    places = np.vstack([np.zeros(3), np.cumsum(legs, axis=0)])
    rubber = NeoHookeanCurve(EA=500.0, largest_strain=0.5)
    stuff = Material(curve=rubber, mass_per_length=0.17, EI=0.002, tension_only=True)
    shape = Points(points=[tuple(map(float, place)) for place in places])
    rope = Rope(segments=5, length=1.2, made_of=stuff, shape=shape)
    run = {"method": method, "time_step": step, "duration": 0.005, "frame_rate": 1000.0}
    return Scene(gravity=(0, -7, 0), ropes=[rope], anchors=[Anchor(node=0)], run=run)


@pytest.mark.parametrize("method", ["esdirk3", "sdirk2", "bdf2", "generalized-alpha"])
def test_short_steps_do_not_let_go_of_what_is_taut(method: str) -> None:
    """Rubber that only pulls, in steps of 10 us: as RK4 has it, and its energy kept.

    When a tension a little off could let go of a taut segment, in steps shorter than its own period, no stage
    had a solution, and parts of steps so small that rounding was all they had made up 4 mJ.
    """
    exact = rw.simulate(bent_string("rk4", 1e-5)).positions
    found = rw.simulate(bent_string(method, 1e-5))
    assert np.abs(found.positions - exact).max() < 5e-8
    assert np.abs(found.energy_error).max() < 1e-8
