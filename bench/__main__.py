"""Run all benchmarks, print the table, store it as CSV in `bench/results/`."""

from __future__ import annotations

import argparse
import csv
import datetime
import os
import platform
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

from rich.console import Console
from rich.table import Table

from bench.cases import CASES, segment_step
from bench.row import Row
from ropewalk import __version__

if TYPE_CHECKING:
    from bench.work_precision.measure import Point

WORK_PRECISION = "work_precision"
RESULTS = Path(__file__).parent / "results"


@cache
def processor() -> str:
    """Return the processor's name, its cores, and how busy they are besides."""
    load = f", load {os.getloadavg()[0]:.1f}" if hasattr(os, "getloadavg") else ""
    return f"{processor_name()}, {os.cpu_count()} cores{load}"


def processor_name() -> str:
    """Return the processor's name as the system gives it, nominal clock and all."""
    cpuinfo = Path("/proc/cpuinfo")
    if cpuinfo.exists():
        for line in cpuinfo.read_text().splitlines():
            if line.startswith("model name"):
                return line.split(":", 1)[1].strip()
    return platform.processor() or platform.machine()


def store(rows: list[Row]) -> Path:
    """Write the rows as CSV, among those that were measured the same day; return the file's path."""
    RESULTS.mkdir(exist_ok=True)
    path = RESULTS / f"{datetime.date.today().isoformat()}.csv"
    head = ["case", "value", "unit", "target", "version", "processor"]
    lines: dict[str, list[str]] = {}
    if path.exists():
        with path.open(newline="") as file:
            lines = {line[0]: line for line in list(csv.reader(file))[1:]}
    for row in rows:
        value = f"{row.value:.4g}"
        lines[row.case] = [row.case, value, row.unit, row.target, __version__, processor()]
    with path.open("w", newline="") as file:
        csv.writer(file).writerows([head, *lines.values()])
    return path


def precision(ropes: list[str], say: Callable[[str], None]) -> list[Row]:
    """Measure error against time (minutes), store the points, return the targets."""
    from bench.work_precision.run import work_precision, write_points

    path = RESULTS / f"work-precision-{datetime.date.today().isoformat()}.csv"
    RESULTS.mkdir(exist_ok=True)
    about = {"version": __version__, "processor": processor()}

    def keep(points: list[Point]) -> None:
        write_points(points, path, about)

    rows = work_precision(ropes, keep, segment_step(), say)
    say(f"stored as {path}, figures and tables in docs/images/work-precision")
    return rows


def main() -> None:
    """Measure, print, store."""
    parser = argparse.ArgumentParser(description=__doc__)
    names = [case.__name__ for case in CASES]
    parser.add_argument("case", nargs="*", choices=[[], *names, WORK_PRECISION], default=[])
    parser.add_argument("--rope", action="append", default=[], help=f"only of {WORK_PRECISION}")
    given = parser.parse_args()
    chosen = given.case
    console = Console()
    rows: list[Row] = []
    failed: list[str] = []
    for case in CASES:
        if not chosen or case.__name__ in chosen:
            console.print(f"{case.__name__}: {case.__doc__}", style="dim")
            try:
                rows += case()
            except Exception:  # a case that fails takes none of the others' rows with it
                console.print_exception()
                failed.append(case.__name__)
    if not chosen or WORK_PRECISION in chosen:
        rows += precision(given.rope, lambda text: console.print(text, style="dim"))
    table = Table("case", "value", "unit", "target", title=f"Ropewalk {__version__}, {processor()}")
    table.columns[1].justify = "right"
    for row in rows:
        table.add_row(row.case, f"{row.value:.3g}", row.unit, row.target)
    console.print(table)
    if rows:
        console.print(f"stored as {store(rows)}")
    if failed:
        raise SystemExit(f"failed: {', '.join(failed)}")


if __name__ == "__main__":
    main()
