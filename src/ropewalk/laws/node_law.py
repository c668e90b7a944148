"""What a law of nodes is: all that the program asks of it.

A law of nodes puts a force on every node that follows from the places and velocities of the node and of its
neighbours. It is one file that ends in a `NodeLaw`, and an entry in `registry`; `nodes` folds the parts of
all laws into one function each, so that a registered law costs what a call by name did. Its table is
`system.node.NAME`, its force `forces.node.NAME` (3, n) [N], its work `work.node.NAME` (n,) [J]; the work is
recorded under its name. What it remembers of the last accepted step is `state.memory.NAME`. `state.now` holds
the time for which forces are evaluated, and that of the last accepted step [s].

Parts are compiled (`core.jit.part`) and get the law's table first, of a law that acts. Those that are None
are left out.
"""

from __future__ import annotations

from collections.abc import Callable
from enum import Enum
from typing import Any, NamedTuple

from ropewalk.core.arrays import Floats
from ropewalk.core.jit import part


class Rest(Enum):
    """What a law does to nodes at rest."""

    NOTHING = 0  # it asks for motion
    CARRIES = 1  # it carries along what nothing holds, as a wind does
    BEARS = 2  # it bears what lies on it
    HOLDS = 3  # it has a place for every node
    PULLS = 4  # it pulls neighbours together or apart, and holds no rope anywhere


@part
def always(table):
    """Say yes."""
    return True


@part
def never(table):
    """Say no."""
    return False


@part
def has_any(table, state):
    """Say yes."""
    return True


class NodeLaw(NamedTuple):
    """A law of nodes. x and v are (3, n), [m] and [m/s]; `marks` (n,) are the law's own."""

    name: str
    section: str  # the field or property of the scene that it is made from
    lower: Callable[..., Any]  # (section or None, *inputs): its table, a named tuple
    # what else that follows from: "layout", "diameters", "ropes", "up", "gravity", "whole", "joints",
    # "parts", "masses"
    inputs: tuple[str, ...]
    acts: Callable[[Any], bool]  # (table): whether there is any force
    # part (table, state, x, v, force, lo, hi): write it, for nodes `lo` to `hi - 1`; None: there is never any
    force: Any
    # part (table, state, x, v, weight_x, weight_v, marks, band): add -(weight_x dF/dx + weight_v dF/dv)
    tangent: Any

    # What begins and ends abruptly: marked in the first iterations of a step that is solved for, then kept.
    mark: Any = None  # part (table, x, marks): mark the nodes it acts on; return how many changed
    # part (table, state, x, v, marks, frozen, force): as `force`, for the marks; beyond them where `frozen`
    marked_force: Any = None
    # part (table, before, after, dt, tolerance): when a step is to end for its first event, and how many
    crossings: Any = None

    # A tangent that is a multiple of one for every node, and of velocities only, needs no blocks.
    is_diagonal: Any = None  # part (table): whether it is so
    # part (table, weight_v, free, diagonal): add it for free nodes, (n,); 0 where the law does not act
    add_diagonal: Any = None

    energy: Any = None  # part (table, state, x): potential energy [J], which its work takes up
    power: Any = (
        None  # part (table, state, x): the most that it can put in per time beyond that [W]
    )

    given: Any = None  # part (table, state, x): what it has put in so far beyond that [J], where that is kept
    still: Any = (
        None  # part (table): whether all that it touches with stands, so that it gives nothing
    )

    is_local: Any = (
        None  # part (table): whether its tangent writes the blocks on the band's diagonal only
    )

    # A law with a memory. It is part of the state, and so of snapshots, islands and checkpoints.
    # (table, x, stiffness of the segments, held): at the start, a named tuple of arrays, the last axis counts
    # nodes; `held` (n,) is 1 where an anchor or a drum holds a node
    memory: Callable[..., Any] | None = None
    remember: Any = (
        None  # part (table, state): write it, where a step was accepted; return what it hit
    )
    # part (table, state, force, middle, dt): book a step's mean forces, see `ledger`, once it is remembered
    book: Any = None
    channels: Callable[[Any], int] | None = None  # (table): rows of its force, 3 and its own
    # part (table, state, force, dt, x, v): how quickly what is hit in a step from the state to there, under
    # its mean force, is stopped [1/s]; 0: nothing is
    hits: Any = None
    touch: Any = (
        None  # part (table, state, force): add what touches the nodes at the state [N], (3, n)
    )
    # part (table, state, x): what rounding of the places does to the force of a stiff one [N]
    rounding: Any = None

    # A law between nodes that are no neighbours. Its force is on nodes, as that of all others.
    pattern: Any = (
        None  # part (table, state, x, network): ask for the groups of four nodes that it couples
    )
    ordered: Any = None  # part (table, state, fits): whether there was room for those of all laws
    # part (table, state, x, v, weight_x, weight_v, network): add -(weight_x dF/dx + weight_v dF/dv)
    couple: Any = None
    couples_any: Any = None  # part (table, state): whether there are any such groups; None: always
    along: Any = (
        None  # part (table, state, x, v, d, weight_x, weight_v): d . K d of it [N m], d (3, n) [m]
    )
    # part (table, state, x): whether a step from the state to there may stand: 0, is to be solved again
    # with what was found on its way: 1, or to be halved: 2
    meet: Any = None
    # part (table, state, dt, every): get ready for what a step of `dt` [s] may hit: with what is new to it,
    # or, for a method that shortens steps for that, with `every` one
    brace: Any = None
    fault: Any = None  # part (table, state): not 0 where the run cannot go on
    wound: Any = None  # part (table, state, winches): nodes have gone on to drums, or come off
    parted: Any = None  # part (table, state, segment, time): a segment has parted, at `time` [s]

    # A law of segments is made by `segment_law`.
    of_ropes: bool = False  # its section is a field of every rope
    carried: Any = (
        None  # part (table, state, x, v, tension): add what it carries along segments [N], (s,)
    )
    relaxed: Callable[[Any], Any] | None = (
        None  # (table): the table of a law whose memory has had all the time that it asks for
    )

    hold_up: Any = (
        None  # part (table, x, v): put an anchor, (3,) each, on the surface that stops it
    )

    # For the host.
    kinks: Callable[[Any], Floats] | None = None  # (table): when what it does changes abruptly [s]
    at_rest: Callable[[Any], Rest] | None = None  # (table), of a law that acts; None: HOLDS
    bears: Callable[[Any, Floats], Any] | None = None  # (table, x): which nodes lie on it, (n,)
    flow: Callable[[Any], Floats] | None = None  # (table): velocity of what flows [m/s], (3,)
    # For the bound of the step: a majorant of its stiffness and damping. (table, chain, lengths, speed) gives
    # the chain under it where nodes move at most so fast [m/s]; (table, chain) gives what may be besides, by
    # the name of the case.
    chain: Callable[..., Any] | None = None
    cases: Callable[..., dict[str, Any]] | None = None
