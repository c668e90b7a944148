"""Movies: the ropes in motion, coloured by tension."""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Iterator
from dataclasses import replace
from itertools import chain
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import matplotlib
import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import LineCollection
from matplotlib.colors import Normalize, to_rgb
from matplotlib.figure import Figure
from PIL import Image

from ropewalk.plots.canvas import (
    ANCHOR,
    JOINT,
    LOAD,
    Backdrop,
    Box,
    backdrop,
    draw_moving,
    draw_still,
    label,
    magnification_note,
    prepare,
)
from ropewalk.plots.ffmpeg import MovieError, Mp4Writer
from ropewalk.plots.gif import GifWriter, make_palette
from ropewalk.plots.given_forces import GIVEN, GivenForces, given_notes, with_room
from ropewalk.plots.sight import Floats, held_nodes, load_nodes, sight_notes, tame
from ropewalk.plots.strands import LINE, Strands, live_segments
from ropewalk.plots.style import (
    method_and_step,
    scaled_axis,
    set_margins,
    set_note,
    set_title,
    styled,
)
from ropewalk.plots.tensions import colour_scale, line_map, open_ends, reach
from ropewalk.plots.torn import BROKEN, broken_note
from ropewalk.record.beyond import until_torn
from ropewalk.record.extremes import extremes

if TYPE_CHECKING:
    from ropewalk.record.result import Result

_DPI = 100
_LAID_OUT = 3  # times a picture is laid out: in a wide, low one the first leaves words half outside
_SAMPLED = 200  # frames from which the colour scale is taken
_BROKEN = 1.0  # seconds shown of a break
_STEP_SHOWN = 0.1  # seconds of the movie that a single step past a break is seen, at least
KINDS = (".gif", ".mp4")

__all__ = ["MovieError", "movie", "movie_times"]


@styled
def movie(
    result: Result,
    path: str | Path,
    *,
    fps: float = 25.0,
    size: tuple[int, int] = (960, 540),
    speed: float = 1.0,
    plane: str | None = None,
    window: tuple[float, float, float, float] | None = None,
    progress: Callable[[int, int], None] | None = None,
) -> Path:
    """Write a movie of a run as GIF (any machine) or MP4 (with ffmpeg) and return its path.

    Args:
        result: the run; its frames are read as they are needed.
        path: ends in .gif or .mp4.
        fps: pictures per second; GIF has at most 50.
        size: width and height in pixels.
        speed: simulated seconds per second of the movie; 1 is real time.
        plane: the two axes to look at, as "xz"; by default those that show most.
        window: what to see of them [m]: left, right, lower and upper end, widened to fill the picture;
            by default all that ropes come to.
        progress: called with the pictures done and those in all.

    Raises ValueError for arguments that make no movie, MovieError when ffmpeg is missing or fails,
    OSError when the file cannot be written. Nothing half written is left at `path`.
    """
    path = Path(path)
    _check(path, fps, size, speed)
    seen = stage(result, plane, size, window_box(window))
    times = movie_times(result, fps, speed, seen.good)
    past = _past(result, fps)
    count = len(times) + len(past)
    painter = _Painter(result, seen, size, speed, decimals(speed / fps))
    part = path.with_name(f".{path.name}.part")
    writer: GifWriter | Mp4Writer
    try:
        if path.suffix.lower() == ".gif":
            writer = GifWriter(part, size, fps, _palette(painter.colours))
        else:
            writer = Mp4Writer(part, size, fps)
        try:
            moments = chain(_moments(result, times, seen.good), past)
            for number, moment in enumerate(moments):
                writer.add(painter.paint(moment))
                if progress is not None:
                    progress(number + 1, count)
        except BaseException:
            writer.abort()
            raise
        writer.close()
        os.replace(part, path)
    finally:
        part.unlink(missing_ok=True)
    return path


