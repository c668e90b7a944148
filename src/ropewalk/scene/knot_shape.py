"""A knot as the initial shape of a rope, and the post or ring about which it is tied."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, ClassVar, Literal, cast

import numpy as np
from pydantic import Field, model_validator

from ropewalk.knots.tying import MOST_SLACK, Tied, faults, knot, named
from ropewalk.scene.base import Number, Vector, Whole, positive, quantity, refuse, vector
from ropewalk.scene.faults import MISSING, Fault
from ropewalk.scene.obstacles import Cylinder, Torus
from ropewalk.scene.shape_model import ShapeModel
from ropewalk.scene.sheet_numbers import given

if TYPE_CHECKING:
    from ropewalk.core.arrays import Floats

Name = Literal[
    "overhand", "figure-eight", "reef", "granny", "bowline",
    "clove-hitch", "two-half-hitches", "prusik", "munter", "bollard",
]  # fmt: skip
_SIZES = ("slack", "post_radius", "ring_radius", "turns")


class Knot(ShapeModel):
    """A knot, loosely tied in a rope of its diameter, whose straight ends are as long as the rope has left.

    A reef and a granny are tied in two ropes, each with this shape. A hitch needs its post as an obstacle.
    """

    of_diameter: ClassVar[bool] = True

    kind: Literal["knot"] = "knot"
    knot: Name = Field(description="Which knot")
    rope: Whole = Field(
        default=1,
        ge=1,
        le=2,
        description="Which of its ropes this is",
        json_schema_extra={"unit": "1"},
    )
    slack: Number = quantity(
        "How loose it is; a knot without a post is so many times as large",
        "1",
        default=1.0,
        ge=1,
        le=MOST_SLACK,
    )
    post_radius: Number | None = positive("Radius of what a hitch is tied about", "m", default=None)
    ring_radius: Number | None = positive(
        "Radius of a ring whose bar the post of a munter is; without it the post is straight",
        "m",
        default=None,
    )
    turns: Number | None = positive(
        "Turns of a bollard (2), or of a prusik to each side (3)", "1", default=None
    )
    center: Vector = vector("Its middle; a hitch's on the axis of the post", "m", default=(0, 0, 0))
    along: Vector = vector(
        "Direction in which the rope comes (any length but zero)", "1", default=(1, 0, 0)
    )
    normal: Vector = vector(
        "Axis of the post; what a knot without a post lies across", "1", default=(0, 0, 1)
    )
    first_end: Number | None = positive(
        "Length of the straight end at the rope's start; by default both are as long",
        "m",
        default=None,
    )
    velocity: Vector = vector("Initial velocity of all nodes", "m/s", default=(0, 0, 0))

    @model_validator(mode="after")
    def _check(self) -> Knot:
        sizes: tuple[Any, ...] = tuple(getattr(self, key) for key in _SIZES)
        found = [
            Fault(path, MISSING if value is None else value, rule)
            for path, value, rule in faults(self.knot, None, *sizes)
        ]
        two = self.knot in ("reef", "granny")
        if self.rope > 1 and not two:
            found.append(Fault("rope", self.rope, f"leave it out: {named(self.knot)} has one rope"))
        found += [
            Fault(path, getattr(self, path), "must not be zero")
            for path in ("along", "normal")
            if not any(getattr(self, path))
        ]
        if not found and self._across() is None:
            found.append(Fault("normal", self.normal, "must not point the way that along does"))
        refuse(found)
        return self

    def _across(self) -> Floats | None:
        """Return the directions of x, y and z of the drawn knot [1], (3, 3), one a row; None without any."""
        along, normal = (np.array(v, float) / np.abs(v).max() for v in (self.along, self.normal))
        z = normal / np.linalg.norm(normal)
        x = along - (along @ z) * z
        size = float(np.linalg.norm(x))
        if size < 1e-6 * float(np.linalg.norm(along)):
            return None
        x /= size
        return np.array([x, np.cross(z, x), z])

    def tied(self, diameter: float) -> Tied:
        """Return the knot of a rope so thick [m]. Raises ValueError where it cannot be tied in it."""
        return knot(
            self.knot,
            diameter,
            slack=self.slack,
            post_radius=self.post_radius,
            ring_radius=self.ring_radius,
            turns=self.turns,
        )

    def faults(self, diameter: float, segments: int, length: float) -> list[Fault]:
        """Return what keeps a rope of that diameter and length [m] from being tied in it."""
        sizes: tuple[Any, ...] = tuple(getattr(self, key) for key in _SIZES)
        found = [
            Fault(f"shape.{path}", value, rule)
            for path, value, rule in faults(self.knot, diameter, *sizes)
        ]
        if found:
            return found
        fault = self.tied(diameter).fault(segments, length, self.first_end)
        return [] if fault is None else [Fault(*fault)]

    def post(self, length: float | str = 1.0, **fields: Any) -> Cylinder | Torus:
        """Return the post of a hitch as an obstacle, a torus where it is a ring.

        Args:
            length: of a straight post [m], its middle at `center`; also a text, such as "30 cm".
            fields: others of the obstacle, such as `friction` or `name`.

        Raises ValueError for a knot without a post, and SceneError for a length that is none.
        """
        length = given("length", length, "m")
        across = self._across()
        if self.post_radius is None or across is None:
            raise ValueError(f"knot: {self.knot} - has no post")
        _, y, z = across
        center = np.array(self.center, float)
        if self.ring_radius is not None:
            middle = center + self.ring_radius * y
            return Torus(
                center=middle.tolist(),
                axis=across[0].tolist(),
                radius=self.ring_radius,
                bar_radius=self.post_radius,
                **fields,
            )
        start, end = center - 0.5 * length * z, center + 0.5 * length * z
        return Cylinder(start=start.tolist(), end=end.tolist(), radius=self.post_radius, **fields)

    def axis(self, reach: float) -> Floats:
        """Return places on what a hitch is tied about [m], (3, 3): its middle, and so far to each side.

        The middle is the second; along the bar of a ring where it has one.
        """
        _, y, z = cast("Floats", self._across())
        steps, ring = np.array([-reach, 0.0, reach]), self.ring_radius
        bent = [(0.0, s) for s in steps]
        if ring is not None:
            bent = [(ring * (1.0 - np.cos(s / ring)), ring * np.sin(s / ring)) for s in steps]
        return np.asarray(np.array(self.center) + np.array(bent) @ np.array([y, z]))

    def places(
        self,
        segments: int,
        length: float,
        segment_length: float,
        up: Sequence[float],
        diameter: float,
    ) -> Floats:
        """See `ShapeModel.places`."""
        drawn = self.tied(diameter).points(segments, length, self.rope, self.first_end)
        return np.asarray(np.array(self.center) + drawn @ cast("Floats", self._across()))
