"""Rigid links: pendulums against their exact motion, tensions, lengths, limits and refusals."""

from __future__ import annotations

import math
from contextlib import suppress
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.special import ellipk

from ropewalk.core.status import UNSOLVED
from ropewalk.methods.registry import METHODS
from ropewalk.scene import (
    Anchor,
    Hanging,
    Kick,
    Limiter,
    Material,
    Rope,
    RunSettings,
    Scene,
    SceneError,
    Slack,
    Straight,
    Winch,
)
from ropewalk.simulation import Broken, Simulation
from ropewalk.theory import lumped_chain
from verification.setups import DOWN, chain, g, hold, off, run, scene, springs

ABLE = tuple(name for name, method in METHODS.items() if method.holds_links)
INF = math.inf


def lengths_error(x: np.ndarray, length: float) -> float:
    """Largest relative error of a segment's length over all frames; x (f, n, 3) [m]."""
    size = np.linalg.norm(np.diff(x, axis=1), axis=2)
    return float(np.abs(size / length - 1.0).max())


def pendulum(method: str, steps: int) -> Simulation:
    """One link of 0.7 m let go from the horizontal, after 5/4 of its exact period, in `steps` steps.

    Period 4 sqrt(L/g) K(sin(45 deg)) (Landau & Lifshitz, Mechanics, sec. 11); it is then at the bottom.
    """
    duration = 5.0 * math.sqrt(0.7 / g) * float(ellipk(0.5))
    rope = chain(np.array([(0.0, 0.0, 0.0), (0.7, 0.0, 0.0)]), springs(INF, 0.3, 0.7))
    made = scene(rope, hold(0), dt=duration / steps, steps=steps, method=method, gravity=DOWN)
    simulation = Simulation(made)
    assert simulation.advance_steps(steps) == 0
    return simulation


@pytest.mark.parametrize(("method", "order"), [("implicit-euler", 1), ("bdf2", 2), ("esdirk3", 2)])
def test_a_pendulum_has_its_exact_period(method: str, order: int) -> None:
    """After 5/4 periods the link hangs straight down, moves at sqrt(2 g L) and pulls with 3 m g; the
    error falls with the method's order for constraints (Hairer & Wanner II, VII.4). Twin: 1 % less gravity
    is a phase of 0.5 % in 7.9 rad or 0.03 m, more than either method's error.
    """
    errors = []
    for steps in (400, 800, 1600):
        simulation = pendulum(method, steps)
        x, v = simulation.positions[1], simulation.velocities[1]
        errors.append(abs(x[0]) + abs(math.hypot(*v) - math.sqrt(2.0 * g * 0.7)))
        assert abs(math.hypot(*x) / 0.7 - 1.0) < 1e-14
    for coarse, fine in pairwise(errors):
        assert math.log2(coarse / fine) == pytest.approx(order, abs=0.3)
    if method != "implicit-euler":
        assert errors[-1] < 1e-3
        assert simulation.arrays.tension[0] == pytest.approx(3.0 * 0.3 * g, rel=2e-2)


def double_pendulum(t: float) -> np.ndarray:
    """Places of both nodes [m] after `t` [s] from both links horizontal, masses 0.2 kg, links 0.5 m.

    Lagrange's equations in the angles from the vertical (Landau & Lifshitz, sec. 5, problem 1).
    """
    L, m = 0.5, 0.2

    def rates(_: float, y: np.ndarray) -> list[float]:
        a, b, p, q = y
        c, s = math.cos(a - b), math.sin(a - b)
        matrix = m * L * L * np.array([[2.0, c], [c, 1.0]])
        right = m * L * L * np.array([-s * q * q, s * p * p]) - m * g * L * np.array(
            [2.0 * math.sin(a), math.sin(b)]
        )
        return [p, q, *np.linalg.solve(matrix, right)]

    start = [0.5 * math.pi, 0.5 * math.pi, 0.0, 0.0]
    found = solve_ivp(rates, (0.0, t), start, method="DOP853", rtol=1e-12, atol=1e-12).y[:, -1]
    first = L * np.array([math.sin(found[0]), -math.cos(found[0]), 0.0])
    return np.array([first, first + L * np.array([math.sin(found[1]), -math.cos(found[1]), 0.0])])


