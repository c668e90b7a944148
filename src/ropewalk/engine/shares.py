"""What of a scene's arrays belongs to some of its ropes: cut out, and put together again."""

from __future__ import annotations

from collections import defaultdict
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np

from ropewalk.core.arrays import Floats, Ints, State, copy, flatten
from ropewalk.core.peaks import EXTREMES, FORCE, LEAST_TENSION, LOWEST, PLACE, VALUE
from ropewalk.engine.pressed import join_pressed
from ropewalk.laws.pairs.table import SLIDE
from ropewalk.laws.registry import NAMES
from ropewalk.laws.slides.table import DRUM, ENDS
from ropewalk.lowering import Layout, Model, Pieces, Span
from ropewalk.lowering.layout import make_layout
from ropewalk.lowering.system import make_tables
from ropewalk.scene import Scene

# What the last axis of an array of `State` counts, or the first of those by anchors and winches.
NODES = (
    *("x", "v", "acceleration", "mass", "inverse_mass", "drift"),
    *("bending_stiffness", "bending_damping", "forces.applied", "work.weight", "work.applied"),
    *(f"{kind}.node.{name}" for kind in ("forces", "work") for name in NAMES),
)
SEGMENTS = (
    *("tension", "limited", "rest_length", "stiffness", "damping_vector", "damping_axial"),
    *("inner", "work.elastic", "work.friction", "work.bending"),
)
BETWEEN = ("forces.elastic", "forces.friction", "forces.bending", "forces.limiter")  # n + 1
ANCHORS = (
    *("held", "anchor_node", "anchor_x", "anchor_v", "reaction"),
    *("clamp_direction", "clamp_spin", "moment", "work.anchors", "work.clamps"),
)
WINCHES = ("winch_exit", "winch_rate", "winch_debt", "winch_paid")
JOINTS, POINTS = ("tied",), ("joint_force",)
WHEELS = ("memory.obstacle.wheel",)
BY_BODY = tuple(f"memory.obstacle.{name}" for name in ("grip", "books", "slip"))  # (k, ..., n)
PRESSED = "forces.node.obstacle"  # (3 + 6 k, n): of all obstacles, then of each
SLIDES = tuple(
    f"memory.slide.{name}" for name in ("grip", "group", "sight", "ends", "off", "stops")
)
# Of all ropes together; and what is each island's own: the verdict, a method's memory.
SUMS = ("work.limiter", "work.winch")
OWN = (
    *("past", "now", "jolt", "most", "balance"),
    *("memory.slide.tally", "memory.obstacle.until", "memory.obstacle.load"),
)
MEMORY = "memory."  # of laws of nodes
PEAKS = "peaks."  # every island looks at its own steps
SEGMENTS_RECORDED = (
    *("tension", "elastic_tension", "rest_length"),
    *("tension_low", "tension_high", "stretch_high"),
)
PEAKS_OF_SEGMENTS = ("tension_high", "tension_low", "square_high", "square_low", "stretch")
LINES = slice(0, FORCE)  # the extremes that a segment or node has ...
HOLDERS = slice(FORCE, None)  # ... and those of an anchor
NODES_RECORDED = ("x", "v", "speed_high", "lowest", "highest", "contact")
# Hold indices of nodes, -1: none.
INDICES = (
    *("anchor_node", "winch_exit", "memory.slide.group", "memory.slide.ends"),
    "memory.contact.inside",
)
INSIDE = ("memory.contact.inside",)
# What contacts remember by pairs of segments; see `contact_rows`.
ROWS = tuple(
    f"memory.contact.{name}"
    for name in (
        *("pair", "grip", "near", "tally", "origin"),
        *("box", "order", "tree", "rope", "books", "swept", "hull"),
    )
)
_COUNTED = (NODES, SEGMENTS, BETWEEN, ANCHORS, WINCHES, JOINTS, POINTS, SLIDES, INSIDE, WHEELS)
_KINDS = {name: kind for kind in _COUNTED for name in kind}
_APART = frozenset((*SUMS, *OWN, *ROWS, "memory.obstacle.ties"))
Place = Ints | slice


