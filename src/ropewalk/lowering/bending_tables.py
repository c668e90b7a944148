"""Bending stiffness and clamps as tables for the kernels."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from ropewalk.core.arrays import BENDING, Bending, Floats, State, System
from ropewalk.lowering.layout import Layout
from ropewalk.lowering.pieces import Pieces
from ropewalk.scene import Anchor, Clamp, Material, Rope, Scene


def no_bending() -> Bending:
    """Return the tables of a scene without bending stiffness: all empty."""
    zero, rows = np.zeros(0), np.zeros((0, 3))
    pairs, natural = np.zeros((0, 2)), np.zeros((0, 6))
    none = np.zeros(0, np.int64)
    return Bending(
        zero, zero, np.zeros((3, 0)), none, pairs, pairs, natural, zero, rows, rows, rows
    )


def add_bending(
    scene: Scene, layout: Layout, system: System, state: State, keep: Pieces
) -> tuple[System, State]:
    """Return system and state with their bending; as they are where no rope has any."""
    if not layout.bends:
        return system, state
    n, count = layout.nodes, len(scene.anchors) if layout.clamped else 0
    stiffness, damping, natural = keep("bends", _bends, layout, tuple(map(_bend, scene.ropes)))
    clamps: tuple[np.ndarray, ...] = no_bending()[3:]
    if count:
        ropes = tuple(scene.rope_named(anchor.rope) for anchor in scene.anchors)
        clamps = keep("clamps", _clamps, scene.anchors, ropes)
    system = system._replace(
        flags=system.flags.copy(),
        bending=Bending(stiffness, damping, natural, *clamps),
    )
    system.flags[BENDING] = 1
    free = np.ones(n)
    for span in layout.ropes:  # nothing bends on a drum, nor where it leaves it
        free[span.first : span.start + 1] = free[span.end : span.last + 1] = 0.0
    held = [row for row in range(count) if system.anchors.release[row] > 0.0]
    free[[layout.anchor_nodes[r] for r in held if system.bending.clamped[r]]] = 0.0
    state = state._replace(
        bending_stiffness=free * stiffness,
        bending_damping=free * damping,
        clamp_direction=system.bending.direction.copy(),
        clamp_spin=_first_spin(system.bending) if count else np.zeros((0, 3)),
        moment=np.zeros((count, 6)),
        forces=state.forces._replace(bending=np.zeros((3, n + 1))),
        work=state.work._replace(bending=np.zeros(layout.segments), clamps=np.zeros(count)),
        peaks=state.peaks._replace(moment=np.full(count if scene.run.extremes else 0, -np.inf)),
    )
    return system, state


def _bend(rope: Rope) -> tuple[Any, ...] | None:
    """What a rope's bends follow from: stiffness and damping of one, curvature, segment length."""
    if not isinstance(rope.made_of, Material):
        return None
    length, made_of = rope.segment_length, rope.made_of
    return made_of.EI / length, made_of.bending_damping / length, made_of.curvature, length


def _bends(
    layout: Layout, ropes: tuple[tuple[Any, ...] | None, ...]
) -> tuple[Floats, Floats, Floats]:
    """Return stiffness, damping (n,) and natural binormal (3, n) of the bends at all nodes."""
    n = layout.nodes
    stiffness, damping, natural = np.zeros(n), np.zeros(n), np.zeros((3, n))
    for rope, span in zip(ropes, layout.ropes, strict=True):
        if rope is not None:
            inner = slice(span.first + 1, span.last)  # on a drum, too
            stiffness[inner], damping[inner], curvature, length = rope
            natural[:, inner] = binormal(curvature, length)[:, None]
    return stiffness, damping, natural


def binormal(bent: Sequence[float], length: float) -> Floats:
    """Return the curvature binormal of the unloaded rope where it turns along `length` [m], (3,).

    2 tan(curvature * length / 2) about the axis, so that a rope of length 2 pi / curvature closes.
    """
    curvature = np.array(bent, dtype=np.float64)
    size = float(np.linalg.norm(curvature))
    return curvature * (2.0 * np.tan(0.5 * size * length) / size) if size > 0.0 else curvature


def _clamps(anchors: tuple[Anchor, ...], ropes: tuple[Rope, ...]) -> tuple[np.ndarray, ...]:
    """Return the clamps' tables in the order of `Bending`, one row per anchor with its rope."""
    a = len(anchors)
    clamped, stiffness, damping = np.zeros(a, np.int64), np.zeros((a, 2)), np.zeros((a, 2))
    natural, turn, own = np.zeros((a, 6)), np.zeros((a, 3)), np.zeros(a)
    direction, axis = np.zeros((a, 3)), np.zeros((a, 3))
    for row, (anchor, rope) in enumerate(zip(anchors, ropes, strict=True)):
        if anchor.clamp is None:
            continue
        clamped[row], own[row] = 1, rope.segment_length
        made_of, half = rope.made_of, 0.5 * rope.segment_length
        assert isinstance(made_of, Material)
        for side in _sides(rope, anchor):
            stiffness[row, side] = 2.0 * made_of.EI / rope.segment_length
            damping[row, side] = 2.0 * made_of.bending_damping / rope.segment_length
            natural[row, 3 * side : 3 * side + 3] = binormal(made_of.curvature, half)
        direction[row], axis[row] = _unit(anchor.clamp.direction), _unit(anchor.clamp.turn_axis)
        turn[row] = _turn(anchor.clamp)
    return clamped, stiffness, damping, natural, own, direction, axis, turn


def _sides(rope: Rope, anchor: Anchor) -> list[int]:
    """Tell on which sides of an anchored node there is rope: 0 before it, 1 after it."""
    node = rope.node_index(anchor.node)
    return [side for side, is_there in ((0, node > 0), (1, node < rope.segments)) if is_there]


def _turn(clamp: Clamp) -> tuple[float, float, float]:
    return clamp.turn_rate, clamp.start, clamp.stop


def _first_spin(bending: Bending) -> Floats:
    """Return the angular velocity of every clamp at time zero [rad/s], (a, 3)."""
    rate, start, stop = bending.turn.T
    turning = np.where((start <= 0.0) & (stop > 0.0), rate, 0.0)
    return np.ascontiguousarray(turning[:, None] * bending.axis)


def _unit(vector: object) -> Floats:
    array = np.asarray(vector, dtype=np.float64)
    return np.asarray(array / np.linalg.norm(array))
