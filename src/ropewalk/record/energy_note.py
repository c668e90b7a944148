"""A sentence about a run whose automatic explicit steps have made up or lost energy."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.methods.registry import METHODS
from ropewalk.scene import Material, Scene

if TYPE_CHECKING:
    from ropewalk.record.result import Result

MOST = 0.01  # [1] of weight times length


def energy_note(result: Result, error: Floats) -> str:
    """Say by how much the energy of an undamped rope is wrong, where it is by more than `MOST`; else "".

    `error` is that of the frames to look at [J], (frames,).
    For explicit methods whose step or whose choice was left to Ropewalk. Of friction, air, ground and limiter
    there must be none: what they take hides what steps make up.
    """
    scene, plan = result.scene, result.plan
    automatic = "auto" in (scene.run.method, scene.run.time_step)
    if not automatic or plan.method not in METHODS or METHODS[plan.method].implicit:
        return ""
    scale = weight_times_length(scene)
    error = error[np.isfinite(error)]
    if not error.size or scale == 0.0 or is_damped(scene):
        return ""
    worst = float(error[np.argmax(np.abs(error))])
    if abs(worst) <= MOST * scale:
        return ""
    did = "made up" if worst > 0.0 else "lost"
    return (
        f"{plan.method} {did} {abs(worst):.3g} J, {100.0 * abs(worst) / scale:.2g} % of weight times length, "
        f"in a rope without friction: take time_step = {0.5 * plan.dt:.3g} s or less, method = adaptive, or "
        "give the rope the friction that it has"
    )


def weight_times_length(scene: Scene) -> float:
    """Return the weight of all ropes and loads times the longest rope's length [J]."""
    mass = sum(rope.total_mass for rope in scene.ropes)
    return math.hypot(*scene.gravity) * mass * max(rope.length_unstretched for rope in scene.ropes)


def is_damped(scene: Scene) -> bool:
    """Tell whether anything in a scene takes energy."""
    if scene.air is not None or scene.ground is not None or scene.limiter is not None:
        return True
    rubs = any(rope.segment_friction > 0.0 for rope in scene.ropes)
    bends = (rope.made_of for rope in scene.ropes if isinstance(rope.made_of, Material))
    return rubs or any(made_of.bending_damping > 0.0 for made_of in bends)
