"""What takes a step that makes up energy: halves by the method itself, and by others where these do, too.

Implicit Euler leaves a rope that swings velocities along the chord of its way. With these the next step
that has an explicit first stage makes up energy again, and so on, until most of the swing is lost; halves
by SDIRK2, which has no such stage, end that. BDF2 goes on after halves by a step of ESDIRK3, as after one
by SDIRK2 it makes up energy. Beside obstacles all parts are by implicit Euler: it takes impacts, and its
friction gives nothing. So they are with rigid links: there the velocities are put right, see
`impacts.rest_links`.
"""

from __future__ import annotations

from ropewalk.core.jit import kernel
from ropewalk.methods.loop import nodes_out
from ropewalk.methods.tableaus import (
    BDF2,
    ESDIRK3,
    GENERALIZED_ALPHA,
    IMPLICIT_EULER,
    SDIRK2,
    Tableau,
)

LAST = 2  # the place of implicit Euler, which is the last


def halves_of(tableau: Tableau, rigid: bool) -> tuple[Tableau, Tableau, Tableau]:
    """Return what takes the halves of a step, one after the other where they make up energy."""
    last = IMPLICIT_EULER
    if rigid or tableau.kind == GENERALIZED_ALPHA or tableau.stages == 1:
        return last, last, last
    if tableau.kind == BDF2:
        return SDIRK2, last, last
    return tableau, SDIRK2 if tableau.A[0, 0] == 0.0 else last, last


def most_stages(tableau: Tableau) -> int:
    """Return the stages of the longest step of a method, its halves, or the one after them."""
    return max(tableau.stages, SDIRK2.stages, ESDIRK3.stages if tableau.kind == BDF2 else 0)


@kernel
def carries_on(dt, held, exits, past):
    """Tell whether the step goes on as the last one did: same length, same anchors and winch exits.

    And whether it is the one after halves.
    """
    holding, out, before = 0.0, nodes_out(exits), past[0]
    for row in range(held.shape[0]):
        holding += held[row]
    kept = past[1] == holding and past[2] == out
    past[0], past[1], past[2] = dt, holding, out
    return kept and before == dt, kept and before == 0.5 * dt
