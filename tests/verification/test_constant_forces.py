"""Constant forces and weights in water: closed forms at rest, ledgers and balances in motion."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.live.edits import cut
from ropewalk.lowering import build
from ropewalk.methods.registry import METHODS
from ropewalk.scene import (
    Anchor,
    Force,
    Load,
    Rope,
    RunSettings,
    Scene,
    Slack,
    Springs,
    Straight,
    loads,
)

G = 9.81


def rope(**changes: object) -> Rope:
    """5 m of cord between two points 4 m apart."""
    stuff = changes.pop("stuff", {})
    made = rw.Material(**({"EA": 5000.0, "mass_per_length": 0.2, "axial_damping": 5.0} | stuff))
    shape = Slack(end=(4.0, 0.0, 0.5))
    return Rope(**({"segments": 20, "length": 5.0, "made_of": made, "shape": shape} | changes))


def scene(*ropes: Rope, held: tuple[int, ...] = (0, -1), **changes: object) -> Scene:
    anchors = [Anchor(node=node) for node in held]
    return Scene(**({"ropes": ropes, "anchors": anchors} | changes))


# -- at rest -------------------------------------------------------------------------------------


def test_in_water_a_rope_hangs_as_a_lighter_one_in_air() -> None:
    wet = rw.equilibrium(scene(rope(submerged_weight=0.05 * G)))
    light = rw.equilibrium(scene(rope(stuff={"mass_per_length": 0.05})))
    np.testing.assert_allclose(wet.positions, light.positions, atol=1e-9)
    np.testing.assert_allclose(wet.tension, light.tension, rtol=1e-9)
    # The ends' halves of segments hang on the anchors themselves.
    np.testing.assert_allclose(wet.reactions, light.reactions, atol=1e-9)
    assert wet.reactions.sum(axis=1)[0, 2] == pytest.approx(0.05 * G * 5.0, rel=1e-9)
    dry = rw.equilibrium(scene(rope()))
    assert dry.tension.max() > 3.5 * wet.tension.max()


def test_of_a_rope_that_floats_up_tables_tell_the_rise() -> None:
    """They said "sag -0 m". The twin sinks."""
    level = Slack(end=(4.0, 0.0, 0.0))
    up, down = (rw.check(scene(rope(shape=level, submerged_weight=w))) for w in (-0.5, 0.5))
    (rises,), (sags,) = up.statics.spans, down.statics.spans
    assert rises.rise == pytest.approx(sags.sag, rel=1e-9)
    assert rises.rise > 1.0
    assert math.copysign(1.0, rises.sag) == 1.0
    assert f"at rest: rise {rises.rise:.4g} m over 4 m" in str(up)
    assert f"at rest: sag {sags.sag:.4g} m over 4 m" in str(down)
    assert rises.sag_words(4).startswith("rises ")


def test_a_buoyant_rope_stands_as_a_heavy_one_hangs() -> None:
    level = Slack(end=(4.0, 0.0, 0.0))
    up = rw.equilibrium(scene(rope(shape=level, submerged_weight=-0.1 * G)))
    down = rw.equilibrium(scene(rope(shape=level, submerged_weight=0.1 * G)))
    np.testing.assert_allclose(up.positions * [1.0, 1.0, -1.0], down.positions, atol=1e-9)
    assert up.positions[0, :, 2].max() > 1.0
    # A mooring tail: held below, it stands straight up, its tension that of what is above.
    tail = rw.equilibrium(scene(rope(submerged_weight=-0.1 * G), held=(0,)))
    above = 0.1 * G * 5.0 * (1.0 - (np.arange(20) + 0.5) / 20)
    np.testing.assert_allclose(tail.tension[0], above, rtol=1e-9)
    assert tail.positions[0, -1, 2] > 5.0


@pytest.mark.parametrize("force", [(0.0, 0.0, -300.0), (120.0, 80.0, -200.0)])
def test_a_force_in_the_middle_makes_a_triangle(force: tuple[float, float, float]) -> None:
    """Two weightless springs: T1 t1 + T2 t2 = F, each T = k (r - L); see closed-forms."""
    stuff = Springs(spring_constant=2000.0, node_mass=1e-9, segment_length=2.0)
    two = Rope(
        segments=2,
        made_of=stuff,
        shape=Straight(start=(0, 0, 0), end=(3.0, 0, 0)),
        forces=[Force(node=1, force=tuple(0.5 * f for f in force)) for _ in "ab"],
    )
    found = rw.equilibrium(scene(two))
    x, pull = found.positions[0], np.zeros(3)
    for end, tension in ((0, found.tension[0, 0]), (2, found.tension[0, 1])):
        away = x[1] - x[end]
        assert tension == pytest.approx(2000.0 * (np.linalg.norm(away) - 2.0), rel=1e-9)
        pull += tension * away / np.linalg.norm(away)
    np.testing.assert_allclose(pull, force, atol=1e-6)
    np.testing.assert_allclose(found.reactions[0].sum(axis=0), -np.array(force), atol=1e-6)
    if force[0] == 0.0:  # symmetric: T = F / (2 sin a)
        sine = -x[1, 2] / np.hypot(1.5, x[1, 2])
        assert found.tension[0, 0] == pytest.approx(300.0 / (2.0 * sine), rel=1e-9)


def test_a_force_down_is_a_load_at_rest() -> None:
    forced = rw.equilibrium(scene(rope(forces=[Force(node=7, force=(0, 0, -3.0 * G))])))
    loaded = rw.equilibrium(scene(rope(loads=[Load(node=7, mass=3.0)])))
    np.testing.assert_allclose(forced.positions, loaded.positions, atol=1e-8)
    np.testing.assert_allclose(forced.tension, loaded.tension, rtol=1e-8)


# -- in motion -----------------------------------------------------------------------------------


@pytest.mark.parametrize("method", METHODS)
def test_a_free_rope_falls_by_its_weight_in_water_and_forces(method: str) -> None:
    """Its centre moves by F t^2/(2 m); the ledger has the force's work, and closes to round-off."""
    n, duration = 4, 0.25
    sideways = (0.4, 0.0, 0.0)
    made = rope(
        segments=n,
        shape=Straight(start=(0, 0, 0), direction=(0, 0, -1)),
        submerged_weight=0.05 * G,
        forces=[Force(node=i, force=sideways) for i in (0, n)],
    )
    settings = RunSettings(
        method=method, duration=duration, time_step=1e-4 if method in ("euler", "heun") else "auto"
    )
    free = rw.simulate(scene(made, held=(), run=settings))
    mass = 0.2 * 5.0
    weights = np.array([0.5, 1, 1, 1, 0.5]) / n
    centre = weights @ (free.positions[-1] - free.positions[0])
    fallen = 0.25 * 0.5 * G * duration**2
    first_order = method in ("euler", "semi-implicit-euler", "implicit-euler", "bdf2")
    tolerance = 1e-5 + (2.2 * free.plan.dt / duration if first_order else 0.0)
    pushed = 0.5 * 0.8 / mass * duration**2
    np.testing.assert_allclose(centre, [pushed, 0.0, -fallen], rtol=tolerance, atol=1e-9)
    momentum = [0.8 * duration, 0.0, -0.25 * G * mass * duration]
    np.testing.assert_allclose(free.momentum[-1], momentum, atol=1e-9)
    moved = free.positions[-1] - free.positions[0]
    lift = 0.75 * 0.2 * 5.0 * G
    work = 0.4 * (moved[0, 0] + moved[n, 0]) + lift * (weights @ moved[:, 2])
    assert free.work["applied"][-1] == pytest.approx(work, rel=2.0 * tolerance)
    assert np.abs(free.balance_residual).max() < 1e-11


