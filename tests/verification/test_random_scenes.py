"""Below the automatic step nothing breaks: random scenes of everything there is.

`ROPEWALK_RANDOM_SCENES=1000` runs all of them; by default every seventh, which takes a minute or two.
"""

from __future__ import annotations

import os

import pytest

from ropewalk.analysis.apart import jerks, torn_apart
from ropewalk.analysis.stability import stability
from ropewalk.core.status import OK
from ropewalk.lowering import build
from ropewalk.lowering.steps import uncovered
from ropewalk.scene import SceneError
from ropewalk.simulation import Simulation
from verification.random_scenes import random_scene

SCENES = int(os.environ.get("ROPEWALK_RANDOM_SCENES", "143"))
ALL = 1000


def end_of(simulation: Simulation) -> bool:
    """Run a simulation to its end; tell whether it broke."""
    status = OK
    for block in simulation.frames():
        status = block.status
    return status != OK


def breaks_by_itself(simulation: Simulation, seed: int) -> bool:
    """Tell whether it breaks in an eighth of the step, too, at the same frame, all energy accounted for."""
    fine = Simulation(random_scene(seed, time_step=simulation.plan.dt / 8.0))
    frame = 1.01 * simulation.plan.frame_interval
    same = end_of(fine) and abs(fine.time - simulation.time) < frame
    return same and simulation.reason.endswith("accounted for")


@pytest.mark.slow
def test_nothing_breaks_below_the_automatic_step() -> None:
    """Where one does, `check` has said so: that no bound holds there, and `auto` takes another method, or
    that the scene's own anchors tear the rope, whatever the step.

    At least half of the scenes must be under a bound, and some of them not, so that both are seen.
    """
    covered = beyond = refused = 0
    broke: dict[int, str] = {}
    for seed in range(0, ALL, max(1, ALL // SCENES)):
        scene = random_scene(seed)
        try:
            simulation = Simulation(scene)
        except SceneError:  # no step of euler or heun is stable
            assert scene.run.method in ("euler", "heun")
            refused += 1
            continue
        model, method = simulation.model, simulation.plan.method
        bare, torn = (
            uncovered(model.system, model.state, method, model.plan.duration),
            torn_apart(model) or jerks(model),
        )
        covered += not bare
        beyond += bool(bare)
        if bare:
            assert "no bound holds" in stability(model).verdict
            assert build(scene.replace(run=scene.run.replace(method="auto"))).plan.method != method
        if end_of(simulation) and not bare and not (torn and breaks_by_itself(simulation, seed)):
            broke[seed] = f"{method} after {simulation.time:g} s: {simulation.reason}"
    assert broke == {}
    assert covered > 0.5 * SCENES
    assert beyond > 0.1 * SCENES
    assert refused < 0.3 * SCENES


@pytest.mark.slow
@pytest.mark.parametrize("seed", [256, 289, 703, 734])
def test_what_its_anchors_tear_breaks_with_any_step(seed: int) -> None:
    """Anchors that circle beside others: these broke before `check` knew it."""
    simulation = Simulation(random_scene(seed))
    assert torn_apart(simulation.model) or jerks(simulation.model)
    assert end_of(simulation)
    assert breaks_by_itself(simulation, seed)
