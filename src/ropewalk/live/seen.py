"""The greatest and least of every step since the last frame: what a frame must not miss."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats, State
from ropewalk.core.peaks import (
    BEFORE,
    FORCE,
    HIGHEST,
    LEAST_TENSION,
    LOWEST,
    MOMENT,
    SPEED,
    SQUARE,
    STEPS,
    STRETCH,
    TENSION,
    WHEN,
    WITHIN,
    Peaks,
    no_peaks,
    root_of,
)
from ropewalk.methods.recording import Recording

_NOTHING = no_peaks(0, 0, 0)


class Seen(NamedTuple):
    """What was seen since the last frame, both frames included."""

    least_tension: Floats  # (s,) [N], 0 where there is no rope
    greatest_tension: Floats  # (s,) [N]
    greatest_speed: Floats  # (n,) [m/s]
    least_height: Floats  # (n,) [m], along up
    greatest_height: Floats  # (n,) [m]
    greatest_force: Floats  # (a,) [N], of anchors on the rope

    @classmethod
    def instant(cls, tension: Floats, speed: Floats, heights: Floats, force: Floats) -> Seen:
        """Return what one instant shows; `force` (a, 3)."""
        return cls(tension, tension, speed, heights, heights, np.linalg.norm(force, axis=-1))

    def joined(self, other: Seen) -> Seen:
        """Return what was seen in both."""
        return Seen(
            *(
                (np.fmin if name.startswith("least") else np.fmax)(mine, others)
                for name, mine, others in zip(self._fields, self, other, strict=True)
            )
        )


class Interval:
    """Collects what every call of a simulation's kernels has seen; begins again after a frame.

    What it holds is replaced, never changed, so that `kept` can be set aside and put back.
    """

    def __init__(self) -> None:
        self.kept: Peaks | None = None  # None: no step since it began

    def begin(self) -> None:
        """Forget all: a frame was made."""
        self.kept = None

    def take(self, peaks: Peaks) -> None:
        """Add the extremes of one call; its first and last state are in them."""
        if peaks.speed.size:
            self._add(peaks)

    def take_frames(self, frames: Recording) -> None:
        """Add those of recorded frames."""
        if not frames.speed_high.size:
            return
        squares = (frames.speed_high, frames.reaction_high, frames.moment_high)
        speed, force, moment = (values.max(axis=0) ** 2 for values in squares)
        self._add(
            _NOTHING._replace(
                tension_high=frames.tension_high.max(axis=0),
                tension_low=frames.tension_low.min(axis=0),
                stretch=frames.stretch_high.max(axis=0),
                speed=speed,
                high=frames.highest.max(axis=0),
                low=frames.lowest.min(axis=0),
                reaction=force,
                moment=moment,
                error=_error_of(frames),
                pressed=_pressed_of(frames),
            )
        )

    def _add(self, peaks: Peaks) -> None:
        known = self.kept
        if known is None or _sizes(known) != _sizes(peaks):  # or of other arrays
            known = peaks
        self.kept = _NOTHING._replace(
            error=_wider(known.error, peaks.error),
            tension_high=np.maximum(known.tension_high, peaks.tension_high),
            tension_low=np.minimum(known.tension_low, peaks.tension_low),
            stretch=np.maximum(known.stretch, peaks.stretch),
            speed=np.maximum(known.speed, peaks.speed),
            high=np.maximum(known.high, peaks.high),
            low=np.minimum(known.low, peaks.low),
            reaction=np.maximum(known.reaction, peaks.reaction),
            moment=np.maximum(known.moment, peaks.moment),
            pressed=_more_pressed(known.pressed, peaks.pressed),
        )

    def widened(self, now: Seen, live: np.ndarray) -> Seen:
        """Return what was seen, the instant `now` included; `live` (s,) tells where there is rope."""
        known = self.kept
        if known is None or known.speed.shape != now.greatest_speed.shape:
            return now
        if known.reaction.shape != now.greatest_force.shape:  # anchors have come or gone since
            return now
        return now.joined(
            Seen(
                np.where(live, known.tension_low, 0.0),
                np.where(live, known.tension_high, 0.0),
                np.sqrt(np.maximum(known.speed, 0.0)),
                known.low,
                known.high,
                np.sqrt(np.maximum(known.reaction, 0.0)),
            )
        )

    def widen(self, frame: Recording, state: State, since: float, until: float) -> None:
        """Write what was seen into a recorded frame, in place of what its last call alone has seen.

        `since` and `until` [s]: the frame before, and this one. Of an extreme of an earlier call no more is
        known than that it came in between.
        """
        known = self.kept
        if known is None or frame.speed_high.shape[1] != known.speed.size:
            return
        if frame.reaction_high.shape[1] != known.reaction.size:
            return
        roots = [
            np.sqrt(np.maximum(row, 0.0)) for row in (known.speed, known.reaction, known.moment)
        ]
        for row, seen, pick in (
            (frame.tension_high, known.tension_high, np.fmax),
            (frame.tension_low, known.tension_low, np.fmin),
            (frame.stretch_high, known.stretch, np.fmax),
            (frame.speed_high, roots[0], np.fmax),
            (frame.highest, known.high, np.fmax),
            (frame.lowest, known.low, np.fmin),
            (frame.reaction_high, roots[1], np.fmax),
            (frame.moment_high, roots[2], np.fmax),
        ):
            if row.shape[1] == seen.size:
                pick(row[0], seen, out=row[0])
        _widen_error(frame, known.error)
        if frame.pressed_high.shape[1] == known.pressed.shape[0]:
            more = _more_pressed(_pressed_of(frame), known.pressed)
            frame.pressed_high[0] = root_of(more[:, SQUARE])
            frame.pressed_time[0] = more[:, WHEN]
            frame.pressed_before[0] = root_of(more[:, BEFORE])
        live = (state.rest_length > 0.0) | (state.stiffness > 0.0)
        for which, values in (
            (TENSION, np.where(live, frame.tension_high[0], -np.inf)),
            (LEAST_TENSION, -np.where(live, frame.tension_low[0], np.inf)),
            (STRETCH, frame.stretch_high[0]),
            (SPEED, frame.speed_high[0]),
            (HIGHEST, frame.highest[0]),
            (LOWEST, -frame.lowest[0]),
            (FORCE, frame.reaction_high[0]),
            (MOMENT, frame.moment_high[0]),
        ):
            sign = -1.0 if which in (LEAST_TENSION, LOWEST) else 1.0
            values = np.where(np.isfinite(values), values, -np.inf)
            place = int(np.argmax(values)) if values.size else 0
            if values.size and values[place] > np.nan_to_num(
                sign * frame.extremes[0, which], nan=-np.inf
            ):
                frame.extremes[0, which] = sign * values[place]
                frame.extreme_places[0, which] = place
                frame.extreme_since[0, which], frame.extreme_until[0, which] = since, until


def _wider(one: Floats, other: Floats) -> Floats:
    """Return the least and greatest energy error of two and their times, as `Peaks.error`; NaN is none."""
    if one.shape != other.shape or not one.size:
        return other.copy()
    sign = np.array([[1.0], [-1.0]])
    first, second = (np.where(np.isnan(e), np.inf, sign * e)[:, :1] for e in (one, other))
    wider: Floats = np.where(first <= second, one, other)
    return wider


def _error_of(frames: Recording) -> Floats:
    """Return the least and greatest energy error of recorded frames, as `Peaks.error`."""
    found = np.full((2, 2), np.nan)
    for row in range(len(frames.error_range)):
        found = _wider(found, np.stack((frames.error_range[row], frames.error_times[row]), axis=1))
    return found


def _more_pressed(one: Floats, other: Floats) -> Floats:
    """Return the greatest forces on obstacles of two and their times, as `Peaks.pressed`."""
    if one.shape != other.shape:
        return other.copy()
    more: Floats = np.where(other[:, :1] > one[:, :1], other, one)
    return more


def _pressed_of(frames: Recording) -> Floats:
    """Return the greatest forces on obstacles of recorded frames, as `Peaks.pressed`."""
    force = np.where(np.isnan(frames.pressed_high), -np.inf, frames.pressed_high)
    at = force.argmax(axis=0), np.arange(force.shape[1])
    square = np.where(force[at] >= 0.0, force[at] ** 2, -np.inf)
    found = np.full((square.size, STEPS + WITHIN), np.nan)
    found[:, SQUARE], found[:, WHEN] = square, frames.pressed_time[at]
    found[:, BEFORE] = frames.pressed_before[at] ** 2
    return found


def _widen_error(frame: Recording, error: Floats) -> None:
    """Write the least and greatest energy error that was seen into a recorded frame."""
    if frame.error_range.shape[1]:
        own = np.stack((frame.error_range[0], frame.error_times[0]), axis=1)
        frame.error_range[0], frame.error_times[0] = _wider(own, error).T


def _sizes(peaks: Peaks) -> tuple[int, ...]:
    parts = (peaks.tension_high, peaks.speed, peaks.reaction, peaks.moment)
    return tuple(part.size for part in parts)
