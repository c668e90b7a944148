"""A knot as the initial shape of a rope, and the post or ring about which it is tied."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, ClassVar, Literal, cast

import numpy as np
from pydantic import Field, model_validator

from ropewalk.knots.tying import MOST_SLACK, Tied, faults, knot, named
from ropewalk.scene.base import (
    Number,
    Vector,
    Whole,
    not_negative,
    positive,
    quantity,
    refuse,
    vector,
)
from ropewalk.scene.faults import MISSING, NO_DIRECTION, Fault
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
    first_end: Number | None = not_negative(
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
            Fault(path, getattr(self, path), NO_DIRECTION)
            for path in ("along", "normal")
            if not any(getattr(self, path))
        ]
        if not found and self._across() is None:
            rule = "must not point along `along`: give a direction across it"
            found.append(Fault("normal", self.normal, rule))
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
            Fault(path if path == "diameter" else f"shape.{path}", value, rule)
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

        Raises ValueError for a knot without a post and for fields that the shape gives itself, and SceneError
        for a length that is none.
        """
        length = given("length", length, "m")
        across = self._across()
        if self.post_radius is None or across is None:
            raise ValueError(f"knot: {self.knot} - has no post")
        x, y, z = across
        center, ring = np.array(self.center, float), self.ring_radius
        own: dict[str, Any] = {"radius": self.post_radius}
        kind: type[Cylinder | Torus] = Cylinder
        if ring is None:
            own["start"], own["end"] = (
                (center - 0.5 * length * z).tolist(),
                (center + 0.5 * length * z).tolist(),
            )
        else:
            kind, own = Torus, {"radius": ring, "bar_radius": self.post_radius, "axis": x.tolist()}
            own["center"] = (center + ring * y).tolist()
        for name in own:
            if name in fields:
                raise ValueError(f"{name}: {fields[name]!r} - leave it out: the shape gives it")
        return kind(**own, **fields)

    def sections(self, diameter: float, many: int) -> Floats:
        """Return where the surface of a hitch's post is to be [m], (3, 1 + many, 3), by the rope's diameter.

        At the middle of its turns and at both ends of them: the place on the post's axis, and `many` about
        it. Along the bar of a ring where it has one.
        """
        x, y, z = cast("Floats", self._across())
        reach, ring = self.tied(diameter).reach, self.ring_radius
        angles = 2.0 * np.pi * np.arange(many)[:, None] / many
        found = []
        for way in (-reach, 0.0, reach):
            middle, outwards = np.array(self.center) + way * z, y
            if ring is not None:
                turn = way / ring
                outwards = np.cos(turn) * y - np.sin(turn) * z
                middle = np.array(self.center) + ring * (y - outwards)
            circle = np.cos(angles) * x + np.sin(angles) * outwards
            found.append(np.concatenate([[middle], middle + (self.post_radius or 0.0) * circle]))
        return np.array(found)

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
