"""What laws between nodes that are no neighbours ask of a solver and of a step, folded as in `nodes`."""

from __future__ import annotations

from typing import Any

from ropewalk.core.jit import kernel, part
from ropewalk.core.ordering import begin_groups, order_groups
from ropewalk.laws.node_law import NodeLaw, has_any
from ropewalk.laws.nodes import fold, nothing_to_remember, remembering, whether
from ropewalk.laws.rare import acts, has_bending

FINE, AGAIN, HALVE = range(3)  # what `meet` says of a step


may_couple = whether("couple")
"""may_couple(system): tell whether a law that acts may couple nodes that are no neighbours."""


@part
def _none_couples(system, state):
    return False


def _counting(law: NodeLaw, k: int, rest: Any) -> Any:
    couples_any = law.couples_any or has_any

    @part
    def _couples(system, state):
        return (acts(system, k) and couples_any(system.node[k], state)) or rest(system, state)

    return _couples


_couples_any = fold(_counting, _none_couples, "couple")
any_presses = fold(_counting, _none_couples, "lower")
"""any_presses(system, state): tell whether a law of nodes acts; not if it couples, and couples none."""


@part
def couples(system, state):
    """Tell whether one couples any, as the state has it: so during a whole solve.

    Or is to be solved for as if, as what bends and may come down on a body: a column that lands on its end
    buckles, and by residuals alone the search finds one of many ways, with energy of its own.
    """
    if may_couple(system) and has_bending(system) and state.memory.obstacle.grip.shape[0] > 0:
        return True
    return _couples_any(system, state)


@part
def _nothing_asked(system, state, x, network):
    pass


def _asking(law: NodeLaw, k: int, rest: Any) -> Any:
    pattern = law.pattern

    @part
    def _ask(system, state, x, network):
        if acts(system, k):
            pattern(system.node[k], state, x, network)
        rest(system, state, x, network)

    return _ask


_ask_all = fold(_asking, _nothing_asked, "pattern")


@part
def _none_told(system, state, fits):
    pass


def _telling(law: NodeLaw, k: int, rest: Any) -> Any:
    ordered = law.ordered

    @part
    def _tell(system, state, fits):
        if acts(system, k):
            ordered(system.node[k], state, fits)
        rest(system, state, fits)

    return _tell


_tell_all = fold(_telling, _none_told, "ordered")


@part
def order_couplings(system, state, x, network):
    """Find the network's order anew with all that laws couple; return whether there was room for it."""
    if not may_couple(system):
        return True
    begin_groups(network)
    _ask_all(system, state, x, network)
    fits = order_groups(network)
    _tell_all(system, state, fits)
    return fits


@part
def _nothing_more(system, state, x, v, weight_x, weight_v, network):
    pass


def _coupling(law: NodeLaw, k: int, rest: Any) -> Any:
    couple = law.couple

    @part
    def _couple(system, state, x, v, weight_x, weight_v, network):
        if acts(system, k):
            table = system.node[k]
            couple(table, state, x, v, weight_x, weight_v, network)
        rest(system, state, x, v, weight_x, weight_v, network)

    return _couple


add_couplings = fold(_coupling, _nothing_more, "couple")
"""add_couplings(system, state, x, v, weight_x, weight_v, network): add the tangents of these laws."""


@part
def _nothing_along(system, state, x, v, d, weight_x, weight_v):
    return 0.0


def _going(law: NodeLaw, k: int, rest: Any) -> Any:
    along = law.along

    @part
    def _along(system, state, x, v, d, weight_x, weight_v):
        total = 0.0
        if acts(system, k):
            total += along(system.node[k], state, x, v, d, weight_x, weight_v)
        return total + rest(system, state, x, v, d, weight_x, weight_v)

    return _along


along_couplings = fold(_going, _nothing_along, "along")
"""along_couplings(system, state, x, v, d, weight_x, weight_v): d . K d of these tangents [N m]."""


@part
def _nothing_stored(system, state, x):
    return 0.0


def _storing(law: NodeLaw, k: int, rest: Any) -> Any:
    energy = law.energy

    @part
    def _stored(system, state, x):
        total = rest(system, state, x)
        if acts(system, k):
            total += energy(system.node[k], state, x)
        return total

    return _stored


