"""Run all benchmarks, print the table, store it as CSV in `bench/results/`."""

from __future__ import annotations

import argparse
import csv
import datetime
import platform
from pathlib import Path

from rich.console import Console
from rich.table import Table

from bench.cases import CASES, Row
from ropewalk import __version__

RESULTS = Path(__file__).parent / "results"


def processor() -> str:
    """Return the processor's name as the system gives it."""
    cpuinfo = Path("/proc/cpuinfo")
    if cpuinfo.exists():
        for line in cpuinfo.read_text().splitlines():
            if line.startswith("model name"):
                return line.split(":", 1)[1].strip()
    return platform.processor() or platform.machine()


def store(rows: list[Row]) -> Path:
    """Write the rows as CSV and return the file's path."""
    RESULTS.mkdir(exist_ok=True)
    today = datetime.date.today().isoformat()
    path = RESULTS / f"{today}.csv"
    with path.open("w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(["case", "value", "unit", "target", "version", "processor"])
        for row in rows:
            value = f"{row.value:.4g}"
            writer.writerow([row.case, value, row.unit, row.target, __version__, processor()])
    return path


def main() -> None:
    """Measure, print, store."""
    parser = argparse.ArgumentParser(description=__doc__)
    names = [case.__name__ for case in CASES]
    parser.add_argument("case", nargs="*", choices=[[], *names], default=[])
    chosen = parser.parse_args().case
    console = Console()
    rows: list[Row] = []
    for case in CASES:
        if not chosen or case.__name__ in chosen:
            console.print(f"{case.__name__}: {case.__doc__}", style="dim")
            rows += case()
    table = Table("case", "value", "unit", "target", title=f"Ropewalk {__version__}, {processor()}")
    table.columns[1].justify = "right"
    for row in rows:
        table.add_row(row.case, f"{row.value:.3g}", row.unit, row.target)
    console.print(table)
    if not chosen:
        console.print(f"stored as {store(rows)}")


if __name__ == "__main__":
    main()
