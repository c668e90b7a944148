"""What a table of runs says of each besides its values: an index, a name."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ropewalk.scene import SceneError
from ropewalk.scene.faults import Fault
from ropewalk.sweeps.parameters import (
    FLOAT,
    INT,
    RESERVED,
    TEXT,
    Parameter,
    as_table,
    is_path_like,
    used_columns,
)

_NAME = re.compile(r"[^\W\d][\w -]*")  # it is also the name of a folder in the store


@dataclass(frozen=True)
class Label:
    """What a table of runs says of each besides its values: an index, a name; kept as a coordinate."""

    name: str
    values: tuple[Any, ...]
    kind: str
    attributes: Mapping[str, str]

    def described(self) -> dict[str, Any]:
        """All of it but the values, as plain data."""
        return {"name": self.name, "kind": self.kind, "attributes": dict(self.attributes)}


def make_labels(vary: Any, parameters: Sequence[Parameter]) -> tuple[Label, ...]:
    """Return what a table says of its runs besides their values.

    Of a DataFrame its index, if it is more than a count; of a Dataset the other coordinates along the runs.
    Raises SceneError for a name that the answer needs for something else, or that cannot be one, and for a
    path of the scene, which would not be varied.
    """
    vary = as_table(vary)
    found = _of_dataset(vary, len(parameters[0].values or ())) if hasattr(vary, "data_vars") else {}
    if hasattr(vary, "iloc"):
        found = _of_frame(vary)
    taken = {parameter.name for parameter in parameters}
    made, faults = [], []
    for name, (values, about) in found.items():
        name = f"given_{name}" if name in RESERVED else name
        if rule := _why_not(name, taken):
            faults.append(Fault("vary", name, rule))
            continue
        taken.add(name)
        if values.dtype.kind in "mM":  # dates and spans of time are kept as they are written
            values = values.astype(str)
        made.append(_label(name, values.tolist(), about))
    if faults:
        raise SceneError(faults)
    return tuple(made)


def _why_not(name: str, taken: set[str]) -> str:
    """Return why an index or coordinate cannot have this name, or nothing."""
    if name in taken:
        return "names an index and a parameter; rename the index"
    if is_path_like(name):
        return (
            "is an index or a coordinate, which is not varied; make it a column (reset_index of a DataFrame, "
            "reset_coords of a Dataset), or rename it without dots and brackets"
        )
    if not _NAME.fullmatch(name):
        return "is no name for a coordinate of the answer: letters, digits, spaces, - and _ only"
    return ""


def _of_dataset(vary: Any, runs: int) -> dict[str, tuple[Any, dict[str, str]]]:
    """Return the coordinates along the runs of a Dataset, with their attributes."""
    used, found = used_columns(vary), {}
    dims = {dim for column in used.values() for dim in column.dims}
    for key, column in vary.coords.items():
        along = key not in used and (set(column.dims) == dims or column.ndim == 0)
        whole = column.dtype.kind != "O" or not isinstance(np.ravel(column.values)[0], tuple)
        if along and whole and not _is_a_count(column.values):
            values = np.broadcast_to(column.values, [runs])
            found[str(key)] = (
                values,
                {k: str(v) for k, v in column.attrs.items() if isinstance(v, str)},
            )
    return found


def _of_frame(vary: Any) -> dict[str, tuple[Any, dict[str, str]]]:
    """Return the levels of a DataFrame's index, if it is more than a count."""
    found = {}
    for level in range(vary.index.nlevels):
        values = vary.index.get_level_values(level)
        name = values.name if values.name is not None else "index"
        if vary.index.nlevels > 1 or not _is_a_count(np.asarray(values)):
            found[str(name)] = np.asarray(values), {"long_name": "index of the table of runs"}
    return found


def _is_a_count(values: Any) -> bool:
    """Tell whether values only count the runs: 0, 1, 2, ..."""
    found = np.asarray(values)
    return found.dtype.kind in "iu" and np.array_equal(found, np.arange(found.size))


def _label(name: str, values: list[Any], about: Mapping[str, str]) -> Label:
    if all(isinstance(v, int) and not isinstance(v, bool) for v in values):
        return Label(name, tuple(values), INT, about)
    if all(isinstance(v, (int, float)) and not isinstance(v, bool) for v in values):
        return Label(name, tuple(map(float, values)), FLOAT, about)
    return Label(name, tuple(map(str, values)), TEXT, about)
