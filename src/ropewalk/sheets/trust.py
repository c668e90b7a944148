"""How far a sheet's numbers can be trusted: method, energy, and the same scene cut and stepped otherwise."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np

from ropewalk.api import equilibrium, simulate
from ropewalk.lowering import build
from ropewalk.record.extremes import extremes
from ropewalk.scene import Scene, SceneError
from ropewalk.scene.recut import recut
from ropewalk.sheets.content import Item, Section, Table, Text
from ropewalk.statics import NoRest, rest_spans
from ropewalk.words.counts import counted
from ropewalk.words.percents import percent
from ropewalk.words.prefixes import prefixed
from ropewalk.words.safe_side import percent_up

if TYPE_CHECKING:
    from ropewalk.record.result import Result

PARTED = "places where ropes parted"
LARGE = 5.0  # [%] a change of a force from which the sheet warns
_RUN = {
    "largest tension": ("greatest tension", "N"),
    "largest force on an anchor": ("greatest anchor force", "N"),
    "largest speed": ("greatest speed", "m/s"),
    "lowest point": ("lowest point", "m"),
}


@dataclass(frozen=True)
class Variant:
    """The scene once more, otherwise cut or stepped: its numbers, or why there are none."""

    title: str
    numbers: dict[str, float] = field(default_factory=dict)
    why_not: str = ""
    failed: bool = False


def method_section(result: Result) -> Section:
    """Return method, step and what the books of energy leave."""
    plan = result.plan
    rows = [("method", plan.method)]
    if plan.tolerance is None:
        rows.append(("time step", f"{1e3 * plan.dt:.5g} ms, {plan.steps_per_frame} a frame"))
    else:
        rows.append(("tolerance of a step", f"{1e3 * plan.tolerance:.4g} mm"))
    if plan.why:
        rows.append(("chosen", plan.why))
    table = result.table
    largest = table.get("largest energy error [J]", math.nan)
    if not math.isnan(largest):
        share = table["largest energy error, share of the energy turned over [%]"]
        told = "" if math.isnan(share) else f" ({percent(share)} of the energy turned over)"
        rows.append(("largest energy error", f"{prefixed(largest, 'J', 3)}{told}"))
    items: list[Item] = [Table(("", ""), rows, numbers=False)]
    if note := table.get("about the energy"):
        items.append(Text(f"The energy: {note}.", warning=True))
    if note := table.get("about the stretch limiter"):
        items.append(Text(f"The stretch limiter: {note}.", warning=True))
    if note := table.get("about the obstacles"):
        items.append(Text(f"The obstacles: {note}.", warning=True))
    if note := table.get("about the contacts"):
        items.append(Text(f"The contacts: {note}.", warning=True))
    if note := table.get("about the wraps"):
        items.append(Text(f"The wraps: {note}.", warning=True))
    return Section("Method", tuple(items))


def run_numbers(result: Result) -> dict[str, float]:
    """Return what variants of a run are compared by, in SI units."""
    found = extremes(result)
    return {title: found[name].value for title, (name, _) in _RUN.items()}


def _ran(scene: Scene) -> dict[str, float]:
    result = simulate(scene)
    return run_numbers(result) | {PARTED: float(len(result.partings))}


def rest_numbers(scene: Scene) -> dict[str, float]:
    """Return the same of an equilibrium. Raises SceneError and NoRest as `equilibrium` does."""
    result, model = equilibrium(scene), build(scene, stepped=False)
    spans = rest_spans(model, result.positions[0], result.tension[0])
    sizes = np.linalg.norm(result.reactions[0], axis=1)
    return {
        "largest tension": float(np.nanmax(result.tension[0])),
        "largest force on an anchor": float(sizes.max()) if sizes.size else math.nan,
        "largest sag": max((s.sag for s in spans if s.kind == "span"), default=math.nan),
        "lowest point": float((result.positions[0] @ np.asarray(scene.up)).min()),
    }


NOT_LOOKED_AT = Section(
    "Convergence",
    (
        Text(
            "Not looked at, as was asked: how far these numbers hang on segments and step is not known.",
            warning=True,
        ),
    ),
)


_NOT = "NOT CONVERGED"
_NOT_SO = (
    "That steps agree does not make these numbers right: they may all be too long for the motion. See what "
    "is said of the energy under Method."
)


def convergence_section(scene: Scene, result: Result, progress: Callable[[str], None]) -> Section:
    """Return how the numbers change with half the segments, and of a run with half the step."""
    at_rest = result.status == "at rest"
    base = rest_numbers(scene) if at_rest else run_numbers(result)
    variants = [_other_cut(scene, result, progress)]
    if not at_rest:
        variants.append(_other_step(scene, result, progress))
    items: list[Item] = [
        Text(f"{v.title}: {v.why_not}.", warning=v.failed) for v in variants if v.why_not
    ]
    ran = [variant for variant in variants if not variant.why_not]
    if ran:
        rows = [row for name in base if (row := row_of(name, base, ran))]
        items.append(Table(("", "this sheet", *(variant.title for variant in ran)), rows))
        items.append(_verdict(base, ran))
        items += _partings(0 if at_rest else len(result.partings), ran)
        if not at_rest and result.table.get("about the energy"):
            items.append(Text(_NOT_SO, warning=True))
    return Section("Convergence", tuple(items))


def doubts(convergence: Section) -> tuple[Item, ...]:
    """Return what a summary has to say of convergence: what its section warns of."""
    told = [one.words for one in convergence.items if isinstance(one, Text) and one.warning]
    return tuple(
        Text(words if words.startswith(_NOT) else f"Convergence: {words}", warning=True)
        for words in told
        if words != _NOT_SO
    )


def _partings(own: int, ran: list[Variant]) -> list[Item]:
    """Say which variants part at more or fewer places than `own`: forces near the breaking load are alike."""
    others = {variant.title: variant.numbers.get(PARTED, own) for variant in ran}
    return [
        Text(
            f"With {title} ropes part at {counted(int(number), 'place')}, in this sheet at {own}.",
            warning=True,
        )
        for title, number in others.items()
        if number != own
    ]


def _other_cut(scene: Scene, result: Result, progress: Callable[[str], None]) -> Variant:
    other = recut(scene)
    if other.scene is None:
        return Variant("other segments", why_not=f"not tried, since {other.why_not}")
    title = "half the segments" if other.factor < 1.0 else "twice the segments"
    progress(f"once more with {title}")
    if result.status == "at rest":
        return tried(title, lambda made: rest_numbers(made), other.scene)
    plan, run = result.plan, other.scene.run
    if plan.tolerance is not None:
        run = run.replace(method=plan.method)
    else:  # an explicit step that was stable is no longer so for segments half as long
        finer = other.factor > 1.0
        run = run.replace(method=plan.method, time_step=plan.dt / (2.0 if finer else 1.0))
        title += " (and half the step)" if finer else ""
    return tried(title, _ran, other.scene.replace(run=run))


def _other_step(scene: Scene, result: Result, progress: Callable[[str], None]) -> Variant:
    plan = result.plan
    if plan.tolerance is None:
        title = "half the step"
        run = scene.run.replace(method=plan.method, time_step=plan.dt / 2.0)
    else:
        title = "a tenth of the tolerance"
        run = scene.run.replace(method=plan.method, tolerance=max(plan.tolerance / 10.0, 1e-9))
    progress(f"once more with {title}")
    return tried(title, _ran, scene.replace(run=run))


def tried(title: str, numbers: Callable[[Scene], dict[str, float]], scene: Scene) -> Variant:
    """Return a variant of these numbers of a scene, or why there are none."""
    from ropewalk.api import BrokenRun

    try:
        return Variant(title, numbers(scene))
    except BrokenRun as error:
        why = str(error.diagnosis)
    except (SceneError, NoRest) as error:
        why = str(error)
    return Variant(title, why_not=f"FAILED: {why.splitlines()[0].rstrip('.')}", failed=True)


def row_of(name: str, base: dict[str, float], ran: list[Variant]) -> tuple[str, ...] | None:
    """Return a quantity with every variant's value and change; of a length in metres, else in percent."""
    value = base[name]
    if math.isnan(value):
        return None
    force = name.endswith(("tension", "anchor"))
    unit = "N" if force else "m/s" if name == "largest speed" else "m"

    def told(number: float) -> str:
        return prefixed(number, "N", 5) if force else f"{number:.5g} {unit}"

    cells = []
    for variant in ran:
        if variant.why_not:
            cells.append("")
            continue
        other = variant.numbers[name]
        change = (
            f"{other - value:+.2g} m"
            if unit == "m"
            else f"{percent(_change(value, other), sign='+')}"
        )
        cells.append(f"{told(other)} ({change})")
    return (name, told(value), *cells)


def _change(value: float, other: float) -> float:
    """Return by how much a number changes [%]."""
    return 100.0 * (other - value) / abs(value) if value else math.inf if other else 0.0


def _verdict(base: dict[str, float], ran: list[Variant]) -> Text:
    """Return whether the forces hold when cut or stepped otherwise."""
    worst, of, by = 0.0, "", ""
    for variant in ran:
        for name in ("largest tension", "largest force on an anchor"):
            change = abs(_change(base[name], variant.numbers[name]))
            if change > worst:
                worst, of, by = change, name, variant.title
    if worst > LARGE:
        return Text(
            f"{_NOT}: the {of} changes by {percent(worst)} with {by}. Cut the ropes finer, or step "
            "shorter, before these numbers are used.",
            warning=True,
        )
    tried = ", and with ".join(variant.title for variant in ran)
    return Text(
        f"The forces change by at most {percent_up(worst)} with {tried}. So much may what was varied be "
        "expected to cost; it says nothing of what was not varied, nor of the data."
    )
