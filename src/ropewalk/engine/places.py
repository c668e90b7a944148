"""Which numbers of the islands' arrays are which of the whole scene's."""

from __future__ import annotations

from collections import defaultdict
from typing import Any, NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats, Ints, State, flatten
from ropewalk.engine.shares import INDICES, PEAKS, SUMS, Share


class Links(NamedTuple):
    """Places in two pools: that of the whole, and that of all islands one after another."""

    there: Ints  # in the whole's pool
    own: Ints  # in that of the islands
    indices: Ints  # which of these pairs are indices of nodes ...
    moved: Ints  # ... and what is taken off those of the whole
    sums: dict[str, Ints]  # of what is added up over islands, in theirs, (k, m)
    past: Ints  # (k,) how much every island's method remembers, in theirs
    now: Ints  # (k, 2) the times of every island's laws, in theirs


def find_links(
    whole: tuple[State, Floats], shares: list[Share], states: list[State], sea: Floats
) -> Links:
    """Find the places of all shares' numbers; `whole` is the state of all and its pool, `sea` the shares'.

    Shares whose arrays have the same shapes are dealt with together.
    """
    there: dict[str, Any] = flatten(_places(*whole))
    alike, firsts = defaultdict(list), []
    for k, (share, state) in enumerate(zip(shares, states, strict=True)):
        shapes = tuple(array.shape for array in flatten(state).values())
        alike[shapes, share.own_segments.tobytes()].append(k)
        firsts.append(start_in(state.x, sea))
    found: list[list[Ints]] = [[np.zeros(0, np.int64)] for _ in range(4)]
    sums = {name: np.zeros((len(shares), 2), np.int64) for name in SUMS}
    past, now = np.zeros(len(shares), np.int64), np.zeros((len(shares), 2), np.int64)
    count = 0
    for numbers in alike.values():
        model: dict[str, Any] = flatten(_places(states[numbers[0]], sea))
        offsets = np.array(firsts)[numbers] - firsts[numbers[0]]
        for name, pairs in _pairs(there, [shares[k] for k in numbers], model):
            own = (offsets[:, None] + pairs[1].ravel()).ravel()
            found[0].append(pairs[0].ravel())
            found[1].append(own)
            if name in INDICES:
                found[2].append(count + np.arange(own.size))
                found[3].append(np.concatenate([shares[k].moved[name].ravel() for k in numbers]))
            count += own.size
        for name, rows in sums.items():
            rows[numbers] = offsets[:, None] + model[name]
        past[numbers] = offsets + model["past"][0]
        now[numbers] = offsets[:, None] + model["now"]
    at, own, indices, moved = (np.concatenate(parts) for parts in found)
    return Links(at, own, indices, moved, sums, past, now)


class OwnLinks(NamedTuple):
    """Places in the pool of the whole, and in that of one island."""

    there: Ints
    own: Ints
    indices: Ints  # as of `Links`
    moved: Ints


def own_links(there: dict[str, Ints], share: Share, state: State, pool: Floats) -> OwnLinks:
    """Find the places of one island's numbers; `there` are those of the whole, see `places_in`."""
    model = places_in(state, pool)
    found: list[list[Ints]] = [[np.zeros(0, np.int64)] for _ in range(4)]
    count = 0
    for name, (whole, own) in _pairs(there, [share], model):
        found[0].append(whole.ravel())
        found[1].append(own.ravel())
        if name in INDICES:
            found[2].append(count + np.arange(own.size))
            found[3].append(share.moved[name].ravel())
        count += own.size
    return OwnLinks(*(np.concatenate(parts) for parts in found))


def places_in(state: State, pool: Floats) -> dict[str, Any]:
    """Return by name where the numbers of a state lie in its pool."""
    return flatten(_places(state, pool))


def _pairs(
    there: dict[str, Ints], shares: list[Share], model: dict[str, Ints]
) -> list[tuple[str, tuple[Ints, Ints]]]:
    """Return names, places in the whole (shares, ...) and in the first share, whose are in `model`."""
    found = []
    for name in shares[0].names(model):
        last, _, here = shares[0].where(name)
        at = np.array([share.rows(name) for share in shares])
        array = shares[0].of_bodies(name, there[name])
        one = np.moveaxis(array[..., at], -2, 0) if last else array[at]
        found.append((name, (one, model[name][..., here] if last else model[name][here])))
    return found


def pool_size(state: State) -> int:
    """Return how many numbers `core.arrays.pooled` wants for a state."""
    parts = flatten(state).items()
    return sum(-(-part.size // 8) * 8 for name, part in parts if not name.startswith(PEAKS))


def start_in(array: Any, pool: Floats) -> int:
    """Return where an array begins in its pool."""
    first: int = array.__array_interface__["data"][0] - pool.__array_interface__["data"][0]
    return first // 8


def _places(state: State, pool: Floats) -> State:
    """Return a state whose arrays hold, in place of each number, where in its pool that lies."""

    def place(value: Any) -> Any:
        if isinstance(value, tuple):
            return type(value)(*(place(item) for item in value))
        first = start_in(value, pool)
        return np.arange(first, first + value.size).reshape(value.shape)

    places: State = place(state)
    return places
