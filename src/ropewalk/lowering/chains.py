"""A model as chains with one unknown per node, for the theory of stability."""

from __future__ import annotations

import math

import numpy as np

from ropewalk.core.arrays import Floats, Ints, State, System
from ropewalk.laws.acting import acting, flow
from ropewalk.laws.obstacle_places import surface_speed
from ropewalk.laws.registry import NODE_LAWS
from ropewalk.laws.winch import MERGE, SPLIT
from ropewalk.lowering.apart import recoil_of_releases
from ropewalk.lowering.bends import bends, wound_bends
from ropewalk.lowering.elastic_tables import softest
from ropewalk.methods.bound import Chain
from ropewalk.motions.rows import largest_speed

FREE = "in the air"  # the case of a rope that touches nothing


def chains(system: System, state: State, speed: float = 0.0) -> dict[str, Chain]:
    """Return the chains whose stability decides, by case: those of `free_chains`, and under laws of nodes."""
    return with_cases(system, free_chains(system, state, speed))


def with_cases(system: System, free: dict[str, Chain]) -> dict[str, Chain]:
    """Return the chains and what laws of nodes, as a ground, may make of them, by case."""
    cases = dict(free)
    for law, table in acting(system):
        if law.cases is None:
            continue
        for name, chain in tuple(cases.items()):
            here = "" if name == FREE else f", {name}"
            cases |= {f"{case}{here}": found for case, found in law.cases(table, chain).items()}
    return cases


def free_chains(system: System, state: State, speed: float = 0.0) -> dict[str, Chain]:
    """Return the chains where nothing is touched, by case: in the air, at a winch.

    A node that is ever released counts as free. Quadratic drag is linearised at `speed` [m/s].
    """
    held = state.anchor_node[~np.isfinite(system.anchors.release)]
    free = state.mass > 0.0
    free[held] = False
    zero = np.zeros_like(state.mass)
    bending, rubbing = bends(system, state)
    base = Chain(
        mass=np.where(state.mass > 0.0, state.mass, 1.0),
        stiffness=state.stiffness,
        damping_vector=state.damping_vector,
        damping_axial=state.damping_axial,
        node_stiffness=zero,
        node_damping=zero,
        free=free,
        sideways=_is_pushed(system, state) or not _is_straight(state.x),
        bending=bending,
        damping_bending=rubbing,
    )
    base = _under_laws(system, base, state.rest_length, speed)
    cases = {FREE: base}
    if system.elastic.time.size:
        soft = softest(system.elastic, base.stiffness)
        cases["where its curve is softest"] = base._replace(stiffness=soft)
    for row in range(len(state.winch_exit)):
        for share in (MERGE, SPLIT):
            cases[f"at a winch whose last segment is {share:g} long"] = _winch_case(
                base, system, state, row, share
            )
    if len(state.winch_exit):
        cases["with all rope paid out"] = _paid_out(base, system, state)
    for row in range(len(state.winch_exit)):
        cases["with all rope reeled in"] = _reeled_in(base, system, state, row)
    return cases


def _under_laws(system: System, chain: Chain, lengths: Floats, speed: float) -> Chain:
    """Return the chain with what laws of nodes always add, where nodes move at most so fast [m/s]."""
    for law, table in zip(NODE_LAWS, system.node, strict=True):
        if law.chain is not None:
            chain = law.chain(table, chain, lengths, speed)
    return chain


def calms_with_speed(system: System, state: State) -> bool:
    """Tell whether a law of nodes damps what moves more than what is at rest, as quadratic drag does."""
    chain = free_chains(system, state)[FREE]
    slow, fast = (_under_laws(system, chain, state.rest_length, speed) for speed in (0.0, 1.0))
    return not np.array_equal(slow.node_damping, fast.node_damping)


def _is_pushed(system: System, state: State) -> bool:
    """Tell whether anything may push nodes off the line that they lie on."""
    moved = bool(np.any(system.gravity) or np.any(state.v) or len(state.held) > 0)
    return moved or bool(np.any(state.forces.applied) or acting(system))


def _is_straight(x: Floats) -> bool:
    """Tell whether all nodes lie on one line, within rounding."""
    spread = x - x.mean(axis=1, keepdims=True)
    sizes = np.linalg.eigvalsh(spread @ spread.T)
    return bool(sizes[1] <= 1e-18 * max(sizes[2], 1e-300))


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
    base = base._replace(mass=mass, stiffness=stiffness, damping_vector=vector, damping_axial=axial)
    lengths = state.rest_length.copy()
    lengths[working] = length
    return _bent(base, system, state, lengths, state.winch_exit)


