"""Ropes that relax, the standard linear solid, against closed forms."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.core.arrays import flatten
from ropewalk.live.lab import lab_scene
from ropewalk.lowering import build
from ropewalk.lowering.steps import predicted_step
from ropewalk.methods.registry import METHODS
from ropewalk.scene import (
    Anchor,
    Force,
    Kick,
    Load,
    Material,
    Rope,
    Scene,
    SceneError,
    Straight,
)
from ropewalk.scene.motions import Shake, Velocity
from ropewalk.simulation import Simulation
from ropewalk.statics import static_shape

EA, E1, TAU, MASS = 1e4, 2.5e4, 0.05, 2.0  # N, N, s, kg


def stuff(**more: Any) -> Material:
    given = {"EA": EA, "relaxing_EA": E1, "relaxation_time": TAU, "mass_per_length": 1e-9} | more
    return Material(**{key: value for key, value in given.items() if value is not None})


def swing(method: str = "rk4", step: float = 2e-4, time: float = 0.1, **more: Any) -> Scene:
    """A mass on a segment of a metre, kicked along it from rest, without weight."""
    rope = Rope(
        segments=1,
        length=1.0,
        made_of=stuff(**more),
        loads=[Load(node=1, mass=MASS)],
        shape=Straight(end=(1.0, 0.0, 0.0)),
        kicks=[Kick(node=1, velocity=(3.0, 0.0, 0.0))],
    )
    run = {"method": method, "time_step": step, "duration": time, "frame_rate": 2.0 / time}
    return Scene(gravity=(0, 0, 0), ropes=[rope], anchors=[Anchor(node=0)], run=run)


def linear_swing(
    t: float, speed: float = 3.0, stiff: float = EA, arm: float = E1, tau: float = TAU
) -> Any:
    """Return x, v and d of the mass at time t [m, m/s, 1] by the roots of the solid's cubic."""
    A = np.array(
        [[0.0, 1.0, 0.0], [-(stiff + arm) / MASS, 0.0, arm / MASS], [1.0 / tau, 0.0, -1.0 / tau]]
    )
    roots, shapes = np.linalg.eig(A)
    cubic = [1.0, 1.0 / tau, (stiff + arm) / MASS, stiff / (MASS * tau)]
    np.testing.assert_allclose(np.sort_complex(roots), np.sort_complex(np.roots(cubic)), rtol=1e-9)
    share = np.linalg.solve(shapes, np.array([0.0, speed, 0.0]))
    return (shapes @ (share * np.exp(roots * t))).real


#: Largest error of the place at 500 steps [m]; the swing is 4 cm wide.
ERRORS = {
    "semi-implicit-euler": 1e-5, "verlet": 1e-5, "rk4": 1e-9, "implicit-euler": 1.5e-3, "sdirk2": 1e-5,
}  # fmt: skip


def error_of(method: str, step: float, time: float = 0.1) -> float:
    result = rw.simulate(swing(method, step, time))
    return abs(float(result.positions[-1, 1, 0]) - 1.0 - linear_swing(time)[0])


@pytest.mark.parametrize("method", ERRORS)
def test_a_mass_swings_by_the_roots_of_the_cubic(method: str) -> None:
    """The twins: the spring alone, and spring and arm without relaxation, are elsewhere."""
    assert error_of(method, 2e-4) < ERRORS[method]
    for stiff in (EA, EA + E1):
        wrong = linear_swing(0.1, stiff=stiff, arm=1e-9)[0]
        assert abs(wrong - linear_swing(0.1)[0]) > 4.0 * ERRORS[method]


@pytest.mark.parametrize(("method", "order"), [("rk4", 4), ("verlet", 2), ("sdirk2", 2)])
def test_methods_keep_their_order(method: str, order: int) -> None:
    ratio = error_of(method, 2e-3) / error_of(method, 1e-3)
    assert abs(np.log2(ratio) - order) < 0.25


