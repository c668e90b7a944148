"""Where points lie from the surface of a body, by formulas of the tests' own."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

from ropewalk.scene import Shake, Velocity


def moved(body: Any, time: np.ndarray) -> np.ndarray:
    """Return how far a body has gone at these times [m], (frames, 3)."""
    motion = body.motion
    if isinstance(motion, Shake):
        axis = np.array(motion.axis) / math.hypot(*motion.axis)
        turns = 2.0 * math.pi * motion.frequency * time + motion.phase
        return motion.amplitude * (np.sin(turns) - math.sin(motion.phase))[:, None] * axis
    assert isinstance(motion, Velocity)
    going = np.clip(time, motion.start, motion.stop) - motion.start
    return going[:, None] * np.array(motion.velocity)


def outside(body: Any, x: np.ndarray) -> np.ndarray:
    """Return the distance of points from a body where it is drawn [m], (...) of (..., 3); < 0 within."""
    if body.kind == "plane":
        normal = np.array(body.normal) / math.hypot(*body.normal)
        return (x - body.point) @ normal
    if body.kind == "sphere":
        return np.linalg.norm(x - body.center, axis=-1) - body.radius
    if body.kind == "torus":
        axis = np.array(body.axis) / math.hypot(*body.axis)
        up = (x - body.center) @ axis
        across = np.linalg.norm(x - body.center - up[..., None] * axis, axis=-1)
        return np.hypot(across - body.radius, up) - body.bar_radius
    if body.kind == "box":
        turned = Rotation.from_rotvec(body.rotation).inv()
        local = turned.apply((x - body.center).reshape(-1, 3)).reshape(x.shape)
        over = np.abs(local) - np.array(body.half_sizes) + body.edge_radius
        within = np.minimum(over.max(axis=-1), 0.0)
        return np.linalg.norm(np.maximum(over, 0.0), axis=-1) + within - body.edge_radius
    start, axis = np.array(body.start), np.array(body.end) - np.array(body.start)
    length = math.hypot(*axis)
    along = (x - start) @ axis / length
    across = np.linalg.norm(x - start - along[..., None] * axis / length, axis=-1)
    beyond = np.abs(along - 0.5 * length) - 0.5 * length
    if body.kind == "capsule":
        return np.hypot(across, np.maximum(beyond, 0.0)) - body.radius
    assert body.kind == "cylinder"
    over = np.stack([across - body.radius, beyond], axis=-1)
    return np.linalg.norm(np.maximum(over, 0.0), axis=-1) + np.minimum(over.max(axis=-1), 0.0)
