"""Contact of ropes with each other and with themselves as a law: Coulomb friction between pairs of segments.

By default a contact is as soft as the inertia of both ropes lets it be solved for, as one with an obstacle
is (`laws.obstacle`), in a thin skin, and EA / diameter below, as stiff as a rope is across. The force is
that of `force`; what it remembers is in `pair_memory`; `way` sees to it that no step lets ropes pass through
each other.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from ropewalk.core.arrays import Floats, Ints
from ropewalk.core.jit import part
from ropewalk.core.ordering import ask_for
from ropewalk.laws.node_law import NodeLaw, Rest, always
from ropewalk.laws.obstacle import node_stiffness
from ropewalk.laws.pairs.beside_slides import begin_inside, follow_slides, reach_ahead
from ropewalk.laws.pairs.boxes import room_for
from ropewalk.laws.pairs.brake import brake_again, brake_hits
from ropewalk.laws.pairs.force import add_pair_forces, pair_energy, pair_forces, pair_rounding
from ropewalk.laws.pairs.heaps import leads
from ropewalk.laws.pairs.neighbours import neighbours, note_joints, with_slides
from ropewalk.laws.pairs.offsets import swap_offsets
from ropewalk.laws.pairs.pair_books import book_pairs
from ropewalk.laws.pairs.pair_events import pair_events
from ropewalk.laws.pairs.pair_hits import quickest_closing
from ropewalk.laws.pairs.pair_memory import remember_pairs
from ropewalk.laws.pairs.pair_tangent import along_pairs, couple_pairs
from ropewalk.laws.pairs.search import note_ropes
from ropewalk.laws.pairs.swept import runs_of
from ropewalk.laws.pairs.table import (
    ASKED,
    BRAKE,
    CONTACTS,
    CROWDED,
    FAULT,
    HARD,
    LEAN,
    LIFTED,
    NEW,
    SEEN,
    STOP,
    WIDTH,
    Memory,
    Pairs,
)
from ropewalk.laws.pairs.way import AGAIN, meet_pairs
from ropewalk.laws.pairs.wound import wind_pairs
from ropewalk.laws.rebound import ratio_of
from ropewalk.laws.striking import pushes

if TYPE_CHECKING:
    from collections.abc import Sequence

    from ropewalk.lowering.layout import Layout
    from ropewalk.methods.bound import Chain
    from ropewalk.scene import Joint, Rope
    from ropewalk.scene.rope_contact import Contact
    from ropewalk.scene.slide import Slide

SKIN = 0.5  # [1] how far lists of pairs look ahead, over the largest diameter
RIGID = 100.0  # [1] stiffness of a contact of rigid links pressed far, over that pressed little
ROWS, LISTED = 16, 40  # contacts, and pairs nearby, that there is room for, per segment
LEAST_ROWS = 256


def lower(
    contact: Contact | None,
    layout: Layout,
    ropes: Sequence[Rope],
    whole: Sequence[float],
    joints: Sequence[Joint],
    slides: Sequence[Slide],
    bound: Sequence[Sequence[int]],
    inert: Floats,
) -> Pairs:
    """Return the table of a scene's ropes; `whole` is a rope's mass with all it is tied to [kg].

    `bound` are numbers of ropes that pull on each other, contact or not; `inert` are masses of nodes [kg].
    """
    s = layout.segments if contact is not None else 0
    table = Pairs(
        ratio=np.array([1.0 if contact is None else ratio_of(contact.restitution)]),
        friction=np.zeros((0, 0)) if contact is None else contact.frictions(ropes),
        skin=np.zeros(1),
        total=np.array([rope.total_mass for rope in ropes]),
        lead=leads(len(ropes), bound),
        radius=np.zeros(s),
        lever=np.zeros(s),
        soft=np.zeros(s),
        hard=np.zeros(s),
        stop=np.zeros(s),
        mass=np.zeros(s),
        load=np.zeros(layout.nodes if s else 0),
        behind=np.zeros(layout.nodes if s else 0),
        joined=np.zeros(layout.nodes if s else 0),
        rope=np.full(s, -1, np.int64),
        skip=np.ones(s, np.int64),
        joint=np.full((s, 2), -1, np.int64),
        slides=np.zeros((s, 0), np.int64),
        inside=np.zeros((0, 7), np.int64),
    )
    if contact is None:
        return table
    for number, (rope, span, mass) in enumerate(zip(ropes, layout.ropes, whole, strict=True)):
        here = slice(span.first, span.last)
        own, table.mass[here] = node_stiffness(rope, mass)
        across = rope.segment_stiffness * rope.segment_length / rope.diameter
        far = max(own, across) if math.isfinite(across) else RIGID * own
        table.radius[here] = 0.5 * rope.diameter
        if rope.segment_length > 0.0:
            table.lever[here] = 0.5 * rope.diameter / (rope.segment_length * math.sqrt(LEAN))
        soft, hard, stop = 1.0 / own, 1.0 / far, 1.0 / (STOP * far)
        if contact.compliance is not None:  # of the skin: how ropes stop each other stays as it is
            soft = hard = 0.5 * contact.compliance
            stop = min(stop, soft / STOP)
        table.soft[here], table.hard[here], table.stop[here] = soft, hard, stop
        table.rope[here], table.skip[here] = number, max(1, neighbours(rope))
        for load in rope.loads:
            table.load[layout.node(load.node, rope.name)] += load.mass
        if pushes(rope):
            own_masses = table.mass[span.first] + table.load[span.first : span.last + 1]
            table.behind[span.first : span.last + 1] = np.maximum(mass - own_masses, 0.0)
    table.skin[0] = SKIN * 2.0 * float(table.radius.max())
    note_joints(table, layout, ropes, joints, inert)
    return with_slides(table, layout, ropes, slides)


def acts(table: Pairs) -> bool:
    """Tell whether ropes touch each other."""
    return len(table.radius) > 0


def memory(table: Pairs, x: Floats, stiffness: Floats, _held: Ints | None = None) -> Memory:
    """Return what is remembered at the start, for nodes at places (3, n) [m]: no force."""
    s = len(table.rope)
    rows = min(max(ROWS * s, LEAST_ROWS), max(s * (s - 1) // 2, 1)) if s else 0
    listed = min(s * (s - 1) // 2, LISTED * s + LEAST_ROWS)
    found = Memory(
        pair=np.zeros((rows, 2), np.int64),
        grip=np.zeros((rows, WIDTH)),
        near=np.zeros((max(listed, 1) if s else 0, 2), np.int64),
        tally=np.zeros(10 if s else 0, np.int64),
        place=x.copy() if s else np.zeros((3, 0)),
        origin=np.full((3, x.shape[1]), 1e150) if s else np.zeros((3, 0)),
        box=np.zeros((s, 6)),
        order=np.arange(s),
        tree=np.zeros((room_for(s) if s else 0, 6)),
        rope=np.full(s, -1, np.int64),
        way=np.zeros((3, x.shape[1] if s else 0)),
        books=np.zeros(4 if s else 0),
        inside=np.zeros((len(table.inside), 2), np.int64),
        swept=runs_of(table.rope),
        hull=np.repeat([[math.inf], [-math.inf]], 3, axis=0).repeat(x.shape[1] if s else 0, axis=1),
    )
    if s:
        note_ropes(table, found, stiffness)
        begin_inside(x, table, found)
        found.tally[SEEN] = 1
        tied = np.ones(int(table.joint.max(initial=-1)) + 1, np.int64)
        remember_pairs(x, np.zeros_like(x), 0.0, table, found, tied)
        found.grip[:, BRAKE] = NEW
    return found


@part
def any_contact(state):
    """Tell whether there is any contact: what follows is called for nothing where there is none."""
    return state.memory.contact.tally[CONTACTS] > 0


@part
def force(table, state, x, v, force, lo, hi):
    """Write the force of all contacts on every node [N], (3, n)."""
    pair_forces(x, v, table, state.memory.contact, force, lo, hi)


@part
def tangent(table, state, x, v, weight_x, weight_v, marks, band):
    """Add nothing: contacts couple nodes that no band reaches, see `couple`."""


@part
def add_diagonal(table, weight_v, free, diagonal):
    """Add nothing, as `tangent`."""


@part
def pattern(table, state, x, network):
    """Ask for the contacts at hand."""
    memory = state.memory.contact
    memory.tally[ASKED] = ask_for(network, memory.pair, memory.tally[CONTACTS])


@part
def couples_any(table, state):
    """Tell whether there are any contacts: the step's way is looked at in either case, see `meet`."""
    return any_contact(state)


