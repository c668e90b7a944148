"""A run as data inside a page: positions, tension, speed, energies of every frame, in few bytes."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from ropewalk import __version__
from ropewalk.core.arrays import Floats, Ints
from ropewalk.live.frame import SCALARS, Picture
from ropewalk.live.packed_touch import touch_streams
from ropewalk.live.packing import LARGEST, Packed, pack, steps_of
from ropewalk.live.replay import ReplayBroadcast
from ropewalk.lowering import Layout
from ropewalk.record.errors import RunError
from ropewalk.record.result import Result
from ropewalk.words.counts import counted

# Half of a step is the error: 0.95e-5 of the longest rope, or 0.095 mm where that is less.
_OF_LENGTH, _METRES = 1.9e-5, 1.9e-4
_PAST = 0.02  # of a range, which what lies past a break may exceed: more than the page takes for rounding
_COARSER = 8  # times, in what lies beyond a frame: the largest of all is among the scalars
# How far what was seen since the frame before lies beyond the frame: nothing where all is calm.
_BEYOND = (
    ("tension", "least_tension", -1.0),
    ("tension", "greatest_tension", 1.0),
    ("speed", "greatest_speed", 1.0),
    ("force", "greatest_force", 1.0),
)


@dataclass(frozen=True)
class Recording:
    """A run packed for a page.

    Attributes:
        header: what the page must know, for JSON.
        data: the streams, one after another.
        frames: number of frames in it.
        left_out: frames at the end that cannot be shown (of a run that broke).
        position_error: largest distance of a coordinate from the run's [m].
        tension_error: the same of the tension [N].
    """

    header: dict[str, Any]
    data: bytes
    frames: int
    left_out: int
    position_error: float
    tension_error: float


def record(run: Path | Result, rate: float = 60.0) -> Recording:
    """Pack a run, or the parts of a live session, at no more than `rate` frames per second.

    Raises RunError when there is nothing to show.
    """
    broadcast = ReplayBroadcast(run, playing=False)
    where = run if isinstance(run, Path) else (run.folder or "result")
    frames = len(broadcast.times)
    usual = _thinned(broadcast.times[: frames - broadcast.single], rate)
    indices = np.union1d(usual, np.arange(frames - broadcast.single, frames))
    packed: list[Packed] = []
    parts: list[dict[str, Any]] = []
    kept: list[Floats] = []
    left_out = 0
    for number, part in enumerate(broadcast.parts):
        first, end = int(broadcast.first[number]), int(broadcast.first[number + 1])
        own = indices[(indices >= first) & (indices < end)]
        before = [-1, *(int(index) - first for index in own)][: len(own)]
        pictures = [
            part.picture(int(index) - first, after)
            for index, after in zip(own, before, strict=True)
        ]
        good = int(np.searchsorted(own, broadcast.sound))
        pictures = _within(pictures, good)
        longest = max(rope.length_unstretched for rope in part.result.scene.ropes)
        step = min(_OF_LENGTH * longest, _METRES) if longest > 0.0 else _METRES
        count = _showable(pictures, step)
        left_out += len(pictures) - count
        if count == 0:
            continue
        streams = _streams(pictures[:count], step, _ropes(part.result.layout))
        packed += streams
        kept.append(broadcast.times[own[:count]])
        parts.append(
            {
                **broadcast.facts(number),
                "layout": broadcast.layout(number),
                "frames": count,
                "good": min(good, count),
                "streams": [one.header() for one in streams],
            }
        )
    if not parts:
        raise RunError(where, "has no frame that can be shown")
    times = np.concatenate(kept)
    clock = pack("times", times[:, None], max(1e-7, float(times[-1]) / LARGEST))
    errors = {name: max(one.error for one in packed if one.name == name) for name in _NEEDED}
    header = {
        "ropewalk": __version__,
        "title": broadcast.scene.name,
        "duration": float(times[-1]),
        "times": clock.header(),
        "parts": parts,
        "single": max(0, broadcast.single - left_out),
        "about": _about(times, rate, left_out, errors, max(0, broadcast.single - left_out)),
    }
    data = b"".join(one.data for one in (clock, *packed))
    return Recording(header, data, len(times), left_out, errors["positions"], errors["tension"])


_NEEDED = ("positions", "tension")


def _thinned(times: Floats, rate: float) -> np.ndarray:
    """Return the frames to take, the first and the last among them."""
    wanted = np.floor((times - times[0]) * rate + 0.25).astype(np.int64)
    first_of_each = np.flatnonzero(np.diff(wanted, prepend=-1) > 0)
    return np.union1d(first_of_each, [len(times) - 1])


def _showable(pictures: list[Picture], step: float) -> int:
    """Return how many frames there are before one that no page can show."""
    for count, picture in enumerate(pictures):
        far = np.abs(picture.positions).max(initial=0.0)
        if not (far < 0.4 * LARGEST * step and np.isfinite(picture.tension).all()):
            return count
    return len(pictures)


def _within(pictures: list[Picture], good: int) -> list[Picture]:
    """Keep tension and speed past a break to the range before it, whose digits they would cost.

    A little more is left of them, so that the legend marks an end that is passed.
    """
    if not 0 < good < len(pictures):
        return pictures
    low = min(float(one.seen.least_tension.min()) for one in pictures[:good])
    high = max(float(one.seen.greatest_tension.max()) for one in pictures[:good])
    fast = max(float(one.seen.greatest_speed.max()) for one in pictures[:good])
    room = _PAST * (high - min(low, 0.0))
    found = pictures[:good]
    for one in pictures[good:]:
        tension = np.clip(one.tension, low - room, high + room)
        speed = np.minimum(one.speed, (1.0 + _PAST) * fast)
        seen = one.seen._replace(
            least_tension=tension, greatest_tension=tension, greatest_speed=speed
        )
        found.append(one._replace(tension=tension, speed=speed, seen=seen))
    return found


def _ropes(layout: Layout) -> Ints:
    """Return the number of every node's rope, (n,)."""
    found = np.zeros(layout.nodes, np.int64)
    for number, span in enumerate(layout.ropes):
        found[span.first : span.last + 1] = number
    return found


