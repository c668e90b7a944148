"""Frames of a scene's islands: buffers for them, and what they are of the whole."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import NamedTuple

import numpy as np
from numpy.lib.stride_tricks import as_strided

from ropewalk.core.arrays import Floats, Ints, State
from ropewalk.engine.engine import Engine
from ropewalk.engine.pressed import add_pressed
from ropewalk.engine.shares import NODES_RECORDED, SEGMENTS_RECORDED, Share, best_of
from ropewalk.methods.recording import (
    LARGE,
    Recording,
    bends,
    energy_names,
    make_recording,
    record_frame,
    remembering,
    work_names,
)
from ropewalk.methods.scratch import make_look
from ropewalk.methods.surface_books import surface_shapes

# Of all ropes together, besides energies and works.
ADDED = ("jump", "momentum", "angular_momentum", "error_range")
OF_ANCHORS = ("reaction", "moment", "reaction_high", "moment_high")
#: What of an island that has ended is not known any more, once it has broken.
GONE = (
    *(
        "v",
        "tension",
        "elastic_tension",
        "tension_low",
        "tension_high",
        "stretch_high",
        "speed_high",
    ),
    *("lowest", "highest", "reaction", "reaction_high", "moment", "moment_high", "contact"),
    *("joint_force", "pressed_high", "pressed_time", "pressed_before"),
    *("extremes", "extreme_since", "extreme_until"),
)

_LENGTHS = Recording._fields.index("rest_length")
_BOOKS = Recording._fields.index("books")
Shapes = tuple[tuple[int, ...], ...]
Columns = tuple[str, ...]


class Group(NamedTuple):
    """Islands whose frames have the same shapes."""

    numbers: Ints  # (k,)
    shares: list[Share]
    shapes: Shapes  # of a frame
    anchors: Ints  # (k a,) rows in the whole
    points: Ints  # (k p,) rows in the whole
    wheels: Ints  # (k w,) rows in the whole
    energies: list[int]  # columns in the whole
    works: list[int]
    books: list[int]  # rows in the whole


class Frames:
    """What islands record, and the whole of it."""

    def __init__(self, shares: list[Share], states: list[State], whole: State) -> None:
        """Tell apart which of them are alike."""
        self.nothing = [make_recording(state, 0, False) for state in states]
        self._shares, self._whole = shares, whole
        names = _columns(whole)
        kinds: dict[tuple[Shapes, Columns, Columns, bytes], list[int]] = {}
        for k, state in enumerate(states):
            own = [part.shape[1:] for part in self.nothing[k]]
            own[_LENGTHS] = state.rest_length.shape
            kind = (tuple(own), *_columns(state), shares[k].bodies.tobytes())
            kinds.setdefault(kind, []).append(k)
        self._groups = []
        last = surface_shapes(whole)[0][0] - 1  # that of ropes on ropes, where they touch
        for (shapes, energies, works, _), numbers in kinds.items():
            group = [shares[k] for k in numbers]
            self._groups.append(
                Group(
                    np.array(numbers),
                    group,
                    shapes,
                    np.concatenate([share.anchors for share in group]),
                    np.concatenate([share.points for share in group]),
                    np.concatenate([share.wheels for share in group]),
                    [names[0].index(name) for name in energies],
                    [names[1].index(name) for name in works],
                    [*group[0].bodies.tolist(), last][: shapes[_BOOKS][0]],
                )
            )
        self._order = np.concatenate([group.numbers for group in self._groups])
        spots = [(g, p) for g, group in enumerate(self._groups) for p in range(group.numbers.size)]
        self._spots = dict(zip(self._order.tolist(), spots, strict=True))  # group, and place in it
        self._laws = len(names[1])
        self._size = 0, False  # frames of the last call, and whether with lengths
        self._made: list[Recording] = []  # of groups: (k, f, ...)
        self._rooms: list[Recording] = []  # parts of these

    def make(self, frames: int, lengths: bool) -> list[Recording]:
        """Return buffers of all islands; those of equal ones lie in one array for each quantity.

        They are those of the last call, where these have so many frames: nobody else has them.
        """
        if (frames, lengths) == self._size:
            for one in self._made:
                for array in one[len(LARGE) :]:
                    array[...] = 0.0
            return self._rooms
        made, rooms = list[Recording](), list(self.nothing)
        for group in self._groups:
            arrays = []
            for name, shape in zip(Recording._fields, group.shapes, strict=True):
                empty = np.empty if name in LARGE else np.zeros
                shape = (0,) if name == "rest_length" and not lengths else shape
                arrays.append(empty((len(group.numbers), frames, *shape)))
            made.append(Recording(*arrays))
            for place, k in enumerate(group.numbers):
                rooms[k] = Recording(*(array[place] for array in arrays))
        self._size = 0, False  # whatever is raised in between
        self._made, self._rooms = made, rooms
        self._size = frames, lengths
        return self._rooms

    def collect_lines(self, out: Recording, frames: int, numbers: Iterable[int]) -> None:
        """Write what nodes and segments of some islands have recorded, as `collect` does.

        Threads may do so at the same time, each for islands of its own.
        """
        runs: list[list[int]] = []  # group, first place and that after the last
        for g, place in sorted(self._spots[k] for k in numbers):
            if runs and runs[-1][0] == g and runs[-1][2] == place:
                runs[-1][2] += 1
            else:
                runs.append([g, place, place + 1])
        for g, first, last in runs:
            found = Recording(*(array[first:last, :frames] for array in self._made[g]))
            _collect_lines(out, frames, self._groups[g].shares[first:last], found)

    def collect(self, out: Recording, frames: int, lines: bool = True) -> None:
        """Write the first `frames` frames of all islands, as they were made last, into those of the whole.

        Without `lines` those of nodes and segments are there, see `collect_lines`.
        """
        if lines:
            self.collect_lines(out, frames, range(len(self._shares)))
        ends = [there.last for share in self._shares for there, _ in share.spans]
        between = [end for end in ends if end < self._whole.rest_length.size]
        for name in SEGMENTS_RECORDED:
            array = getattr(out, name)
            if array.shape[1]:
                array[:frames, between] = 0.0
        made = [Recording(*(array[:, :frames] for array in one)) for one in self._made]
        for name in ("moment", "moment_high"):
            getattr(out, name)[:frames] = 0.0
        for group, found in zip(self._groups, made, strict=True):
            for name in OF_ANCHORS:  # none where there is no clamp, or extremes are not wanted
                own = getattr(found, name)
                if own.shape[2]:
                    getattr(out, name)[:frames, group.anchors] = _beside(own)
            out.joint_force[:frames, group.points] = _beside(found.joint_force)
            if group.wheels.size:
                out.wheel[:frames, group.wheels] = _beside(found.wheel)
            own = found.work[..., len(group.works) :]
            out.work[:frames, self._laws + group.anchors] = _beside(own)
        self._add(out, frames, made)
        add_pressed(out, frames, made, [group.shares[0].bodies for group in self._groups])
        if out.extremes.shape[1]:
            pairs = zip(self._groups, made, strict=True)
            each = [(group.shares, _extremes(found)) for group, found in pairs]
            best = best_of(each, self._order)
            out.extremes[:frames], out.extreme_places[:frames] = best[0], best[1]
            out.extreme_since[:frames], out.extreme_until[:frames] = best[2], best[3]

    def _add(self, out: Recording, frames: int, made: list[Recording]) -> None:
        """Add up what is of all ropes together, in their order."""
        columns = {"energy": [group.energies for group in self._groups]}
        columns["work"] = [group.works for group in self._groups]
        columns["books"] = [group.books for group in self._groups]
        for name in ("energy", "work", "books", *ADDED):
            whole = getattr(out, name)[:frames]
            whole = whole[:, : self._laws] if name == "work" else whole
            each = np.zeros((len(self._shares), *whole.shape))
            for k, (group, found) in enumerate(zip(self._groups, made, strict=True)):
                own = getattr(found, name)
                if name in columns:
                    here = np.array(columns[name][k], np.int64)
                    each[np.ix_(group.numbers, np.arange(frames), here)] = own[:, :, : len(here)]
                else:
                    each[group.numbers] = own
            whole[...] = np.add.accumulate(each, axis=0, out=each)[-1] + 0.0  # no other order
        if out.error_times.shape[1]:  # when all together err the most is not known
            out.error_times[:frames] = np.nan


def _extremes(found: Recording) -> Floats:
    """Return value, place, since and until of all extremes, (k, 4, f, 8)."""
    parts = found.extremes, found.extreme_places, found.extreme_since, found.extreme_until
    return np.stack(parts, axis=1)


def _beside(found: Floats) -> Floats:
    """Return what every island has of its own, (k, f, a, ...), side by side, (f, k a, ...)."""
    k, frames, own, *rest = found.shape
    return np.moveaxis(found, 0, 1).reshape(frames, k * own, *rest)


def _columns(state: State) -> tuple[Columns, Columns]:
    """Return the columns of energies and of works of a state's recording."""
    return energy_names(bends(state)), work_names(bends(state), remembering(state))


