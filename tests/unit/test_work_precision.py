"""The bench of error against time: its reference, its contestants and what it reads off."""

from __future__ import annotations

import csv
import math
from pathlib import Path

import numpy as np
import pytest
from bench.work_precision.contestants import Entry, Series, _numpy, _ropewalk, _scipy, sparsity
from bench.work_precision.curves import points_of, targets, time_at
from bench.work_precision.equations import LOWER_BAND, UPPER_BAND, equations, rates
from bench.work_precision.figure import draw
from bench.work_precision.measure import Point, measure
from bench.work_precision.reference import reference, solve
from bench.work_precision.run import write_points, write_table
from bench.work_precision.scenes import Case, cases, swinging

from ropewalk import Anchor, Limiter, Rope, Scene, Springs, preset
from ropewalk.lowering import build
from ropewalk.methods.loop import prepare
from ropewalk.scene import Hanging

SPRING, MASS, FRICTION, LENGTH = 40.0, 0.5, 0.3, 1.0  # N/m, kg, N s/m, m
CASES = {case.name: case for case in cases()}


def one_spring(friction: float = FRICTION) -> Scene:
    """One mass on one spring below a fixed point, let go at rest length."""
    springs = Springs(
        spring_constant=SPRING, node_mass=MASS, spring_friction=friction, segment_length=LENGTH
    )
    return Scene(
        ropes=[Rope(segments=1, made_of=springs, shape=Hanging())],
        anchors=[Anchor(node=0)],
        gravity=(0.0, 0.0, -9.81),
    )


def depth(t: float) -> float:
    """Closed form [m]: s (1 - e^(-d t) (cos w t + d/w sin w t)), s = m g / k, d = c / 2m, below LENGTH."""
    s, d = MASS * 9.81 / SPRING, 0.5 * FRICTION / MASS
    w = math.sqrt(SPRING / MASS - d * d)
    return LENGTH + s * (1.0 - math.exp(-d * t) * (math.cos(w * t) + d / w * math.sin(w * t)))


def test_reference_is_the_closed_form() -> None:
    """DOP853 at 1e-11: to 1e-10 m, and its own estimate says so. Twin: a tenth more friction."""
    exact = reference(equations(build(one_spring())), 1.7)
    assert exact.positions[1, 2] == pytest.approx(-depth(1.7), abs=1e-10)
    assert abs(exact.positions[1, 2] + depth(1.7)) < max(exact.error, 1e-12) < 1e-8
    other = solve(equations(build(one_spring(1.1 * FRICTION))), 1.7, 1e-9)
    assert abs(other[1, 2] + depth(1.7)) > 1e-4


@pytest.mark.parametrize("name", CASES)
def test_equations_are_the_packages(name: str) -> None:
    """Accelerations of a shaken state agree to round-off, though both are written apart.

    Twin: without the segments' rest lengths they do not.
    """
    model = build(CASES[name].scene)
    state, system = model.state, model.system
    random = np.random.default_rng(7)
    size = float(state.rest_length.max())
    held = state.inverse_mass == 0.0
    state.x[:, ~held] += random.normal(0.0, 0.3 * size, (3, int((~held).sum())))
    state.v[:, ~held] += random.normal(0.0, 5.0, (3, int((~held).sum())))
    state.v[:, held] = 0.0
    prepare(system, state)
    ours = equations(model)
    y = np.concatenate([state.x.T, state.v.T], axis=1).ravel()
    found = rates(0.0, y, *ours.arguments).reshape(-1, 6)
    scale = float(np.abs(state.acceleration).max())
    np.testing.assert_allclose(found[:, 3:].T, state.acceleration, rtol=0.0, atol=1e-12 * scale)
    np.testing.assert_array_equal(found[:, :3], state.v.T)
    wrong = ours.segments.copy()
    wrong[1] *= 0.99
    other = rates(0.0, y, wrong, *ours.arguments[1:]).reshape(-1, 6)
    assert np.abs(other[:, 3:].T - state.acceleration).max() > 1e-6 * scale


def test_jacobian_has_the_stated_band() -> None:
    """Finite differences of `rates` differ from zero only where `sparsity` and the band say."""
    whip = preset("whip")
    ours = equations(build(whip.replace(ropes=[whip.ropes[0].replace(segments=6)])))
    random = np.random.default_rng(3)
    y = 1.2 * ours.start + random.normal(0.0, 0.02, ours.start.shape)  # taut, and bent
    base = rates(0.0, y, *ours.arguments)
    jacobian = np.zeros((y.size, y.size))
    for i in range(y.size):
        moved = y.copy()
        moved[i] += 1e-6
        jacobian[:, i] = rates(0.0, moved, *ours.arguments) - base
    rows, columns = np.nonzero(jacobian)
    assert columns.size > 100
    allowed = sparsity(7).toarray() != 0.0
    assert allowed[rows, columns].all()
    assert (rows - columns).max() == LOWER_BAND
    assert (columns - rows).max() == UPPER_BAND


