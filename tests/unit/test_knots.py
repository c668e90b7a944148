"""Knots as curves: which knots they are, how far apart their strands are, how sharply they bend, how long."""

from __future__ import annotations

import math
import re
from typing import Any

import numpy as np
import pytest

from ropewalk import knots
from ropewalk.core.arrays import Floats
from ropewalk.knots.course import Curve
from ropewalk.lowering import build
from ropewalk.scene import (
    Contact,
    Cylinder,
    Knot,
    Material,
    Rope,
    RunSettings,
    Scene,
    SceneError,
    Torus,
    dumps,
    loads,
)
from verification.topology import alexander, crossings, jones, linking_number

D = 0.01
FAR = 8.0  # [m]
TURNS = (0.1, 0.2, 0.3, 0.5, 0.7, 0.9, 1.1, 1.3)


def sizes(name: str, post: float = 2.0) -> dict[str, Any]:
    """A post of so many diameters for what needs one."""
    return {} if name in knots.KNOTS else {"post_radius": post * D}


def nodes(name: str, one: float = 1.2, **more: Any) -> list[Floats]:
    """The nodes of all ropes of a knot, segments of so many diameters, with ends of 15 diameters."""
    tied = knots.knot(name, D, **{**sizes(name), **more})
    count = math.ceil((tied.length / D + 30.0) / one)
    return [tied.points(count, count * one * D, rope + 1) for rope in range(tied.ropes)]


def closed(name: str, ropes: list[Floats]) -> list[Floats]:
    """The rope joined far away to a closed curve, and the post beside it, closed on the other side."""
    if len(ropes) == 2:  # what is pulled to what is pulled, free ends to free ends
        (a, b), y = ropes, ropes[0][-1, 1]
        over = [[-FAR, y, 0], [-FAR, FAR, 0], [FAR, FAR, 0], [FAR, y, 0]]
        below = [[FAR, -y, 0], [FAR, -FAR, 0], [-FAR, -FAR, 0], [-FAR, -y, 0]]
        return [np.vstack([a, over, b[::-1], below])]
    x = ropes[0]
    ends = []
    for end, before in ((x[0], x[1]), (x[-1], x[-2])):
        ends.append(end + FAR * (end - before) / np.linalg.norm(end - before))
    if name in knots.KNOTS:
        middle = 0.5 * (ends[0] + ends[1]) + [0.0, 3.0 * FAR, 0.1]
        return [np.vstack([x, ends[1], middle, ends[0]])]
    aside = np.array([0.0, -4.0 * FAR, 0.0])
    rope = np.vstack([x, ends[1], ends[1] + aside, ends[0] + aside, ends[0]])
    post = [[0, 0, -FAR], [0, 0, FAR], [4 * FAR, 2 * FAR, FAR], [4 * FAR, 2 * FAR, -FAR]]
    return [rope, np.array(post, float)]


#: Alexander polynomials: 3_1; 4_1; two of 3_1, their product; 8_20; of links with the post 6^2_3, no name,
#: none (a prusik can be taken off by its bight), 5^2_1 (Whitehead's), and the torus link (2, 4).
#: Sources: Rolfsen, Knots and Links, 1976, appendix C; that of the half hitches is its own.
KNOWN = {
    "overhand": ((1, -1, 1), None),
    "figure-eight": ((1, -3, 1), None),
    "reef": ((1, -2, 3, -2, 1), None),
    "granny": ((1, -2, 3, -2, 1), None),
    "bowline": ((1, -2, 3, -2, 1), None),
    "clove-hitch": ((1, -5, 5, -1), 2),
    "two-half-hitches": ((2, -6, 10, -10, 6, -2), 2),
    "prusik": ((0,), 0),
    "munter": ((1, -3, 3, -1), 0),
    "bollard": ((1, -1, 1, -1), 2),
}


def test_all_knots_are_known() -> None:
    assert set(KNOWN) == set(knots.names())


@pytest.mark.parametrize("name", KNOWN)
@pytest.mark.parametrize("slack", [1.0, 2.5])
def test_which_knot_it_is(name: str, slack: float) -> None:
    """By its Alexander polynomial in two projections, and by how often it goes round the post."""
    curves = closed(name, nodes(name, slack=slack))
    polynomial, links = KNOWN[name]
    for turn in (0.3, 1.1):
        assert alexander(curves, turn) == polynomial
    if links is not None:
        assert abs(linking_number(*curves)) == pytest.approx(links, abs=1e-6)


