"""How near ropes come to breaking: utilisation, and the safety factor that is its inverse."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from ropewalk.core.arrays import Floats

if TYPE_CHECKING:
    from ropewalk.lowering import Layout
    from ropewalk.scene import Scene


def breaking_loads(scene: Scene, layout: Layout) -> Floats | None:
    """Return the breaking load of every segment, (segments,) [N], inf where none is known; None of none.

    Segments between two ropes, which carry nothing, have inf.
    """
    loads = np.full(max(layout.nodes - 1, 0), math.inf)
    for rope, span in zip(scene.ropes, layout.ropes, strict=True):
        load = breaking_load(rope)
        if load is not None:
            loads[span.first : span.last] = load
    return loads if np.isfinite(loads).any() else None


def utilisations(tension: Floats, loads: Floats) -> Floats:
    """Return tensions over breaking loads, (frames, segments) [1]; -inf where no load is known."""
    found = np.full(tension.shape, -math.inf)
    np.divide(tension, loads, out=found, where=np.isfinite(loads))
    return found


def breaking_load(rope: Any) -> float | None:
    """Return the breaking load of a rope of a scene [N], None where it is not known."""
    found: float | None = getattr(rope.made_of, "breaking_load", None)
    return found


def margin_rows(utilisation: float, place: str) -> dict[str, Any]:
    """Return the rows of a table: the largest utilisation [1] with its place, and the safety factor [1]."""
    return {
        "largest utilisation of the breaking load [%]": 100.0 * utilisation,
        "largest utilisation of the breaking load at": place,
        "least safety factor [1]": 1.0 / utilisation if utilisation > 0.0 else math.inf,
    }


def margin_words(utilisation: float, beyond: str = "it would have parted") -> str:
    """Return how near to breaking, as a sentence without its full stop; `beyond` it, what comes of that."""
    text = f"{100.0 * utilisation:.3g} % of the breaking load"
    if utilisation > 0.0:
        text += f", safety factor {1.0 / utilisation:.3g}"
    return text + (f"; {beyond}" if beyond and utilisation > 1.0 else "")
