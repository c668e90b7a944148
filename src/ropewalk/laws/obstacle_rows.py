"""Obstacles of a scene as rows of numbers: which kind, where, how large, how they turn."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.laws.obstacle_shapes import (
    BOX,
    CAPSULE,
    CYLINDER,
    HALF_PIPE,
    MESH,
    PLANE,
    SPHERE,
    TORUS,
)
from ropewalk.laws.triangle_rows import mesh_row
from ropewalk.motions.registry import FIXED
from ropewalk.motions.rows import Motions, motion_rows
from ropewalk.motions.whereabouts import place_now

KINDS = {
    "plane": PLANE,
    "sphere": SPHERE,
    "cylinder": CYLINDER,
    "capsule": CAPSULE,
    "box": BOX,
    "torus": TORUS,
    "half-pipe": HALF_PIPE,
    "mesh": MESH,
    "sdf": MESH,
}


_ROUND = 1e-9  # [1] by which an axle may be off the axis of what is round


def wherever(bodies: Sequence[Any], places: Sequence[Any]) -> tuple[Floats, Floats, Motions]:
    """Return the middles and hubs of bodies at time zero, (k, 3) each [m], and how they move."""
    count = len(bodies)
    centers = np.array([place[0] for place in places], dtype=np.float64).reshape(count, 3)
    hubs = np.array([hub_of(body) for body in bodies], dtype=np.float64).reshape(count, 3)
    motion = motion_rows([body.motion for body in bodies], centers)
    for moved in np.flatnonzero(motion.kind != FIXED):  # a table has places of its own
        there = np.array(place_now(motion, moved, 0.0)[:3])
        hubs[moved] += there - centers[moved]
        centers[moved] = there
    return centers, hubs, motion


def wheel_columns(bodies: Sequence[Any], gravity: Floats) -> dict[str, Any]:
    """Return the columns of what turns freely, see `Obstacles`; `gravity` (3,) [m/s^2]."""
    spins = [body.spin for body in bodies]
    free = [row for row, spin in enumerate(spins) if spin is not None and spin.free]
    wheel = np.full(len(spins), -1, np.int64)
    wheel[free] = np.arange(len(free))
    found: dict[str, Any] = {"wheel": wheel}
    for name in ("inertia", "bearing", "viscous", "rate"):
        column = [getattr(spins[row], name) or 0.0 for row in free]
        found[name] = np.array(column, dtype=np.float64)
    weights = [weight_of(bodies[row], gravity) for row in free]
    found["weight"] = np.array(weights, dtype=np.float64).reshape(len(free), 2)
    return found


def weight_of(body: Any, gravity: Floats) -> tuple[float, float]:
    """Return the torque of a body's weight about its axle as it starts, and a quarter of a turn on [N m]."""
    spin = body.spin
    if spin.mass is None:
        return 0.0, 0.0
    axle, pull = axle_of(body), spin.mass * gravity
    where = place_of(body)[0] if spin.center_of_mass is None else spin.center_of_mass
    arm = np.array(where, dtype=np.float64) - hub_of(body)
    return float(axle @ np.cross(arm, pull)), float(axle @ np.cross(np.cross(axle, arm), pull))


def place_of(body: Any) -> tuple[Any, Any, Any]:
    """Return centre [m], axis [1] and size [m] of an obstacle, see `Obstacles`."""
    match body.kind:
        case "plane":
            return body.point, _unit(body.normal), (0.0, 0.0, 0.0, 0.0)
        case "sphere":
            return body.center, _unit(body.axis), (body.radius, 0.0, 0.0, 0.0)
        case "torus":
            return body.center, _unit(body.axis), (body.radius, body.bar_radius, 0.0, 0.0)
        case "box":
            inner = [half - body.edge_radius for half in body.half_sizes]
            edges = turned_by(body.rotation, np.eye(3))
            return body.center, edges[2], (*inner, body.edge_radius, *map(float, edges[0]))
        case "mesh" | "sdf":
            row = mesh_row(corners_of(body), np.array(body.faces, np.int64), body.rounding)
            return body.position, (0.0, 0.0, 1.0), row
    start, end = np.array(body.start, dtype=np.float64), np.array(body.end, dtype=np.float64)
    if body.kind == "half-pipe":
        axis, above = _unit(end - start), _unit(body.open_to)
        above = _unit(above - (above @ axis) * axis)
        return start, axis, (body.radius, *map(float, above))
    half = 0.5 * float(np.linalg.norm(end - start))
    if body.kind == "cylinder" and body.endless:
        half = math.inf
    return 0.5 * (start + end), _unit(end - start), (body.radius, half, 0.0, 0.0)


