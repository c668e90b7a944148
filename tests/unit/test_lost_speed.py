"""Steps that lose what would have moved: of a taut rope that is let go the largest speed was its drift."""

from __future__ import annotations

import pytest

import ropewalk as rw
from ropewalk.record.note_kinds import kinds
from ropewalk.scene import Anchor, Material, Rope, RunSettings, Scene, Straight

SPEED = "largest speed [m/s]"
NOTE = "about the largest speed"


def let_go(method: str, time_step: float, friction: float = 100.0) -> Scene:
    """Two metres under 500 N that drift at 20 mm/s; one end is let go. T / sqrt(EA mu) is 5 m/s."""
    made_of = Material(EA=1e5, mass_per_length=0.1, tension_only=False, axial_damping=friction)
    shape = Straight(end=(2.01, 0, 0), velocity=(0, 0.02, 0))
    rope = Rope(segments=20, length=2.0, made_of=made_of, shape=shape)
    anchors = (Anchor(node=0), Anchor(node=-1, release_time=0.1))
    run = RunSettings(duration=0.3, method=method, time_step=time_step)
    return Scene(ropes=rope, anchors=anchors, gravity=(0, 0, 0), run=run)


def test_what_implicit_euler_brought_to_rest_within_a_step_is_told() -> None:
    coarse, fine = (
        rw.simulate(let_go("implicit-euler", 1 / 60)),
        rw.simulate(let_go("esdirk3", 5e-5)),
    )
    assert coarse.table[SPEED] < 0.021 < 4.0 < fine.table[SPEED]
    assert "lost 1.02 J, beside at most" in coarse.table[NOTE]
    assert "speed may be too low" in kinds(coarse)
    assert NOTE not in fine.table


@pytest.mark.parametrize("friction", [1e3, 1e4])
def test_of_what_friction_brings_to_rest_nothing_is_told(friction: float) -> None:
    """It creeps at a tenth of that, and moves by less in frames than rounding of steps takes."""
    assert NOTE not in rw.simulate(let_go("esdirk3", 5e-5, friction)).table
