"""Results for other programs: CSV, Parquet, NumPy archives, VTK."""

from __future__ import annotations

import csv
import zipfile
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ropewalk.record.errors import InputError, RunError
from ropewalk.record.files import PARTIAL, writing
from ropewalk.record.place import PROVENANCE
from ropewalk.record.quantities import BY_NAME, QUANTITIES, labels, rope_numbers, sizes
from ropewalk.record.selection import DEFAULT, Selection, select
from ropewalk.record.tables import NAMES, Table, tables
from ropewalk.record.vtk import write_vtk
from ropewalk.words.nearest import nearest

if TYPE_CHECKING:
    from ropewalk.record.result import Result

FORMATS = ("csv", "parquet", "npz", "vtk")
LAYOUTS = ("long", "wide")


def export(
    result: Result,
    to: str,
    out: str | Path,
    *,
    quantities: Iterable[str] = DEFAULT,
    nodes: Sequence[int] | None = None,
    times: Sequence[float] | None = None,
    every: int | None = None,
    rope: str | None = None,
    layout: str = "long",
    overwrite: bool = False,
) -> tuple[Path, ...]:
    """Write a result for other programs, in pieces; return the files to open.

    csv and parquet make up to ten tables in the folder `out` (nodes, segments, anchors, joints, pulleys,
    contacts, rope_contacts, wraps, slides, run), or the file `out` itself where one table is asked for and
    `out` ends in .csv or .parquet. npz makes the file `out`; vtk a folder with a .pvd for ParaView and one
    .vtp a frame.

    Args:
        result: of a run in memory, or of a run folder: `Result.open(folder)`.
        to: csv, parquet, npz or vtk.
        out: file or folder to make.
        quantities: of positions, velocities, tension, elastic_tension, rest_length, energy, work,
            reactions, moments, joint_forces, pulleys, momentum, angular_momentum. Those that a run does not
            record are left out.
        nodes: only these nodes of every rope (negative: from its end), and the segments next to them.
        times: only the frames nearest to these times [s].
        every: only every so many frames. Greatest and least are of all steps since the row before, those of
            chosen times, too, and of the first row since the start; what comes after the last row is in none.
        rope: only this rope, its anchors and what joints tie of it. Pulleys and the table of the run are of
            all ropes.
        layout: "long", a row per frame and node, or "wide", a row per frame.
        overwrite: replace files of an earlier export. In the run's own folder, tables that are older than
            the run go.

    Raises InputError for a request that cannot be met, RunError for the files.
    """
    if to not in FORMATS:
        raise InputError("to", to, f"no such format; {nearest(to, FORMATS)}")
    if layout not in LAYOUTS:
        raise InputError("layout", layout, f"no such layout; {nearest(layout, LAYOUTS)}")
    chosen = select(result, quantities, nodes, times, every, rope)
    out = Path(out)
    if to == "npz":
        if out.is_dir():
            raise RunError(out, f"is a folder; npz makes one file: name it, as {out / 'run.npz'}")
        out = out if out.suffix == ".npz" else out.with_name(out.name + ".npz")
        with new_file(out, overwrite) as partial:
            write_npz(result, chosen, partial)
        return (out,)
    if to == "vtk":
        return (write_vtk(result, chosen, out, overwrite),)
    found = _write_tables(tables(result, chosen, layout), to, out, overwrite)
    if result.folder is not None and out.parent == result.folder:
        _drop_former(result.folder, out, to)
    return found


def _drop_former(run: Path, out: Path, to: str) -> None:
    """Remove tables beside a run that are older than it: of one that it has replaced."""
    with writing(out):
        begun = (run / PROVENANCE).stat().st_mtime
        for name in NAMES:
            path = out / f"{name}.{to}"
            if path.is_file() and path.stat().st_mtime < begun:
                path.unlink()


def _write_tables(found: list[Table], to: str, out: Path, overwrite: bool) -> tuple[Path, ...]:
    if not found:
        raise InputError("quantities", (), "none of them was recorded in this run")
    write = write_csv if to == "csv" else _parquet_writer(out)
    if out.suffix == f".{to}":
        if len(found) > 1:
            names = ", ".join(table.name for table in found)
            raise InputError("out", str(out), f"holds one table, not {names}; name a folder")
        files = {out: found[0]}
    else:
        files = {out / f"{table.name}.{to}": table for table in found}
    for path in files:
        check_file(path, overwrite)
    for path, table in files.items():
        with new_file(path, overwrite) as partial:
            write(table, partial)
    return tuple(files)


def check_file(path: Path, overwrite: bool) -> None:
    """Raise RunError when `path` must not be written."""
    with writing(path):
        if path.is_dir():
            raise RunError(path, "is a folder, not a file")
        if path.exists() and not overwrite:
            raise RunError(path, "exists; choose another name, or allow to overwrite")


@contextmanager
def new_file(path: Path, overwrite: bool) -> Iterator[Path]:
    """Give a partial file to fill, which then gets its name, whole. Raises RunError."""
    check_file(path, overwrite)
    partial = path.with_name(f".{path.name}{PARTIAL}")
    try:
        with writing(path):
            path.parent.mkdir(parents=True, exist_ok=True)
            yield partial
            partial.replace(path)
    finally:
        with suppress(OSError):
            partial.unlink()


def write_csv(table: Table, path: Path) -> None:
    """Write a table as CSV, its headers first. Raises OSError."""
    with open(path, "w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(table.headers)
        for columns in table.pieces():
            writer.writerows(zip(*map(_plain, columns), strict=True))


def _plain(column: NDArray[Any]) -> list[Any]:
    """A column's values for text, in which nobody wants a minus before a zero."""
    found: list[Any] = (column + 0.0 if column.dtype.kind == "f" else column).tolist()
    return found


def _parquet_writer(out: Path) -> Any:
    try:
        import pyarrow
        import pyarrow.parquet
    except ImportError:
        rule = "Parquet needs two packages more: pip install pandas pyarrow"
        raise RunError(out, rule) from None

    def write(table: Table, path: Path) -> None:
        writer = None
        try:
            for columns in table.pieces():
                piece = pyarrow.table([pyarrow.array(c) for c in columns], names=table.headers)
                if writer is None:
                    writer = pyarrow.parquet.ParquetWriter(path, piece.schema)
                writer.write_table(piece)
        finally:
            if writer is not None:
                writer.close()

    return write


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
    lengths |= {dim: len(places) for dim, places in chosen.places.items()}
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
            array = _picked(chosen.take(result, name, piece), name, chosen)
            file.write(np.ascontiguousarray(array, dtype="<f8").tobytes())


def _picked(array: NDArray[np.float64], name: str, chosen: Selection) -> NDArray[np.float64]:
    second = BY_NAME[name].dims[1] if name in BY_NAME else ""
    return array[:, chosen.places[second]] if second in chosen.places else array


def _about(result: Result, chosen: Selection) -> dict[str, NDArray[Any]]:
    ropes = np.array([span.name for span in result.layout.ropes])
    number = rope_numbers(result.layout)
    of_nodes = [result.layout.rope_of(int(i))[1] for i in chosen.nodes]
    named = {
        key: np.array(labels(result.layout)[key], dtype=str)
        for key in ("form", "law", "anchor", "extreme", "bound")
    }
    named["anchor"] = named["anchor"][chosen.anchors]
    return {
        "node_rope": ropes[number[chosen.nodes]],
        "node_number": np.array(of_nodes),
        "segment_rope": ropes[number[chosen.segments]],
        "segment_number": np.array([result.layout.rope_of(int(j))[1] for j in chosen.segments]),
        **named,
    }