@dataclass(frozen=True)
class Share:
    """Some ropes of a scene, by where they lie in its arrays and in arrays of their own."""

    scene: Scene  # with these ropes only
    spans: tuple[tuple[Span, Span], ...]  # in the whole and in the share
    anchors: Ints  # rows in the whole
    winches: Ints  # rows in the whole
    joints: Ints  # rows in the whole
    points: Ints  # of these joints, rows in the whole
    slides: Ints  # rows in the whole
    inside: Ints  # of what lies inside the lines of these slides, rows in the whole
    bodies: Ints  # of obstacles, rows in the whole; those that turn freely have one island each
    wheels: Ints  # of those of these that turn freely, rows in the whole
    moved: dict[str, Ints]  # what to take from the whole's indices, by the name of their array

    @cached_property
    def nodes(self) -> Ints:
        """Indices in the whole."""
        return np.concatenate([np.arange(there.first, there.last + 1) for there, _ in self.spans])

    @cached_property
    def segments(self) -> Ints:
        """Indices in the whole of the segments that are not between ropes."""
        return np.concatenate([np.arange(there.first, there.last) for there, _ in self.spans])

    @cached_property
    def own_segments(self) -> Ints:
        """Indices of the same in the share."""
        return np.concatenate([np.arange(own.first, own.last) for _, own in self.spans])

    @cached_property
    def _spots(self) -> dict[tuple[str, ...], tuple[bool, Place, Place]]:
        """What `where` returns, by the arrays; those of one rope lie in a row."""
        anchors, winches = len(self.anchors), len(self.winches)
        spots: dict[tuple[str, ...], tuple[bool, Place, Place]] = {
            ANCHORS: (False, self.anchors, slice(0, anchors)),
            WINCHES: (False, self.winches, slice(0, winches)),
            JOINTS: (False, self.joints, slice(0, len(self.joints))),
            POINTS: (False, self.points, slice(0, len(self.points))),
            SLIDES: (False, self.slides, slice(0, len(self.slides))),
            INSIDE: (False, self.inside, slice(0, len(self.inside))),
            WHEELS: (False, self.wheels, slice(0, len(self.wheels))),
        }
        if len(self.spans) == 1:
            ((there, _),) = self.spans
            first, last, count = there.first, there.last, there.nodes
            spots[NODES] = True, slice(first, last + 1), slice(0, count)
            spots[SEGMENTS] = True, slice(first, last), slice(0, count - 1)
            spots[BETWEEN] = True, slice(first + 1, last + 1), slice(1, count)
        else:
            spots[NODES] = True, self.nodes, slice(0, len(self.nodes))
            spots[SEGMENTS] = True, self.segments, self.own_segments
            spots[BETWEEN] = True, self.segments + 1, self.own_segments + 1
        return spots

    def where(self, name: str) -> tuple[bool, Place, Place]:
        """Return whether the last axis counts in an array of the state, and where its entries lie.

        First in the whole, then in the share. Raises KeyError for an array that nobody has placed.
        """
        return self._spots[_KINDS.get(name, NODES) if name.startswith(MEMORY) else _KINDS[name]]

    def of_bodies(self, name: str, array: Any) -> Any:
        """Return an array of the whole with what it has of the share's obstacles alone."""
        if name == PRESSED and len(array) > 3:
            own = 3 + 6 * self.bodies[:, None] + np.arange(6)
            return array[np.concatenate([np.arange(3), own.ravel()])]
        return array[self.bodies] if name in BY_BODY else array

    def rows(self, name: str) -> Ints:
        """Return where the entries of an array lie in the whole, as indices."""
        at = self.where(name)[1]
        return np.arange(at.start, at.stop) if isinstance(at, slice) else at

    def names(self, own: dict[str, Any]) -> list[str]:
        """Return the names of those arrays of the share that are parts of the whole's."""
        return [
            name
            for name, array in own.items()
            if array.size and name not in _APART and not name.startswith(PEAKS)
        ]

    def cut(self, model: Model, whole: dict[str, Floats], keep: Pieces) -> Model:
        """Return the model of the share: tables of its own, with the state that `model` has, `whole`.

        Tables that are those of the last share, with the same `keep`, are its tables.
        """
        layout = make_layout(self.scene)
        scene = self.scene
        named = scene.winches or scene.joints or scene.slides or scene.contact is not None
        common = layout if named or len(self.spans) > 1 else _nameless(layout)
        system, made = make_tables(self.scene, common, keep, drawn=False)
        state = copy(made)  # nobody writes to what is made
        own = flatten(state)
        for name in self.names(own):
            last, at, here = self.where(name)
            if last:
                own[name][..., here] = self.of_bodies(name, whole[name])[..., at]
            else:
                own[name][here] = whole[name][at]
        for name in INDICES:
            own[name] -= np.where(own[name] < 0, 0, self.moved[name])
        params = model.system.anchors.params[
            self.anchors
        ]  # of motions that may have begun elsewhere
        anchors, rare = (
            system.anchors._replace(params=params),
            model.system.rare,
        )  # one variant for all
        system = system._replace(anchors=anchors, rare=rare)
        return replace(model, scene=self.scene, system=system, state=state, layout=layout)


