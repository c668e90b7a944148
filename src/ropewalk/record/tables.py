"""A result as tables: columns with units, rows in pieces."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ropewalk.core.peaks import BOUNDS, EXTREMES
from ropewalk.laws.wheel_rows import RECORDED, UNITS
from ropewalk.record.contacts import COLUMNS, rows
from ropewalk.record.errors import InputError, RunError
from ropewalk.record.moving_rows import SLIDE_COLUMNS, slide_rows
from ropewalk.record.quantities import (
    AXES,
    BY_NAME,
    CONTACT_WORK,
    EXTREME_UNITS,
    OBSTACLE_FORCE,
    PULLEYS,
    ROPE_CONTACTS,
    law_names,
)
from ropewalk.record.rope_contact_table import HEADERS as ROPE_COLUMNS
from ropewalk.record.rope_contact_table import rope_rows
from ropewalk.record.selection import EXPORTED, Indices, Selection, select, take
from ropewalk.record.skipped import is_of_steps
from ropewalk.record.wrap_table import WRAP_COLUMNS, wrap_rows
from ropewalk.words.nearest import nearest

if TYPE_CHECKING:
    import pandas as pd

    from ropewalk.record.result import Result

NAMES = (
    *("nodes", "segments", "anchors", "joints", "pulleys"),
    *("contacts", "rope_contacts", "wraps", "slides", "run"),
)
Columns = list[NDArray[Any]]


@dataclass(frozen=True)
class Table:
    """One table; `pieces` yields its columns for some frames after others."""

    name: str
    headers: list[str]
    pieces: Callable[[], Iterator[Columns]]


def tables(result: Result, chosen: Selection, layout: str) -> list[Table]:
    """Return the tables that hold the chosen quantities, `long` or `wide`.

    nodes: positions and velocities; segments: tensions and unstretched length; anchors: reactions
    and moments; joints: their forces on each rope; pulleys: how they turn, and works; contacts: a row for
    each node on each obstacle; rope_contacts: one for each contact of two ropes; wraps: one for each stretch
    of a rope on an obstacle; slides: one for each slide; run: energies, works, momentum, one row
    per frame in either layout. Those of pulleys and of the run are of all ropes, whichever is chosen.
    """
    ropes, numbers = _node_labels(result)
    at_nodes = [f"{ropes[i]}[{numbers[i]}]" for i in chosen.nodes]
    at_segments = [f"{ropes[j]}[{numbers[j]}]" for j in chosen.segments]
    names = [result.layout.anchor_names[k] for k in chosen.anchors]
    ties = [result.layout.ties[k] for k in chosen.ties]
    pulleys = list(result.layout.pulleys)
    kinds = (
        ("nodes", "node", chosen.nodes, at_nodes, _OF_NODES),
        ("segments", "segment", chosen.segments, at_segments, _OF_SEGMENTS),
        ("anchors", "anchor", chosen.anchors, names, _OF_ANCHORS),
        ("joints", "tie", chosen.ties, ties, ("joint_forces",)),
        ("pulleys", "pulley", np.arange(len(pulleys)), pulleys, (PULLEYS,)),
    )
    found = []
    for name, noun, places, shown, quantities in kinds:
        wanted = [q for q in quantities if q in chosen.quantities and q in result.source.names]
        if not wanted or not len(places):
            continue
        if layout == "wide":
            found.append(_wide(result, chosen, name, places, shown, wanted))
        else:
            keys: dict[str, NDArray[Any]] = {noun: np.array(shown, dtype=object)}
            if noun in ("node", "segment"):
                keys = {"rope": ropes[places], noun: numbers[places]}
            found.append(_long(result, chosen, name, places, keys, wanted))
    found += contact_tables(result, chosen)
    if run := _run_table(result, chosen):
        found.append(run)
    return found


def _node_labels(result: Result) -> tuple[NDArray[Any], Indices]:
    labelled = [result.layout.rope_of(index) for index in range(result.nodes)]
    ropes = np.array([rope for rope, _ in labelled], dtype=object)
    return ropes, np.array([number for _, number in labelled])


_SYMBOLS = {
    "positions": "",
    "velocities": "v",
    "reactions": "f",
    "moments": "m",
    "joint_forces": "f",
    "contact_force": "contact f",
    OBSTACLE_FORCE: "obstacle f",
}


_OF_NODES = (
    *("positions", "velocities", "contact_force", OBSTACLE_FORCE),
    *("greatest_speed", "least_height", "greatest_height"),
)
_OF_CONTACTS = ("positions", "velocities", "contact_force")  # what they follow from
_OF_SLIDES = (
    "positions",
    "velocities",
    "tension",
)  # the last, for a table of nodes alone stays alone
_OF_SEGMENTS = (
    *("tension", "elastic_tension", "least_tension", "greatest_tension", "greatest_stretch"),
    "rest_length",
)
_OF_ANCHORS = ("reactions", "moments", "greatest_reactions", "greatest_moments")
_GREATEST = {"greatest_reactions": "greatest force", "greatest_moments": "greatest moment"}


def _components(result: Result, quantity: str) -> list[tuple[str, str]]:
    """Return symbol and unit of a quantity's components."""
    unit = BY_NAME[quantity].unit
    if quantity == "tension":
        return [(result.tension_name, unit)]
    if quantity == PULLEYS:
        return list(zip(RECORDED, UNITS, strict=True))
    if quantity in _SYMBOLS:
        return [(_SYMBOLS[quantity] + axis, unit) for axis in AXES]
    return [(_GREATEST.get(quantity, quantity.replace("_", " ")), unit)]