@pytest.mark.slow
@pytest.mark.parametrize("method", METHODS)
def test_every_method_follows_the_solid(method: str) -> None:
    """And keeps its order; semi-implicit Euler's places are Verlet's here, where it begins at rest."""
    if method == "adaptive":
        run = swing(method).run.replace(tolerance=1e-7, time_step="auto")
        end = rw.simulate(swing(method).replace(run=run)).positions[-1, 1, 0] - 1.0
        assert end == pytest.approx(linear_swing(0.1)[0], abs=1e-5)
        return
    first = method in ("euler", "implicit-euler")
    coarse, fine = error_of(method, 4e-4), error_of(method, 2e-4)
    assert fine < (3e-3 if first else 4e-5)
    least = 0.7 if first else {"rk4": 3.8, "esdirk3": 2.8}.get(method, 1.8)
    assert np.log2(coarse / fine) > least


def driven(motion: Any, method: str, step: float, time: float, **more: Any) -> Scene:
    """One segment of a metre whose ends are held, the other one moved along it."""
    rope = Rope(segments=1, length=1.0, made_of=stuff(**more), shape=Straight(end=(1.0, 0.0, 0.0)))
    anchors = [Anchor(node=0), Anchor(node=1, motion=motion)]
    run = {"method": method, "time_step": step, "duration": time, "frame_rate": 100.0}
    return Scene(gravity=(0, 0, 0), ropes=[rope], anchors=anchors, run=run)


@pytest.mark.parametrize(("method", "error"), [("verlet", 1e-9), ("rk4", 1e-8), ("sdirk2", 1e-4)])
def test_tension_relaxes_at_a_held_length(method: str, error: float) -> None:
    """Drawn at a constant rate for 0.1 s, then held: the arm's tension falls by exp(-t / tau)."""
    rate, stop = 0.5, 0.1
    draw = Velocity(velocity=(rate, 0.0, 0.0), stop=stop)
    result = rw.simulate(driven(draw, method, 1e-3, 0.3))
    t = result.time
    arm = E1 * rate * TAU * (1.0 - np.exp(-np.minimum(t, stop) / TAU))
    arm *= np.exp(-np.maximum(t - stop, 0.0) / TAU)
    expected = EA * rate * np.minimum(t, stop) + arm
    np.testing.assert_allclose(result.tension[:, 0], expected, atol=error * expected.max())
    late = expected[-1] / (EA * rate * stop)
    assert 1.0 < late < 1.05 < expected.max() / (EA * rate * stop)


def test_a_load_creeps_and_comes_back() -> None:
    """A hundredth of a gram follows its force at once: the strain goes from F/(EA + E1) to F/EA."""
    force, slow = 700.0, TAU * (EA + E1) / EA
    rope = Rope(
        segments=1, length=1.0, made_of=stuff(), loads=[Load(node=1, mass=1e-5)],
        shape=Straight(end=(1.0, 0.0, 0.0)), forces=[Force(node=1, force=(force, 0.0, 0.0))],
    )  # fmt: skip
    run = {"method": "sdirk2", "time_step": 1e-3, "duration": 0.4, "frame_rate": 50.0}
    scene = Scene(gravity=(0, 0, 0), ropes=[rope], anchors=[Anchor(node=0)], run=run)
    result = rw.simulate(scene)
    t, strain = result.time[1:], result.positions[1:, 1, 0] - 1.0
    expected = force / EA - (force / EA - force / (EA + E1)) * np.exp(-t / slow)
    np.testing.assert_allclose(strain, expected, rtol=1e-4)


def test_a_swinging_strain_loses_what_the_loss_modulus_says() -> None:
    """pi E1 e^2 w tau / (1 + w^2 tau^2) a cycle, from what the ends give, and from what friction takes."""
    size, rate = 0.01, 4.0
    shake = Shake(axis=(1.0, 0.0, 0.0), amplitude=size, frequency=rate)
    result = rw.simulate(driven(shake, "verlet", 2.5e-4, 1.5))
    turn = 2.0 * np.pi * rate * TAU
    loss = np.pi * E1 * size**2 * turn / (1.0 + turn**2)
    first, last = 100, 150  # frames of two whole cycles, twenty relaxation times after the start
    friction = result.work["friction"]
    assert (friction[first] - friction[last]) / 2.0 == pytest.approx(loss, rel=1e-4)
    given = sum(result.work[name] for name in result.work if name.startswith("anchor"))
    assert (given[last] - given[first]) / 2.0 == pytest.approx(loss, rel=1e-4)
    assert np.all(np.diff(friction) < 0.0)


