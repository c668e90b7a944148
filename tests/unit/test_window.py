"""Windows of a rope that are solved first: the same solution, in fewer Newton steps of the whole."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from ropewalk.core.status import OK
from ropewalk.methods.stage_report import SOLVES, most_dense
from ropewalk.methods.window import LARGE, SMALL, make_windows, solve_stage
from ropewalk.scene import Air, Anchor, Material, Rope, RunSettings, Scene, Straight
from ropewalk.simulation import Simulation

C = 0.3 / 60.0  # [s] c1 and c2 of a stage of `sdirk2` in steps of 1/60 s


def hanging(segments: int, anchors: tuple[int, ...] = (0,), **more: Any) -> Simulation:
    """Return a rope of 0.5 kg/m and EA 1e5 N that has fallen for half a second."""
    material = Material(EA=1e5, mass_per_length=0.5, **more)
    rope = Rope(
        segments=segments, length=10.0, made_of=material, shape=Straight(direction=(1, 0, 0))
    )
    run = RunSettings(duration=1.0, time_step=1.0 / 60.0, method="sdirk2")
    scene = Scene(ropes=rope, anchors=[Anchor(node=node) for node in anchors], run=run)
    simulation = Simulation(scene)
    simulation.advance_frames(30)
    return simulation


def solve(simulation: Simulation, kicked: slice, *, windows: bool) -> tuple[Any, float, float]:
    """Solve a stage in which some nodes are thrown about; return places, and Newton steps: all, windows'."""
    engine = simulation._engine
    state, stage, room = engine.state, engine._scratch.stage, engine._scratch.windows
    kick = np.random.default_rng(7).normal(size=state.x.shape)
    kick[:, : kicked.start], kick[:, kicked.stop :] = 0.0, 0.0
    stage.x_known[...], stage.v_known[...] = state.x, state.v + 20.0 * kick
    stage.v_known[:, state.inverse_mass == 0.0] = 0.0
    stage.v[...] = stage.v_known
    stage.x[...] = stage.x_known + C * stage.v
    stage.tension[...] = state.tension
    insides = [one.stage.report for one in room if one.state is not state]
    before = np.array([stage.report[SOLVES], *(one[SOLVES] for one in insides)])
    status = solve_stage(engine.system, state, stage, room if windows else None, C, C)
    after = np.array([stage.report[SOLVES], *(one[SOLVES] for one in insides)])
    assert status == OK
    whole, *inside = after - before
    return stage.x.copy(), whole, sum(inside)


@pytest.mark.parametrize("more", [{}, {"tension_only": True}], ids=["springs", "slack"])
@pytest.mark.parametrize(
    ("segments", "kicked"), [(300, slice(284, 301)), (300, slice(0, 12)), (1100, slice(500, 640))]
)
def test_windows_find_the_same_solution(segments: int, kicked: slice, more: dict[str, Any]) -> None:
    simulation = hanging(segments, **more)
    places, aided, inside = solve(simulation, kicked, windows=True)
    assert inside > 0.0
    alone, whole, none = solve(simulation, kicked, windows=False)
    assert none == 0.0
    assert aided < whole
    assert np.abs(places - alone).max() < 1e-8


def test_windows_with_axial_friction_find_the_same_solution() -> None:
    simulation = hanging(300, axial_damping=1.0)
    places, _, inside = solve(simulation, slice(284, 301), windows=True)
    alone, _, _ = solve(simulation, slice(284, 301), windows=False)
    assert inside > 0.0
    assert np.abs(places - alone).max() < 1e-8


def test_a_window_between_anchors() -> None:
    simulation = hanging(300, (0, 150, 300))
    places, _, inside = solve(simulation, slice(140, 160), windows=True)
    alone, _, _ = solve(simulation, slice(140, 160), windows=False)
    assert inside > 0.0
    assert np.abs(places - alone).max() < 1e-8
    assert (
        np.abs(places[:, [0, 150, 300]] - simulation._engine.state.x[:, [0, 150, 300]]).max() == 0.0
    )


def test_where_the_merit_is() -> None:
    force, misfit = np.zeros((3, 10)), np.zeros(9)
    force[1, 4], force[2, 7], force[0, 9] = 1.0, 0.1, 0.001
    mass, weight = np.ones(10), np.ones(9)
    assert most_dense(force, misfit, mass, weight, 1.0) == (4, 7)
    misfit[0] = 0.5
    assert most_dense(force, misfit, mass, weight, 1.0) == (0, 7)
    assert most_dense(0.0 * force, 0.0 * misfit, mass, weight, 1.0) == (0, -1)


def test_short_ropes_and_other_laws_have_none() -> None:
    slack = hanging(4 * SMALL, tension_only=True, axial_damping=1.0)
    assert slack._engine._scratch.windows.small.state is slack._engine.state
    short = hanging(4 * SMALL - 2)
    room = short._engine._scratch.windows
    assert room.small.state is short._engine.state
    long = hanging(4 * SMALL - 1)
    room = long._engine._scratch.windows
    assert room.small.state.x.shape == (3, SMALL)
    assert room.large.state is long._engine.state
    assert hanging(4 * LARGE - 1)._engine._scratch.windows.large.state.x.shape == (3, LARGE)
    scene = short.scene.model_copy(update={"air": Air()})
    engine = Simulation(scene)._engine
    assert make_windows(engine.system, engine.state, engine._scratch.stage) is None
