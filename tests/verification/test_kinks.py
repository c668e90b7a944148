"""Where anchors and clamps start, stop and turn corners, at steps and inside them: no order is lost."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cache
from typing import Any

import numpy as np
import pytest

from ropewalk.api import simulate
from ropewalk.lowering import build
from ropewalk.methods.kinks import next_kink
from ropewalk.methods.registry import METHODS
from ropewalk.motions.tabulated import cubic_rows, speed
from ropewalk.scene import Anchor, Clamp, Load, Material, Rope, Scene, Straight, Table, Velocity
from ropewalk.simulation import Simulation
from verification.setups import ALL, DOWN, along_x, chain, scene, springs

END = 0.2  # s
STEPS = {"verlet": 400, "heun": 400, "rk4": 200, "esdirk3": 40}
AT_A_STEP, INSIDE = 0.1, 0.2 / math.pi  # s
CORNERS = Table(
    times=[0.0, INSIDE, AT_A_STEP, 1.0],
    positions=[(0.0, 0.0, 0.0), (0.02, 0.05, 0.0), (0.0, 0.0, 0.03), (0.5, 0.5, 0.0)],
)


def pulled(motion: Any) -> dict[str, Any]:
    """A chain with friction along its segments, one end moved."""
    points = np.array([(0.25 * i, -0.05 * i * (5 - i), 0.03 * i) for i in range(6)])
    rope = chain(points, springs(60.0, 0.1, 0.25, 0.2, friction="axial"))
    return {"rope": rope, "anchors": [Anchor(node=0, motion=motion), Anchor(node=5)]}


def turned(start: float) -> dict[str, Any]:
    """A rod with bending damping, clamped at an end that begins to turn."""
    points = along_x(np.linspace(0.0, 1.0, 6))
    points[:, 1] = 0.02 * np.sin(3.0 * points[:, 0])
    made_of = Material(
        EA=200.0, mass_per_length=0.2, EI=0.5, bending_damping=0.02, axial_damping=0.5
    )
    clamp = Clamp(direction=(1, 0, 0), turn_axis=(0, 0, 1), turn_rate=2.0, start=start, stop=9.0)
    rope = chain(points, made_of, length=1.0)
    return {"rope": rope, "anchors": [Anchor(node=0, clamp=clamp), Anchor(node=5)]}


KNOTS = Table(
    times=[-0.03, 0.02, INSIDE, AT_A_STEP, 0.16, 0.3],
    positions=[
        *[(0.0, 0.0, 0.0), (0.02, 0.05, 0.0), (0.05, 0.04, 0.03)],
        *[(0.05, 0.05, 0.02), (0.08, 0.05, 0.05), (0.1, 0.1, 0.1)],
    ],
    interpolation="cubic",
)


def let_go(time: float) -> dict[str, Any]:
    """A chain with friction along its segments, one end of which is let go."""
    made = pulled({"kind": "fixed"})
    return made | {"anchors": [Anchor(node=0, release_time=time), Anchor(node=5)]}


CASES = {
    "knots of a cubic table": pulled(KNOTS),
    "a start at a step": pulled(Velocity(velocity=(0.4, 0.9, 0.0), start=AT_A_STEP, stop=9.0)),
    "a start inside a step": pulled(Velocity(velocity=(0.4, 0.9, 0.0), start=INSIDE, stop=0.15)),
    "corners of a table": pulled(CORNERS),
    "a clamp from the start": turned(0.0),
    "a clamp at a step": turned(AT_A_STEP),
    "a clamp inside a step": turned(INSIDE),
    "a release at a step": let_go(AT_A_STEP),
    "a release inside a step": let_go(0.2 / math.e),
}


@cache
def end_state(case: str, method: str, steps: int, cut: bool = True) -> np.ndarray:
    """Places and velocities at END; without `cut` the simulation is told of no kinks."""
    made = scene(
        **CASES[case], dt=END / steps, steps=steps, every=steps, method=method, gravity=DOWN
    )
    model = build(made)
    if not cut:
        model = replace(model, system=model.system._replace(kinks=np.zeros(0)))
    simulation = Simulation(model)
    assert simulation.advance_frames(1).status == 0
    return np.concatenate([simulation.positions.ravel(), simulation.velocities.ravel()])


def order(case: str, method: str, cut: bool = True) -> float:
    """Fit the order of convergence to what rk4 finds in 1600 steps."""
    exact, n = end_state(case, "rk4", 1600), STEPS.get(method, 80)
    errors = [np.linalg.norm(end_state(case, method, s, cut) - exact) for s in (n, 2 * n)]
    return math.log2(errors[0] / errors[1])


@pytest.mark.parametrize("case", CASES)
@pytest.mark.parametrize("method", [m for m in ALL if METHODS[m].order > 1 and m != "rk4"])
def test_kinks_cost_no_order(method: str, case: str) -> None:
    """Within 0.4 of the method's order, where fixed steps have their order at all."""
    assert order(case, method) > METHODS[method].order - 0.4


