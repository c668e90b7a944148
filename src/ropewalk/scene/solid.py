"""What every obstacle has: a name, friction, a compliance, a motion."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from ropewalk.scene.base import NAME, Model, Number, Text, positive, quantity
from ropewalk.scene.motions import Fixed, Told

#: A coefficient of friction beyond this is a slip of the pen.
MOST_FRICTION = 100.0

BodyMotion = Annotated[Told, Field(discriminator="kind")]


class Body(Model):
    """What all obstacles have."""

    name: Text = Field(
        default="",
        pattern=NAME,
        max_length=60,
        description='Name; default "obstacle0", "obstacle1" ..',
    )
    friction: Number = quantity(
        "Coefficient of friction, Coulomb's", "1", default=0.3, ge=0, le=MOST_FRICTION
    )
    compliance: Number | None = positive(
        "How far a node is pressed in per force, across and along; by default as little as the rope's "
        "own inertia and stiffness allow, and less the deeper",
        "m/N",
        default=None,
    )

    motion: BodyMotion = Field(
        default=Fixed(),
        description="How it moves, its middle (of a plane its point) as the node of an anchor; its direction "
        "is changed by spin only",
    )