coupled_energy = fold(_storing, _nothing_stored, "couple")
"""coupled_energy(system, state, x): return what these laws have stored [J]."""


@part
def _no_work(system, forces, v0, v1, dt):
    return 0.0


def _working(law: NodeLaw, k: int, rest: Any) -> Any:
    @part
    def _work(system, forces, v0, v1, dt):
        total = rest(system, forces, v0, v1, dt)
        if acts(system, k):
            total += work_on_nodes(forces[k], v0, v1, dt)
        return total

    return _work


coupled_work = fold(_working, _no_work, "couple")
"""coupled_work(system, forces, v0, v1, dt): return what they do to the nodes in a step [J]."""


@kernel
def work_on_nodes(force, v0, v1, dt):
    """Return the work of forces on nodes, (3, n), in a step from velocities v0 to v1 [J]."""
    total = 0.0
    for k in range(3):
        for i in range(v0.shape[1]):
            total += force[k, i] * (v0[k, i] + v1[k, i])
    return 0.5 * dt * total


@part
def _nothing_met(system, state, x):
    return FINE


def _meeting(law: NodeLaw, k: int, rest: Any) -> Any:
    meet = law.meet

    @part
    def _meet(system, state, x):
        found = rest(system, state, x)
        if acts(system, k):
            found = max(found, meet(system.node[k], state, x))
        return found

    return _meet


meet_on_way = fold(_meeting, _nothing_met, "meet")
"""meet_on_way(system, state, x): tell whether a step from the state to there may stand."""


def _meeting_coupled(law: NodeLaw, k: int, rest: Any) -> Any:
    return rest if law.meet is None else _meeting(law, k, rest)


meet_couplings = fold(_meeting_coupled, _nothing_met, "couple")
"""meet_couplings(system, state, x): the same of laws between nodes that are no neighbours alone."""

remember_couplings = fold(remembering, nothing_to_remember, "couple")
"""remember_couplings(system, state): let these laws keep what they carry; return what they have hit."""


@part
def _nothing_braced(system, state, dt, all_anew):
    pass


def _bracing(law: NodeLaw, k: int, rest: Any) -> Any:
    brace = law.brace

    @part
    def _brace(system, state, dt, all_anew):
        if acts(system, k):
            brace(system.node[k], state, dt, all_anew)
        rest(system, state, dt, all_anew)

    return _brace


brace_couplings = fold(_bracing, _nothing_braced, "brace")
"""brace_couplings(system, state, dt, all_anew): let these laws get ready for what a step of `dt` [s] may hit.

What is new to it, or with `all_anew` all.
"""


@part
def _nothing_wound(system, state):
    pass


def _winding(law: NodeLaw, k: int, rest: Any) -> Any:
    wound = law.wound

    @part
    def _wind(system, state):
        if acts(system, k):
            wound(system.node[k], state, system.winches)
        rest(system, state)

    return _wind


wind_couplings = fold(_winding, _nothing_wound, "wound")
"""wind_couplings(system, state): let these laws follow nodes that have gone on to drums, or come off."""


@part
def _nothing_parted(system, state, segment, time):
    pass


def _parting(law: NodeLaw, k: int, rest: Any) -> Any:
    parted = law.parted

    @part
    def _part(system, state, segment, time):
        if acts(system, k):
            parted(system.node[k], state, segment, time)
        rest(system, state, segment, time)

    return _part


part_couplings = fold(_parting, _nothing_parted, "parted")
"""part_couplings(system, state, segment, time): let these laws know of a segment that has parted."""


@part
def _no_fault(system, state):
    return False


def _failing(law: NodeLaw, k: int, rest: Any) -> Any:
    fault = law.fault

    @part
    def _fault(system, state):
        bad = rest(system, state)
        if acts(system, k):
            bad = bad or fault(system.node[k], state) != 0
        return bad

    return _fault


any_fault = fold(_failing, _no_fault, "fault")
"""any_fault(system, state): tell whether anything is so wrong that the run cannot go on."""
