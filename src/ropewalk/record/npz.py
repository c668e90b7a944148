"""NumPy archives, written a piece at a time."""

from __future__ import annotations

import zipfile
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ropewalk.record.quantities import BY_NAME, QUANTITIES, labels, rope_numbers, sizes
from ropewalk.record.result import Result
from ropewalk.record.selection import Indices, Selection, take


def write_npz(result: Result, chosen: Selection, path: Path) -> None:
    """Write the chosen quantities as arrays of the shapes that a Result has. Raises OSError.

    Beside them: `time`, the ropes and numbers of `nodes`, the ropes of `segments`, and the names along
    `form`, `law`, `anchor`, `extreme` and `bound`. Energies are the columns kinetic, gravity, elastic.
    """
    names = [q.name for q in QUANTITIES if q.name in chosen.quantities]
    with zipfile.ZipFile(path, "w", zipfile.ZIP_STORED) as archive:
        _write_pieces(archive, "time", result, chosen, (), "time")
        for name in names:
            if name in result.source.names:
                title = result.tension_name.replace(" ", "_") if name == "tension" else name
                shape = _shape(result, chosen, name)
                _write_pieces(archive, title, result, chosen, shape, name)
        for name, array in _about(result, chosen).items():
            with archive.open(f"{name}.npy", "w", force_zip64=True) as file:
                np.lib.format.write_array(file, array, allow_pickle=False)


def _shape(result: Result, chosen: Selection, name: str) -> tuple[int, ...]:
    lengths = sizes(result.layout)
    lengths |= {"node": len(chosen.nodes), "segment": len(chosen.segments)}
    return tuple(lengths[dim] for dim in BY_NAME[name].dims[1:])


def _write_pieces(
    archive: zipfile.ZipFile,
    title: str,
    result: Result,
    chosen: Selection,
    rest: tuple[int, ...],
    name: str,
) -> None:
    header = {"descr": "<f8", "fortran_order": False, "shape": (len(chosen.frames), *rest)}
    with archive.open(f"{title}.npy", "w", force_zip64=True) as file:
        np.lib.format.write_array_header_1_0(file, header)
        for piece in chosen.pieces(result):
            array = _picked(take(result, name, piece), name, chosen)
            file.write(np.ascontiguousarray(array, dtype="<f8").tobytes())


def _picked(array: NDArray[np.float64], name: str, chosen: Selection) -> NDArray[np.float64]:
    second = BY_NAME[name].dims[1] if name in BY_NAME else ""
    places: dict[str, Indices] = {"node": chosen.nodes, "segment": chosen.segments}
    return array[:, places[second]] if second in places else array


def _about(result: Result, chosen: Selection) -> dict[str, NDArray[Any]]:
    ropes = np.array([span.name for span in result.layout.ropes])
    number = rope_numbers(result.layout)
    of_nodes = [result.layout.rope_of(int(i))[1] for i in chosen.nodes]
    named = {
        key: np.array(labels(result.layout)[key], dtype=str)
        for key in ("form", "law", "anchor", "extreme", "bound")
    }
    return {
        "node_rope": ropes[number[chosen.nodes]],
        "node_number": np.array(of_nodes),
        "segment_rope": ropes[number[chosen.segments]],
        "segment_number": np.array([result.layout.rope_of(int(j))[1] for j in chosen.segments]),
        **named,
    }
