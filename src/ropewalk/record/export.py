"""Results for other programs: CSV, Parquet, NumPy archives, VTK."""

from __future__ import annotations

import csv
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

from numpy.typing import NDArray

from ropewalk.record.errors import InputError, RunError
from ropewalk.record.files import PARTIAL, writing
from ropewalk.record.npz import write_npz
from ropewalk.record.result import Result
from ropewalk.record.selection import DEFAULT, select
from ropewalk.record.tables import Table, tables
from ropewalk.record.vtk import write_vtk
from ropewalk.words.nearest import nearest

FORMATS = ("csv", "parquet", "npz", "vtk")
LAYOUTS = ("long", "wide")


def export(
    run: Result | str | Path,
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
    """Write a run for other programs, in pieces; return the files to open.

    csv and parquet make up to four tables in the folder `out` (nodes, segments, anchors, run), or the
    file `out` itself where one table is asked for and `out` ends in .csv or .parquet. npz makes the
    file `out`; vtk a folder with a .pvd for ParaView and one .vtp a frame.

    Args:
        run: result, or run folder.
        to: csv, parquet, npz or vtk.
        out: file or folder to make.
        quantities: of positions, velocities, tension, elastic_tension, rest_length, energy, work,
            reactions, moments, momentum, angular_momentum. Those that a run does not record are left out.
        nodes: only these nodes of every rope (negative: from its end), and the segments next to them.
        times: only the frames nearest to these times [s].
        every: only every so many frames.
        rope: only this rope.
        layout: "long", a row per frame and node, or "wide", a row per frame.
        overwrite: replace files of an earlier export.

    Raises InputError for a request that cannot be met, RunError for the run or the files.
    """
    if to not in FORMATS:
        raise InputError("to", to, f"no such format; {nearest(to, FORMATS)}")
    if layout not in LAYOUTS:
        raise InputError("layout", layout, f"no such layout; {nearest(layout, LAYOUTS)}")
    result = run if isinstance(run, Result) else Result.open(run)
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
    return _write_tables(tables(result, chosen, layout), to, out, overwrite)


def _write_tables(found: list[Table], to: str, out: Path, overwrite: bool) -> tuple[Path, ...]:
    if not found:
        raise InputError("quantities", (), "none of them was recorded in this run")
    write = _write_csv if to == "csv" else _parquet_writer(out)
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


def _write_csv(table: Table, path: Path) -> None:
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
