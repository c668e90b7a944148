"""Frames for the page: where everything lies, and writing it. See docs/reference/live-protocol.md."""

from __future__ import annotations

import struct
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.live.hands import MOST_GRABS, Grab

MAGIC = 0x46505752
HEADER = struct.Struct("<IIIIddfffI")
PLAYING, BROKEN, SLOW, GRABBED, END = 1, 2, 4, 8, 16
SCALARS = (
    "time", "dt", "kinetic", "gravity", "elastic", "lost", "put_in", "energy_error", "tension_low",
    "tension_high", "tension_max", "strain_max", "speed_high", "low", "high", "touching",
    "difference", "difference_max",
)  # fmt: skip
_TINY = 1e-30


class Places(NamedTuple):
    """Where the parts of one variant begin in a frame [bytes]."""

    scalars: int
    positions: int
    tension: int
    speed: int
    anchors: int
    grabs: int


@dataclass(frozen=True)
class Shape:
    """Sizes of one variant: nodes and anchors."""

    nodes: int
    anchors: int

    def places(self, start: int) -> tuple[Places, int]:
        """Return where the parts lie from `start` on, and where the next variant begins."""
        half = 4 * ((self.nodes + 1) // 2)
        sizes = (4 * len(SCALARS), 12 * self.nodes, half, half, 40 * self.anchors, 32 * MOST_GRABS)
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
        spot, place = Shape(len(picture.positions), len(picture.anchors)).places(place)
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
    n = len(picture.positions)
    low = min(float(picture.tension.min(initial=0.0)), 0.0)
    high = max(float(picture.tension.max(initial=0.0)), low + _TINY, _TINY)
    fast = max(float(picture.speed.max(initial=0.0)), _TINY)
    scalars = picture.scalars | {"tension_low": low, "tension_high": high, "speed_high": fast}
    _view(data, spot.scalars, len(SCALARS))[:] = [scalars.get(name, 0.0) for name in SCALARS]
    _view(data, spot.positions, 3 * n).reshape(n, 3)[:] = picture.positions
    _quantise(picture.tension, low, high, data, spot.tension)
    _quantise(picture.speed, 0.0, fast, data, spot.speed)
    _view(data, spot.anchors, picture.anchors.size)[:] = picture.anchors.ravel()
    grabs = _view(data, spot.grabs, 8 * MOST_GRABS).reshape(MOST_GRABS, 8)
    grabs[:, 0] = -1.0
    for row, grab in enumerate(picture.grabs[:MOST_GRABS]):
        grabs[row, 0], grabs[row, 1:4], grabs[row, 4:7] = grab.node, grab.target, grab.force


def _view(data: bytearray, offset: int, count: int) -> Any:
    """Return a part of a frame as floats, to write to."""
    return np.frombuffer(data, "<f4", count, offset)


def _quantise(values: Floats, low: float, high: float, data: bytearray, offset: int) -> None:
    """Write values as shares of 65535 between low and high, which hold them all."""
    scaled = (values - low) * (65535.0 / (high - low)) + 0.5
    np.frombuffer(data, "<u2", len(values), offset)[:] = scaled.clip(0.0, 65535.0)
