"""What `check` says of anchors and obstacles that shake or go round too quickly for steps or contacts."""

from __future__ import annotations

import math

import numpy as np

from ropewalk.laws.obstacle import DAMPING
from ropewalk.lowering import Model
from ropewalk.lowering.swings import remedy, too_few
from ropewalk.scene.motions import Orbit, Shake
from ropewalk.scene.obstacles import Obstacle, Plane
from ropewalk.words.safe_side import rounded_down

_AHEAD, _LITTLE = (
    0.25,
    0.1,
)  # of half a swing [1]: ways on which contacts brake, told of and asked for
_ALONG = 1e-9  # [1] of a way: what of it goes across a plane by rounding


def swing_warnings(model: Model) -> list[str]:
    """Return a sentence for everything that swings in too few steps, or quicker than its contacts brake."""
    plan, run = model.plan, model.scene.run
    step = plan.dt if plan.longest is None else plan.longest
    found = []
    for one in too_few(model.scene, plan.method, step, run.duration):
        as_fast = "" if one.exact else ", as hard to follow as a sine of that period"
        found.append(
            f"{one.path}: {one.value} - {one.name} swings in {1e3 * one.period:.4g} ms{as_fast}, and makes "
            f"it in {one.period / step:.3g} steps: what it moves and rubs may be wrong by much more than a "
            f"few per cent; {remedy(one)}"
        )
    for row, body in enumerate(model.scene.obstacles):
        found += _braked_ahead(model, row, body)
    return found


def _braked_ahead(model: Model, row: int, body: Obstacle) -> list[str]:
    """Return a sentence where what a body throws is braked on much of the way that it swings.

    Contacts take hold of what comes at u from c u / k ahead on, see `laws.closing`.
    """
    motion = body.motion
    if not isinstance(motion, Shake | Orbit) or not _comes_across(body, motion):
        return []
    table = model.system.node.obstacle
    reach = table.ratio[row] * table.damping[row] / table.stiffness[row]
    worst = int(reach.argmax())
    rate = 2.0 * math.pi * abs(motion.frequency)
    share = rate * float(reach[worst])
    if share <= _AHEAD:
        return []
    mass = (table.damping[row, worst] / (2.0 * DAMPING)) ** 2 / table.stiffness[row, worst]
    firm = (_LITTLE / (2.0 * DAMPING * rate)) ** 2 / mass
    return [
        f"obstacle[{row}].motion.frequency: {motion.frequency:g} Hz - contacts of {body.name!r} brake "
        f"what it comes at from {share:.2g} of half its swing ahead on, where it may never be: it strikes "
        "otherwise than a hard body; give it a compliance of at most "
        f"{rounded_down(float(firm), 2)} m/N"
    ]


def _comes_across(body: Obstacle, motion: Shake | Orbit) -> bool:
    """Tell whether a body's motion moves its surface, and not a plane along itself."""
    if not isinstance(body, Plane):
        return True
    axis, normal = np.array(motion.axis), np.array(body.normal)
    across = (
        abs(axis @ normal) if isinstance(motion, Shake) else np.linalg.norm(np.cross(axis, normal))
    )
    return bool(across > _ALONG * np.linalg.norm(axis) * np.linalg.norm(normal))