def stage(
    result: Result, plane: str | None, size: tuple[int, int], window: Box | None = None
) -> Backdrop:
    """Return the backdrop of a movie, which fills its pictures and has room for arrows, or is a window's."""
    seen = backdrop(result, plane)
    seen = replace(seen, box=_filled(window or seen.box, size))  # in a wide box arrows are long
    return seen if window else with_room(result, seen)


def window_box(given: tuple[float, float, float, float] | None) -> Box | None:
    """Return the box of a window [m]."""
    if given is None:
        return None
    try:
        left, right, low, high = (float(side + 0.0) for side in given)  # no strings
    except (TypeError, ValueError):
        left, right, low, high = [np.nan] * 4
    if not (-np.inf < left < right < np.inf and -np.inf < low < high < np.inf):
        raise ValueError(f"window: {given!r} - must be left, right, low and high [m]")
    return Box(left, right, low, high)


def _check(path: Path, fps: float, size: tuple[int, int], speed: float) -> None:
    if path.suffix.lower() not in KINDS:
        raise ValueError(f"{path}: {path.suffix!r} - must end in .gif or .mp4")
    highest = 50.0 if path.suffix.lower() == ".gif" else 240.0
    if not 0.0 < fps <= highest:
        raise ValueError(f"fps: {fps!r} - must be above 0 and at most {highest:g}")
    if not 0.0 < speed < float("inf"):
        raise ValueError(f"speed: {speed!r} - must be positive and finite")
    if len(size) != 2 or not all(200 <= side <= 4096 for side in size):
        raise ValueError(f"size: {size!r} - must be two numbers of pixels from 200 to 4096")


def movie_times(result: Result, fps: float, speed: float, good: int) -> Floats:
    """Return the simulated times of the pictures [s]: from the start, `speed / fps` apart."""
    time = result.time
    end = float(time[-1])
    if good < len(time):
        end = min(end, float(time[good - 1]) + _BROKEN * speed)
    count = int(np.floor((end - float(time[0])) * fps / speed + 1e-6)) + 1
    return np.asarray(float(time[0]) + np.arange(count) * (speed / fps), dtype=np.float64)


class _Moment(NamedTuple):
    time: float
    points: Floats  # (n, 3) [m]
    tension: Floats  # (s,) [N]
    broken: bool


def _past(result: Result, fps: float) -> list[_Moment]:
    """Return the single steps past a break, each as often as it takes to be seen; about a second in all."""
    found = until_torn(result)
    if found is None or found.last < result.frames - 1:  # other ropes went on
        return []
    each = max(1, round(fps * max(_STEP_SHOWN, _BROKEN / len(found.time))))
    none = np.zeros(result.layout.segments)
    return [
        _Moment(float(time), points, none, True)
        for time, points in zip(found.time, found.positions, strict=True)
        for _ in range(each)
    ]