def polynomial_of(name: str) -> dict[int, int]:
    """Its Jones polynomial, from the projection with the fewest crossings."""
    (curve,) = closed(name, nodes(name))
    return jones(curve, min(TURNS, key=lambda turn: len(crossings([curve], turn)[0])))


def product(one: dict[int, int], other: dict[int, int]) -> dict[int, int]:
    """Of two polynomials."""
    found: dict[int, int] = {}
    for i, a in one.items():
        for j, b in other.items():
            found[i + j] = found.get(i + j, 0) + a * b
    return {power: value for power, value in found.items() if value}


def test_a_reef_is_a_trefoil_and_its_mirror_image_and_a_granny_two_alike() -> None:
    """Alexander's polynomial does not tell them apart; that of Jones does (Jones 1985)."""
    right = {1: 1, 3: 1, 4: -1}
    left = {-power: value for power, value in right.items()}
    assert polynomial_of("overhand") == right
    assert polynomial_of("reef") == product(right, left)
    assert polynomial_of("granny") in (product(right, right), product(left, left))
    assert polynomial_of("figure-eight") == {-2: 1, -1: -1, 0: 1, 1: -1, 2: 1}
    # 8_20, or its mirror image
    seen = polynomial_of("bowline")
    assert seen == {-1: -1, 0: 2, 1: -1, 2: 2, 3: -1, 4: 1, 5: -1}


def test_a_prusik_winds_to_one_side_and_back_on_the_other() -> None:
    """Three turns each, in which the two cancel: its linking number is none."""
    (x,) = nodes("prusik")
    angle = np.unwrap(np.arctan2(x[:, 1], x[:, 0]))
    middle = len(x) // 2
    upper = angle[middle] - angle[0]
    assert upper == pytest.approx(6.5 * math.pi, abs=0.5)  # from -x, and three turns
    assert angle[-1] - angle[middle] == pytest.approx(-upper, abs=0.2)
    assert x[: middle - 2, 2].min() > 0.0
    assert x[middle + 2 :, 2].max() < 0.0


def test_the_bight_of_a_prusik_lies_over_its_turns_and_ends() -> None:
    (x,) = nodes("prusik")
    far = np.hypot(x[:, 0], x[:, 1])
    middle = len(x) // 2
    turns = far < far[middle] - 0.5 * D  # without the bight, and without the ends
    assert turns.sum() > 0.5 * (np.abs(x[:, 0]) < far[middle]).sum()
    bight = x[middle - 3 : middle + 4]
    ends = x[(x[:, 0] < 0.0) & (np.abs(x[:, 2]) < D) & (x[:, 1] < 0.0)]
    assert bight[:, 1].max() < ends[np.abs(ends[:, 0]) > D][:, 1].min() - 0.9 * D


def least_distance(name: str, ropes: list[Floats]) -> float:
    """Between strands that are more than four diameters apart along one rope, or of two ropes [diameters]."""
    least = math.inf
    for k, x in enumerate(ropes):
        fine = np.concatenate([x[:-1] + s * np.diff(x, axis=0) for s in (0.0, 0.25, 0.5, 0.75)])
        along = np.concatenate([np.arange(len(x) - 1) + s for s in (0.0, 0.25, 0.5, 0.75)])
        one = float(np.linalg.norm(x[1] - x[0]))
        for other in range(k, len(ropes)):
            y = ropes[other]
            apart = np.linalg.norm(fine[:, None] - y[None], axis=2)
            if other == k:
                apart[np.abs(along[:, None] - np.arange(len(y))) * one < 4.0 * D] = math.inf
            least = min(least, float(apart.min()))
    return least / D


