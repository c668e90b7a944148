"""What couples nodes that are no neighbours, in the equations of rest: ropes on ropes, slides."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ropewalk.core import arrays
from ropewalk.core.arrays import BENDING, Floats, Ints, State, System
from ropewalk.core.elimination import tied_network
from ropewalk.core.network import Network
from ropewalk.laws.acting import acting
from ropewalk.laws.couplings import FINE, HALVE
from ropewalk.laws.others import coupled_tangent, keep_couplings, meet_others
from ropewalk.laws.pairs.force import pair_rounding
from ropewalk.laws.pairs.pairs_at_rest import straighten
from ropewalk.laws.pairs.table import CONTACTS, FAULT, PUSH, SPRING
from ropewalk.laws.registry import NAMES
from ropewalk.laws.slides.slide_force import bound_of
from ropewalk.laws.slides.table import SPRING as HELD
from ropewalk.laws.winch import joined
from ropewalk.lowering.touching import SLIPS

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
        """Return stiffness and friction about places (3, n) [m]: what is at the limit of friction is free."""
        self._free_slides()
        free = self._at_limit()
        whole = self.kept()
        self._keep_contacts(~free)
        parts = [self.entries(x), self.entries(x, 0.0, 1.0)]
        if free.any():
            self.restore(whole)
            self._keep_contacts(free)
            smooth = self._without_friction()
            parts += [smooth.entries(x), smooth.entries(x, 0.0, 1.0)]
        self.restore(whole)
        if any(part is None for part in parts):
            raise NoRoom(ROOM)
        joined = [np.concatenate(both) for both in zip(*parts[::2], strict=True)]
        rubs = [np.concatenate(both) for both in zip(*parts[1::2], strict=True)]
        return (joined[0], joined[1], joined[2]), (rubs[0], rubs[1], rubs[2])

    def _at_limit(self) -> NDArray[np.bool_]:
        """Return which contacts of ropes carry all that friction can, (c,), or have none."""
        if not self.touch:
            return np.zeros(0, bool)
        contact = self.state.memory.contact
        grip = contact.grip[: contact.tally[CONTACTS]]
        table = self.system.node.contact
        first, second = table.rope[contact.pair[: len(grip)].T]
        most = table.friction[first, second] * grip[:, PUSH]
        rub = np.linalg.norm(grip[:, SPRING : SPRING + 3], axis=1)
        return np.asarray((most == 0.0) | (rub >= SLIPS * most))

    def _keep_contacts(self, which: NDArray[np.bool_]) -> None:
        """Leave only some contacts of ropes, (c,)."""
        if not self.touch:
            return
        contact, count = self.state.memory.contact, int(which.sum())
        for rows in (contact.pair, contact.grip):
            rows[:count] = rows[: which.size][which]
        contact.tally[CONTACTS] = count

    def _free_slides(self) -> None:
        """Leave slides that carry all that friction and brake can without either."""
        table, memory = self.slide, self.state.memory.slide
        free = np.zeros(len(table.node), bool)
        for row in range(free.size):
            most = float(bound_there(table, memory.sight, row))
            free[row] = abs(memory.grip[row, HELD]) >= SLIPS * most
        loose = {
            name: np.where(free, 0.0, getattr(table, name))
            for name in ("friction", "brake", "damping")
        }
        self.slide = table._replace(**loose)
        self.system = self.system._replace(node=self.system.node._replace(slide=self.slide))

    def _without_friction(self) -> Couplings:
        """Return the contacts of ropes alone, and none of them holds along the surface."""
        table, memory = self.system.node.contact, self.state.memory.contact
        table = table._replace(friction=np.zeros_like(table.friction))
        memory.grip[: memory.tally[CONTACTS], SPRING : SPRING + 3] = (
            _ASKEW  # more than no friction holds
        )
        acts = self.system.acts.copy()
        acts[NAMES.index("slide")] = 0
        system = self.system._replace(node=self.system.node._replace(contact=table), acts=acts)
        return Couplings(system, self.state)

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
        keep_couplings(self.system, state)
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