@pytest.mark.parametrize("name", ["report", "nehe", "whip"])
def test_numpy_version_is_semi_implicit_euler(name: str) -> None:
    """The same step of the same method in numpy and in the kernels: equal to round-off."""
    case = CASES[name]._replace(duration=0.02)
    step = 0.02 / 1000
    entry = _ropewalk(case, "semi-implicit-euler", step)
    entry.ready()
    numpy_version = _numpy(case, equations(build(case.scene)), step)
    np.testing.assert_allclose(entry.run(), numpy_version.run(), rtol=0.0, atol=1e-9)


def test_scenes_that_are_not_written_down_are_refused() -> None:
    scene = one_spring().replace(limiter=Limiter(min_stretch=0.9, max_stretch=1.1))
    with pytest.raises(ValueError, match="limiters"):
        equations(build(scene))


def tiny() -> Case:
    """Six segments for a tenth of a second."""
    return Case("tiny", "Tiny rope", swinging(segments=6), 0.1)


def small_series(case: Case, model: object, system: object) -> list[Series]:
    """Three methods of Ropewalk and one of scipy, few settings."""
    found = [
        Series("ropewalk", name, tuple(_ropewalk(case, name, 0.1 / n) for n in (400, 800)))
        for name in ("semi-implicit-euler", "verlet", "rk4")
    ]
    entries = tuple(_scipy(case, system, "LSODA", tolerance) for tolerance in (1e-4, 1e-6))
    return [*found, Series("scipy", "LSODA", entries)]


def test_orders_are_seen(tmp_path: Path) -> None:
    """Halving the step divides the error by 2, 4 and 16, and the tables and figures get written."""
    points, exact = measure(tiny(), small_series, share=0.01)
    for name, order in (("semi-implicit-euler", 1), ("verlet", 2), ("rk4", 4)):
        coarse, fine = points_of(points, "tiny", "ropewalk", name)
        assert math.log2(coarse.error / fine.error) == pytest.approx(order, abs=0.15)
        assert 0.0 < coarse.seconds < 1.0
    loose, tight = points_of(points, "tiny", "scipy", "LSODA")
    assert 10.0 * exact.error < tight.error < loose.error < 1e-2
    draw(tiny(), points, tmp_path / "tiny.svg")
    assert (tmp_path / "tiny.svg").read_text().startswith("<?xml")
    write_table(tiny(), points, tmp_path / "tiny.csv")
    write_points(points, tmp_path / "points.csv", {"version": "0"})
    rows = list(csv.DictReader((tmp_path / "points.csv").open()))
    assert len(rows) == len(points) == 8
    assert float(rows[0]["error"]) == pytest.approx(points[0].error, rel=1e-3)


def line(case: str, name: str, factor: float, family: str = "ropewalk") -> list[Point]:
    """A first-order method: error = factor / time."""
    return [Point(case, family, name, 1.0 / t, t, factor / t, 0.0) for t in (0.01, 0.1, 1.0, 10.0)]


def test_time_at_an_error() -> None:
    """On a power law the time between two points is exact; above and below them it is stated."""
    points = line("x", "euler", 1e-4)
    assert time_at(points, 3e-4) == pytest.approx(1e-4 / 3e-4)
    assert time_at(points, 1.0) == 0.01
    assert math.isnan(time_at(points, 1e-9))


def test_targets_are_ratios_of_times() -> None:
    """Ten times faster than the explicit method, and a hundred times than scipy."""
    points = line("dropped-1e5", "sdirk2", 1e-5) + line("dropped-1e5", "verlet", 1e-4)
    points += line("dropped-1e5", "LSODA", 1e-3, "scipy")
    found = {row.case: row.value for row in targets(points, 2.5e-9)}
    assert found["dropped-1e5: sdirk2 / verlet at 1 mm"] == pytest.approx(0.1)
    label = "dropped-1e5: LSODA (scipy's fastest) / sdirk2, our fastest, at 0.1 mm"
    assert found[label] == pytest.approx(100.0)


def test_a_broken_run_is_not_a_point() -> None:
    """A step far beyond the bound breaks: its error is infinite and it is left out of the curves."""

    def broken(case: Case, model: object, system: object) -> list[Series]:
        entries: tuple[Entry, ...] = tuple(_ropewalk(case, "verlet", h) for h in (0.05, 0.1 / 800))
        return [Series("ropewalk", "verlet", entries)]

    points, _ = measure(tiny()._replace(duration=2.0), broken, share=0.01)
    assert math.isinf(points[0].error)
    assert len(points_of(points, "tiny", "ropewalk", "verlet")) == len(points) - 1
