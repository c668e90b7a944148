"""Tying two points by hand: two hands bring them together, then a joint ties them where they meet.

Points that lie apart cannot be tied at once: to put them at one place would stretch ropes in no time. So each
is held by an anchor of its own for a while, which moves at a bounded speed and slows down the harder it must
pull; a point that an anchor holds already stays with that. They meet halfway, or, where ropes are too short
for that, at the next place that is within reach of both. What hands do is work, and is booked as that of any
anchor. Where the two meet they have one place and one velocity, and a joint takes the hands' place without
a jump.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.live import edits
from ropewalk.live.messages import sentence
from ropewalk.live.parameters import refusal
from ropewalk.scene import SceneError
from ropewalk.simulation import Simulation

if TYPE_CHECKING:
    from ropewalk.live.track import Track

SPEED = 1.0  # [m/s] of a hand
LONGEST = 2.0  # [s] that the way takes; faster where they lie far apart
ACCELERATION = 20.0  # [m/s2]
EASE = 0.05  # [s] in which 63 % of the last of the way is made up
LAST = 1e-3  # of the speed, below which they go the rest of the way
NEAR = 1e-6  # of the longer rope, at which they are together
STRONG = 20.0  # of the ropes' weight, the largest force of a hand: as that of a pull
SLACK = 0.98  # of a rope's length, how far it is stretched to meet
ROUNDS = 30  # of looking for a place to meet
HASTE = 10.0  # times as fast patience goes where a hand must hold more than it can
PATIENCE = 3.0  # [s] beyond what the way takes, after which hands give up


@dataclass(frozen=True)
class Pull:
    """Two points on their way to each other."""

    anchors: tuple[str, str]  # that hold them
    hands: tuple[str, ...]  # those of them that are there for this only
    owner: int
    fastest: float  # [m/s]
    most: float  # force of a hand [N]
    near: float  # [m]
    left: float  # [s] until it is given up
    speed: float = 0.0  # [m/s] of a hand now


def begin(track: Track, nodes: tuple[int, int], owner: int) -> str:
    """Take hold of two nodes to tie them; return what will happen.

    Raises SceneError where they cannot be tied.
    """
    held = [track.holder(node) for node in nodes]
    if all(held) and held[0] != held[1]:
        rule = f"are held by anchors {held[0]!r} and {held[1]!r}; let one of the two go first"
        raise refusal("nodes", f"{nodes[0]}, {nodes[1]}", rule)
    _refuse_wound(track.simulation, nodes)
    edits.knot(track.scene, track.simulation.layout, nodes)  # refuses what can never be tied
    state = track.simulation.arrays
    gap = float(np.linalg.norm(state.x[:, nodes[0]] - state.x[:, nodes[1]]))
    fastest = max(SPEED, gap / LONGEST)
    spans = [
        track.simulation.layout.span(edits.at_node(track.simulation.layout, i)[0]) for i in nodes
    ]
    masses = {span.name: float(state.mass[span.start : span.end + 1].sum()) for span in spans}
    weight = sum(masses.values()) * max(float(np.linalg.norm(track.simulation.system.gravity)), 1.0)
    size = max(track.scene.rope_named(span.name).length_unstretched for span in spans)
    most = STRONG * weight
    _refuse_far(track.simulation, nodes, most)
    names, hands = [], []
    for node, holder in zip(nodes, held, strict=True):
        if holder is None:
            holder = edits.free_name([track.scene], "tie")
            track.restructure(partial(edits.pin, index=node, name=holder))
            hands.append(holder)
        names.append(holder)
    pull = Pull(
        (names[0], names[1]),
        tuple(hands),
        owner,
        fastest,
        most,
        NEAR * max(size, 1e-9),
        PATIENCE + 2.0 * gap / fastest,
    )
    track.hands.pulls.append(pull)
    track.hands.fresh = True
    if gap <= pull.near:
        return ""
    return f"{gap:.3g} m apart: hands bring them together, then they are tied"


def _refuse_wound(simulation: Simulation, nodes: tuple[int, int]) -> None:
    """Raise SceneError where one of the nodes is on a drum by now; those that are held stay off it."""
    winches = simulation.system.winches
    for first, exit_node in zip(winches.first, simulation.arrays.winch_exit, strict=True):
        for node in nodes:
            if min(first, exit_node) <= node <= max(first, exit_node):
                raise refusal("nodes", node, "is on a winch's drum: choose a point off it")


def brought(simulation: Simulation, pull: Pull, interval: float) -> Pull:
    """Set the velocities of a pull's hands for the next `interval` [s]; return what it is then."""
    if not _held(simulation, pull):
        return replace(pull, left=0.0)
    state = simulation.arrays
    rows = [simulation.layout.anchor_names.index(name) for name in pull.anchors]
    hands = [row for row, name in zip(rows, pull.anchors, strict=True) if name in pull.hands]
    if len(hands) == 2:
        goal, drift = meeting_place(simulation, rows), np.zeros(3)
    else:
        (other,) = set(rows) - set(hands)
        goal, drift = state.anchor_x[other], state.anchor_v[other]
    ways = [goal - state.anchor_x[row] for row in hands]
    way = max(float(np.linalg.norm(one)) for one in ways)
    force = max(float(np.linalg.norm(state.reaction[row])) for row in hands)
    free = max(0.0, 1.0 - force / pull.most) if np.isfinite(force) else 0.0
    speed = min(pull.speed + ACCELERATION * interval, pull.fastest, way / EASE) * free
    step = way if way < LAST * pull.fastest * EASE else min(speed * interval, way)
    for row, one in zip(hands, ways, strict=True):
        name = simulation.layout.anchor_names[row]
        simulation.anchors[name].velocity = drift + one * (step / max(way, 1e-300) / interval)
    spent = interval if force < pull.most else HASTE * interval
    return replace(pull, speed=speed, left=pull.left - spent)