def _collect_lines(out: Recording, frames: int, shares: Sequence[Share], found: Recording) -> None:
    """Write what there is for every node and segment of equal shares."""
    firsts = [share.spans[0][0].first for share in shares]
    steps = set(np.diff(firsts).tolist())
    in_rows = len(steps) <= 1 and all(len(share.spans) == 1 for share in shares)
    for names, last in (NODES_RECORDED, 1), (SEGMENTS_RECORDED, 0):
        for name in names:
            own, whole = getattr(found, name), getattr(out, name)
            if not own.shape[2] or not own.shape[-1]:
                if whole.shape[-1] and own.shape[2]:  # these have nothing that they could touch
                    for share in shares:
                        whole[:frames, ..., share.nodes] = 0.0
                continue
            if in_rows and min(steps, default=1) > 0:
                whole = whole[:frames, ..., firsts[0] :]
                step = max(steps, default=0) * whole.strides[-1]
                shape = (*whole.shape[:-1], len(shares), own.shape[-1])
                strides = (*whole.strides[:-1], step, whole.strides[-1])
                as_strided(whole, shape, strides)[...] = np.moveaxis(own, 0, -2)
                continue
            for share, part in zip(shares, own, strict=True):
                for there, here in share.spans:
                    at = slice(there.first, there.last + last)
                    whole[:frames, ..., at] = part[..., here.first : here.last + last]


def hold_frames(engine: Engine, room: Recording, ledger: bool) -> None:
    """Fill the frames of an island that has ended: it lies where it broke, and all else is NaN.

    But for what is added up over all ropes: there it counts as it was.
    """
    state = engine.state
    out = make_recording(state, 1, room.rest_length.shape[1] > 0)
    record_frame(engine.system, state, ledger, make_look(state), 0, out)
    for name in GONE:
        getattr(out, name)[...] = np.nan
    out.extreme_places[...] = -1.0
    for to, array in zip(room, out, strict=True):
        to[...] = array
