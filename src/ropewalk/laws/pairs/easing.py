"""What keeps contacts without friction from rocking: the part of their geometry that must not lag by a step.

Points and normals are those of a step's start. With R the force, d the radii's sum, u between the points, e
and f along the segments, e* and f* dual to them in the plane of both, P across the normal n, and by how much
the segments turn g = e* (n . de) + f* (n . df), the nearest points are n . du - g . du - d g^2 / 2 further
apart to second order, and besides what the frozen plane sees of it the energy of the contact changes by
    R (2 g . du + d g^2) / 2  =  R/d |P du + d g|^2 / 2  -  R/d |P du|^2 / 2 .
A concave part that lags by a step takes energy; a convex one makes some, however short steps are, and what
lies without friction rocks for ever. So where a contact goes in a way for which the sum is positive, as much
of the convex part is followed within the step: by a spring that begins with none in each (that of friction,
with levers d e* and d f*). What slides straight on has none. What turns it drags on, by R times the way in a
step over d at most, and by less the faster it goes, to none from EASED on.
Source: Eyre 1998, MRS Proc. 529:39 (convex splitting).
"""

from __future__ import annotations

from ropewalk.core.jit import kernel, small
from ropewalk.laws.pairs.distance import product
from ropewalk.laws.pairs.table import (
    FOLLOW,
    LEVER,
    NORMAL,
    OTHER,
    OWN,
    PUSH,
    SETTLES,
    apart,
    between,
    friction_of,
    throws_back,
)

EASED = 4.0  # [1/s] of the radii's sum
LEAST_SINE = (
    3e-4  # [1] square of that of a degree: points of what is more parallel count as of that
)


@small
def ease_levers(memory, row, e, f, s, t, size):
    """Write the levers of a contact without friction: d e* and d f*, where its points can go along.

    e and f are what lies across the normal of the vectors along the segments; a point at a node stays there.
    """
    grip, ee, ff, ef = (
        memory.grip,
        max(product(e, e), 1e-300),
        max(product(f, f), 1e-300),
        product(e, f),
    )
    own_goes, other_goes = 0.0 < s < 1.0, 0.0 < t < 1.0
    wide = max(ee * ff - ef * ef, LEAST_SINE * ee * ff)
    for k in range(3):
        own, other = 0.0, 0.0
        if own_goes and other_goes:
            own, other = (ff * e[k] - ef * f[k]) / wide, (ee * f[k] - ef * e[k]) / wide
        elif own_goes:
            own = e[k] / ee
        elif other_goes:
            other = f[k] / ff
        grip[row, LEVER + k], grip[row, LEVER + 3 + k] = size * own, size * other


@small
def slow(v, memory, row, size):
    """Return 1 where the points of a contact do not move against each other, down to 0 from EASED on."""
    i, j, grip = memory.pair[row, 0], memory.pair[row, 1], memory.grip
    w = between(v, i, j, grip[row, OWN], grip[row, OTHER])
    return max(1.0 - product(w, w) / (EASED * size) ** 2, 0.0)


@small
def across_squared(grip, row, w):
    """Return |P w|^2."""
    n = (grip[row, NORMAL], grip[row, NORMAL + 1], grip[row, NORMAL + 2])
    return max(product(w, w) - product(n, w) ** 2, 0.0)


@small
def convex(v, memory, row):
    """Return how much of the convex part is left of both in the way that a contact goes [1]; 0: none."""
    i, j, grip = memory.pair[row, 0], memory.pair[row, 1], memory.grip
    slides = across_squared(grip, row, between(v, i, j, grip[row, OWN], grip[row, OTHER]))
    turns = across_squared(grip, row, apart(v, grip, row, i, j))
    return 1.0 - slides / turns if turns > slides else 0.0


@kernel
def ease(v, table, memory, row):
    """Keep how stiff the spring of a contact without friction is in the next step [N/m]; 0: it has none.

    Statics has no steps that lag, and what throws back has short ones.
    """
    i, j, grip = memory.pair[row, 0], memory.pair[row, 1], memory.grip
    grip[row, FOLLOW] = 0.0
    if throws_back(table) or memory.tally[SETTLES] != 0:
        return
    if grip[row, PUSH] > 0.0 and friction_of(table, i, j) == 0.0:
        size = table.radius[i] + table.radius[j]
        part = convex(v, memory, row) * slow(v, memory, row, size)
        grip[row, FOLLOW] = part * grip[row, PUSH] / size
