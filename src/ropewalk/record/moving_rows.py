"""Rows about pulleys, obstacles and what slides along ropes, of a run's table and of their own.

Of the recorded frames: between two of them there may be more, and the rows of the run's table say so.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ropewalk.core.arrays import Floats, Ints
from ropewalk.record.body_loads import body_loads
from ropewalk.record.event_log import RAN_OFF
from ropewalk.record.extremes import SEEN
from ropewalk.record.quantities import PULLEYS, has_rope
from ropewalk.statics.slide_bumps import SHARP, bump_words, turn_at

if TYPE_CHECKING:
    from ropewalk.laws.slides.table import Slides
    from ropewalk.record.result import Result

_VALUES = 2_000_000  # numbers of one quantity looked at together
_TOLD = 4  # slides that a row names
_RATE, _KINETIC, _WEIGHT = 1, 2, 6  # columns of the quantity pulleys
APART = "of the ropes; what turns freely has its own"
SLIDE_COLUMNS = (
    *("time [s]", "slide", "rope", "along"),
    *("place [m]", "speed [m/s]", "load [N]", "speed of the rope's centre of mass [m/s]"),
)


class SlideMotion(NamedTuple):
    """How a node slid along a rope, one row a frame."""

    place: Floats  # (frames,) unstretched rope from the line's start [m], NaN once it has run off
    speed: Floats  # (frames,) of the node [m/s]
    # (frames,) that it presses on the line with, across it, at an end of the line with the stop's force [N];
    # 0 once it has run off
    load: Floats
    carried: (
        Floats  # (frames,) speed of the centre of mass of the node's rope, with its loads [m/s]
    )


def moving_rows(result: Result) -> dict[str, Any]:
    """Return the rows of pulleys, other obstacles and slides; nothing where there are none."""
    return _rates(result) | _of_turning(result) | _of_slides(result)


def slide_motion(result: Result, name: str) -> SlideMotion:
    """Return how one slide moved. Raises KeyError where the scene has none of that name."""
    names = [slide.name for slide in result.scene.slides]
    if name not in names:
        raise KeyError(f"name one of the slides, {', '.join(names) or '(none)'}, not {name!r}")
    row, parts = names.index(name), list[SlideMotion]()
    table, masses = _slides(result), _masses(result, row)
    for start, stop in _pieces(result, result.frames):
        parts.append(_piece(result, row, table, masses, start, stop)[0])
    return SlideMotion(*(np.concatenate(column) for column in zip(*parts, strict=True)))


def slide_rows(result: Result, nodes: Ints) -> Callable[[Ints], list[NDArray[np.generic]]]:
    """Return what makes the columns at some frames: a row a frame for each slide of one of some nodes.

    `place` is of the line's unstretched rope, NaN once the slide has run off. All frames are looked at
    once: where a slide is follows from where it was.
    """
    found: list[tuple[tuple[str, str, str], SlideMotion]] | None = None
    wanted = set(nodes.tolist())
    slides = [s for s in result.scene.slides if result.layout.node(s.node, s.rope) in wanted]

    def columns(frames: Ints) -> list[NDArray[np.generic]]:
        nonlocal found
        if found is None:
            found = [((s.name, s.rope, s.on), slide_motion(result, s.name)) for s in slides]
        times = np.repeat(result.time[frames], len(found))
        named = [
            np.array([labels[k] for labels, _ in found] * len(frames), dtype=object)
            for k in range(3)
        ]
        values = [
            np.array([motion[k][frames] for _, motion in found]).reshape(len(found), -1).T.ravel()
            for k in range(len(SlideMotion._fields))
        ]
        return [times, *named, *values]

    return columns


def ran_off_at(result: Result, name: str) -> float:
    """Return when a slide ran off its rope, which had parted [s]; inf: it never did."""
    events = (event for event in result.events if event["event"] == RAN_OFF)
    return min((float(one["time"]) for one in events if one["slide"] == name), default=math.inf)


def axle_loads(result: Result, frames: range) -> Floats:
    """Return the force of the ropes on each pulley, (frames, pulleys) [N]: see `body_loads`."""
    return body_loads(result, frames, result.layout.pulleys)


def _rates(result: Result) -> dict[str, Any]:
    """Return the largest rate of a pulley."""
    names = result.layout.pulleys
    if not names or PULLEYS not in result.source.names:
        return {}
    best, shown = dict[str, tuple[float, str]](), [f"pulley {name!r}" for name in names]
    for start, stop in _pieces(result, result.good_frames):
        rates = np.abs(result.read(PULLEYS, start, stop)[..., _RATE])
        _keep(best, "rate", rates, shown, result.time[start:stop])
    return {
        "largest rate of a pulley [rad/s]": best["rate"][0],
        "largest rate of a pulley at": best["rate"][1],
    }


def _of_turning(result: Result) -> dict[str, Any]:
    """Return the energy in the end of what turns freely, which is not in that of the ropes."""
    if not result.layout.pulleys or PULLEYS not in result.source.names:
        return {}
    last, what = result.good_frames - 1, "of what turns freely"
    each = result.read(PULLEYS, last, last + 1)[0]
    beside = "not in that of the ropes"
    rows = {
        f"final kinetic energy {what} [J]": float(each[:, _KINETIC].sum()),
        f"final kinetic energy {what} at": beside,
    }
    if each[:, _WEIGHT].any():
        rows[f"final energy of weight {what} [J]"] = -float(each[:, _WEIGHT].sum())
        rows[f"final energy of weight {what} at"] = f"{beside}; 0 at the start"
    return rows


def _of_slides(result: Result) -> dict[str, Any]:
    """Return speeds, load and places of what slides."""
    slides = result.scene.slides
    if not slides:
        return {}
    table, best, last = _slides(result), dict[str, tuple[float, str]](), list[str]()
    sharp = list[tuple[float, str]]()
    for row, slide in enumerate(slides):
        masses, said, turned = _masses(result, row), f"slide {slide.name!r}", list[Floats]()
        for start, stop in _pieces(result, result.good_frames):
            found, turns = _piece(result, row, table, masses, start, stop)
            turned.append(np.stack([found.load, turns]))
            for title, values in zip(SlideMotion._fields, found, strict=True):
                frame = int(np.argmax(np.where(np.isfinite(values), values, -np.inf)))
                where = f"{said}, {found.place[frame]:.5g} m along {slide.on!r}"
                there = f"rope {slide.rope!r}, {where}" if title == "carried" else where
                words = f"{said} along {slide.on!r}" if title == "place" else there
                _keep(best, title, values[:, None], [words], result.time[start:stop])
        turn = _sharpest_loaded(*np.concatenate(turned, axis=1))
        if turn > SHARP:
            sharp.append((turn, bump_words(slide.name, slide.on, turn, "up to ")))
        off = ran_off_at(result, slide.name)
        left = f"has run off at t = {off:.6g} s"
        last.append(
            f"{slide.name!r} " + (f"{found.place[-1]:.5g} m along" if off == math.inf else left)
        )
    titles = {
        "speed": "largest speed of a sliding node [m/s]",
        "carried": "largest speed of a sliding rope's centre of mass [m/s]",
        "load": "largest load of a slide on its rope [N]",
        "place": "farthest place of a slide [m]",
    }
    rows: dict[str, Any] = {}
    for name, title in titles.items():
        rows |= {title: best[name][0], f"{title.partition(' [')[0]} at": best[name][1]}
    rows["largest load of a slide on its rope at"] += (
        "; at an end of the line the stop's force is in it"
    )
    rows["farthest place of a slide at"] += f"; in the end {_few(last, ', ')}"
    sharpest = [words for _, words in sorted(sharp, reverse=True)]
    return rows | ({"about the slides": _few(sharpest, "; ")} if sharp else {})


def _few(told: Sequence[str], between: str) -> str:
    """Return the first of what is told of slides, and of how many more it could be."""
    more = [f"and {len(told) - _TOLD} more"] if len(told) > _TOLD else []
    return between.join([*told[:_TOLD], *more])


def _sharpest_loaded(load: Floats, turns: Floats) -> float:
    """Return the largest turn [rad] of frames in which a slide bears at least half of what it mostly does.

    Not a mean: what bumps hold grows with the turn's fourth power, and a line that is slack turns anyhow.
    """
    borne = load[load > 0.0]
    heavy = (load > 0.0) & (load >= 0.5 * np.median(borne)) if borne.size else load > 0.0
    return float(turns[heavy].max(initial=0.0))


def _keep(
    best: dict[str, tuple[float, str]],
    title: str,
    values: Floats,
    named: Sequence[str],
    times: Floats,
) -> None:
    """Keep the largest of (frames, things), with which of those `named`, and when it was."""
    signed = np.where(np.isfinite(values), values, -np.inf)
    frame, column = divmod(int(np.argmax(signed)), values.shape[1])
    if signed[frame, column] > best.get(title, (-math.inf, ""))[0]:
        at = f"{named[column]}, t = {times[frame]:.6g} s, {SEEN}"
        best[title] = float(signed[frame, column]), at


def _pieces(result: Result, frames: int) -> Iterator[tuple[int, int]]:
    """Return the first and last frame of pieces that fit into memory."""
    step = max(1, _VALUES // (3 * result.nodes))
    return ((start, min(start + step, frames)) for start in range(0, frames, step))


def _slides(result: Result) -> Slides:
    from ropewalk.record.contacts import model_of

    table: Slides = model_of(result).system.node.slide
    return table


def _masses(result: Result, row: int) -> Floats:
    """Return the masses of the nodes of the rope of a slide, with their loads, (nodes,) [kg]."""
    rope = result.scene.rope_named(result.scene.slides[row].rope)
    length = rope.own_mass / max(rope.nodes - 1, 1)
    masses = np.full(rope.nodes, length)
    masses[[0, -1]] *= 0.5
    if rope.made_of.kind == "springs":
        masses[:] = rope.own_mass / rope.nodes
    for load in rope.loads:
        masses[rope.node_index(load.node)] += load.mass
    return masses


def _piece(
    result: Result, row: int, table: Slides, masses: Floats, start: int, stop: int
) -> tuple[SlideMotion, Floats]:
    """Return how a slide moved in some frames, and by how much its line turned there [rad], (frames,)."""
    from ropewalk.laws.slides.rail import nearest_place, point_at
    from ropewalk.laws.slides.reach import live_ends, place_near, whole
    from ropewalk.laws.slides.table import LOOSE

    places = result.read("positions", start, stop).transpose(0, 2, 1)
    velocities = result.read("velocities", start, stop)
    node, first, last = int(table.node[row]), int(table.first[row]), int(table.last[row])
    slide = result.scene.slides[row]
    off, live, ends = ran_off_at(result, slide.name), None, whole(last - first)
    if "rest_length" in result.source.names:
        lengths = [rope.segment_length for rope in result.scene.ropes]
        live = has_rope(result.layout, result.read("rest_length", start, stop), lengths)
    span = result.layout.span(result.scene.slides[row].rope)
    (place, load, turns), u = np.zeros((3, stop - start)), math.nan
    for i, x in enumerate(np.ascontiguousarray(places)):
        if result.time[start + i] >= off:
            place[i], load[i] = math.nan, 0.0
            continue
        if live is not None:
            ends = live_ends(table, row, x, live[i], u)
            ends[LOOSE : LOOSE + 2] = 0
        u = nearest_place(x, node, first, ends, u) if u == u else place_near(table, row, x, ends)
        apart = x[:, node] - np.array(point_at(x, first, ends, u))
        place[i] = u * table.length[row]
        load[i] = table.stiffness[row] * float(np.linalg.norm(apart))
        turns[i] = turn_at(x, first, last, u)
    middle = np.einsum("n,fnk->fk", masses, velocities[:, span.start : span.end + 1])
    motion = SlideMotion(
        place,
        np.linalg.norm(velocities[:, node], axis=1),
        load,
        np.linalg.norm(middle, axis=1) / masses.sum(),
    )
    return motion, turns
