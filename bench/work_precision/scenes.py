"""The ropes on which the methods compete."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from ropewalk import Anchor, Material, Rope, RunSettings, Scene, preset
from ropewalk.lowering import build
from ropewalk.scene.shapes import Points, Slack

SEGMENTS = 100
MASS, LENGTH = 5.0, 10.0  # [kg], [m]
TILT = math.radians(60.0)  # of the swinging rope's first shape, from the vertical


class Case(NamedTuple):
    """One rope and the time at which errors are taken."""

    name: str
    title: str
    scene: Scene
    duration: float  # [s]


def dropped(EA: float, segments: int = SEGMENTS) -> Scene:
    """Return a rope that is held at one end and let go from the horizontal."""
    return Scene(
        name=f"dropped rope, EA {EA:.0e} N",
        ropes=[_rope(EA, segments)],
        anchors=[Anchor(node=0)],
        run=RunSettings(duration=1.0),
    )


def swinging(segments: int = SEGMENTS) -> Scene:
    """Return a rope between two pins 8 m apart, let go with its catenary turned up by 60 degrees."""
    slack = _rope(1e5, segments, shape=Slack(end=(8.0, 0.0, 0.0)))
    anchors = [Anchor(name="left", node=0), Anchor(name="right", node=-1)]
    hanging = Scene(ropes=[slack], anchors=anchors)
    points = build(hanging).state.x.T.copy()
    down = points @ np.asarray(hanging.up)
    turned = np.zeros_like(points)
    turned[:, 0], turned[:, 1], turned[:, 2] = (
        points[:, 0],
        -math.sin(TILT) * down,
        math.cos(TILT) * down,
    )
    turned[-1] = (8.0, 0.0, 0.0)
    rope = _rope(1e5, segments, shape=Points(points=[tuple(p) for p in turned.tolist()]))
    return Scene(name="swinging rope", ropes=[rope], anchors=anchors)


def _rope(EA: float, segments: int, **more: object) -> Rope:
    material = Material(EA=EA, mass_per_length=MASS / LENGTH)
    return Rope(segments=segments, length=LENGTH, made_of=material, **more)


def cases() -> list[Case]:
    """Return all of them."""
    return [
        Case("dropped-1e5", "Dropped rope, EA 100 kN", dropped(1e5), 1.0),
        Case("dropped-1e7", "Dropped rope, EA 10 MN", dropped(1e7), 1.0),
        Case("swinging", "Swinging rope, pinned at both ends", swinging(), 2.0),
        Case("report", "The report's scene, R4", preset("r4"), 2.0),
        Case("nehe", "NeHe's scene, N40", preset("n40"), 1.0),
        Case("whip", "Whip", preset("whip"), 0.3),
    ]