@pytest.mark.parametrize("name", KNOWN)
def test_strands_do_not_overlap_and_bend_gently(name: str) -> None:
    """With segments of 1.5 diameters, too; bent to a diameter at least, or about a thin post."""
    for slack in (1.0, 2.5):
        for post in (0.5, 1.0, 5.0, 20.0) if name in knots.HITCHES else (0.0,):
            more = {"slack": slack} | sizes(name, post)
            tied = knots.knot(name, D, **more)
            bound = 1.0 if name in knots.KNOTS else min(1.0, 0.45 * (post + 0.5))
            assert tied.least_radius > bound * D
            for one in (0.8, 1.5):
                ropes = nodes(name, one, **more)
                assert least_distance(name, ropes) > 1.05
                if post > 1.0:  # about thinner ones chords of 1.5 diameters cut the corner
                    assert np.hypot(ropes[0][:, 0], ropes[0][:, 1]).min() > (post + 0.5) * D


def test_a_munter_on_a_ring_is_clear_of_it() -> None:
    ropes = nodes("munter", post_radius=2.0 * D, ring_radius=10.0 * D)
    x, y, z = ropes[0].T
    from_bar = np.hypot(np.hypot(y - 10.0 * D, z) - 10.0 * D, x)
    assert from_bar.min() > 2.5 * D
    assert least_distance("munter", ropes) > 1.05
    t = np.linspace(0.0, 2.0 * math.pi, 60, endpoint=False)
    ring = 10.0 * D * np.stack((0.0 * t, 1.0 - np.cos(t), np.sin(t)), axis=1)
    assert alexander([closed("munter", ropes)[0], ring]) == KNOWN["munter"][0]


@pytest.mark.parametrize("name", KNOWN)
def test_segments_are_equally_long_and_so_is_the_rope(name: str) -> None:
    """To rounding; its ends are straight and, where nothing else is said, equally long."""
    for x in nodes(name):
        one = np.linalg.norm(np.diff(x, axis=0), axis=1)
        assert np.abs(one / (1.2 * D) - 1.0).max() < 1e-12
    tied = knots.knot(name, D, **sizes(name))
    curve, length = tied.curves[0], tied.length + 0.3
    x = tied.points(200, length)
    first = math.dist(x[0], curve.at(0.0))
    last = math.dist(x[-1], curve.at(curve.length))
    assert last - tied.within[1] == pytest.approx(first - tied.within[0], abs=0.2 * D)
    x = tied.points(200, length, first_end=0.05)
    assert math.dist(x[0], curve.at(0.0)) - tied.within[0] == pytest.approx(0.05, rel=1e-9)


