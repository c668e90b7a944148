"""Slides as a law: nodes that run along other ropes, with friction and a brake. See `slide_force`.

By default a slide is as stiff across as contacts of the two ropes would be (`laws.obstacle`), or as hangs its
load at rest no farther off the line than SINK of a segment, where that is more. No more than steps for the
ropes allow for as well: on its own it moves no quicker than their nodes do by one of their segments.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from ropewalk.core.arrays import Floats, Ints
from ropewalk.core.jit import part
from ropewalk.core.ordering import ask_for
from ropewalk.laws.node_law import NodeLaw, Rest
from ropewalk.laws.obstacle import FRAME, node_stiffness
from ropewalk.laws.slides.reach import follow_drums, live_ends, part_line, place_near
from ropewalk.laws.slides.slide_force import (
    let_run_off,
    remember_slides,
    slide_energy,
    slide_forces,
)
from ropewalk.laws.slides.slide_tangent import along_slides, couple_slides
from ropewalk.laws.slides.table import (
    ASKED,
    ENDS,
    FAULT,
    GIVEN,
    LOST,
    PLACE,
    WHICH,
    WIDTH,
    Memory,
    Slides,
)

if TYPE_CHECKING:
    from collections.abc import Sequence

    from ropewalk.lowering.layout import Layout
    from ropewalk.methods.bound import Chain
    from ropewalk.scene import Rope
    from ropewalk.scene.slide import Slide
    from ropewalk.scene.winch import Winch

DAMPING = 0.5  # [1] damping ratio of the friction spring between the nodes at hand
SINK = (
    0.005  # [1] how far off its line a load hangs at rest by default, over the length of a segment
)


def lower(
    slides: Sequence[Slide] | None,
    layout: Layout,
    ropes: Sequence[Rope],
    whole: Sequence[float],
    winches: Sequence[Winch],
    gravity: float,
) -> Slides:
    """Return the table of a scene's slides; `whole` is a rope's mass with all it is tied to [kg].

    `gravity` is its size [m/s^2].
    """
    numbers = {rope.name: number for number, rope in enumerate(ropes)}
    rows = []
    pulls = known_pulls(slides or (), layout, ropes, whole, gravity)
    for slide, pull in zip(slides or (), pulls, strict=True):
        own, other = numbers[slide.rope], numbers[slide.on]
        rope, line, span = ropes[own], ropes[other], layout.ropes[other]
        node = rope.node_index(slide.node)
        mass = rope.own_mass / rope.nodes
        mass += sum(load.mass for load in rope.loads if rope.node_index(load.node) == node)
        stiff, mass = node_stiffness(rope, whole[own], mass)
        carries, light = node_stiffness(line, whole[other])
        stiff = stiff * carries / (stiff + carries)
        stiff = max(stiff, min(pull / (SINK * line.segment_length), _most(rope, mass, line, light)))
        if slide.compliance is not None:
            stiff = 1.0 / slide.compliance
        rubs = slide.friction > 0.0 or slide.brake > 0.0
        damping = 2.0 * DAMPING * math.sqrt(stiff * mass * light / (mass + light)) if rubs else 0.0
        place = layout.node(slide.node, slide.rope), span.start, span.end, line.segment_length
        rubbed = stiff, stiff, damping, slide.friction, slide.brake, slide.brake_from
        rows.append((*place, *rubbed, span.first, span.last, *_drums_of(line, winches)))
    columns = np.array(rows, dtype=np.float64).reshape(-1, 14).T
    names = [name for name in Slides._fields if name != "winch"]
    made = dict(zip(names, map(np.ascontiguousarray, columns[:12]), strict=True))
    for name in ("node", "first", "last", "lowest", "highest"):
        made[name] = made[name].astype(np.int64)
    return Slides(**made, winch=np.ascontiguousarray(columns[12:].T).astype(np.int64))


def known_pulls(
    slides: Sequence[Slide],
    layout: Layout,
    ropes: Sequence[Rope],
    whole: Sequence[float],
    gravity: float,
) -> list[float]:
    """Return what is known to pull each slide off its line [N].

    That is the weight of its rope and of all that is tied to it or slides along it, and given forces;
    where an anchor holds its rope the line may hang on that, too.
    """
    weights = {rope.name: gravity * mass for rope, mass in zip(ropes, whole, strict=True)}
    pushes = {rope.name: sum(math.hypot(*one.force) for one in rope.forces) for rope in ropes}
    own = []
    for slide in slides:
        span = layout.span(slide.rope)
        held = any(span.first <= node <= span.last for node in layout.anchor_nodes)
        pull = weights[slide.rope] + pushes[slide.rope]
        own.append(pull + held * weights[slide.on])
    found = own
    for _ in slides:  # no more of them hang on one another
        on = dict.fromkeys(weights, 0.0)
        for slide, pull in zip(slides, found, strict=True):
            on[slide.on] += pull
        found = [pull + on[slide.rope] for slide, pull in zip(slides, own, strict=True)]
    return found


def _most(rope: Rope, mass: float, line: Rope, light: float) -> float:
    """Return the stiffness of a slide that steps for its ropes allow for as well [N/m].

    Its node has `mass`, those of the line are `light` [kg].
    """
    quickest = max(rope.segment_stiffness / mass, line.segment_stiffness / light, FRAME**-2)
    return quickest * mass * light / (mass + light)


def _drums_of(line: Rope, winches: Sequence[Winch]) -> tuple[int, int]:
    """Return the numbers of the winches at a rope's start and end, -1: there is none."""
    found = {winch.end: i for i, winch in enumerate(winches) if winch.rope == line.name}
    return found.get("start", -1), found.get("end", -1)