@pytest.mark.parametrize(("method", "most"), [("bdf2", 2e-3), ("esdirk3", 5e-5)])
def test_a_double_pendulum(method: str, most: float) -> None:
    """Against scipy's solution in the angles after 1.2 s; second order. Twin: springs of EA 100 N."""
    exact = double_pendulum(1.2)

    def places(steps: int, k: float = INF) -> np.ndarray:
        points = np.array([(0.5 * i, 0.0, 0.0) for i in range(3)])
        rope = chain(points, springs(k, 0.2, 0.5))
        made = scene(rope, hold(0), dt=1.2 / steps, steps=steps, method=method, gravity=DOWN)
        simulation = Simulation(made)
        assert simulation.advance_steps(steps) == 0
        return simulation.positions[1:]

    errors = [off(places(steps), exact) for steps in (1000, 2000)]
    assert errors[1] < most
    assert math.log2(errors[0] / errors[1]) == pytest.approx(2.0, abs=0.4)
    assert off(places(2000, 200.0), exact) > 1e-2


def test_tensions_at_rest_are_those_of_the_closed_forms() -> None:
    """A hanging chain carries what is below each link; one between two anchors the lumped chain's tensions
    (closed forms 2.2, k = inf). Started at rest, both stay there, at the first frame and after 1 s.
    """
    made_of, n = Material(EA=INF, mass_per_length=0.5), 12
    for shape, anchors in ((Hanging(), [0]), (Slack(start=(0, 0, 0), end=(3, 0, 0.5)), [0, -1])):
        rope = Rope(segments=n, length=4.0, made_of=made_of, shape=shape)
        settings = RunSettings(duration=1.0, time_step=1 / 60, method="bdf2", start="at-rest")
        film = run(Scene(ropes=rope, anchors=hold(*anchors), run=settings))
        weight = 0.5 * 4.0 / n * g
        if len(anchors) == 1:
            expected = weight * (n - 0.5 - np.arange(n))
        else:
            expected = lumped_chain(np.full(n - 1, weight), INF, 4.0 / n, 3.0, 0.5).tension
        tension = film.block.recording.tension
        assert off(tension[0] / expected, 1.0) < 1e-8
        assert off(tension[-1] / expected, 1.0) < 1e-7
        assert off(film.x, film.x[0]) < 1e-9
        assert off(film.block.recording.energy[:, 2], 0.0) == 0.0


def thrown(method: str, step: float, frames: int = 100, every: int = 20, **more: Any) -> Scene:
    """Sixteen links held at one end and let go from the horizontal, their end kicked sideways."""
    rope = Rope(
        segments=16,
        length=2.0,
        made_of=Material(mass_per_length=0.3, **({"EA": INF} | more)),
        shape=Straight(direction=(1, 0, 0)),
        kicks=[Kick(node=-1, velocity=(0.0, 2.0, 0.0))],
    )
    rate = 1.0 / (every * step)
    settings = RunSettings(
        duration=frames / rate, frame_rate=rate, time_step=step, steps="exact", method=method
    )
    return Scene(ropes=rope, anchors=hold(0), run=settings)