@part
def ordered(table, state, fits):
    """Note whether there was room for what is coupled."""
    memory = state.memory.contact
    if not fits:
        memory.tally[FAULT] = CROWDED
    elif memory.tally[FAULT] == CROWDED:  # fewer touch in a shorter step
        memory.tally[FAULT] = 0


@part
def couple(table, state, x, v, weight_x, weight_v, network):
    """Add the derivatives of the force to the network."""
    couple_pairs(x, v, table, state.memory.contact, weight_x, weight_v, network)


@part
def along(table, state, x, v, d, weight_x, weight_v):
    """Return d . K d of these derivatives K for a direction (3, n) [N m]."""
    return along_pairs(x, v, d, table, state.memory.contact, weight_x, weight_v)


@part
def remember(table, state):
    """Keep what contacts carry at the state; return how many have closed."""
    memory, dt = state.memory.contact, state.now[0] - state.now[1]
    note_ropes(table, memory, state.stiffness)
    solved = memory.tally[SEEN] == 1
    closed = remember_pairs(state.x, state.v, dt, table, memory, state.tied)
    if table.inside.shape[0] > 0:
        follow_slides(state.x, table, memory, state.memory.slide, state.tied)
    if any_contact(state):
        brake_hits(state.x, state.v, state.inverse_mass, table, memory, dt, solved)
    return closed


