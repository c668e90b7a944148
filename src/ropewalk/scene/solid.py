"""What every obstacle has: a name, friction, a compliance, a motion."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

from pydantic import Field

from ropewalk.scene.base import NAME, Many, Model, Number, Text, listed, positive, quantity
from ropewalk.scene.motions import Fixed, Told
from ropewalk.scene.rubbing import Pair, coefficient

if TYPE_CHECKING:
    from ropewalk.scene.rope import Rope

BodyMotion = Annotated[Told, Field(discriminator="kind")]


class Body(Model):
    """What all obstacles have."""

    name: Text = Field(
        default="",
        pattern=NAME,
        max_length=60,
        description='Name; default "obstacle0", "obstacle1" ..',
    )
    friction: Number = coefficient(
        "Coefficient of friction, Coulomb's; the larger of this and the rope's own holds",
        default=0.3,
    )
    pairs: Many[Pair] = listed(
        "Coefficients of friction with single ropes, which hold instead",
        "pair",
        "pairs",
        default=(),
    )
    compliance: Number | None = positive(
        "How far a node is pressed in per force, across and along; by default as little as the rope's "
        "own inertia and stiffness allow, and less the deeper",
        "m/N",
        default=None,
    )

    restitution: Number = quantity(
        "Share of the speed across the surface with which a free node leaves that hits it; what sticks "
        "meanwhile may leave backwards along it, by up to some 30 % of what it came with; asks for a "
        "`compliance` and the method `adaptive`",
        "1",
        default=0.0,
        ge=0,
        le=1,
    )
    motion: BodyMotion = Field(
        default=Fixed(),
        description="How it moves, its middle (of a plane its point) as the node of an anchor; its direction "
        "is changed by spin only",
    )

    def friction_with(self, rope: Rope) -> float:
        """Return the coefficient of friction of a rope on this body [1]."""
        for pair in self.pairs:
            if pair.rope == rope.name:
                return pair.friction
        return max(self.friction, rope.friction)
