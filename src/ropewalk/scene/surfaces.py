"""Reading closed surfaces of triangles, and what is wrong with those that are not closed."""

from __future__ import annotations

import warnings
from collections.abc import Iterable, Sequence
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from pydantic_core import PydanticCustomError

from ropewalk.scene.base import refuse
from ropewalk.scene.faults import MISSING, NO_VALUE, Fault
from ropewalk.scene.units import WrongUnit, in_unit

SUFFIXES = (".stl", ".obj", ".ply")
_NEEDS = 'needs the extra "mesh": pip install "ropewalk[mesh]"'
_FLAT = 1e-12  # volume over surface and size, below which a surface encloses nothing [1]
_SLOPES = (0.5, 2.0)  # between which the slope of distances next to the surface must lie [1]
_SHARED = (
    "four triangles or more meet at an edge of it: two solids, or two parts of one, share an edge there. "
    "Make them two obstacles, or keep them a little apart"
)
_DISAGREE = (
    "its neighbours disagree which side is outside, or three meet at an edge: turn all faces "
    "counter-clockwise seen from outside (a mesh editor's 'recalculate normals')"
)

_PLAIN = "save plain arrays of floats by numpy.savez(file, values=..., spacing=...)"

Triangles = tuple[list[list[float]], list[list[int]]]


def read_mesh(folder: Path, file: str) -> Triangles:
    """Return vertices and faces of a file. Refuses, inside a validator, what is no mesh (path ``file``)."""
    try:
        trimesh: Any = import_module("trimesh")
    except ImportError:
        refuse([Fault("file", file, _NEEDS)])
    path = folder / file
    suffix = path.suffix.lower()
    if suffix not in SUFFIXES:
        refuse([Fault("file", file, f"must end in {', '.join(SUFFIXES)}")])
    _refuse_absent(path, file)
    try:
        found = trimesh.load(path, file_type=suffix[1:], force="mesh", process=True)
    except IndexError:
        rule = (
            f"cannot be read as {suffix[1:].upper()}: a triangle names a vertex that the file does not have; "
            "export it again"
        )
        refuse([Fault("file", file, rule)])
    except Exception as error:  # a library's readers raise what they like
        refuse([Fault("file", file, f"cannot be read as {suffix[1:].upper()}: {error}")])
    faces = getattr(found, "faces", None)
    if faces is None or len(faces) == 0:
        kind = suffix[1:].upper()
        rule = (
            f"holds no triangles that can be read as {kind}: export it as {kind} again, with all "
            "coordinates finite numbers and faces as triangles"
        )
        refuse([Fault("file", file, rule)])
    vertices, faces = _joined(np.asarray(found.vertices, np.float64), np.asarray(faces, np.int64))
    return vertices.tolist(), faces.tolist()


def joined_where_open(vertices: Any, faces: Any) -> tuple[Triangles | None, list[Fault]]:
    """Return triangles with equal vertices made one where only that closes them, and what is wrong with them.

    None where they are left as they are. Files and many libraries have a copy of a vertex for every triangle.
    """
    faults = surface_faults(vertices, faces)
    if not faults or len(set(vertices)) == len(vertices):
        return None, faults
    corners = np.array(faces, np.int64)
    if corners.min() < 0 or corners.max() >= len(vertices):
        return None, faults
    places, corners = _joined(np.array(vertices, np.float64), corners)
    if len(corners) == 0:
        return None, faults
    return (places.tolist(), corners.tolist()), surface_faults(places, corners)


def _joined(
    vertices: NDArray[np.float64], faces: NDArray[np.int64]
) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    """Return a mesh whose equal vertices are one, without triangles of no area."""
    same, which = np.unique(vertices, axis=0, return_inverse=True)
    faces = which.ravel()[faces]
    distinct = (faces != np.roll(faces, 1, axis=1)).all(axis=1)
    return same, faces[distinct]


def _refuse_absent(path: Path, file: str) -> None:
    if path.is_dir():
        refuse([Fault("file", file, "is a folder: name a file in it")])
    if not path.exists():
        refuse([Fault("file", file, f"no such file ({path})")])


