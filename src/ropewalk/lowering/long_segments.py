"""Segments so long that a rope may pass an obstacle between two of its nodes, which alone touch."""

from __future__ import annotations

import math

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.laws.obstacle import radius_of
from ropewalk.lowering.obstacle_checks import longest_kept_out
from ropewalk.scene import Rope, Scene
from ropewalk.scene.obstacles import Cylinder, Obstacle, thinnest, what_is_thin

TWICE = 2.0  # of a radius: a longer segment on it has its nodes on two sides [1]
_ALONG = math.sqrt(0.5)  # cosine of 45 degrees


def longest_about(body: Obstacle, rope: Rope) -> float:
    """Return the length from which on a rope's segments may pass a body between two nodes, or cut it [m]."""
    return min(longest_kept_out(body, rope), TWICE * (thinnest(body) + radius_of(rope)))


def long_about(scene: Scene, body: Obstacle, segments: Floats) -> Rope | None:
    """Return the rope whose segments may most pass a body between two nodes; None where none may.

    `segments` (3, s) are those that there are, as drawn [m]: of a disc only what goes along its axis counts.
    Each rope has its own thickness: a thick one elsewhere helps no thin one.
    """
    flat = isinstance(body, Cylinder) and what_is_thin(body) == "half length"
    if isinstance(body, Cylinder) and flat and not _goes_along(segments, body):
        return None
    rope = max(scene.ropes, key=lambda one: one.segment_length / longest_about(body, one))
    return rope if rope.segment_length > longest_about(body, rope) else None


def _goes_along(segments: Floats, body: Cylinder) -> bool:
    """Tell whether some segment is drawn rather along a cylinder's axis than across it."""
    axis = np.subtract(body.end, body.start)
    sizes = np.linalg.norm(segments, axis=0) * np.linalg.norm(axis)
    return bool((np.abs(axis @ segments) > _ALONG * sizes).any())
