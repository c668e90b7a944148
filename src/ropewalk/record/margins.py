"""How near ropes come to breaking: utilisation, and the safety factor that is its inverse."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.scene.guess import COMPUTE, doubt_of, guesses_of, load_doubt, worst_of
from ropewalk.scene.knotted import both_doubt, knot_doubt, knotted_worst, least_worst
from ropewalk.words.safe_side import percent_up, safety_factor

if TYPE_CHECKING:
    from ropewalk.lowering import Layout
    from ropewalk.scene import Rope, Scene

_LEAST = "largest utilisation with the least of a guessed breaking load"
AT_LEAST = "it is at least that, as the stretch limiter takes no part in rest"
_OF_BOTH = f"{_LEAST}, and of what its knot leaves"


def breaking_loads(
    scene: Scene, layout: Layout, *, worst: Callable[[Rope, float], float] | None = None
) -> Floats | None:
    """Return the breaking load of every segment, (segments,) [N], inf where none is known; None of none.

    Segments between two ropes, which carry nothing, have inf. With `worst`, what a doubt makes of a rope's
    utilisation [1], the least that they may be.
    """
    if all(breaking_load(rope) is None for rope in scene.ropes):
        return None
    loads = np.full(max(layout.nodes - 1, 0), math.inf)
    for rope, span in zip(scene.ropes, layout.ropes, strict=True):
        load = breaking_load(rope)
        if load is not None:
            loads[span.first : span.last] = load / (worst(rope, 1.0) if worst else 1.0)
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


class Margin(NamedTuple):
    """The greatest utilisation, and that with the least of guessed breaking loads, of knots, and of both."""

    name: str  # of the rope that comes nearest
    utilisation: float  # [1]
    guessed: str  # the rope that comes nearest with the least of the guesses
    at_most: float  # its utilisation, with its own breaking load as it was guessed [1]
    knotted: str  # the rope that comes nearest with the least that knots leave
    untied: float  # its utilisation, of its breaking load without the knot [1]
    doubted: (
        str  # the rope that comes nearest with the least that knots leave of the least of guesses
    )
    as_given: float  # its utilisation, of its breaking load without the knot, as it was guessed [1]
    least: bool = False  # whether it is more, as rest is without a stretch limiter that would act


def margin_of(scene: Scene, utilisation: dict[str, float]) -> Margin:
    """Return the margin of ropes whose greatest utilisations [1] these are, by name; one at least."""
    name = max(utilisation, key=utilisation.__getitem__)
    found: list[Any] = [name, utilisation[name]]
    for worst in (guessed_worst, knotted_worst, least_worst):
        most = {one: worst(scene.rope_named(one), use) for one, use in utilisation.items()}
        nearest = max(most, key=lambda one: (most[one], one == name))
        found += [nearest, utilisation[nearest]]
    return Margin(*found)


def guessed_worst(rope: Rope, utilisation: float) -> float:
    """Return the utilisation [1] of a rope with the least of a guessed breaking load."""
    return worst_of(rope.made_of, utilisation)


def doubt_words(scene: Scene, margin: Margin, then: str = COMPUTE) -> str:
    """Return what guesses, knots and a limiter make of the greatest utilisation; "" where there is none.

    `then`: what is to be done about a stiffness, or was done.
    """
    least = AT_LEAST if margin.least else ""
    told = (
        least,
        guess_doubt(scene, margin, then),
        knot_words(scene, margin),
        both_words(scene, margin),
    )
    return "; ".join(text for text in told if text)


def knot_words(scene: Scene, margin: Margin) -> str:
    """As `doubt_words`, of knots alone: another rope, which is tied in one, may come nearer."""
    knot = knot_doubt(scene.rope_named(margin.knotted), margin.untied)
    if knot and margin.knotted != margin.name:
        return f"rope {margin.knotted!r} may come nearer: its breaking load is told {knot}"
    return knot


def both_words(scene: Scene, margin: Margin) -> str:
    """As `doubt_words`, of a rope that has a knot and a guessed breaking load, by both together.

    A rope that is the nearest by both, and has one of them alone, is the nearest by that one.
    """
    both = both_doubt(scene.rope_named(margin.doubted), margin.as_given)
    if both and margin.doubted != margin.name:
        return f"rope {margin.doubted!r} may come nearer: {both}"
    return both


def guess_doubt(scene: Scene, margin: Margin, then: str = COMPUTE) -> str:
    """As `doubt_words`, of guesses alone.

    Another rope, whose breaking load is a guess, may come nearer than the one that is told.
    """
    told = [doubt_of(scene.rope_named(margin.name).made_of, margin.utilisation, then)]
    if margin.guessed != margin.name:
        doubt = load_doubt(scene.rope_named(margin.guessed).made_of, margin.at_most)
        told.append(f"rope {margin.guessed!r} may come nearer: {doubt}")
    return "; ".join(text for text in told if text)


def margin_rows(margin: Margin, place: str, scene: Scene, note: str = "") -> dict[str, Any]:
    """Return the rows of a table: the largest utilisation [1] with its place, and the safety factor [1].

    With `note`, what there is to say of the tension that it is of.

    With what guesses and knots make of it, in words and, of a guessed breaking load, as numbers of the rope
    that comes nearest with the least of it, and of the one that does with its knot besides.
    """
    made_of = scene.rope_named(margin.guessed).made_of
    worst, doubt = worst_of(made_of, margin.at_most), doubt_words(scene, margin)
    doubt = "; ".join(text for text in (note, doubt) if text)
    about: dict[str, Any] = (
        {"about the largest utilisation of the breaking load": doubt} if doubt else {}
    )
    if "breaking_load" in guesses_of(made_of):
        about[f"{_LEAST} [%]"] = 100.0 * worst
        about[f"{_LEAST}, of"] = f"rope {margin.guessed!r}"
    doubted = scene.rope_named(margin.doubted)
    if both_doubt(doubted, margin.as_given):
        about[f"{_OF_BOTH} [%]"] = 100.0 * least_worst(doubted, margin.as_given)
        about[f"{_OF_BOTH}, of"] = f"rope {margin.doubted!r}"
    return {
        "largest utilisation of the breaking load [%]": 100.0 * margin.utilisation,
        "largest utilisation of the breaking load at": place,
        "least safety factor [1]": 1.0 / margin.utilisation
        if margin.utilisation > 0.0
        else math.inf,
        **about,
    }


def margin_bounds(utilisation: float, *, least: bool) -> tuple[str, str]:
    """Return a utilisation and its safety factor in words, "" unloaded; `least`: it is no less."""
    used = f"{'at least ' if least else ''}{percent_up(100.0 * utilisation, 3)}"
    most = "at most " if least else ""
    return used, f"{most}{safety_factor(utilisation)}" if utilisation > 0.0 else ""


def margin_words(
    utilisation: float, beyond: str = "it would have parted", *, least: bool = False
) -> str:
    """Return how near to breaking, as a sentence without its full stop; `beyond` it, what comes of that.

    `least`: it is no less, see `Margin`.
    """
    used, factor = margin_bounds(utilisation, least=least)
    text = f"{used} of the breaking load"
    text += f", safety factor {factor}" if factor else ""
    return text + (f"; {beyond}" if beyond and utilisation > 1.0 else "")
