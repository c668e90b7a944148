"""VTK PolyData, one .vtp a frame and a .pvd with the times, as ParaView opens them.

Every segment is a cell, so that tension is cell data; segments between ropes and on drums are left out.
Numbers are binary in base64, with their size in bytes as UInt64 before them.
Source: VTK file formats, docs.vtk.org, XML formats (PolyData, Collection).
"""

from __future__ import annotations

import base64
import shutil
from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Any
from xml.sax.saxutils import quoteattr

import numpy as np
from numpy.typing import NDArray

from ropewalk.record.contacts import node_modes
from ropewalk.record.errors import RunError
from ropewalk.record.files import PARTIAL, write, writing
from ropewalk.record.quantities import has_rope, rest_length_at_start, rope_numbers
from ropewalk.record.selection import Indices, Selection, take

if TYPE_CHECKING:
    from ropewalk.record.result import Result

_TYPES = {"f8": "Float64", "i8": "Int64"}
_HEAD = (
    '<?xml version="1.0"?>\n'
    '<VTKFile type="{}" version="1.0" byte_order="LittleEndian" header_type="UInt64">\n'
)


def write_vtk(result: Result, chosen: Selection, out: Path, overwrite: bool) -> Path:
    """Write the series into the folder `out`; return its .pvd. Raises RunError.

    Points are the chosen nodes; positions are always written, velocities, tensions and contact forces where
    they are chosen, these with what each node does (0 open, 1 sticks, 2 slips, 3 unknown), and where
    obstacles are as field data; other quantities have no place in it.
    """
    index, frames = out / "rope.pvd", out / "frames"
    with writing(out):
        if out.exists() and not out.is_dir():
            raise RunError(out, "is a file; VTK needs a folder")
        if (index.exists() or frames.exists()) and not overwrite:
            raise RunError(out, "holds an export already; choose another folder, or overwrite")
        foreign = frames.exists() and any(not _own(entry) for entry in frames.iterdir())
        if foreign:
            raise RunError(frames, "holds other files than frames; it is not replaced")
        out.mkdir(parents=True, exist_ok=True)
        partial = out / f".frames{PARTIAL}"
        shutil.rmtree(partial, ignore_errors=True)
        partial.mkdir()
        try:
            names = _write_frames(result, chosen, partial)
            if frames.exists():
                index.unlink(missing_ok=True)
                shutil.rmtree(frames)
            partial.rename(frames)
        finally:
            shutil.rmtree(partial, ignore_errors=True)
        write(index, _index(result, chosen, names).encode())
    return index


def _own(entry: Path) -> bool:
    return entry.name.startswith("frame_") and entry.suffix == ".vtp"


def _index(result: Result, chosen: Selection, names: list[str]) -> str:
    lines = [_HEAD.format("Collection") + "<Collection>"]
    for time, name in zip(result.time[chosen.frames], names, strict=True):
        lines.append(f'<DataSet timestep="{float(time)!r}" part="0" file="frames/{name}"/>')
    return "\n".join([*lines, "</Collection>\n</VTKFile>\n"])


def _write_frames(result: Result, chosen: Selection, folder: Path) -> list[str]:
    names = []
    for piece in chosen.pieces(result):
        names_of = ("positions", *_more(result, chosen))
        arrays: dict[str, NDArray[Any]] = {name: take(result, name, piece) for name in names_of}
        lengths = [rope.segment_length for rope in result.scene.ropes]
        if "rest_length" in result.source.names:
            rest = take(result, "rest_length", piece)
        else:
            fixed = rest_length_at_start(result.layout, lengths)
            rest = np.broadcast_to(fixed, (len(piece), len(fixed)))
        if "contact_force" in arrays:
            arrays["contact_mode"] = node_modes(result, piece.tolist())
        live = has_rope(result.layout, rest, lengths)
        for row, frame in enumerate(piece):
            name = f"frame_{frame:06d}.vtp"
            parts = {key: array[row] for key, array in arrays.items()}
            write(folder / name, _poly_data(result, chosen, parts, live[row], frame))
            names.append(name)
    return names


