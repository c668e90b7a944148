"""The plane that a shape lies in: that of the sag of every rope, wherever beside each other they hang."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.lowering import Model
from ropewalk.scene.bound_ropes import bound_ropes

_FLAT = 0.02  # of the extent: a shape no thicker than this is plane [1]
_STRAIGHT = 1e-8  # of the extent: a shape narrower than this is a straight line [1]
_SLIGHT = 1e-4  # of the extent: sag of which a plane of its own is not asked [1]
_TILTED = 0.1  # sine of the angle between planes that are told as one [1]


class Plane(NamedTuple):
    """How ropes lie, each with those that joints tie to it, or slides hang on it."""

    normal: Floats  # (3,) unit vector
    flat: bool  # whether all lie in planes of this normal
    upright: tuple[
        bool, ...
    ]  # (ropes,) which hang straight along the weight: any upright plane is theirs


class _Cloud(NamedTuple):
    """The nodes of ropes that are bound to each other, about their mean."""

    points: Floats  # (3, k) [m]
    along: Floats  # (3,) direction of its largest extent
    across: Floats  # (3,) and of the next one
    sizes: Floats  # (3,) root of the sums of squares in its three directions [m]

    @property
    def straight(self) -> bool:
        return bool(self.sizes[1] <= _STRAIGHT * max(self.sizes[0], 1e-300))

    def lies_across(self, normal: Floats) -> bool:
        """Tell whether it lies in a plane of a normal, and that is its own where it sags."""
        thick, (length, width, least) = float(np.linalg.norm(normal @ self.points)), self.sizes
        tilted = width > _SLIGHT * length and thick > _TILTED * width + 1.01 * least
        return bool(thick <= _FLAT * length) and not tilted


def plane_of(model: Model, x: Floats) -> Plane:
    """Return the plane of a shape `x` (3, n): that of the rope which sags most, in which all others lie, too.

    A straight shape lies in the upright plane through it; an upright one in any, of which one is taken: that
    of all where they stand side by side.
    """
    up, alive = np.array(model.scene.up), model.state.mass > 0.0
    upright = [False] * len(model.layout.ropes)
    clouds, hanging = [], 0
    for group in bound_ropes(model.scene):
        nodes = np.zeros(x.shape[1], dtype=bool)
        for i in group:
            span = model.layout.ropes[i]
            nodes[span.start : span.end + 1] = True
        nodes &= alive
        if not nodes.any():
            continue
        if bool(np.any(model.system.gravity)) and _is_upright(x[:, nodes], up):
            hanging += 1
            for i in group:
                upright[i] = True
        clouds.append(_cloud(x[:, nodes]))
    if hanging == len(clouds):
        clouds = [_cloud(x[:, alive])]
    normal = _normal(clouds, up)
    return Plane(normal, all(one.lies_across(normal) for one in clouds), tuple(upright))


def _cloud(places: Floats) -> _Cloud:
    points = places - places.mean(axis=1, keepdims=True)
    axes, sizes, _ = np.linalg.svd(points, full_matrices=False)
    axes = np.hstack([axes, np.zeros((3, 3 - axes.shape[1]))])
    return _Cloud(points, axes[:, 0], axes[:, 1], np.append(sizes, np.zeros(3 - sizes.size)))


def _normal(clouds: list[_Cloud], up: Floats) -> Floats:
    """Return the unit normal (3,) of the widest of these; of straight ones that of the upright plane."""
    widest = max(clouds, key=lambda one: float(one.sizes[1]) * (not one.straight))
    normal = np.cross(widest.along, widest.across)
    if widest.straight:
        sides = [np.cross(one.along, up) for one in clouds]
        normal = max(sides, key=lambda side: float(np.linalg.norm(side)))
        if np.linalg.norm(normal) < 1e-6:
            normal = np.cross(up, np.eye(3)[int(np.argmin(np.abs(up)))])
    normal = normal / np.linalg.norm(normal)
    lead = normal[int(np.argmax(np.abs(normal)))]
    return np.asarray(normal * np.sign(lead))


def _is_upright(places: Floats, up: Floats) -> bool:
    points = (places - places[:, :1]).T
    aside = points - np.outer(points @ up, up)
    size = float(np.abs(points).max(initial=0.0))
    return bool(np.abs(aside).max(initial=0.0) <= 1e-6 * size)