def _streams(pictures: list[Picture], step: float, ropes: Ints) -> list[Packed]:
    """Pack pictures; tensions and forces by the range of each rope (n,) and anchor, places by `step` [m]."""
    rows = len(pictures)

    def stacked(values: Any) -> Floats:
        found: Floats = np.array(values, float).reshape(rows, -1)
        return np.where(np.isfinite(found), found, 0.0)

    anchors = np.array([one.anchors for one in pictures], float)
    values = {
        "tension": stacked([one.tension for one in pictures]),
        "speed": stacked([one.speed for one in pictures]),
        "velocity": stacked(list(anchors[:, :, 3:6])),
        "force": stacked(list(anchors[:, :, 6:9])),
    }
    scalars = stacked([[one.scalars.get(name, 0.0) for name in SCALARS] for one in pictures])
    found = [pack("positions", stacked([one.positions for one in pictures]), step)]
    held = np.arange(anchors.shape[1])
    groups = {"tension": ropes[:-1], "speed": 0 * ropes, "velocity": np.repeat(held, 3)}
    groups["force"] = groups["velocity"]
    found += [pack(name, values[name], steps_of(values[name], groups[name])) for name in values]
    found += touch_streams([one.touch for one in pictures], ropes)
    for name, where, sign in _BEYOND:
        now = np.linalg.norm(anchors[:, :, 6:9], axis=2) if name == "force" else values[name]
        seen = stacked([getattr(one.seen, where) for one in pictures])
        beyond = np.maximum(sign * (seen - now.reshape(rows, -1)), 0.0)
        own = held if name == "force" else groups[name]
        steps = np.maximum(steps_of(seen, own), steps_of(beyond, own))
        found.append(pack(where, beyond, _COARSER * steps))
    # A hundred thousand steps each: they stand in numbers and graphs, and cost little.
    spans = np.ptp(scalars, axis=0)
    steps = np.maximum(spans, np.abs(scalars).max(axis=0) * 1e-6) * 1e-5
    found.append(pack("scalars", scalars, np.where(steps > 0.0, steps, 1.0)))
    return found


def _about(times: Floats, most: float, left_out: int, errors: dict[str, float], single: int) -> str:
    """Return a sentence on what the page holds, at no more frames per second than `most`, and how true it is.

    The last frame is taken however soon it comes, and says nothing of how many come in a second.
    """
    times = times[: len(times) - single]
    duration = float(times[-1] - times[0])
    count = max(len(times) - 2, 1)
    rate = min(count / float(times[count] - times[0]), most) if duration > 0.0 else 0.0
    text = (
        f"{counted(len(times), 'frame')}, {duration:.4g} s"
        + (f" at {rate:.4g} frames per second" if rate else "")
        + f"; positions are rounded to within {_length(errors['positions'])}, "
        f"tension to within {_figures(errors['tension'])} N."
    )
    if single:
        text += (
            f" It broke; past the last good frame the page has {counted(single, 'single step')}."
        )
    if left_out:
        last, lie = ("frame", "lies") if left_out == 1 else (f"{left_out} frames", "lie")
        text += f" The last {last}, after it broke, {lie} too far away to be shown."
    return text


def _length(metres: float) -> str:
    for size, unit in ((1e-2, "mm"), (1e-5, "µm")):
        if metres >= 0.1 * size:
            return f"{_figures(metres * (1e3 if unit == 'mm' else 1e6))} {unit}"
    return f"{_figures(metres * 1e6)} µm"


def _figures(value: float) -> str:
    """Two figures, rounded up: what is said must hold."""
    if value <= 0.0:
        return "0"
    size = 10.0 ** (np.floor(np.log10(value)) - 1)
    return f"{np.ceil(value / size - 1e-9) * size:.2g}"
