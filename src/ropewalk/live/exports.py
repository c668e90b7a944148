"""What a page can download: the scene as it stands, tables of the recorded session, a page to share."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from ropewalk.live.share import share_run
from ropewalk.record.errors import InputError, RunError
from ropewalk.record.export import export
from ropewalk.scene import Scene, dumps

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

        result = Result.open(folder)
        every = max(1, result.frames * result.nodes // MOST_ROWS)
        export(result, "csv", out, quantities=(_TABLES[name],), every=every)
        return out, _CSV
