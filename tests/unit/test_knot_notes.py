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


_HITCHES = ["clove-hitch", "two-half-hitches", "prusik", "munter", "bollard"]
_POST = {"radius": 0.02, "start": (0, 0, -0.1), "end": (0, 0, 0.1)}


def _about(
    *bodies: Any, knot: str = "clove-hitch", post_radius: float = 0.02, **sizes: Any
) -> Scene:
    """A hitch for a post of 20 mm, and what is there."""
    shape = Knot(knot=knot, post_radius=post_radius, **sizes)
    made_of = Material(EA=1e4, mass_per_length=0.08)
    rope = Rope(segments=280, length=2.8, diameter=0.01, made_of=made_of, shape=shape)
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


@pytest.mark.parametrize("knot", _HITCHES)
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


@pytest.mark.parametrize("knot", _HITCHES)
@pytest.mark.parametrize(
    ("post_radius", "half_sizes", "edge_radius", "turned"),
    [
        (0.0285, (0.02, 0.02, 0.3), 0.003, 0.0),
        (0.0285, (0.02, 0.02, 0.3), 0.003, 0.4),
        (0.027, (0.025, 0.01, 0.3), 0.003, 0.0),
        (0.0255, (0.025, 0.006, 0.3), 0.003, 0.5),
    ],
    ids=["square", "square, turned", "flat", "flatter, turned"],
)
def test_nothing_is_said_of_a_hitch_about_a_post_that_is_not_round(
    knot: str, post_radius: float, half_sizes: Any, edge_radius: float, turned: float
) -> None:
    """The hitch has to be drawn about its corners; how thick it is about its axis was asked."""
    bar = Box(
        center=(0, 0, 0), half_sizes=half_sizes, edge_radius=edge_radius, rotation=(0, 0, turned)
    )
    assert knot_warnings(build(_about(bar, knot=knot, post_radius=post_radius))) == []
    (found,) = knot_warnings(build(_about(bar, knot=knot, post_radius=1.5 * post_radius)))
    assert f"no post of about {1.5 * post_radius:g} m radius" in found


@pytest.mark.parametrize("knot", _HITCHES)
@pytest.mark.parametrize("thick", [0.0005, 0.002, 0.004])
def test_a_hitch_about_a_strip_is_told_to_be_slack(knot: str, thick: float) -> None:
    """The way round 50 by 4 mm is 108 mm, that of the circle it is drawn on 160 mm: nothing was said."""
    sizes = {"half_sizes": (0.025, thick, 0.3), "edge_radius": min(thick, 0.002)}
    bar = Box(center=(0, 0, 0), rotation=(0, 0, 0.5), **sizes)
    (found,) = knot_warnings(build(_about(bar, knot=knot, post_radius=0.0255)))
    assert "what stands in it is flat: it starts slack" in found
    (found,) = knot_warnings(build(_about(bar, knot=knot, post_radius=0.038)))
    assert "no post of about 0.038 m radius" in found


@pytest.mark.parametrize("knot", _HITCHES)
def test_a_post_that_ends_within_the_turns_is_told(knot: str) -> None:
    """Those of a prusik go on to five diameters from its middle; one was looked for at each side."""
    shape = _about(knot=knot).ropes[0].shape
    assert isinstance(shape, Knot)
    reach = shape.tied(0.01).reach
    assert 0.013 < reach < 0.05
    for half, told in ((reach, False), (reach - 0.01, True)):
        post = shape.post(2.0 * half)
        assert bool(knot_warnings(build(_about(post, knot=knot)))) is told


def test_a_post_in_two_pieces_is_one() -> None:
    pieces = [Cylinder(**_POST | {key: (0, 0, 0)}) for key in ("start", "end")]
    assert knot_warnings(build(_about(*pieces))) == []


@pytest.mark.parametrize("knot", _HITCHES)
@pytest.mark.parametrize(
    ("at", "to", "diameter", "told"),
    [
        ([(0, 0)], [(0, 0)], 0.034, False),
        ([(-0.001, -0.001)], [(0.001, 0.001)], 0.034, False),
        ([(0.01, 0), (-0.01, 0)], [(0.01, 0), (-0.01, 0)], 0.02, False),
        ([(0.01, 0)], [(0.01, 0)], 0.02, True),  # one of two beside each other
        ([(0, 0)], [(0, 0)], 0.01, True),
        ([(0.012, 0)], [(0.012, 0)], 0.01, True),
        ([(0.5, 0)], [(0.5, 0)], 0.034, True),
    ],
    ids=["one", "askew", "two", "one of two", "thin", "thin, aside", "elsewhere"],
)
def test_a_hitch_on_other_ropes_is_about_those_ropes(
    knot: str, at: Any, to: Any, diameter: float, told: bool
) -> None:
    """By how far it was aside a thin one was taken for a thick one."""
    cord = _about(knot=knot).ropes[0].replace(name="cord")
    ropes = [cord]
    for i, (a, b) in enumerate(zip(at, to, strict=True)):
        start, end = (*a, -0.5), (*b, 0.5)
        size = {"length": math.dist(start, end), "segments": 50, "diameter": diameter}
        ropes.append(cord.replace(name=f"main{i}", **size, shape=Straight(start=start, end=end)))
    scene = _about().replace(ropes=ropes)
    assert bool(knot_warnings(build(scene))) is told


@pytest.mark.parametrize("name", ["overhand", "clove-hitch", "bollard", "prusik", "munter"])
def test_knots_of_presets_are_knots(name: str) -> None:
    assert knot_warnings(build(preset(name))) == []