def _values(
    result: Result, chosen: Selection, quantity: str, piece: Indices, places: Indices
) -> NDArray[np.float64]:
    """Return (frames, places, components)."""
    array = chosen.take(result, quantity, piece)[:, places]
    return array[..., None] if array.ndim == 2 else array


def _long(
    result: Result,
    chosen: Selection,
    name: str,
    places: Indices,
    keys: dict[str, NDArray[Any]],
    quantities: list[str],
) -> Table:
    headers = ["time [s]", *keys]
    headers += [f"{symbol} [{unit}]" for q in quantities for symbol, unit in _components(result, q)]

    def pieces() -> Iterator[Columns]:
        for piece in chosen.pieces(result):
            columns: Columns = [np.repeat(take(result, "time", piece), len(places))]
            columns += [np.tile(key, len(piece)) for key in keys.values()]
            for quantity in quantities:
                values = _values(result, chosen, quantity, piece, places)
                columns += [values[..., k].ravel() for k in range(values.shape[-1])]
            yield columns

    return Table(name, headers, pieces)


def _wide(
    result: Result,
    chosen: Selection,
    name: str,
    places: Indices,
    shown: list[str],
    quantities: list[str],
) -> Table:
    headers = ["time [s]"]
    for quantity in quantities:
        parts = _components(result, quantity)
        headers += [f"{symbol} {place} [{unit}]" for place in shown for symbol, unit in parts]

    def pieces() -> Iterator[Columns]:
        for piece in chosen.pieces(result):
            columns: Columns = [take(result, "time", piece)]
            for quantity in quantities:
                values = _values(result, chosen, quantity, piece, places)
                columns += list(values.reshape(len(piece), -1).T)
            yield columns

    return Table(name, headers, pieces)


def series(
    result: Result, quantity: str, of_rows: NDArray[np.float64] | None = None
) -> dict[str, NDArray[np.float64]]:
    """Return the series of a quantity of the whole run by header, each (frames,).

    Of greatest and least rows may be given, (rows, columns), in place of the frames.
    """
    unit = BY_NAME[quantity].unit
    if quantity == "energy":
        found = {f"{name} energy [{unit}]": array for name, array in result.energy.items()}
        if result.facts.ledger:
            found[f"energy error [{unit}]"] = result.energy_error
            found[f"balance residual [{unit}]"] = result.balance_residual
        return found
    if quantity == "work":
        names = law_names(result.layout)
        return {f"work of {name} [{unit}]": result.work[name] for name in names}
    if quantity == CONTACT_WORK:
        return {
            f"{entry} of {surface} [{unit}]": array
            for surface, entries in result.contact_work.items()
            for entry, array in entries.items()
        }
    if quantity in OF_ERRORS and not result.facts.ledger:
        return {}
    symbol = quantity.replace("_", " ")
    array = result.read(quantity) if of_rows is None else of_rows
    if quantity in OF_EXTREMES:  # but those that there are none of, as moments without a clamp
        about, units = OF_EXTREMES[quantity], EXTREME_UNITS if quantity == "extremes" else None
        return {
            f"{about}{name} [{units[k] if units else unit}]": array[:, k]
            for k, name in enumerate(EXTREMES)
            if array.shape[0] == 0 or np.isfinite(array[:, k]).any()
        }
    if quantity in OF_ERRORS:
        about = OF_ERRORS[quantity]
        return {
            f"{about}{bound} energy error [{unit}]": array[:, k] for k, bound in enumerate(BOUNDS)
        }
    return {f"{symbol} {axis} [{unit}]": array[:, k] for k, axis in enumerate(AXES)}


