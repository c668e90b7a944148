"""Ropes that their own tension presses into a body: told where that is no rest, right where it is."""

from __future__ import annotations

import math
import re
from typing import Any

import pytest

import ropewalk as rw
from ropewalk.scene import Anchor, Force, Material, Points, Polyline, Rope, Scene
from ropewalk.scene.presets import preset
from ropewalk.statics import NoRest, static_shape
from verification.test_rest_on_obstacles import RUN, drum, weighted

SOFT = 4e-5  # [m/N]


def taut_over_a_pipe(length: float, **more: Any) -> Scene:
    """A line of 1 cm with EA of 100 kN over a pipe of 3 cm, its ends held 2 m apart and 30 cm lower."""
    corners = [[-1, 0, -0.3], [-0.012, 0, 0.0331], [0, 0, 0.035], [0.012, 0, 0.0331], [1, 0, -0.3]]
    rope = Rope(
        segments=60,
        length=length,
        diameter=0.01,
        made_of=Material(EA=1e5, mass_per_length=0.07, axial_damping=50.0),
        shape=Polyline(points=[tuple(map(float, corner)) for corner in corners]),
    )
    anchors = [Anchor(node=0), Anchor(node=-1)]
    return Scene(ropes=[rope], anchors=anchors, obstacles=[drum(0.3, 0.03, **more)], run=RUN)


def pulled_round(scale: float, **more: Any) -> Scene:
    """Forces of 400 and 600 N, times `scale`, pull a light rope down on both sides of a drum."""
    scene = weighted(1.5, drum(0.3))
    forces = [Force(node=i, force=(0, 0, -scale * pull)) for i, pull in ((0, 400.0), (-1, 600.0))]
    shape = Points(points=[(x, y, z + 2e-4) for x, y, z in scene.ropes[0].shape.points])
    rope = scene.ropes[0].replace(loads=[], forces=forces, shape=shape)
    return scene.replace(ropes=[rope], obstacles=[drum(0.3, 0.0498, **more)])


@pytest.mark.parametrize("length", [2.06, 2.1])
def test_a_taut_line_that_is_pressed_into_a_pipe_is_not_at_rest(length: float) -> None:
    """At 2.06 m it once hung under the pipe with 1.8 N, at 2.1 m 12 mm deep in it with 70 N."""
    scene = taut_over_a_pipe(length, compliance=SOFT)
    with pytest.raises(NoRest, match=r"mm into 'obstacle0'.*a compliance of at most \d+e-0\d m/N"):
        static_shape(scene)
    check = rw.check(scene, measure=False)
    assert "at rest:" not in "\n".join(check.lines())
    (told,) = [text for text in check.warnings if "the drawn shape presses it in by" in text]
    assert "give it a compliance of at most" in told


@pytest.mark.parametrize("pipe", [{}, {"compliance": 1e-7}])
@pytest.mark.parametrize(("length", "tension"), [(2.06, 2386.0), (2.1, 439.0)])
def test_by_a_stiff_pipe_it_is_at_rest(length: float, tension: float, pipe: Any) -> None:
    """EA (l / L - 1), l from end to end over the node on top; a contact of its own hardens by itself."""
    over_top = 2.0 * math.hypot(1.0, 0.335)
    assert tension == pytest.approx(1e5 * (over_top / length - 1.0), rel=0.01)
    rest = static_shape(taut_over_a_pipe(length, **pipe))
    assert rest.largest_tension == pytest.approx(tension, rel=0.01)


def test_check_tells_how_deep_a_contact_that_hardens_is_pressed() -> None:
    """As deep as it lies at rest: R over the stiffness of the skin was a hundred times that."""
    scene = taut_over_a_pipe(2.06)
    (told,) = [text for text in rw.check(scene, measure=False).warnings if "presses it in" in text]
    rest = static_shape(scene).positions
    depth = 0.035 - math.hypot(rest[30, 0], rest[30, 2])
    found = re.search(r"carries at rest presses it in by ([\d.]+) mm", told)
    assert found is not None
    assert float(found[1]) == pytest.approx(1e3 * depth, rel=0.01)


def test_forces_that_press_a_rope_through_are_told() -> None:
    """It once said that the ropes fall past all obstacles."""
    with pytest.raises(NoRest, match="into 'obstacle0'.*give the obstacle a compliance") as error:
        static_shape(pulled_round(1.0, compliance=1e-2))
    assert "fall past" not in str(error.value)


@pytest.mark.parametrize("more", [{}, {"compliance": 1e-5}])
def test_a_drum_bears_what_pulls_on_ropes(more: dict[str, float]) -> None:
    """By default, too."""
    rest = static_shape(pulled_round(1.0, **more))
    (wrap,) = rest.wraps
    assert (wrap.before, wrap.after) == pytest.approx((400.0, 600.0), rel=1e-3)
    assert wrap.least == pytest.approx(157.0, rel=0.03)
    assert wrap.most == pytest.approx(1031.0, rel=0.03)


def test_what_only_friction_holds_is_strained() -> None:
    """A rope of EA 100 kN that carries 15 N, and no anchor holds it."""
    scene = weighted(1.5, drum(0.3))
    rest = static_shape(scene)
    assert rest.stretch.max() == pytest.approx(1.0 + rest.largest_tension / 1e5, rel=1e-9)
    strain = rw.check(scene, measure=False).ropes[0].largest_strain
    assert strain == pytest.approx(rest.largest_tension / 1e5, rel=1e-4)


def test_a_rope_that_is_drawn_short_is_told_to_be_drawn_as_long_as_it_is() -> None:
    """It was told of a compliance, with which it slid and fell; drawn as long as it is, it rests."""
    capstan = preset("capstan")
    long = capstan.replace(**{"rope.length": 3.6})
    with pytest.raises(NoRest) as told:
        static_shape(long)
    assert "as it falls: its shape is 1.2" in str(told.value)
    assert "m long, and it is 3.6 m; draw it as long as it is" in str(told.value)
    assert "compliance" not in str(told.value)
    points = [list(point) for point in capstan.ropes[0].shape.points]
    for end in (points[0], points[-1]):  # which hang straight down
        end[2] -= 0.5 * (3.6 - 1.22)
    static_shape(long.replace(**{"rope.shape.points": points}))


def test_a_rope_that_is_drawn_taut_is_told_of_a_compliance_with_which_it_rests() -> None:
    """The twin: tension presses it in, and what is told keeps it out."""
    with pytest.raises(NoRest) as told:
        static_shape(taut_over_a_pipe(2.06, compliance=SOFT))
    most = float(re.search(r"compliance of at most (\S+) m/N", str(told.value))[1])
    static_shape(taut_over_a_pipe(2.06, compliance=most))


@pytest.mark.parametrize(("compliance", "yields"), [(1e-5, False), (2e-5, True)])
def test_what_check_says_of_contacts_is_of_the_rest_that_is_known(
    compliance: float, yields: bool
) -> None:
    """All weight on one node was told of a preset whose rest stood two lines above. The twin yields there."""
    scene = rw.preset("capstan").replace(**{"obstacle.compliance": compliance})
    check = rw.check(scene, measure=False)
    assert check.statics.solved
    told = [text for text in check.warnings if "presses it in" in text]
    assert len(told) == yields
    assert all("what a node carries at rest" in text for text in told)