def test_it_is_in_the_recording_the_table_and_files(tmp_path: Path) -> None:
    made = scene(rope(forces=[Force(node=10, force=(0, 5.0, 0))], submerged_weight=1.0))
    run = rw.run(made.replace(run=RunSettings(duration=0.3)), tmp_path / "run")
    assert run.scene == made.replace(run=RunSettings(duration=0.3))
    # At time zero, too, the anchors carry what balances all forces on their nodes.
    step = run.positions[0, 1] - run.positions[0, 0]
    left = run.reactions[0, 0] + run.tension[0, 0] * step / np.linalg.norm(step)
    np.testing.assert_allclose(left, [0.0, 0.0, 1.0 * 0.5 * 0.25], atol=1e-9)
    assert run.work["applied"][-1] != 0.0
    assert abs(run.energy_error).max() < 0.05 * np.ptp(run.energy["kinetic"])
    sums = run.reactions[-1].sum(axis=0)
    assert sums.shape == (3,)
    check = rw.check(made, measure=False)
    assert check.statics.reactions.sum(axis=0) == pytest.approx([0, -5.0, 5.0], abs=1e-8)
    still = rw.simulate(made.replace(run=RunSettings(start="at-rest", duration=0.2)))
    assert np.abs(still.velocities).max() < 1e-6