def _run_table(result: Result, chosen: Selection) -> Table | None:
    whole = [q for q in chosen.quantities if q in OF_THE_RUN and q in result.source.names]
    if not whole:
        return None
    columns = {"time [s]": result.time}
    for quantity in whole:
        columns |= series(result, quantity)
    rows = {name: array[chosen.frames] for name, array in columns.items()}
    for quantity in whole:
        if is_of_steps(quantity):
            of_steps = chosen.take(result, quantity, chosen.frames)
            headers = series(result, quantity, of_steps)
            rows |= {name: array for name, array in headers.items() if name in rows}

    def pieces() -> Iterator[Columns]:
        for piece in chosen.pieces(result):
            here = np.searchsorted(chosen.frames, piece)
            yield [array[here] for array in rows.values()]

    return Table("run", list(rows), pieces)


def contact_tables(result: Result, chosen: Selection) -> list[Table]:
    """Return who touches what and where it slides, in either layout a row for each at every frame."""
    asked = [q for q in chosen.quantities if q in result.source.names]
    on_obstacles = bool(result.scene.obstacles) and set(_OF_CONTACTS) <= set(asked)
    kinds: list[tuple[str, bool, Sequence[str], Callable[[Indices], Columns]]] = [
        ("contacts", on_obstacles, COLUMNS, lambda piece: rows(result, piece, chosen.nodes)),
        (
            "rope_contacts",
            ROPE_CONTACTS in asked,
            ROPE_COLUMNS,
            lambda piece: rope_rows(result, piece, chosen.segments),
        ),
        (
            "wraps",
            on_obstacles and "tension" in asked,
            WRAP_COLUMNS,
            lambda piece: wrap_rows(result, piece, chosen.nodes),
        ),
        (
            "slides",
            bool(result.scene.slides) and set(_OF_SLIDES) <= set(asked),
            SLIDE_COLUMNS,
            slide_rows(result, chosen.nodes),
        ),
    ]
    return [
        Table(name, list(headers), partial(_each, chosen, result, make))
        for name, there, headers, make in kinds
        if there
    ]


def _each(
    chosen: Selection, result: Result, make: Callable[[Indices], Columns]
) -> Iterator[Columns]:
    """Yield pieces with rows; where there is none, one without, whose columns have no types of their own."""
    made, none = None, True
    for piece in chosen.pieces(result):
        made = make(piece)
        if len(made[0]):
            none = False
            yield made
    if none and made is not None:
        yield made


OF_EXTREMES = {
    "extremes": "",
    "extreme_places": "place of ",
    "extreme_since": "time after which came ",
    "extreme_until": "time until which came ",
}
OF_ERRORS = {"energy_errors": "", "energy_error_times": "time of the "}
OF_THE_RUN = (
    "energy",
    "work",
    CONTACT_WORK,
    "momentum",
    "angular_momentum",
    *OF_EXTREMES,
    *OF_ERRORS,
)


def to_pandas(
    result: Result,
    table: str,
    nodes: Sequence[int] | None,
    times: Sequence[float] | None,
    every: int | None,
    rope: str | None,
) -> pd.DataFrame:
    """Return a table of a result; see `Result.to_pandas`."""
    if table not in NAMES:
        raise InputError("table", table, f"no such table; {nearest(table, NAMES)}")
    try:
        import pandas
    except ImportError:
        raise RunError("to_pandas", "needs one package more: pip install pandas") from None
    chosen = select(result, EXPORTED, nodes, times, every, rope)
    found = {made.name: made for made in tables(result, chosen, "long")}
    if table not in found:
        raise InputError("table", table, f"this run has none; there is {', '.join(found)}")
    pieces = list(found[table].pieces())
    columns = [np.concatenate(parts) for parts in zip(*pieces, strict=True)]
    return pandas.DataFrame(dict(zip(found[table].headers, columns, strict=True)))
