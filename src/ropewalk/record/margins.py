"""How near ropes come to breaking: utilisation, and the safety factor that is its inverse."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.scene.guess import doubt_of, guesses_of

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


def doubt_words(scene: Scene, nearest: str, utilisation: float) -> str:
    """Return what guessed breaking loads make of the greatest utilisation [1], that of the rope `nearest`.

    "" where none is a guess. Another rope whose load is one may come nearer than it.
    """
    made_of = scene.rope_named(nearest).made_of
    told = [doubt_of(made_of, utilisation)]
    also = ", too" if "breaking_load" in guesses_of(made_of) else ""
    for rope in scene.ropes:
        mark = guesses_of(rope.made_of).get("breaking_load")
        if mark is not None and rope.name != nearest:
            told.append(f"the breaking load of rope {rope.name!r} is a guess{also}, {mark.span}")
    return "; ".join(text for text in told if text)


def margin_rows(utilisation: float, place: str, doubt: str) -> dict[str, Any]:
    """Return the rows of a table: the largest utilisation [1] with its place, and the safety factor [1].

    `doubt` is what guesses make of it, in words.
    """
    about = {"about the largest utilisation of the breaking load": doubt} if doubt else {}
    return {
        "largest utilisation of the breaking load [%]": 100.0 * utilisation,
        "largest utilisation of the breaking load at": place,
        "least safety factor [1]": 1.0 / utilisation if utilisation > 0.0 else math.inf,
        **about,
    }


def margin_words(utilisation: float, beyond: str = "it would have parted") -> str:
    """Return how near to breaking, as a sentence without its full stop; `beyond` it, what comes of that."""
    text = f"{100.0 * utilisation:.3g} % of the breaking load"
    if utilisation > 0.0:
        text += f", safety factor {1.0 / utilisation:.3g}"
    return text + (f"; {beyond}" if beyond and utilisation > 1.0 else "")
