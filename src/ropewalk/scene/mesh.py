"""Obstacles of any form: closed surfaces of triangles, from a file or from distances on a grid."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import Field, ValidationInfo, model_validator

from ropewalk.scene.base import (
    Many,
    Number,
    Text,
    Vector,
    Whole,
    not_negative,
    positive,
    refuse,
    vector,
)
from ropewalk.scene.faults import MISSING, NO_VALUE, Fault
from ropewalk.scene.spin import Tumbling

#: No mesh has more; what has is to be made coarser.
MOST_FACES = 200_000
_Corners = Annotated[Many[Whole], Field(min_length=3, max_length=3)]


class _Surface(Tumbling):
    """What has a surface of triangles. It turns about ``axis`` through its position."""

    vertices: Many[Vector] = Field(
        default=(),
        description="Corners of the triangles, in a frame of their own and in units of scale",
        json_schema_extra={"unit": "1"},
    )
    faces: Many[_Corners] = Field(
        default=(),
        description="Three vertices of each triangle, from 0, counter-clockwise seen from outside",
    )
    scale: Number = positive("Length of their unit, 0.001 for millimetres", "m", default=1.0)
    position: Vector = vector("Where the origin of its frame is", "m", default=(0, 0, 0))
    rotation: Vector = vector(
        "How its frame is turned: along the axis, as long as the angle", "rad", default=(0, 0, 0)
    )
    rounding: Number = not_negative(
        "By how much it is made larger, so that its edges are round", "m", default=0.0
    )

    def _check_surface(self, source: str) -> None:
        from ropewalk.scene.surfaces import joined_where_open

        if not self.vertices or not self.faces:
            refuse([Fault("file", MISSING, f"give {source}, or vertices and faces")])
        if len(self.faces) > MOST_FACES:
            rule = f"must be at most {MOST_FACES}: make it coarser"
            refuse([Fault("faces", f"{len(self.faces)} triangles", rule)])
        joined, faults = joined_where_open(self.vertices, self.faces)
        refuse(faults)
        if joined is not None:
            vertices, faces = joined
            self.__dict__["vertices"] = tuple(map(tuple, vertices))
            self.__dict__["faces"] = tuple(map(tuple, faces))


class Mesh(_Surface):
    """A solid of any form, as a closed surface of triangles.

    A file (STL, OBJ or PLY; needs the extra "mesh") is read at once; the scene no longer needs it.
    """

    kind: Literal["mesh"] = "mesh"
    file: Text | None = Field(
        default=None, description="STL, OBJ or PLY file with the triangles (read at load)"
    )

    @model_validator(mode="before")
    @classmethod
    def _read(cls, data: Any, info: ValidationInfo) -> Any:
        if not isinstance(data, dict) or not isinstance(data.get("file"), str):
            return data
        if "vertices" in data or "faces" in data:
            refuse([Fault("file", data["file"], "give either file or vertices and faces")])
        from ropewalk.scene.csv_columns import folder_of
        from ropewalk.scene.surfaces import read_mesh

        vertices, faces = read_mesh(folder_of(info), data["file"])
        rest = {key: value for key, value in data.items() if key != "file"}
        return rest | {"vertices": vertices, "faces": faces}

    @model_validator(mode="after")
    def _check(self) -> Mesh:
        self._check_surface("file")
        return self


class Sdf(_Surface):
    """A solid of any form, from distances to its surface on a grid, negative inside.

    The surface is found at once as triangles (needs the extra "mesh"), by marching cubes; the scene no
    longer needs the grid. A file is an .npz with ``values`` (nx, ny, nz), ``spacing`` and perhaps ``origin``.
    """

    kind: Literal["sdf"] = "sdf"
    file: Text | None = Field(
        default=None, description=".npz file with values, spacing, origin (read at load)"
    )
    values: Any = Field(
        default=None,
        description="Distances to the surface [m], negative inside, (nx, ny, nz) (taken at once)",
    )
    spacing: Number | None = positive("Between the points of the grid", "m", default=None)
    origin: Vector = vector(
        "The grid's first point in the frame of the solid", "m", default=(0, 0, 0)
    )

    @model_validator(mode="before")
    @classmethod
    def _read(cls, data: Any, info: ValidationInfo) -> Any:
        if not isinstance(data, dict) or not isinstance(data.get("file", ""), str | None):
            return data  # the field says what is wrong with it
        given = [name for name in ("file", "values") if data.get(name) is not None]
        if not given:
            return data
        if len(given) > 1 or "vertices" in data or "faces" in data:
            rule = "give one of file, values, or vertices and faces"
            shown = data["file"] if given[0] == "file" else NO_VALUE
            refuse([Fault(given[0], shown, rule)])
        from ropewalk.scene.csv_columns import folder_of
        from ropewalk.scene.surfaces import grid_of, surface_of

        own = ("file", "values", "spacing", "origin")
        grid = grid_of(folder_of(info), {name: data.get(name) for name in own})
        rest = {key: value for key, value in data.items() if key not in own}
        vertices, faces = surface_of(*grid)
        return rest | {"vertices": vertices, "faces": faces}

    @model_validator(mode="after")
    def _check(self) -> Sdf:
        self._check_surface("file, values with spacing")
        return self
