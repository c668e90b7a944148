"""Between which places of a line friction and brake hold what slides along it.

The line's two sides meet in a load W with the same horizontal part of tension, as under a clamp, and the
load is carried by what acts across the line, N, and along it, F. Along is half way between the directions
of both sides, t- and t+, the tangent of a smooth line through both:

    F = W . (t- + t+) / |t- + t+|,   F^2 + N^2 = W^2,   held where |F| <= mu N + b,   b the brake.

Without brake that is where the way on which the load would roll is no steeper than mu. Both sides are
elastic catenaries, see `rolling`.
"""

from __future__ import annotations

import math

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.rigging.lines import Line
from ropewalk.rigging.rolling import rest_at
from ropewalk.scene import Material, Scene
from ropewalk.scene.rope import Rope
from ropewalk.scene.slide import Slide
from ropewalk.statics.touches import Seat
from ropewalk.theory import elastic_catenary
from ropewalk.words.safe_side import inwards

_FIGURES = (4, 5, 6, 7)
_ROUNDS = 20  # of halving between two places
_NEAREST = 0.01  # of the span: nearer to an anchor nothing is looked for [1]
_NODES = 2.0  # segments by which the shape at rest may differ from the closed form


def held_places(scene: Scene, ropes: dict[str, Floats], seat: Seat) -> tuple[float, float] | None:
    """Return the first and the last place at which a slide is held [m], unstretched from the rope's start.

    Args:
        scene: the scene at rest.
        ropes: by name, the places of its nodes there (n, 3) [m].
        seat: where the slide is, and what it does there.

    None where the closed form does not say it: without friction and brake, without weight, or where
    anything but weight and two anchors at its ends holds the rope.
    """
    slide = next(one for one in scene.slides if one.name == seat.slide)
    rope = scene.rope_named(seat.on)
    if seat.most <= 0.0 or not any(scene.gravity) or not _plain(scene, rope, slide):
        return None
    load, gravity = math.hypot(seat.force, seat.along), float(np.linalg.norm(scene.gravity))
    line = _line(rope, ropes[rope.name], np.array(scene.gravity) / gravity, gravity)
    if line is None:
        return None
    about = _NODES * rope.segment_length
    for first, last in _intervals(line, load, slide):
        if first - about <= seat.at <= last + about:
            return first, last
    return None


def _intervals(line: Line, load: float, slide: Slide) -> list[tuple[float, float]]:
    """Return where a slide is held: two intervals where it brakes beyond what friction holds only."""
    rolling = _ends(line, load, _most(load, slide.friction, 0.0))
    if slide.brake == 0.0:
        return [rolling]
    first, last = _ends(line, load, _most(load, slide.friction, slide.brake))
    first = max(first, slide.brake_from)
    if first <= rolling[1]:
        return [(min(first, rolling[0]), last)]
    return [rolling, (first, last)] if first <= last else [rolling]


def _ends(line: Line, load: float, most: float) -> tuple[float, float]:
    return _end(line, load, -most), _end(line, load, most)


def in_words(seat: Seat, places: tuple[float, float] | None) -> str:
    """Return what a user reads of them, empty for none."""
    if places is None:
        return ""
    for figures in _FIGURES:  # as many as have the rest, as it is told, between them
        first, last = inwards(*places, figures)
        if float(first) <= float(f"{seat.at:.5g}") <= float(last):
            break
    return (
        f"slide {seat.slide!r} is held anywhere from {first} to {last} m of rope {seat.on!r} "
        "(closed form of a line that hangs by its ends)"
    )


def _plain(scene: Scene, rope: Rope, slide: Slide) -> bool:
    """Tell whether only weight, one slide and anchors at its ends act on a rope that obeys Hooke's law."""
    held = sorted(scene.anchor_node(one) for one in scene.anchors if one.rope == rope.name)
    rider = any(one.rope == slide.rope for one in scene.anchors)
    blown = scene.air is not None and any(scene.air.wind)
    touched = scene.obstacles or scene.ground is not None or scene.joints or blown
    made = rope.made_of
    straight = isinstance(made, Material) and made.EI == 0.0 and not (rope.curved or rope.relaxes)
    alone = sum(one.on == rope.name for one in scene.slides) == 1 and not rope.loads
    pushed = rope.forces or scene.rope_named(slide.rope).forces or rope.submerged_weight is not None
    hung = sum(one.rope == slide.rope for one in scene.slides) > 1  # not upright, then
    ends = held == [0, rope.segments]
    return bool(ends and straight and alone and not (touched or rider or pushed or hung))


def _line(rope: Rope, places: Floats, down: Floats, gravity: float) -> Line | None:
    made = rope.made_of
    assert isinstance(made, Material)
    way = places[-1] - places[0]
    rise = -float(way @ down)
    across = float(np.linalg.norm(way + rise * down))
    if not across > 0.0:
        return None
    weight = made.mass_per_length * gravity
    try:
        cable = elastic_catenary(rope.length_unstretched, across, rise, weight, made.EA)
    except ValueError:
        return None
    return Line(cable, made, None, gravity, "")


def _most(load: float, friction: float, brake: float) -> float:
    """Return the largest force along the line that holds [N]: F = mu N + b with F^2 + N^2 = W^2."""
    if brake >= load:
        return load
    square = 1.0 + friction**2
    normal = math.sqrt((friction * brake) ** 2 - square * (brake**2 - load**2)) - friction * brake
    return friction * normal / square + brake


def _end(line: Line, load: float, wanted: float) -> float:
    """Return the unstretched place [m] at which the force along the line is what is wanted [N].

    The end of the rope where it is less all the way to it.
    """
    low, high = _NEAREST * line.span, (1.0 - _NEAREST) * line.span
    for end, sign, place in ((low, 1.0, 0.0), (high, -1.0, line.length)):
        found = _along(line, load, end)
        if found is not None and sign * (found[1] - wanted) >= 0.0:
            return place
    left = 0.5 * line.length
    for _ in range(_ROUNDS):
        middle = 0.5 * (low + high)
        found = _along(line, load, middle)
        if found is None:  # out of reach: nearer to the middle
            low, high = (middle, high) if middle < 0.5 * line.span else (low, middle)
            continue
        left = found[0]
        low, high = (middle, high) if found[1] < wanted else (low, middle)
    return left


def _along(line: Line, load: float, x: float) -> tuple[float, float] | None:
    """Return the unstretched length left of a load at x [m], and the force towards the line's end that
    holds it there [N], negative left of the lowest place; None where no rest is found.
    """
    try:
        left, _, (first, last) = rest_at(line, load, True, x, None)
    except ArithmeticError:
        return None
    before, after = np.array(first.end_force), -np.array(last.start_force)
    way = before / np.linalg.norm(before) + after / np.linalg.norm(after)
    return left, float(load * way[1] / np.linalg.norm(way))
