"""Checks across the parts of a scene: names, nodes, anchors, winches."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from itertools import chain, islice

from ropewalk.scene.anchor import Anchor
from ropewalk.scene.environment import Limiter
from ropewalk.scene.faults import MISSING, NO_VALUE, Fault
from ropewalk.scene.joint import Joint, Tie
from ropewalk.scene.limits import MOST_ON_DRUM, MOST_SEGMENTS, MOST_TOLD
from ropewalk.scene.rope import Material, Rope, node_range
from ropewalk.scene.shapes import Slack
from ropewalk.scene.winch import Winch
from ropewalk.words.nearest import nearest
from ropewalk.words.safe_side import rounded_down, rounded_up

#: A catenary's ends must be apart across gravity by this fraction of the rope's length.
_LEAST_WIDTH = 1e-6


def scene_faults(
    gravity: Sequence[float] | None,
    ropes: Sequence[Rope | None],
    anchors: Sequence[Anchor | None],
    winches: Sequence[Winch | None],
    limiter: Limiter | None,
    joints: Sequence[Joint | None] = (),
) -> list[Fault]:
    """The faults between the parts, of very many the first; None is a part that is faulty in itself."""
    found = chain(
        _ropes(ropes, limiter),
        (_slack(gravity, ropes) if gravity is not None else ()),
        _anchors(ropes, anchors),
        _winches(ropes, anchors, winches),
        _weights(gravity, ropes, winches),
        _joints(ropes, anchors, winches, joints),
    )
    told = list(islice(found, MOST_TOLD))
    if next(found, None) is not None:
        told.append(Fault("", NO_VALUE, "and more faults, not told here"))
    return told


def obstacle_faults(names: Iterable[str | None]) -> list[Fault]:
    """The faults of obstacles' names; None where one is faulty, "" for the name it is given."""
    return list(_named_once("obstacle", names))


def _named_once(section: str, names: Iterable[str | None]) -> Iterator[Fault]:
    """The faults of names that stand twice; None where a part is faulty, "" for the name it is given."""
    seen: dict[str, int] = {}
    for i, given in enumerate(names):
        name = given or f"{section}{i}"
        if given is not None and seen.setdefault(name, i) != i:
            rule = f"is the name of {section}[{seen[name]}] already: give it another"
            yield Fault(f"{section}[{i}].name", name, rule)


def _weights(
    gravity: Sequence[float] | None, ropes: Sequence[Rope | None], winches: Sequence[Winch | None]
) -> Iterator[Fault]:
    """Weights in water where there is no up, or where a winch changes what is in the water."""
    wound = [winch.rope for winch in winches if winch is not None]
    for i, rope in enumerate(ropes):
        if rope is None or rope.submerged_weight is None:
            continue
        path, value = f"rope[{i}].submerged_weight", rope.submerged_weight
        if gravity is not None and not any(gravity):
            yield Fault(path, value, "needs gravity: without it nothing has a weight")
        if wound and (rope.name in wound or "" in wound):
            yield Fault(path, value, "a rope on a winch cannot have it: leave it out, or the winch")


def _ropes(ropes: Sequence[Rope | None], limiter: Limiter | None) -> Iterator[Fault]:
    if not ropes:
        yield Fault("rope", MISSING, "a scene needs at least one [[rope]]")
    names: dict[str, int] = {}
    for i, rope in enumerate(ropes):
        if rope is None:
            continue
        if len(ropes) > 1 and "name" not in rope.model_fields_set:
            yield Fault(f"rope[{i}].name", MISSING, "with several ropes each needs a name")
        elif names.setdefault(rope.name, i) != i:
            first = names[rope.name]
            rule = f"is the name of rope[{first}] already: give it another"
            yield Fault(f"rope[{i}].name", rope.name, rule)
        if limiter is not None and rope.segment_length == 0.0:
            yield Fault(
                "limiter", NO_VALUE, f"cannot limit rope[{i}], whose springs have no length"
            )
        if limiter is not None and rope.rigid:
            yield from _bounds_of_links(limiter, i)
    total = sum(rope.segments for rope in ropes if rope is not None)
    if total > MOST_SEGMENTS:
        yield Fault("rope", f"{total} segments", f"must be at most {MOST_SEGMENTS} in total")


def _bounds_of_links(limiter: Limiter, i: int) -> Iterator[Fault]:
    """Bounds that links of one length cannot keep; all others they do."""
    for name, at_fault, most in (
        ("min_stretch", limiter.min_stretch > 1.0, "at most"),
        ("max_stretch", limiter.max_stretch < 1.0, "at least"),
    ):
        if at_fault:
            rule = f"must be {most} 1 beside rope[{i}], whose links are rigid (inf) and keep their length"
            yield Fault(f"limiter.{name}", getattr(limiter, name), rule)


