"""The answer of a sweep: an xarray Dataset with the parameters as coordinates, in their units."""

from __future__ import annotations

import json
import math
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ropewalk.record.errors import RunError
from ropewalk.sweeps.designs import GRID
from ropewalk.sweeps.memory import SweepMemory
from ropewalk.sweeps.store_layout import ABOUT_NOTES, ABOUT_STATUS, DONE
from ropewalk.sweeps.sweep_folder import SweepFolder
from ropewalk.sweeps.sweep_plan import SweepPlan

if TYPE_CHECKING:
    import xarray as xr

#: A grid on disk that would take more memory than this stays a table of runs there [bytes].
MOST_BYTES = 100_000_000
_TEXT_BYTES = 100  # that status and reason of a run take in memory


def open_sweep(folder: str | Path) -> xr.Dataset:
    """Open a sweep's folder, finished or not.

    Of a grid every parameter is a dimension; of other designs (and of grids of more than 100 MB) there is
    one dimension `run` with the parameters along it, read from disk as it is used: `set_index(run=[...])`
    and `unstack` make a grid of it. Runs that are not made yet have the status "".

    Raises RunError when it is none, or damaged.
    """
    return stored(SweepFolder.open(Path(folder)))


def stored(sweep: SweepFolder) -> xr.Dataset:
    """Return the dataset of a sweep on disk. Raises RunError when it is damaged."""
    with _told_of_damage(sweep):
        return _stored(sweep)


@contextmanager
def _told_of_damage(sweep: SweepFolder) -> Iterator[None]:
    try:
        yield
    except (ValueError, KeyError, OSError, RuntimeError) as error:
        rule = (
            f"cannot be read, some of its data are damaged ({error or type(error).__name__}); "
            "`ropewalk info --verify` names them, `ropewalk resume` puts them right"
        )
        raise RunError(sweep.folder, rule) from None


def _stored(sweep: SweepFolder) -> xr.Dataset:
    import xarray as xr

    from ropewalk.sweeps.checked import CheckedStore

    store = CheckedStore.of(sweep)
    found: xr.Dataset = xr.open_zarr(
        store, chunks=None, drop_variables=["run", DONE]
    )  # DONE: until format 2
    found = found.assign_attrs(sweep=str(sweep.folder))
    found = found.assign_coords(_numbers(sweep.plan.runs))
    plan = sweep.plan
    if store.unmarked:
        status = found.status.load()
        for rows in store.unmarked:
            status.values[rows] = ""
        found["status"] = status
    if plan.design != GRID or plan.runs * (plan.run_bytes + _TEXT_BYTES) > MOST_BYTES:
        return found
    return as_grid(found.load(), plan)


def _numbers(runs: int) -> xr.Coordinates:
    """Return the numbers of the runs as a coordinate whose index takes no memory."""
    import pandas as pd
    import xarray as xr

    index = xr.indexes.PandasIndex(pd.RangeIndex(runs, name="run"), "run")
    found = xr.Coordinates.from_xindex(index)
    found["run"].attrs["long_name"] = "number of the run"
    return found


def in_memory(sweep: SweepMemory) -> xr.Dataset:
    """Return the dataset of a sweep in memory."""
    import xarray as xr

    plan = sweep.plan
    coords: dict[str, Any] = {
        "run": ("run", np.arange(plan.runs), {"long_name": "number of the run"})
    }
    for about in plan.parameters:
        told = {"path": about["path"], "long_name": about["long_name"]}
        told |= {"units": about["unit"]} if about["unit"] else {}
        coords[about["name"]] = ("run", sweep.values[about["name"]], told)
    for label in plan.labels:
        coords[label["name"]] = ("run", sweep.values[label["name"]], label["attributes"])
    for dim, found in plan.coordinates.items():
        coords[dim] = (dim, np.array(found["values"]), found["attributes"])
    variables: dict[str, Any] = {
        "status": ("run", sweep.columns["status"], ABOUT_STATUS),
        "notes": ("run", sweep.columns["notes"], ABOUT_NOTES),
        "reason": ("run", sweep.columns["reason"], {"long_name": "why it broke"}),
        "broke_at": (
            "run",
            sweep.columns["broke_at"],
            {"long_name": "time of the last good frame of a broken run", "units": "s"},
        ),
    }
    for v in plan.variables:
        variables[v.name] = (("run", *v.dims), sweep.columns[v.name], v.attributes)
    seed = {} if plan.seed is None else {"seed": plan.seed}
    about = {
        "title": plan.title,
        "source": f"ropewalk {plan.provenance.get('ropewalk', '')}".rstrip(),
        "design": plan.design,
        **seed,
        "grid": json.dumps(list(plan.shape)),
    }
    made = xr.Dataset(variables, coords, about)
    return as_grid(made, plan) if plan.design == GRID else made


def as_grid(table: xr.Dataset, plan: SweepPlan) -> xr.Dataset:
    """Return a table of runs as a grid: one dimension per parameter, in the order they were given."""
    import xarray as xr

    names = [parameter["name"] for parameter in plan.parameters]
    coords: dict[str, Any] = {}
    for place, name in enumerate(names):
        inner = math.prod(plan.shape[place + 1 :])
        picked = np.arange(plan.shape[place]) * inner
        coords[name] = (name, table[name].values[picked], table[name].attrs)
    variables: dict[str, Any] = {}
    for key, array in table.variables.items():
        if key in names:
            continue
        if "run" not in array.dims:
            coords[str(key)] = array
            continue
        shaped = array.values.reshape(*plan.shape, *array.shape[1:])
        made = ((*names, *array.dims[1:]), shaped, array.attrs)
        (coords if key == "run" else variables)[str(key)] = made
    return xr.Dataset(variables, coords, table.attrs)
