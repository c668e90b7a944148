"""Implicit methods: convergence of Newton's method and of the steps, stiff ropes, failures."""

from __future__ import annotations

import math
import re
from typing import Any

import numpy as np
import pytest

from ropewalk.analysis.diagnosis import explain
from ropewalk.analysis.stability import stability
from ropewalk.core.status import BROKEN, OK, UNSOLVED
from ropewalk.engine.unsolved import describe
from ropewalk.methods.characteristic import growth
from ropewalk.methods.stage_report import (
    HISTORY,
    ITERATIONS,
    MISFIT,
    NODE,
    RESIDUAL,
    ROUNDING,
    SCALE,
    SOLVES,
)
from ropewalk.scene import (
    Anchor,
    Material,
    Rope,
    RunSettings,
    Scene,
    Slack,
    Straight,
    presets,
)
from ropewalk.simulation import Broken, Simulation
from ropewalk.theory import lumped_chain
from verification.setups import DOWN, IMPLICIT, chain, hold, off, run, scene, springs

FRAME = 1.0 / 60.0


def dropped(method: str, step: float, EA: float = 1e5, segments: int = 100) -> Scene:
    """DESIGN, section 6: 10 m, 5 kg, held at one end, let go from the horizontal, for 1 s."""
    rope = Rope(
        segments=segments,
        length=10.0,
        made_of=Material(EA=EA, mass_per_length=0.5),
        shape=Straight(direction=(1.0, 0.0, 0.0)),
    )
    settings = RunSettings(duration=1.0, frame_rate=60.0, time_step=step, method=method)
    return Scene(ropes=rope, anchors=[Anchor(node=0)], run=settings)


def places(method: str, step: float, EA: float = 1e5, segments: int = 100) -> np.ndarray:
    return run(dropped(method, step, EA, segments)).x[-1]


def rms(a: np.ndarray, b: np.ndarray) -> float:
    return float(np.sqrt(((a - b) ** 2).sum(axis=1).mean()))


def test_the_dropped_rope_at_one_step_per_frame() -> None:
    """sdirk2 at 1/60 s errs by at most 3 mm rms against RK4 at 5e-5 s (whose error is below 1 um: a
    fifth of its bound, fourth order), and four times less at half the step. The twins: implicit
    Euler; the same against a rope of a tenth of the stiffness.
    """
    exact = places("rk4", 5e-5)
    error = rms(places("sdirk2", FRAME), exact)
    assert 5e-4 < error < 3e-3
    assert rms(places("sdirk2", 0.5 * FRAME), exact) < 0.4 * error
    assert rms(places("implicit-euler", FRAME), exact) > 10.0 * error
    assert rms(places("sdirk2", FRAME, 1e4), exact) > 5.0 * error


def newton_orders(drag: float = 0.0) -> list[float]:
    """Orders of convergence of Newton's method, log(m2 / m1) / log(m1 / m0) of its merits, in ten steps.

    `drag` [N s/m] is put into the tangent alone: without air no law asks for it.
    """
    simulation = Simulation(dropped("implicit-euler", 0.1, 1e6, 20))
    simulation.system.node.air.node_drag[...] = drag
    report, orders = simulation._engine._scratch.stage.report, []
    for _ in range(10):
        simulation.step(0.1)
        merits = report[HISTORY : HISTORY + int(report[ITERATIONS]) + 1]
        falls = np.log(merits[1:] / merits[:-1])
        kept = (falls[:-1] < -6.0) & (merits[2:] > 1e-21 * merits[0])  # near, and above rounding
        orders += list((falls[1:] / falls[:-1])[kept])
    return orders


def test_newton_converges_quadratically() -> None:
    """The merit is a square of the residual F, and |F'| <= C |F|^2: near the solution its logarithm falls
    twice as far in each iteration as in the one before. The twin: with a tangent that is wrong in a few
    percent of its diagonal it falls by the same each time, order 1.
    """
    orders = newton_orders()
    assert len(orders) >= 5
    assert 1.75 < min(orders) <= max(orders) < 2.6
    assert np.mean(orders) == pytest.approx(2.0, abs=0.2)
    wrong = newton_orders(0.05)
    assert len(wrong) >= 5
    assert np.mean(wrong) == pytest.approx(1.0, abs=0.1)


def test_the_midpoint_rule_keeps_the_energy_of_a_linear_chain() -> None:
    """Quadratic invariants are kept exactly (Hairer, Lubich & Wanner, IV.2.1): springs of no rest
    length, a step ten times too long for explicit methods. The twin: sdirk2 loses energy.
    """
    rng = np.random.default_rng(7)
    points = np.cumsum(rng.normal(size=(6, 3)), axis=0)
    rope = chain(points, springs(300.0, 0.02, 0.0))
    step = 10.0 * math.sqrt(0.02 / 300.0)

    def drift(method: str) -> float:
        film = run(scene(rope, hold(0), dt=step, steps=400, method=method))
        return off(film.total / film.total[0], 1.0)

    assert drift("implicit-midpoint") < 1e-10
    assert drift("sdirk2") > 0.1


