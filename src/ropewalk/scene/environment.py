"""What is around the ropes and acts on all of them: air, ground, limiter."""

from __future__ import annotations

from pydantic import Field, model_validator

from ropewalk.scene.base import (
    Model,
    Number,
    Vector,
    Whole,
    not_negative,
    positive,
    quantity,
    refuse,
    vector,
)
from ropewalk.scene.faults import Fault


class Air(Model):
    """Drag on nodes (linear, quadratic) and on segments (quadratic, normal and tangential).

    Segment drag per stretched length is 1/2 density x coefficient x diameter x speed^2 for
    the flow across the rope, and pi times the diameter for the flow along it.
    """

    node_drag: Number = not_negative("Linear drag of each node", "N s/m", default=0.0)
    node_drag_quadratic: Number = not_negative(
        "Quadratic drag of each node", "N s^2/m^2", default=0.0
    )
    density: Number = not_negative("Density of the air, for segment drag", "kg/m^3", default=0.0)
    normal_coefficient: Number = not_negative("Drag coefficient across the rope", "1", default=1.2)
    tangential_coefficient: Number = not_negative(
        "Drag coefficient along the rope", "1", default=0.02
    )
    wind: Vector = vector("Velocity of the air", "m/s", default=(0.0, 0.0, 0.0))

    @property
    def drags(self) -> bool:
        """Whether it drags on anything; a wind without a drag blows on nothing."""
        return bool(self.density or self.node_drag or self.node_drag_quadratic)


class Ground(Model):
    """A yielding floor as in NeHe's lesson 40, whose values are the defaults.

    NeHe's floor throws back what it has taken up: absorption acts on the way in only. With a
    ``damping_ratio`` it damps on the way out, too, and never pulls: 1 for no bounce to speak of.
    """

    height: Number = quantity("Height along up (minus gravity)", "m", default=0.0)
    repulsion: Number = positive(
        "Upward force per depth, for each node below", "N/m", default=100.0
    )
    friction: Number = not_negative(
        "Viscous friction of sliding, for each node", "N s/m", default=0.2
    )
    absorption: Number = not_negative("Friction on the way in, for each node", "N s/m", default=2.0)
    damping_ratio: Number = not_negative(
        "Damping both ways, for each node, over that at which it hardly bounces", "1", default=0.0
    )


class Limiter(Model):
    """Puts every segment back between two lengths after each step (Habrador's way).

    Implicit methods solve for the bounds instead, which then hold exactly, whatever `passes` are.
    Equal limits restore the length exactly, as a rope of position constraints.
    """

    min_stretch: Number = not_negative("Smallest length over unstretched length", "1", default=0.9)
    max_stretch: Number = positive("Largest length over unstretched length", "1", default=1.1)
    passes: Whole = Field(
        default=2, ge=1, le=10_000, description="Passes over the rope in each step"
    )

    @model_validator(mode="after")
    def _check(self) -> Limiter:
        if self.min_stretch > self.max_stretch:
            rule = f"must be at most max_stretch ({self.max_stretch:g})"
            refuse([Fault("min_stretch", self.min_stretch, rule)])
        return self