@pytest.mark.parametrize("method", ABLE)
def test_lengths_hold_for_thousands_of_steps(method: str) -> None:
    """4000 steps of a thrown chain, or those that adaptive takes for as long: lengths to 1e-9 of theirs at
    every frame (twin: EA 1e4 N), no elastic energy, the books of kinetic energy closed to rounding, and
    never more energy than at the start.
    """
    film = run(thrown(method, 1e-3, frames=200))
    assert film.simulation.time == pytest.approx(4.0)
    assert lengths_error(film.x, 0.125) < 1e-9
    energy = film.block.recording.energy
    assert off(energy[:, 2], 0.0) == 0.0
    turned = 0.6 * g * 2.0
    assert off(film.residual(), 0.0) < 1e-10 * turned
    assert (film.total - film.total[0]).max() < 1e-3 * turned
    soft = run(thrown(method, 1e-3, frames=20, EA=1e4))
    assert lengths_error(soft.x, 0.125) > 1e-5


def books(method: str, spoil: float = 1.0) -> tuple[float, float]:
    """What the books leave open after 100 steps of varying length [J], and the lengths' relative error.

    The forces that the next step begins with are multiplied by `spoil`.
    """
    simulation = Simulation(thrown(method, 1.0 / 60.0, frames=1, every=1))
    first = simulation.recording().recording
    for step in np.random.default_rng(3).uniform(1e-3, 1.0 / 60.0, 100):
        simulation.step(float(step))
        simulation.arrays.forces.elastic[...] *= spoil
    last = simulation.recording().recording
    gained = float(last.energy[0, 0] - first.energy[0, 0])
    lengths = lengths_error(simulation.positions[None], 0.125)
    return abs(gained - float(last.work[0].sum())), lengths


@pytest.mark.parametrize("method", ABLE)
def test_the_books_close_in_steps_of_varying_length(method: str) -> None:
    """Kinetic energy gained is all work done, to rounding: also where bdf2 cannot follow its last step and
    begins anew, with the forces at the start and not the mean ones that it keeps. The twin: esdirk3, which
    takes over the forces it finds, with a tenth of them missing.
    """
    turned = 0.6 * g * 2.0
    left, lengths = books(method)
    assert left < 1e-12 * turned
    assert lengths < 1e-9
    if method == "esdirk3":
        assert books(method, 0.9)[0] > 1e-3 * turned


def test_auto_takes_a_method_that_holds_links() -> None:
    made = thrown("esdirk3", 1e-3)
    chosen = Simulation(made.replace(run=made.run.replace(method="auto", time_step="auto"))).plan
    assert chosen.method == "esdirk3"
    assert "rigid links" in chosen.why


def test_a_kick_along_a_link_is_shared_like_an_impact() -> None:
    """A link's end is kicked at 2 m/s along it: both equal masses go on at 1 m/s. Across it, it stays."""
    rope = chain(
        np.array([(0.0, 0.0, 0.0), (1.0, 0.0, 0.0)]),
        springs(INF, 0.1, 1.0),
        kicks=[Kick(node=1, velocity=(2.0, 3.0, 0.0))],
    )
    simulation = Simulation(scene(rope, dt=0.01, steps=10, method="bdf2"))
    assert off(simulation.velocities, [[1.0, 0.0, 0.0], [1.0, 3.0, 0.0]]) < 1e-14
    # the first tension turns the relative velocity: m u^2 / (2 r)
    assert simulation.arrays.tension[0] == pytest.approx(0.5 * 0.1 * 9.0, rel=1e-12)


def test_stiff_ropes_converge_to_rigid_links() -> None:
    """The difference to a rope of stiffness EA falls as 1 / EA, from 1e6 to 1e10 N; at the same steps, by
    implicit Euler, which begins with nothing but places and velocities."""

    def end(EA: float) -> np.ndarray:
        return run(thrown("implicit-euler", 5e-3, frames=20, every=5, EA=EA)).x[-1]

    rigid = end(INF)
    errors = [off(end(EA), rigid) for EA in (1e6, 1e8, 1e10)]
    for coarse, fine in pairwise(errors):
        assert coarse / fine == pytest.approx(100.0, rel=0.2)