def test_what_is_left_of_the_fastest_modes() -> None:
    """L-stable methods leave nothing, the midpoint rule all, generalized-alpha its radius 0.8."""
    left = {"implicit-midpoint": 1.0, "generalized-alpha": 0.8}
    for method in IMPLICIT:
        assert growth(method, 1e14, 1.0) == pytest.approx(left.get(method, 0.0), abs=1e-3)


def test_the_report_s_rope_at_one_step_per_frame() -> None:
    """k = 10000 at 60 Hz, which the report found impossible: no break, and never more energy than at
    the start. The twin: the report's own method breaks.
    """
    r1 = presets.preset("r4")
    stiff = r1.replace(run=r1.run.replace(method="sdirk2", time_step=FRAME, duration=2.0))
    simulation = Simulation(stiff)
    assert simulation.plan.steps_per_frame == 1
    film = run(simulation)
    assert np.isfinite(film.x).all()
    own = stiff.replace(run=stiff.run.replace(method="semi-implicit-euler"))
    with pytest.raises(Broken):
        [*map(Simulation(own).step, [None] * 60)]


def test_an_unsolvable_step_is_said_with_time_and_node() -> None:
    """Overflow leaves no solution: one sentence with the step, the node and what to try."""
    rope = chain(np.array([(i, 0.0, 0.0) for i in range(6)]), springs(10.0, 0.1, 1.0))
    made = scene(rope, hold(0), dt=0.01, steps=10, method="sdirk2", gravity=DOWN)
    simulation, kept = Simulation(made), Simulation(made)
    for one in (simulation, kept):
        one.arrays.v[1, 3] = 1e200
    with pytest.raises(Broken, match=r"sdirk2 found no solution of step 1 at t = .* node"):
        simulation.step()
    assert simulation._engine._scratch.stage.report[SOLVES] > 0
    assert kept.advance_frames(5).frames == 0
    assert "Try a shorter time_step" in kept.failure


def test_a_run_that_fails_midway_keeps_what_it_has() -> None:
    """An anchor leaves in the sixth step, farther than links that do not stretch reach.

    Five frames are kept, those of a run without it; the sentence names step, time, place, what is left and
    the anchors. The twin: at 1 m/s it stays in reach, and the run goes on.
    """
    run, down = 0.95, math.sqrt(1.0 - 0.95**2)  # of a link on a slope
    points = np.array(
        [
            *[(0.0, 0.0, 0.0), (run, 0.0, -down), (2 * run, 0.0, -2 * down)],
            *[(2 * run + 1.0, 0.0, -2 * down), (3 * run + 1.0, 0.0, -down), (4.8, 0.0, 0.0)],
        ]
    )

    def film(speed: float) -> tuple[Simulation, Any]:
        motion = {"kind": "velocity", "velocity": (-speed, 0.0, 0.0), "start": 0.055}
        rope = chain(points, springs(math.inf, 0.1, 1.0))
        anchors = [Anchor(node=0, motion=motion), Anchor(node=5)]
        made = scene(rope, anchors, dt=0.01, steps=20, method="esdirk3", gravity=DOWN)
        simulation = Simulation(made)
        return simulation, simulation.advance_frames(20)

    broken, block = film(100.0)
    whole, other = film(1.0)
    assert (block.status, other.status) == (UNSOLVED, OK)
    assert (block.frames, other.frames) == (5, 20)
    assert broken.time == pytest.approx(0.05)
    for kept, expected in zip(block.recording, other.recording, strict=True):
        np.testing.assert_array_equal(kept, expected[:5])
    np.testing.assert_array_equal(broken.positions.T, block.recording.x[-1])
    said = (
        r"esdirk3 found no solution of step 6 at t = 0\.05\d* s, not even in parts of 2\.4e-06 s: at node "
        r"\d of rope 'rope' a force of \S+ N stays unbalanced.* anchors 'anchor0' and 'anchor1' are "
        r"5\.00\d* m apart, with 5 m of rope"
    )
    assert re.match(said, broken.failure)
    assert whole.failure == ""
    # who goes on from an earlier frame reads reactions without those of the parts that were solved
    assert not broken._engine._scratch.reaction.any()


def test_what_is_farthest_from_solved_is_named_first() -> None:
    """A segment whose tension and length disagree, where the forces balance; the twin: where they do not."""
    made = dropped("bdf2", FRAME, segments=6)
    for residual, first in ((1e-9, "segment 3 of rope 'rope' is 0.002 m off"), (1e3, "at node 2")):
        simulation = Simulation(made)
        simulation.arrays.v[1, 3] = 1e200
        assert simulation.advance_steps(1) == UNSOLVED
        stage = simulation._engine._scratch.stage
        stage.saddle.misfit[:] = 0.0
        stage.saddle.misfit[3] = 2e-3
        stage.report[[RESIDUAL, NODE, SCALE, MISFIT, ROUNDING]] = residual, 2, 1.0, 1e6, 0.0
        clock = simulation.model, simulation.arrays, simulation.clock
        assert f" s: {first}" in describe(*clock, simulation._engine._scratch)


