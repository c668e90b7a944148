"""What the kernels get: constant tables (`System`) and what evolves (`State`).

n nodes, s = n - 1 segments, one rope after another; the segment between two ropes is dead (stiffness,
damping and rest length 0). Vectors are `(3, n)`, so that loops over nodes run over contiguous memory.
Forces of segments are `(3, n + 1)`: column j + 1 holds what segment j does to node j (and, with the
opposite sign, to node j + 1); columns 0 and n stay zero, so that no loop needs an edge case.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ropewalk.core.peaks import Peaks

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

# Places in `System.flags`.
APPLIED, AXIAL, TENSION_ONLY, BENDING = range(4)


class Limiter(NamedTuple):
    """Stretch limiter: order and shares of its sweep."""

    active: int
    shortest: float  # least allowed stretch [1]
    longest: float  # largest allowed stretch [1]
    passes: int
    order: Ints  # (s',) segments from the anchors outward
    share: Floats  # (s',) part of the correction given to node j (the rest goes to node j + 1)
    anchor: Ints  # (s') row of the anchor that the share goes by, -1: none
    joint: Ints  # (2, s') the joints of these two nodes, -1: none


class Anchors(NamedTuple):
    """Anchors and their motions, one row each."""

    release: Floats  # (a,) [s], inf: never
    first_release: float  # [s] the least of them
    above_ground: Ints  # (a,)
    kind: Ints  # (a,) code of the motion
    params: Floats  # (a, 16) parameters of the motion
    table_start: Ints  # (a,) first row of the motion's own table
    table_rows: Ints  # (a,)
    table: Floats  # (rows, 13) time, then cubic coefficients of x, y, z
    order: Ints  # (a,) rows by the node they hold at the start
    alike: Ints  # (a,) whether it goes as all go that hold the same ropes


class Winches(NamedTuple):
    """Winches, one row each. `step` is +1 where the rope lies above the drum's index, else -1."""

    anchor: Ints  # (w,) the anchor that carries the drum
    first: Ints  # (w,) node at the rope's end on the drum
    last: Ints  # (w,) node at the rope's other end
    step: Ints  # (w,) +1 at the rope's start, -1 at its end
    load: Ints  # (w,) the next node with a load, which does not come on to the drum; -1: none
    speed: Floats  # (w,) [m/s], + pays out
    start: Floats  # (w,) [s]
    stop: Floats  # (w,) [s]
    segment: Floats  # (w,) nominal segment length [m]
    shortest: Floats  # (w,) [m] stop of reeling in
    longest: Floats  # (w,) [m] stop of paying out
    drum: Floats  # (w,) [m] rope that waits on the drum at the start
    EA: Floats  # (w,) [N]
    vector: Floats  # (w,) vector friction times length [N s]
    axial: Floats  # (w,) axial friction times length [N s]
    line: Floats  # (w,) mass per length [kg/m]


class Bending(NamedTuple):
    """Bending stiffness at the nodes, and the anchors that hold a direction, one row per anchor."""

    stiffness: Floats  # (n,) EI over half the two rest lengths [N m]; 0 where there is no bend
    damping: Floats  # (n,) the same of the bending damping [N m s]
    natural: Floats  # (3, n) curvature binormal of the unloaded rope [1]
    clamped: Ints  # (a,) 1 for an anchor that holds a direction
    clamp_stiffness: Floats  # (a, 2) of the half cells before and after the node [N m]
    clamp_damping: Floats  # (a, 2) [N m s]
    clamp_natural: Floats  # (a, 6) [1]
    clamp_length: Floats  # (a,) length of a segment that these are for [m]
    direction: Floats  # (a, 3) unit vector at time zero
    axis: Floats  # (a, 3) unit vector about which it turns
    turn: Floats  # (a, 3) rate [rad/s], start [s], stop [s]


