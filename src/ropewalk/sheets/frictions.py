"""Coefficients of friction in words: one number, or what differs from pair to pair."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ropewalk.scene import Contact, Obstacle, Rope

_MOST_NAMED = 4  # pairs with one coefficient


def friction_on(body: Obstacle, ropes: Sequence[Rope]) -> str:
    """Say how rough an obstacle is to ropes."""
    pairs = [(f"rope {rope.name!r}", body.friction_with(rope)) for rope in ropes]
    return _words(pairs)


def friction_between(contact: Contact, ropes: Sequence[Rope]) -> str:
    """Say how rough ropes are to each other and to themselves."""
    table = contact.frictions(ropes)
    if len(np.unique(table)) == 1:
        return _words([("", float(table[0, 0]))])
    pairs = []
    for i, j in np.argwhere(np.tri(len(ropes)) > 0.0).tolist():
        one, other = ropes[j].name, ropes[i].name
        said = f"rope {one!r} on itself" if i == j else f"rope {one!r} on {other!r}"
        pairs.append((said, float(table[i, j])))
    return _words(pairs)


def _words(pairs: Sequence[tuple[str, float]]) -> str:
    """Say coefficients of friction: of several each with its pairs, the commonest last."""
    whose: dict[float, list[str]] = {}
    for said, value in pairs:
        whose.setdefault(value, []).append(said)
    if len(whose) == 1:
        return f"a coefficient of friction of {pairs[0][1]:g}"
    told = [
        f"{value:g} ({', '.join(whose[value][:_MOST_NAMED])}"
        + (f" and {more} more)" if (more := len(whose[value]) - _MOST_NAMED) > 0 else ")")
        for value in sorted(whose, key=lambda value: len(whose[value]))
    ]
    return f"coefficients of friction of {', '.join(told[:-1])} and {told[-1]}"
