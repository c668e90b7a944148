"""`rw.sweep`: a call, and what belongs to it."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

from ropewalk.sweeps import engines
from ropewalk.sweeps.answer import open_sweep
from ropewalk.sweeps.calibration import Calibrate
from ropewalk.sweeps.function import SweepFunction
from ropewalk.sweeps.many import resume_sweep
from ropewalk.sweeps.many import sweep as make_sweep

if TYPE_CHECKING:
    import xarray as xr

    from ropewalk.record.result import Result


class Sweep:
    """`rw.sweep(scene, vary, ...)` makes a sweep; `open`, `resume`, `replay` and `function` go with it."""

    __call__ = staticmethod(make_sweep)

    #: `rw.sweep.function(scene, names, keep)` maps (N, D) to (N, K).
    function = SweepFunction

    @property
    def dashboard(self) -> str | None:
        """Address of the Dask dashboard of the cluster that a sweep uses, or used last; None without one."""
        return engines.dashboard

    def open(self, folder: str | Path) -> xr.Dataset:
        """Open a sweep's folder, finished or not; see `sweeps.open_sweep`."""
        return open_sweep(folder)

    def resume(self, folder: str | Path, **options: Any) -> xr.Dataset:
        """Go on with a sweep that was stopped or killed; see `sweeps.resume_sweep`."""
        return resume_sweep(folder, **options)

    def replay(self, folder: str | Path, run: int) -> Result:
        """Make one run of a sweep again and return its result, to the bits that the sweep had.

        Raises RunError for a folder without a sweep or a run that is not there, SceneError for a run that
        the sweep has as refused.
        """
        from ropewalk.sweeps.rerun import replay

        return replay(Path(folder), run)

    def __repr__(self) -> str:
        return "<ropewalk.sweep: many runs of one scene; see help(ropewalk.sweep.__call__)>"


sweep = Sweep()
calibrate = Calibrate()
