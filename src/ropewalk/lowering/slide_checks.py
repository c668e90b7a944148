"""Nodes that slide along ropes: they begin on them; and what cannot be done with them."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from ropewalk.core.arrays import Floats, State
from ropewalk.laws.slides.rail import nearest_place, point_at
from ropewalk.laws.slides.reach import whole
from ropewalk.laws.slides.table import NEAREST, room_of
from ropewalk.lowering.layout import Layout
from ropewalk.scene import Scene, SceneError, Winch
from ropewalk.scene.faults import MISSING, NO_VALUE, Fault
from ropewalk.scene.joint import tied_ropes

_NEAR = 1.0  # [1] a node that is drawn farther off, over the length of a segment, is somewhere else
_SECOND = 0.01  # [1] the same of a second node of one rope, which alone is moved


def refuse_slides(scene: Scene, what: str) -> None:
    """Raise SceneError for `what` cannot be done while something slides."""
    if scene.slides:
        raise SceneError([Fault("slide", NO_VALUE, f"{what}; leave out the slides")])


def shortest_length(scene: Scene, winch: Winch, segment: float) -> float:
    """Return the unstretched length at which a winch stops reeling in [m]; `segment` is that of one [m].

    Half a segment, where it is not given; more where something slides along the rope.
    """
    least = 0.5
    if any(slide.on == winch.rope for slide in scene.slides):
        least = room_of(sum(other.rope == winch.rope for other in scene.winches))
    return max(winch.min_length or 0.0, least * segment)


def put_on_ropes(scene: Scene, layout: Layout, state: State) -> None:
    """Move what slides onto its rope, its own rope and what is tied to it with it: lines first, then what
    slides along them.

    Raises SceneError where it is drawn too far from there, where an anchor holds what would be moved, and
    for ropes that slide along each other in a ring.
    """
    faults, placed, lines = list[Fault](), set[str](), set[str]()
    held = {anchor.rope for anchor in scene.anchors}
    tied = _tied_to(scene)
    for i in _lines_first(scene):
        slide = scene.slides[i]
        node, line = layout.node(slide.node, slide.rope), slide.on
        u, way = _way_to_rope(scene, layout, state.x, i)
        faults += _at_drum(scene, layout, state.x, i, u)
        far = float(np.linalg.norm(way))
        group = tied[slide.rope]
        stays = line in group or not (placed | held | lines).isdisjoint(group)
        if stays:
            allowed = _SECOND * scene.rope_named(slide.rope).segment_length
        else:
            allowed = _NEAR * scene.rope_named(line).segment_length
        if (stays or slide.at is None) and far > allowed:
            whose = "a joint" if held.isdisjoint(group) else "an anchor"
            whose = whose if (placed | lines).isdisjoint(group) else "another slide"
            more = f", as {whose} has its rope's place" if stays else ", or give `at`"
            rule = (
                f"lies {far:.4g} m off its place on rope {line!r} at the start: draw it there{more}"
            )
            faults.append(Fault(f"slide[{i}].node", f"node {slide.node} of {slide.rope}", rule))
        elif stays:
            state.x[:, node] += way
        else:
            for own in map(layout.span, group):
                state.x[:, own.first : own.last + 1] += way[:, None]
        placed.update(group)
        lines.add(line)
    if faults:
        raise SceneError(faults)


def _tied_to(scene: Scene) -> dict[str, list[str]]:
    """Return the ropes that joints tie to every rope, by name, itself included."""
    groups = [
        [scene.ropes[k].name for k in group] for group in tied_ropes(scene.ropes, scene.joints)
    ]
    return {name: group for group in groups for name in group}


def _way_to_rope(scene: Scene, layout: Layout, x: Floats, i: int) -> tuple[float, Floats]:
    """Return a slide's place on its line [1], and the way there from where its node is drawn, (3,) [m]."""
    slide = scene.slides[i]
    node, line = layout.node(slide.node, slide.rope), layout.span(slide.on)
    first, last = line.start, line.end
    ends = whole(last - first)
    if slide.at is None:
        away = np.square(x[:, first : last + 1] - x[:, [node]]).sum(axis=0)
        u = nearest_place(x, node, first, ends, float(np.argmin(away)))
    else:
        u = min(slide.at / scene.rope_named(slide.on).segment_length, float(last - first))
    return u, np.array(point_at(x, first, ends, u)) - x[:, node]


def _at_drum(scene: Scene, layout: Layout, x: Floats, i: int, u: float) -> Iterator[Fault]:
    """The fault of a slide that begins where a drum's stop would press on it, at a place [1].

    Along the rope, as `at` is, or through the air as the stop sees it, where the rope is slack or bent.
    """
    slide = scene.slides[i]
    line, span = scene.rope_named(slide.on), layout.span(slide.on)
    place = np.array(point_at(x, span.start, whole(span.end - span.start), u))
    for winch in scene.winches:
        if winch.rope != slide.on:
            continue
        start = winch.end == "start"
        drum = x[:, span.start if start else span.end]
        far = float(np.linalg.norm(place - drum)) / line.segment_length
        away = u if start else line.segments - u
        if min(away, far) < NEAREST:
            away = away if away < NEAREST else far
            least = NEAREST * line.segment_length
            rule = (
                f"is {away * line.segment_length:.4g} m from the drum of winch {winch.name!r}: what slides "
                f"is stopped {NEAREST:g} segments from a drum, {least:.4g} m; begin farther away, or give "
                f"rope {slide.on!r} more segments"
            )
            yield Fault(f"slide[{i}].at", slide.at if slide.at is not None else MISSING, rule)


def _lines_first(scene: Scene) -> list[int]:
    """Return the numbers of the slides, those along a rope after those of that rope. Raises SceneError."""
    left, found = list(range(len(scene.slides))), list[int]()
    while left:
        movers = {scene.slides[i].rope for i in left}
        ready = [i for i in left if scene.slides[i].on not in movers]
        if not ready:
            rule = "ropes that slide along each other in a ring have no order to be placed in; leave one out"
            raise SceneError([Fault(f"slide[{left[0]}].on", scene.slides[left[0]].on, rule)])
        found += ready
        left = [i for i in left if i not in ready]
    return found