@pytest.mark.parametrize(
    "method", ["semi-implicit-euler", "verlet", "rk4", "sdirk2", "implicit-euler"]
)
def test_a_slack_segment_relaxes_without_tension(method: str) -> None:
    """Let go after it was drawn for long, it is longer for a while; the twin that can push is pressed."""
    back = Velocity(velocity=(-20.0, 0.0, 0.0), stop=0.01)
    slow = TAU * (EA + E1) / EA
    left = []
    for tension_only in (True, False):
        scene = driven(back, method, 2.5e-4, 0.06, tension_only=tension_only)
        rope = scene.ropes[0].replace(shape=Straight(end=(1.1, 0.0, 0.0)))
        simulation = Simulation(scene.replace(ropes=[rope]))
        simulation.advance_frames(2)
        before = float(simulation.arrays.inner[0, 0])
        simulation.advance_frames(4)
        left.append(float(simulation.arrays.inner[0, 0]) / before)
        pull = simulation.recording().recording.tension[0, 0]
        assert pull == 0.0 if tension_only else pull < 0.0
    assert left[0] == pytest.approx(np.exp(-0.04 / slow), rel=2e-3)
    assert left[1] < 0.9 * left[0]


@pytest.mark.parametrize("method", ["verlet", "sdirk2"])
def test_the_limits_of_the_relaxation_time_are_springs(method: str) -> None:
    for tau, stiff in ((1e-9, EA), (1e9, EA + E1)):
        solid, spring = (
            rw.simulate(swing(method, **more)).positions[-1, 1, 0]
            for more in (
                {"relaxation_time": tau},
                {"EA": stiff, "relaxing_EA": None, "relaxation_time": None},
            )
        )
        assert solid == pytest.approx(spring, abs=1e-6)


TABLE = [(0.02, 100.0), (0.05, 500.0), (0.1, 1500.0), (0.25, 9000.0)]


def hung(method: str = "verlet", **more: Any) -> Scene:
    """A rope with a curve that relaxes, between two anchors, with a load let go off its middle."""
    made_of = stuff(
        **({"EA": None, "curve": TABLE, "mass_per_length": 0.3, "tension_only": True} | more)
    )
    rope = Rope(
        segments=12, length=6.0, made_of=made_of, loads=[Load(node=4, mass=40.0)],
        shape=Straight(end=(6.1, 0.0, 0.0)),
    )  # fmt: skip
    run = {"method": method, "time_step": 2e-4, "duration": 0.2, "frame_rate": 20.0}
    return Scene(ropes=[rope], anchors=[Anchor(node=0), Anchor(node=-1)], run=run)


def test_ledger_and_methods_agree_on_a_rope_with_a_curve() -> None:
    ends = []
    for method in ("verlet", "sdirk2"):
        result = rw.simulate(hung(method))
        given = -float(result.work["weight"][-1])
        assert abs(given) > 50.0
        assert result.table["largest balance residual [J]"] < 1e-9 * abs(given)
        assert result.table["largest energy error [J]"] < 2e-3 * abs(given)
        assert np.all(np.diff(result.work["friction"]) <= 0.0)
        assert result.work["friction"][-1] < -0.1
        ends.append(result.positions[-1])
    np.testing.assert_allclose(ends[0], ends[1], atol=2e-4)


def test_rest_and_modes_are_those_of_a_rope_long_relaxed() -> None:
    solid, spring = hung(), hung(relaxing_EA=None, relaxation_time=None)
    one, other = static_shape(solid), static_shape(spring)
    np.testing.assert_allclose(one.positions, other.positions, atol=1e-9)
    np.testing.assert_allclose(one.tension, other.tension, rtol=1e-8)
    rates = [rw.modes(scene, count=4).frequencies for scene in (solid, spring)]
    np.testing.assert_allclose(*rates, rtol=1e-6)
    run = solid.run.replace(start="at-rest", method="sdirk2", duration=0.02)
    at_rest = rw.simulate(solid.replace(run=run))
    assert np.abs(at_rest.positions[-1] - one.positions).max() < 1e-8


def test_the_bound_of_the_step_is_that_of_a_sudden_stretch() -> None:
    steps = {}
    for method in ("semi-implicit-euler", "rk4"):
        for tau in (TAU, 1e-4):
            model = build(swing(method, relaxation_time=tau))
            steps[method, tau] = predicted_step(model.system, model.state, method)
    free = 2.0 / np.sqrt((EA + E1) / MASS)
    assert steps["semi-implicit-euler", TAU] == pytest.approx(free, rel=1e-6)
    assert steps["semi-implicit-euler", 1e-4] == pytest.approx(free, rel=1e-6)
    assert steps["rk4", 1e-4] < 2.785e-4 < steps["rk4", TAU]


