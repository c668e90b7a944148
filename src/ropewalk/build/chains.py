"""A model as chains with one unknown per node, for the theory of stability."""

from __future__ import annotations

import math

import numpy as np

from ropewalk.core.arrays import Floats, State, System
from ropewalk.laws.winch import MERGE, SPLIT
from ropewalk.methods.bound import Chain


def chains(system: System, state: State, speed: float = 0.0) -> dict[str, Chain]:
    """Return the chains whose stability decides, by case: in the air, on the ground, at a winch.

    A node that is ever released counts as free. Quadratic drag is linearised at `speed` [m/s].
    """
    held = state.anchor_node[~np.isfinite(system.anchors.release)]
    free = state.mass > 0.0
    free[held] = False
    zero = np.zeros_like(state.mass)
    base = Chain(
        mass=np.where(state.mass > 0.0, state.mass, 1.0),
        stiffness=state.stiffness,
        damping_vector=state.damping_vector,
        damping_axial=state.damping_axial,
        node_stiffness=zero,
        node_damping=_air_damping(system, state, speed),
        free=free,
        sideways=bool(np.any(system.gravity) or np.any(state.v) or len(state.held) > 0),
    )
    cases = {"in the air": base}
    for row in range(len(state.winch_exit)):
        for share in (MERGE, SPLIT):
            cases[f"at a winch whose last segment is {share:g} long"] = _winch_case(
                base, system, state, row, share
            )
    if len(state.winch_exit):
        cases["with all rope paid out"] = _paid_out(base, system, state)
    if system.ground.active:
        ground = system.ground
        for name, chain in tuple(cases.items()):
            here = "" if name == "in the air" else f", {name}"
            damping = chain.node_damping
            cases[f"pressed to the ground{here}"] = chain._replace(
                node_stiffness=zero + ground.repulsion,
                node_damping=damping + ground.absorption,
            )
            cases[f"sliding on the ground{here}"] = chain._replace(
                node_damping=damping + ground.friction
            )
    return cases


def _air_damping(system: System, state: State, speed: float) -> Floats:
    """Drag per speed of every node [N s/m]: d(a v^2)/dv = 2 a v, a segment's shared by its ends."""
    air = system.air
    per_segment = speed * np.maximum(air.normal, air.tangential) * state.rest_length
    damping = air.node_drag + 2.0 * speed * air.node_drag_quadratic
    damping[:-1] += per_segment
    damping[1:] += per_segment
    return damping


def _winch_case(base: Chain, system: System, state: State, row: int, share: float) -> Chain:
    """The chain with the working segment of a winch at a share of its nominal length."""
    winches = system.winches
    side, drum = int(winches.step[row]), int(state.winch_exit[row])
    working = drum if side > 0 else drum - 1
    length = share * winches.segment[row]
    stiffness, vector = base.stiffness.copy(), base.damping_vector.copy()
    axial, mass = base.damping_axial.copy(), base.mass.copy()
    stiffness[working] = winches.EA[row] / length
    vector[working] = winches.vector[row] / length
    axial[working] = winches.axial[row] / length
    mass[drum + side] += 0.5 * winches.line[row] * (length - state.rest_length[working])
    return base._replace(mass=mass, stiffness=stiffness, damping_vector=vector, damping_axial=axial)


def _paid_out(base: Chain, system: System, state: State) -> Chain:
    """The chain when no winch has rope left on its drum, the last segments at their shortest."""
    winches = system.winches
    chain = base._replace(
        mass=base.mass.copy(),
        stiffness=base.stiffness.copy(),
        damping_vector=base.damping_vector.copy(),
        damping_axial=base.damping_axial.copy(),
        free=base.free.copy(),
    )
    for row, drum in enumerate(state.winch_exit):
        side, first = int(winches.step[row]), int(winches.first[row])
        if first == drum:
            continue
        nodes = np.arange(first, int(drum) + side, side)
        segments = np.minimum(nodes[:-1], nodes[1:])
        length = np.full(len(segments), winches.segment[row])
        length[0] *= MERGE
        chain.stiffness[segments] = winches.EA[row] / length
        chain.damping_vector[segments] = winches.vector[row] / length
        chain.damping_axial[segments] = winches.axial[row] / length
        chain.mass[nodes] = winches.line[row] * winches.segment[row]
        chain.mass[nodes[1]] *= 0.5 * (1.0 + MERGE)
        chain.free[nodes] = True
        chain.free[first] = False
    return chain


def speed_scale(system: System, state: State) -> float:
    """Return the speed at which quadratic drag is linearised [m/s].

    The fastest of: initial velocities against the wind, anchors, and a fall through the rope's length.
    """
    wind = system.air.wind[:, None]
    start = float(np.linalg.norm(state.v - wind, axis=0).max())
    fall = math.sqrt(2.0 * float(np.linalg.norm(system.gravity)) * float(state.rest_length.sum()))
    anchors = system.anchors
    moved = float(np.linalg.norm(anchors.params[:, 3:6], axis=1).max(initial=0.0))
    return max(start, fall + float(np.linalg.norm(wind)), moved)