def grid_of(folder: Path, given: dict[str, Any]) -> tuple[NDArray[np.float64], float, list[float]]:
    """Return distances (nx, ny, nz), spacing and origin [m]. Refuses what is no grid."""
    file = given["file"]
    if file is not None:
        path = folder / file
        _refuse_absent(path, file)
        try:
            found = np.load(path, allow_pickle=False)
            if isinstance(found, np.ndarray):
                rule = (
                    "is one array; an .npz is needed with values (nx, ny, nz), spacing [m] and perhaps "
                    "origin [m]: numpy.savez(file, values=..., spacing=...)"
                )
                refuse([Fault("file", file, rule)])
            with found as arrays:
                given = given | {name: arrays[name] for name in arrays if given.get(name) is None}
        except PydanticCustomError:
            raise
        except Exception as error:  # zip, header or pickle
            pickled = "pickle" in str(error)  # numpy would have it read unsafely
            why = "it holds Python objects, or is no file of numpy's" if pickled else error
            refuse([Fault("file", file, f"cannot be read as .npz: {why}; {_PLAIN}")])
    shown = "" if file is None else f" (of {file})"
    if given["values"] is None or given["spacing"] is None:
        absent = "values" if given["values"] is None else "spacing"
        refuse([Fault(absent, MISSING, f"give values and spacing{shown}")])
    step, origin = in_unit(given["spacing"], "m"), in_unit(given["origin"], "m")
    for name, value in (("spacing", step), ("origin", origin)):
        if isinstance(value, WrongUnit):
            refuse([Fault(name, value.given, value.rule)])
    values = _numbers("values", given["values"], shown)
    size = _numbers("spacing", step, shown)
    corner = _numbers("origin", (0.0, 0.0, 0.0) if origin is None else origin, shown)
    if size.size != 1:
        rule = "must be one number [m]: the grid has the same spacing each way"
        refuse([Fault("spacing", size.tolist(), rule)])
    if corner.shape != (3,):
        refuse([Fault("origin", corner.tolist(), "must be three numbers [m]")])
    refuse(_grid_faults(values, float(size.item()), shown))
    return values, float(size.item()), corner.tolist()


def _numbers(name: str, given: Any, shown: str) -> NDArray[np.float64]:
    """Return what was given as an array. Refuses what are no finite numbers, by the field's name."""
    try:
        if np.iscomplexobj(given):
            raise TypeError("complex numbers are no distances")
        found = np.array(given, dtype=np.float64)
    except (TypeError, ValueError) as error:
        refuse([Fault(name, NO_VALUE, f"must be numbers{shown}: {error}")])
    if not np.isfinite(found).all():
        where = f"an array of shape {found.shape}{shown}" if found.size > 3 else found.tolist()
        refuse([Fault(name, where, "must be finite numbers")])
    return found


def _grid_faults(values: NDArray[np.float64], spacing: float, shown: str) -> Iterable[Fault]:
    """Return what is wrong with distances on a grid."""
    shape = f"an array of shape {values.shape}{shown}"
    if values.ndim != 3 or min(values.shape) < 3:
        return [Fault("values", shape, "must be (nx, ny, nz), three points or more each way")]
    if not spacing > 0.0:
        return [Fault("spacing", spacing, "must be greater than 0 (m)")]
    rim = np.ones(values.shape, bool)
    rim[1:-1, 1:-1, 1:-1] = False
    if (values[rim] < 0.0).all() and (values > 0.0).any():
        rule = (
            "are negative all round, as of a hollow: distances are positive outside the solid and negative "
            "inside; turn their signs"
        )
        return [Fault("values", shape, rule)]
    if not (values[rim] > 0.0).all():
        rule = (
            "must be positive all round: the solid must end inside the grid; make the grid larger"
        )
        return [Fault("values", shape, rule)]
    if not (values < 0.0).any():
        return [Fault("values", shape, "must be negative inside the solid: there is none")]
    slope = np.linalg.norm(np.gradient(values, spacing), axis=0)
    near = np.abs(values) < 2.0 * spacing  # nowhere, where they are millimetres
    typical = float(np.median(slope[near] if near.any() else slope))
    if not _SLOPES[0] < typical < _SLOPES[1]:
        rule = (
            f"must be distances in metres, with a slope of 1 next to the surface, not {typical:.3g}: "
            "is spacing in metres?"
        )
        return [Fault("values", shape, rule)]
    return []


def surface_of(values: NDArray[np.float64], spacing: float, origin: Sequence[float]) -> Triangles:
    """Return vertices and faces of the surface where distances on a grid are 0 (marching cubes)."""
    try:
        marching_cubes: Any = import_module("skimage.measure").marching_cubes
    except ImportError:
        refuse([Fault("values", MISSING, _NEEDS)])
    # a zero at a grid point would give triangles of no area
    grid = np.where(np.abs(values) < 1e-6 * spacing, 1e-6 * spacing, values)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        vertices, faces, _, _ = marching_cubes(
            grid, 0.0, spacing=(spacing,) * 3, gradient_direction="descent"
        )
    places, corners = _joined(np.asarray(vertices, np.float64), np.asarray(faces, np.int64))
    return (places + np.asarray(origin)).tolist(), corners.tolist()


