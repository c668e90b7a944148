"""How far runs lie apart, in numbers.

The distance of two runs at a time is that of their ropes' nodes (or of points at equal shares of their
unstretched lengths, where the numbers of nodes differ). Times are the frames of the run that has fewer of
them. Where the other has none then, its positions follow from places and velocities of the frames beside,
which is exact at the frames: a run compared with itself differs by exactly zero.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.record.good import good_part
from ropewalk.record.result import Result
from ropewalk.scene import Scene

_CHUNK = 256  # frames compared in one go


@dataclass(frozen=True)
class Distance:
    """The distance of a run from another over their common time.

    `time` (f,) [s] and `largest`, `rms` (f,) [m], over all nodes; all empty where the distance is not
    defined, and `note` says why. `way` says which points were compared.
    """

    time: Floats
    largest: Floats
    rms: Floats
    way: str
    note: str = ""

    @property
    def defined(self) -> bool:
        """Whether there is a distance at all."""
        return self.time.size > 0

    @property
    def worst(self) -> float:
        """Largest distance of all times [m]; nan where it is not defined."""
        return float(self.largest.max()) if self.defined else float("nan")

    @property
    def when(self) -> float:
        """Time of the largest distance [s]; nan where it is not defined."""
        return float(self.time[self.largest.argmax()]) if self.defined else float("nan")


@dataclass(frozen=True)
class Comparison:
    """Two or more runs, all measured against the first."""

    results: tuple[Result, ...]
    labels: tuple[str, ...]
    distances: tuple[Distance, ...]  # of the second and later runs from the first
    settings: tuple[tuple[str, tuple[str, ...]], ...]  # what differs: path in the scene, values

    @property
    def rows(self) -> list[dict[str, Any]]:
        """One row of numbers per run, SI units in the names; nan where something is not defined."""
        rows = []
        elastic = not all(result.has_total_tension for result in self.results)
        frames = not all(result.has_extremes for result in self.results)
        for number, (result, label) in enumerate(zip(self.results, self.labels, strict=True)):
            row = {"run": label, **key_numbers(result, elastic=elastic, frames=frames)}
            distance = self.distances[number - 1] if number else None
            row["largest distance [m]"] = distance.worst if distance else 0.0
            row["at time [s]"] = distance.when if distance else float("nan")
            row["compared"] = (distance.note or distance.way) if distance else "the reference"
            rows.append(row)
        return rows


def compare_runs(results: Sequence[Result], labels: Sequence[str] | None = None) -> Comparison:
    """Compare two or more runs with the first of them.

    Raises ValueError for fewer than two runs, or labels that are not one per run and different.
    """
    if len(results) < 2:
        raise ValueError(f"results: {len(results)} - must be at least two runs")
    names = tuple(labels) if labels is not None else default_labels(results)
    if len(names) != len(results) or len(set(names)) != len(names):
        raise ValueError(f"labels: {list(names)!r} - must be {len(results)} different names")
    distances = tuple(distance(results[0], other) for other in results[1:])
    settings = differing_settings([result.scene for result in results])
    return Comparison(tuple(results), names, distances, settings)


def default_labels(results: Sequence[Result]) -> tuple[str, ...]:
    """Return the runs' folder names, else scene names, else methods; numbered where they repeat."""
    for names in (
        [result.folder.name if result.folder else "" for result in results],
        [result.scene.name for result in results],
        [result.plan.method for result in results],
    ):
        if all(names) and len(set(names)) == len(names):
            return tuple(names)
    return tuple(f"{result.scene.name} {i + 1}" for i, result in enumerate(results))


