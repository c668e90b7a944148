"""What is to be said of loads that roll on a line, and wheels under one: segments make bumps.

On a light line that does not stretch it runs on an ellipse about both ends of the line, whose radius of
curvature is rho = (p q)^(3/2) / (a b) where it is p and q from them, 2 a = p + q, b^2 = a^2 - c^2, 2 c the
distance of the ends; about its lowest place it swings with omega^2 = g / rho. A line of segments is bent in
one or two of them, and what rolls over these goes up and down with every node. Measured, on sides of 2.6 to
14 degrees and 20 to 160 segments: omega^2 is up to 0.25 n tan^2 too large with the lowest place at a node,
up to 0.48 n tan^2 too small between two, n the line's length in segments: more on finer lines.

Of a wheel the stiffness that corners add is known (`turning.Turns`): without it omega^2 is less by its share
of the mode, to first order.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.scene.slide import Slide

if TYPE_CHECKING:
    from ropewalk.vibration.modes import Modes
    from ropewalk.vibration.solve import Complex
    from ropewalk.vibration.turning import Turns

_BUMPS = 0.48  # by which omega^2 is off, over n tan^2 of the sides [1]
_HALF, _CENT = 0.5, 100.0
_NOTHING = 0.2  # of a frequency: what is left of it where corners make it [1]
_TOLD = 0.04  # of a frequency: what may be off without a word [1]


def wheel_notes(
    values: Complex, flat: Complex, mass: Floats, bodies: tuple[Turns, ...]
) -> tuple[str, ...]:
    """Return a sentence for every wheel that corners of its rope hold, for the mode of which they make most.

    Args:
        values: eigenvalues (m,) [1/s].
        flat: shapes (m, u), the turning of the bodies at their end.
        mass: (u,) [kg].
        bodies: those.
    """
    found = []
    for number, body in enumerate(bodies):
        turn = np.abs(flat[:, mass.size - len(bodies) + number]) ** 2
        added = body.bump * turn / (mass * np.abs(flat) ** 2).sum(axis=1)  # to omega^2
        square = values.imag**2
        share = np.divide(added, square, out=np.zeros_like(added), where=square > 0.0)
        mode = int(np.argmax(share)) if share.size else 0
        if not share.size or 1.0 - math.sqrt(max(1.0 - float(share[mode]), 0.0)) < _TOLD:
            continue
        rate = math.sqrt(max(1.0 - float(share[mode]), 0.0)) * math.sqrt(float(square[mode]))
        smooth = rate / (2.0 * math.pi)
        now = math.sqrt(float(square[mode])) / (2.0 * math.pi)
        told = "0: it turns on" if smooth < _NOTHING * now else f"{smooth:.3g} Hz"
        found.append(
            f"pulley {body.name!r} turns in mode {mode + 1} at {now:.4g} Hz, held by corners of the rope, "
            f"whose segments make bumps there; without segments it is {told}"
        )
    return tuple(found)


def bump_notes(modes: Modes) -> list[str]:
    """Return a sentence for every slide that rolls freely on steep sides."""
    return [
        told
        for slide in modes.scene.slides
        if slide.friction == 0.0 and slide.brake == 0.0 and (told := _note(modes, slide))
    ]


def _note(modes: Modes, slide: Slide) -> str:
    own, line = modes.layout.span(slide.rope), modes.layout.span(slide.on)
    rider = next(rope for rope in modes.scene.ropes if rope.name == slide.rope)
    place = modes.positions[own.start + rider.node_index(slide.node)]
    nodes = modes.positions[line.start : line.end + 1]
    gravity = np.array(modes.scene.gravity)
    size = float(np.linalg.norm(gravity))
    if size == 0.0:
        return ""
    ways = np.stack([nodes[0] - place, nodes[-1] - place])
    p, q = np.linalg.norm(ways, axis=1)
    if not min(p, q) > 0.0:
        return ""
    sizes = np.linalg.norm(np.diff(nodes, axis=0), axis=1)
    whole, segment = float(sizes.sum()), float(sizes.max())
    # The smooth line cuts the corner under the load.
    p, q = whole * p / (p + q), whole * q / (p + q)
    between = nodes[-1] - nodes[0]
    across = float(np.linalg.norm(between - (between @ gravity) * gravity / size**2))
    steep = math.acos(min(across / whole, 1.0))  # of either side of a light line
    a, c = 0.5 * whole, 0.5 * float(np.linalg.norm(between))
    off = 1.0 - math.sqrt(max(1.0 - _BUMPS * whole / segment * math.tan(steep) ** 2, 0.0))
    if off < _TOLD:
        return ""
    held = {modes.scene.anchor_node(one) for one in modes.scene.anchors if one.rope == slide.on}
    told = (
        f"slide {slide.name!r} rolls on a line whose sides stand at {math.degrees(steep):.3g} degrees: its "
        "segments make bumps there, which shift the frequency at which it rolls by up to "
        f"{'half and more' if off > _HALF else f'some {_CENT * off:.0f} %'}, finer lines the more"
    )
    if held == {0, line.end - line.start} and a > c:
        rate = math.sqrt(size * a * math.sqrt(a * a - c * c) / (p * q) ** 1.5)
        told += f". On a light line that does not stretch it is {rate / (2.0 * math.pi):.4g} Hz"
    return told
