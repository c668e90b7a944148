"""Contact of ropes with each other and with themselves."""

from __future__ import annotations

from collections.abc import Sequence

from ropewalk.scene.base import Model, Number, positive, quantity
from ropewalk.scene.faults import MISSING, NO_VALUE, Fault
from ropewalk.scene.rope import Rope
from ropewalk.scene.solid import MOST_FRICTION
from ropewalk.scene.winch import Winch


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


def contact_faults(
    contact: Contact | None,
    ropes: Sequence[Rope],
    winches: Sequence[Winch],
) -> list[Fault]:
    """The faults of a scene whose ropes touch each other."""
    if contact is None:
        return []
    rule = (
        "is needed where ropes touch each other: give the rope its diameter, or leave out contact"
    )
    found = [
        Fault(f"rope[{i}].diameter", MISSING, rule)
        for i, rope in enumerate(ropes)
        if "diameter" not in rope.model_fields_set
    ]
    found += [
        Fault(
            f"rope[{i}].made_of.parts",
            True,
            "cannot work with ropes that touch each other yet: what has parted would still be touched; "
            "leave out parts, or contact",
        )
        for i, rope in enumerate(ropes)
        if rope.made_of.parts
    ]
    if winches:
        rule = (
            "cannot work with a winch, which takes nodes onto its drum after the way of a step was looked "
            "at: leave out the winches, or contact"
        )
        found.append(Fault("contact", NO_VALUE, rule))
    return found
