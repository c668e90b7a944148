"""The laws of nodes together: every piece that they have, folded into one part.

A fold is a closure over a law and the fold of the laws after it, all of them parts. A law that does not act
costs a comparison, where compiled functions as values would cost 0.2 to 0.5 us a step.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

from ropewalk.core.jit import part
from ropewalk.core.ranges import ALL
from ropewalk.laws.node_law import NodeLaw, never
from ropewalk.laws.rare import acts
from ropewalk.laws.registry import NODE_LAWS

Make = Callable[[Any, int, Any], Any]


def fold(make: Make, end: Any, having: str = "force", laws: Any = NODE_LAWS) -> Any:
    """Return the part of all laws that have a piece: `make(law, its place, part of the laws after it)`.

    `end` is the part of no law.
    """
    found = end
    for k in reversed(range(len(laws))):
        if getattr(laws[k], having) is not None:
            found = make(laws[k], k, found)
    return found


# -- whether, and what force -------------------------------------------------------------


@part
def _no_forces(system, state, x, v, forces, lo, hi):
    pass


def _forcing(law: NodeLaw, k: int, rest: Any) -> Any:
    force = law.force

    @part
    def _node_forces(system, state, x, v, forces, lo, hi):
        if acts(system, k):
            table = system.node[k]
            force(table, state, x, v, forces.node[k], lo, hi)
        rest(system, state, x, v, forces, lo, hi)

    return _node_forces


node_forces = fold(_forcing, _no_forces)
"""node_forces(system, state, x, v, forces, lo, hi): write the forces of all laws that act."""


@part
def _no_marked_forces(system, state, x, v, band, forces):
    pass


def _forcing_marked(law: NodeLaw, k: int, rest: Any) -> Any:
    force, marked_force = law.force, law.marked_force

    @part
    def _as_ever(table, state, x, v, marks, frozen, channel):
        force(table, state, x, v, channel, 0, ALL)

    write = _as_ever if marked_force is None else marked_force

    @part
    def _marked_node_forces(system, state, x, v, band, forces):
        if acts(system, k):
            table = system.node[k]
            write(table, state, x, v, band.marks[k], band.frozen[0], forces.node[k])
        rest(system, state, x, v, band, forces)

    return _marked_node_forces


marked_node_forces = fold(_forcing_marked, _no_marked_forces)
"""marked_node_forces(system, state, x, v, band, forces): write them for what is marked in the band."""


@part
def _no_marks(system, x, band):
    return 0.0


def _marking(law: NodeLaw, k: int, rest: Any) -> Any:
    mark = law.mark

    @part
    def _mark_nodes(system, x, band):
        changed = 0.0
        if acts(system, k):
            changed += mark(system.node[k], x, band.marks[k])
        return changed + rest(system, x, band)

    return _mark_nodes


mark_nodes = fold(_marking, _no_marks, "mark")
"""mark_nodes(system, x, band): mark what the laws act on; return how many marks changed."""


# -- how the forces change -----------------------------------------------------------------


@part
def _no_tangents(system, state, x, v, weight_x, weight_v, band):
    pass


def _differing(law: NodeLaw, k: int, rest: Any) -> Any:
    tangent = law.tangent

    @part
    def _node_tangents(system, state, x, v, weight_x, weight_v, band):
        if acts(system, k):
            table = system.node[k]
            tangent(table, state, x, v, weight_x, weight_v, band.marks[k], band)
        rest(system, state, x, v, weight_x, weight_v, band)

    return _node_tangents


node_tangents = fold(_differing, _no_tangents)
"""node_tangents(system, state, x, v, weight_x, weight_v, band): add those of all laws that act."""


@part
def _all_are(system):
    return True


def all_are(piece: str) -> Any:
    """Return the part that tells whether all laws that act say yes to `piece`; a law without it says no."""

    def make(law: NodeLaw, k: int, rest: Any) -> Any:
        says = getattr(law, piece) or never

        @part
        def _are(system):
            return (not acts(system, k) or says(system.node[k])) and rest(system)

        return _are

    return fold(make, _all_are)


are_diagonal = all_are("is_diagonal")
"""are_diagonal(system): tell whether all tangents are a number for every node, and of velocities only."""
are_local = all_are("is_local")
"""are_local(system): tell whether all tangents have a block for every node, and no more."""


@part
def _no_diagonals(system, weight_v, free, diagonal):
    pass


def _weighing(law: NodeLaw, k: int, rest: Any) -> Any:
    add_diagonal = law.add_diagonal

    @part
    def _add_diagonals(system, weight_v, free, diagonal):
        add_diagonal(system.node[k], weight_v, free, diagonal)
        rest(system, weight_v, free, diagonal)

    return _add_diagonals


add_diagonals = fold(_weighing, _no_diagonals, "add_diagonal")
"""add_diagonals(system, weight_v, free, diagonal): add these numbers, (n,)."""


@part
def _no_crossings(system, before, after, dt, tolerance):
    return math.inf, 0


def _crossing(law: NodeLaw, k: int, rest: Any) -> Any:
    crossings = law.crossings

    @part
    def _node_crossings(system, before, after, dt, tolerance):
        end, changes = rest(system, before, after, dt, tolerance)
        if acts(system, k):
            table = system.node[k]
            own, more = crossings(table, before, after, dt, tolerance)
            end, changes = min(end, own), changes + int(more)
        return end, changes

    return _node_crossings


node_crossings = fold(_crossing, _no_crossings, "crossings")
"""node_crossings(system, before, after, dt, tolerance): see `methods.crossings.crossings`."""


@part
def _no_stop(system, x, v):
    pass


def _stopping(law: NodeLaw, k: int, rest: Any) -> Any:
    hold_up = law.hold_up

    @part
    def _hold_up(system, x, v):
        if acts(system, k):
            hold_up(system.node[k], x, v)
        rest(system, x, v)

    return _hold_up


hold_up = fold(_stopping, _no_stop, "hold_up")
"""hold_up(system, x, v): put an anchor that was moved too far on the surfaces that stop it, (3,) each."""


# -- memory ----------------------------------------------------------------------------------


@part
def nothing_to_remember(system, state):
    """Return that nothing was hit."""
    return 0.0


def remembering(law: NodeLaw, k: int, rest: Any) -> Any:
    remember = law.remember

    @part
    def _remember_nodes(system, state):
        hits = rest(system, state)
        if acts(system, k):
            hits += remember(system.node[k], state)
        return hits

    return _remember_nodes


_remember_all = fold(remembering, nothing_to_remember, "remember")


@part
def remember_step(system, state, t):
    """Let the laws keep what they need of a step that is accepted, at its end at time `t` [s]."""
    state.now[0] = t
    hits = _remember_all(system, state)
    state.now[1] = t
    state.jolt[0] = 1.0 if hits > 0.0 else 0.0


@part
def _nothing_hit(system, state, forces, dt, x, v):
    return 0.0


def _hitting(law: NodeLaw, k: int, rest: Any) -> Any:
    hits = law.hits

    @part
    def _hits(system, state, forces, dt, x, v):
        found = rest(system, state, forces, dt, x, v)
        if acts(system, k):
            found = max(found, hits(system.node[k], state, forces[k], dt, x, v))
        return found

    return _hits


hits = fold(_hitting, _nothing_hit, "hits")
"""hits(system, state, forces, dt, x, v): return how quickly what is hit in a step is stopped [1/s], or 0."""


@part
def _nothing_touches(system, state, force):
    pass


def _touching(law: NodeLaw, k: int, rest: Any) -> Any:
    touch = law.touch

    @part
    def _touch_nodes(system, state, force):
        if acts(system, k):
            touch(system.node[k], state, force)
        rest(system, state, force)

    return _touch_nodes


touch_nodes = fold(_touching, _nothing_touches, "touch")
"""touch_nodes(system, state, force): add what touches nodes at the state [N], (3, n)."""


@part
def _none_has_it(system):
    return False


def _asking(law: NodeLaw, k: int, rest: Any) -> Any:
    @part
    def _has_it(system):
        return acts(system, k) or rest(system)

    return _has_it


def whether(piece: str) -> Any:
    """Return the part that tells whether a law that acts has a piece."""
    return fold(_asking, _none_has_it, piece)


remembers = whether("remember")
"""remembers(system): tell whether a law that acts has a memory."""


# -- energy ----------------------------------------------------------------------------------


@part
def _nothing(system, state, x):
    return 0.0


def _adding_up(piece: str) -> Any:
    def make(law: NodeLaw, k: int, rest: Any) -> Any:
        amount = getattr(law, piece)

        @part
        def _total(system, state, x):
            total = 0.0
            if acts(system, k):
                total += amount(system.node[k], state, x)
            return total + rest(system, state, x)

        return _total

    return fold(make, _nothing, piece)


node_energy = _adding_up("energy")
"""node_energy(system, state, x): return the potential energy of all laws [J]."""
node_power = _adding_up("power")
"""node_power(system, state, x): return the most that they can put in per time beyond that [W]."""
node_given = _adding_up("given")
"""node_given(system, state, x): return what they have put in so far beyond that [J], where it is kept."""
node_rounding = _adding_up("rounding")
"""node_rounding(system, state, x): return what rounding of places does to the forces of stiff laws [N]."""


# -- channels --------------------------------------------------------------------------------


@part
def _no_channels(system, channels, others, p, q, lo, hi):
    pass


def on_channels(use: Any) -> Any:
    """Return the part that calls `use(channel, other, p, q, lo, hi)` for every law that acts.

    It takes the system, channels and others, one each by law, and what else `use` gets.
    """

    def make(law: NodeLaw, k: int, rest: Any) -> Any:
        @part
        def _on_channels(system, channels, others, p, q, lo, hi):
            if acts(system, k):
                use(channels[k], others[k], p, q, lo, hi)
            rest(system, channels, others, p, q, lo, hi)

        return _on_channels

    return fold(make, _no_channels)


@part
def _no_more_force(system, channels, i, c, total):
    return total


def _at_node(law: NodeLaw, k: int, rest: Any) -> Any:
    @part
    def _add_node_force(system, channels, i, c, total):
        if acts(system, k):
            total += channels[k][c, i]
        return rest(system, channels, i, c, total)

    return _add_node_force


add_node_force = fold(_at_node, _no_more_force)
"""add_node_force(system, channels, i, c, total): return `total` and component c of all forces on node i."""
