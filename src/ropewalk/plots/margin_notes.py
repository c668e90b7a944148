"""How near to breaking, as a note below a figure of tensions."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ropewalk.plots.style import escape
from ropewalk.record.extremes import extremes, margin
from ropewalk.record.facts import AT_REST
from ropewalk.record.margins import Margin, breaking_load, doubt_words, margin_of, margin_words
from ropewalk.scene import Rope
from ropewalk.words.safe_side import percent_up

if TYPE_CHECKING:
    from ropewalk.record.result import Result


def margin_notes(result: Result, first: int, stop: int) -> list[str]:
    """Return sentences on the rope that comes nearest to breaking in these frames; none if not known.

    One frame is an instant, after which stands what every step up to it reached, and the safety factor
    of that; with several, what steps between them reach counts, too.
    """
    if first > 0 and stop == first + 1:
        now, until = _nearest(result, first, stop), _nearest(result, 0, stop)
        if now is None or until is None:
            return []
        return [
            f"{now[0]}{percent_up(100.0 * now[3], 3)} of the breaking load at this moment.",
            f"{until[0]}{until[1]} since the start{_more(until[2])}.",
        ]
    found = _nearest(result, first, stop)
    return [] if found is None else [f"{found[0]}{found[1]}{_more(found[2])}."]


def _more(doubt: str) -> str:
    return f"; {doubt}" if doubt else ""


def _nearest(result: Result, first: int, stop: int) -> tuple[str, str, str, float] | None:
    """Return the rope that comes nearest, as words begin, how near, and what guesses make of that.

    With its utilisation [1].
    """
    found = _margin(result, first, stop)
    if found is None:
        return None
    whose = f"Rope {escape(found.name)}: " if len(result.scene.ropes) > 1 else "The rope: "
    beyond = _beyond(result, result.scene.rope_named(found.name), stop)
    near = margin_words(found.utilisation, beyond, least=found.least)
    near = near if found.least else f"at most {near}"
    return whose, near, escape(doubt_words(result.scene, found)), found.utilisation


def _margin(result: Result, first: int, stop: int) -> Margin | None:
    """Return how near these frames come; at rest as tables say, where an anchor bears more than a segment."""
    if result.status == AT_REST:
        return margin(result, extremes(result))
    shares = {}
    for rope in result.scene.ropes:
        load = breaking_load(rope)
        if load is not None:
            view = result.rope(rope.name)
            pull = (view.tension if stop == first + 1 else view.greatest_tension)[first:stop]
            largest = float(np.nanmax(np.where(np.isfinite(pull), pull, 0.0), initial=0.0))
            shares[rope.name] = largest / load
    return margin_of(result.scene, shares) if shares else None


def _beyond(result: Result, rope: Rope, stop: int) -> str:
    """Return what came of more than the breaking load up to a frame; "" of one that parts and held."""
    if not rope.made_of.parts:
        return "it would have parted"
    until = result.time[stop - 1]
    return (
        "it parted" if any(p.rope == rope.name and p.time <= until for p in result.partings) else ""
    )
