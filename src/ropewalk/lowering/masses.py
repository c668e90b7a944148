"""The masses of a rope's nodes."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.lowering.layout import Layout, Span
from ropewalk.scene import Material, Rope, Springs
from ropewalk.theory.curve import steepest_chord


def line_density(rope: Rope) -> float:
    """Return mass per unstretched length [kg/m]; a spring rope's node mass over segment length."""
    if isinstance(rope.made_of, Material):
        return rope.made_of.mass_per_length
    length = rope.segment_length
    return rope.made_of.node_mass / length if length > 0.0 else 0.0


def line(rope: Rope) -> tuple[Any, ...]:
    """What the masses of a rope's nodes follow from: that of a node, whether halved at the ends, loads."""
    made_of, nodes = rope.made_of, rope.nodes
    loads = tuple((load.node % nodes, load.mass) for load in rope.loads)
    if isinstance(made_of, Springs):
        return made_of.node_mass, False, loads
    return made_of.mass_per_length * rope.segment_length, True, loads


def masses(layout: Layout, lines: tuple[tuple[Any, ...], ...]) -> tuple[Floats, Floats]:
    """Return the mass of every node, loads included [kg], and one over it, (n,) each."""
    mass = np.zeros(layout.nodes)
    for span, (own, halved, loads) in zip(layout.ropes, lines, strict=True):
        part = mass[span.start : span.end + 1]
        part[:] = own
        if halved:
            part[0] *= 0.5
            part[-1] *= 0.5
        for node, more in loads:
            part[node] += more
    return mass, np.divide(1.0, mass, out=np.zeros_like(mass), where=mass > 0.0)


def passing(rope: Rope, span: Span) -> tuple[float, ...]:
    """Return when a wave from the first segment of a rope that parts comes to each [s]; 0: rigid.

    Those on a drum are counted. It takes sqrt(m/k) to pass a node, k the stiffness by which a rope at its
    breaking load lets go.
    """
    if not math.isfinite(rope.strength):
        return ()
    inner = rope.own_mass / (rope.nodes if isinstance(rope.made_of, Springs) else rope.segments)
    mass = np.full(span.nodes, inner)
    for load in rope.loads:
        mass[span.spare_start + load.node % rope.nodes] += load.mass
    stiffness = rope.segment_stiffness
    if isinstance(rope.made_of, Material) and rope.made_of.curve is not None:
        curve = rope.made_of.curve
        steep = steepest_chord(curve.pieces, rope.strength) - rope.made_of.EA
        stiffness += steep / rope.segment_length
    return (0.0, *(float(time) for time in np.cumsum(np.sqrt(mass[1:-1] / stiffness))))