def test_a_string_goes_slack_and_taut_again() -> None:
    """A tension-only link: its mass, thrown up inside the circle, is free until the string is taut, then
    never farther than its length, and never pushed. The twin: a rod pushes, and holds it on the circle.
    """

    def film(tension_only: bool):
        rope = chain(
            np.array([(0.0, 0.0, 0.0), (0.0, -1.0, 0.0)]),
            springs(INF, 0.2, 1.0, tension_only=tension_only),
            kicks=[Kick(node=1, velocity=(5.5, 0.0, 0.0))],
        )
        made = scene(rope, hold(0), dt=2e-3, steps=800, method="bdf2", gravity=DOWN)
        return run(made)

    string, rod = film(True), film(False)
    away = np.linalg.norm(string.x[:, 1], axis=1)
    assert away.max() < 1.0 + 1e-9
    assert away.min() < 0.97
    tension = string.block.recording.tension[:, 0]
    assert tension.min() == 0.0
    assert tension[1] == pytest.approx(0.2 * (g + 5.5**2), rel=1e-2)
    assert (string.total - string.total[0]).max() < 1e-2
    assert rod.block.recording.tension.min() < -0.1
    assert lengths_error(rod.x, 1.0) < 1e-9


@pytest.mark.parametrize("kinds", [(INF, INF), (INF, 1e4), (1e4, 1e3)])
def test_ropes_in_one_scene_do_not_feel_each_other(kinds: tuple[float, float]) -> None:
    """Two ropes that do not touch, rigid or elastic, held or free, move as each does alone."""
    ropes = {
        name: Rope(
            name=name,
            segments=8,
            length=2.0,
            made_of=Material(EA=EA, mass_per_length=0.2),
            shape=Slack(start=(0, 0, 0), end=(1.5, 0, 0)),
            kicks=[Kick(node=4, velocity=(0.0, 1.0, 0.0))],
        )
        for name, EA in zip("ab", kinds, strict=True)
    }

    def end(*names: str, held: tuple[int, ...] = (0, -1), **more: Any) -> np.ndarray:
        anchors = [Anchor(rope=name, node=node) for name in names for node in held]
        settings = RunSettings(duration=0.5, time_step=5e-3, method="esdirk3")
        made = Scene(ropes=[ropes[n] for n in names], anchors=anchors, run=settings, **more)
        return run(made).x[-1]

    for held in ((0, -1), (0,)):
        both = end("a", "b", held=held)
        assert off(both[:9], end("a", held=held)) < 1e-9
        assert off(both[9:], end("b", held=held)) < 1e-9
    if kinds == (INF, 1e4):
        wound = end("a", "b", winches=[Winch(rope="b", end="start", speed=-0.1)])
        assert lengths_error(wound[None, :9], 0.25) < 1e-9
        assert off(wound[9:], both[9:]) > 1e-2


def refusal(**keys: Any) -> str:
    """What is said of a scene of rigid links that is refused when it is run."""
    shape = keys.pop("shape", Slack(start=(0, 0, 0), end=(8, 0, 0)))
    method, anchors = keys.pop("method", "bdf2"), keys.pop("anchors", hold(0, -1))
    rope = Rope(
        segments=20, length=10.0, made_of=Material(EA=INF, mass_per_length=0.5), shape=shape
    )
    with pytest.raises(SceneError) as caught:
        Simulation(
            Scene(
                ropes=rope, anchors=anchors, run=RunSettings(method=method, time_step=0.01), **keys
            )
        )
    return str(caught.value)


@pytest.mark.parametrize("method", [name for name in METHODS if not METHODS[name].holds_links])
def test_other_methods_refuse_rigid_links(method: str) -> None:
    said = refusal(method=method)
    assert f'run.method: "{method}" - cannot hold the lengths of rigid links' in said
    assert "methods that can: implicit-euler, bdf2, esdirk3" in said


