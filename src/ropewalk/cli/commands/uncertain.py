"""`ropewalk run --uncertain`: bands of what is not known exactly."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ropewalk.cli.commands.sweep import SWEEPS, ended, telling
from ropewalk.cli.console import print_json, print_table, say, tell
from ropewalk.cli.output_files import claimed
from ropewalk.cli.progress import tell_compiling

if TYPE_CHECKING:
    from ropewalk.scene import Scene


def run_uncertain(
    scene: Scene,
    spreads: Sequence[str],
    drawn: tuple[int, int | None],
    where: tuple[Path | None, str, bool],
    *,
    as_json: bool,
) -> int:
    """Make the runs into a sweep's folder, print the bands and draw the figure there.

    `drawn` are the number of samples and their seed.
    """
    from ropewalk.sweeps.spread_text import parse_uncertain
    from ropewalk.sweeps.uncertainty import uncertain

    output, name, overwrite = where
    vary = dict(parse_uncertain(text) for text in spreads)
    tell_compiling(scene.run.method, scene)
    with claimed(output, SWEEPS, f"{name}-uncertain") as folder, telling():
        samples, seed = drawn
        ask: dict[str, Any] = {
            "samples": samples,
            "seed": seed,
            "store": folder,
            "overwrite": overwrite,
        }
        return ended(folder, lambda: uncertain(scene, vary, **ask), as_json, tell_uncertain)


def tell_uncertain(folder: Path, *, as_json: bool) -> None:
    """Print the bands of the runs in a folder, and draw the figure there."""
    from ropewalk import plots
    from ropewalk.sweeps.uncertainty import of_folder, text_rows

    found = of_folder(folder)
    figures = folder / "figures"
    figures.mkdir(exist_ok=True)
    path = plots.save(found.plot(), figures / "uncertain.png")
    if as_json:
        print_json(_facts(found, folder))
        return
    columns = (
        "result",
        "5 %",
        "50 %",
        "95 %",
        "unit",
        "follows (total Sobol index, 95 % interval)",
    )
    print_table(columns, text_rows(found), right=(1, 2, 3))
    if found.note:
        tell(found.note)
    say(f"seed of the samples: {found.runs.attrs['seed']}")
    say(str(path))
    say(f"sweep folder: {folder}")


def _facts(found: Any, folder: Path) -> dict[str, Any]:
    bands = {
        name: {"unit": unit, "5 %": low, "50 %": middle, "95 %": high}
        for name, unit, low, middle, high in found.table()
    }
    sobol, half = {}, {}
    if found.sobol is not None:
        names = found.sobol.parameter.values.tolist()
        for key in found.sobol.data_vars:
            if not str(key).endswith("_ci"):
                total = found.sobol[key].sel(order="total").values
                sobol[str(key)] = dict(zip(names, total.tolist(), strict=True))
                width = found.sobol[f"{key}_ci"].sel(order="total").values
                half[str(key)] = dict(zip(names, width.tolist(), strict=True))
    return {
        "folder": str(folder),
        "runs": len(found.runs.run),
        "broken": found.broken,
        "seed": found.runs.attrs["seed"],
        "bands": bands,
        "total Sobol indices": sobol,
        "half width of their 95 % intervals": half,
        "note": found.note or None,
    }
