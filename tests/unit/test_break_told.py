"""A run that breaks comes back as a broken run, whatever becomes of its explanation."""

from __future__ import annotations

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.analysis.diagnosis import explain
from ropewalk.engine.start import started
from ropewalk.lowering import build
from ropewalk.record.simulate import simulate_in_memory
from ropewalk.scene import Air, Anchor, Rope, RunSettings, Scene, Springs, Straight
from ropewalk.simulation import Simulation
from ropewalk.statics import NoRest, static_shape


def breaking(**run: object) -> Scene:
    """A chain in the wind whose step is too long."""
    rope = Rope(
        segments=20,
        made_of=Springs(
            spring_constant=300.0, node_mass=0.05, spring_friction=0.05, segment_length=1.0
        ),
        shape=Straight(start=(0, 0, 0)),
    )
    return Scene(
        run=RunSettings(
            **({"time_step": 1 / 60, "duration": 4.0, "method": "semi-implicit-euler"} | run)
        ),
        ropes=(rope,),
        anchors=(Anchor(node=0), Anchor(node=-1)),
        air=Air(node_drag=0.01, wind=(2.0, 1.0, 0.0)),
    )


def test_a_scene_without_rest_shape_breaks_as_any_other(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("ropewalk.statics.newton.STEPS", 0)
    with pytest.raises(NoRest):
        static_shape(breaking())
    with pytest.raises(rw.BrokenRun, match="Broke after t") as broken:
        rw.simulate(breaking())
    assert broken.value.result.frames > 1
    assert "zigzag" in broken.value.diagnosis
    assert "could not be told" not in broken.value.diagnosis


def test_an_explanation_that_fails_loses_no_result() -> None:
    def unlucky(simulation: Simulation) -> str:
        simulation.advance_steps(1)
        raise NoRest("no shape of rest was found")

    found = simulate_in_memory(breaking(), explain=unlucky)
    assert found.status == "broke"
    assert found.diagnosis.startswith("Broke after t = ")
    assert "NoRest: no shape of rest was found" in found.diagnosis
    told = simulate_in_memory(breaking(), explain=lambda simulation: str(explain(simulation)))
    np.testing.assert_array_equal(told.positions, found.positions)


def test_a_started_model_starts_the_same_again() -> None:
    """The diagnosis takes a run again from its model: a mode that rings must not ring twice."""
    rope = Rope(
        segments=10,
        length=2.0,
        made_of=rw.Material(EA=1000.0, mass_per_length=0.1),
        shape=Straight(start=(0, 0, 0)),
    )
    ring = {"mode": 1, "speed": 0.5}
    scene = Scene(
        run=RunSettings(start="at-rest", ring=ring, duration=0.1),
        ropes=(rope,),
        anchors=(Anchor(node=0), Anchor(node=-1)),
    )
    once = started(build(scene))
    assert np.abs(once.state.v).max() == pytest.approx(0.5)
    again = Simulation(Simulation(scene).model)
    np.testing.assert_array_equal(again.velocities.T, once.state.v)
