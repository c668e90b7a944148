"""What a check says of knots: strands that nothing keeps apart, hitches about nothing, ropes that lack."""

from __future__ import annotations

import math
from typing import Any

import pytest

from ropewalk.analysis.knot_notes import knot_warnings
from ropewalk.api import preset
from ropewalk.lowering import build
from ropewalk.scene import (
    Box,
    Contact,
    Cylinder,
    Knot,
    Material,
    Plane,
    Rope,
    RunSettings,
    Scene,
    Sphere,
    Straight,
    loads,
)


def _knotted(knot: str, more: str = "", **sizes: float) -> Scene:
    given = "".join(f", {name} = {value}" for name, value in sizes.items())
    return loads(f"""
{more}
[[rope]]
segments = 160
length = 1.6
diameter = 0.01
made_of = {{ kind = "material", EA = 1e4, mass_per_length = 0.08 }}
shape = {{ kind = "knot", knot = "{knot}"{given} }}
""")


@pytest.mark.parametrize(
    ("scene", "words"),
    [
        (_knotted("overhand"), "an overhand, but strands go through each other; add a [contact]"),
        (
            _knotted("reef", "[contact]"),
            "a reef, but its other rope is not there; give one the same",
        ),
        (
            _knotted("clove-hitch", "[contact]", post_radius=0.02),
            "but there is no post; add it as an",
        ),
        (_knotted("bollard", post_radius=0.02), "but there is no post; add it as an obstacle"),
    ],
)
def test_a_knot_that_is_none_is_told(scene: Scene, words: str) -> None:
    """A scene of a knot without [contact] ran, came undone and said nothing."""
    found = knot_warnings(build(scene))
    assert len(found) == 1
    assert words in found[0]


_POST = {"radius": 0.02, "start": (0, 0, -0.1), "end": (0, 0, 0.1)}


def _about(*bodies: Any, knot: str = "clove-hitch", **sizes: Any) -> Scene:
    """A hitch for a post of 20 mm, and what is there."""
    shape = Knot(knot=knot, post_radius=0.02, **sizes)
    made_of = Material(EA=1e4, mass_per_length=0.08)
    rope = Rope(segments=140, length=1.4, diameter=0.01, made_of=made_of, shape=shape)
    run = RunSettings(method="implicit-euler", time_step=0.004)
    return Scene(ropes=[rope], obstacles=bodies, contact=Contact(), run=run)


@pytest.mark.parametrize(
    "body",
    [
        Plane(point=(0, 0, -0.3)),
        Cylinder(**_POST | {"start": (0, 0.2, -0.1), "end": (0, 0.2, 0.1)}),
        Cylinder(**_POST | {"radius": 0.01}),
        Cylinder(**_POST | {"start": (0, 0, 0.005), "end": (0, 0, 0.2)}),
        Sphere(center=(0, 0, 0), radius=0.02),
    ],
    ids=["floor", "aside", "thin", "short", "ball"],
)
def test_a_hitch_whose_post_is_elsewhere_is_told(body: Any) -> None:
    """Any obstacle in the scene was taken for the post."""
    (found,) = knot_warnings(build(_about(body)))
    assert "no post of about 0.02 m radius stands at its center along its normal" in found


@pytest.mark.parametrize("knot", ["clove-hitch", "two-half-hitches", "prusik", "munter", "bollard"])
@pytest.mark.parametrize("where", [{}, {"center": (1, 2, 3), "normal": (0, 1, 0.5)}])
def test_nothing_is_said_of_a_hitch_about_its_post(knot: str, where: dict[str, Any]) -> None:
    """Nor with a ring, a floor besides, or a post that is square, or a little thinner."""
    more = [where] if knot != "munter" else [where, where | {"ring_radius": 0.1}]
    for sizes in more:
        post = _about(knot=knot, **sizes).ropes[0].shape.post(0.3)
        floor = Plane(point=(0, 0, -3))
        assert knot_warnings(build(_about(floor, post, knot=knot, **sizes))) == []
    thinner = Cylinder(**_POST | {"radius": 0.016})
    square = Box(center=(0, 0, 0), half_sizes=(0.016, 0.016, 0.2), edge_radius=0.006)
    for body in (thinner, square):
        assert knot_warnings(build(_about(body, knot=knot))) == []


@pytest.mark.parametrize(
    ("at", "to", "diameter", "told"),
    [
        ((0, 0, -0.5), (0, 0, 0.5), 0.034, False),
        ((-0.02, -0.02, -0.5), (0.02, 0.02, 0.5), 0.034, False),
        ((0.01, 0, -0.5), (0.01, 0, 0.5), 0.02, False),  # one of two beside each other
        ((0, 0, -0.5), (0, 0, 0.5), 0.01, True),
        ((0.5, 0, -0.5), (0.5, 0, 0.5), 0.034, True),
    ],
)
def test_a_hitch_on_another_rope_is_about_that_rope(
    at: tuple[float, ...], to: tuple[float, ...], diameter: float, told: bool
) -> None:
    scene = _about(knot="prusik")
    length = math.dist(at, to)
    main = scene.ropes[0].replace(
        name="main",
        length=length,
        segments=50,
        diameter=diameter,
        shape=Straight(start=at, end=to),
    )
    scene = scene.replace(ropes=[scene.ropes[0].replace(name="cord"), main])
    assert bool(knot_warnings(build(scene))) is told


@pytest.mark.parametrize("name", ["overhand", "clove-hitch", "bollard", "prusik", "munter"])
def test_knots_of_presets_are_knots(name: str) -> None:
    assert knot_warnings(build(preset(name))) == []
