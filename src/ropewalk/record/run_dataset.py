"""A run's whole dataset, which refuses to become one table; and the parts that make tables."""

from __future__ import annotations

import math
from collections.abc import Callable, Hashable, Iterator, Mapping, Sequence
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr

from ropewalk.record.errors import InputError
from ropewalk.record.quantities import BY_NAME, ROPE_CONTACTS, labels
from ropewalk.record.selection import EXPORTED, select
from ropewalk.record.tables import OF_THE_RUN, Table, contact_tables, series

if TYPE_CHECKING:
    import pandas as pd

    from ropewalk.record.result import Result

_PLACES = {
    "node": "nodes",
    "segment": "segments",
    "anchor": "anchors",
    "tie": "joints",
    "pulley": "pulleys",
}


class RunDataset(xr.Dataset):  # type: ignore[no-untyped-call]
    """A Dataset that makes a table of variables only where none brings dimensions foreign to the others."""

    __slots__ = ()

    def to_dataframe(self, dim_order: Sequence[Hashable] | None = None) -> pd.DataFrame:
        """Return a pandas DataFrame, a row for every combination of the dimensions.

        Raises InputError (a ValueError) when that would be more rows than any variable has values.
        """
        rows = math.prod(self.sizes.values())
        most = max((variable.size for variable in self.data_vars.values()), default=rows)
        if rows > most:
            first = ", ".join(map(str, list(self.data_vars)[:4]))
            names = first + (" ..." if len(self.data_vars) > 4 else "")
            rule = (
                f"these have different dimensions, and one table of all would have {rows:.3g} rows; "
                'take one part: result.to_pandas("segments"), or result.datasets["nodes"]'
            )
            raise InputError("to_dataframe", names, rule)
        return super().to_dataframe(dim_order)


class Parts(Mapping[str, xr.Dataset]):
    """The parts of a dataset by name; those of contacts are reckoned when they are asked for."""

    def __init__(self, ready: dict[str, xr.Dataset], later: dict[str, Callable[[], xr.Dataset]]):
        self._ready, self._later = ready, later

    def __getitem__(self, name: str) -> xr.Dataset:
        if name in self._later:
            self._ready[name] = self._later.pop(name)()
        return self._ready[name]

    def __iter__(self) -> Iterator[str]:
        return iter([*self._ready, *self._later])

    def __len__(self) -> int:
        return len(self._ready) + len(self._later)


def split(result: Result, whole: xr.Dataset) -> Parts:
    """Return the parts of a dataset by what they are of: nodes, segments, anchors, joints, run, contacts."""
    names: dict[str, list[str]] = {}
    for name in result.source.names:
        if name == ROPE_CONTACTS:
            continue
        part = next((_PLACES[dim] for dim in BY_NAME[name].dims if dim in _PLACES), "run")
        names.setdefault(part, []).append(name)
    found = {part: whole[names[part]] for part in _PLACES.values() if part in names}
    found |= {"run": _of_the_run(result, whole, names.get("run", []))}
    chosen = select(result, EXPORTED, None, None, None, None)
    lists = contact_tables(result, chosen)
    return Parts(found, {table.name: partial(_of_rows, table, whole.attrs) for table in lists})


def _of_rows(table: Table, about: Mapping[Hashable, Any]) -> xr.Dataset:
    """Return a table as variables over its rows, with units."""
    parts = list(zip(*table.pieces(), strict=True))
    variables = {}
    for header, pieces in zip(table.headers, parts, strict=True):
        name, _, unit = header.partition(" [")
        attrs = {"long_name": name} | ({"units": unit.rstrip("]")} if unit else {})
        variables[name.replace(" ", "_")] = ("row", np.concatenate(pieces), attrs)
    return xr.Dataset(variables, attrs=dict(about))


def _of_the_run(result: Result, whole: xr.Dataset, names: list[str]) -> xr.Dataset:
    """Return what has one value a frame, each label of a quantity as a variable of its own."""
    variables = {}
    for name in names:
        quantity = BY_NAME[name]
        if name in OF_THE_RUN:
            columns = series(result, name)
        elif len(quantity.dims) == 1:
            columns = {f"{name} [{quantity.unit}]": result.read(name)}
        else:
            array, words = result.read(name), labels(result.layout)[quantity.dims[1]]
            columns = {
                f"{name} {word} [{quantity.unit}]": array[:, k] for k, word in enumerate(words)
            }
        for header, values in columns.items():
            column, _, unit = header.removesuffix("]").rpartition(" [")
            about = {"units": unit, "long_name": column}
            variables[column.replace(" ", "_")] = ("time", np.asarray(values), about)
    return xr.Dataset(variables, {"time": whole["time"]}, whole.attrs)
