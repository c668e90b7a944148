"""What ropes touch, as streams of a packed run."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

import numpy as np

from ropewalk.core.arrays import Floats, Ints
from ropewalk.live.packing import Packed, pack, step_of, steps_of
from ropewalk.live.touch import PAIR, Touch

_PLACE = 0.02  # of a segment, to which contacts of ropes are placed
_ANGLE = 1e-3  # [rad], and of the logarithm of the ratio at slip [1]
_FINE = 10.0  # parts of a usual step, for what stands in numbers


def touch_streams(touches: Sequence[Touch], ropes: Ints) -> list[Packed]:
    """Return the streams of what is touched in some frames, none of what there is no room for.

    `ropes` (n,) has the ropes of all nodes, whose forces have steps of their own.
    """
    rows, room = len(touches), touches[0].room
    found = []

    def keep(name: str, values: Floats, step: Floats | float) -> None:
        flat = np.where(np.isfinite(values), values, 0.0).reshape(rows, -1)
        found.append(pack(name, flat, step, zero=True))

    if room.forces:
        force = np.array([one.force for one in touches])
        force = np.nan_to_num(force).reshape(rows, -1)
        keep("contact", force, steps_of(force, np.repeat(ropes, 3)))
    if room.pairs:
        pairs = in_places([one.pairs for one in touches])
        push = pairs[:, :, 2:].reshape(rows, -1)
        each = np.full(pairs.shape[1:], _PLACE)
        each[:, 2:] = steps_of(push, np.repeat(np.arange(len(each)), 3)).reshape(-1, 3)
        keep("rope_contacts", pairs, each.ravel())
    if room.wraps:
        wraps = np.array([one.wraps for one in touches])
        wraps = wraps[:, : max(1, int((wraps[:, :, 0] >= 0.0).sum(axis=1).max()))]
        each = np.tile([1.0] * 4 + [_ANGLE] * 4, (wraps.shape[1], 1))
        pulls = np.nan_to_num(wraps[:, :, 5:7]).reshape(rows, -1)
        each[:, 5:7] = steps_of(pulls, np.repeat(np.arange(len(each)), 2)).reshape(-1, 2) / _FINE
        keep("wraps", wraps, each.ravel())
    if room.surfaces:
        rubbed = np.array([one.rubbed for one in touches])
        if np.isfinite(rubbed).all():
            steps = [step_of(surface) / _FINE for surface in rubbed.T]
            keep("friction_work", rubbed, np.array(steps))
    return found


def in_places(pairs: Sequence[Floats]) -> Floats:
    """Return contacts, (p, 5) a frame, with each at one place as long as it lasts: (frames, most, 5).

    An empty place stays where it was, without force: that packs best.
    """
    places: dict[tuple[int, int, int], int] = {}
    frames: list[dict[int, Floats]] = []
    for one in pairs:
        there = one[one[:, 0] >= 0.0]
        names = _names(there)
        places = {name: places[name] for name in names if name in places}
        free = iter(sorted(set(range(len(names) + len(places))) - set(places.values())))
        for name in names:
            if name not in places:
                places[name] = next(free)
        frames.append({places[name]: row for name, row in zip(names, there, strict=True)})
    found = np.zeros(
        (len(frames), max((max(one, default=0) for one in frames), default=0) + 1, PAIR)
    )
    for now, here in enumerate(frames):
        if now:
            found[now, :, :2] = found[now - 1, :, :2]
        for place, row in here.items():
            found[now, place] = row
    return found


def _names(there: Floats) -> list[tuple[int, int, int]]:
    """Return the segments of contacts (k, 5) and, as the end of one starts the next, a number."""
    count: Counter[tuple[int, int]] = Counter()
    names = []
    for first, second in np.floor(there[:, :2]).astype(int).tolist():
        names.append((first, second, count[first, second]))
        count[first, second] += 1
    return names