def _slack(gravity: Sequence[float], ropes: Sequence[Rope | None]) -> Iterator[Fault]:
    size = math.hypot(*gravity)
    up = [part / size for part in gravity] if size else [0.0, 0.0, 1.0]
    for i, rope in enumerate(ropes):
        if rope is None or not isinstance(rope.shape, Slack):
            continue
        shape, length = rope.shape, rope.length_unstretched
        step = [b - a for a, b in zip(shape.start, shape.end, strict=True)]
        rise = sum(a * b for a, b in zip(step, up, strict=True))
        width = math.hypot(*(a - rise * b for a, b in zip(step, up, strict=True)))
        sags = shape.sag is not None or length > shape.span * (1 + 1e-9)
        if sags and width < _LEAST_WIDTH * length:
            least = rounded_up(_LEAST_WIDTH * length, 6)
            rule = f"must be at least {least} m aside from start, across gravity"
            yield Fault(f"rope[{i}].shape.end", shape.end, rule)


class _Names:
    """The ropes by name, for what names them."""

    def __init__(self, ropes: Sequence[Rope | None]) -> None:
        self._count, self._any_faulty = len(ropes), None in ropes
        self._index: dict[str, int] = {}
        for i, rope in enumerate(ropes):
            if rope is not None:
                self._index.setdefault(rope.name, i)

    def of(self, part: Anchor | Winch | Tie) -> int | Fault:
        """The index of the rope that a part names, or what is wrong with the name."""
        if not part.rope:
            if self._count == 1:
                return 0
            return Fault("rope", MISSING, "with several ropes, the name of one is needed")
        if part.rope in self._index:
            return self._index[part.rope]
        if self._any_faulty:  # it may name the faulty one
            return -1
        return Fault("rope", part.rope, f"no such rope; {nearest(part.rope, self._index)}")


def _anchors(ropes: Sequence[Rope | None], anchors: Sequence[Anchor | None]) -> Iterator[Fault]:
    yield from _named_once("anchor", (part.name if part is not None else None for part in anchors))
    held: dict[tuple[int, int], int] = {}
    known = _Names(ropes)
    for i, anchor in enumerate(anchors):
        if anchor is None:
            continue
        index = known.of(anchor)
        if isinstance(index, Fault):
            yield index.below(f"anchor[{i}]")
            continue
        rope = ropes[index] if index >= 0 else None
        if rope is None:
            continue
        if not -rope.nodes <= anchor.node < rope.nodes:
            yield Fault(f"anchor[{i}].node", anchor.node, node_range(rope))
            continue
        if anchor.clamp is not None and rope.bending_stiffness == 0.0:
            rule = f"holds a direction: {rope.name!r} needs a material with bending stiffness (EI)"
            yield Fault(f"anchor[{i}].clamp", NO_VALUE, rule)
        first = held.setdefault((index, anchor.node % rope.nodes), i)
        if first != i:
            rule = f"is held by anchor[{first}] already: leave out one of the two"
            yield Fault(f"anchor[{i}].node", anchor.node, rule)


def _winches(
    ropes: Sequence[Rope | None], anchors: Sequence[Anchor | None], winches: Sequence[Winch | None]
) -> Iterator[Fault]:
    first: dict[tuple[int, str], int] = {}
    yield from _named_once("winch", (part.name if part is not None else None for part in winches))
    known, held = _Names(ropes), _held(ropes, anchors)
    for i, winch in enumerate(winches):
        if winch is None:
            continue
        path = f"winch[{i}]"
        index = known.of(winch)
        if isinstance(index, Fault):
            yield index.below(path)
            continue
        rope = ropes[index] if index >= 0 else None
        if rope is None:
            continue
        earlier = first.setdefault((index, winch.end), i)
        if earlier != i:
            rule = f"has winch[{earlier}] already: leave out one of the two"
            yield Fault(f"{path}.end", winch.end, rule)
        end = 0 if winch.end == "start" else rope.segments
        if held is not None and (index, end) not in held:
            node = 0 if winch.end == "start" else -1
            rule = f"needs an anchor at node {node} of {rope.name!r}: give [[anchor]] one, too"
            yield Fault(f"{path}.end", winch.end, rule)
        yield from (fault.below(path) for fault in _winch_lengths(winch, rope))


def _held(
    ropes: Sequence[Rope | None], anchors: Sequence[Anchor | None]
) -> set[tuple[int, int]] | None:
    """The ropes' nodes that anchors hold; None where a faulty anchor may hold any."""
    known, held = _Names(ropes), set()
    for anchor in anchors:
        if anchor is None:
            return None
        index = known.of(anchor)
        rope = ropes[index] if isinstance(index, int) and index >= 0 else None
        if isinstance(index, int) and rope is not None:
            held.add((index, anchor.node + rope.nodes if anchor.node < 0 else anchor.node))
    return held