class Elastic(NamedTuple):
    """Laws of segments whose tension is no straight line of the strain; see `laws.elastic_law`."""

    of: Ints  # (s,) the law of every segment by its place in the list, -1: Hooke's
    time: Floats  # (s,) in which a segment forgets [s], inf: never; (0,) where all are Hooke's
    table: Any  # the tables of the laws, by name; see `laws.registry`


class Joints(NamedTuple):
    """Joints, and which of them every anchor holds; `member` is cut at `first`."""

    first: Ints  # (j + 1,) into the members
    member: Ints  # (p,) nodes, those of a joint side by side
    of_anchor: Ints  # (a,) the joint whose node the anchor holds, -1: none


class System(NamedTuple):
    """All that stays the same during a run."""

    gravity: Floats  # (3,) [m/s^2]
    flags: Ints  # (4,) which optional parts act: APPLIED, AXIAL, TENSION_ONLY, BENDING
    break_stretch: float  # [1] a segment stretched more than this is a broken simulation
    slack_floor: Floats  # (s,) least elastic tension [N]: 0 for tension-only segments, else -inf
    up: Floats  # (3,) unit vector against gravity
    node: Any  # the tables of the laws of nodes, by name; see `laws.registry`
    acts: Ints  # (m,) 1 for each of these laws that acts
    limiter: Limiter
    anchors: Anchors
    winches: Winches
    bending: Bending
    joints: Joints
    elastic: Elastic
    kinks: Floats  # (k,) times at which the velocity of an anchor or clamp jumps [s], sorted
    rare: (
        int | None
    )  # 1 where a law beyond springs, friction, weight and anchors acts; see `laws.rare`


class Forces(NamedTuple):
    """Forces of the last evaluation [N], by law."""

    elastic: Floats  # (3, n + 1)
    friction: Floats  # (3, n + 1)
    node: Any  # (3, n) each, by name of the law of nodes
    applied: Floats  # (3, n)
    bending: Floats  # (3, n + 1) elastic part only; (3, 0) where no rope has bending stiffness
    limiter: Floats  # (3, n + 1) at a bound, of implicit methods; (3, 0) without a limiter


class Work(NamedTuple):
    """Work done on the rope so far [J], by law; per segment, per node, or in all."""

    elastic: Floats  # (s,)
    friction: Floats  # (s,)
    weight: Floats  # (n,)
    node: Any  # (n,) each, by name of the law of nodes
    applied: Floats  # (n,)
    anchors: Floats  # (a,)
    limiter: Floats  # (2,) kinetic, potential
    winch: Floats  # (2,) kinetic, potential
    bending: Floats  # (s,); (0,) where no rope has bending stiffness
    clamps: Floats  # (a,) by turning clamped directions; (0,) where none is clamped


