"""What figures look at: the plane, the good part of a run, ropes, anchors, loads and ground."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ropewalk.record.good import good_part, remembered

if TYPE_CHECKING:
    from ropewalk.lowering.layout import Span
    from ropewalk.record.result import Result

Floats = NDArray[np.float64]
AXES = ("x", "y", "z")
_MOTION = 0.6  # [1] how much motion rather than time decides which frames are shown
_LOOKS = 400  # frames from which motion is judged
_SIDEWAYS = (
    1.25  # [1] motion across the plane over that in it, from which the plane is turned to it
)
_DEEP = 0.3  # [1] reach across the plane over that in it, from which it is told
_NOTHING = 1e-6  # [1] of the ropes' extent: they do not move
_CHUNK = 4_000_000  # coordinates looked at in one go


@dataclass(frozen=True)
class Extent:
    """The space that a run takes up [m], (3,) each."""

    low: Floats
    high: Floats
    inside: Floats  # extent of the ropes at one time, on average
    moves: Floats  # how far a node goes, on average


@dataclass(frozen=True)
class Sight:
    """The plane of a figure: two unit vectors and what their axes are called."""

    across: Floats  # (3,)
    up: Floats  # (3,)
    across_name: str
    up_name: str

    def project(self, points: Floats) -> Floats:
        """Return the coordinates in the plane [m], (..., 2), of points (..., 3)."""
        return np.stack([along(points, self.across), along(points, self.up)], axis=-1)


def along(points: Floats, direction: Floats) -> Floats:
    """Return the coordinate along a unit vector; exactly x, y or z where it is one of these."""
    axis = int(np.argmax(np.abs(direction)))
    if abs(direction[axis]) == 1.0:
        picked: Floats = points[..., axis] * direction[axis]
        return picked
    with np.errstate(all="ignore"):
        product: Floats = points @ direction
    return product


def sight(result: Result, plane: str | None = None, *, still: bool = False) -> Sight:
    """Return the plane that shows most: up, and the horizontal axis along which the ropes extend most.

    Where they swing across that plane, by more than they move in it, it is up and the axis of the swing, but
    for what is drawn `still`. Without gravity these are the two axes along which they extend most. `plane`
    names the axes instead, the horizontal one first: "xz".

    Raises ValueError for a plane that is not two different letters of x, y and z.
    """
    basis = np.eye(3)
    if plane is not None:
        if len(plane) != 2 or plane[0] == plane[1] or not set(plane) <= set(AXES):
            raise ValueError(f"plane: {plane!r} - must be two of x, y and z, such as 'xz'")
        first, second = AXES.index(plane[0]), AXES.index(plane[1])
        return Sight(basis[first], basis[second], plane[0], plane[1])
    space = extent(result)
    # How long the ropes are seen at most times, and a little for where they go.
    spread = space.inside + 0.1 * (space.high - space.low)
    up = np.array(result.scene.up)
    if not any(result.scene.gravity):
        first, second = sorted(np.argsort(-spread, kind="stable")[:2])
        return Sight(basis[first], basis[second], AXES[first], AXES[second])
    axis = int(np.argmax(np.abs(up)))
    if abs(up[axis]) > 1.0 - 1e-12:
        up = np.sign(up[axis]) * basis[axis]
        rest = [k for k in range(3) if k != axis]
        best = max(rest, key=lambda k: spread[k])
        aside = sum(rest) - best
        inside = max(space.moves[best], space.moves[axis])
        if not still and space.moves[aside] > _SIDEWAYS * inside + _NOTHING * space.inside.max():
            best = aside
        return Sight(basis[best], up, AXES[best], AXES[axis] if up[axis] > 0 else "up")
    flat = [basis[k] - up[k] * up for k in range(3)]
    flat = [vector / np.linalg.norm(vector) for vector in flat]
    wide = max(range(3), key=lambda k: spread[k] * np.linalg.norm(basis[k] - up[k] * up))
    return Sight(flat[wide], up, "across", "up")


def sight_notes(result: Result, view: Sight) -> list[str]:
    """Say how far the ropes reach and move along the line of sight, where it is much beside what is seen."""
    ahead = np.cross(view.across, view.up)
    space = extent(result)
    depth, deep = abs(float(space.inside @ ahead)), float(np.abs(ahead) @ space.moves)
    wide = float(np.abs(view.across) @ space.inside)
    seen = max(float(np.abs(way) @ space.moves) for way in (view.across, view.up))
    plane = f"Drawn is the plane of {view.across_name} and {view.up_name}"
    if depth > 2.0 * wide and seen > deep:
        return [f"{plane}, in which the ropes move; across it they reach {depth:.3g} m."]
    if deep > 0.5 * seen + _NOTHING * space.inside.max():
        return [f"{plane}; across it the ropes move, too, by {deep:.3g} m on average."]
    if depth > _DEEP * max(wide, float(space.inside @ np.abs(view.up))):
        return [f"{plane}; across it the ropes reach {depth:.3g} m."]
    return []


def up_label(result: Result) -> tuple[Floats, str]:
    """Return the unit vector up and what height along it is called: "y", or "height"."""
    up = np.array(result.scene.up)
    axis = int(np.argmax(up))
    if up[axis] > 1.0 - 1e-12:
        return np.eye(3)[axis], AXES[axis]
    return up, "height"


# -- the good part ----------------------------------------------------------------------


def chunks(result: Result) -> Iterator[slice]:
    """Yield ranges of frames that are small enough to look at in one go."""
    frames = len(result.time)
    size = max(1, _CHUNK // (3 * result.layout.nodes))
    for start in range(0, frames, size):
        yield slice(start, min(start + size, frames))


def positions_of(result: Result, frames: slice) -> Floats:
    """Return positions of some frames [m], (f, n, 3), without loading the others."""
    return result.read("positions", frames.start, frames.stop)


def shown_positions(result: Result, frame: int) -> Floats:
    """Return the positions of a frame [m], (n, 3); NaN for ropes that broke before it."""
    points = np.array(positions_of(result, slice(frame, frame + 1))[0])
    for name in gone_ropes(result, frame):
        span = result.layout.span(name)
        points[span.first : span.last + 1] = np.nan
    return points


def good_frames_of(result: Result, rope: str) -> int:
    """Return the number of frames before a rope broke."""
    own = [end.frames for end in result.ends if rope in end.ropes]
    return min([good_frames(result), *own])


def gone_ropes(result: Result, frame: int) -> set[str]:
    """Return the ropes that broke before a frame, while others went on."""
    if frame >= good_frames(result):
        return set()
    return {name for end in result.ends if end.frames <= frame for name in end.ropes}


def good_frames(result: Result) -> int:
    """Return the number of frames before the run broke."""
    return good_part(result)


@remembered
def extent(result: Result) -> Extent:
    """Return what space the good part takes up [m]."""
    good = good_frames(result)
    inside, frames = np.zeros(3), 0
    low, high = (
        np.full((result.layout.nodes, 3), np.inf),
        np.full((result.layout.nodes, 3), -np.inf),
    )
    for part in chunks(result):
        if part.start >= good:
            break
        points = np.asarray(positions_of(result, slice(part.start, min(part.stop, good))))
        low = np.minimum(low, points.min(axis=0))
        high = np.maximum(high, points.max(axis=0))
        inside += np.ptp(points, axis=1).sum(axis=0)
        frames += len(points)
    moves = (high - low).mean(axis=0)
    return Extent(low.min(axis=0), high.max(axis=0), inside / frames, moves)


@remembered
def motion(result: Result) -> tuple[list[int], Floats]:
    """Return frames spread over the good part, and the way [m] that its nodes went up to each."""
    good = good_frames(result)
    frames = spread(good, _LOOKS)
    way, before = np.zeros(len(frames)), positions_of(result, slice(0, 1))[0]
    for i, frame in enumerate(frames):
        here = positions_of(result, slice(frame, frame + 1))[0]
        way[i] = np.sqrt(((here - before) ** 2).sum(axis=1).mean())
        before = here
    return frames, np.cumsum(way)


def spread(good: int, count: int) -> list[int]:
    """Return at most `count` frames spread evenly over the first `good`, the ends included."""
    chosen = np.unique(np.linspace(0, good - 1, min(count, good)).round().astype(int))
    return [int(frame) for frame in chosen]


# -- choosing ---------------------------------------------------------------------------


def frame_at(result: Result, times: Iterable[float]) -> list[int]:
    """Return the frames nearest to some times [s].

    Raises ValueError for times that are not numbers within the run.
    """
    have = result.time
    slack = 0.5 * float(have[1] - have[0]) if len(have) > 1 else 0.0
    found = []
    for time in times:
        if not have[0] - slack <= time <= have[-1] + slack + 1e-9:
            rule = f"must be within the run, {have[0]:g} to {have[-1]:g} s"
            raise ValueError(f"times: {time!r} - {rule}")
        found.append(int(np.argmin(np.abs(have - time))))
    return found


def telling_frames(result: Result, count: int, beyond: int) -> list[int]:
    """Return about `count` frames, closer together where much moves, then `beyond` broken ones."""
    frames, way = motion(result)
    good = good_frames(result)
    after = range(good, min(good + beyond, len(result.time)))
    time = result.time[frames]
    total = float(time[-1] - time[0]) or 1.0
    measure = (1.0 - _MOTION) * (time - time[0]) / total + _MOTION * way / (float(way[-1]) or 1.0)
    marks = np.linspace(0.0, float(measure[-1]), max(count - len(after), 2))
    chosen = {frames[int(np.argmin(np.abs(measure - mark)))] for mark in marks}
    return [*sorted(chosen), *after]


def spread_frames(result: Result, count: int, good: int, beyond: int) -> list[int]:
    """Return about `count` frames over the good part, then `beyond` broken ones where it breaks."""
    after = range(good, min(good + beyond, len(result.time)))
    inside = max(count - len(after), 2)
    return [*spread(good, inside), *after]


def node_index(result: Result, node: int | str | tuple[str, int]) -> int:
    """Return the array index of a node given as 5, -1, ("rope", 5) or "rope:5".

    A plain number means the first rope. Raises ValueError when there is no such node.
    """
    rope: str | None = None
    number: object = node
    if isinstance(node, tuple):
        rope, number = node
    elif isinstance(node, str):
        head, _, tail = node.rpartition(":")
        rope, number = head or None, tail
    try:
        index = int(number)  # type: ignore[call-overload]
        return result.layout.node(index, rope or result.layout.ropes[0].name)
    except (KeyError, IndexError, TypeError, ValueError) as error:
        rule = error.args[0] if isinstance(error, (KeyError, IndexError)) else "must be a number"
        raise ValueError(f"node: {node!r} - {rule}") from None


def node_name(result: Result, index: int) -> str:
    """Return what a node is called in a legend; with its rope where there are several."""
    for span in result.layout.ropes:
        if span.first <= index <= span.last:
            rope = f"{span.name}, " if len(result.layout.ropes) > 1 else ""
            last = " (end)" if index == span.end else ""
            return f"{rope}node {index - span.start}{last}"
    raise IndexError(f"there are {result.layout.nodes} nodes, no index {index}")


def telling_nodes(result: Result, most: int) -> list[int]:
    """Return free ends and the middles between anchors, at most so many, every rope in turn."""
    held = set(result.layout.anchor_nodes)
    per_rope = [_telling(span, held) for span in result.layout.ropes]
    chosen: list[int] = []
    for turn in range(max(map(len, per_rope))):
        chosen += [nodes[turn] for nodes in per_rope if turn < len(nodes)]
    return sorted(chosen[:most])


def _telling(span: Span, held: set[int]) -> list[int]:
    """Free ends first, then middles of the stretches between anchors, the longest first."""
    free = [node for node in (span.end, span.start) if node not in held]
    marks = sorted({span.start, span.end, *(n for n in held if span.start <= n <= span.end)})
    gaps = sorted(pairwise(marks), key=lambda gap: gap[0] - gap[1])
    middles = [(a + b) // 2 for a, b in gaps if b - a > 1]
    return free + middles or [span.end]


# -- what is there ----------------------------------------------------------------------


def rope_lines(result: Result, points: Floats, time: float = -math.inf) -> list[Floats]:
    """Split one frame's points (n, 2) into one array per rope; NaN where it has parted by `time` [s]."""
    gaps = parted_segments(result, time)
    lines = []
    for span in result.layout.ropes:
        own = [j + 1 - span.first for j in gaps if span.first <= j < span.last]
        lines.append(np.insert(points[span.first : span.last + 1], own, np.nan, axis=0))
    return lines