@pytest.mark.parametrize("slack", [1.0, 4.0])
@pytest.mark.parametrize("post", [0.5, 2.0, 20.0])
def test_the_shortest_rope_has_what_a_knot_is_tied_about(slack: float, post: float) -> None:
    """Half hitches about no standing part, a bight over no ends, were tied without a word."""
    tied = knots.knot("two-half-hitches", D, post_radius=post * D, slack=slack)
    for first_end in (None, 0.0):
        length = tied.length + 1e-3 * D
        x = tied.points(math.ceil(length / D), length, first_end=first_end)
        y, z = x[:, 1] - x[0, 1], x[:, 2] - x[0, 2]
        hitches = np.flatnonzero(np.hypot(y, z) > 7.0 * D).max() + 1
        turned = np.unwrap(np.arctan2(z[hitches:], y[hitches:]))
        assert abs(turned[-1] - turned[0]) > 3.5 * math.pi  # about the standing part
        assert x[0, 0] < x[hitches:, 0].min() - D
    with pytest.raises(ValueError, match=f"length: {0.999 * tied.length:g} - must be more than"):
        tied.points(2000, 0.999 * tied.length)
    prusik = knots.knot("prusik", D, post_radius=post * D, slack=slack)
    length = prusik.length + 1e-3 * D
    x = prusik.points(math.ceil(length / D), length)
    bight = x[len(x) // 2]
    assert bight[1] < x[0, 1] - D  # farther from the post, over the ends
    assert max(x[0, 0], x[-1, 0]) < bight[0] - D


def test_the_length_of_a_curve() -> None:
    """A circle's, to 1e-6, and a chain's converges to it."""
    angle = np.linspace(0.0, 1.5 * math.pi, 41)
    circle = np.stack((np.cos(angle), np.sin(angle), 0.0 * angle), axis=1)
    curve = Curve(circle, np.array([0.0, 1.0, 0.0]), np.array([1.0, 0.0, 0.0]))
    assert curve.length == pytest.approx(1.5 * math.pi, rel=1e-6)
    assert curve.least_radius == pytest.approx(1.0, rel=1e-2)
    fine = np.array([curve.at(s) for s in np.linspace(0.0, curve.length, 20001)])
    found = np.linalg.norm(np.diff(fine, axis=0), axis=1).sum()
    assert found == pytest.approx(curve.length, rel=1e-6)


@pytest.mark.parametrize(
    ("name", "more", "said"),
    [
        ("sheepshank", {}, "name: 'sheepshank' - must be one of overhand, figure-eight"),
        ("reef", {"slack": 0.5}, "slack: 0.5 - must be from 1 to 4"),
        ("reef", {"post_radius": 0.1}, "post_radius: 0.1 - leave it out: a reef has no post"),
        ("prusik", {}, "a prusik is tied about a post: give its radius"),
        ("prusik", {"post_radius": 0.9}, "post_radius: 0.9 - must be from 0.004 to 0.5 m"),
        ("prusik", {"post_radius": 0.01, "turns": 2.5}, "turns: 2.5 - must be a whole number"),
        ("reef", {"turns": 2.0}, "turns: 2.0 - leave it out: only prusik and bollard have them"),
        ("munter", {"post_radius": 0.01, "ring_radius": 0.02}, "ring_radius: 0.02 - must be at"),
        ("prusik", {"post_radius": 0.01, "ring_radius": 0.2}, "only a munter is tied on a ring"),
    ],
)
def test_what_cannot_be_tied_is_refused_in_words(name: str, more: Any, said: str) -> None:
    with pytest.raises(ValueError, match=said):
        knots.knot(name, D, **more)


@pytest.mark.parametrize("diameter", [0.010123, 0.011, 0.0123457])
def test_sizes_that_are_told_are_those_of_a_knot(diameter: float) -> None:
    """They were rounded to the nearest, and refused when given."""
    with pytest.raises(ValueError, match="post_radius") as refused:
        knots.knot("bollard", diameter, post_radius=1e3)
    for bound in re.findall(r"from (\S+) to (\S+) m", str(refused.value))[0]:
        assert knots.knot("bollard", diameter, post_radius=float(bound))
    with pytest.raises(ValueError, match="length") as refused:
        knots.knot("overhand", diameter).points(500, 1e-3)
    need = float(re.findall(r"more than (\S+) m", str(refused.value))[0])
    assert len(knots.knot("overhand", diameter).points(500, need * (1.0 + 1e-9))) == 501


def test_a_rope_too_short_or_too_coarse_is_refused_in_words() -> None:
    tied = knots.knot("overhand", D)
    with pytest.raises(
        ValueError, match=r"length: 0.1 - must be more than 0.4\d+ m for an overhand"
    ):
        tied.points(20, 0.1)
    with pytest.raises(ValueError, match=r"segments: 20 - must be at least 67"):
        tied.points(20, 1.0)
    with pytest.raises(ValueError, match="rope: 2 - must be from 1 to 1 for an overhand"):
        tied.points(100, 1.0, rope=2)
    with pytest.raises(ValueError, match="diameter: 0.0 - must be greater than 0"):
        knots.knot("overhand", 0.0)


def rope_of(shape: Knot, name: str = "cord", one: float = 1.2, ends: float = 30.0) -> Rope:
    """A rope so tied, in segments of so many diameters, with so many diameters for its ends."""
    count = math.ceil((shape.tied(D).length / D + ends) / one)
    made_of = Material(EA=1e4, mass_per_length=0.05)
    length = count * one * D
    return Rope(name=name, segments=count, length=length, diameter=D, made_of=made_of, shape=shape)


@pytest.mark.parametrize("name", knots.names())
def test_every_knot_starts_without_tension_or_overlap(name: str) -> None:
    """As a rope's shape, turned and moved, about its post as an obstacle; no contact is pressed."""
    shape = Knot(
        knot=name, **sizes(name), center=(1, 2, 3), along=(1, 1, 0.2), normal=(0.1, -0.2, 1)
    )
    ropes = [rope_of(shape, "a")]
    if name in ("reef", "granny"):
        ropes.append(rope_of(shape.replace(rope=2), "b"))
    posts = [shape.post(0.3, friction=0.4)] if name in knots.HITCHES else []
    run = RunSettings(method="implicit-euler", time_step=1 / 240)
    scene = Scene(ropes=ropes, obstacles=posts, contact=Contact(), run=run)
    assert loads(dumps(scene)) == scene
    model = build(scene)
    x = model.state.x[:, : ropes[0].nodes].T
    stretch = np.linalg.norm(np.diff(x, axis=0), axis=1) / ropes[0].segment_length
    assert np.abs(stretch - 1.0).max() < 1e-12
    turned = knots.knot(name, D, **sizes(name)).points(
        ropes[0].segments, ropes[0].length_unstretched
    )
    for a, b in ((0, -1), (10, 40), (25, 30)):
        assert math.dist(x[a], x[b]) == pytest.approx(math.dist(turned[a], turned[b]), rel=1e-9)
    if posts:
        assert isinstance(posts[0], Cylinder)
        axis = np.array(posts[0].end) - np.array(posts[0].start)
        axis /= np.linalg.norm(axis)
        away = np.cross(x - np.array(posts[0].start), axis)
        assert np.linalg.norm(away, axis=1).min() > 2.5 * D


@pytest.mark.parametrize("size", [1.0, 15.0, 30.0])
def test_a_clove_hitch_is_clear_of_its_post(size: float) -> None:
    """About thick posts the way to the crossing strand was a chord, 3.3 mm inside one of 15 diameters."""
    shape = Knot(knot="clove-hitch", post_radius=size * D)
    build(Scene(ropes=[rope_of(shape)], obstacles=[shape.post()]))


def test_a_ring_lies_where_the_munter_is_tied() -> None:
    shape = Knot(
        knot="munter", post_radius=0.02, ring_radius=0.1, center=(0, 0, 1), normal=(0, 1, 0)
    )
    ring = shape.post(friction=0.2)
    assert isinstance(ring, Torus)
    assert (ring.radius, ring.bar_radius, ring.friction) == (0.1, 0.02, 0.2)
    assert math.dist(ring.center, shape.center) == pytest.approx(0.1)
    x = build(Scene(ropes=[rope_of(shape)])).state.x.T
    axis = np.array(ring.axis)
    along = (x - np.array(ring.center)) @ axis
    across = np.linalg.norm(np.cross(x - np.array(ring.center), axis), axis=1)
    assert np.hypot(across - 0.1, along).min() > 0.025


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({"knot": "sheepshank"}, 'knot: "sheepshank"'),
        ({"knot": "reef", "rope": 3}, "rope: 3 - must be at most 2"),
        ({"knot": "overhand", "rope": 2}, "rope: 2 - leave it out: an overhand has one rope"),
        ({"knot": "munter"}, "post_radius: missing - a munter is tied about a post"),
        ({"knot": "reef", "along": (0, 0, 0)}, "along: .* - must not be zero"),
        ({"knot": "reef", "along": (0, 0, 2)}, "normal: .* - must not point along `along`"),
        ({"knot": "bollard", "post_radius": 0.02, "turns": 90}, "turns: 90.* - must be from 0.5"),
    ],
)
def test_faulty_knots_in_a_scene_are_told(given: dict[str, Any], said: str) -> None:
    with pytest.raises(SceneError, match=said):
        Knot(**given)


def test_a_rope_that_does_not_fit_its_knot_is_told() -> None:
    made_of = {"kind": "material", "EA": 1e4, "mass_per_length": 0.05}

    def made(length: float, segments: int, **shape: Any) -> Rope:
        return Rope(
            segments=segments, length=length, diameter=D, made_of=made_of, shape=Knot(**shape)
        )

    with pytest.raises(
        SceneError, match=r"length: 0.3 - must be more than 0.4\d+ m for an overhand"
    ):
        made(0.3, 40, knot="overhand")
    with pytest.raises(SceneError, match=r"segments: 40 - must be at least 67"):
        made(1.0, 40, knot="overhand")
    with pytest.raises(SceneError, match=r"shape.post_radius: 0.001 - must be from 0.004 to 0.5 m"):
        made(1.0, 100, knot="bollard", post_radius=0.001)
    with pytest.raises(SceneError, match=r"length: 1.0.* with that first_end"):
        made(1.0, 100, knot="overhand", first_end=0.8)


def test_a_knot_without_a_post_has_none() -> None:
    with pytest.raises(ValueError, match="knot: reef - has no post"):
        Knot(knot="reef").post()
