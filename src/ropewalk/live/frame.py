"""Frames for the page: where everything lies, and writing it. See docs/reference/live-protocol.md."""

from __future__ import annotations

import math
import struct
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.live.hands import MOST_GRABS, Grab
from ropewalk.live.seen import Seen
from ropewalk.live.touch import NO_ROOM, NOTHING, PAIR, WRAP, Room, Touch

MAGIC = 0x46505752
HEADER = struct.Struct("<IIIIddfffI")
PLAYING, BROKEN, SLOW, GRABBED, END = 1, 2, 4, 8, 16
#: How far the first obstacles that turn freely have turned [rad]: less than a whole turn.
TURNS = tuple(f"turn{number}" for number in range(16))
SCALARS = (
    "time", "dt", "kinetic", "gravity", "elastic", "lost", "put_in", "energy_error", "tension_low",
    "tension_high", "tension_max", "strain_max", "speed_high", "low", "high", "touching",
    "difference", "difference_max", *TURNS, "rope_contacts", "rope_contact_force", "wraps", "wrap_age",
    "energy_off", "energy_turned",
)  # fmt: skip
_TINY = 1e-30


class Places(NamedTuple):
    """Where the parts of one variant begin in a frame [bytes]."""

    scalars: int
    positions: int
    tension: int
    speed: int
    least_tension: int
    greatest_tension: int
    greatest_speed: int
    least_height: int
    greatest_height: int
    greatest_force: int
    anchors: int
    contact: int
    rope_contacts: int
    wraps: int
    friction_work: int
    grabs: int


