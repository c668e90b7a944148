"""What the first numbers that islands of ropes keep say: which ropes have met, and which have ended."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.methods.adaptive import Walk

Ropes = tuple[int, ...]


def misfit(what: str) -> ValueError:
    """Return what to raise where this does not fit a simulation."""
    return ValueError(f"snapshot: of another scene - must be of this simulation: {what}")


def met_before(inner: Floats, began: Sequence[Ropes]) -> tuple[list[Ropes], set[int]]:
    """Return which ropes, which `began` as these islands, are one, and which have ended.

    For (0,) all are one. Raises ValueError where these numbers do not say so.
    """
    ropes = sorted(rope for island in began for rope in island)
    if not inner.size:
        return [tuple(ropes)], set()
    first, over = inner[: len(ropes)], inner[len(ropes) : 2 * len(ropes)]
    groups: dict[float, list[int]] = {}
    for rope, lead in enumerate(first.tolist()):
        groups.setdefault(lead, []).append(rope)
    led = over.size == len(ropes) and all(lead == group[0] for lead, group in groups.items())
    if not led or any(np.ptp(first[list(island)]) for island in began):
        raise misfit("which ropes have met")
    if not np.isin(over, (0.0, 1.0)).all() or any(np.ptp(over[group]) for group in groups.values()):
        raise misfit("which ropes have ended")
    return [tuple(group) for group in groups.values()], set(np.flatnonzero(over).tolist())


def is_as(here: Walk, walk: Walk) -> bool:
    """Tell whether walks have as many numbers; those of an older version may have others.

    Raises ValueError where one alone is of steps that vary.
    """
    if bool(here.control.size) != bool(walk.control.size):
        raise misfit("the steps of its method")
    return all(one.size == other.size for one, other in zip(here, walk, strict=True))
