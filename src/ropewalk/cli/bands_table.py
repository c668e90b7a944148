"""The bands of uncertain runs, as a table, a figure and JSON."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from ropewalk.cli.console import print_json, print_table, say, tell

FIGURE = "uncertain.png"


def tell_bands(folder: Path, *, as_json: bool, quiet: bool = False) -> None:
    """Print the bands of the runs in a folder, or the folder alone, and draw the figure there."""
    from ropewalk import plots
    from ropewalk.sweeps.uncertainty import of_folder, text_rows

    found = of_folder(folder)
    figures = folder / "figures"
    figures.mkdir(exist_ok=True)
    path = plots.save(found.plot(), figures / FIGURE)
    if as_json:
        print_json(_facts(found, folder))
        return
    if quiet:
        say(str(folder))
        return
    columns = (
        "result",
        "over",
        "5 %",
        "50 %",
        "95 %",
        "unit",
        "follows (total Sobol index, 95 % interval)",
    )
    print_table(columns, text_rows(found), right=(2, 3, 4))
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
        "notes": found.notes,
        "note": found.note or None,
    }