@pytest.mark.parametrize(
    "case", ["corners of a table", "a clamp at a step", "a release inside a step"]
)
@pytest.mark.parametrize("method", ["heun", "esdirk3"])
def test_the_twin_loses_it(method: str, case: str) -> None:
    """Without the kinks' times the same steps are of order one, or little above where the kinks are small."""
    assert order(case, method, cut=False) < 2.0


POSES = np.array([(0.0, 0.0, 0.0), (0.02, 0.05, 0.0), (0.0, 0.0, 0.03), (0.05, 0.05, 0.0)])
SPAN = 0.05  # s between two poses


def as_table(steps: int, method: str) -> Simulation:
    """The end of a chain goes through poses along straight lines that the scene knows."""
    made = pulled(Table(times=[SPAN * k for k in range(4)], positions=[tuple(p) for p in POSES]))
    dt = SPAN / steps
    simulation = Simulation(scene(**made, dt=dt, steps=3 * steps, method=method, gravity=DOWN))
    simulation.step(3 * SPAN)
    return simulation


def by_hand(steps: int, method: str, how: str) -> Simulation:
    """The same motion, as a program that owns the loop gives it: by speed, by pose, or a step too late."""
    dt = SPAN / steps
    made = scene(**pulled({"kind": "fixed"}), dt=dt, steps=3 * steps, method=method, gravity=DOWN)
    simulation = Simulation(made)
    end = simulation.anchors[simulation.layout.anchor_names[0]]
    for k in range(3):
        if how == "pose":
            end.move_to(POSES[k + 1])
        elif how == "speed":
            end.velocity = (POSES[k + 1] - POSES[k]) / SPAN
        if how != "late":
            simulation.step(SPAN)
            continue
        simulation.step(dt)
        end.velocity = (POSES[k + 1] - POSES[k]) / SPAN
        simulation.step(SPAN - dt)
    return simulation


def free_nodes(simulation: Simulation) -> np.ndarray:
    """Places and velocities of the nodes that nothing holds."""
    return np.concatenate([simulation.positions[1:].ravel(), simulation.velocities[1:].ravel()])


@pytest.mark.parametrize("method", [m for m in ALL if METHODS[m].order > 1])
def test_hands_and_poses_cost_no_order(method: str) -> None:
    """A motion in hand is that of a table whose corners are known: the first step has the new rate."""
    exact = free_nodes(as_table(50, method))
    for how in ("speed", "pose"):
        found = free_nodes(by_hand(50, method, how))
        assert np.abs(found - exact).max() < 1e-10 * np.abs(exact).max(), how
    twin = free_nodes(by_hand(50, method, "late"))
    assert np.abs(twin - exact).max() > 1e-4 * np.abs(exact).max()


def test_the_work_of_a_hand_is_its_anchors() -> None:
    """What a jump of a hand's rate does to the kinetic energy is booked: the balance closes to rounding."""
    simulation = by_hand(20, "esdirk3", "speed")
    out = simulation.recording().recording
    first = Simulation(simulation.scene).recording().recording
    gained = out.energy[0, 0] - first.energy[0, 0]
    assert out.work[0].sum() == pytest.approx(gained, abs=1e-12)


