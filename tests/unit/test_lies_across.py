"""Which segments lie across a body, down to those whose ends are as deep in it as nodes may be."""

from __future__ import annotations

import math

import pytest

import ropewalk as rw
from ropewalk.laws.obstacle_way import DEEPEST, lies_across
from ropewalk.lowering import build
from ropewalk.scene import Cylinder, Material, Straight

RADIUS = 0.055  # [m] of the bar, the rope's own counted in


def crosses(length: float, beside: float, along: float = 0.0) -> bool:
    """Whether a segment lies across a bar, its middle so far from the axis, and so far aside [m]."""
    rope = rw.Rope(
        segments=2,
        length=1.0,
        diameter=0.01,
        made_of=Material(EA=math.inf, mass_per_length=0.1),
        shape=Straight(start=(1, 0, 0), end=(2, 0, 0)),
    )
    bar = Cylinder(start=(0, -1, 0), end=(0, 1, 0), radius=0.05)
    table = build(rw.Scene(ropes=rope, obstacles=[bar])).system.node.obstacle
    ends = (along - 0.5 * length, 0.0, beside), (along + 0.5 * length, 0.0, beside)
    return bool(lies_across(table, 0, 0, *ends))


@pytest.mark.parametrize("share", [0.51, 0.8, 1.3, 1.5, 3.0])
def test_what_has_its_middle_on_the_axis_lies_across(share: float) -> None:
    assert crosses(share * RADIUS, 0.001 * RADIUS)


@pytest.mark.parametrize("share", [0.3, 0.8, 1.3])
def test_chords_near_the_surface_cut_a_corner_only(share: float) -> None:
    """Where both ends are in no deeper than DEEPEST of the radius, and on one side."""
    assert not crosses(share * RADIUS, 0.8 * RADIUS)


def test_shorter_ones_cannot_with_ends_as_deep_as_nodes_may_be() -> None:
    assert not crosses(0.99 * 2.0 * (1.0 - DEEPEST) * RADIUS, 0.0)
