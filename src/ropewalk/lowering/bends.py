"""The bends of a rope as springs between neighbours, for the theory of stability.

With d, d' the displacements across the segments before and after a node over their lengths, its bend
changes by d' - d, and B (d' - d)^2 <= 2 B (d^2 + d'^2): springs of 2 B / L^2 along both segments are nowhere
softer. For a motion that alternates from node to node, the fastest there is, they are exact: a long
uniform rope has the highest frequency 4 sqrt(EI / (mu L^4)). A half cell at a clamp makes a spring B / L^2.

A node bent by the angle t is stiffer by (1 + s^2)^2 + e s (1 + s^2) + min(e^2 / 4, e / 2), s = tan(t / 2) and
e = |kb - k0| (B |kb - k0|^2 / 2 twice by t, and what bending then adds to stretch); the bends of time zero
count, up to 120 degrees, where it is about 42: +4 % at 10 degrees, +36 % at 30. The friction of bending is
stiffer by (1 + s^2)^2.
"""

from __future__ import annotations

import numpy as np

from ropewalk.core.arrays import Floats, Ints, State, System
from ropewalk.laws.bending import FOLD
from ropewalk.laws.wound_bends import set_all_bends


def bends(system: System, state: State) -> tuple[Floats, Floats]:
    """Return the springs [N/m] and their friction [N s/m], (s,) each; zeros without bending."""
    springs, rubbing = np.zeros_like(state.stiffness), np.zeros_like(state.stiffness)
    table = system.bending
    if table.stiffness.size == 0:
        return springs, rubbing
    stiffness, damping = state.bending_stiffness.copy(), state.bending_damping.copy()
    for row in np.flatnonzero(table.clamped):
        node = state.anchor_node[row]
        lasts = not np.isfinite(system.anchors.release[row])
        if lasts or min(state.rest_length[node - 1 : node + 1], default=0.0) <= 0.0:  # or at a drum
            continue
        # bends as any other node from then on
        stiffness[node], damping[node] = table.stiffness[node], table.damping[node]
    joints = np.flatnonzero(stiffness > 0.0)
    vectors = np.diff(state.x, axis=1)
    sizes = np.linalg.norm(vectors, axis=0)
    units = np.divide(vectors, sizes, out=np.zeros_like(vectors), where=sizes > 0.0)
    before, after = units[:, joints - 1], units[:, joints]
    stiffer, rougher = _factors(before.T, after.T, table.natural[:, joints].T)
    square = state.rest_length**2
    over = np.divide(1.0, square, out=np.zeros_like(square), where=square > 0.0)
    for segment in (joints - 1, joints):
        np.add.at(springs, segment, 2.0 * stiffness[joints] * stiffer * over[segment])
        np.add.at(rubbing, segment, 2.0 * damping[joints] * rougher * over[segment])
    for row in np.flatnonzero(table.clamped):
        for side in np.flatnonzero(table.clamp_stiffness[row]):
            j = state.anchor_node[row] - 1 + side
            pair = units[:, j], table.direction[row]
            first, second = pair if side == 0 else pair[::-1]
            natural = table.clamp_natural[row, 3 * side : 3 * side + 3]
            stiff, rough = _factors(first[None], second[None], natural[None])
            share = table.clamp_length[row] / state.rest_length[j] if over[j] else 0.0
            springs[j] += share * table.clamp_stiffness[row, side] * stiff[0] * over[j]
            rubbing[j] += share * table.clamp_damping[row, side] * rough[0] * over[j]
    return springs, rubbing


def wound_bends(
    system: System, state: State, lengths: Floats, exits: Ints
) -> tuple[Floats, Floats]:
    """As `bends`, where winches have given segments other rest lengths (s,) [m] and stand at `exits` (w,).

    What is on a drum now will leave it straight.
    """
    if not system.bending.stiffness.size:
        return bends(system, state)
    x, anchors = state.x.copy(), state.anchor_node.copy()
    for row, (first, last) in enumerate(zip(exits, state.winch_exit, strict=True)):
        side = int(system.winches.step[row])
        along = x[:, last + side] - x[:, last]
        for node in range(int(last) - side, int(first) - side, -side):
            x[:, node] = x[:, node + side] - along
        anchors[system.winches.anchor[row]] = first
    wound = state._replace(
        x=x,
        rest_length=lengths,
        winch_exit=exits,
        anchor_node=anchors,
        bending_stiffness=state.bending_stiffness.copy(),
        bending_damping=state.bending_damping.copy(),
    )
    set_all_bends(system, wound)
    return bends(system, wound)


def _factors(a: Floats, b: Floats, natural: Floats) -> tuple[Floats, Floats]:
    """Return how much stiffer and rougher bends are than straight ones [1], from unit vectors (m, 3)."""
    chi = np.maximum(1.0 + (a * b).sum(axis=1), FOLD)
    square = np.maximum(2.0 / chi - 1.0, 0.0)  # tan^2(angle / 2); a straight one may round below
    excess = np.linalg.norm(2.0 * np.cross(a, b) / chi[:, None] - natural, axis=1)
    grown = 1.0 + square
    more = np.minimum(0.25 * excess**2, 0.5 * excess)
    return grown**2 + excess * np.sqrt(square) * grown + more, grown**2