def _reeled_in(base: Chain, system: System, state: State, row: int) -> Chain:
    """The chain when a winch has left one segment, as short as it may get."""
    winches = system.winches
    side, last = int(winches.step[row]), int(winches.last[row])
    drum = last - side
    segment = min(drum, last)
    length = min(MERGE * winches.segment[row], winches.shortest[row])
    changed = {
        "stiffness": winches.EA[row] / length,
        "damping_vector": winches.vector[row] / length,
        "damping_axial": winches.axial[row] / length,
    }
    arrays = {name: getattr(base, name).copy() for name in changed}
    for name, value in changed.items():
        arrays[name][segment] = value
    free, mass = base.free.copy(), base.mass.copy()
    free[drum] = False
    mass[last] += 0.5 * winches.line[row] * (length - winches.segment[row])
    base = base._replace(free=free, mass=mass, **arrays)
    lengths, exits = state.rest_length.copy(), state.winch_exit.copy()
    lengths[min(winches.first[row], last) : max(winches.first[row], last)] = 0.0
    lengths[segment], exits[row] = length, drum
    return _bent(base, system, state, lengths, exits)


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
    lengths = state.rest_length.copy()
    for row, drum in enumerate(state.winch_exit):
        side, first = int(winches.step[row]), int(winches.first[row])
        if first == drum:
            continue
        nodes = np.arange(first, int(drum) + side, side)
        segments = np.minimum(nodes[:-1], nodes[1:])
        length = np.full(len(segments), winches.segment[row])
        length[0] *= MERGE
        lengths[segments] = length
        chain.stiffness[segments] = winches.EA[row] / length
        chain.damping_vector[segments] = winches.vector[row] / length
        chain.damping_axial[segments] = winches.axial[row] / length
        chain.mass[nodes] = winches.line[row] * winches.segment[row]
        chain.mass[nodes[1]] *= 0.5 * (1.0 + MERGE)
        chain.free[nodes] = True
        chain.free[first] = False
    return _bent(chain, system, state, lengths, winches.first)


def _bent(chain: Chain, system: System, state: State, lengths: Floats, exits: Ints) -> Chain:
    """The chain with the bends of other rest lengths [m], drums at `exits` (w,)."""
    bending, rubbing = wound_bends(system, state, lengths, exits)
    return chain._replace(bending=bending, damping_bending=rubbing)


def speed_scale(
    system: System, state: State, until: float = math.inf, *, drums: bool = True
) -> float:
    """Return the speed of what a scene sets going before a time [s] [m/s].

    The fastest of: initial velocities against the wind, anchors and obstacles, and a fall through the rope's
    length, with what waits on its drums if they count.
    """
    wind = flow(system)[:, None]
    start = float(np.linalg.norm(state.v - wind, axis=0).max())
    pull = float(np.linalg.norm(system.gravity))
    if state.forces.applied.any():
        whole = np.linalg.norm(state.forces.applied, axis=0).sum() / state.mass.sum()
        pull += float(whole)
    length = float(state.rest_length.sum()) + (_on_drums(system, state) if drums else 0.0)
    fall = math.sqrt(2.0 * pull * length)
    moved = driven_speed(system, until)
    return max(start, fall + float(np.linalg.norm(wind)), moved + float(np.linalg.norm(wind)))


def _on_drums(system: System, state: State) -> float:
    """Return the length of the rope that winches may still pay out [m]."""
    winches, total = system.winches, 0.0
    for row, paid in enumerate(state.winch_paid):
        one, other = sorted((int(winches.first[row]), int(winches.last[row])))
        room = float(winches.longest[row] - state.rest_length[one:other].sum())
        total += max(0.0, min(float(winches.drum[row] - paid), room))
    return total


def recoil(state: State) -> float:
    """Return the speed at which a rope that starts stretched flies back [m/s].

    A wave of recoil moves what it has passed at strain times the speed of waves, a free end at twice that.
    """
    size = np.linalg.norm(np.diff(state.x, axis=1), axis=0)
    lightest = np.maximum(state.inverse_mass[:-1], state.inverse_mass[1:])
    stretched = np.maximum(size - state.rest_length, 0.0) * (state.rest_length > 0.0)
    soft = np.where(np.isfinite(state.stiffness), state.stiffness, 0.0)
    return float((2.0 * stretched * np.sqrt(soft * lightest)).max(initial=0.0))


def fastest(system: System, state: State, until: float = math.inf) -> float:
    """Return the largest speed to reckon with before a time [s], with `recoil`, against the wind [m/s]."""
    wind = float(np.linalg.norm(flow(system)))
    back = max(recoil(state), recoil_of_releases(system, state))
    return max(speed_scale(system, state, until), back + wind)


def driven_speed(system: System, until: float = math.inf) -> float:
    """Return the largest speed of what moves by itself before a time [s], anchors and obstacles [m/s]."""
    table = system.node.obstacle
    anchors = (largest_speed(system.anchors, row, until) for row in range(len(system.anchors.kind)))
    bodies = (surface_speed(table, row, until) for row in range(len(table.kind)))
    return max((*anchors, *bodies), default=0.0)