@pytest.mark.parametrize("method", ["implicit-midpoint", "generalized-alpha", "bdf2"])
def test_a_method_that_rings_is_named_where_it_breaks(method: str) -> None:
    """A stiff rope dropped, at 1/60 s: `check` says that no limit holds for small motions only, and the
    break, with a solution or without, names what to take. The twin: bdf2 goes on.
    """
    made = dropped(method, FRAME, EA=1e7, segments=20)
    simulation, other, verdict = Simulation(made), Simulation(made), stability(made).verdict
    block = simulation.advance_frames(120)
    other.arrays.v[1, 3] = 1e200
    assert other.advance_steps(1) == UNSOLVED
    if method == "bdf2":
        assert block.status == OK
        assert "small motions" not in verdict
        assert "look for anchors" in other.failure
        return
    assert "no limit, for small motions only" in verdict
    assert block.status == BROKEN
    broken = explain(simulation)
    assert "bdf2 or esdirk3" in broken.advice[0]
    for said in (broken.text, other.failure):
        assert "bdf2 or esdirk3, or a shorter" in said
        assert "anchors" not in said


def swing(method: str, step: float) -> tuple[np.ndarray, np.ndarray]:
    """Positions and tensions after 0.4 s of a rope of 1 m and EA 1e9 N, let go at an angle."""
    rope = Rope(
        segments=5,
        length=1.0,
        made_of=Material(EA=1e9, mass_per_length=0.5),
        shape=Straight(direction=(1.0, 0.0, -0.5)),
    )
    settings = RunSettings(duration=0.4, frame_rate=2.5, time_step=step, method=method)
    simulation = Simulation(Scene(ropes=rope, anchors=[Anchor(node=0)], run=settings))
    simulation.step(0.4)
    return simulation.positions.copy(), simulation.arrays.tension.copy()


@pytest.mark.parametrize(
    ("method", "places_order", "tension_order"),
    [
        ("implicit-euler", 1.0, 1.0),
        ("bdf2", 2.0, 2.0),
        ("sdirk2", 1.0, 0.0),
        ("esdirk3", 2.1, 1.0),
        ("generalized-alpha", 2.0, 1.0),
        ("implicit-midpoint", 2.0, None),
    ],
)
def test_orders_on_a_stiff_rope(
    method: str, places_order: float, tension_order: float | None
) -> None:
    """Steps far above 1 / omega (2e-5 s): index-3 behaviour, where the stage order decides (Hairer,
    Lubich & Roche 1989; Hairer & Wanner II, VII.4). sdirk2, of stage order 1, keeps order 1 in the
    places and none in the tensions. Against esdirk3 at a 64th of the finer step. Twin: another order.
    """
    x, tension = swing("esdirk3", 0.4 / 16384)
    steps = [0.4 / 128, 0.4 / 256]
    found = [swing(method, step) for step in steps]
    order = math.log2(rms(found[0][0], x) / rms(found[1][0], x))
    assert order == pytest.approx(places_order, abs=0.15)
    assert abs(order - places_order - 1.0) > 0.5
    if tension_order is not None:
        order = math.log2(off(found[0][1], tension) / off(found[1][1], tension))
        assert order == pytest.approx(tension_order, abs=0.15)


def test_what_stiffness_does_to_the_tensions() -> None:
    """The dropped rope at EA 1e7 N and one step per frame: bdf2 and esdirk3 keep the anchor's tension
    within 3 % rms, against esdirk3 at a 64th of the step; sdirk2's is off by more than it is (twin).
    """

    def pull(method: str, step: float) -> np.ndarray:
        return run(dropped(method, step, 1e7)).block.recording.tension[5:40, 0]

    exact = pull("esdirk3", FRAME / 64)

    def error(method: str) -> float:
        return float(np.sqrt(((pull(method, FRAME) - exact) ** 2).mean()) / exact.mean())

    assert error("bdf2") < 0.03
    assert error("esdirk3") < 0.03
    assert error("sdirk2") > 0.5


@pytest.mark.parametrize("EA", [1e6, 1e12])
def test_recorded_tensions_keep_their_digits(EA: float) -> None:
    """A rope at rest between two anchors for 1 s: the lumped chain's tensions (closed forms 2.2) to 1e-9
    after every step. The twin: k (r - L) of the recorded places is off by some eps EA / T, 3e-4 at EA 1e12 N.
    """
    n, length = 20, 2.0
    rope = Rope(
        segments=n,
        length=length,
        made_of=Material(EA=EA, mass_per_length=0.5),
        shape=Slack(start=(0, 0, 0), end=(1.5, 0, 0)),
    )
    settings = RunSettings(duration=1.0, time_step=FRAME, method="bdf2", start="at-rest")
    film = run(Scene(ropes=rope, anchors=hold(0, -1), run=settings))
    k, size = EA * n / length, length / n
    exact = lumped_chain(np.full(n - 1, 0.5 * size * 9.81), k, size, 1.5).tension
    assert off(film.block.recording.tension[1:] / exact, 1.0) < 1e-9
    if EA == 1e12:
        r = np.linalg.norm(np.diff(film.x[-1], axis=0), axis=1)
        assert off(k * (r - size) / exact, 1.0) > 1e-5