@part
def book(table, state, force, middle, dt):
    """Book what a step's mean forces have done."""
    book_pairs(state.memory.contact, force, middle, dt)


@part
def hits(table, state, force, dt, x, v):
    """Return how quickly contacts stop what they hit in a step from the state to `x` and `v` [1/s]."""
    if not any_contact(state):
        return 0.0
    return quickest_closing(state.v, x, v, force, dt, table, state.memory.contact)


@part
def meet(table, state, x):
    """Tell whether the way from the state to `x` may stand, see `way`."""
    memory = state.memory.contact
    slides = table.inside.shape[0] > 0
    if slides and reach_ahead(x, table, memory, state.memory.slide, state.tied):
        return AGAIN
    return meet_pairs(state.x, x, table, memory, state.tied, state.now[0] - state.now[1])


@part
def brace(table, state, dt, all_anew):
    """Let contacts have the drag that stops what they meet in a step of `dt` [s], see `brake`."""
    if any_contact(state):
        brake_again(state.x, state.v, state.inverse_mass, table, state.memory.contact, dt, all_anew)


@part
def wound(table, state, winches):
    """Let contacts follow nodes that go on to drums, or come off."""
    wind_pairs(table, state, winches)


@part
def fault(table, state):
    """Return what went wrong, 0: nothing."""
    return state.memory.contact.tally[FAULT]


@part
def touch(table, state, force):
    """Add the force of all contacts at the state itself [N], (3, n), with the offsets of its step."""
    swap_offsets(state.memory.contact)
    add_pair_forces(state.x, state.v, table, state.memory.contact, force)
    swap_offsets(state.memory.contact)


@part
def rounding(table, state, x):
    """Return what rounding of the places does to the force [N]."""
    return pair_rounding(x, table, state.memory.contact) if any_contact(state) else 0.0


@part
def energy(table, state, x):
    """Return what contacts have stored [J]."""
    return pair_energy(x, table, state.memory.contact)


@part
def given(table, state, x):
    """Return what offsets have given contacts that lie still [J]."""
    return max(state.memory.contact.books[LIFTED], 0.0)


def at_rest(table: Pairs) -> Rest:
    """Ropes that lie on each other bear each other."""
    return Rest.BEARS


def channels(table: Pairs) -> int:
    """Return how many rows the forces have, with what rubs."""
    return 6 if acts(table) else 3


def touched(table: Pairs, x: Floats) -> Any:
    """Return which nodes lie on something that bears them, (n,): none for sure."""
    return np.zeros(x.shape[1], bool)


def cases(table: Pairs, chain: Chain) -> dict[str, Chain]:
    """Return a chain all of whose nodes are pressed to other ropes on two sides, as hard as can be.

    A spring k of the sum of c_a x_a is no stiffer than k |c_a| (|c_1| + |c_2| + ...) at each x_a. Across,
    the c are shares, 2 in all; along the surfaces come the levers, four times A, the largest of them.
    """
    if not len(table.rope):
        return {}
    alive = table.rope >= 0
    soft, stiff = 0.5 / table.soft[alive].min(), 0.5 / table.stop[alive].min()
    damping = 2.0 * math.sqrt(max(soft, HARD**2 * stiff) * 0.5 * float(table.mass[alive].max()))
    lever = table.lever[alive].max()
    both = 2.0 * max(2.0 + 4.0 * lever, 2.0 + lever * (2.0 + 4.0 * lever))
    return {
        "pressed to ropes": chain._replace(
            node_stiffness=chain.node_stiffness + both * stiff,
            node_damping=chain.node_damping + both * damping,
        )
    }


CONTACT = NodeLaw(
    name="contact",
    section="contact",
    lower=lower,
    inputs=("layout", "ropes", "whole", "joints", "slides", "bound", "inert"),
    acts=acts,
    force=force,
    tangent=tangent,
    is_diagonal=always,
    is_local=always,
    add_diagonal=add_diagonal,
    memory=memory,
    remember=remember,
    book=book,
    channels=channels,
    crossings=pair_events,
    hits=hits,
    touch=touch,
    rounding=rounding,
    energy=energy,
    given=given,
    at_rest=at_rest,
    bears=touched,
    cases=cases,
    pattern=pattern,
    ordered=ordered,
    couple=couple,
    couples_any=couples_any,
    along=along,
    meet=meet,
    brace=brace,
    fault=fault,
    wound=wound,
)