def key_numbers(result: Result, *, elastic: bool = False, frames: bool = False) -> dict[str, Any]:
    """Return what people compare first, over the good part of a run.

    With `elastic` the elastic tension, which run folders of format 2 have alone, in place of the tension;
    with `frames` the largest of the recorded frames, where not all runs have kept that of every step.
    """
    good = good_part(result)
    with np.errstate(all="ignore"):
        error = np.asarray(result.energy_error if frames else result.energy_errors)[:good]
        total = np.asarray(result.energy["total"])[:good]
    pull = "tension" if frames or not result.has_extremes else "greatest_tension"
    if elastic:
        pull = "elastic_tension" if result.has_total_tension else "tension"
    highest = [_largest(result, pull, part, good) for part in range(0, good, _CHUNK)]
    return {
        "method": result.plan.method,
        "step [s]": result.plan.dt,
        "nodes": sum(rope.nodes for rope in result.scene.ropes),
        "frames": good,
        "end [s]": float(result.time[good - 1]),
        "status": result.status,
        f"largest {'elastic ' if elastic else ''}tension{_SEEN if frames else ''} [N]": max(
            highest
        ),
        "energy change [J]": float(total[-1] - total[0]),
        "largest energy error [J]": float(np.abs(error).max()),
    }


_SEEN = " of the recorded frames"


def _largest(result: Result, name: str, start: int, good: int) -> float:
    return float(np.nanmax(result.read(name, start, min(start + _CHUNK, good))))


# -- distance ----------------------------------------------------------------------------


def distance(first: Result, second: Result) -> Distance:
    """Return the distance of the second run from the first, until a rope breaks.

    At the frames of the run that has fewer: another's are no places at all between its frames.
    """
    why = _incomparable(first, second)
    if why:
        return Distance(np.empty(0), np.empty(0), np.empty(0), "", f"not defined: {why}")
    goods = _whole(first), _whole(second)
    end = min(first.time[goods[0] - 1], second.time[goods[1] - 1])
    start = max(first.time[0], second.time[0])
    slack = 1e-9 * max(float(end), 1.0)
    frames = [run.time[:good] for run, good in zip((first, second), goods, strict=True)]
    common = [one[(one >= start - slack) & (one <= end + slack)] for one in frames]
    moments = min(common, key=len)
    if moments.size == 0:
        return Distance(np.empty(0), np.empty(0), np.empty(0), "", "not defined: no common time")
    same = _nodes(first) == _nodes(second)
    way = "node by node" if same else "at equal shares of the ropes' unstretched lengths"
    if not all(_are_frames(moments, one) for one in frames):
        way += ", between frames of one run"
    largest, rms = np.empty(moments.size), np.empty(moments.size)
    for i in range(0, moments.size, _CHUNK):
        part = moments[i : i + _CHUNK]
        a, b = positions_at(first, part, goods[0]), positions_at(second, part, goods[1])
        gap = _gap(first, second, a, b, same)
        largest[i : i + _CHUNK] = gap.max(axis=1)
        rms[i : i + _CHUNK] = np.sqrt((gap**2).mean(axis=1))
    broke = any(
        good < len(run.time) and run.time[good - 1] <= end + slack
        for run, good in zip((first, second), goods, strict=True)
    )
    note = f"{way}, until one run broke at {end:.4g} s" if broke else ""
    return Distance(moments.copy(), largest, rms, way, note)


def _are_frames(moments: Floats, frames: Floats) -> bool:
    """Tell whether all of these times are frames."""
    after = np.clip(np.searchsorted(frames, moments), 1, max(len(frames) - 1, 1))
    near = np.minimum(abs(moments - frames[after - 1]), abs(frames[after % len(frames)] - moments))
    return bool((near <= 1e-9 * np.maximum(moments, 1e-3)).all())


def _whole(result: Result) -> int:
    """Return the number of frames in which no rope has broken."""
    return min([good_part(result), *(end.frames for end in result.ends)])


def _nodes(result: Result) -> list[tuple[str, int, int]]:
    return [(span.name, span.nodes, span.spare_start) for span in result.layout.ropes]


def _incomparable(first: Result, second: Result) -> str:
    """Say why two runs have no distance; empty when they have."""
    names = [[span.name for span in r.layout.ropes] for r in (first, second)]
    if len(names[0]) != len(names[1]):
        return f"{len(names[0])} ropes and {len(names[1])}"
    if set(names[0]) != set(names[1]) and len(names[0]) > 1:
        return "the ropes have different names"
    winches = bool(first.scene.winches or second.scene.winches)
    if winches and [n[1:] for n in _nodes(first)] != [n[1:] for n in _nodes(second)]:
        return "ropes on winches with different numbers of nodes"
    return ""


