"""Measure all cases; write the numbers, the tables and the figures; return the targets."""

from __future__ import annotations

import csv
import math
from collections.abc import Callable
from pathlib import Path

from bench.row import Row
from bench.work_precision.curves import contestants, points_of, targets, time_at
from bench.work_precision.figure import draw
from bench.work_precision.measure import Point, measure
from bench.work_precision.scenes import Case, cases

ROOT = Path(__file__).resolve().parents[2]
PAGES = ROOT / "docs" / "images" / "work-precision"
ERRORS = {"1 cm": 1e-2, "1 mm": 1e-3, "0.1 mm": 1e-4}  # [m]


def work_precision(
    names: list[str],
    store: Callable[[list[Point]], None],
    cost: float,
    say: Callable[[str], None] = print,
) -> list[Row]:
    """Measure the named cases (none: all) and return the rows of the targets.

    `store` keeps the points; `cost` is an explicit step's per segment [s]. Figures and tables go to
    the documentation.
    """
    points: list[Point] = []
    PAGES.mkdir(parents=True, exist_ok=True)
    for case in cases():
        if names and case.name not in names:
            continue
        found, exact = measure(case)
        say(f"{case.title}: {len(found)} points; the reference is off by {exact.error:.1g} m")
        points += found
        draw(case, found, PAGES / f"{case.name}.svg")
        write_table(case, found, PAGES / f"{case.name}.csv")
        store(points)
    return targets(points, cost)


def write_points(points: list[Point], path: Path, about: dict[str, str]) -> None:
    """Write all points as CSV, with the same facts `about` the run in every row."""
    with path.open("w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow([*Point._fields, *about])
        for point in points:
            numbers = [f"{value:.4g}" for value in point[3:]]
            writer.writerow([*point[:3], *numbers, *about.values()])


def write_table(case: Case, points: list[Point], path: Path) -> None:
    """Write the times [ms] to some errors as CSV, for the documentation, where a hyphen would be a list."""
    with path.open("w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(["method", *(f"{error} [ms]" for error in ERRORS)])
        for family, name in contestants(points, case.name):
            own = points_of(points, case.name, family, name)
            times = [time_at(own, error) for error in ERRORS.values()]
            label = f"`{name}`" if family == "ropewalk" else f"{family}: {name}"
            shown = [f"{1e3 * t:.3g}" if math.isfinite(t) else "–" for t in times]
            writer.writerow([label, *shown])
