"""What a contact throws back of what hits: a coefficient of restitution, by its damper.

A node of mass m that comes with u is pressed from where its damper takes hold to where that lets go, by
    k u exp(-z w t) sin(w' t) / w',   w = sqrt(k / m),   w' = w sqrt(1 - z^2),
which is half a swing. If nothing else holds it, it leaves with
    e = exp(-pi z / sqrt(1 - z^2))
of u, both seen from the surface; its weight changes that by the square of g / (w u). It goes some u / w
deep: the steps of `adaptive` follow that, if it is thirty of their tolerances and more. Along the surface the
damper is the critical one as ever. What sticks does not ring there, but the spring that it has wound up lets
go with the contact: it may leave backwards, as elastic bodies do, where Coulomb's rigid one would stop.
Of two segments that meet it is the same with m = 1 / sum(c_a^2 / m_a), c_a the shares of their four nodes in
the points where they touch: what those move as, together.
Source: Schwager & Poeschel 2007, Granular Matter 9:465 (which force ends a collision).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from ropewalk.core.arrays import Floats

if TYPE_CHECKING:
    from ropewalk.scene.obstacles import Obstacle


def ratio_of(restitution: float) -> float:
    """Return the damping ratio z with which so much of its speed is left to what is thrown back [1]."""
    if restitution <= 0.0:
        return 1.0
    lost = -math.log(restitution)
    return lost / math.hypot(math.pi, lost)


def rebounds(bodies: Sequence[Obstacle], struck: Floats, masses: Floats) -> tuple[Floats, Floats]:
    """Return the damping ratios of bodies, (k,), and with what masses their dampers reckon [kg], (k, n).

    Of those that throw back with each node's own of the `masses` (n,), with what a joint ties to it, else
    with what it strikes with.
    """
    ratio = np.array([ratio_of(body.restitution) for body in bodies], dtype=np.float64)
    own = np.where(masses > 0.0, masses, struck)
    return ratio, np.where(ratio[:, None] < 1.0, own, struck)
