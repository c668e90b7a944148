"""Initial shapes: where the nodes of a rope are, and how fast they move, at time zero.

Each is a `ShapeModel`, of which `places` is all that the engine asks. The union at the end names them all.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, Annotated, Any, Literal

import numpy as np
from pydantic import Field, ValidationInfo, model_validator

from ropewalk.scene.base import Many, Number, Text, Vector, positive, refuse, vector
from ropewalk.scene.faults import MISSING, NO_DIRECTION, NO_VALUE, Fault
from ropewalk.scene.knot_shape import Knot
from ropewalk.scene.limits import HUGE
from ropewalk.scene.shape_model import ShapeModel

if TYPE_CHECKING:
    from ropewalk.core.arrays import Floats

_ZERO = (0.0, 0.0, 0.0)
_VELOCITY = "Initial velocity of all nodes"


class Straight(ShapeModel):
    """A straight line of evenly spaced nodes.

    Without ``end`` the rope lies at its unstretched length from ``start`` along ``direction``
    (default +x); with ``end`` it is stretched or slack to fit between the two points.
    """

    kind: Literal["straight"] = "straight"
    start: Vector = vector("Place of the first node", "m", default=_ZERO)
    end: Vector | None = vector("Place of the last node", "m", default=None)
    direction: Vector | None = vector(
        "Direction from the first node to the last", "1", default=None
    )
    velocity: Vector = vector(_VELOCITY, "m/s", default=_ZERO)

    @model_validator(mode="after")
    def _check(self) -> Straight:
        faults = []
        if self.end is not None and self.direction is not None:
            faults.append(Fault("direction", self.direction, "give either end or direction"))
        elif self.end is not None and tuple(self.end) == tuple(self.start):
            faults.append(Fault("end", self.end, "must be another point than start"))
        elif self.direction is not None and not any(self.direction):
            faults.append(Fault("direction", self.direction, NO_DIRECTION))
        refuse(faults)
        return self

    def places(
        self,
        segments: int,
        length: float,
        segment_length: float,
        up: Sequence[float],
        diameter: float,
    ) -> Floats:
        """See `ShapeModel.places`."""
        start = np.array(self.start, dtype=np.float64)
        if self.end is not None:
            share = np.arange(segments + 1) / segments
            return np.asarray(start + share[:, None] * (np.array(self.end) - start))
        way = np.array(self.direction or (1.0, 0.0, 0.0), dtype=np.float64)
        way /= np.linalg.norm(way)
        # node by node, so that a rope at rest length has no stretch from rounding
        return start + np.arange(segments + 1)[:, None] * (segment_length * way)


class Polyline(ShapeModel):
    """Nodes evenly spaced by arc length along a line through given corner points."""

    kind: Literal["polyline"] = "polyline"
    points: Many[Vector] = Field(
        description="Corner points, two or more", json_schema_extra={"unit": "m"}
    )
    velocity: Vector = vector(_VELOCITY, "m/s", default=_ZERO)

    @model_validator(mode="after")
    def _check(self) -> Polyline:
        if len(self.points) < 2:
            refuse([Fault("points", self.points, "must have at least 2 points")])
        refuse(coincident(self.points))
        return self

    def places(
        self,
        segments: int,
        length: float,
        segment_length: float,
        up: Sequence[float],
        diameter: float,
    ) -> Floats:
        """See `ShapeModel.places`."""
        from ropewalk.scene.shape_lines import along_polyline

        share = np.arange(segments + 1) / segments
        return along_polyline(np.array(self.points, dtype=np.float64), share)


class Hanging(ShapeModel):
    """Straight along gravity from ``start``, the first node on top, at unstretched length."""

    kind: Literal["hanging"] = "hanging"
    start: Vector = vector("Place of the first node, on top", "m", default=_ZERO)
    velocity: Vector = vector(_VELOCITY, "m/s", default=_ZERO)

    def places(
        self,
        segments: int,
        length: float,
        segment_length: float,
        up: Sequence[float],
        diameter: float,
    ) -> Floats:
        """See `ShapeModel.places`."""
        share = np.arange(segments + 1) / segments
        along = share[:, None] * length * -np.array(up)
        return np.asarray(self.start + along, dtype=np.float64)


class Slack(ShapeModel):
    """A smooth sagging curve (catenary) between two points, of the rope's own length; straight if shorter.

    With `sag` it has that sag whatever the rope's length: so a rope hangs that its own weight has stretched.
    """

    kind: Literal["slack"] = "slack"
    start: Vector = vector("Place of the first node", "m", default=_ZERO)
    end: Vector = vector("Place of the last node", "m")
    sag: Number | None = positive(
        "Largest drop below the straight line between the ends; of the rope's own length when left out",
        "m",
        default=None,
    )
    velocity: Vector = vector(_VELOCITY, "m/s", default=_ZERO)

    @model_validator(mode="after")
    def _check(self) -> Slack:
        if tuple(self.end) == tuple(self.start):
            refuse([Fault("end", self.end, "must be another point than start")])
        return self

    @property
    def span(self) -> float:
        """Distance between the two ends [m]."""
        return math.dist(self.start, self.end)

    def places(
        self,
        segments: int,
        length: float,
        segment_length: float,
        up: Sequence[float],
        diameter: float,
    ) -> Floats:
        """See `ShapeModel.places`."""
        from ropewalk.scene.shape_lines import catenary_points, length_of_sag

        start, end, down = np.array(self.start, float), np.array(self.end, float), -np.array(up)
        share = np.arange(segments + 1) / segments
        arc = length if self.sag is None else length_of_sag(start, end, self.sag, down)
        return catenary_points(start, end, arc, down, share)


class Points(ShapeModel):
    """One given point per node, inline or from a CSV file with columns x, y, z.

    A file is read at once and its points kept; the scene no longer needs it afterwards.
    """

    kind: Literal["points"] = "points"
    file: Text | None = Field(
        default=None, description="CSV file with columns x, y, z, one row per node (read at load)"
    )
    points: Many[Vector] = Field(
        default=(), description="Place of each node", json_schema_extra={"unit": "m"}
    )
    velocity: Vector = vector(_VELOCITY, "m/s", default=_ZERO)

    @model_validator(mode="before")
    @classmethod
    def _read(cls, data: Any, info: ValidationInfo) -> Any:
        from ropewalk.scene.csv_columns import folder_of, read_columns

        if not isinstance(data, dict) or not isinstance(data.get("file"), str):
            return data
        if "points" in data:
            refuse([Fault("points", NO_VALUE, "give either file or points, not both")])
        columns = read_columns(folder_of(info), data["file"], dict.fromkeys("xyz", "m"))
        rest = {key: value for key, value in data.items() if key != "file"}
        return rest | {"points": list(zip(*columns, strict=True))}

    @model_validator(mode="after")
    def _check(self) -> Points:
        if not self.points:
            refuse([Fault("points", MISSING, "give points = [[x, y, z], ...] or file")])
        refuse(coincident(self.points))
        return self

    def places(
        self,
        segments: int,
        length: float,
        segment_length: float,
        up: Sequence[float],
        diameter: float,
    ) -> Floats:
        """See `ShapeModel.places`."""
        return np.array(self.points, dtype=np.float64)


def coincident(points: Many[Vector]) -> list[Fault]:
    """A fault for every point that lies on the one before it."""
    rule = "must not lie on the point before it"
    return [
        Fault(f"points[{i + 1}]", b, rule)
        for i, (a, b) in enumerate(pairwise(points))
        if not 0.0 < math.dist(a, b) < HUGE * HUGE
    ]


Shape = Annotated[
    Straight | Polyline | Hanging | Slack | Points | Knot, Field(discriminator="kind")
]
