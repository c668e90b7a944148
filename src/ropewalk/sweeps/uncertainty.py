"""Uncertainty: bands of what is not known exactly, and which of the unknowns they come from."""

from __future__ import annotations

import math
import warnings
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ropewalk.api import SceneLike, as_scene, told_of
from ropewalk.record.errors import InputError
from ropewalk.record.note_kinds import kinds_in, noted
from ropewalk.scene import Scene, SceneError, loads
from ropewalk.scene.faults import NO_VALUE, Fault
from ropewalk.sweeps.answer import stored
from ropewalk.sweeps.batch import GOOD
from ropewalk.sweeps.derived import BY_LABEL
from ropewalk.sweeps.designs import DESIGNS, MOST_RUNS, SALTELLI, Design, plain_rows
from ropewalk.sweeps.keep import over
from ropewalk.sweeps.many import make_runs, sweep
from ropewalk.sweeps.parameters import Parameter, make_parameters
from ropewalk.sweeps.per_cents import with_ranges
from ropewalk.sweeps.sweep_folder import SweepFolder
from ropewalk.sweeps.sweep_plan import SweepPlan
from ropewalk.sweeps.whole import refuse_unless_whole
from ropewalk.words.percents import percent

if TYPE_CHECKING:
    import xarray as xr

QUANTILES = (0.05, 0.5, 0.95)
FEW = 21  # runs: of fewer, 5 % and 95 % lie between the two least and the two largest
_SAME = 1e-9  # [1] of the largest result of its kind: what differs by less, by what solvers leave
_STRAIN = (
    1e-5  # [1] whose tension is the least size of forces: by _SAME of it lengths are rounded off
)
_PLOTS = "ropewalk.plots.uncertainty_bands"  # a layer above this one, so it is looked up when it is needed


@dataclass(frozen=True)
class Uncertainty:
    """What a scene gives when some of its values are not known exactly.

    Attributes:
        runs: the sweep's dataset, one row per run.
        bands: quantiles 5, 50, 95 % of everything kept, along `quantile`, over `sample`.
        sobol: Sobol indices [1] by kept scalar, `order` (first, total) and `parameter`, with the half
            width of their 95 % intervals; None without SALib or where too many runs broke.
        note: what a reader must know: broken runs, what is missing.
    """

    runs: xr.Dataset
    bands: xr.Dataset
    sobol: xr.Dataset | None
    note: str

    @property
    def broken(self) -> int:
        """Number of runs that did not end well; they are not in the bands."""
        return int(sum(status not in GOOD for status in self.runs.status.values.tolist()))

    @property
    def sample(self) -> int:
        """Number of runs that the bands are of: those of the plain sample that ended well."""
        return len(_plain(self.runs).run)

    @property
    def notes(self) -> dict[str, int]:
        """What the tables of the runs in the bands warn of: how many of them, by kind."""
        return count_notes(_plain(self.runs))

    @property
    def few(self) -> bool:
        """Whether the bands are of too few runs to be as wide as they should."""
        return self.sample < FEW

    def plot(self) -> Any:
        """Draw the bands of tension, sag and anchor forces, and the Sobol indices; a Figure."""
        return import_module(_PLOTS).uncertainty(self)

    def table(self) -> list[tuple[str, str, float, float, float]]:
        """Return name, unit and the three quantiles of every scalar."""
        found = []
        for name, part in scalars(self.bands):
            low, middle, high = (float(v) for v in part.values)
            found.append((name, str(part.attrs.get("units", "")), low, middle, high))
        return found

    def __repr__(self) -> str:
        lines = [f"{len(self.runs.run)} runs; 5 %, 50 %, 95 % of {self.sample} of them:"]
        for name, unit, low, middle, high in self.table():
            seen = over(str(self.bands[name.partition("[")[0]].attrs.get("long_name", "")))
            lines.append(
                f"  {name}: {low:.5g}, {middle:.5g}, {high:.5g} {unit}, over {seen}".removesuffix(
                    ", over "
                )
            )
        if self.sobol is not None:
            for key in self.sobol.data_vars:
                if not str(key).endswith("_ci"):
                    told = ", ".join(shares_in_words(self.sobol, str(key)))
                    lines.append(f"  {key} follows (total index, 95 % interval): {told}")
        return "\n".join([*lines, self.note] if self.note else lines)


