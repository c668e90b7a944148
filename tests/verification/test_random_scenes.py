"""Below the automatic step nothing breaks: random scenes of everything there is.

`ROPEWALK_RANDOM_SCENES=1000` runs more of them; by default there are so many that it takes some minutes.
"""

from __future__ import annotations

import os

import pytest

from ropewalk.analysis.stability import stability
from ropewalk.build import build
from ropewalk.build.steps import uncovered
from ropewalk.core.status import OK
from ropewalk.scene import SceneError
from ropewalk.simulation import Simulation
from verification.random_scenes import random_scene

SCENES = int(os.environ.get("ROPEWALK_RANDOM_SCENES", "150"))
FIRST = int(os.environ.get("ROPEWALK_FIRST_SCENE", "0"))


@pytest.mark.slow
def test_nothing_breaks_below_the_automatic_step() -> None:
    """Where one does, `check` has said that no bound holds there, and `auto` takes another method.

    At least half of the scenes must be under a bound, and some of them not, so that both are seen.
    """
    covered = refused = 0
    broke: dict[int, str] = {}
    for seed in range(FIRST, FIRST + SCENES):
        scene = random_scene(seed)
        try:
            simulation = Simulation(scene)
        except SceneError:  # no step of euler or heun is stable
            assert scene.run.method in ("euler", "heun")
            refused += 1
            continue
        model, method = simulation.model, simulation.plan.method
        bare = uncovered(model.system, model.state, method)
        covered += not bare
        status = OK
        for block in simulation.frames():
            status = block.status
        if status == OK:
            continue
        if not bare:
            broke[seed] = f"{method} after {simulation.time:g} s: {simulation.reason}"
            continue
        assert "no bound holds" in stability(model).verdict
        auto = build(scene.replace(run=scene.run.replace(method="auto")))
        assert auto.plan.method != method
    assert broke == {}
    assert covered > 0.5 * SCENES
    assert refused < 0.3 * SCENES
