"""Ropewalk in cosseratbench: its experiments, scored by its own code."""

from __future__ import annotations

import tomllib
from importlib import import_module
from pathlib import Path

import numpy as np
import pytest
from cosseratbench.metrics import segment_distance
from cosseratbench.registry import load_experiment
from cosseratbench.scenario import neighbour_elements
from cosseratbench.solver import Solver

from ropewalk.adapters.cosserat import RopewalkSolver


def scores(name: str, elements: int | None = None, **values: float) -> dict[str, float]:
    """What an experiment finds at these values."""
    experiment = load_experiment(name)
    scenario = experiment.scenario_for(**values)
    solver = RopewalkSolver()
    count = elements or experiment.n_elements
    trajectory = solver.run(scenario, n_elements=count, n_frames=experiment.n_frames)
    return {key: metric(scenario, trajectory) for key, metric in experiment.metrics.items()}


def test_it_is_found_and_is_a_solver() -> None:
    points = tomllib.loads(Path("pyproject.toml").read_text())["project"]["entry-points"]
    module, _, name = points["cosseratbench.solvers"]["ropewalk"].partition(":")
    assert getattr(import_module(module), name) is RopewalkSolver
    assert isinstance(RopewalkSolver(), Solver)


def test_shapes_at_rest() -> None:
    """Catenary and cantilever; the first reference leaves the bending stiffness out."""
    hung = scores("catenary")
    assert hung["shape_error"] < 1e-3
    assert hung["sag_error"] < 1e-3
    assert hung["settling_residual"] < 1e-6
    assert scores("cantilever")["tip_deflection_error"] < 1e-3


def test_the_period_of_a_swing_has_order_two_in_the_segments() -> None:
    """To what the benchmark's linear reference is worth, 2e-5; no energy is lost."""
    coarse, fine = scores("pendulum", 25), scores("pendulum", 50)
    assert fine["period_error"] < 2e-4
    assert 3.0 < coarse["period_error"] / fine["period_error"] < 5.0
    assert abs(fine["amplitude_change"]) < 1e-4


@pytest.mark.parametrize(("overhang", "slides"), [(0.8, False), (0.95, False), (1.1, True)])
def test_a_rope_holds_on_the_cylinder_below_the_limit_and_slides_above(
    overhang: float, slides: bool
) -> None:
    """The heavy-rope capstan: no creep (MuJoCo, by the benchmark's own adapter, slides off at 0.95)."""
    slide = scores("capstan", overhang=overhang)["slide"]
    assert slide > 0.15 if slides else slide < 1e-4


def test_a_rope_that_crosses_another_lies_where_the_elastica_does() -> None:
    """One contact without friction: shapes and the lift, which tells the force through it.

    What is off are the segments, and how deep contacts are pressed at rest: finer ones err less.
    """
    found, fine = scores("crossing"), scores("crossing", 200)
    assert found["shape_error"] < 8e-4
    assert found["lift_error"] < 2.6e-3
    assert found["settling_residual"] < 1e-9
    assert fine["shape_error"] < 1.2e-4
    assert fine["lift_error"] < 1e-3


def test_a_rope_heaps_up_without_passing_into_itself() -> None:
    """There is no reference: it lies on itself, within its own length, and nothing is deep in anything."""
    experiment = load_experiment("pile")
    scenario = experiment.scenario_for()
    trajectory = RopewalkSolver().run(
        scenario, n_elements=experiment.n_elements, n_frames=experiment.n_frames
    )
    found = {name: metric(scenario, trajectory) for name, metric in experiment.metrics.items()}
    assert found["contacts"] >= 1
    assert 1.0 < found["pile_height"] < 10.0
    assert found["footprint"] < 0.5 * scenario.rods[0].length
    rod, x = scenario.rods[0], trajectory.positions[0]
    assert x[:, :, 2].min() > 0.5 * rod.radius  # over the floor, into which impacts press it
    assert x[-1, :, 2].min() > 0.95 * rod.radius
    apart = neighbour_elements(rod.radius, rod.length / experiment.n_elements)
    first, second = np.triu_indices(experiment.n_elements, k=apart)
    for y in x[::5]:
        gap = segment_distance(y[first], y[first + 1], y[second], y[second + 1])
        assert gap.min() > 0.89 * 2.0 * rod.radius


def test_what_there_is_no_model_of_is_refused() -> None:
    """A scenario that turns an end is; ropes that touch each other are modelled."""
    twist = load_experiment("twist")
    with pytest.raises(NotImplementedError, match="turns"):
        RopewalkSolver().run(twist.scenario, n_elements=20, n_frames=5)
    for name in ("crossing", "pile"):
        assert load_experiment(name).requires <= RopewalkSolver.capabilities


def test_only_scenarios_in_which_ropes_can_touch_pay_for_it() -> None:
    for name, touching in (("catenary", False), ("capstan", False), ("crossing", True)):
        scenario = load_experiment(name).scenario_for()
        made = RopewalkSolver().scene(scenario, 20, 5)
        assert (made.contact is not None) == touching
