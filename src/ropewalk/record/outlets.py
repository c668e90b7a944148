"""The ways out of a result: figures, films, pages, tables, files."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import cached_property
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, cast

from ropewalk.display import cells
from ropewalk.record.drawing import Plots
from ropewalk.record.selection import DEFAULT

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr

    from ropewalk.live.cell import Replay
    from ropewalk.live.view import View
    from ropewalk.record.result import Result
    from ropewalk.record.run_dataset import RunDataset

# Layers above this one, so they are looked up when they are needed.
_CELL, _PLOTS, _SHARE, _VIEW = (
    f"ropewalk.{name}" for name in ("live.cell", "plots", "live.share", "live.view")
)

TableName = Literal[
    "nodes",
    "segments",
    "anchors",
    "joints",
    "pulleys",
    "contacts",
    "rope_contacts",
    "wraps",
    "slides",
    "run",
]


class Outlets:
    """What a Result can be made into; part of every Result."""

    @property
    def _result(self) -> Result:
        return cast("Result", self)

    # -- tables and files ----------------------------------------------------------------

    @cached_property
    def dataset(self) -> RunDataset:
        """The result as an xarray Dataset with named dimensions, coordinates and units.

        Its variables have different dimensions, and one table of all of them would have a row for every
        combination of node, segment, anchor and law: `to_dataframe` refuses that. For tables take
        `datasets`, or `to_pandas`.
        """
        from ropewalk.record.dataset import make_dataset

        return make_dataset(self._result)

    @cached_property
    def datasets(self) -> Mapping[str, xr.Dataset]:
        """The result as xarray Datasets by name, each with its own dimensions only.

        `nodes` (time, node, axis), `segments` (time, segment), `anchors` (time, anchor, axis), where there
        are anchors, `joints` (time, tie, axis), where there are joints, `pulleys` (time, pulley, motion),
        where obstacles turn freely, and `run` (time,) with a variable for each energy, work and component.
        Where ropes touch something `contacts`, `rope_contacts` and `wraps`, and where something slides
        `slides`, the tables of `to_pandas` with a dimension `row`. Units are in `attrs["units"]` of every
        variable. Each can be made into a table by `to_dataframe`.
        """
        from ropewalk.record.dataset import split_dataset

        return split_dataset(self._result)

    def to_pandas(
        self,
        table: TableName,
        *,
        nodes: Sequence[int] | None = None,
        times: Sequence[float] | None = None,
        every: int | None = None,
        rope: str | None = None,
    ) -> pd.DataFrame:
        """Return one table as a pandas DataFrame, units in the names of its columns.

        Args:
            table: "nodes" (a row per frame and node: x, y, z [m], vx, vy, vz [m/s]), "segments" (a row
                per frame and segment: tension [N] ..), "anchors" (forces [N], moments [N m]), "joints"
                (their forces on the ropes [N]), "pulleys" (angle [rad], speed [rad/s], energy and works [J],
                torque [N m] of obstacles that turn freely), "contacts" (a row for every node on an obstacle
                at each frame: forces [N], slip speed [m/s], whether it sticks or slips), "rope_contacts" (the
                same for every two segments of ropes that press on each other), "wraps" (a row for every
                stretch of a rope on an obstacle at each frame: angle [rad], tensions before and after [N],
                their ratio), "slides" (a row for every slide at each frame: place [m], speed [m/s], load [N])
                or "run" (a row per frame: energies and works [J], momenta).
            nodes: only these nodes of every rope (negative: from its end), and the segments next to them.
            times: only the frames nearest to these times [s].
            every: only every so many frames. Greatest and least are of all steps since the row before, those
                of chosen times, too, and of the first row since the start.
            rope: only this rope, its anchors and what joints tie of it. Pulleys and the table of the run are
                of all ropes.

        Raises InputError (a ValueError) for a table, nodes, times or a rope that are not there, RunError
        where there is no pandas.
        """
        from ropewalk.record.tables import to_pandas

        return to_pandas(self._result, table, nodes, times, every, rope)

    def export(
        self,
        to: Literal["csv", "parquet", "npz", "vtk"],
        out: str | Path,
        *,
        quantities: Iterable[str] = DEFAULT,
        nodes: Sequence[int] | None = None,
        times: Sequence[float] | None = None,
        every: int | None = None,
        rope: str | None = None,
        layout: Literal["long", "wide"] = "long",
        overwrite: bool = False,
    ) -> tuple[Path, ...]:
        """Write the result for other programs, in pieces; return the files to open.

        csv and parquet make up to ten tables in the folder `out` (nodes, segments, anchors, joints,
        pulleys, contacts, rope_contacts, wraps, slides, run), or the file `out` itself where one table is
        asked for and `out` ends in .csv or .parquet. npz makes the file `out`; vtk a folder with a .pvd for
        ParaView and one .vtp a frame.

        Args:
            to: csv, parquet, npz or vtk.
            out: file or folder to make.
            quantities: names of recorded quantities, as "positions" or "tension"; those that this run
                does not record are left out.
            nodes: only these nodes of every rope (negative: from its end), and the segments next to them.
            times: only the frames nearest to these times [s].
            every: only every so many frames. Greatest and least are of all steps since the row before, those
                of chosen times, too, and of the first row since the start.
            rope: only this rope, its anchors and what joints tie of it. Pulleys and the table of the run are
                of all ropes.
            layout: "long", a row per frame and node, or "wide", a row per frame.
            overwrite: replace files of an earlier export. In the run's own folder, tables that are older than
                the run go.

        Raises InputError (a ValueError) for a request that cannot be met, RunError for the files.
        """
        from ropewalk.record.export import export

        return export(
            self._result, to, out, quantities=quantities, nodes=nodes, times=times, every=every,
            rope=rope, layout=layout, overwrite=overwrite,
        )  # fmt: skip

    # -- to look at ----------------------------------------------------------------------

    @property
    def plot(self) -> Plots:
        """Figures: `result.plot.shape()`, `.film()`, `.height()`, `.tension()`, `.energy()`, ..."""
        return Plots(self._result)

    def movie(
        self,
        path: str | Path,
        *,
        fps: float = 25.0,
        size: tuple[int, int] = (960, 540),
        speed: float = 1.0,
        plane: str | None = None,
        window: tuple[float, float, float, float] | None = None,
        progress: Callable[[int, int], None] | None = None,
    ) -> Path:
        """Write a film of the run as GIF (any machine) or MP4 (with ffmpeg); return its path.

        Args:
            path: ends in .gif or .mp4.
            fps: pictures per second [1/s]; GIF has at most 50.
            size: width and height in pixels.
            speed: simulated seconds per second of the film [1]; 1 is real time.
            plane: the two axes to look at, as "xz"; by default those that show most.
            window: what to see of them [m]: left, right, lower and upper end, widened to fill the picture;
                by default all that ropes come to.
            progress: called with the pictures done and those in all.

        Raises ValueError for arguments that make no film, MovieError when ffmpeg is missing or fails,
        OSError when the file cannot be written.
        """
        options: dict[str, Any] = {"fps": fps, "size": size, "speed": speed, "plane": plane}
        options |= {"window": window, "progress": progress}
        return Path(import_module(_PLOTS).movie(self._result, path, **options))

    def view(
        self, *, open_browser: bool = True, playing: bool = True, port: int | None = None
    ) -> View:
        """Replay the run in the browser, or here in a notebook, and return the view.

        It is served by this program, and ends with it; `replay` needs no server.

        Args:
            open_browser: open a browser at once (never in a notebook).
            playing: begin to play, or stand at the first frame.
            port: of the server; by default one that is free.

        Raises RunError when the packages of `ropewalk[view]` are missing, or the port is taken.
        """
        return cast(
            "View",
            import_module(_VIEW).view_result(
                self._result, open_browser=open_browser, playing=playing, port=port
            ),
        )

    def replay(self, *, frame_rate: float = 60.0, height: int = 640) -> Replay:
        """Replay the run in this cell of a notebook, without a server: the page that `share` writes.

        The whole page is kept in the notebook (0.8 MB, and the run), so it still plays when the
        notebook is opened again or exported to HTML.

        Args:
            frame_rate: the most frames that are kept [1/s].
            height: of the frame in pixels.

        Raises RunError for a run of which nothing can be shown, ValueError for a height below 100.
        """
        return cast("Replay", import_module(_CELL).replay(self._result, frame_rate, height))

    def share(self, path: str | Path, *, frame_rate: float = 60.0, overwrite: bool = False) -> Path:
        """Write one HTML file that replays the run without server or network; return its path.

        `frame_rate` [1/s] is the most that is kept.

        Raises RunError when the file exists already, unless `overwrite`, or cannot be written.
        """
        made = import_module(_SHARE).share_result
        return Path(made(self._result, path, frame_rate=frame_rate, overwrite=overwrite))

    def _repr_png_(self) -> bytes | None:
        return cells.png(self.plot.shape)

    def _repr_html_(self) -> str:
        result = self._result
        # A number that is none (NaN) has no row.
        rows = [(key, value) for key, value in result.table.items() if value == value]
        shown = cells.picture(self._repr_png_(), "the rope")
        return cells.paragraph(repr(result)) + shown + cells.table(rows)
