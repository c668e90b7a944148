"""Contact of ropes with each other and with themselves."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from ropewalk.scene.base import Many, Model, Number, listed, positive, quantity
from ropewalk.scene.faults import MISSING, Fault
from ropewalk.scene.rope import Rope
from ropewalk.scene.rubbing import RopePair, coefficient

if TYPE_CHECKING:
    from ropewalk.core.arrays import Floats, Ints


class Contact(Model):
    """Lets ropes touch each other and themselves, with Coulomb friction; none passes through another.

    Every rope needs the diameter of its material.
    """

    friction: Number = coefficient(
        "Coefficient of friction of rope on rope, Coulomb's; the largest of this and both ropes' own holds",
        default=0.2,
    )
    pairs: Many[RopePair] = listed(
        "Coefficients of friction of two ropes each, which hold instead",
        "pair",
        "pairs",
        default=(),
    )
    compliance: Number | None = positive(
        "How far two ropes are pressed into each other per force, across and along; by default as little as "
        "their own inertia and stiffness allow, and less the deeper",
        "m/N",
        default=None,
    )
    restitution: Number = quantity(
        "Share of the speed across the contact with which segments part that hit each other, of two on their "
        "own; asks for a `compliance` and the method `adaptive`",
        "1",
        default=0.0,
        ge=0,
        le=1,
    )

    def frictions_of(self, ropes: Sequence[Rope], one: Ints, other: Ints) -> Floats:
        """Return the coefficients of friction of c pairs of ropes [1], (c,).

        Args:
            ropes: those of the scene.
            one: numbers of the first ropes among them, (c,).
            other: numbers of the second ones, (c,).
        """
        own = np.array([rope.friction for rope in ropes])
        found: Floats = np.maximum(self.friction, np.maximum(own[one], own[other]))
        names = {rope.name: number for number, rope in enumerate(ropes)}
        for pair in self.pairs:
            first, second = names[pair.rope], names[pair.other]
            found[((one == first) & (other == second)) | ((one == second) & (other == first))] = (
                pair.friction
            )
        return found

    def frictions(self, ropes: Sequence[Rope]) -> Floats:
        """Return the coefficients of friction of r ropes on each other and on themselves, (r, r) [1]."""
        every = np.indices((len(ropes), len(ropes)))
        return self.frictions_of(ropes, every[0], every[1])


def contact_faults(contact: Contact | None, ropes: Sequence[Rope | None]) -> list[Fault]:
    """The faults of a scene whose ropes touch each other; None is a rope that is faulty in itself."""
    if contact is None:
        return []
    rule = (
        "is needed where ropes touch each other: give the rope its diameter, or leave out contact"
    )
    return [
        Fault(f"rope[{i}].diameter", MISSING, rule)
        for i, rope in enumerate(ropes)
        if rope is not None and "diameter" not in rope.model_fields_set
    ]
