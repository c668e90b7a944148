"""Contact of ropes with each other and with themselves."""

from __future__ import annotations

from collections.abc import Sequence

from ropewalk.scene.base import Model, Number, positive, quantity
from ropewalk.scene.faults import MISSING, Fault
from ropewalk.scene.rope import Rope
from ropewalk.scene.solid import MOST_FRICTION


class Contact(Model):
    """Lets ropes touch each other and themselves, with Coulomb friction; none passes through another.

    Every rope needs the diameter of its material.
    """

    friction: Number = quantity(
        "Coefficient of friction of rope on rope, Coulomb's",
        "1",
        default=0.2,
        ge=0,
        le=MOST_FRICTION,
    )
    compliance: Number | None = positive(
        "How far two ropes are pressed into each other per force, across and along; by default as little as "
        "their own inertia and stiffness allow, and less the deeper",
        "m/N",
        default=None,
    )


def contact_faults(contact: Contact | None, ropes: Sequence[Rope]) -> list[Fault]:
    """The faults of a scene whose ropes touch each other."""
    if contact is None:
        return []
    rule = (
        "is needed where ropes touch each other: give the rope its diameter, or leave out contact"
    )
    return [
        Fault(f"rope[{i}].diameter", MISSING, rule)
        for i, rope in enumerate(ropes)
        if "diameter" not in rope.model_fields_set
    ]
