"""What a page can download: the scene as it stands, tables of the recorded session, a page to share."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ropewalk.live.keeper import parts
from ropewalk.live.recorded import Recorded, followed
from ropewalk.live.share import share_run
from ropewalk.record.errors import InputError, RunError
from ropewalk.record.export import new_file, write_csv
from ropewalk.record.selection import select
from ropewalk.record.tables import Table, tables
from ropewalk.scene import Scene, dumps

if TYPE_CHECKING:
    from ropewalk.record.result import Result

_TABLES = {"nodes.csv": "positions", "energies.csv": "energy", "tension.csv": "tension"}
_CSV, _TOML, _HTML = "text/csv; charset=utf-8", "application/toml", "text/html; charset=utf-8"
MOST_ROWS = 2_000_000  # of one table; longer sessions are thinned


class NothingToExport(Exception):  # noqa: N818
    """There is nothing of that kind."""


class Exports:
    """Makes the files. `scene` and `folder` are asked for when they are needed."""

    def __init__(
        self,
        scene: Callable[[], Scene] | None,
        folder: Callable[[], Path] | None,
        name: str = "rope",
    ) -> None:
        self._scene, self._folder, self._name = scene, folder, name

    def names(self) -> list[str]:
        """Return the names of what can be made."""
        found = ["scene.toml"] if self._scene is not None else []
        if self._folder is not None:
            found += [*_TABLES, "page.html"]
        return found

    def file_name(self, name: str) -> str:
        """Return the name that a download gets."""
        safe = "".join(one if one.isalnum() or one in "-_" else "-" for one in self._name)
        return f"{safe[:60] or 'rope'}-{name}"

    def make(self, name: str, into: Path) -> tuple[Path, str]:
        """Write a file into a folder; return its path and type. Raises NothingToExport."""
        if name not in self.names():
            raise NothingToExport("there is nothing of that name here")
        if name == "scene.toml":
            assert self._scene is not None
            out = into / name
            out.write_text(dumps(self._scene()), encoding="utf-8", newline="\n")
            return out, _TOML
        assert self._folder is not None
        try:
            return self._from_run(name, self._folder(), into / name)
        except (RunError, InputError) as error:
            raise NothingToExport(str(error)) from None

    def _from_run(self, name: str, folder: Path, out: Path) -> tuple[Path, str]:
        if name == "page.html":
            share_run(folder, out)
            return out, _HTML
        from ropewalk.record.result import Result

        results = [Result.open(part) for part in parts(folder)]
        every = max(1, sum(one.frames * one.nodes for one in results) // MOST_ROWS)
        with new_file(out, overwrite=False) as partial:
            write_csv(_joined(results, _TABLES[name], every), partial)
        return out, _CSV


def _joined(results: Sequence[Result], quantity: str, every: int) -> Table:
    """Return the table of a quantity through all parts of a session.

    Of more than one part it ends with the part's number, and has nothing where a part lacks a column.
    Energies and their error count on from the part before, as the page's graph has them.
    """
    found = [
        (number, table)
        for number, result in enumerate(results, start=1)
        for table in tables(result, select(result, [quantity], None, None, every, None), "long")
    ]
    if not found:
        raise InputError("quantities", quantity, "was not recorded in this run")
    first = found[0][1]
    if len(results) == 1 and quantity != "energy":
        return first
    counted = followed(results) if quantity == "energy" else []
    number_of = ["part"] if len(results) > 1 else []
    headers = list(dict.fromkeys(name for _, table in found for name in table.headers))

    def pieces() -> Iterator[list[NDArray[Any]]]:
        for number, table in found:
            for columns in table.pieces():
                known, rows = dict(zip(table.headers, columns, strict=True)), len(columns[0])
                for part in counted[number - 1 : number]:
                    for name, energy in _carried(part, known["time [s]"]).items():
                        known[name] = known[name] + energy
                nothing = np.full(rows, "", dtype=object)
                own = (known.get(name, nothing) for name in headers)
                yield [*own, *(np.full(rows, number) for _ in number_of)]

    return Table(first.name, [*headers, *number_of], pieces)


def _carried(part: Recorded, time: Any) -> dict[str, Any]:
    """Return what is to be added to a part's own columns of energy at some times [s] [J]."""
    gravity, error = part.carried_gravity, part.carried_error - part.given(time)
    return {
        "gravity energy [J]": gravity,
        "total energy [J]": gravity,
        "energy error [J]": error,
    }