def positions_at(result: Result, moments: Floats, good: int) -> Floats:
    """Return positions at some times [m], (f, n, 3), between frames cubic, by places and velocities.

    Times before the first frame or after the last good one get these.
    """
    time = result.time[:good]
    low = np.clip(np.searchsorted(time, moments, side="right") - 1, 0, good - 1)
    near = np.clip(np.searchsorted(time, moments), 0, good - 1)
    close = np.abs(time[near] - moments) <= 1e-9 * np.maximum(np.abs(moments), 1e-3)
    low = np.where(close, near, low)
    high = np.minimum(low + 1, good - 1)
    width = np.where(high > low, time[high] - time[low], 1.0)
    share = np.where(close, 0.0, np.clip((moments - time[low]) / width, 0.0, 1.0))
    first, last = int(low.min()), int(high.max()) + 1
    points = result.read("positions", first, last)
    a, b = points[low - first], points[high - first]
    if not share.any():
        return a
    speeds = result.read("velocities", first, last)
    s, h = share[:, None, None], width[:, None, None]
    u, v = h * speeds[low - first], h * speeds[high - first]
    way = b - a
    cubic = a + s * (u + s * (3.0 * way - 2.0 * u - v + s * (u + v - 2.0 * way)))
    return np.where(s == 0.0, a, cubic)


def _gap(first: Result, second: Result, a: Floats, b: Floats, same: bool) -> Floats:
    """Return the distances of matching points [m], (f, p)."""
    if same:
        return np.asarray(np.linalg.norm(a - b, axis=2))
    gaps = []
    for span in first.layout.ropes:
        other = (
            second.layout.ropes[0]
            if len(second.layout.ropes) == 1
            else second.layout.span(span.name)
        )
        mine, its = a[:, span.first : span.last + 1], b[:, other.first : other.last + 1]
        points = min(mine.shape[1], its.shape[1])
        gaps.append(np.linalg.norm(resample(mine, points) - resample(its, points), axis=2))
    return np.concatenate(gaps, axis=1)


def resample(points: Floats, count: int) -> Floats:
    """Return points at equal shares of the unstretched length, (f, count, 3), from nodes (f, n, 3).

    All segments of a rope have the same unstretched length, so equal shares are equal node numbers.
    """
    nodes = points.shape[1]
    if nodes == count:
        return points
    place = np.linspace(0.0, nodes - 1.0, count)
    low = np.minimum(place.astype(int), nodes - 2)
    share = (place - low)[None, :, None]
    out: Floats = points[:, low] * (1.0 - share) + points[:, low + 1] * share
    return out


# -- settings ----------------------------------------------------------------------------


def differing_settings(scenes: Sequence[Scene]) -> tuple[tuple[str, tuple[str, ...]], ...]:
    """Return the paths in the scenes whose values differ, with each scene's value as text."""
    flat = [_flatten(scene.model_dump(mode="json", by_alias=True)) for scene in scenes]
    paths = list(dict.fromkeys(path for one in flat for path in one))
    found = []
    for path in paths:
        values = [one.get(path, "-") for one in flat]
        if any(value != values[0] for value in values) and path not in ("name", "description"):
            found.append((path, _texts(values)))
    return tuple(found)


def _texts(values: Sequence[Any]) -> tuple[str, ...]:
    """Return values as text, numbers with six figures or as many as tell them apart."""
    for figures in (6, 9, 12, 15, 17):
        texts = tuple(_text(value, figures) for value in values)
        if len(set(texts)) == len(set(map(str, values))):
            break
    return texts


def _flatten(value: Any, path: str = "") -> dict[str, Any]:
    """Return a nested model's values by path, as `rope[0].made_of.EA`."""
    if isinstance(value, dict):
        out: dict[str, Any] = {}
        for key, item in value.items():
            out |= _flatten(item, f"{path}.{key}" if path else str(key))
        return out
    if isinstance(value, list) and value and isinstance(value[0], dict):
        out = {}
        for i, item in enumerate(value):
            out |= _flatten(item, f"{path}[{i}]")
        return out
    return {path: value}


def _text(value: Any, figures: int) -> str:
    text = f"{value:.{figures}g}" if isinstance(value, float) else str(value)
    return text if len(text) <= 40 else text[:39] + "…"