def acts(table: Slides) -> bool:
    """Tell whether anything slides."""
    return len(table.node) > 0


def memory(table: Slides, x: Floats, stiffness: Floats, _held: Ints | None = None) -> Memory:
    """Return what is remembered at the start, for nodes at places (3, n) [m]: no friction."""
    k = len(table.node)
    grip, ends = np.zeros((k, 2)), np.zeros((k, ENDS), np.int64)
    for row in range(k):
        ends[row] = live_ends(table, row, x, stiffness > 0.0)
        grip[row, PLACE] = place_near(table, row, x, ends[row])
    tally = np.zeros(3 * min(k, 1), np.int64)
    off = np.full(k, math.inf)
    work = np.zeros((k, 4), np.int64), np.zeros((k, WIDTH))
    found = Memory(grip, *work, tally, ends, off, np.zeros((k, 3)))
    if k > 0:  # else it would be compiled for nothing
        remember_slides(x, table, found)
    return found


@part
def force(table, state, x, v, force, lo, hi):
    """Write the force of all slides on every node [N], (3, n)."""
    slide_forces(x, v, table, state.memory.slide, force, lo, hi)


@part
def tangent(table, state, x, v, weight_x, weight_v, marks, band):
    """Add nothing: slides couple nodes that no band reaches, see `couple`."""


@part
def pattern(table, state, x, network):
    """Ask for the nodes that carry now."""
    memory = state.memory.slide
    slide_energy(x, table, memory)  # which looks where they are
    memory.tally[ASKED] = ask_for(network, memory.group, memory.group.shape[0])


@part
def couple(table, state, x, v, weight_x, weight_v, network):
    """Add the derivatives of the force to the network."""
    couple_slides(x, v, table, state.memory.slide, weight_x, weight_v, network)


@part
def along(table, state, x, v, d, weight_x, weight_v):
    """Return d . K d of these derivatives K for a direction (3, n) [N m]."""
    return along_slides(x, v, d, table, state.memory.slide, weight_x, weight_v)


@part
def remember(table, state):
    """Keep what slides carry at the state; nothing is hit."""
    memory = state.memory.slide
    lost = remember_slides(state.x, table, memory)
    if lost >= 0 and memory.tally[FAULT] == 0:
        memory.tally[FAULT], memory.tally[WHICH] = LOST, lost
    if let_run_off(memory, state.now[0]):
        state.past[0] = 0.0  # a multistep method begins anew
    return 0.0


@part
def wound(table, state, winches):
    """Let slides follow the nodes at drums."""
    follow_drums(table, state.memory.slide, state.winch_exit, state.held, winches.anchor)


@part
def parted(table, state, segment, time):
    """Leave what slides the part of its rope that it is on, where a segment has parted at `time` [s]."""
    part_line(table, state.memory.slide, segment, time)


@part
def fault(table, state):
    """Return what went wrong, 0: nothing."""
    return state.memory.slide.tally[FAULT]


@part
def energy(table, state, x):
    """Return what slides have stored [J]."""
    return slide_energy(x, table, state.memory.slide)


@part
def given(table, state, x):
    """Return what stops at drums have given as they moved [J]."""
    stops, total = state.memory.slide.stops, 0.0
    for row in range(stops.shape[0]):
        total += max(stops[row, GIVEN], 0.0)
    return total


@part
def rounding(table, state, x):
    """Return what rounding of the places does to the force [N]."""
    size, most = 0.0, 0.0
    for k in range(3):
        for i in range(x.shape[1]):
            size = max(size, abs(x[k, i]))
    for row in range(table.node.shape[0]):
        most = max(most, table.stiffness[row])
    return 16.0 * 2.220446049250313e-16 * most * size


def at_rest(table: Slides) -> Rest:
    """They roll where nothing holds them."""
    return Rest.NOTHING


def chain(table: Slides, chain: Chain, lengths: Floats, speed: float) -> Chain:
    """Return a chain with every slide at each node of its rope.

    Of (a - b)^2 <= (1 + s) a^2 + (1 + 1/s) b^2, with s the ratio of the masses, both sides are as stiff for
    their mass as the pair is; shares of nodes add up to 1, so that none gets more than all.
    """
    if not len(table.node):
        return chain
    stiffness, damping = chain.node_stiffness.copy(), chain.node_damping.copy()
    for row in range(len(table.node)):
        node, line = int(table.node[row]), slice(int(table.first[row]), int(table.last[row]) + 1)
        ratio = chain.mass[line] / chain.mass[node] if chain.free[node] else 0.0
        least = np.min(chain.mass[line])
        stop = 1.0 if (table.winch[row] >= 0).any() else 0.0
        for array, value in ((stiffness, table.stiffness[row]), (damping, table.damping[row])):
            array[line] += value * (1.0 + ratio)
            array[node] += value * (1.0 + chain.mass[node] / least)
        stiffness[node] += stop * table.stiffness[row]
    return chain._replace(node_stiffness=stiffness, node_damping=damping)


def lost(state: Any) -> int | None:
    """Return the slide whose node has come off its rope, if any."""
    tally = state.memory.slide.tally
    return int(tally[WHICH]) if tally.size and tally[FAULT] == LOST else None


SLIDE = NodeLaw(
    name="slide",
    section="slides",
    lower=lower,
    inputs=("layout", "ropes", "whole", "winches", "gravity"),
    acts=acts,
    force=force,
    tangent=tangent,
    memory=memory,
    remember=remember,
    rounding=rounding,
    energy=energy,
    given=given,
    at_rest=at_rest,
    chain=chain,
    pattern=pattern,
    couple=couple,
    along=along,
    fault=fault,
    wound=wound,
    parted=parted,
)
