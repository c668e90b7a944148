"""The bench's rods in PyElastica are the ropes of its scenes."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

pytest.importorskip("elastica")

from bench.elastica import BENDS, SAFETY, _longest_step, _overlap, _rod
from bench.touch import DRUM, PIECES, RADIUS, capstan, incline

import ropewalk as rw


def rod_of(scene: rw.Scene) -> Any:
    return _rod(scene.ropes[0], np.array(rw.Simulation(scene).positions))


@pytest.mark.parametrize("scene", [capstan(0.95), incline(16.5)], ids=["capstan", "incline"])
def test_a_rod_has_the_ropes_mass_length_stiffness_and_places(scene: rw.Scene) -> None:
    rope, rod = scene.ropes[0], rod_of(scene)
    assert rod.mass.sum() == pytest.approx(rope.own_mass, rel=1e-9)
    assert rod.rest_lengths == pytest.approx(rope.length / rope.segments, rel=1e-9)
    assert rod.radius == pytest.approx(0.5 * rope.diameter)
    assert rod.shear_matrix[2, 2] == pytest.approx(rope.made_of.EA)
    assert rod.bend_matrix[0, 0] == pytest.approx(BENDS * rope.made_of.EA * RADIUS**2 / 4.0)
    assert pytest.approx(np.array(rw.Simulation(scene).positions)) == rod.position_collection.T
    tangents = np.diff(rod.position_collection.T, axis=0)
    tangents /= np.linalg.norm(tangents, axis=1, keepdims=True)
    assert pytest.approx(tangents) == rod.director_collection[2].T
    for frame in rod.director_collection.transpose(2, 0, 1):
        assert frame @ frame.T == pytest.approx(np.eye(3), abs=1e-12)
        assert np.linalg.det(frame) == pytest.approx(1.0)


def test_the_straight_pieces_round_a_drum_are_inside_it_by_their_sagitta() -> None:
    """Contact of elements' middles would begin with a kick by it."""
    sagitta = (DRUM + RADIUS) * (1.0 - math.sqrt(1.0 - (0.5 * math.pi / PIECES) ** 2))
    axis = np.array([0.0, 1.0, 0.0])
    rod = rod_of(capstan(0.95))
    assert _overlap(rod, np.zeros(3), axis, DRUM) == pytest.approx(sagitta, rel=1e-6)
    assert _overlap(rod, np.zeros(3), axis, 0.9 * DRUM) == 0.0


def test_its_step_is_below_the_fastest_oscillation_of_an_element() -> None:
    """Shear turns a cross-section against its inertia: 2 / omega is the limit of explicit steps."""
    scene = capstan(0.95)
    rope, rod = scene.ropes[0], rod_of(scene)
    piece = rope.length / rope.segments
    turning = math.sqrt(
        rod.shear_matrix[0, 0, 5] * piece / rod.mass_second_moment_of_inertia[0, 0, 5]
    )
    stretching = 2.0 * math.sqrt(rope.made_of.EA / piece / rod.mass[5])
    assert SAFETY * _longest_step(rope) == pytest.approx(
        SAFETY * 2.0 / max(turning, stretching), rel=1e-3
    )