@dataclass(frozen=True)
class Shape:
    """Sizes of one variant: nodes and anchors, and what there is to touch."""

    nodes: int
    anchors: int
    touch: Room = NO_ROOM

    def places(self, start: int) -> tuple[Places, int]:
        """Return where the parts lie from `start` on, and where the next variant begins."""
        half = 4 * ((self.nodes + 1) // 2)
        seen = (*(half,) * (len(Seen._fields) - 1), 4 * self.anchors)
        lines = (12 * self.nodes, half, half, *seen)
        room = self.touch
        rows = (4 * PAIR * room.pairs, 4 * WRAP * room.wraps, 4 * room.surfaces)
        touch = (12 * self.nodes if room.forces else 0, *rows)
        sizes = (4 * len(SCALARS), *lines, 40 * self.anchors, *touch, 32 * MOST_GRABS)
        found = [start]
        for size in sizes:
            found.append(found[-1] + size)
        return Places(*found[:-1]), found[-1]


class Picture(NamedTuple):
    """What a frame shows of one variant."""

    scalars: dict[str, float]
    positions: Floats  # (n, 3) [m]
    tension: Floats  # (s,) [N], 0 where there is no rope
    speed: Floats  # (n,) [m/s]
    anchors: Floats  # (a, 10)
    grabs: list[Grab]
    seen: Seen  # since the last frame
    touch: Touch = NOTHING


def turns_of(wheels: Floats) -> dict[str, float]:
    """Return how far obstacles have turned that turn freely, rows of `wheel_rows.RECORDED`, as scalars."""
    return {name: float(angle) for name, angle in zip(TURNS, wheels[:, 0] % math.tau, strict=False)}


class Ranges(NamedTuple):
    """Between what the numbers of a variant are written; scalars of the frame."""

    tension_low: float
    tension_high: float
    speed_high: float
    low: float
    high: float

    def of(self, part: str) -> tuple[float, float]:
        """Return the range of a part of the frame."""
        if part.endswith("tension"):
            return self.tension_low, self.tension_high
        return (0.0, self.speed_high) if part.endswith("speed") else (self.low, self.high)


class Clockwork(NamedTuple):
    """What the header says."""

    layout: int
    frame: int
    flags: int
    time: float
    steps: int
    realtime: float
    speed: float
    load: float


def encode(head: Clockwork, pictures: list[Picture]) -> bytes:
    """Return a frame."""
    place = HEADER.size
    spots = []
    for picture in pictures:
        sizes = len(picture.positions), len(picture.anchors), picture.touch.room
        spot, place = Shape(*sizes).places(place)
        spots.append(spot)
    data = bytearray(place)
    HEADER.pack_into(
        data, 0, MAGIC, head.layout & 0xFFFFFFFF, head.frame & 0xFFFFFFFF, head.flags, head.time,
        float(head.steps), head.realtime, head.speed, head.load, 0,
    )  # fmt: skip
    with np.errstate(over="ignore", invalid="ignore"):
        for spot, picture in zip(spots, pictures, strict=True):
            _write(data, spot, picture)
    return bytes(data)


def _write(data: bytearray, spot: Places, picture: Picture) -> None:
    n, seen = len(picture.positions), picture.seen
    low = min(float(seen.least_tension.min(initial=0.0)), 0.0)
    high = max(float(seen.greatest_tension.max(initial=0.0)), low + _TINY, _TINY)
    fast = max(float(seen.greatest_speed.max(initial=0.0)), _TINY)
    bottom, top = picture.scalars["low"], picture.scalars["high"]
    ranges = {"tension_low": low, "tension_high": high, "speed_high": fast}
    scalars = picture.scalars | picture.touch.scalars | ranges
    _view(data, spot.scalars, len(SCALARS))[:] = [scalars.get(name, 0.0) for name in SCALARS]
    _view(data, spot.positions, 3 * n).reshape(n, 3)[:] = picture.positions
    _quantise(picture.tension, low, high, data, spot.tension)
    _quantise(picture.speed, 0.0, fast, data, spot.speed)
    _write_seen(data, spot, seen, Ranges(low, high, fast, bottom, top))
    _view(data, spot.anchors, picture.anchors.size)[:] = picture.anchors.ravel()
    _write_touch(data, spot, picture.touch)
    grabs = _view(data, spot.grabs, 8 * MOST_GRABS).reshape(MOST_GRABS, 8)
    grabs[:, 0] = -1.0
    for row, grab in enumerate(picture.grabs[:MOST_GRABS]):
        grabs[row, 0], grabs[row, 7] = grab.node, grab.most
        grabs[row, 1:4], grabs[row, 4:7] = grab.target, grab.force


def _write_touch(data: bytearray, spot: Places, touch: Touch) -> None:
    if touch.force is not None:
        _view(data, spot.contact, touch.force.size)[:] = np.nan_to_num(touch.force).ravel()
    _view(data, spot.rope_contacts, touch.pairs.size)[:] = touch.pairs.ravel()
    _view(data, spot.wraps, touch.wraps.size)[:] = touch.wraps.ravel()
    _view(data, spot.friction_work, touch.rubbed.size)[:] = touch.rubbed


def _write_seen(data: bytearray, spot: Places, seen: Seen, ranges: Ranges) -> None:
    for name, values in zip(Seen._fields, seen, strict=True):
        if name != "greatest_force":
            _quantise(values, *ranges.of(name), data, getattr(spot, name))
    _view(data, spot.greatest_force, seen.greatest_force.size)[:] = seen.greatest_force


def combined(shapes: Sequence[Shape], older: bytes, newer: bytes) -> bytes:
    """Return the newer frame with what was seen since the one before the older, which nobody gets.

    The newer one as it is where they are not written alike.
    """
    place = HEADER.size
    spots = []
    for shape in shapes:
        spot, place = shape.places(place)
        spots.append((shape, spot))
    if not (len(older) == len(newer) == place and older[4:8] == newer[4:8]):
        return newer
    data = bytearray(newer)
    with np.errstate(over="ignore", invalid="ignore"):
        for shape, spot in spots:
            _combine(data, older, shape, spot)
    return bytes(data)


def _combine(data: bytearray, older: bytes, shape: Shape, spot: Places) -> None:
    """Widen one variant's part of a frame by that of an older one."""
    (before, seen_before, _), (after, seen, own) = (
        _read(frame, shape, spot) for frame in (bytearray(older), data)
    )
    wide = Ranges(
        *(
            (np.fmin if name in ("tension_low", "low") else np.fmax)(getattr(before, name), value)
            for name, value in after._asdict().items()
        )
    )
    scalars = _view(data, spot.scalars, len(SCALARS))
    for name, value in wide._asdict().items():
        scalars[SCALARS.index(name)] = value
    at = SCALARS.index("tension_max")
    scalars[at] = np.fmax(scalars[at], np.frombuffer(older, "<f4", 1, spot.scalars + 4 * at)[0])
    for name, values in own.items():
        _quantise(values, *wide.of(name), data, getattr(spot, name))
    _write_seen(data, spot, seen.joined(seen_before), wide)


def _read(data: bytearray, shape: Shape, spot: Places) -> tuple[Ranges, Seen, dict[str, Floats]]:
    """Return the ranges of one variant's part of a frame, what was seen, and the instant's own."""
    scalars = _view(data, spot.scalars, len(SCALARS)).astype(float)
    ranges = Ranges(*(scalars[SCALARS.index(name)] for name in Ranges._fields))

    def values(name: str) -> Floats:
        low, high = ranges.of(name)
        raw = np.frombuffer(data, "<u2", shape.nodes, getattr(spot, name))
        return low + raw.astype(float) * ((high - low) / 65535.0)

    found = {name: values(name) for name in Seen._fields if name != "greatest_force"}
    force = _view(data, spot.greatest_force, shape.anchors).astype(float)
    seen = Seen(**found, greatest_force=force)
    return ranges, seen, {name: values(name) for name in ("tension", "speed")}


def _view(data: bytearray, offset: int, count: int) -> Any:
    """Return a part of a frame as floats, to write to."""
    return np.frombuffer(data, "<f4", count, offset)


def _quantise(values: Floats, low: float, high: float, data: bytearray, offset: int) -> None:
    """Write values as shares of 65535 between low and high, which hold them all."""
    scaled = (values - low) * (65535.0 / max(high - low, _TINY)) + 0.5
    np.frombuffer(data, "<u2", len(values), offset)[:] = scaled.clip(0.0, 65535.0)
