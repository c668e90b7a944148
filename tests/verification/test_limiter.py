"""The stretch limiter's impulses: momentum, energy, reactions."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest

from ropewalk.api import simulate
from ropewalk.scene import (
    Anchor,
    Contact,
    Hanging,
    Kick,
    Limiter,
    Load,
    Material,
    Rope,
    RunSettings,
    Scene,
    Springs,
    Straight,
    Winch,
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


def hauled(method: str, tied: bool) -> Scene:
    """20 kg on a rope at its bound, whole or tied in its middle, that a drum hauls for 0.3 s."""
    soft = Material(EA=2000.0, mass_per_length=0.1, axial_damping=20.0)
    load, cuts = [Load(node=-1, mass=20.0)], (0.0, 3.0, 5.0) if tied else (0.0, 5.0)
    ropes = [
        Rope(
            name=f"to{end:g}",
            segments=int(end - start),
            length=end - start,
            made_of=soft,
            shape=Straight(start=(0.0, 0.0, -1.02 * start), end=(0.0, 0.0, -1.02 * end)),
            loads=load if end == 5.0 else [],
        )
        for start, end in pairwise(cuts)
    ]
    ends = [{"rope": "to3", "node": -1}, {"rope": "to5", "node": 0}]
    return Scene(
        ropes=ropes,
        anchors=[Anchor(rope=ropes[0].name, node=0)],
        joints=[{"points": ends}] if tied else [],
        winches=[Winch(rope=ropes[0].name, end="start", speed=-1.0, stop=0.3)],
        limiter=Limiter(min_stretch=0.9, max_stretch=1.02),
        run=RunSettings(duration=0.4, time_step=1e-3, method=method),
    )


@pytest.mark.parametrize("tied", [False, True])
@pytest.mark.parametrize("method", ["semi-implicit-euler", "rk4"])
def test_a_load_at_its_bound_goes_with_the_drum(method: str, tied: bool) -> None:
    """At the bound's own speed, 1.02 m/s, and flies on when the drum stops, as where bounds are solved for;
    the work is the drum's, and the limiter's is what the start of the load takes.
    """
    result = simulate(hauled(method, tied))
    speed = result.velocities[:, -1, 2]
    assert speed[6:18] == pytest.approx(np.full(12, 1.02), abs=1e-6)
    solved = simulate(hauled("esdirk3", tied))
    assert speed[20:] == pytest.approx(solved.velocities[20:, -1, 2], abs=0.01)
    assert result.positions[-1, -1] == pytest.approx(solved.positions[-1, -1], abs=2e-3)
    lost = 0.5 * 20.0 * 1.02**2
    assert -1.1 * lost < result.work["limiter"][-1] < -0.9 * lost
    both = solved.work["winch"][-1] + solved.work["limiter"][-1]
    assert result.work["winch"][-1] + result.work["limiter"][-1] == pytest.approx(both, rel=0.01)


def test_slack_rope_is_reeled_in_as_where_bounds_are_solved_for() -> None:
    """A rope that hangs in a bow is drawn over at 3 m/s; 5 cm less far where impulses held it back."""
    ends = []
    for method in ("semi-implicit-euler", "esdirk3"):
        soft = Material(EA=500.0, mass_per_length=0.1, axial_damping=1.0)
        bow = {"kind": "slack", "start": (0.0, 0.0, 0.0), "end": (3.0, 0.0, 0.0)}
        scene = Scene(
            ropes=[Rope(segments=4, length=4.0, made_of=soft, shape=bow)],
            anchors=[Anchor(node=0), Anchor(node=-1)],
            winches=[Winch(end="start", speed=-3.0, stop=0.04)],
            limiter=Limiter(min_stretch=0.98, max_stretch=1.0, passes=20),
            run=RunSettings(duration=0.08, time_step=1e-3, method=method),
        )
        ends.append(simulate(scene).positions[-1])
    assert ends[0] == pytest.approx(ends[1], abs=5e-3)


@pytest.mark.parametrize("side", [0, -1])
def test_an_anchor_that_has_let_go_holds_no_order(side: int) -> None:
    """A rope falls from one of its ends: what was near to that end keeps within its bounds as well as what is
    near the other one; it was stretched by 1.020 of 1.010 where its nodes stayed as if still held.
    """
    soft = Material(EA=300.0, mass_per_length=0.1, axial_damping=1.0)
    bow = {"kind": "slack", "start": (0.0, 0.0, 0.0), "end": (2.4, 0.0, 0.0)}
    let_go = {0: None, -1: None} | {side: 0.2}
    scene = Scene(
        ropes=[Rope(segments=16, length=3.0, made_of=soft, shape=bow)],
        anchors=[Anchor(node=node, release_time=time) for node, time in let_go.items()],
        limiter=Limiter(min_stretch=0.5, max_stretch=1.01),
        run=RunSettings(duration=0.9, time_step=8e-4, method="semi-implicit-euler"),
    )
    result = simulate(scene)
    lengths = np.linalg.norm(np.diff(result.positions, axis=1), axis=2)
    assert lengths.max() / (3.0 / 16) < 1.0103


def test_a_rope_on_a_drum_keeps_its_order_beside_another() -> None:
    """One that touches nothing, in the same island: the anchor of the rope on the drum counted twice."""
    soft = Material(EA=20.0, mass_per_length=0.1)
    ends = []
    for far in (None, 50.0):
        shapes = {"wound": Straight(start=(0, 0, 0), end=(3, 0, 0))}
        if far:
            shapes["other"] = Straight(start=(0, far, 0), end=(3, far, 0))
        ropes = [
            Rope(name=name, segments=6, length=3.0, diameter=0.01, made_of=soft, shape=shape)
            for name, shape in shapes.items()
        ]
        scene = Scene(
            ropes=ropes,
            anchors=[Anchor(rope="wound", node=node) for node in (0, -1)],
            winches=[Winch(rope="wound", end="start", speed=1.5, max_length=6.0)],
            contact=Contact(),
            limiter=Limiter(max_stretch=1.02),
            run=RunSettings(duration=0.5, time_step=0.01, method="semi-implicit-euler"),
        )
        ends.append(simulate(scene).rope("wound").positions[-1])
    assert np.array_equal(*ends)
