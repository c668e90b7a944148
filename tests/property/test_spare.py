"""A run in the arrays of another one has the bits of a run in arrays of its own."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import HealthCheck, Phase, assume, given, settings

import ropewalk as rw
from ropewalk.engine import spare as spares
from ropewalk.engine.spare import Spare
from ropewalk.lowering import build
from ropewalk.record.simulate import simulate_in_memory
from ropewalk.scene import Scene, SceneError
from ropewalk.statics import NoRest
from strategies import scenes
from sweeps.scenes import swing

MOST_STEPS = 2_000
RELAXED = settings(
    max_examples=15,
    deadline=None,
    suppress_health_check=[HealthCheck.too_slow, HealthCheck.filter_too_much],
    phases=(Phase.explicit, Phase.reuse, Phase.generate),  # shrinking whole runs takes minutes
    derandomize=True,
)


def differences(scene: Scene, other: Scene) -> list[str]:
    """Names of what differs between a run of its own and one in the arrays that another has left."""
    own, spare = simulate_in_memory(scene), Spare()
    simulate_in_memory(other, spare=spare)
    mixed = simulate_in_memory(scene, spare=spare)
    assert mixed.status == own.status
    names = [
        name for name in own.source.names if own.read(name).tobytes() != mixed.read(name).tobytes()
    ]
    assert mixed.frames == own.frames
    return names


@RELAXED
@given(scenes(max_ropes=2, max_segments=5))
def test_what_a_run_leaves_changes_no_bit_of_the_next(scene: Scene) -> None:
    try:
        model = build(scene)
        other = scene.replace(gravity=(1.0, *scene.gravity[1:]))
        assume(model.plan.steps <= MOST_STEPS)
        assert differences(scene, other) == []
    except (SceneError, NoRest):
        return


def test_arrays_of_other_shapes_are_left(monkeypatch: pytest.MonkeyPatch) -> None:
    scene = swing(0.04)
    longer = scene.replace(**{"rope.segments": 6})
    assert differences(scene, longer) == []
    assert differences(scene, scene.replace(**{"rope.length": 2.1})) == []
    monkeypatch.setattr(spares, "assign", lambda *_: None)  # the twin: what was left stays
    assert differences(scene, scene.replace(**{"rope.length": 2.1}))
    assert np.isfinite(rw.simulate(scene).positions).all()