def _more(result: Result, chosen: Selection) -> list[str]:
    wanted = ("velocities", "tension", "elastic_tension", "contact_force")
    return [name for name in wanted if name in chosen.quantities and name in result.source.names]


def _poly_data(
    result: Result,
    chosen: Selection,
    parts: dict[str, Any],
    live: NDArray[np.bool_],
    frame: int,
) -> bytes:
    nodes = chosen.nodes
    place = np.full(result.nodes, -1)
    place[nodes] = np.arange(len(nodes))
    cells = np.flatnonzero(live & (place[:-1] >= 0) & (place[1:] >= 0))
    lines = np.stack([place[cells], place[cells + 1]], axis=1)
    number = rope_numbers(result.layout)
    points: dict[str, NDArray[Any]] = {"rope": number[nodes], "node": _numbers(result, nodes)}
    if "velocities" in parts:
        velocity = parts["velocities"][nodes]
        with np.errstate(over="ignore", invalid="ignore"):  # of a broken frame
            points |= {"velocity": velocity, "speed": np.linalg.norm(velocity, axis=1)}
    if "contact_force" in parts:
        points["contact_force"] = parts["contact_force"][nodes]
        points["contact_mode"] = parts["contact_mode"][nodes]
    of_cells: dict[str, NDArray[Any]] = {"rope": number[cells]}
    if "tension" in parts:
        of_cells[result.tension_name.replace(" ", "_")] = parts["tension"][cells]
    if "elastic_tension" in parts:
        of_cells["elastic_tension"] = parts["elastic_tension"][cells]
    count = f'NumberOfPoints="{len(nodes)}" NumberOfVerts="0" NumberOfLines="{len(cells)}"'
    text = [_HEAD.format("PolyData") + "<PolyData>"]
    if result.scene.obstacles:
        bodies = result.obstacle_positions(slice(frame, frame + 1))[0]
        turns = result.obstacle_angles(slice(frame, frame + 1))[0]
        text += ["<FieldData>", _array("obstacle_position", bodies, tuples=True)]
        text += [_array("obstacle_angle", turns, tuples=True), "</FieldData>"]
    text.append(f'<Piece {count} NumberOfStrips="0" NumberOfPolys="0">')
    text += ["<PointData>", *_arrays(points), "</PointData>"]
    text += ["<CellData>", *_arrays(of_cells), "</CellData>"]
    text += ["<Points>", _array("Points", parts["positions"][nodes]), "</Points>"]
    ends = 2 * np.arange(1, len(cells) + 1)
    text += ["<Lines>", *_arrays({"connectivity": lines.ravel(), "offsets": ends}), "</Lines>"]
    return "\n".join([*text, "</Piece>", "</PolyData>", "</VTKFile>", ""]).encode()


def _numbers(result: Result, nodes: Indices) -> Indices:
    return np.array([result.layout.rope_of(int(i))[1] for i in nodes])


def _arrays(arrays: dict[str, NDArray[Any]]) -> Iterable[str]:
    return [_array(name, array) for name, array in arrays.items()]


def _array(name: str, array: NDArray[Any], *, tuples: bool = False) -> str:
    kind = "f8" if array.dtype.kind == "f" else "i8"
    data = np.ascontiguousarray(array, dtype="<" + kind).tobytes()
    width = array.shape[1] if array.ndim == 2 else 1
    packed = base64.b64encode(len(data).to_bytes(8, "little") + data).decode("ascii")
    about = f'type="{_TYPES[kind]}" Name={quoteattr(name)} NumberOfComponents="{width}"'
    about += f' NumberOfTuples="{len(array)}"' if tuples else ""
    return f'<DataArray {about} format="binary">{packed}</DataArray>'
