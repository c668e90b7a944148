"""What a run led to, as a table for people and as JSON for programs."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any

from ropewalk.cli.console import print_json, print_table
from ropewalk.words.prefixes import prefixed

if TYPE_CHECKING:
    from ropewalk.record.result import Result

_PREFIXED = ("N", "N m", "J")
_UNIT = re.compile(r"^(.*) \[(.*)\]$")


def results_rows(table: dict[str, Any]) -> list[tuple[str, str, str]]:
    """Return name, value with unit, and place of the numbers of a result's table."""
    rows = []
    for name, value in table.items():
        if name.endswith(" at") or name == "status" or value != value:  # NaN: there is none
            continue
        found = _UNIT.match(name)
        bare, unit = (found[1], found[2]) if found else (name, "")
        place = str(table.get(f"{bare} at", ""))
        rows.append((bare, _with_unit(value, "" if unit == "1" else unit), place))
    return rows


def print_results(result: Result, title: str = "") -> None:
    """Print a result's numbers on stdout."""
    print_table(("result", "value", "where and when"), results_rows(result.table), title=title)


def print_result_json(result: Result, warnings: tuple[str, ...] = ()) -> None:
    """Print a result as one JSON object on stdout."""
    print_json(
        {
            "name": result.scene.name,
            "folder": str(result.folder),
            "status": result.status,
            "diagnosis": result.diagnosis or None,
            "method": result.plan.method,
            "time_step": result.plan.dt if result.plan.tolerance is None else None,
            "tolerance": result.plan.tolerance,
            "step_counts": result.facts.step_counts or None,
            "why": result.plan.why or None,
            "planned_duration": result.plan.duration,
            "results": {name: value for name, value in result.table.items() if name != "status"},
            "warnings": warnings,
            "events": result.events,
        }
    )


def _with_unit(value: Any, unit: str) -> str:
    """Five figures and the unit; of forces and energies with a prefix: 26.774 kN."""
    if not isinstance(value, float):
        return f"{value} {unit}".rstrip()
    if unit in _PREFIXED:
        return prefixed(value, unit, 5)
    return f"{value:.5g} {unit}".rstrip()