def _moments(result: Result, times: Floats, good: int) -> Iterator[_Moment]:
    """Yield positions and tensions at the times, between frames by linear interpolation."""
    have = result.time
    block = max(2, 2_000_000 // (4 * result.layout.nodes))
    start, points, tension = 0, np.empty((0, 0, 3)), np.empty((0, 0))
    for time in times:
        low = int(np.clip(np.searchsorted(have, time, side="right") - 1, 0, len(have) - 1))
        high = min(low + 1, len(have) - 1)
        if high >= start + len(points):
            start = low
            points = _shown(result, low, low + block, good)
            tension = result.read("tension", low, low + block)
        share = 0.0
        if high > low:
            share = float(np.clip((time - have[low]) / (have[high] - have[low]), 0.0, 1.0))
        if high >= good:  # nothing between a sound and a broken frame is meaningful
            share = round(share)
        first, second = low - start, high - start
        if share in (0.0, 1.0):
            at = first if share == 0.0 else second
            yield _Moment(float(time), points[at], tension[at], start + at >= good)
        else:
            x = points[first] + share * (points[second] - points[first])
            t = tension[first] + share * (tension[second] - tension[first])
            yield _Moment(float(time), x, t, False)


def _shown(result: Result, start: int, stop: int, good: int) -> Floats:
    """Return positions of frames [m], (f, n, 3); NaN for ropes that broke before, while others went on."""
    points = np.array(result.read("positions", start, stop))
    for end in result.ends:
        for span in map(result.layout.span, end.ropes):
            there, until = max(end.frames - start, 0), max(good - start, 0)
            points[there:until, span.first : span.last + 1] = np.nan
    return points


class _Painter:
    """Draws pictures: what stays is drawn once, what moves is drawn over it."""

    def __init__(
        self,
        result: Result,
        seen: Backdrop,
        size: tuple[int, int],
        speed: float,
        places: int,
    ) -> None:
        self._result, self._size, self._places = result, size, places
        self._scale, name, extend = _tension_scale(result, seen.good)
        self.colours = line_map(name).with_extremes(bad=BROKEN)
        seen = self._seen = replace(seen, box=_filled(seen.box, size))
        figure = Figure((size[0] / _DPI, size[1] / _DPI), dpi=_DPI, layout="constrained")
        set_margins(figure)
        self._canvas = FigureCanvasAgg(figure)
        self._axes = axes = figure.add_subplot()
        prepare(axes, seen.box)
        label(axes, seen.view)
        draw_still(axes, seen)
        self._rope = LineCollection([], cmap=self.colours, norm=self._scale, linewidths=LINE)
        self._rope.set_capstyle("round")  # others leave gaps between segments
        axes.add_collection(self._rope)
        bar = figure.colorbar(self._rope, ax=axes, pad=0.02, shrink=0.9, extend=extend)
        scaled_axis(bar.ax, result.tension_name, "N", reach(self._scale))
        self._joints = axes.plot([], [], **JOINT)[0]  # type: ignore[arg-type]
        self._tied = list(result.layout.tied_nodes)
        self._loads = axes.plot([], [], **LOAD)[0]  # type: ignore[arg-type]
        self._anchors = axes.plot([], [], **ANCHOR)[0]  # type: ignore[arg-type]
        above: dict[str, Any] = {"transform": axes.transAxes, "ha": "right", "va": "bottom"}
        self._stamp = axes.text(1.0, 1.015, "", fontsize=11.0, **above)
        pace = "real time" if speed == 1.0 else f"{speed:g} times real time"
        set_title(figure, result.scene.name, f"{method_and_step(result)}, {pace}")
        note = broken_note(result, seen.good, clipped="the broken rope leaves the picture")
        note += magnification_note(seen.box) + sight_notes(result, seen.view)
        note += given_notes(result.scene)
        set_note(figure, note)
        self._forces = GivenForces(axes, result, seen)
        self._strands = Strands(axes, result, seen.view)
        drawn = (self._strands.artist, self._rope, self._joints, self._loads, self._anchors)
        self._moving = (*drawn, *self._forces.artists, self._stamp)
        for artist in self._moving:
            artist.set_animated(True)
        for _ in range(_LAID_OUT):
            self._canvas.draw()  # type: ignore[no-untyped-call]
        self._thick = seen.box.magnified == 1.0 and Strands.wide(axes, result)
        figure.set_layout_engine("none")
        self._still = self._canvas.copy_from_bbox(figure.bbox)  # type: ignore[no-untyped-call]
        self._load_nodes = load_nodes(result)

    def paint(self, moment: _Moment) -> Image.Image:
        """Return the picture of a moment, RGB."""
        box = self._seen.box
        points = self._seen.view.project(moment.points)
        bodies = draw_moving(self._axes, self._result, self._seen.view, moment.time)
        if moment.broken:
            x = tame(points[:, 0], box.left, box.right)
            points = np.stack([x, tame(points[:, 1], box.low, box.high)], axis=1)
        pieces = np.stack([points[:-1], points[1:]], axis=1)
        live = live_segments(self._result, moment.time)
        live &= np.isfinite(pieces).all(axis=(1, 2))  # NaN: of a rope that broke before
        pieces = pieces[live]
        thick = self._thick and not moment.broken
        self._rope.set_segments([] if thick else list(pieces))
        self._strands.artist.set_visible(thick)
        if thick:
            shades = self.colours(self._scale(moment.tension))
            self._strands.show(moment.points, shades, live, moment.time)
        elif moment.broken:
            self._rope.set_array(None)
            self._rope.set_color(BROKEN)
        else:
            self._rope.set_array(moment.tension[live])
        holds = held_nodes(self._result, moment.time)
        self._anchors.set_data(points[holds, 0], points[holds, 1])
        self._joints.set_data(points[self._tied, 0], points[self._tied, 1])
        self._loads.set_data(points[self._load_nodes, 0], points[self._load_nodes, 1])
        self._forces.move(points)
        sound = f"{moment.time:.{self._places}f} s"
        stamp = f"{moment.time:.6g} s (broken)" if moment.broken else sound
        self._stamp.set_text(f"t = {stamp}")
        self._canvas.restore_region(self._still)  # type: ignore[no-untyped-call]
        for artist in (*bodies, *self._moving):
            self._axes.draw_artist(artist)
        for body in bodies:
            body.remove()
        pixels = self._canvas.buffer_rgba()  # type: ignore[no-untyped-call]
        picture = Image.frombuffer("RGBA", self._size, pixels)
        return picture.convert("RGB")


def decimals(step: float) -> int:
    """Return how many decimals tell times apart that are a step apart [s], two at least."""
    return max(2, math.ceil(-math.log10(step)))


def _filled(box: Box, size: tuple[int, int]) -> Box:
    """Widen or heighten a box of equal scales so that it fills the picture."""
    if box.magnified != 1.0:
        return box
    ratio = (size[1] - 110) / (size[0] - 190)
    wide, tall = max(box.width, box.height / ratio), max(box.height, box.width * ratio)
    x, y = 0.5 * (box.left + box.right), 0.5 * (box.low + box.high)
    return Box(x - wide / 2, x + wide / 2, y - tall / 2, y + tall / 2)


def _tension_scale(result: Result, good: int) -> tuple[Normalize, str, str]:
    """Scale and colour map from frames spread over the good part, and the bar's open ends for all of it."""
    frames = np.unique(np.linspace(0, good - 1, min(good, _SAMPLED)).round().astype(int))
    live = live_segments(result, -math.inf)
    sample = [result.read("tension", int(f), int(f) + 1)[:, live] for f in frames]
    scale, name, _ = colour_scale(sample)
    found = extremes(result)
    ends = (found[f"{which} tension"].value for which in ("least", "greatest"))
    return scale, name, open_ends(scale, *ends)


def _palette(colours: matplotlib.colors.Colormap) -> Image.Image:
    """Return a palette for these pictures: tension colours, greys, and the ground's tones."""
    tones = [tuple(round(255 * part) for part in colours(i / 139)[:3]) for i in range(140)]
    # Pillow takes any colour within 8 levels of another for it: nothing else may come near white.
    pale = [tone for tone in (_mixed(tone, 0.5) for tone in tones[::4]) if min(tone) < 240]
    greys = [(level, level, level) for level in np.linspace(0, 255, 26).round().astype(int)]
    earth = [(239, 234, 228), (140, 123, 104), (189, 178, 166), (214, 206, 197)]
    found = [*greys, *earth, *tones, *pale]
    for one in (BROKEN, GIVEN):
        tone = tuple(round(255 * part) for part in to_rgb(one))
        found += [_mixed(tone, share) for share in (1.0, 0.5)]
    return make_palette([(int(r), int(g), int(b)) for r, g, b in found])


def _mixed(tone: tuple[int, ...], share: float) -> tuple[int, ...]:
    """A tone mixed with white, for soft edges."""
    return tuple(round(255 + share * (part - 255)) for part in tone)
