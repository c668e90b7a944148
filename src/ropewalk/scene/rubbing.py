"""Coefficients of friction of pairs: of a rope and what it touches, of two ropes.

The larger of both holds, as surfaces are rough to each other, but where a pair has a number of its own.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

from pydantic import Field

from ropewalk.scene.base import Model, Number, Text, quantity
from ropewalk.scene.faults import Fault
from ropewalk.words.nearest import nearest

if TYPE_CHECKING:
    from ropewalk.scene.obstacles import Obstacle
    from ropewalk.scene.rope import Rope
    from ropewalk.scene.rope_contact import Contact

#: A coefficient of friction beyond this is a slip of the pen.
MOST_FRICTION = 100.0


def coefficient(description: str, *, default: Any = ...) -> Any:
    """A coefficient of Coulomb's friction [1]."""
    return quantity(description, "1", default=default, ge=0, le=MOST_FRICTION)


class Pair(Model):
    """The friction of one rope with an obstacle, whatever either has with others."""

    rope: Text = Field(description="Name of the rope")
    friction: Number = coefficient("Coefficient of friction of the two, Coulomb's")


class RopePair(Model):
    """The friction of two ropes with each other, or of one with itself, whatever they have with others."""

    rope: Text = Field(description="Name of one rope")
    other: Text = Field(description="Name of the other rope; of the same, where it touches itself")
    friction: Number = coefficient("Coefficient of friction of the two, Coulomb's")


def of_pieces(pairs: Sequence[Pair], name: str, pieces: Sequence[str]) -> list[Pair]:
    """Return the pairs with an obstacle once a rope of that name is in pieces: each is as rough as it was."""
    return [
        pair.replace(rope=one)
        for pair in pairs
        for one in (pieces if pair.rope == name else [pair.rope])
    ]


def between_pieces(pairs: Sequence[RopePair], name: str, pieces: Sequence[str]) -> list[RopePair]:
    """Return the pairs of ropes once one of that name is in pieces: each is as rough as the whole was."""
    found: dict[frozenset[str], RopePair] = {}
    for pair in pairs:
        for one in pieces if pair.rope == name else [pair.rope]:
            for other in pieces if pair.other == name else [pair.other]:
                found[frozenset((one, other))] = pair.replace(rope=one, other=other)
    return list(found.values())


def pair_faults(
    obstacles: Sequence[Obstacle | None], contact: Contact | None, ropes: Sequence[Rope | None]
) -> Iterator[Fault]:
    """Yield the faults of pairs that name no rope, or one twice; None is a part that is faulty in itself."""
    names = [rope.name for rope in ropes if rope is not None]
    tables: list[tuple[str, Sequence[Pair | RopePair]]] = [
        (f"obstacle[{i}]", body.pairs) for i, body in enumerate(obstacles) if body is not None
    ]
    if contact is not None:
        tables.append(("contact", contact.pairs))
    for path, pairs in tables:
        seen: dict[frozenset[str], int] = {}
        for i, pair in enumerate(pairs):
            here = f"{path}.pair[{i}]"
            own = {"rope": pair.rope}
            if isinstance(pair, RopePair):
                own["other"] = pair.other
            for key, name in own.items():
                if name not in names and None not in ropes:
                    yield Fault(f"{here}.{key}", name, f"is no rope; {nearest(name, names)}")
            first = seen.setdefault(frozenset(own.values()), i)
            if first != i:
                rule = f"is told by {path}.pair[{first}] already: leave out one of the two"
                yield Fault(f"{here}.rope", pair.rope, rule)
