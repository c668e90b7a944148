"""The tangent of all laws: how their forces change with positions and velocities.

    matrix = -(weight_x dF/dx + weight_v dF/dv)

Exact, and so not symmetric where a law is not: axial friction and drag along a line depend on the
direction of a segment. Held nodes are treated as all others; who solves with the matrix leaves their rows
out.
"""

from __future__ import annotations

from ropewalk.core.arrays import TENSION_ONLY
from ropewalk.core.band import Band, clear_band, make_band
from ropewalk.core.jit import kernel, part
from ropewalk.laws.bending_tangent import bending_tangent, clamp_tangent
from ropewalk.laws.elastic import law_tangent
from ropewalk.laws.nodes import mark_nodes, node_tangents
from ropewalk.laws.rare import has_bending, has_clamps, has_elastic_laws
from ropewalk.laws.registry import NODE_LAWS
from ropewalk.laws.stretch_tangent import elastic_tangent, friction_tangent, mark_rubbing


@part
def mark(system, state, x, band):
    """Note in the band which segments rub and what the laws of nodes act on at positions `x`."""
    if system.flags[TENSION_ONLY] == 1:
        mark_rubbing(x, state.rest_length, system.slack_floor, band.rubs)
    mark_nodes(system, x, band)


@part
def begin_tangent(system, state, x, v, weight_x, weight_v, definite, band):
    """Overwrite the band with the tangent of bending, the law that reaches farthest; or with zeros.

    With `definite` it is changed so that it has no negative eigenvalue.
    """
    if has_bending(system):
        write_bending_tangent(system, state, x, v, weight_x, weight_v, definite, band)
    else:
        clear_band(band)


@part
def add_tangents(system, state, x, v, weight_x, weight_v, band):
    """Add the tangents of all laws but bending and the springs', for what is marked in the band."""
    friction_tangent(system, state, x, v, weight_x, weight_v, band.rubs, band)
    node_tangents(system, state, x, v, weight_x, weight_v, band)


@part
def write_bending_tangent(system, state, x, v, weight_x, weight_v, definite, band):
    """Write the tangents of bending, its friction and the clamps; the band has second off-diagonals."""
    lengths, bending = state.rest_length, system.bending
    stiffness, damping = state.bending_stiffness, state.bending_damping
    natural = bending.natural
    bending_tangent(x, v, lengths, stiffness, damping, natural, weight_x, weight_v, definite, band)
    if has_clamps(system, state):
        clamp_tangent(x, v, lengths, state, bending, weight_x, weight_v, definite, band)


@kernel
def assemble_tangent(system, state, x, v, weight_x, weight_v, band, clamp=False):
    """Write -(weight_x dF/dx + weight_v dF/dv) of all acting laws at `x` and `v`, (3, n) [m, m/s].

    With `clamp` the geometric stiffness T/r (I - t t^T) of compressed segments is left out, so that the
    springs' part has no negative eigenvalue.
    """
    floor = system.slack_floor
    mark(system, state, x, band)
    begin_tangent(system, state, x, v, weight_x, weight_v, False, band)
    if has_elastic_laws(system):
        lengths, k = state.rest_length, state.stiffness
        law_tangent(x, lengths, k, floor, system.elastic, weight_x, clamp, band)
    else:
        elastic_tangent(x, state.rest_length, state.stiffness, floor, weight_x, clamp, band)
    add_tangents(system, state, x, v, weight_x, weight_v, band)


def law_band(nodes: int, second: bool = False) -> Band:
    """Return a band of zeros with marks for all laws; with `second` it has second off-diagonals."""
    return make_band(nodes, second, len(NODE_LAWS))
