"""Modes of a rod that sags say that its bending damping does not damp them out of plane."""

from __future__ import annotations

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.scene import Anchor, Clamp, Material, Rope, RunSettings, Scene, Straight


def rod(*, EA: float = 4e5, longer: float = 0.0, damping: float = 0.05) -> Scene:
    """2 m of rod between two clamps, stretched by so much [m]."""
    made_of = Material(EA=EA, mass_per_length=0.5, EI=40.0, bending_damping=damping)
    shape = Straight(end=(2.0 + longer, 0.0, 0.0))
    rope = Rope(name="rod", segments=20, length=2.0, made_of=made_of, shape=shape)
    ends = [Anchor(node=node, clamp=Clamp(direction=(1, 0, 0))) for node in (0, -1)]
    return Scene(ropes=[rope], anchors=ends, run=RunSettings(duration=0.1))


def test_a_rod_that_sags_says_that_it_swings_sideways_undamped() -> None:
    """It sags by millimetres and "falls to 1/e: never", where a straight one has 3 %: without a word. Twins:
    the straight rod, one without damping, and one that tension keeps rather than its stiffness.
    """
    sags, straight = rw.modes(rod(), count=4), rw.modes(rod(), about="start", count=4)
    (note,) = (note for note in sags.notes if "bending damping" in note)
    assert "rope 'rod' is curved" in note
    aside = next(i for i, one in enumerate(sags.motions) if one.name == "out of plane")
    assert f"mode {aside + 1}, out of plane" in note
    assert sags.damping_ratios[aside] < 0.01 * straight.damping_ratios[0]
    frequency = straight.frequencies[0]
    assert straight.damping_ratios[0] == pytest.approx(np.pi * frequency * 0.05 / 40.0, rel=0.02)
    for twin in (
        straight,
        rw.modes(rod(damping=0.0), count=4),
        rw.modes(rod(longer=0.02), count=4),
    ):
        assert not any("bending damping" in note for note in twin.notes), twin.notes
