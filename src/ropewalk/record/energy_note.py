"""A sentence about a run whose automatic steps have made up or lost energy, or miscounted it."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.laws.registry import NODE_LAWS
from ropewalk.methods.registry import METHODS
from ropewalk.scene import Material, Scene

if TYPE_CHECKING:
    from ropewalk.lowering import Plan
    from ropewalk.record.result import Result

MOST = 0.01  # [1] of weight times length
TURNED = 5.0  # [%] of the energy turned over: more than that is no ledger
_NOTHING = 1e-4  # [1] of weight times length: a rope that hardly moves turns over nothing


def energy_note(result: Result, error: Floats, share: float) -> str:
    """Say by how much the energy of an automatic run is wrong, where it is by too much; else "".

    Args:
        result: the run; its step or its method was left to Ropewalk, or there is no note.
        error: of the energy at the frames to look at [J], (frames,).
        share: the largest error, of the energy turned over [%].

    An explicit run of an undamped rope may err by `MOST` of weight times length. Of friction, air, ground
    and limiter there must be none: what they take hides what steps make up. A run whose method was left to
    Ropewalk, or the steps of an implicit one, may err by `TURNED` of the energy turned over.
    """
    scene, plan = result.scene, result.plan
    error = error[np.isfinite(error)]
    automatic = "auto" in (scene.run.method, scene.run.time_step)
    if not automatic or plan.method not in METHODS or not error.size:
        return ""
    worst, scale = float(error[np.argmax(np.abs(error))]), weight_times_length(scene)
    if not METHODS[plan.method].implicit and not is_damped(scene):
        return _made_up(plan, worst, scale) if abs(worst) > MOST * scale > 0.0 else ""
    chosen = scene.run.method == "auto" or METHODS[plan.method].implicit
    if not chosen or not share > TURNED or abs(worst) <= _NOTHING * scale:
        return ""
    return (
        f"{abs(worst):.3g} J, {share:.3g} % of the energy turned over, are in no law's work: some of the "
        f"motion is too fast for {plan.method}'s steps of {1e3 * plan.dt:.3g} ms. Do not trust works, nor "
        f"places after it; take time_step = {0.25 * plan.dt:.3g} s or less, or method = adaptive"
    )


def _made_up(plan: Plan, worst: float, scale: float) -> str:
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
    sections = (*(law.section for law in NODE_LAWS), "limiter")
    if any(getattr(scene, section, None) is not None for section in sections):
        return True
    rubs = any(rope.segment_friction > 0.0 for rope in scene.ropes)
    bends = (rope.made_of for rope in scene.ropes if isinstance(rope.made_of, Material))
    return rubs or any(made_of.bending_damping > 0.0 for made_of in bends)
