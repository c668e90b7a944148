"""How shapes of rest are told: sags in wind, tails that stand, heights that are rounding, ropes on drums."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.record.result import Result
from ropewalk.scene import Air, Anchor, Cylinder, Load, Material, Polyline, Rope, Scene, Straight
from ropewalk.scene.anchor import Clamp
from ropewalk.sheets.loads import _tail_words
from ropewalk.statics import RestSpan, static_shape

WIRE = Material(EA=1e5, mass_per_length=0.5)
ENDS = [Anchor(node=0), Anchor(node=-1)]


def span_of(length: float, stuff: Material = WIRE, **more: object) -> RestSpan:
    """Return what is said of a rope of 10 segments, drawn level over 1 m."""
    shape = Straight(end=(1.0, 0.0, 0.0))
    rope = Rope(length=length, segments=10, diameter=0.03, made_of=stuff, shape=shape)
    (span,) = static_shape(Scene(ropes=[rope], **({"anchors": ENDS} | more))).spans
    return span


def test_in_wind_a_sag_is_said_to_be_along_gravity() -> None:
    """Blown aside by 30 m/s a rope is farther from the line between its ends than that."""
    blown = span_of(1.02, air=Air(density=1.2, wind=(0.0, 30.0, 0.0)))
    for words in (blown.words, str(blown)):
        assert f"sag {blown.sag:.4g} m along gravity over 1 m" in words
    assert "along gravity" not in span_of(1.02, air=Air(density=1.2)).words


def test_a_height_that_is_rounding_is_none() -> None:
    """A taut rope without weight, aslant in space: "rise 8.628e-32 m over 0.9999 m" was said."""
    shape = Straight(start=(0.1, 0.2, 0.3), end=(0.61, 0.77, 0.83))
    rope = Rope(length=0.9, segments=30, made_of=WIRE, shape=shape)
    weightless = Scene(ropes=[rope], anchors=ENDS, gravity=(0, 0, 0))
    (span,) = static_shape(weightless).spans
    assert (span.sag, span.rise) == (0.0, 0.0)
    assert span.hangs == "sag 0 m"


@pytest.mark.parametrize(("EI", "stands"), [(50.0, True), (0.05, False)])
def test_a_rod_that_stands_does_not_hang_free(EI: float, stands: bool) -> None:
    """A clamped cantilever that bends by 1 cm was told to hang free; a limp one hangs from its anchor."""
    clamp = Clamp(direction=(1.0, 0.0, 0.0)) if stands else None
    rod = WIRE.replace(EI=EI)
    tail = span_of(1.0, rod, anchors=[Anchor(node=0, clamp=clamp)])
    assert tail.stands is stands
    said = "stand or hang, 1 m of rope, the tip" if stands else "hang free, 1 m long"
    assert said in tail.words
    assert _tail_words(tail) == ("stands or hangs" if stands else "hangs free")


@pytest.mark.parametrize(("height", "lies"), [(-0.3, True), (-1.5, False)])
def test_a_rod_that_lies_on_the_ground_does_not_stand(height: float, lies: bool) -> None:
    """Every tail with EI was told to stand or hang, one that lies on the ground, too."""
    ground = {"height": height, "repulsion": 1e4, "damping_ratio": 1.0}
    clamp = None if lies else Clamp(direction=(1.0, 0.0, 0.0))
    rod = WIRE.replace(EI=0.05 if lies else 50.0)
    tail = span_of(1.0, rod, anchors=[Anchor(node=0, clamp=clamp)], ground=ground)
    assert tail.stands is not lies
    assert ("hang or lie, " if lies else "stand or hang, ") in tail.words
    assert _tail_words(tail) == ("hangs or lies" if lies else "stands or hangs")


@pytest.mark.parametrize("EI", [0.0, 0.05])
def test_a_tail_that_lies_straight_on_the_ground_does_not_hang_free(EI: float) -> None:
    """Drawn along the ground it is as long from end to end as it is made, and lies all the same."""
    ground = {"height": 0.0, "repulsion": 1e4, "damping_ratio": 1.0}
    tail = span_of(1.0, WIRE.replace(EI=EI), anchors=[Anchor(node=0)], ground=ground)
    assert tail.distance == pytest.approx(1.0, rel=1e-6)
    assert tail.words == "nodes 0 to 10 hang or lie, 1 m of rope, its tip 1 m away"
    assert _tail_words(tail) == "hangs or lies"


def test_a_tension_below_the_force_that_is_left_is_none() -> None:
    """ "largest tension 4.16528e-18 N" was told of a rope that lies on the ground."""
    ground = {"height": 0.0, "repulsion": 1e4, "damping_ratio": 1.0}
    rope = Rope(name="r", length=1.0, segments=10, diameter=0.01, made_of=WIRE, shape=Straight())
    lying = Scene(ropes=[rope], anchors=[Anchor(node=0)], ground=ground)
    rest, shape = rw.equilibrium(lying), static_shape(lying)
    assert 0.0 < rest.tension.max() <= rest.residual
    assert "with 10 segments, largest tension 0 N, at most" in repr(rest)
    assert rest.table["largest tension [N]"] == shape.largest_tension == 0.0
    assert shape.spans[0].pull_words(4) == "0 N"
    assert repr(shape).endswith("largest tension 0 N.")
    assert "at rest: largest tension 0 N, strain 0 %" in str(rw.check(lying, measure=False))


def test_one_segment_and_one_frame_are_told_as_one() -> None:
    """ "with 1 segments" and "in 1 frames"."""
    rope = Rope(name="r", length=1.0, segments=1, made_of=WIRE, shape=Straight())
    hung = Scene(ropes=[rope], anchors=[Anchor(node=0)])
    rest = rw.equilibrium(hung)
    assert "rope 'r' with 1 segment, largest" in repr(rest)
    only = Result(rest.scene, rest.layout, rest.source, replace(rest.facts, status="cancelled"))
    assert "rope 'r' with 1 segment, 0 s in 1 frame by" in repr(only)


def test_a_rope_on_a_drum_is_not_told_to_be_held_by_nothing() -> None:
    arc = [(0.0508 * math.cos(a), 0.0, 0.0508 * math.sin(a)) for a in np.linspace(math.pi, 0, 17)]
    over = Polyline(points=[(-0.0508, 0, -0.1), *arc, (0.0508, 0, -0.1)])
    rope = Rope(
        segments=24, length=0.2 + 0.0508 * math.pi, diameter=0.001, made_of=WIRE, shape=over,
        loads=[Load(node=-1, mass=1.0)],
    )  # fmt: skip
    drum = Cylinder(name="drum", start=(0, -0.1, 0), end=(0, 0.1, 0), radius=0.05, friction=0.5)
    found = static_shape(Scene(ropes=[rope], anchors=[Anchor(node=0)], obstacles=[drum]))
    assert "nothing is held" not in repr(found)
    assert repr(found).startswith(f"Statics: {found.wraps[0]}; largest tension")


@pytest.mark.parametrize("use", ["", ":static", ":relaxing"])
def test_a_climbing_rope_is_said_to_stretch_more_at_rest(use: str) -> None:
    """100 kg stretch it by 3.6 % with the EA of a fall, by 12.5 % with that of rest."""
    rope = Rope(
        segments=4, length=5.0, made_of=f"dynamic-single-9.8{use}", shape={"kind": "hanging"},
        loads=[Load(node=-1, mass=100.0)],
    )  # fmt: skip
    lines = rw.check(Scene(ropes=[rope], anchors=[Anchor(node=0)]), measure=False).lines()
    told = [line for line in lines if "its EA is that of a fall" in line]
    assert bool(told) is (use == "")
    assert all(line.endswith("dynamic-single-9.8:static has that") for line in told)
