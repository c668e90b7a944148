"""What a law of segments is: a pull along every segment, beside the spring's, by its length and its rate.

It is one file that ends in `of_segments(SegmentLaw(...))`, and an entry in `registry`. What a segment law has
to say is about one segment: how hard it pulls at a length and a rate. Forces on nodes, their tangent, works,
energy, tension and what the law remembers follow here, once for all of them; the rest of the program sees a
law of nodes (`node_law`), with all that it may leave out.

    T(r, r'),   F = T t on the first node, -F on the second,
    dF/dd = T_r t t^T + T/r P + T_r'/r t (P u)^T,   dF/du = T_r' t t^T

d the vector of the segment, r its length, t = d / r, P = I - t t^T, u the ends' relative velocity and
r' = u . t.
A segment without a spring (between two ropes, on a drum, parted) or without a length has no law either.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats, Ints
from ropewalk.core.jit import part
from ropewalk.laws.node_law import NodeLaw, Rest
from ropewalk.laws.stretch import stretched
from ropewalk.laws.stretch_tangent import add_line, add_turn

if TYPE_CHECKING:
    from ropewalk.lowering.layout import Layout


class SegmentLaw(NamedTuple):
    """A law of segments; j is a segment's number, `state.rest_length[j]` its length without tension [m]."""

    name: str
    section: str  # the field of a rope that it is made from
    # (what each rope has there, or None; layout): its table, a named tuple; see `along`
    lower: Callable[[tuple[Any, ...], Any], Any]
    acts: Callable[[Any], bool]  # (table): whether any segment has it
    # part (table, state, j, r, rate): the pull [N], its derivatives by length [N/m] and rate [N s/m]
    pull: Any
    # (table, lengths): a majorant for the bound of the step, (s,) each: of the slope T_r and of T/r [N/m], at
    # whatever length may come, and of T_r' [N s/m]
    most: Callable[[Any, Floats], tuple[Floats, Floats]]
    energy: Any = None  # part (table, state, j, r): what it stores [J]; None: nothing
    # A law with a memory: state.memory.NAME. From state.now[0] - state.now[1] the time since [s] is known.
    memory: Callable[[Any, Floats], Any] | None = (
        None  # (table, lengths): at the start, arrays (s + 1,)
    )
    remember: Any = None  # part (table, state, j, r): write it, where a step was accepted
    relaxed: Callable[[Any], Any] | None = (
        None  # (table): what is left of the law at rest; None: all
    )


def along(layout: Layout, values: tuple[float, ...]) -> Floats:
    """Return a number per segment, (s,): a rope's own all along it, 0 between ropes."""
    found = np.zeros(layout.nodes - 1)
    for value, span in zip(values, layout.ropes, strict=True):
        found[span.first : span.last] = value
    return found


def of_segments(law: SegmentLaw) -> NodeLaw:
    """Return a law of segments as the law of nodes that it is."""
    remembers = law.memory is not None
    return NodeLaw(
        name=law.name,
        section=law.section,
        of_ropes=True,
        lower=lambda sections, layout: law.lower(sections or (None,) * len(layout.ropes), layout),
        inputs=("layout",),
        acts=law.acts,
        force=_force(law),
        tangent=_tangent(law),
        carried=_carried(law),
        energy=None if law.energy is None else _energy(law),
        memory=_memory(law) if remembers else None,
        remember=_remember(law) if remembers else None,
        relaxed=law.relaxed,
        at_rest=_at_rest(law),
        chain=_chain(law),
    )


def _force(law: SegmentLaw) -> Any:
    pull = law.pull

    @part
    def _pull_nodes(table, state, x, v, force, lo, hi):
        last = x.shape[1] - 1
        if lo == 0:
            force[0, 0], force[1, 0], force[2, 0] = 0.0, 0.0, 0.0
        for j in range(lo, min(hi, last)):
            dx, dy, dz = x[0, j + 1] - x[0, j], x[1, j + 1] - x[1, j], x[2, j + 1] - x[2, j]
            ux, uy, uz = v[0, j + 1] - v[0, j], v[1, j + 1] - v[1, j], v[2, j + 1] - v[2, j]
            r = math.sqrt(dx * dx + dy * dy + dz * dz)
            over = 0.0
            if state.stiffness[j] > 0.0 and r > 0.0:
                rate = (ux * dx + uy * dy + uz * dz) / r
                found = pull(table, state, j, r, rate)
                over = found[0] / r
            force[0, j] += over * dx
            force[1, j] += over * dy
            force[2, j] += over * dz
            force[0, j + 1], force[1, j + 1], force[2, j + 1] = -over * dx, -over * dy, -over * dz

    return _pull_nodes