def meeting_place(simulation: Simulation, rows: Sequence[int]) -> Floats:
    """Return where two held points are to meet (3,) [m]: the place next to halfway that ropes reach.

    To project on the ball of each tether in turn leads into what all have in common (Bregman 1965).
    """
    state = simulation.arrays
    tethers = [
        one for row in rows for one in _tethers(simulation, int(state.anchor_node[row]), rows)
    ]
    place: Floats = state.anchor_x[list(rows)].mean(axis=0)
    for _ in range(ROUNDS):
        before = place
        for center, length, _name in tethers:
            away = place - center
            size = float(np.linalg.norm(away))
            if size > SLACK * length * (1.0 + 1e-6):
                place = center + away * (SLACK * length / size)
        if np.array_equal(place, before):
            break
    return place


def _tethers(
    simulation: Simulation, node: int, free: Sequence[int] = ()
) -> list[tuple[Floats, float, str]]:
    """Return what holds a node back: places of anchors on its rope, rope between [m], their names."""
    state, layout = simulation.arrays, simulation.layout
    name, number = layout.rope_of(node)
    length = simulation.scene.rope_named(name).segment_length
    found = []
    for row in np.flatnonzero(state.held):
        rope, there = layout.rope_of(int(state.anchor_node[row]))
        if rope == name and row not in free:
            about = layout.anchor_names[row]
            found.append((state.anchor_x[row], length * abs(there - number), about))
    return found


def _refuse_far(simulation: Simulation, nodes: tuple[int, int], most: float) -> None:
    """Raise SceneError where ropes are too short, also when pulled with the largest force, to meet."""
    one, other = (_tethers(simulation, node) for node in nodes)
    softest = min(
        simulation.scene.rope_named(simulation.layout.rope_of(node)[0]).segment_stiffness
        * simulation.scene.rope_named(simulation.layout.rope_of(node)[0]).segment_length
        for node in nodes
    )
    stretch = 1.0 + most / softest if softest > 0.0 else np.inf
    for here, rope, name in one:
        for there, more, end in other:
            gap = float(np.linalg.norm(here - there))
            if gap > (rope + more) * stretch:
                rule = (
                    f"cannot meet: anchors {name!r} and {end!r} are {gap:.3g} m apart, "
                    f"with {rope + more:.3g} m of rope between"
                )
                raise refusal("nodes", f"{nodes[0]}, {nodes[1]}", rule)


def is_over(simulation: Simulation, pull: Pull) -> bool:
    """Tell whether the two have met, or the hands have given up."""
    return pull.left <= 0.0 or not _held(simulation, pull) or _have_met(simulation, pull)


def end(track: Track, pull: Pull) -> str:
    """Tie what a pull has brought together, or let it go; return what was done, in words."""
    simulation = track.simulation
    track.hands.pulls = [one for one in track.hands.pulls if one != pull]
    if not _held(simulation, pull):
        track.restructure(partial(edits.drop_anchors, names=pull.hands))
        return "not tied: a hand has lost its point"
    if _gap(simulation, pull) > pull.near:
        gap = _gap(simulation, pull)
        track.restructure(partial(edits.drop_anchors, names=pull.hands))
        return (
            f"not tied: still {gap:.3g} m apart; hands pull with at most {pull.most:.3g} N, "
            f"{STRONG:g} times the ropes' weight"
        )
    state, names = simulation.arrays, simulation.layout.anchor_names
    a, b = (int(state.anchor_node[names.index(name)]) for name in pull.anchors)
    try:
        track.restructure(partial(edits.knot, nodes=(a, b), hands=pull.hands))
    except SceneError as error:
        track.restructure(partial(edits.drop_anchors, names=pull.hands))
        return "not tied. " + "\n".join(map(sentence, error.faults))
    return ""


def _held(simulation: Simulation, pull: Pull) -> bool:
    return all(
        name in simulation.anchors and simulation.anchors[name].holds for name in pull.anchors
    )


def _have_met(simulation: Simulation, pull: Pull) -> bool:
    """Whether the points are together, and one does not come from the other."""
    names, speeds = simulation.layout.anchor_names, simulation.arrays.anchor_v
    one, other = (speeds[names.index(name)] for name in pull.anchors)
    calm = float(np.linalg.norm(one - other)) <= LAST * pull.fastest
    return calm and _gap(simulation, pull) <= pull.near


def _gap(simulation: Simulation, pull: Pull) -> float:
    names, places = simulation.layout.anchor_names, simulation.arrays.anchor_x
    one, other = (places[names.index(name)] for name in pull.anchors)
    return float(np.linalg.norm(one - other))
