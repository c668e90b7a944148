"""Diagnoses of runs that really break, and of histories made by hand."""

from __future__ import annotations

import json
import math
import re

import numpy as np
import pytest

import ropewalk as rw
import runs
from ropewalk.analysis.diagnosis import Diagnosis, diagnose, explain, retrace
from ropewalk.analysis.stability import stability
from ropewalk.core.status import OK
from ropewalk.engine.broken import ACCOUNTED
from ropewalk.lowering import build
from ropewalk.scene import (
    Anchor,
    Kick,
    Material,
    Rope,
    RunSettings,
    Scene,
    Slack,
    Springs,
    Straight,
    Velocity,
)
from ropewalk.simulation import Simulation


def scene(k: float = 200.0, dt: float = 1 / 60, **run: object) -> Scene:
    rope = Rope(
        segments=20,
        made_of=Springs(
            spring_constant=k, node_mass=0.05, spring_friction=0.05, segment_length=1.0
        ),
        shape=Straight(start=(0, 0, 0)),
    )
    settings = RunSettings(time_step=dt, steps="exact", **run)
    held = (Anchor(node=0), Anchor(node=-1))
    return Scene(gravity=(0, -9.81, 0), run=settings, ropes=(rope,), anchors=held)


def broken(made: Scene) -> Diagnosis:
    model = build(made)
    positions = retrace(Simulation(model), 5000)
    steps = len(positions) - 2
    return diagnose(stability(model), model.layout, positions, steps * model.plan.dt, steps)


def test_the_report_at_60_hz() -> None:
    found = broken(scene(duration=30.0))
    assert found.predicted
    assert found.zigzag < -0.9
    assert found.flip < -0.95
    # Theory: growth 2.02 per step, its square in energy.
    expected = stability(scene(duration=30.0)).growth_per_step ** 2
    assert found.energy_growth == pytest.approx(expected, rel=0.25)
    assert found.rope == "rope"
    assert 0 < found.node < 20
    text = str(found)
    for words in ("Broke after t =", "zigzag", "spring_constant <= 175 N/m", "15.6"):
        assert words in text
    assert text.count(". ") <= 2
    assert json.loads(json.dumps(found.as_dict(), allow_nan=False))["predicted"] is True


def test_euler_is_told_to_change_the_method() -> None:
    found = broken(scene(10000.0, 0.001, method="euler"))
    assert "method = semi-implicit-euler" in str(found)
    assert found.energy_growth > 1.0


def test_what_a_winch_has_paid_out_is_looked_at() -> None:
    """A zigzag of segments that were on the drum at the start was no sign."""
    model = build(runs.winched(speed=1.0))
    (span, _), x = model.layout.ropes, model.state.x.T.copy()
    paid = 6  # nodes that have come off the drum, all below it
    x[span.first : span.last + 1, 2] = -0.5 * np.maximum(
        np.arange(span.nodes) - (span.spare_start - paid), 0
    )
    steps = np.repeat(x[None], 12, axis=0)
    shaken = slice(span.start - paid + 1, span.start)
    pattern = (-1.0) ** np.arange(paid - 1)
    for i in range(12):
        steps[i, shaken, 2] += 1e-9 * (-2.0) ** i * pattern
    found = diagnose(stability(model), model.layout, steps, 0.1, 6)
    assert found.zigzag < -0.5
    assert found.rope == "line"
    assert -paid < found.node < 0


def history(pattern: np.ndarray, growth: float, steps: int = 12) -> np.ndarray:
    """Positions of a straight chain along x whose nodes move by `pattern`, growing per step."""
    x = np.zeros((steps, 21, 3))
    for i in range(steps):
        x[i, :, 0] = np.arange(21) + 1e-9 * growth**i * pattern
    return x


def test_measures_on_patterns_made_by_hand() -> None:
    model = build(scene())
    found = stability(model)
    nodes = np.arange(21.0)
    bump = np.exp(-((nodes - 7) ** 2) / 8.0)
    zigzag = diagnose(found, model.layout, history((-1.0) ** nodes * bump, -2.0), 0.1, 6)
    assert zigzag.zigzag < -0.9
    assert zigzag.flip < -0.99
    assert zigzag.energy_growth == pytest.approx(4.0, rel=1e-6)
    assert zigzag.node == 7
    smooth = diagnose(found, model.layout, history(bump, 1.3), 0.1, 6)
    assert smooth.zigzag > 0.3
    assert smooth.flip > 0.9
    assert "zigzag" not in smooth.sign
    assert smooth.energy_growth == pytest.approx(1.69, rel=1e-6)


def test_a_zigzag_is_seen_when_springs_have_turned_over() -> None:
    model = build(scene())
    pattern = (-1.0) ** np.arange(21)
    pattern[[0, -1]] = 0.0
    x = np.zeros((4, 21, 3))
    x[:, :, 0] = np.arange(21)
    x[2, :, 0] += 2.0 * pattern  # at once, and further than a segment is long
    x[3, :, 0] -= 40.0 * pattern
    found = diagnose(stability(model), model.layout, x, 0.1, 6)
    assert found.zigzag < -0.9
    assert found.flip < -0.9
    assert (found.time, found.step) == (0.1, 6)  # of the run; the zigzag is in step 1 of these
    # The twin, lengths alone: all of them grow.
    lengths = np.diff(np.linalg.norm(np.diff(x, axis=1), axis=2), axis=0)[1]
    assert (lengths >= 0.0).all()


