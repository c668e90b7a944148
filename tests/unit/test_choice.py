"""`method = "auto"`: what is chosen, and the sentence that says why."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.lowering import build
from ropewalk.lowering.choice import AIM, ERROR, candidates
from ropewalk.lowering.plan import Plan
from ropewalk.lowering.steps import predicted_step
from ropewalk.methods.registry import METHODS
from ropewalk.record.facts import provenance
from ropewalk.scene import Anchor, Limiter, Material, Rope, RunSettings, Scene, Winch
from ropewalk.simulation import Simulation


def rope(EA: float, segments: int = 20, **more: object) -> Scene:
    line = Rope(segments=segments, length=10.0, made_of=Material(EA=EA, mass_per_length=0.5))
    run = RunSettings(**({"method": "auto", "duration": 1.0} | more))
    return Scene(ropes=[line], anchors=[Anchor(node=0)], run=run)


def plan(scene: Scene) -> Plan:
    return build(scene).plan


def test_a_soft_rope_is_explicit_and_a_stiff_one_implicit() -> None:
    soft, stiff = plan(rope(20.0)), plan(rope(1e9))
    assert not METHODS[soft.method].implicit
    assert stiff.method == "esdirk3"
    assert "(explicit)" in soft.why
    assert "stability allows" in soft.why
    assert "(implicit)" in stiff.why
    assert "times as much" in stiff.why
    assert soft.why.startswith(f"auto chose {soft.method}")
    # stability: an explicit step is within the scene's share of the bound
    model = build(rope(20.0))
    bound = predicted_step(model.system, model.state, soft.method)
    assert soft.dt <= 0.8 * bound * (1.0 + 1e-12)


def test_it_is_the_cheapest() -> None:
    """Twin: any other candidate costs more."""
    for EA in (20.0, 1e3, 1e5, 1e7):
        model = build(rope(EA))
        found = candidates(model.scene, model.system, model.state, math.inf)
        # so soft a rope may be pressed together by its own fall, which symplectic methods do not stand
        assert {one.method for one in found} == ({"rk4", "esdirk3"} if EA == 20.0 else set(ERROR))
        cost = {one.method: one.cost for one in found}
        assert min(cost, key=lambda name: cost[name]) == model.plan.method
        for one in found:
            assert one.cost == pytest.approx(METHODS[one.method].cost / one.step)


def test_accuracy_shortens_the_step() -> None:
    loose, tight = plan(rope(1e7, tolerance=1e-4)), plan(rope(1e7, tolerance=1e-8))
    assert tight.dt < 0.2 * loose.dt
    assert "10 mm" in loose.why


def test_what_a_scene_limits() -> None:
    """A limiter goes with methods that solve for it; a winch winds little in a step; a given step is the
    longest.
    """
    for EA in (1e3, 1e7):
        limited = METHODS[plan(rope(EA).replace(limiter=Limiter(max_stretch=1.1))).method]
        assert limited.implicit
        assert limited.holds_links
    bounded = plan(rope(1e3).replace(limiter=Limiter(max_stretch=1.1))).why
    assert bounded.endswith("no bound holds for explicit methods beside a stretch limiter")
    assert not METHODS[plan(rope(1e3)).method].implicit  # the twin
    winch = Winch(end="start", speed=10.0)
    wound = plan(rope(1e7).replace(winches=[winch]))
    assert wound.dt <= 0.2 * 0.5 / 10.0
    capped = plan(rope(1e7, time_step=1e-3))
    assert capped.dt <= 1e-3
    assert "at the scene's time_step of 1 ms" in capped.why
    assert "the scene's time_step being 1 ms: " in plan(rope(1e3, time_step=1e-3)).why
    assert "the scene's time_step" not in plan(rope(1e7, time_step=1.0)).why  # the twin
    assert "ms (0.8 of the bound)" in capped.why


def test_it_is_resolved_for_the_record(tmp_path: Path) -> None:
    """Provenance has the method by name and the sentence; `check` says it; the scene keeps "auto"."""
    scene = rope(20.0, segments=4, duration=0.1)
    model = build(scene)
    about = provenance(model.plan, ledger=True, keep_going=False)["plan"]
    assert about["method"] in METHODS
    assert about["why"] == model.plan.why
    found = rw.check(scene, measure=False)
    assert found.why in found.lines()
    assert found.stability.method == model.plan.method
    assert scene.run.method == "auto"
    result = rw.simulate(scene).save(tmp_path / "run")
    assert result.plan == model.plan
    assert result.scene.run.method == "auto"


@pytest.mark.slow
@pytest.mark.parametrize("method", list(ERROR))
def test_the_error_is_about_what_is_said(method: str) -> None:
    """The dropped rope of 100 segments: between a thirtieth and thrice the aim, at the step for it."""
    scene = rope(1e3, segments=100, frame_rate=1.0, time_step="auto")
    fine = scene.run.replace(method="esdirk3", time_step=1.0 / 4000.0)
    exact = Simulation(scene.replace(run=fine))
    exact.advance_frames(1)
    model = build(scene)
    found = candidates(model.scene, model.system, model.state, math.inf)
    step = next(one.step for one in found if one.method == method)
    own = Simulation(scene.replace(run=fine.replace(method=method, time_step=step)))
    own.advance_frames(1)
    apart = np.linalg.norm(own.positions - exact.positions, axis=1)
    error = float(np.sqrt((apart**2).mean()))
    aim = AIM * scene.run.tolerance
    assert error < 3.0 * aim
    if step < 0.5 * next(one.bound for one in found if one.method == method):
        assert error > aim / 30.0