def parted_segments(result: Result, time: float) -> list[int]:
    """Return the segments that have parted by a time [s]."""
    spans = {span.name: span.start for span in result.layout.ropes}
    return [spans[one.rope] + one.segment for one in result.partings if one.time <= time]


def anchors_at(result: Result, frame: int) -> Floats:
    """Return the places of the anchors that hold at a frame [m], (a, 3)."""
    time = float(result.time[frame])
    held: Floats = shown_positions(result, frame)[held_nodes(result, time)]
    return held


def held_nodes(result: Result, time: float) -> list[int]:
    """Return array indices of nodes at the anchors that hold at a time [s].

    On a winch's drum that is the rope's very end, which never leaves it.
    """
    spans = {span.name: span for span in result.layout.ropes}
    drums = {
        spans[w.rope].start if w.end == "start" else spans[w.rope].end: (
            spans[w.rope].first if w.end == "start" else spans[w.rope].last
        )
        for w in result.scene.winches
    }
    nodes = result.layout.anchor_nodes
    return [drums.get(nodes[row], nodes[row]) for row in holding(result, time)]


def holding(result: Result, time: float) -> list[int]:
    """Return which anchors hold at a time [s], as places among all of the scene."""
    releases = [anchor.release_time for anchor in result.scene.anchors]
    return [row for row, when in enumerate(releases) if when is None or time < when]