def _tangent(law: SegmentLaw) -> Any:
    pull = law.pull

    @part
    def _differ(table, state, x, v, weight_x, weight_v, marks, band):
        for j in range(x.shape[1] - 1):
            dx, dy, dz = x[0, j + 1] - x[0, j], x[1, j + 1] - x[1, j], x[2, j + 1] - x[2, j]
            ux, uy, uz = v[0, j + 1] - v[0, j], v[1, j + 1] - v[1, j], v[2, j + 1] - v[2, j]
            r = math.sqrt(dx * dx + dy * dy + dz * dz)
            if state.stiffness[j] > 0.0 and r > 0.0:
                tx, ty, tz = dx / r, dy / r, dz / r
                rate = ux * tx + uy * ty + uz * tz
                found = pull(table, state, j, r, rate)
                across, slope = weight_x * found[0] / r, weight_x * found[1]
                add_line(band, j, tx, ty, tz, across, slope + weight_v * found[2])
                q = weight_x * found[2] / r
                px, py, pz = q * (ux - rate * tx), q * (uy - rate * ty), q * (uz - rate * tz)
                add_turn(band, j, tx, ty, tz, px, py, pz)

    return _differ


def _carried(law: SegmentLaw) -> Any:
    pull = law.pull

    @part
    def _add_pulls(table, state, x, v, tension):
        for j in range(tension.shape[0]):
            dx, dy, dz = x[0, j + 1] - x[0, j], x[1, j + 1] - x[1, j], x[2, j + 1] - x[2, j]
            ux, uy, uz = v[0, j + 1] - v[0, j], v[1, j + 1] - v[1, j], v[2, j + 1] - v[2, j]
            r = math.sqrt(dx * dx + dy * dy + dz * dz)
            if state.stiffness[j] > 0.0 and r > 0.0:
                found = pull(table, state, j, r, (ux * dx + uy * dy + uz * dz) / r)
                tension[j] += found[0]

    return _add_pulls


def _energy(law: SegmentLaw) -> Any:
    stored = law.energy

    @part
    def _add_up(table, state, x):
        total = 0.0
        for j in range(x.shape[1] - 1):
            if state.stiffness[j] > 0.0:
                total += stored(table, state, j, stretched(x, j))
        return total

    return _add_up


def _memory(law: SegmentLaw) -> Any:
    begin = law.memory

    def memory(table: Any, x: Floats, _stiffness: Floats, _held: Ints) -> Any:
        lengths = np.sqrt((np.diff(x, axis=1) ** 2).sum(axis=0))
        return begin(table, lengths) if begin is not None else None

    return memory


def _remember(law: SegmentLaw) -> Any:
    keep = law.remember

    @part
    def _keep_all(table, state):
        for j in range(state.stiffness.shape[0]):
            if state.stiffness[j] > 0.0:
                keep(table, state, j, stretched(state.x, j))
        return 0.0

    return _keep_all


def _at_rest(law: SegmentLaw) -> Callable[[Any], Rest]:
    def at_rest(table: Any) -> Rest:
        left = table if law.relaxed is None else law.relaxed(table)
        return Rest.PULLS if law.acts(left) else Rest.NOTHING

    return at_rest


def _chain(law: SegmentLaw) -> Callable[..., Any]:
    def chain(table: Any, chain: Any, lengths: Floats, speed: float) -> Any:
        if not law.acts(table):
            return chain
        slope, rubbing = law.most(table, lengths)
        alive = chain.stiffness > 0.0
        return chain._replace(
            stiffness=chain.stiffness + np.where(alive, slope, 0.0),
            damping_axial=chain.damping_axial + np.where(alive, rubbing, 0.0),
        )

    return chain
