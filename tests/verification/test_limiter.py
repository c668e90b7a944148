"""The stretch limiter's impulses: momentum, energy, reactions."""

from __future__ import annotations

import numpy as np
import pytest

from ropewalk.scene import (
    Anchor,
    Hanging,
    Kick,
    Limiter,
    Load,
    Material,
    Rope,
    RunSettings,
    Scene,
    Springs,
)
from ropewalk.simulation import Simulation


def pair(limiter: Limiter | None = None) -> Scene:
    """Two free nodes of 1.01 and 0.01 kg that fly apart, almost without a spring between them."""
    springs = Springs(spring_constant=1e-3, node_mass=0.01, segment_length=1.0)
    return Scene(
        gravity=(0.0, 0.0, 0.0),
        ropes=[
            Rope(
                segments=1,
                made_of=springs,
                loads=[Load(node=0, mass=1.0)],
                kicks=[
                    Kick(node=0, velocity=(0.1, 0.0, 0.0)),
                    Kick(node=1, velocity=(10.0, 0.0, 0.0)),
                ],
            )
        ],
        limiter=limiter,
        run=RunSettings(duration=1.0, time_step=0.01, method="semi-implicit-euler"),
    )


def hanging(min_stretch: float = 0.9, max_stretch: float = 1.1) -> Scene:
    """0.6 kg of a rope far too soft for its weight, so that it rests on the limiter."""
    soft = Material(EA=1.0, mass_per_length=0.1, axial_damping=0.01)
    return Scene(
        ropes=[Rope(segments=6, length=6.0, made_of=soft, shape=Hanging())],
        anchors=[Anchor(node=0)],
        limiter=Limiter(min_stretch=min_stretch, max_stretch=max_stretch),
        run=RunSettings(duration=20.0, time_step=0.005, method="semi-implicit-euler"),
    )


def test_a_free_pair_keeps_its_momentum_and_stops_parting() -> None:
    """A perfectly inelastic stop: both go on with the speed of the centre of mass, P / M."""
    simulation = Simulation(pair(Limiter()))
    before = simulation.recording().recording
    (block,) = simulation.frames()
    film = block.recording
    np.testing.assert_allclose(film.momentum, before.momentum.repeat(60, axis=0), atol=1e-14)
    # the spring of 1e-3 N/m changes the speed of the lighter node by < 1e-2 m/s in a second
    assert film.v[-1, 0] == pytest.approx(0.201 / 1.02, abs=1e-2)
    assert film.energy[-1, 0] == pytest.approx(0.201**2 / (2 * 1.02), rel=1e-2)
    assert film.energy[:, 0].max() <= before.energy[0, 0] + 1e-12


def test_without_a_limiter_the_pair_parts() -> None:
    """The twin: nothing stops it, so the comparison above would fail."""
    (block,) = Simulation(pair()).frames()
    assert block.recording.v[-1, 0, 1] > 9.0


def test_the_anchor_carries_what_rests_on_the_limiter() -> None:
    """At rest the reaction is the whole weight, although the springs pull far less."""
    simulation = Simulation(hanging())
    for block in simulation.frames():
        film = block.recording
    weight = 0.6 * 9.81
    assert film.elastic_tension[-1].max() < 0.2
    assert film.tension[-1].max() == pytest.approx(weight * 5.5 / 6, rel=1e-3)  # half a node above
    assert film.reaction[-1, 0, 2] == pytest.approx(weight, rel=1e-3)
    assert np.abs(film.v[-1]).max() < 0.02  # less than half a step's gravity


def test_a_limit_of_one_length_keeps_every_length() -> None:
    """With equal limits the segments are links: lengths hold and the pendulum's energy never grows."""
    scene = hanging(1.0, 1.0).replace(limiter=Limiter(min_stretch=1.0, max_stretch=1.0, passes=20))
    simulation = Simulation(scene)
    for block in simulation.frames():
        lengths = np.linalg.norm(np.diff(block.recording.x, axis=2), axis=1)
        np.testing.assert_allclose(lengths, 1.0, rtol=1e-9)
