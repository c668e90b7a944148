"""Whether no node can touch an obstacle, found for all of them at once, or for a run of them.

A contact presses with no more than c u - k g, u the speed at which a node comes and g its gap (see
`contact`). Gaps are distances: no node's is smaller than that of one node less how far it is from there.
"""

from __future__ import annotations

import math

from ropewalk.core.jit import kernel, small
from ropewalk.core.largest import order, ordered
from ropewalk.laws.contact_frame import DAMP
from ropewalk.laws.obstacle_pose import body_of, probe_turned
from ropewalk.laws.obstacle_shapes import PLANE

RUN = 16  # nodes that are looked at together once some of the rope is in reach
ROUNDED = 1e-12  # [1] of the places: more than rounding does to a gap


@kernel
def is_out_of_reach(x, v, obstacles, grip, o, pose, moved, speed, turning, lo, hi):
    """Tell whether obstacle o presses none of the nodes `lo` to `hi - 1`, as sure as can be in one look.

    It lies in a `pose`, see `obstacle_pose`, has `moved` [m], and goes at `speed` [m/s], turning at `turning`
    [rad/s], (3) each.
    """
    lo = max(lo, 0)
    if not hi > lo:
        return True
    hub, at = obstacles.hub[o], (lo + hi) // 2
    cx, cy, cz = x[0, at], x[1, at], x[2, at]
    px, py, pz = cx - moved[0], cy - moved[1], cz - moved[2]
    gap = probe_turned(body_of(obstacles, o), pose, px, py, pz)[0]
    if not gap > obstacles.thickness[at]:
        return False
    # views of their own, as with an index that may be below 0 the loop does not vectorise
    x0, x1, x2, thickness = x[0][lo:hi], x[1][lo:hi], x[2][lo:hi], obstacles.thickness[lo:hi]
    v0, v1, v2, damping = v[0][lo:hi], v[1][lo:hi], v[2][lo:hi], grip[DAMP][lo:hi]
    stiffness, far, fast, thick, damped = obstacles.stiffness[o][lo:hi], 0, 0, 0, 0
    soft = order(math.inf)
    for i in range(x0.shape[0]):
        dx, dy, dz = x0[i] - cx, x1[i] - cy, x2[i] - cz
        far = max(far, order(abs(dx * dx + dy * dy + dz * dz)))
        fast = max(fast, order(abs(v0[i] * v0[i] + v1[i] * v1[i] + v2[i] * v2[i])))
        thick, soft = max(thick, order(thickness[i])), min(soft, order(stiffness[i]))
        damped = max(damped, order(damping[i]))
    away, quick = math.sqrt(ordered(far)), math.sqrt(ordered(fast))
    size = abs(cx) + abs(cy) + abs(cz) + abs(px) + abs(py) + abs(pz) + away
    center = obstacles.center[o]
    size += abs(center[0]) + abs(center[1]) + abs(center[2])
    least = gap - away - ordered(thick) - ROUNDED * size
    arm = abs(px - hub[0]) + abs(py - hub[1]) + abs(pz - hub[2]) + away
    quick += abs(speed[0]) + abs(speed[1]) + abs(speed[2])
    quick += (abs(turning[0]) + abs(turning[1]) + abs(turning[2])) * arm
    return ordered(soft) * least > ordered(damped) * quick


@small
def first_run(obstacles, o, lo, hi):
    """Return where the first run of the nodes `lo` to `hi - 1` begins, `hi`: they are looked at one by one.

    To ask a node how far it is from a plane takes no longer than to ask a run.
    """
    return hi if obstacles.kind[o] == PLANE or hi - lo <= RUN else lo
