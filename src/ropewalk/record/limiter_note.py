"""Whether the stretch limiter of an explicit run did what a limiter can.

After a step it moves nodes to their bounds and takes the speed at which they would pass them. Where too much
hangs on too fine a rope for its passes it only moves nodes: places stand still, and velocities go on. That
shows in its work and in the energy. Where nothing drives a scene bounds can only take.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ropewalk.methods.registry import METHODS
from ropewalk.record.turnover import largest_change
from ropewalk.scene import Scene
from ropewalk.scene.motions import Fixed
from ropewalk.words.percents import percent

if TYPE_CHECKING:
    from ropewalk.record.result import Result

MOST = 0.05  # [1] of the energy turned over that it may give: one that has just caught a load gives 0.02


def limiter_note(result: Result) -> str:
    """Say how much energy a limiter has made up, where it is too much; else ""."""
    scene, good = result.scene, result.good_frames
    if not scene.limiter or _driven(scene) or METHODS[result.plan.method].implicit:
        return ""
    work = result.work["limiter"][:good]
    if not np.isfinite(work).all():
        return ""
    # its work alone grows where a load hangs at its bound: against the weight's, step by step
    total = result.energy["total"][:good] - result.work["applied"][:good]
    given, risen = (float((one - np.minimum.accumulate(one)).max()) for one in (work, total))
    turned = largest_change(part[:good] for name, part in result.energy.items() if name != "total")
    if not min(given, risen) > MOST * turned > 0.0:
        return ""
    return (
        f"it has put in {given:.3g} J, {percent(100.0 * given / turned, 3)} of the energy turned over, where "
        "it can only take: it holds nodes at their bounds, but does not stop them. Do not trust velocities, "
        "forces or energies; take method = esdirk3, fewer segments, or "
        f"time_step = {0.1 * result.plan.dt:.3g} s or less"
    )


def _driven(scene: Scene) -> bool:
    """Tell whether anything moves or blows that may put energy in; constant forces have their own work."""
    moved = (one.motion for one in (*scene.anchors, *scene.obstacles))
    winds = scene.air is not None and any(scene.air.wind)
    turned = any(body.spin is not None for body in scene.obstacles)
    return bool(scene.winches) or winds or turned or not all(isinstance(m, Fixed) for m in moved)