def _nameless(layout: Layout) -> Layout:
    """Return the layout of a rope by itself as that of any other, where nothing asks for it by name."""
    (span,) = layout.ropes
    return replace(layout, ropes=(replace(span, name=""),), anchor_names=())


def shares_of(model: Model, groups: list[list[int]], homes: Ints | None = None) -> list[Share]:
    """Return the share of every group of ropes, which are given by their numbers.

    `homes` (w,) are the ropes whose shares have the wheels; None: each has all.
    """
    scene, spans, inside = model.scene, model.layout.ropes, model.system.node.contact
    anchors, winches = defaultdict(list), defaultdict(list)
    for row, anchor in enumerate(scene.anchors):
        anchors[anchor.rope].append(row)
    for row, winch in enumerate(scene.winches):
        winches[winch.rope].append(row)
    first_point = np.cumsum([0] + [len(joint.points) for joint in scene.joints])
    shares = []
    for group in groups:
        names = [scene.ropes[i].name for i in group]
        held = sorted(row for name in names for row in anchors[name])
        wound = sorted(row for name in names for row in winches[name])
        here = set(names)
        joints = [j for j, joint in enumerate(scene.joints) if joint.points[0].rope in here]
        points = [k for j in joints for k in range(first_point[j], first_point[j + 1])]
        pairs, first = [], 0
        for i in group:
            pairs.append((spans[i], replace(spans[i], first=first)))
            first += spans[i].nodes
        back = {there.name: there.first - own.first for there, own in pairs}
        slid = [k for k, slide in enumerate(scene.slides) if slide.rope in here]
        moved = {
            "anchor_node": [back[scene.anchors[row].rope] for row in held],
            "winch_exit": [back[scene.winches[row].rope] for row in wound],
        }
        ways = [(back[scene.slides[k].rope], back[scene.slides[k].on]) for k in slid]
        by_node = np.array(ways, np.int64).reshape(-1, 2)[:, [0, 1, 1, 1]]
        at_drums = np.zeros((len(slid), ENDS), np.int64)
        at_drums[:, DRUM:] = by_node[:, 1:2]
        lies = inside.inside[:, SLIDE]
        within = np.flatnonzero(np.isin(lies, slid))
        lines = [[back[scene.slides[k].on]] * 2 for k in lies[within]]
        bodies, turning = _bodies(model, group, homes)
        part = scene.model_copy(
            update={
                "ropes": tuple(scene.ropes[i] for i in group),
                "anchors": tuple(scene.anchors[row] for row in held),
                "winches": tuple(scene.winches[row] for row in wound),
                "joints": tuple(scene.joints[j] for j in joints),
                "slides": tuple(scene.slides[k] for k in slid),
                "obstacles": tuple(scene.obstacles[row] for row in bodies),
            }
        )
        rows = [np.array(part, np.int64) for part in (held, wound, joints, points, slid)]
        shifts = {name: np.array(by, np.int64) for name, by in moved.items()}
        shifts |= {"memory.slide.group": by_node, "memory.slide.ends": at_drums}
        shifts["memory.contact.inside"] = np.array(lines, np.int64).reshape(-1, 2)
        where = rows[0], rows[1], rows[2], rows[3], rows[4], within, bodies, turning
        shares.append(Share(part, tuple(pairs), *where, shifts))
    return shares


