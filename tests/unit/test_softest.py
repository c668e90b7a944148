"""How soft ropes must be for a step: with that the step holds, with little more it does not."""

from __future__ import annotations

import pytest

from ropewalk.analysis.stability import Stability, stability
from ropewalk.live.meter import measure
from ropewalk.lowering import build
from ropewalk.scene import Anchor, Material, Rope, RunSettings, Scene
from ropewalk.words.safe_side import rounded_down


def soft(method: str, dt: float, **more: float | bool) -> Stability:
    """What `check` says of a hanging rope of 50 segments, of a material with more of it, for 10 s."""
    stuff = Material(**({"EA": 1e4, "mass_per_length": 0.1} | more))
    rope = Rope(segments=50, length=5.0, made_of=stuff)
    run = RunSettings(method=method, time_step=dt, duration=10.0)
    model = build(Scene(ropes=rope, anchors=[Anchor(node=0)], run=run))
    found = stability(model)
    assert measure(model)["spring_factor"] == pytest.approx(found.largest_spring_factor, rel=1e-6)
    return found


@pytest.mark.parametrize("dt", [1e-4, 4e-4])
def test_the_softest_of_ropes_that_go_slack_are_what_is_told(dt: float) -> None:
    """The step holds with the EA that is told, and not with 5 % more: slack segments bound it."""
    told = soft("verlet", dt, tension_only=True)
    most = told.largest_axial_stiffness
    assert not told.stable
    assert most is not None
    assert any(f"EA <= {rounded_down(most)} N" == text for text in told.remedies)
    assert soft("verlet", dt, tension_only=True, EA=0.99 * most).stable
    assert not soft("verlet", dt, tension_only=True, EA=1.05 * most).stable


def test_the_softest_of_ropes_that_relax_are_what_is_told() -> None:
    """As a factor of both stiffnesses, EA and relaxing_EA, since EA alone does not make them stable."""
    solid = {"relaxing_EA": 1e4, "relaxation_time": 5e-4}
    told = soft("rk4", 4e-4, **solid)
    factor = told.largest_spring_factor
    assert told.largest_axial_stiffness is None
    assert not any("EA" in text for text in told.remedies)
    for share, holds in ((0.99, True), (1.05, False)):
        found = soft("rk4", 4e-4, relaxation_time=5e-4, EA=1e4 * share * factor,
                     relaxing_EA=1e4 * share * factor)  # fmt: skip
        assert found.stable is holds
    assert told.breaks
    assert told.growth_per_step > 2.0


def test_what_is_beyond_a_bound_that_is_kept_is_not_said_to_grow_by_less_than_nothing() -> None:
    beyond = soft("rk4", 4e-4, EA=6350.0, relaxing_EA=6350.0, relaxation_time=5e-4)
    assert not beyond.stable
    assert beyond.growth_per_step >= 1.0
    assert "x" not in beyond.verdict.split("(")[0].replace("rk4", "")
