"""What modes are given and refuse; how runs start at rest, and go on to the same bits."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from scipy.sparse import identity

import ropewalk as rw
from ropewalk.lowering import build
from ropewalk.record.resume import resume_run
from ropewalk.record.run import record_run
from ropewalk.scene import Anchor, Rope, Scene, Springs, Straight, Velocity
from ropewalk.scene.at_nodes import Kick
from ropewalk.vibration import NoModes
from ropewalk.vibration.flexibility import rate
from ropewalk.vibration.linear import Linear, linearise
from ropewalk.vibration.winding import missing

STUFF = Springs(spring_constant=500.0, node_mass=0.05, segment_length=0.5, spring_friction=0.05)
REST = rw.RunSettings(start="at-rest", duration=0.2)


def scene(run: rw.RunSettings = REST, **more: object) -> Scene:
    velocity = more.pop("velocity", (0, 0, 0))
    shape = Straight(end=(2.5, 0, 0.2), velocity=velocity)
    rope = Rope(segments=6, made_of=STUFF, shape=shape, kicks=more.pop("kicks", ()))
    anchors = more.pop("anchors", (Anchor(node=0), Anchor(node=-1)))
    return Scene(ropes=(rope,), anchors=anchors, run=run, **more)


def test_modes_that_damping_puts_out_of_order_say_in_which_they_stand() -> None:
    """34.47 Hz stood before 34.17, "the slowest first". The twin: with less friction none is overtaken."""
    for friction, told in ((0.3, True), (0.05, False)):
        stuff = STUFF.replace(spring_friction=friction)
        damped = scene().replace(ropes=(scene().ropes[0].replace(made_of=stuff),))
        found = rw.modes(damped, count=15)
        rings = found.frequencies[found.frequencies > 0.0]
        assert bool((np.diff(rings) < -0.1).any()) is told
        assert any("order of their natural frequencies" in note for note in found.notes) is told


def test_a_table_of_modes() -> None:
    found = rw.modes(scene(), count=4)
    assert found.count == 4
    assert (np.diff(found.natural_frequencies) >= 0.0).all()
    row = found.table[0]
    assert row["mode"] == 1
    assert row["frequency [Hz]"] == found.frequencies[0]
    assert 0.0 < row["damping ratio [1]"] < 0.1
    assert row["motion"] in ("in plane", "out of plane")
    np.testing.assert_allclose(np.linalg.norm(np.abs(found.shapes), axis=2).max(axis=1), 1.0)
    assert (found.shapes[:, [0, -1]] == 0.0).all()
    assert repr(found).startswith("Modes of 'scene' about its equilibrium: ")
    assert found.motions[0].along + found.motions[0].in_plane + found.motions[0].out_of_plane == (
        pytest.approx(1.0)
    )
    again = rw.modes(scene(), count=4)
    np.testing.assert_array_equal(again.eigenvalues, found.eigenvalues)


def test_what_modes_refuse() -> None:
    with pytest.raises(ValueError, match="about: \"rest\"|about: 'rest' - must be"):
        rw.modes(scene(), about="rest")  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="count: 0 - must be at least 1"):
        rw.modes(scene(), count=0)
    with pytest.raises(rw.SceneError, match="no anchor holds it"):
        rw.modes(scene(anchors=(), run=rw.RunSettings()))
    both = Scene(
        ropes=(Rope(segments=1, made_of=STUFF),), anchors=(Anchor(node=0), Anchor(node=-1))
    )
    assert rw.modes(both).count == 0  # nothing is free


def test_a_run_starts_from_the_equilibrium() -> None:
    simulation = rw.Simulation(scene())
    np.testing.assert_array_equal(simulation.positions, rw.equilibrium(scene()).positions[0])
    assert not simulation.velocities.any()
    kicked = rw.Simulation(scene(kicks=(Kick(node=2, velocity=(0, 0, 1)),)))
    assert kicked.velocities[2, 2] == 1.0
    assert np.count_nonzero(kicked.velocities) == 1
    moving = (Anchor(node=0, motion=Velocity(velocity=(0, 0, 0.5))), Anchor(node=-1))
    moved = rw.Simulation(scene(anchors=moving))
    np.testing.assert_array_equal(moved.velocities[0], [0, 0, 0.5])
    assert np.count_nonzero(moved.velocities) == 1


def test_a_run_rings_in_a_mode() -> None:
    ring = REST.replace(ring=rw.Ring(mode=3, speed=0.25))
    simulation = rw.Simulation(scene(ring))
    shape = rw.modes(scene(), count=3).shapes[2].real
    speeds = np.linalg.norm(simulation.velocities, axis=1)
    assert speeds.max() == pytest.approx(0.25, rel=1e-12)
    np.testing.assert_allclose(simulation.velocities, 0.25 * shape, atol=1e-3)


@pytest.mark.parametrize("mode", [1, 2, 3, 4])
@pytest.mark.parametrize("friction", [0.0, 0.05])
def test_a_run_rings_in_the_mode_that_is_listed(mode: int, friction: float) -> None:
    # A taut string without weight: modes 1 and 2, 3 and 4 have equal frequencies in two planes.
    taut = Rope(
        segments=6, made_of=STUFF.replace(spring_friction=friction), shape=Straight(end=(3.3, 0, 0))
    )
    string = scene(REST.replace(ring=rw.Ring(mode=mode, speed=1.0)), gravity=(0, 0, 0))
    string = string.replace(ropes=(taut,))
    listed = rw.modes(string)
    assert listed.motions[mode - 1].name == ("in plane", "out of plane")[(mode - 1) % 2]
    shape = listed.shapes[mode - 1].real
    np.testing.assert_allclose(rw.Simulation(string).velocities, shape, atol=1e-9)
    other = listed.shapes[mode - 2 + 2 * (mode % 2)].real  # its twin in the other plane
    assert np.abs(rw.Simulation(string).velocities - other).max() > 0.9


def test_modes_that_do_not_settle_are_said(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("ropewalk.vibration.solve.DENSE", 0)
    monkeypatch.setattr("ropewalk.vibration.solve._DENSE_DAMPED", 0)
    long = Rope(segments=60, made_of=STUFF, shape=Straight(end=(33, 0, 0)))
    damped = scene().replace(ropes=(long,))
    still = damped.replace(ropes=(long.replace(made_of=STUFF.replace(spring_friction=0.0)),))
    for source in (damped, still):
        assert rw.modes(source, count=3).count == 3
    monkeypatch.setattr("ropewalk.vibration.solve._ROUNDS", 1)
    with pytest.raises(NoModes, match="did not settle in 1 rounds: they still change by"):
        rw.modes(still, count=3)
    monkeypatch.setattr("ropewalk.vibration.quadratic._CYCLES", 1)
    monkeypatch.setattr("ropewalk.vibration.quadratic._TRIES", 1)
    with pytest.raises(NoModes, match="were not found in 1 tries: too many are nearly alike"):
        rw.modes(damped, count=10)


def test_modes_that_are_missing_are_noticed(monkeypatch: pytest.MonkeyPatch) -> None:
    # With the slowest pair left out of what is found first, the count in the disk is two short.
    counted = []

    def count(linear: Linear, known: np.ndarray, radius: float, centre: float) -> int | None:
        counted.append(missing(linear, known if counted else known[2:], radius, centre))
        return counted[-1]

    monkeypatch.setattr("ropewalk.vibration.solve._DENSE_DAMPED", 0)
    rope = Rope(segments=60, made_of=STUFF, shape=Straight(end=(33, 0, 0)))
    sought = scene().replace(ropes=(rope,))
    whole = rw.modes(sought, count=3)
    monkeypatch.setattr("ropewalk.vibration.quadratic.missing", count)
    again = rw.modes(sought, count=3)
    assert counted == [2, 0]
    np.testing.assert_allclose(again.eigenvalues, whole.eigenvalues, rtol=1e-10)


def test_slack_ropes_have_no_modes_where_they_start() -> None:
    loose = Rope(
        segments=6, made_of=STUFF.replace(tension_only=True), shape=Straight(end=(3.0, 0, 0))
    )
    source = scene().replace(ropes=(loose,))
    with pytest.raises(rw.SceneError, match="where it starts all its segments are slack") as caught:
        rw.modes(source, about="start")
    assert str(caught.value).startswith('rope[0]: "rope" - has no modes')
    assert rw.modes(source).frequencies[0] > 0.1  # at rest it hangs


def test_a_resumed_run_that_started_at_rest_goes_on_to_the_same_bits(tmp_path: Path) -> None:
    ring = REST.replace(ring=rw.Ring(mode=1, speed=0.3), duration=0.4)
    whole = record_run(scene(ring), tmp_path / "whole")

    def stop(done: int, planned: int, block: object) -> None:
        if done >= 6:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        record_run(scene(ring), tmp_path / "cut", progress=stop, commit_seconds=0.0)
    resumed = resume_run(tmp_path / "cut")
    np.testing.assert_array_equal(resumed.positions, whole.positions)
    assert resumed.scene == whole.scene
    assert whole.scene.run.ring == rw.Ring(mode=1, speed=0.3)


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: rw.RunSettings(ring=rw.Ring(mode=1, speed=1.0)), 'ring: needs start = "at-rest"'),
        (lambda: rw.Ring(mode=0, speed=1.0), "mode: 0 - must be at least 1"),
        (lambda: rw.Ring(mode=1, speed=0.0), "speed: 0.0 - must be"),
        (lambda: rw.RunSettings(start="rest"), 'start: "rest" - must be'),
        (
            lambda: scene(velocity=(1, 0, 0)),
            'rope[0].shape.velocity: [1.0, 0.0, 0.0] - leave it out with run.start = "at-rest"',
        ),
        (
            lambda: rw.Simulation(scene(REST.replace(ring=rw.Ring(mode=99, speed=1.0)))),
            "run.ring.mode: 99 - must be at most 15",
        ),
        (
            lambda: rw.Simulation(scene(anchors=())),
            'rope[0]: "rope" - no anchor holds it, and there is no ground: it falls',
        ),
    ],
)
def test_starts_that_cannot_be(make, words: str) -> None:
    with pytest.raises(rw.SceneError) as caught:
        make()
    assert words in str(caught.value)


def test_a_mode_that_creeps_has_no_natural_frequency() -> None:
    """The sizes of its two rates over 2 pi stood there as two frequencies; without any damping it rings."""

    def one(friction: float) -> rw.Modes:
        weight = Springs(
            spring_constant=500.0, node_mass=0.05, segment_length=0.5, spring_friction=friction
        )
        drawn = Straight(end=(0.0, 0.0, -0.5))
        hangs = Scene(
            ropes=[Rope(segments=1, made_of=weight, shape=drawn)], anchors=[Anchor(node=0)]
        )
        return rw.modes(hangs, count=4)

    rings, creeps = one(0.0), one(50.0)
    own = np.sqrt(500.0 / 0.05) / (2.0 * np.pi)
    assert rings.natural_frequencies[-1] == pytest.approx(own)
    rates = creeps.decay_rates[creeps.eigenvalues.imag == 0.0] / (2.0 * np.pi)
    assert rates[-1] * rates[-2] == pytest.approx(
        own**2
    )  # those of its stretch, about the frequency
    np.testing.assert_array_equal(
        np.isnan(creeps.natural_frequencies), creeps.eigenvalues.imag == 0.0
    )
    assert np.isnan(creeps.table[-1]["natural frequency [Hz]"])
    assert not np.isnan(rings.natural_frequencies).any()


def test_modes_of_a_rope_that_is_folded_back_are_not_along_it() -> None:
    """A sling with both ends at one point, 5 kg in its middle: it swings as a pendulum, to both sides alike.

    At a node with its segments back to back the tangent was a billion times too long, and level.
    """
    line = rw.Material(EA=1e5, mass_per_length=0.1)
    points = [(0.0, 0.0, -0.25 * min(i, 8 - i)) for i in range(9)]
    sling = Rope(
        length=2.0, segments=8, made_of=line, loads=[rw.Load(node=4, mass=5.0)],
        shape=rw.scene.Points(points=points),
    )  # fmt: skip
    found = rw.modes(Scene(ropes=[sling], anchors=[Anchor(node=0), Anchor(node=-1)]), count=2)
    arm = float(found.positions[:, 2].min()) * -1.0
    slow = np.sqrt(9.81 / arm) / (2.0 * np.pi)
    assert found.frequencies == pytest.approx([slow, slow], rel=0.02)
    for motion in found.motions:
        assert motion.name == "sideways"
        assert motion.along < 1e-6
        assert motion.in_plane + motion.out_of_plane == pytest.approx(1.0)


def test_rounding_is_no_mode_that_grows() -> None:
    """Two anchors 1 m above the ground, and a rope that lies there with friction: it is free sideways."""
    line = rw.Material(EA=1e5, mass_per_length=0.5)
    rope = Rope(
        length=8.0, segments=20, made_of=line,
        shape=rw.scene.Slack(start=(0.0, 0.0, 1.0), end=(5.0, 0.0, 1.0)),
    )  # fmt: skip
    lies = Scene(ropes=[rope], anchors=[Anchor(node=0), Anchor(node=-1)], ground=rw.scene.Ground())
    found = rw.modes(lies, count=20)
    free = np.abs(found.eigenvalues) < 1e-9
    assert free.any()
    assert (found.eigenvalues[free] == 0.0).all()
    assert (found.eigenvalues.real <= 0.0).all()
    assert found.count == 20
    assert (found.eigenvalues.imag > 0.5).any()  # what hangs swings


def test_rounding_of_tensions_sets_no_rate() -> None:
    """Most nodes of a rope that lies there are held by rounding alone: the middle of that was the rate."""
    model = build(scene())
    tension = np.zeros(6)
    tension[0] = 10.0
    linear = linearise(model, model.state.x, tension)
    noisy = replace(linear, other=linear.other + 1e-16 * identity(linear.mass.size, format="csc"))
    assert np.count_nonzero(linear.other.diagonal()) < linear.mass.size / 2
    assert rate(noisy) == pytest.approx(rate(linear), rel=1e-12)
