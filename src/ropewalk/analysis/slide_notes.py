"""What `check` says of slides: how far off their ropes loads hang, and where lines turn sharply at them.

By default a slide is no stiffer than a segment of its rope, about, so that a force F hangs some F h / EA off
the curve, where that is more than `laws.slides.sliding.SINK` of a segment h. What a sharp turn does:
`statics.slide_bumps`.
"""

from __future__ import annotations

import math

import numpy as np

from ropewalk.laws.slides.reach import place_near, whole
from ropewalk.laws.slides.sliding import SINK, known_pulls
from ropewalk.lowering import Model
from ropewalk.lowering.system import tied_masses
from ropewalk.scene import Slide
from ropewalk.statics.hung import held_nodes
from ropewalk.statics.pressing import rounded
from ropewalk.statics.slide_bumps import SHARP, bump_words, turn_at
from ropewalk.statics.touches import OFF

_CENT = 100.0


def slide_warnings(model: Model) -> list[str]:
    """Return a sentence for every slide whose known load hangs off its rope, and where that turns sharply.

    None of the first where it was told to.
    """
    scene, table = model.scene, model.system.node.slide
    if not scene.slides:
        return []
    whole, gravity = tied_masses(scene), math.hypot(*scene.gravity)
    pulls = known_pulls(scene.slides, model.layout, scene.ropes, whole, gravity)
    found = []
    for row, (slide, pull) in enumerate(zip(scene.slides, pulls, strict=True)):
        off, segment = pull / float(table.stiffness[row]), float(table.length[row])
        if slide.compliance is None and off > OFF * segment:
            found.append(
                f"slide {slide.name!r}: what hangs on it ({pull:.4g} N) is {1e3 * off:.3g} mm off rope "
                f"{slide.on!r}, {_CENT * off / segment:.3g} % of a segment, as the slide is no stiffer than "
                "steps for these ropes allow for; give it a compliance of at most "
                f"{rounded(SINK * segment / pull)} m/N where that matters (explicit methods then need "
                "shorter steps), or more segments"
            )
        turn = _sharpest(model, row, slide, pull)
        if turn > SHARP:
            found.append(bump_words(slide.name, slide.on, turn))
    return found


def _sharpest(model: Model, row: int, slide: Slide, pull: float) -> float:
    """Return by how much a line turns at a slide [rad], as drawn or once the load `pull` [N] draws it taut.

    The latter of a line that two anchors alone bear, with its load where it starts or, where nothing rubs
    or brakes, where it comes to rest: there both sides are as steep, asin(across / length) to the vertical
    for anchors so far across.
    """
    table, x = model.system.node.slide, model.state.x
    first, last, node = int(table.first[row]), int(table.last[row]), int(table.node[row])
    length = float(table.length[row])
    u = place_near(table, row, x, whole(last - first))
    turn = turn_at(x, first, last, u)
    held = [i for i in held_nodes(model, model.layout.span(slide.on)) if first <= i <= last]
    low = [i for i in held if i < first + u]
    high = [i for i in held if i > first + u]
    gravity = np.asarray(model.system.gravity)
    if not low or not high:
        return turn
    own = slice(low[-1] + 1, high[0])  # its loads too draw a line down
    given = float(np.linalg.norm(model.state.forces.applied[:, own], axis=0).sum())
    if not pull > float(np.linalg.norm(gravity)) * float(model.state.mass[own].sum()) + given:
        return turn
    if _borne_elsewhere(model, slide):
        return turn
    a, b = x[:, low[-1]], x[:, high[0]]
    before, after = (first + u - low[-1]) * length, (high[0] - first - u) * length
    if model.state.inverse_mass[node] == 0.0:  # a ring that is held
        into, out = x[:, node] - a, b - x[:, node]
        return max(turn, math.atan2(float(np.linalg.norm(np.cross(into, out))), float(into @ out)))
    span = float(np.linalg.norm(b - a))
    if not before + after > span:
        return turn
    if abs(before - after) < span:  # else it is slack there on one side
        turn = max(turn, math.acos((span**2 - before**2 - after**2) / (2.0 * before * after)))
    if slide.friction == slide.brake == 0.0 and gravity.any():
        down = gravity / np.linalg.norm(gravity)
        across = float(np.linalg.norm(b - a - (b - a) @ down * down))
        turn = max(turn, math.pi - 2.0 * math.asin(min(across / (before + after), 1.0)))
    return turn


def _borne_elsewhere(model: Model, slide: Slide) -> bool:
    """Tell whether more than its anchors and this slide may bear or load a line, which then makes no V."""
    scene = model.scene
    touching = scene.ground is not None or scene.contact is not None or bool(scene.obstacles)
    ties = [tie for joint in scene.joints for tie in joint.points if tie.rope == slide.on]
    loose = any(
        model.state.inverse_mass[model.layout.node(tie.node, tie.rope)] > 0.0 for tie in ties
    )
    others = any(one.on == slide.on and one.name != slide.name for one in scene.slides)
    return touching or loose or others