def test_of_two_kinks_at_a_steps_begin_the_last_counts() -> None:
    """Two corners less apart than a step can tell: the rate is that after both."""
    kinks = np.array([0.1, 0.1 + 1e-13, 0.3])
    here, later = next_kink(kinks, 0.1, 0.2, 0.1)
    assert (here, later) == (kinks[1], math.inf)
    assert next_kink(kinks, 0.05, 0.15, 0.1) == (-math.inf, kinks[0])
    assert next_kink(kinks, 0.25, 0.3, 0.05) == (-math.inf, kinks[2])


def test_kinks_of_a_scene() -> None:
    """Starts, stops and corners, in order; a motion from the beginning on has none there."""
    made = Scene(ropes=[CASES["a start inside a step"]["rope"]], anchors=pulled(CORNERS)["anchors"])
    assert build(made).system.kinks.tolist() == [INSIDE, AT_A_STEP, 1.0]
    made = made.replace(anchors=CASES["a start inside a step"]["anchors"])
    assert build(made).system.kinks.tolist() == [INSIDE, 0.15]
    made = made.replace(anchors=[Anchor(node=0, motion=Velocity(velocity=(1, 0, 0)))])
    assert build(made).system.kinks.tolist() == []


def test_the_work_of_a_jump_is_the_anchors() -> None:
    """The ledger stays exact over a kink: kinetic energy gained is the sum of all works."""
    made = scene(
        **CASES["corners of a table"], dt=END / 40, steps=40, method="esdirk3", gravity=DOWN
    )
    simulation = Simulation(made)
    first = simulation.recording().recording
    block = simulation.advance_frames(40).recording
    gained = block.energy[:, 0] - first.energy[0, 0]
    assert block.work.sum(axis=1) == pytest.approx(gained, abs=1e-12)
    assert np.abs(gained).max() > 0.01


@pytest.mark.parametrize("method", ["implicit-euler", "bdf2", "sdirk2", "esdirk3"])
def test_a_stop_at_once_does_not_throw_a_damped_rope(method: str) -> None:
    """An anchor goes 0.5 m in 0.4 s and stops; steps of 1/60 s are long beside the friction's 0.03 ms.

    Friction made up 44 J and more in the step after the stop, where some 3 J were there, with all but
    implicit Euler, whose friction only takes. The reference: verlet in its own short steps.
    """
    cord = Material(EA=5000.0, mass_per_length=0.02, axial_damping=5.0)
    line = Rope(
        segments=10,
        length=0.8,
        made_of=cord,
        loads=[Load(node=-1, mass=0.3)],
        shape=Straight(end=(0.0, 0.0, -0.8)),
    )
    motion = Velocity(velocity=(1.25, 0.0, 0.0), start=0.0, stop=0.4)
    settings = {"start": "at-rest", "duration": 0.5}
    scene = Scene(ropes=[line], anchors=[Anchor(node=0, motion=motion)], run=settings)
    fine = simulate(scene.replace(**{"run.method": "verlet"}))
    long = simulate(scene.replace(**{"run.method": method, "run.time_step": 1.0 / 60.0}))
    assert long.status == "finished"
    room = 0.025 if method == "implicit-euler" else 0.003
    assert np.abs(long.positions[-1, -1] - fine.positions[-1, -1]).max() < room


def test_the_largest_speed_of_a_table_is_that_of_a_dense_sample() -> None:
    """Nine samples between two rows had up to 1.4 % less: a bound is on the safe side."""
    random, worst = np.random.default_rng(0), 0.0
    for _ in range(200):
        count = int(random.integers(3, 7))
        times = np.cumsum(10.0 ** random.uniform(-1.0, 0.5, count))
        places = random.normal(size=(count, 3)) * (np.arange(3) < random.integers(1, 4))
        rows = cubic_rows(
            Table(times=times.tolist(), positions=places.tolist(), interpolation="cubic")
        )
        s = (np.diff(rows[:, 0])[:, None] * np.linspace(0.0, 1.0, 1001))[:, :, None]
        c1, c2, c3 = (rows[:-1, None, i::4] for i in (2, 3, 4))
        dense = np.linalg.norm(c1 + s * (2.0 * c2 + 3.0 * s * c3), axis=2)
        found = speed(rows[0], rows, math.inf)
        assert 1.0 - 1e-6 < found / dense.max() < 1.0 + 1e-5
        worst = max(worst, found / dense[:, ::125].max() - 1.0)
    assert worst > 0.003  # what nine samples miss in these
