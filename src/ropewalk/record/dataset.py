"""Results as xarray datasets, and the coordinates that a dataset and a run folder share."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.lowering import Layout
from ropewalk.record.books import told
from ropewalk.record.obstacle_table import swings
from ropewalk.record.place import DATA
from ropewalk.record.quantities import (
    BY_NAME,
    WORKS,
    joined,
    labels,
    rest_length_at_start,
    rope_numbers,
)
from ropewalk.scene import Scene

if TYPE_CHECKING:
    from collections.abc import Mapping

    import xarray as xr

    from ropewalk.record.result import Result
    from ropewalk.record.run_dataset import RunDataset

TIME = {"units": "s", "long_name": "time", "standard_name": "time"}


def coordinates(scene: Scene, layout: Layout) -> dict[str, tuple[str, Any, dict[str, str]]]:
    """Return all coordinates but time: name -> dimension, values, attributes."""
    names = np.array([span.name for span in layout.ropes], dtype=object)
    number = rope_numbers(layout)
    rest = rest_length_at_start(layout, [rope.segment_length for rope in scene.ropes])
    found: dict[str, tuple[str, Any, dict[str, str]]] = {
        "node": ("node", np.arange(layout.nodes), {"long_name": "place in the arrays"}),
        "segment": ("segment", np.arange(layout.segments), {"long_name": "place in the arrays"}),
        "node_rope": ("node", names[number], {"long_name": "rope of the node"}),
        "node_number": (
            "node",
            _numbers(layout),
            {"long_name": "number of the node in its rope; outside the rope: on a drum"},
        ),
        "segment_rope": (
            "segment",
            np.where(joined(layout), names[number[:-1]], ""),
            {"long_name": "rope of the segment; empty between two ropes"},
        ),
        "arc_length": (
            "segment",
            _arc_length(layout, rest),
            {
                "units": "m",
                "long_name": "unstretched length from the rope's start to the segment's middle",
            },
        ),
    }
    meanings = {
        "axis": "axis",
        "form": "form of energy",
        "law": "law or anchor that does the work",
        "cause": "what put it in",
        "anchor": "anchor",
        "tie": "what a joint ties",
        "column": "what is told of a contact of two ropes",
        "pulley": "obstacle that turns freely",
        "surface": "what ropes touch: obstacles, and other ropes",
        "entry": "what did the work: motor, pressing, friction; what is stored; the method's share",
        "motion": "what is told of an obstacle that turns freely",
        "extreme": "greatest or least of all steps since the frame before",
        "bound": "least or greatest of all steps since the frame before",
    }
    for name, values in labels(layout).items():
        if values:
            found[name] = (name, np.array(values, dtype=object), {"long_name": meanings[name]})
    return found


def _numbers(layout: Layout) -> np.ndarray[Any, np.dtype[np.int64]]:
    return np.concatenate([np.arange(span.nodes) - span.spare_start for span in layout.ropes])


def _arc_length(layout: Layout, rest: Floats) -> Floats:
    out = np.full(layout.segments, np.nan)
    for span in layout.ropes:
        lengths = rest[span.first : span.last]
        out[span.first : span.last] = np.cumsum(lengths) - 0.5 * lengths
    return out


def attributes(scene: Scene, provenance: dict[str, Any]) -> dict[str, Any]:
    """Return what a dataset says about itself."""
    plan = provenance.get("plan", {})
    tolerance = plan.get("tolerance")
    step = (
        {"time_step": float(plan.get("dt", 0.0))} if tolerance is None else {"tolerance": tolerance}
    )
    return {
        "title": scene.name,
        "comment": scene.description,
        "source": f"ropewalk {provenance.get('ropewalk', '')}".rstrip(),
        "method": str(plan.get("method", "")),
        **step,
        "gravity": list(scene.gravity),
        "up": list(scene.up),
    }


def _counts(result: Result) -> dict[str, float]:
    """Return how many steps of varying length were taken, as attributes."""
    return {f"{name}_steps": count for name, count in result.facts.step_counts.items()
            if name in ("accepted", "rejected")}  # fmt: skip


def _obstacles(result: Result) -> dict[str, Any]:
    """Return where obstacles are, where any of them moves, and how far they have turned, where any turns."""
    bodies, found = result.scene.obstacles, dict[str, Any]()
    names = {"obstacles": ", ".join(body.name for body in bodies)}
    moved = any(body.motion.kind != "fixed" for body in bodies)
    if moved or swings(result.scene, result.layout):
        about = names | {"units": "m", "long_name": "middle of each obstacle, or a plane's point"}
        places = result.obstacle_positions()
        found["obstacle_position"] = (("time", "obstacle", "axis"), places, about)
    if any(body.spin is not None for body in bodies):
        about = names | {"units": "rad", "long_name": "by how much each obstacle has turned"}
        found["obstacle_angle"] = (("time", "obstacle"), result.obstacle_angles(), about)
    return found


def make_dataset(result: Result) -> RunDataset:
    """Return a result's dataset: lazy for a run folder, views of the arrays in memory otherwise."""
    import xarray as xr

    from ropewalk.record.run_dataset import RunDataset

    if result.folder is not None:
        from ropewalk.record.run_store import RunStore

        store = RunStore(result.folder / DATA, source=result.source)
        stored: xr.Dataset = xr.open_zarr(store, chunks=None)
        books = [name for name in WORKS if name in stored]
        works = {
            name: stored[name].copy(data=told(result, name, stored[name].values)) for name in books
        }
        own = dict(stored.data_vars) | works | _obstacles(result)
        return RunDataset(own, stored.coords, stored.attrs | _counts(result))
    variables = {}
    for name in result.source.names:
        quantity = BY_NAME[name]
        about = {"units": quantity.unit, "long_name": quantity.long_name}
        variables[name] = (quantity.dims, told(result, name, result.read(name)), about)
    variables |= _obstacles(result)
    coords: dict[str, Any] = dict(coordinates(result.scene, result.layout))
    coords["time"] = ("time", result.time, TIME)
    about = attributes(result.scene, result.facts.provenance) | _counts(result)
    return RunDataset(variables, coords, about)


def split_dataset(result: Result) -> Mapping[str, xr.Dataset]:
    """Return datasets of nodes, segments, anchors, joints and the run; see `Result.datasets`."""
    from ropewalk.record.run_dataset import split

    return split(result, result.dataset)
