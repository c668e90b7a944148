"""A sweep in a few lines: how far it is, how its runs ended, what they gave."""

from __future__ import annotations

import re
from collections import Counter
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ropewalk.record.note_kinds import KINDS, kinds_in
from ropewalk.sweeps.answer import stored
from ropewalk.sweeps.batch import GOOD
from ropewalk.sweeps.derived import BY_LABEL
from ropewalk.sweeps.designs import GIVEN, GRID, plain_rows
from ropewalk.sweeps.sweep_folder import SweepFolder
from ropewalk.sweeps.sweep_plan import SweepPlan

_MOST_NUMBERS = 10_000_000  # that quantiles are made of
IN_ROWS = (GRID, GIVEN)  # designs whose first runs are no sample of them all
_NUMBER = re.compile(r"[-+]?\d+(\.\d+)?(e[-+]?\d+)?", re.IGNORECASE)


def cause(status: str, reason: str) -> str:
    """Return a run's reason without its numbers: what many runs have in common."""
    first = reason.replace("\n", "; ")
    first = re.sub(r"Broke after t = \S+ s at node \d+ of", "Broke at", first)
    sentences = re.split(r"(?<=[.:;])\s", first + " ", maxsplit=2)[:2]
    return f"{status}: {_NUMBER.sub('#', ' '.join(sentences).strip())}"


def summary(sweep: SweepFolder) -> dict[str, Any]:
    """Return counts of runs by how they ended and why, and ranges of what was kept."""
    ended: Counter[str] = Counter()
    causes: Counter[str] = Counter()
    notes: Counter[str] = Counter()
    plan = sweep.plan
    done, damaged = sweep.standing()
    plain, sample = range(plan.runs)[_plain(plan)], 0
    for number, (status, reason) in zip(done, sweep.statuses(done), strict=True):
        ended.update(status)
        rows = zip(plan.rows(number), status, strict=True)
        sample += sum(row in plain and one in GOOD for row, one in rows)
        pairs = zip(status, reason, strict=True)
        notes.update(kind for one in sweep.notes(number) for kind in kinds_in(one))
        causes.update(cause(one, why) for one, why in pairs if one not in GOOD)
    return {
        "title": plan.title,
        "design": plan.design,
        "seed": plan.seed,
        "runs": plan.runs,
        "done": sum(ended.values()),
        "plain": len(plain),
        "sample": sample,  # of the plain ones, those that ended well: quantiles are of them
        "batches": plan.batches,
        "batches done": len(done),
        "damaged": damaged,
        "ended": dict(ended),
        "ended well": sum(count for one, count in ended.items() if one in GOOD),
        "notes": {kind: notes[kind] for kind in KINDS if notes[kind]} if plan.has_notes else None,
        "causes": dict(causes.most_common(20)),
        "parameters": [dict(parameter) for parameter in plan.parameters],
        "kept": _kept(sweep, ranges=not damaged),
        "provenance": dict(plan.provenance),
    }


def _kept(sweep: SweepFolder, ranges: bool) -> list[dict[str, Any]]:
    """Return shape and unit of everything kept, and quantiles over the runs that ended well.

    Least and largest are of all of them, what lies between of the plain sample, as the bands of `uncertain`.
    Of what is one number a run, anchor by anchor and rope by rope: mixed with places and times they would
    mean nothing. Of the first rows of a grid or a table nothing lies between that would be of them all.
    Without `ranges` no quantiles: they would read damaged batches.
    """
    data = stored(sweep) if ranges else None
    found, plain = [], _plain(sweep.plan)
    whole = sweep.plan.design not in IN_ROWS or bool((data is None) or (data.status != "").all())
    for variable in sweep.plan.variables:
        about: dict[str, Any] = {
            "name": variable.name,
            "unit": variable.unit,
            "long_name": variable.long_name,
            "dims": list(variable.dims),
            "sizes": list(variable.sizes),
        }
        if data is None or variable.numbers * sweep.plan.runs > _MOST_NUMBERS:
            found.append(about)
        elif not variable.dims:
            found.append(about | _quantiles(data[variable.name].values, plain, whole))
        elif len(variable.dims) == 1 and variable.dims[0] in BY_LABEL:
            (dim,) = variable.dims
            for place, label in enumerate(sweep.plan.coordinates[dim]["values"]):
                part = data[variable.name].isel({dim: place})
                one = {"name": f"{variable.name}[{label}]", "dims": [], "sizes": []}
                found.append(about | one | _quantiles(part.values, plain, whole))
        else:
            found.append(about)
    return found


def _plain(plan: SweepPlan) -> slice:
    return plain_rows(plan.design, len(plan.parameters))


def _quantiles(values: NDArray[np.float64], plain: slice, whole: bool) -> dict[str, list[float]]:
    """Return least, 5 %, median, 95 % and largest of finite values; those between NaN if not `whole`."""
    sound = values[np.isfinite(values)]
    sample = values[plain][np.isfinite(values[plain])]
    if not sample.size:
        return {}
    shares = np.quantile(sample, [0.05, 0.5, 0.95]) if whole else np.full(3, np.nan)
    low, middle, high = shares.tolist()
    return {"quantiles": [float(sound.min()), low, middle, high, float(sound.max())]}
