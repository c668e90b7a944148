"""Numbers of a recording, packed small: whole multiples of a step, differences in time, deflate.

The page's `recording.js` does the same backwards. A column that moves smoothly has small second differences,
one that jumps has smaller first ones; whichever packs better is taken. Differences are split into bytes of
equal weight, which deflate likes better than whole numbers.
"""

from __future__ import annotations

import zlib
from dataclasses import dataclass

import numpy as np

from ropewalk.core.arrays import Floats, Ints

LARGEST = 2**29  # of a multiple; second differences of it still fit in 32 bits
_LEVEL = 9
_STEPS = 4000  # of tension, speed and force from their lowest to their highest value
_FINEST = 1e-4  # of the step of all columns: what is smaller beside them may be rounding


@dataclass(frozen=True)
class Packed:
    """One stream: `rows` times `columns` numbers.

    Attributes:
        low, step: a number is `low[column] + step[column] * multiple`.
        order: of the differences, 1 or 2.
        planes: bytes per difference.
        data: deflated.
        error: largest distance between a number and what is unpacked as 32-bit float.
    """

    name: str
    columns: int
    low: list[float]
    step: list[float]
    order: int
    planes: int
    data: bytes
    error: float

    def header(self) -> dict[str, object]:
        """Return what the page must know of it."""
        return {
            "name": self.name,
            "columns": self.columns,
            "low": self.low,
            "step": self.step,
            "order": self.order,
            "planes": self.planes,
            "bytes": len(self.data),
        }


def step_of(values: Floats) -> float:
    """Return the usual step for values: a small share of their range."""
    span = float(np.ptp(values)) if values.size else 0.0
    largest = float(np.abs(values).max(initial=0.0))
    return max(span, 1e-6 * largest) / _STEPS or 1.0


def steps_of(values: Floats, groups: Ints) -> Floats:
    """Return steps of columns (c,), each group (c,) by its own range, as light ropes beside heavy ones."""
    least = _FINEST * step_of(values)
    found = np.full(len(groups), least)
    for group in np.unique(groups):
        own = groups == group
        found[own] = max(step_of(values[:, own]), least) if values[:, own].any() else least
    return found


def pack(name: str, values: Floats, step: Floats | float, *, zero: bool = False) -> Packed:
    """Pack finite values (rows, columns) to within half a step (of all, or per column).

    The lowest of each column is exact, or with `zero` what is zero, where zero says that nothing is there.

    Raises ValueError when a value is too many steps from the column's lowest.
    """
    rows, columns = values.shape
    low = values.min(axis=0) if rows else np.zeros(columns)
    steps = np.broadcast_to(np.asarray(step, float), columns)
    if zero:
        low = np.floor(low / steps) * steps
    multiples = np.rint((values - low) / steps)
    if multiples.size and multiples.max() > LARGEST:
        raise ValueError(f"{name}: values too far apart for their step")
    whole = multiples.astype(np.int64)
    back = (low + steps * whole).astype(np.float32).astype(float)
    best: tuple[bytes, int, int] | None = None
    for order in (1, 2):
        data, planes = _deflate(whole, order)
        if best is None or len(data) < len(best[0]):
            best = data, order, planes
    assert best is not None
    error = float(np.abs(back - values).max(initial=0.0))
    return Packed(name, columns, low.tolist(), steps.tolist(), best[1], best[2], best[0], error)


def _deflate(whole: np.ndarray, order: int) -> tuple[bytes, int]:
    differences = whole
    for _ in range(order):
        differences = np.diff(differences, axis=0, prepend=0)
    zigzag = np.where(differences < 0, -2 * differences - 1, 2 * differences).astype("<u4")
    by_column = np.ascontiguousarray(zigzag.T)
    planes = max(1, (int(by_column.max(initial=0)).bit_length() + 7) // 8)
    parts = [((by_column >> (8 * plane)) & 255).astype(np.uint8) for plane in range(planes)]
    return zlib.compress(b"".join(part.tobytes() for part in parts), _LEVEL), planes


def unpack(packed: Packed, rows: int) -> Floats:
    """Return the values (rows, columns) as the page sees them."""
    raw = np.frombuffer(zlib.decompress(packed.data), np.uint8)
    parts = raw.reshape(packed.planes, packed.columns, rows).astype(np.int64)
    zigzag = sum(parts[plane] << (8 * plane) for plane in range(packed.planes))
    differences = np.where(zigzag % 2 == 1, -((zigzag + 1) // 2), zigzag // 2).T
    for _ in range(packed.order):
        differences = np.cumsum(differences, axis=0)
    values: Floats = np.asarray(packed.low) + np.asarray(packed.step) * differences
    return values