def _bodies(model: Model, group: list[int], homes: Ints | None) -> tuple[Ints, Ints]:
    """Return which obstacles a group of ropes has, and which wheels these are, see `shares_of`."""
    wheel = model.system.node.obstacle.wheel
    here = np.ones(len(wheel), bool)
    if homes is not None and homes.size:
        here = (wheel < 0) | np.isin(homes, group)[np.maximum(wheel, 0)]
    return np.flatnonzero(here), wheel[here & (wheel >= 0)]


def best_of(groups: list[tuple[list[Any], Floats]], order: Ints) -> Floats:
    """Return the greatest and least of all shares, (4, ..., 8), of what groups of equal ones have found.

    Shares are asked for `nodes` and `anchors` only. Each is (k, 4, ..., 8): VALUE, PLACE, SINCE and UNTIL of
    `core.peaks`, its EXTREMES last; places become the whole's. `order` says which share each is, in the order
    of the groups: the first of equal ones counts.
    """
    for shares, found in groups:
        places = found[:, PLACE]
        for columns, rows in (
            (LINES, [share.nodes for share in shares]),
            (HOLDERS, [share.anchors for share in shares]),
        ):
            table = np.stack(rows)
            if table.shape[1]:
                own = places[..., columns].astype(np.int64)
                at = np.maximum(own, 0).reshape(len(shares), -1)
                whole = np.take_along_axis(table, at, axis=1).reshape(own.shape)
                places[..., columns] = np.where(own < 0, -1, whole)
    sign = np.ones(len(EXTREMES))
    sign[[LEAST_TENSION, LOWEST]] = -1.0
    found = groups[0][1]
    if len(groups) > 1:
        found = np.concatenate([found for _, found in groups])[np.argsort(order)]
    which = np.argmax(np.where(found[:, PLACE] < 0.0, -np.inf, sign * found[:, VALUE]), axis=0)
    best: Floats = np.take_along_axis(found, which[None, None], axis=0)[0]
    return best


def gather_peaks(shares: list[Share], own: list[State], whole: State) -> None:
    """Write into the whole's state what its shares have seen since their intervals began."""
    peaks = whole.peaks
    if not peaks.speed.size:
        return
    for share, state in zip(shares, own, strict=True):
        for name in PEAKS_OF_SEGMENTS:
            getattr(peaks, name)[share.segments] = getattr(state.peaks, name)[share.own_segments]
        for name in ("speed", "high", "low"):
            getattr(peaks, name)[share.nodes] = getattr(state.peaks, name)
        peaks.reaction[share.anchors] = state.peaks.reaction
        if state.peaks.moment.size:
            peaks.moment[share.anchors] = state.peaks.moment
    rows = [share.bodies for share in shares]
    join_pressed(whole, list(zip(own, rows, strict=True)))
    each = [
        ([share], state.peaks.found[None].copy()) for share, state in zip(shares, own, strict=True)
    ]
    peaks.found[:] = best_of(each, np.arange(len(own)))
    peaks.looked[:] = own[0].peaks.looked
    peaks.error[:, 0] = sum(state.peaks.error[:, 0] for state in own)
    peaks.error[:, 1] = state.peaks.error[:, 1] if len(own) == 1 else np.nan
