"""What couples nodes that are no neighbours, in the equations of rest: ropes on ropes, slides."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from ropewalk.core import arrays
from ropewalk.core.arrays import BENDING, Floats, Ints, State, System
from ropewalk.core.elimination import tied_network
from ropewalk.core.network import Network
from ropewalk.laws.acting import acting
from ropewalk.laws.couplings import FINE, HALVE
from ropewalk.laws.others import coupled_tangent, keep_couplings, meet_others
from ropewalk.laws.pairs.force import pair_rounding
from ropewalk.laws.pairs.pairs_at_rest import straighten
from ropewalk.laws.pairs.table import CONTACTS, FAULT, SETTLES, SPRING
from ropewalk.laws.slides.slide_force import bound_of
from ropewalk.laws.winch import joined

Entries = tuple[
    Ints, Ints, Floats
]  # rows, columns, values of a matrix over all places, node by node

_BEGINS = 0.03  # [s] the time of a step, for what contacts carry over as they are found anew
_ASKEW = 0.48, 0.6, 0.64  # [N] a force along no normal, but by chance; only that it is one counts
ROOM = "ropes touch in more places than there is room for: take fewer segments"
_EPS = float(np.finfo(float).eps)

#: `bound_of` as plain Python: what goes into kernels has no machine code of its own on disk, and would get
#: some in every process.
bound_there = getattr(bound_of, "py_func", bound_of)


class NoRoom(ArithmeticError):  # noqa: N818 - it is what happened, not a mistake
    """More is coupled than there is room for."""


class Couplings:
    """The laws of a model between nodes that are no neighbours."""

    def __init__(self, system: System, state: State) -> None:
        self.system, self.state = system, state
        self.acts = any(law.couple is not None for law, _ in acting(system))
        self._network = self._make_network() if self.acts else None
        self.touch, self.slide = bool(system.node.contact.radius.size), system.node.slide

    def _make_network(self) -> Network:
        state, memory = self.state, self.state.memory
        alive, bends = joined(self.system, state), bool(self.system.flags[BENDING])
        groups = len(memory.slide.group) + len(memory.contact.pair)
        return tied_network(self.system.joints, state.tied, alive, bends, groups)

    def entries(self, x: Floats, weight_x: float = 1.0, weight_v: float = 0.0) -> Entries | None:
        """Return -(weight_x df/dx + weight_v df/dv) at places (3, n) [m]; None where there is no room."""
        network, still = self._network, np.zeros_like(x)
        assert network is not None
        if not coupled_tangent(self.system, self.state, x, still, weight_x, weight_v, network):
            return None
        return _entries(network)

    def stiffness(self) -> Floats:
        """Return how stiff these laws are at every node [N/m], (n,), where they act at all."""
        found, table = np.zeros(self.state.x.shape[1]), self.system.node.contact
        if self.touch:
            stiff = np.where(table.rope >= 0, 0.5 / np.maximum(table.soft, 1e-300), 0.0)
            found[:-1] = stiff
            found[1:] = np.maximum(found[1:], stiff)
        for row in range(len(self.slide.node)):
            line = slice(int(self.slide.first[row]), int(self.slide.last[row]) + 1)
            found[line] = np.maximum(found[line], self.slide.stiffness[row])
            node = self.slide.node[row]
            found[node] = max(found[node], self.slide.stiffness[row])
        return found

    def longest(self) -> float:
        """Return how far nodes may go in one step of creeping so that none loses its rope [m]."""
        return float(self.slide.length.min(initial=math.inf))

    def rounding(self, x: Floats) -> float:
        """Return what rounding of places (3, n) [m] makes of these forces [N]."""
        found, stiff = 0.0, float(self.slide.stiffness.max(initial=0.0))
        if self.touch:
            found = float(pair_rounding(x, self.system.node.contact, self.state.memory.contact))
        return max(found, 16.0 * _EPS * float(np.abs(x).max()) * stiff)

    def small_motions(self, x: Floats) -> tuple[Entries, Entries]:
        """Return stiffness and friction about places (3, n) [m]."""
        whole = self.kept()
        self._let_go()
        stiff, rubs = self.entries(x), self.entries(x, 0.0, 1.0)
        self.restore(whole)
        if stiff is None or rubs is None:
            raise NoRoom(ROOM)
        return stiff, rubs

    def _let_go(self) -> None:
        """Let contacts of ropes without friction slip: one that carries nothing counts as stuck."""
        if not self.touch:
            return
        contact, table = self.state.memory.contact, self.system.node.contact
        grip = contact.grip[: contact.tally[CONTACTS]]
        first, second = table.rope[contact.pair[: len(grip)].T]
        grip[table.friction[first, second] == 0.0, SPRING : SPRING + 3] = _ASKEW

    # -- memory ----------------------------------------------------------------------------

    def kept(self) -> tuple[Any, Any]:
        """Return a copy of what they carry."""
        memory = self.state.memory
        return arrays.copy(memory.contact), arrays.copy(memory.slide)

    def restore(self, kept: tuple[Any, Any]) -> None:
        """Let them carry again what they did."""
        arrays.assign(self.state.memory.contact, kept[0])
        arrays.assign(self.state.memory.slide, kept[1])

    def meets(self, start: Floats, end: Floats) -> int:
        """Tell whether the way between two places (3, n) may stand, see `laws.couplings`."""
        if not self.touch:
            return FINE
        self.state.x[...] = start
        found = int(meet_others(self.system, self.state, end))
        return HALVE if self.fails else found

    @property
    def fails(self) -> bool:
        """Whether there is no room for what touches, or ropes came through each other."""
        return self.touch and self.state.memory.contact.tally[FAULT] != 0

    def remember(self, x: Floats, *, at_last: bool) -> None:
        """Let them keep what they carry at places (3, n) [m]; at last contacts have their own depth."""
        state = self.state
        state.x[...] = x
        state.now[0], state.now[1] = (math.inf if at_last else _BEGINS), 0.0
        if self.touch:
            state.memory.contact.tally[SETTLES] = 1
        keep_couplings(self.system, state)
        if self.touch:
            state.memory.contact.tally[SETTLES] = 0
        state.now[:2] = 0.0

    def straighten(self, x: Floats) -> None:
        """Give contacts points and normals as they are at places (3, n) [m]."""
        if self.touch:
            straighten(x, self.system.node.contact, self.state.memory.contact, self.state.tied)


def _entries(network: Network) -> Entries:
    number, points = network.number, len(network.diagonal)
    lead = np.empty(points, np.int64)
    lead[number[::-1]] = np.arange(number.size)[::-1]
    count = int(network.start[points])
    row = np.repeat(np.arange(points), np.diff(network.start[: points + 1]))
    column = network.later[:count]
    first = lead[np.concatenate([np.arange(points), row, column])]
    second = lead[np.concatenate([np.arange(points), column, row])]
    values = np.concatenate([network.diagonal, network.upper[:count], network.lower[:count]])
    one, two = np.divmod(np.arange(9), 3)
    rows, columns = 3 * first[:, None] + one, 3 * second[:, None] + two
    there = values != 0.0
    return rows[there], columns[there], values[there]