class State(NamedTuple):
    """All that evolves; a copy of it restarts a run to the same bits."""

    x: Floats  # (3, n) positions [m]
    v: Floats  # (3, n) velocities [m/s]
    acceleration: Floats  # (3, n) [m/s^2], of the last evaluation
    mass: Floats  # (n,) [kg]
    inverse_mass: Floats  # (n,) [1/kg], 0 for held nodes
    tension: Floats  # (s,) [N] of the last stage of an implicit method, its next guess
    limited: (
        Floats  # (s,) [N] of an explicit method's limiter, mean over the last step; (0,) without
    )
    drift: Floats  # (3, n) what the last step moved the nodes by [m], for multistep methods
    # (6,) last step [s], 0: none; anchors held and sum of winch exits in it; the parts that the next step
    # begins with, see `methods.part_lengths`
    past: Floats
    rest_length: Floats  # (s,) [m]
    stiffness: Floats  # (s,) [N/m]
    damping_vector: Floats  # (s,) [N s/m]
    damping_axial: Floats  # (s,) [N s/m]
    held: Ints  # (a,) 1 while the anchor holds its node
    anchor_node: Ints  # (a,) the node it holds; a winch changes it
    anchor_x: Floats  # (a, 3) [m]
    anchor_v: Floats  # (a, 3) [m/s]
    reaction: Floats  # (a, 3) force of the anchor on the rope, mean over the last step [N]
    winch_exit: Ints  # (w,) the last node on the drum
    winch_rate: Floats  # (w,) growth of the working segment's length [m/s], of the last step
    winch_debt: Floats  # (w,) unstretched length still to be given back [m]
    winch_paid: Floats  # (w,) rope paid out since the start, less what was reeled in [m]
    bending_stiffness: Floats  # (n,) [N m], 0 at clamped nodes; (0,) without bending, as the next
    bending_damping: Floats  # (n,) [N m s]
    clamp_direction: Floats  # (a, 3) unit vector; (0, 3) where none is clamped, as the next two
    clamp_spin: Floats  # (a, 3) its angular velocity [rad/s]
    moment: (
        Floats  # (a, 6) of the clamps on the rope at the last step's end [N m]: elastic, friction
    )
    tied: Ints  # (j,) 1 while the joint ties its nodes
    joint_force: Floats  # (p, 3) force of a joint on each of its nodes, mean over the last step [N]
    now: Floats  # (2,) time of the forces in hand, and of what laws of nodes remember [s]
    jolt: Floats  # (1,) 1 where something was hit in the last step: a method that rings goes on softly
    memory: Any  # by name of the law of nodes, (0,) of one without
    forces: Forces
    work: Work
    inner: Floats  # (4, s) what segments remember, see `laws.inner`; (4, 0): none does
    most: Floats  # (a + 1,) largest work so far of every anchor, and of all winches [J]
    balance: Floats  # (5,) [J], for the verdict, see `core.status`
    peaks: Peaks


def copy(value: Any) -> Any:
    """Copy a (nested) named tuple of arrays."""
    if isinstance(value, tuple):
        return type(value)(*(copy(item) for item in value))
    return value.copy() if isinstance(value, np.ndarray) else value


def blank(value: Any) -> Any:
    """Return zeros of the same shapes as a (nested) named tuple of arrays."""
    if isinstance(value, tuple):
        return type(value)(*(blank(item) for item in value))
    return np.zeros_like(value)


def assign(target: Any, source: Any) -> None:
    """Copy the arrays of one named tuple into those of another of the same shapes."""
    for to, item in zip(target, source, strict=True):
        if isinstance(to, tuple):
            assign(to, item)
        else:
            to[...] = item


def flatten(value: Any, prefix: str = "") -> dict[str, Floats]:
    """Return the arrays of a nested named tuple by dotted name."""
    found: dict[str, Floats] = {}
    for name, item in zip(value._fields, value, strict=True):
        if isinstance(item, tuple):
            found |= flatten(item, f"{prefix}{name}.")
        else:
            found[prefix + name] = item
    return found


def pooled(state: State, pool: Floats | None = None) -> tuple[State, Floats]:
    """Return a copy of `state` whose arrays lie in one, and that one, (m,): a single loop copies it all.

    Whole numbers lie there by their bits. What the steps were looked at for stays in the arrays it is in.
    `pool` is filled where one is given.
    """
    parts = {key: part for key, part in flatten(state).items() if not key.startswith("peaks.")}
    starts = np.cumsum([0] + [-(-part.size // 8) * 8 for part in parts.values()])
    pool = np.zeros(int(starts[-1])) if pool is None else pool
    views = {}
    for start, (name, part) in zip(starts, parts.items(), strict=False):
        room = pool[start : start + part.size]
        views[name] = room.view(part.dtype).reshape(part.shape)
        views[name][...] = part
    return _nested(state, views, ""), pool


def _nested(like: Any, views: dict[str, Floats], prefix: str) -> Any:
    """Return a nested named tuple like `like` of arrays by dotted name."""
    found = (
        _nested(item, views, f"{prefix}{name}.")
        if isinstance(item, tuple)
        else views.get(prefix + name, item)
        for name, item in zip(like._fields, like, strict=True)
    )
    return type(like)(*found)