def uncertain(
    scene: SceneLike,
    spreads: Any,
    *,
    samples: int = 256,
    seed: int | None = None,
    keep: Sequence[str] | None = None,
    what: str = "run",
    **options: Any,
) -> Uncertainty:
    """Say what is not known of a scene, and get bands for tension, sag and anchor forces.

    Args:
        scene: scene, preset's name, or scene file.
        spreads: mapping from paths to frozen scipy.stats distributions, ranges (low, high) or "29..31 m",
            or per cents such as "10 %": that far below and above the scene's value, evenly.
        samples: base samples, best a power of two. With SALib (`ropewalk[uncertain]`) there are
            `samples` times (parameters + 2) runs, from which come bands and Sobol indices; without it
            `samples` runs, and bands only.
        seed: of the samples.
        keep: what to keep besides the largest tension, sag and reactions, and their course in time.
        what: "run", or "rest" for the equilibrium.
        options: of `sweep`: store, on, workers, progress.

    Raises SceneError for values that nothing makes uncertain and where no run ends well, InputError for
    samples or a seed that are no whole numbers, for fewer than 2 samples or more than there can be, else as
    `sweep`.
    """
    loaded = as_scene(scene)
    with told_of(scene):
        spreads, parameters = spread_parameters(loaded, spreads)
    refuse_unless_whole("samples", samples, 2)
    if samples > (most := MOST_RUNS // (len(parameters) + 2)):
        raise InputError("samples", samples, f"must be at most {most}")
    if seed is not None:
        refuse_unless_whole("seed", seed, 0)
    else:
        seed = int(np.random.SeedSequence().generate_state(1)[0] >> 1)
    kept = [*_default_keep(loaded, what), *(keep or ())]
    with told_of(scene):
        if find_spec("SALib") is None:
            asked: dict[str, Any] = {"samples": samples, "seed": seed, "keep": kept, "what": what}
            runs = sweep(loaded, spreads, **asked, **options)
        else:
            design = Design(SALTELLI, parameters, samples * (len(parameters) + 2), seed)
            runs = make_runs(loaded, design, kept, what=what, **options)
    return _of_runs(loaded, runs, [parameter.name for parameter in parameters])


def is_uncertain(plan: SweepPlan) -> bool:
    """Tell whether a sweep is one of `uncertain`: by its design, or by what it keeps, without SALib."""
    if plan.design == SALTELLI:
        return True
    keep = _default_keep(loads(plan.recipe.scene), plan.recipe.what)
    drawn = plan.design in DESIGNS and all(about["spread"] for about in plan.parameters)
    return drawn and list(plan.recipe.keep[: len(keep)]) == keep


def of_folder(folder: Path) -> Uncertainty:
    """Return what the runs in a folder of `uncertain` tell. Raises RunError, SceneError where all broke."""
    found = SweepFolder.open(folder)
    names = [str(parameter["name"]) for parameter in found.plan.parameters]
    return _of_runs(loads(found.plan.recipe.scene), stored(found).load(), names)


def _of_runs(scene: Scene, runs: xr.Dataset, names: Sequence[str]) -> Uncertainty:
    if not len(_plain(runs).run):
        rule = "none of the samples ended well, so that there are no bands; take values that do not break"
        raise SceneError([Fault(", ".join(names), NO_VALUE, rule)])
    if runs.attrs["design"] != SALTELLI or find_spec("SALib") is None:
        note = "No Sobol indices: pip install 'ropewalk[uncertain]' brings them."
        return Uncertainty(runs, bands(runs), None, _note(runs, note))
    found, more = _indices(runs, names, int(runs.attrs["seed"]), _sizes(scene))
    return Uncertainty(runs, bands(runs), found, _note(runs, more))


def spread_parameters(scene: Scene, spreads: Any) -> tuple[Any, tuple[Parameter, ...]]:
    """Return the spreads with per cents as ranges, and their parameters. Raises SceneError as `uncertain`."""
    ranges = with_ranges(scene, spreads)
    parameters = make_parameters(scene, ranges)
    fixed = [p.path for p in parameters if p.spread is None]
    if fixed:
        rule = (
            "must be a range such as 9.5..10.5, in Python (9.5, 10.5), a distribution such as norm(10, 0.5), "
            "or per cents such as 10 %"
        )
        raise SceneError([Fault(path, NO_VALUE, rule) for path in fixed])
    return ranges, parameters


def _default_keep(scene: Scene, what: str) -> list[str]:
    names = ["tension", "sag"] + (["reactions"] if scene.anchors else [])
    kept = [f"{name}.max" for name in names]
    return kept if what == "rest" else [*kept, *(f"{name}.max[time]" for name in names)]


def _problem(names: Sequence[str]) -> dict[str, Any]:
    return {"num_vars": len(names), "names": list(names), "bounds": [[0.0, 1.0]] * len(names)}


def _planned(runs: xr.Dataset) -> xr.Dataset:
    """Return the runs of the plain sample."""
    width = sum("path" in runs[name].attrs for name in runs.coords)
    return runs.isel(run=plain_rows(runs.attrs["design"], width))


def _plain(runs: xr.Dataset) -> xr.Dataset:
    """Return the runs of the plain sample that ended well."""
    plain = _planned(runs)
    return plain.isel(run=np.flatnonzero(np.isin(plain.status.values.tolist(), GOOD)))


def bands(runs: xr.Dataset) -> xr.Dataset:
    """Return the quantiles 5, 50, 95 % of everything kept, over the plain sample's runs that ended well."""
    kept = [name for name in runs.data_vars if "keep" in runs[name].attrs]
    names = [name for name in kept if "frame" not in runs[name].dims]  # not at the same times
    made = _plain(runs)[names].quantile(QUANTILES, dim="run", keep_attrs=True)
    made["quantile"].attrs["long_name"] = "share of the runs below"
    return made


def scalars(data: xr.Dataset) -> list[tuple[str, xr.DataArray]]:
    """Return what is one number per run, anchor by anchor and rope by rope, with labels."""
    found = []
    for name in data.data_vars:
        array = data[name]
        own = [dim for dim in array.dims if dim not in ("run", "quantile")]
        if not own:
            found.append((str(name), array))
        elif len(own) == 1 and own[0] in BY_LABEL:
            (dim,) = own
            labels = array[dim].values.tolist()
            found += [(f"{name}[{label}]", array.sel({dim: label})) for label in labels]
    return found


def _sizes(scene: Scene) -> dict[str, float]:
    """Return the sizes of the scene by unit, against which a result may be zero but for rounding."""
    pulls = [rope.segment_stiffness * rope.segment_length for rope in scene.ropes if not rope.rigid]
    lengths = [rope.length_unstretched for rope in scene.ropes]
    return {"m": max(lengths), "N": _STRAIN * max(pulls, default=0.0)}


def _indices(
    runs: xr.Dataset,
    names: Sequence[str],
    seed: int,
    sizes: Mapping[str, float],
) -> tuple[xr.Dataset | None, str]:
    """Return the Sobol indices of all scalars, and what is to be said of them.

    A group of runs in which one broke cannot be used: all its runs are left out. A scalar that differs by
    less than `_SAME` of the largest of its unit, or of the scene's `sizes`, has no index.
    """
    import xarray as xr
    from SALib.analyze import sobol

    width = len(names) + 2
    kept = runs[[n for n in runs.data_vars if "keep" in runs[n].attrs]]
    if len(runs.run) < 8 * width:
        return None, "No Sobol indices: they need at least 8 samples."
    made: dict[str, Any] = {}
    note, largest = "", dict(sizes)
    for _, array in scalars(kept):
        unit = str(array.attrs.get("units", ""))
        size = float(np.nanmax(np.abs(array.values), initial=0.0))
        largest[unit] = max(largest.get(unit, 0.0), size)
    for name, array in scalars(kept):
        groups = array.values.reshape(-1, width)
        whole = np.isfinite(groups).all(axis=1)
        if whole.sum() < 8:
            return None, "No Sobol indices: too many runs broke."
        if not whole.all():
            note = f"Sobol indices without {int((~whole).sum())} groups of runs in which one broke."
        values = groups[whole].ravel()
        if np.ptp(values) <= _SAME * largest[str(array.attrs.get("units", ""))]:
            continue  # nothing to share out
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            got = sobol.analyze(
                _problem(names),
                values,
                calc_second_order=False,
                seed=seed,
                print_to_console=False,
            )
        dims, none = ("order", "parameter"), {"units": "1"}
        made[name] = (dims, np.stack([got["S1"], got["ST"]]), none)
        made[f"{name}_ci"] = (dims, np.stack([got["S1_conf"], got["ST_conf"]]), none)
    return xr.Dataset(made, {"order": ["first", "total"], "parameter": list(names)}), note


def _note(runs: xr.Dataset, more: str) -> str:
    broken = int(sum(status not in GOOD for status in runs.status.values.tolist()))
    told = []
    if broken:
        share = 100.0 * broken / len(runs.run)
        told.append(
            f"{broken} of {len(runs.run)} runs broke ({percent(share)}) and are not in the bands: they hold "
            "for the values that do not break."
        )
    if any("frame" in runs[name].dims for name in runs.data_vars):
        told.append("No bands in time: the frames of these runs are at different times.")
    plain = _plain(runs)
    sample = len(plain.run)
    told += [f"{text}." for _, text in noted(count_notes(plain), sample)]
    if sample < FEW:
        planned = len(_planned(runs).run)
        why = "take 64 samples or more"
        if planned >= FEW:
            why = f"{planned - sample} of the {planned} samples broke"
        told.append(
            f"Bands of {sample} runs are too narrow: their 5 % and 95 % are hardly more than the least and "
            f"the largest that was met; {why}."
        )
    return " ".join([*told, more] if more else told)


def count_notes(runs: xr.Dataset) -> dict[str, int]:
    """Return how many of these runs have which kind of note; {} of a sweep made before there were any."""
    texts = runs.notes.values.tolist() if "notes" in runs else []
    return dict(Counter(kind for text in texts for kind in kinds_in(text)))


def shares_in_words(sobol: xr.Dataset, name: str) -> list[str]:
    """Return the total indices of a scalar, largest first, each with its 95 % interval."""
    total: NDArray[Any] = sobol[name].sel(order="total").values
    half: NDArray[Any] = sobol[f"{name}_ci"].sel(order="total").values
    names = sobol.parameter.values
    return [f"{names[i]} {total[i]:.2f} ± {half[i]:.2f}" for i in np.argsort(-total)]


def text_rows(found: Uncertainty) -> list[tuple[str, ...]]:
    """Return the table of bands and total indices as text, for the command line."""
    rows = []
    for name, unit, low, middle, high in found.table():
        seen = over(str(found.bands[name.partition("[")[0]].attrs.get("long_name", "")))
        parts = [
            name,
            seen,
            *(f"{v:.5g}" if math.isfinite(v) else "" for v in (low, middle, high)),
            unit,
        ]
        told = ""
        if found.sobol is not None and name in found.sobol:
            told = ", ".join(shares_in_words(found.sobol, name))
        rows.append((*parts, told))
    return rows