def test_rounding_is_no_zigzag() -> None:
    model = build(scene(100.0))
    noise = np.random.default_rng(1).normal(size=(50, 21, 3))
    x = np.zeros((50, 21, 3))
    x[:, :, 0] = np.arange(21)
    quiet = diagnose(stability(model), model.layout, x + 1e-15 * noise, 0.1, 6)
    assert math.isnan(quiet.zigzag)
    assert "zigzag (" not in quiet.sign


def test_infinite_and_missing_history_is_borne() -> None:
    model = build(scene())
    found = stability(model)
    x = history((-1.0) ** np.arange(21), -2.0)
    x[9:] = np.nan
    x[8] = 1e300
    same = diagnose(found, model.layout, x, 0.1, 6)
    assert same.zigzag < -0.9
    assert same.energy_growth == pytest.approx(4.0, rel=1e-6)
    for length in (0, 1, 2):
        short = diagnose(found, model.layout, x[:length], 0.1, 6)
        assert math.isnan(short.flip)
        assert "time_step <=" in str(short)
    nothing = diagnose(found, model.layout, np.full((3, 21, 3), np.inf), 0.1, 6)
    assert "too fast to show how" in str(nothing)
    assert "zigzag" not in str(nothing)


def test_a_stable_step_is_not_blamed() -> None:
    model = build(scene(100.0))
    found = stability(model)
    assert found.stable
    x = history(np.linspace(0, 1, 21) * 1e9, 1.2)
    why = f"segment 3 of rope 'rope' is 12 times its rest length; {ACCOUNTED}"
    text = str(diagnose(found, model.layout, x, 0.1, 6, why))
    assert "not the method" in text
    assert why in text
    made_up = str(diagnose(found, model.layout, x, 0.1, 6, "the ropes have 7 J more than"))
    assert "not the method" not in made_up  # the twin: energy that nothing gave is the method's
    assert "no zigzag" in text or "energy grows" in text
    assert "time_step <=" not in text


def test_what_is_known_is_told_in_place_of_a_sign_that_is_missing() -> None:
    """It read "no zigzag", though the ropes had 7.7 MJ that nothing had given them."""
    stuff = Material(EA=1e7, mass_per_length=0.2, axial_damping=0.5)
    kick = Kick(node=3, velocity=(-10.0, 10.0, 5.0))
    rope = Rope(
        segments=4,
        length=1.0,
        diameter=0.01,
        made_of=stuff,
        shape=Slack(start=(0, 0, 0), end=(0.9, 0, 0)),
        kicks=[kick],
    )
    run = {"method": "implicit-midpoint", "duration": 0.06, "frame_rate": 50, "time_step": 5e-3}
    with pytest.raises(rw.BrokenRun) as caught:
        rw.simulate(Scene(ropes=[rope], anchors=[Anchor(node=0)], run=run))
    text = str(caught.value)
    assert re.search(r"of rope 'rope': the ropes have \S+ J more than at the start", text)
    assert "no zigzag" not in text
    assert text.count("J more than") == 1


@pytest.mark.parametrize("method", ["semi-implicit-euler", "bdf2"])
def test_a_rope_that_its_anchors_tear_is_not_blamed_on_the_method(method: str) -> None:
    """Soft, heavy and pulled apart at 4 m/s, segments beside the anchors go first: a zigzag that no step
    helps. It was "inf % below the bound", or no bound held and another method was to help.
    """
    soft = Material(EA=40.0, mass_per_length=2.0, axial_damping=0.01)
    rope = Rope(segments=5, length=0.13, made_of=soft, shape=Straight(end=(0.12, 0.0, 0.0)))
    away = Anchor(node=-1, motion=Velocity(velocity=(1.2, 4.0, 0.0)))
    run = RunSettings(method=method, duration=1.0, frame_rate=100.0)
    torn = Scene(ropes=[rope], anchors=[Anchor(node=0), away], run=run)
    text = rw.simulate(torn, on_failure="return").diagnosis
    assert "so this is not the method; look for anchors that move apart" in text
    assert "inf" not in text
    assert "time_step" not in text


def test_retrace_keeps_the_last_steps_and_stops_at_the_break() -> None:
    model = build(scene(duration=30.0))
    whole = retrace(Simulation(model), 5000, keep=5000)
    few = retrace(Simulation(model), 5000, keep=10)
    assert len(few) == 10
    np.testing.assert_array_equal(few, whole[-10:])
    assert len(retrace(Simulation(model), 3)) == 4


@pytest.mark.parametrize(
    "made",
    [scene(duration=30.0), scene(10000.0, 0.00235, duration=5.0)],
    ids=["60 Hz", "many steps"],
)
def test_explain_from_the_last_good_frame(made: Scene) -> None:
    simulation = Simulation(made)
    good = 0
    for block in simulation.frames():
        good += block.frames
        status = block.status
    assert status != OK
    before = simulation.positions.copy(), simulation.time
    found = explain(simulation)
    np.testing.assert_array_equal(simulation.positions, before[0])
    assert simulation.time == before[1]
    assert found.time == pytest.approx(good * simulation.plan.frame_interval)
    assert found.step == good * simulation.plan.steps_per_frame
    assert found.zigzag < -0.9
    expected = stability(made).growth_per_step ** 2
    assert found.energy_growth == pytest.approx(expected, rel=0.3)


def test_explain_a_run_that_was_moved_by_hand() -> None:
    made = scene(10000.0, 0.001, duration=20.0)
    simulation = Simulation(made)
    simulation.advance_frames(5)
    simulation.anchors["anchor1"].velocity = (20000.0, 0.0, 0.0)
    for block in simulation.frames(50):
        status = block.status
    assert status != OK
    found = explain(simulation)
    assert not found.predicted
    assert "not the method" in str(found)
    assert found.node in (19, 20)