def _winch_lengths(winch: Winch, rope: Rope) -> Iterator[Fault]:
    length = rope.length_unstretched
    if length == 0.0:
        rule = "has springs of no length, which a winch cannot change: give it one, or leave out the winch"
        yield Fault("rope", rope.name, rule)
        return
    if rope.rigid:
        rule = (
            "has rigid links (inf), which a winch cannot wind segment by segment without a jolt; "
            "give it a finite stiffness: implicit methods take any, such as EA = 1e9, at the same cost"
        )
        yield Fault("rope", rope.name, rule)
    if isinstance(rope.made_of, Material) and any(rope.made_of.curvature):
        rule = "is curved by itself (curvature), with which a winch cannot wind it: leave out curvature"
        yield Fault("rope", rope.name, rule)
    if winch.min_length is not None and winch.min_length > length:
        rule = f"must be at most the rope's length at the start ({length:g} m)"
        yield Fault("min_length", winch.min_length, rule)
    if winch.max_length is not None and winch.max_length < length:
        rule = f"must be at least the rope's length at the start ({length:g} m)"
        yield Fault("max_length", winch.max_length, rule)
    most = MOST_ON_DRUM * rope.segment_length
    if winch.on_drum is not None and winch.on_drum > most:
        rule = f"must be at most {rounded_down(most, 6)} m, a million segments of this rope"
        yield Fault("on_drum", winch.on_drum, rule)


def _joints(
    ropes: Sequence[Rope | None],
    anchors: Sequence[Anchor | None],
    winches: Sequence[Winch | None],
    joints: Sequence[Joint | None],
) -> Iterator[Fault]:
    if not joints:
        return
    yield from _named_once("joint", (part.name if part is not None else None for part in joints))
    tied: dict[tuple[int, int], tuple[int, int]] = {}
    known, drums = _Names(ropes), _drums(ropes, winches)
    for i, joint in enumerate(joints):
        if joint is None:
            continue
        for k, tie in enumerate(joint.points):
            path = f"joint[{i}].points[{k}]"
            index = known.of(tie)
            if isinstance(index, Fault):
                yield index.below(path)
                continue
            rope = ropes[index] if index >= 0 else None
            if rope is None:
                continue
            if not -rope.nodes <= tie.node < rope.nodes:
                yield Fault(f"{path}.node", tie.node, node_range(rope))
                continue
            if (rope.name, tie.node % rope.nodes) in drums:
                rule = "is where a winch's drum is: tie another node, or leave out the winch"
                yield Fault(f"{path}.node", tie.node, rule)
            yield from _tied_once(tied, (index, tie.node % rope.nodes), (i, k), tie.node)
    yield from _held_once(ropes, anchors, tied)


def _drums(ropes: Sequence[Rope | None], winches: Sequence[Winch | None]) -> set[tuple[str, int]]:
    """Return the nodes at which winches wind, by their rope's name; a winch of no name has the only rope."""
    found = set()
    for winch in winches:
        for rope in ropes:
            if winch is not None and rope is not None and winch.rope in ("", rope.name):
                found.add((rope.name, 0 if winch.end == "start" else rope.nodes - 1))
    return found


def _tied_once(
    tied: dict[tuple[int, int], tuple[int, int]],
    point: tuple[int, int],
    place: tuple[int, int],
    node: int,
) -> Iterator[Fault]:
    """A node that is tied already, by `place` of a joint and a point, or to its neighbour."""
    path = f"joint[{place[0]}].points[{place[1]}].node"
    joint, k = tied.setdefault(point, place)
    if joint == place[0] and k != place[1]:
        yield Fault(path, node, f"is points[{k}] already: leave out one of the two")
    elif joint != place[0]:
        rule = f"is tied by joint[{joint}] already: list all nodes that meet in one joint"
        yield Fault(path, node, rule)
    for beside in (-1, 1):
        other = tied.get((point[0], point[1] + beside))
        if other is not None and other[0] == place[0] and other[1] < place[1]:
            rule = (
                f"is the neighbour of points[{other[1]}]: the segment between would have no length; tie a "
                "node farther along"
            )
            yield Fault(path, node, rule)


def _held_once(
    ropes: Sequence[Rope | None],
    anchors: Sequence[Anchor | None],
    tied: dict[tuple[int, int], tuple[int, int]],
) -> Iterator[Fault]:
    """Joints that two anchors hold."""
    known, first = _Names(ropes), dict[int, int]()
    for i, anchor in enumerate(anchors):
        index = known.of(anchor) if anchor is not None else -1
        rope = ropes[index] if isinstance(index, int) and index >= 0 else None
        if anchor is None or rope is None:
            continue
        place = tied.get((ropes.index(rope), anchor.node % rope.nodes))
        if place is not None and first.setdefault(place[0], i) != i:
            rule = (
                f"is tied by joint[{place[0]}] to the node that anchor[{first[place[0]]}] holds: "
            )
            yield Fault(f"anchor[{i}].node", anchor.node, f"{rule}leave out one of the two")