def axle_of(body: Any) -> Any:
    """Return the unit vector about which an obstacle turns."""
    if body.spin is not None and body.spin.axis is not None:
        return _unit(body.spin.axis)
    return _unit(body.axis) if body.kind in ("box", "mesh", "sdf") else place_of(body)[1]


def hub_of(body: Any) -> Floats:
    """Return a point of the axis about which an obstacle turns (3,) [m], where it starts."""
    spin = body.spin
    own = place_of(body)[0] if spin is None or spin.pivot is None else spin.pivot
    return np.array(own, dtype=np.float64)


def sweeps(body: Any) -> bool:
    """Tell whether an obstacle's surface leaves its place as it turns: it is not round about its axle."""
    if body.kind in ("box", "half-pipe", "mesh", "sdf"):
        return True
    middle, axis, _ = place_of(body)
    aside = hub_of(body) - np.array(middle, dtype=np.float64)
    if body.kind == "sphere":
        axis = axle_of(body)
    elif np.linalg.norm(np.cross(axis, axle_of(body))) > _ROUND:
        return True
    off = float(np.linalg.norm(np.cross(axis, aside)))
    return body.kind != "plane" and off > _ROUND * float(body.radius)


def radius_round(body: Any) -> float:
    """Return the least radius about which a rope may lie [m]: inf of a plane, 0 of sharp edges."""
    if body.kind == "plane":
        return math.inf
    name = {"torus": "bar_radius", "box": "edge_radius", "mesh": "rounding", "sdf": "rounding"}
    return float(getattr(body, name.get(body.kind, "radius")))


def corners_of(body: Any) -> Floats:
    """Return the vertices of a mesh about the origin of its frame, (v, 3) [m]."""
    found: Floats = turned_by(body.rotation, body.scale * np.array(body.vertices, np.float64))
    return found


def turned_by(rotation: Any, places: Floats) -> Floats:
    """Return places (v, 3) turned about an axis by its length [rad] (Rodrigues' formula)."""
    angle = float(np.linalg.norm(rotation))
    if angle == 0.0:
        return places
    axis = np.array(rotation) / angle
    c, s = math.cos(angle), math.sin(angle)
    along = (places @ axis)[:, None] * axis
    return c * places + s * np.cross(axis, places) + (1.0 - c) * along


def size_rows(sizes: Sequence[Any]) -> Floats:
    """Return the sizes of all, one row each, (k, 4) or as wide as the largest mesh needs."""
    width = max([4, *map(len, sizes)])
    found = np.zeros((len(sizes), width))
    for row, size in enumerate(sizes):
        found[row, : len(size)] = size
    return found


def _unit(direction: Any) -> Floats:
    found = np.array(direction, dtype=np.float64)
    found /= np.abs(found).max()
    unit: Floats = found / np.linalg.norm(found)
    return unit


def spin_of(body: Any) -> tuple[float, float, float]:
    """Return what turns at one rate [rad/s], and from when to when [s]."""
    spin = body.spin
    if spin is None or spin.rate is None or spin.free:
        return 0.0, 0.0, math.inf
    return spin.rate, spin.start, spin.stop


def turning_of(body: Any) -> Any:
    """Return the angles of what turns by a table, as a motion along x; None else."""
    spin = body.spin
    return spin.as_motion() if spin is not None and spin.times else None


def half_thickness(body: Any) -> float:
    """Return half of how thick a solid is at least [m]: inf where it has no other side.

    A mesh may be as thin as can be, but for its rounding.
    """
    match body.kind:
        case "plane" | "half-pipe":
            return math.inf
        case "box":
            return float(min(body.half_sizes))
        case "cylinder" if not body.endless:
            return min(body.radius, 0.5 * math.dist(body.start, body.end))
    return radius_round(body)