def test_what_cannot_be_built() -> None:
    span = refusal(shape=Straight(end=(10.2, 0, 0)))
    assert "anchors 'anchor0' and 'anchor1' are 10.2 m apart, with 10 m of rope" in span
    assert "nothing determines its tension" in refusal(shape=Straight(end=(10, 0, 0)))
    assert "is 9 m long, but the rope is 10 m" in refusal(shape=Straight(end=(9, 0, 0)))
    assert "less straight" in refusal(shape=Straight(end=(9.9, 0, 0)))
    assert "rigid (inf)" in refusal(limiter=Limiter(min_stretch=1.05, max_stretch=1.1))
    assert "which a winch cannot wind" in refusal(winches=[Winch(end="start", speed=0.1)])


def test_anchors_that_pull_too_far_end_the_run_with_all_before_it() -> None:
    """The right anchor leaves at 1 m/s from 8 m; 10 m of rope: no solution beyond 2 s. All frames before are
    kept, and the sentence says which anchors. The twin: an elastic rope goes on.
    """
    moved = [Anchor(node=0), Anchor(node=-1, motion={"kind": "velocity", "velocity": (1.0, 0, 0)})]
    for EA in (INF, 1e4):
        rope = Rope(
            segments=20,
            length=10.0,
            made_of=Material(EA=EA, mass_per_length=0.5),
            shape=Slack(start=(0, 0, 0), end=(8, 0, 0)),
        )
        settings = RunSettings(duration=2.5, time_step=1 / 60, method="bdf2")
        simulation = Simulation(Scene(ropes=rope, anchors=moved, run=settings))
        block = simulation.advance_frames(150)
        if EA < INF:
            assert block.frames == 150
            continue
        assert block.status == UNSOLVED
        assert 1.9 < block.time[-1] < 2.0 + 1 / 60
        assert np.isfinite(block.recording.x).all()
        for part in (
            "found no solution of step 12",
            "segment",
            "unbalanced",
            "'anchor0' and 'anchor1'",
        ):
            assert part in simulation.failure


def test_after_a_failure_time_and_state_agree() -> None:
    """The anchor that leaves at 1 m/s stands at 8 m + t wherever it stopped: in one call of many steps, in
    single ones, in frames; between two steps where parts of the last one were solved. The twin: the time
    that was asked for.
    """
    moved = [Anchor(node=0), Anchor(node=-1, motion={"kind": "velocity", "velocity": (1.0, 0, 0)})]
    made_of = Material(EA=INF, mass_per_length=0.5)
    shape = Slack(start=(0, 0, 0), end=(8, 0, 0))
    rope = Rope(segments=20, length=10.0, made_of=made_of, shape=shape)
    settings = RunSettings(duration=4.0, time_step=1 / 60, method="bdf2")
    scene = Scene(ropes=rope, anchors=moved, run=settings)
    ways = (
        lambda one: one.step(3.0),
        lambda one: [one.step() for _ in range(180)],
        lambda one: one.advance_steps(180),
        lambda one: one.advance_frames(180, keep_going=True),
    )
    for way in ways:
        simulation = Simulation(scene)
        with suppress(Broken):
            way(simulation)
        assert "found no solution of step 12" in simulation.failure
        assert simulation.positions[-1, 0] == pytest.approx(8.0 + simulation.time, abs=1e-9)
        assert 1.9 < simulation.time < 2.0 + 1e-9
        assert abs(simulation.time - 3.0) > 0.9


def test_a_rod_that_bends_but_does_not_stretch() -> None:
    """EA = inf with EI: the lengths hold, and it stays nearly straight (the twin: without EI it folds)."""

    def span(EI: float) -> float:
        film = run(thrown("esdirk3", 2e-3, frames=30, EI=EI))
        assert lengths_error(film.x, 0.125) < 1e-9
        return float(np.linalg.norm(film.x[:, -1] - film.x[:, 0], axis=1).min())

    assert span(20.0) > 1.9
    assert span(0.0) < 1.8