def test_modes_are_those_about_the_rest_shape() -> None:
    """A mass on a string of length L pulled by F swings at sqrt(F/(m L)), whatever pulls it."""
    stuff = Springs(spring_constant=1e7, node_mass=0.5, segment_length=2.0)
    pulled = Rope(
        segments=1,
        made_of=stuff,
        forces=[Force(node=1, force=(7.0, 0, 0))],
        shape=Straight(start=(0, 0, 0)),
    )
    found = rw.modes(scene(pulled, held=(0,), gravity=(0, 0, 0)), count=2)
    np.testing.assert_allclose(
        found.frequencies, math.sqrt(7.0 / (0.5 * 2.0)) / (2 * math.pi), rtol=1e-5
    )


def test_hands_come_on_top_and_let_go_again() -> None:
    simulation = rw.Simulation(scene(rope(forces=[Force(node=5, force=(1.0, 0, 0))])))
    simulation.apply_force(5, (0.0, 2.0, 0.0))
    np.testing.assert_array_equal(simulation.arrays.forces.applied[:, 5], [1.0, 2.0, 0.0])
    assert simulation.applied_forces[5].tolist() == [0.0, 2.0, 0.0]
    simulation.applied_forces = np.zeros((21, 3))
    np.testing.assert_array_equal(simulation.arrays.forces.applied[:, 5], [1.0, 0.0, 0.0])


def test_a_cut_keeps_all_forces() -> None:
    flat = Straight(start=(0, 0, 0))
    whole = scene(rope(shape=flat, forces=[Force(node=3, force=(1.0, 0, 0))], submerged_weight=0.4))
    model = build(whole)
    parts = build(cut(whole, model.layout, 10).scene)
    np.testing.assert_allclose(
        parts.state.forces.applied.sum(axis=1), model.state.forces.applied.sum(axis=1), rtol=1e-12
    )


# -- bad input -----------------------------------------------------------------------------------


def test_what_makes_no_sense_is_refused() -> None:
    with pytest.raises(rw.SceneError, match="needs gravity"):
        scene(rope(submerged_weight=1.0), gravity=(0, 0, 0))
    with pytest.raises(rw.SceneError, match=r"force\[0\].node"):
        rope(forces=[Force(node=99, force=(0, 0, 1))])
    with pytest.raises(rw.SceneError, match="rope on a winch"):
        scene(rope(submerged_weight=1.0), winches=[rw.Winch(end="start", speed=0.1)])
    with pytest.raises(rw.SceneError, match="carries it away"):
        rw.equilibrium(
            scene(rope(forces=[Force(node=0, force=(1, 0, 0))]), held=(), gravity=(0, 0, 0))
        )


def test_a_rope_that_is_heavier_in_water_is_warned_of() -> None:
    for weight, said in ((2.5, True), (1.9, False), (-3.0, False)):
        found = rw.check(scene(rope(submerged_weight=weight)), measure=False).warnings
        assert any("more than its 1.962 N/m in air" in text for text in found) is said


def test_a_scene_file_has_them() -> None:
    text = """
[[rope]]
segments = 4
length = 2.0
submerged_weight = -0.5
[rope.made_of]
kind = "material"
EA = 1000.0
mass_per_length = 0.1
[[rope.force]]
node = -1
force = [1.0, 0.0, 0.0]
[[anchor]]
node = 0
"""
    found = loads(text)
    assert found.ropes[0].forces[0].force == (1.0, 0.0, 0.0)
    assert loads(rw.dumps(found)) == found