def surface_faults(vertices: Any, faces: Any) -> list[Fault]:
    """Return what keeps triangles from being the surface of a solid."""
    places, corners = np.array(vertices, np.float64), np.array(faces, np.int64)
    if corners.min() < 0 or corners.max() >= len(places):
        rule = f"must be numbers of vertices, 0 to {len(places) - 1}"
        return [Fault("faces", f"from {corners.min()} to {corners.max()}", rule)]
    sides = np.linalg.norm(np.roll(places[corners], -1, axis=1) - places[corners], axis=2)
    size = float(np.ptp(places[corners].reshape(-1, 3), axis=0).max())
    if not size > 0.0 or sides.min() < 1e-12 * size:
        rule = "must have three sides each: two of its corners are one; join them, or take it out"
        return [Fault(f"faces[{int(np.argmin(sides.min(axis=1)))}]", "a triangle of no area", rule)]
    edges = np.stack([corners, np.roll(corners, -1, axis=1)], axis=2).reshape(-1, 2)
    each, first, times = np.unique(edges, axis=0, return_index=True, return_counts=True)
    back = {tuple(edge) for edge in edges[:, ::-1].tolist()}
    if times.max() > 1:
        worst = int(np.argmax(times))
        opposite = int((edges == each[worst, ::-1]).all(axis=1).sum())
        rule = _SHARED if opposite == times[worst] else _DISAGREE
        return [Fault(f"faces[{int(first[worst]) // 3}]", "a triangle", rule)]
    loose = [row for row, edge in enumerate(edges.tolist()) if tuple(edge) not in back]
    if loose:
        rule = (
            f"must be closed: {len(loose)} edges have a triangle on one side only, as of this one; fill the "
            "holes (a mesh editor's 'make watertight')"
        )
        return [Fault(f"faces[{loose[0] // 3}]", "an open mesh", rule)]
    return _inverted(places, corners)


def _inverted(places: NDArray[np.float64], corners: NDArray[np.int64]) -> list[Fault]:
    """Return a fault for a part that is flat, or inside out and no cavity: not within what is solid."""
    whole = places[corners]
    parts = _parts(len(places), corners)[corners[:, 0]]
    volumes, firsts = [], []
    for part in np.unique(parts):
        own = whole[parts == part]
        a, b, c = np.moveaxis(own - own.mean(axis=(0, 1)), 1, 0)
        volumes.append(float((a * np.cross(b, c)).sum()) / 6.0)
        area = 0.5 * float(np.linalg.norm(np.cross(b - a, c - a), axis=1).sum())
        if abs(volumes[-1]) <= _FLAT * area * float(np.ptp(own, axis=(0, 1)).max()):
            first = int(np.argmax(parts == part))
            rule = "encloses nothing: its sides lie on each other; give it a thickness"
            return [Fault(f"faces[{first}]", "of a flat part", rule)]
        firsts.append(int(np.argmax(parts == part)))
    for volume, first in zip(volumes, firsts, strict=True):
        if volume > 0.0 or _times_round(whole[parts != parts[first]], whole[first, 0]) > 0.5:
            continue
        rule = (
            "is inside out: faces must be counter-clockwise seen from outside; turn them round (a mesh "
            "editor's 'flip normals')"
        )
        return [Fault(f"faces[{first}]", f"of a part with a volume of {volume:.3g}", rule)]
    return []


def _times_round(triangles: NDArray[np.float64], point: NDArray[np.float64]) -> float:
    """Return how often triangles (t, 3, 3) go round a point: 1 within a solid, 0 outside it and in a cavity.

    The sum of their solid angles over that of a sphere (Van Oosterom and Strackee 1983).
    """
    a, b, c = np.moveaxis(triangles - point, 1, 0)
    x, y, z = (np.linalg.norm(side, axis=1) for side in (a, b, c))
    over = (a * np.cross(b, c)).sum(axis=1)
    under = x * y * z + (a * b).sum(axis=1) * z + (b * c).sum(axis=1) * x + (c * a).sum(axis=1) * y
    return float(np.arctan2(over, under).sum()) / (2.0 * np.pi)


def _parts(count: int, corners: NDArray[np.int64]) -> NDArray[np.int64]:
    """Return for every vertex the least one that faces join it to, (count,)."""
    least = np.arange(count)
    while True:
        before = least.copy()
        np.minimum.at(least, corners, least[corners].min(axis=1, keepdims=True))
        least = least[least]
        if (least == before).all():
            return least