def test_a_state_that_is_kept_goes_on_to_the_same_bits() -> None:
    for method in ("semi-implicit-euler", "bdf2", "generalized-alpha"):
        whole, parts = Simulation(hung(method)), Simulation(hung(method))
        whole.advance_frames(4)
        parts.advance_frames(2)
        again = Simulation(hung(method))
        again.restore(parts.state)
        again.advance_frames(2)
        one, other = flatten(whole.arrays), flatten(again.arrays)
        assert np.abs(one["inner"][0]).max() > 0.0
        assert all(one[name].tobytes() == other[name].tobytes() for name in ("x", "v", "inner"))


def test_a_solid_beside_another_rope_moves_as_alone() -> None:
    alone = hung("sdirk2")
    other = alone.ropes[0].replace(
        name="other", made_of=stuff(mass_per_length=0.2, relaxing_EA=None, relaxation_time=None)
    )
    both = alone.replace(
        ropes=[alone.ropes[0].replace(name="first"), other],
        anchors=[Anchor(rope=name, node=node) for name in ("first", "other") for node in (0, -1)],
    )
    one, two = rw.simulate(alone), rw.simulate(both)
    np.testing.assert_array_equal(one.positions[-1], two.rope("first").positions[-1])


def test_modes_say_what_they_leave_out() -> None:
    """E1 = 3 EA: up to sqrt(1 + 3) = 2 times as fast, with (2 - 1) / 2 of the critical damping, which a run
    has where the rate at rest is (1 + 3)^(-3/4) / tau, by the roots of tau s^3 + s^2 + 4 tau w^2 s + w^2.
    """

    def notes(**more: Any) -> list[str]:
        between = Straight(start=(0, 0, 0), end=(1.01, 0, 0))
        rope = Rope(segments=2, length=1.0, made_of=stuff(**more), shape=between)
        ends = [Anchor(node=0), Anchor(node=-1)]
        return rw.modes(Scene(gravity=(0, 0, 0), ropes=[rope], anchors=ends)).notes

    (note,) = notes(relaxing_EA=3.0 * EA)
    assert "at 3.18 Hz rings up to 2 times as fast" in note
    assert "a damping ratio of up to 0.5;" in note
    assert notes(relaxing_EA=None, relaxation_time=None) == []
    w, ratios = np.sqrt(EA / MASS), []
    for tau in np.geomspace(0.1, 10.0, 201) * 4.0**-0.75 / w:
        roots = np.roots([tau, 1.0, 4.0 * tau * w**2, w**2])
        ring = roots[roots.imag > 0.0]
        ratios.append(float((-ring.real / abs(ring)).max()))
    assert max(ratios) == pytest.approx(0.5, abs=1e-9)
    assert ratios.index(max(ratios)) == 100
    tau = 4.0**-0.75 / w
    found = rw.simulate(swing(relaxing_EA=3.0 * EA, relaxation_time=tau))
    roots = np.roots([tau, 1.0, 4.0 * tau * w**2, w**2])
    start = np.linalg.solve([roots**0, roots, roots**2], [0.0, 3.0, 0.0])
    exact = (start * np.exp(roots * found.time[:, None])).sum(axis=1).real
    assert np.abs(found.positions[:, 1, 0] - 1.0 - exact).max() < 1e-6


@pytest.mark.parametrize(
    ("fields", "words"),
    [
        ({"relaxation_time": None}, "relaxation_time: missing"),
        ({"relaxing_EA": None}, "relaxing_EA: missing"),
        ({"EA": np.inf}, "nothing relaxes"),
        ({"axial_damping": 3.0, "tension_only": True}, "the loss of such a rope is its relaxation"),
        ({"relaxing_EA": -1.0}, "relaxing_EA: -1.0"),
    ],
)
def test_what_a_solid_cannot_be_is_told(fields: dict[str, Any], words: str) -> None:
    with pytest.raises(SceneError, match=words):
        stuff(**fields)


def test_the_lab_refuses_a_rope_that_relaxes() -> None:
    with pytest.raises(SceneError, match="the lab has no relaxation"):
        lab_scene(swing())
