"""How fast a node comes at a surface, as far as it will touch it.

The damper of a contact takes hold before the surface does, from 2 v sqrt(m/k) on. Round a convex surface with
the radius r - g about which a node at the distance r of the centre of curvature turns, g its gap, what flies
on straight passes at r w / sqrt(w^2 + u^2), w its speed along the arc and u towards the surface. So it comes
no nearer than r - g, and is not to be braked, if
    u <= G w,   G = sqrt(r^2 - (r - g)^2) / (r - g) .
Only u - G w is damped. As it is lost far out, the energy is that lost with all of the normal speed at the
touch, (u^2 - (G w)^2) / 2. From EVEN r down G falls straight to nothing: its slope has no bound there.
"""

from __future__ import annotations

import math

from ropewalk.core.jit import small

EVEN = 1e-3  # [1] gap over r below which G is straight
SHARP = (
    1e-3  # [1] least (r - g) / r: past an edge without a radius all may go that does not meet it
)


@small
def across(ca, cb, n, a, u):
    """Return H u, H of `obstacle_shapes`."""
    along, aside = n[0] * u[0] + n[1] * u[1] + n[2] * u[2], a[0] * u[0] + a[1] * u[1] + a[2] * u[2]
    return (
        ca * (u[0] - along * n[0] - aside * a[0]) + cb * aside * a[0],
        ca * (u[1] - along * n[1] - aside * a[1]) + cb * aside * a[1],
        ca * (u[2] - along * n[2] - aside * a[2]) + cb * aside * a[2],
    )


@small
def passing(gap, over):
    """Return G of a gap [m] where the normal turns by `over` = 1/r [1/m], and its slope along r [1/m]."""
    even = EVEN / over
    far = max(gap, even)
    inner = max(1.0 - far * over, SHARP)
    most = math.sqrt(far * over * (1.0 + inner)) / inner
    if gap < even:
        return most * gap / even, most / even
    if inner == SHARP:
        return most, 0.0  # r - g is nothing, G as good as even
    return most, over / (inner * inner * most)


@small
def closing(rise, gap, n, a, ca, cb, v):
    """Return how fast a gap [m] grows that will close [m/s], 0: it will not.

    And what G w changes by with the gap [1/s], with H v . dx [1] and with H v . dv [m]. `rise` is how fast it
    grows at all, `n`, `a`, `ca`, `cb` as `probe` has them, `v` the velocity over the surface [m/s]. What is
    curved along a as well, but no ball, is taken for flat.
    """
    if rise >= 0.0 or gap <= 0.0 or ca <= 0.0 or cb != 0.0:
        return rise, 0.0, 0.0, 0.0
    h = across(ca, cb, n, a, v)
    square = (h[0] * v[0] + h[1] * v[1] + h[2] * v[2]) / ca
    if not square > 0.0:
        return rise, 0.0, 0.0, 0.0
    w = math.sqrt(square)
    most, slope = passing(gap, ca)
    return min(rise + most * w, 0.0), w * slope, -most * rise / w, most / (ca * w)