def load_nodes(result: Result) -> list[int]:
    """Return the array indices of the nodes that carry loads."""
    return sorted(
        {
            span.start + rope.node_index(load.node)
            for span, rope in zip(result.layout.ropes, result.scene.ropes, strict=True)
            for load in rope.loads
        }
    )


def ground_height(result: Result, view: Sight) -> float | None:
    """Return the height of the ground where it is seen edge-on [m], else None."""
    ground = result.scene.ground
    seen = float(np.dot(view.up, result.scene.up))
    return ground.height * seen if ground is not None and abs(seen) > 1.0 - 1e-9 else None


def tame(values: Floats, low: float | Floats, high: float | Floats) -> Floats:
    """Return values for drawing: what lies beyond 20 spans of [low, high] is put at that border."""
    span = np.maximum(np.asarray(high) - np.asarray(low), 1e-300)
    with np.errstate(all="ignore"):
        return np.clip(values, low - 20.0 * span, high + 20.0 * span)


def limits(values: Sequence[Floats] | Floats, margin: float = 0.05) -> tuple[float, float]:
    """Return axis limits around all finite values, with a margin; never of zero width."""
    flat = np.concatenate([np.ravel(np.asarray(part)) for part in values])
    flat = flat[np.isfinite(flat)]
    if flat.size == 0:
        return -1.0, 1.0
    low, high = float(flat.min()), float(flat.max())
    room = margin * (high - low)
    if room <= 1e-12 * max(abs(low), abs(high)):
        room = 0.1 * max(abs(low), abs(high)) or 1.0
    return low - room, high + room
