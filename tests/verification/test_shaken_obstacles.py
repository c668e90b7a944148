"""What shakes or goes round takes enough steps a swing, or is refused or told of; see `lowering.swings`.

A table that shakes along itself far quicker than friction accelerates a rope leaves that where it is, and
takes mu m g over 4 amplitudes a swing. Steps that see other places of it carry the rope away.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.analysis.check import check
from ropewalk.lowering import build
from ropewalk.lowering.swings import FEW, STEPS, period_of, swinging_step
from ropewalk.motions.tabulated import cubic_rows
from ropewalk.record.note_kinds import kinds
from ropewalk.scene import (
    Anchor,
    Cylinder,
    Fixed,
    Material,
    Motion,
    Orbit,
    Plane,
    Rope,
    RunSettings,
    Scene,
    SceneError,
    Shake,
    Sphere,
    Spin,
    Straight,
    Table,
    Velocity,
    Winch,
)

g, MU, MASS, WIDTH = 9.81, 0.3, 0.1, 0.02
ALONG, ACROSS = (1.0, 0.0, 0.0), (0.0, 0.0, 1.0)


def on_table(
    motion: Motion, *, low: float = 0.0, compliance: float | None = None, **run: Any
) -> Scene:
    """A rope of 1 m on a table that moves, or `low` [m] above it."""
    made = Material(EA=1e4, mass_per_length=MASS, axial_damping=5.0)
    shape = Straight(start=(-0.5, 0.0, 0.005), end=(0.5, 0.0, 0.005))
    rope = Rope(segments=20, length=1.0, diameter=0.01, made_of=made, shape=shape)
    table = Plane(point=(0, 0, -low), friction=MU, motion=motion, compliance=compliance)
    settings = {"duration": 0.5, "frame_rate": 60.0, "method": "esdirk3"} | run
    return Scene(ropes=[rope], obstacles=[table], run=RunSettings(**settings))


def shaken(frequency: float, axis: tuple[float, float, float] = ALONG, **more: Any) -> Scene:
    """The same on one that shakes by WIDTH."""
    return on_table(Shake(axis=axis, amplitude=WIDTH, frequency=frequency), **more)


def held(motion: Motion, **run: Any) -> Scene:
    """A rope that an anchor moves."""
    made = Material(EA=1e4, mass_per_length=MASS, axial_damping=5.0)
    shape = Straight(start=(0.0, 0.0, 0.0), end=(0.0, 0.0, -1.0))
    rope = Rope(segments=10, length=1.0, diameter=0.01, made_of=made, shape=shape)
    settings = {"duration": 0.5, "frame_rate": 60.0, "method": "esdirk3"} | run
    return Scene(ropes=[rope], anchors=[Anchor(node=0, motion=motion)], run=RunSettings(**settings))


def by_table(place: Callable[[Any], Any], times: Any, interpolation: Any = "cubic") -> Table:
    """A motion along x whose places are a function of the time."""
    places = [(float(x), 0.0, 0.0) for x in place(np.asarray(times))]
    return Table(times=tuple(map(float, times)), positions=places, interpolation=interpolation)


def warned(scene: Scene) -> list[str]:
    return [text for text in check(scene, measure=False).warnings if "swings in" in text]


@pytest.mark.parametrize("method", ["implicit-euler", "bdf2", "esdirk3", "auto", "adaptive"])
@pytest.mark.parametrize("frequency", [30.0, 60.0])
def test_a_rope_stays_on_a_table_that_shakes_quickly(method: str, frequency: float) -> None:
    scene = shaken(frequency, method=method)
    result = rw.simulate(scene)
    rubbed = float(np.ravel(result.contact_work["obstacle0"]["friction"])[-1])
    swings = frequency * scene.run.duration
    assert rubbed == pytest.approx(-MU * MASS * g * 4.0 * WIDTH * swings, rel=0.03)
    assert abs(result.positions[-1, :, 0].mean()) < 0.25 * WIDTH
    assert warned(scene) == []


@pytest.mark.parametrize("make", [on_table, held])
def test_automatic_steps_follow_a_swing(make: Callable[..., Scene]) -> None:
    motion = Shake(axis=ALONG, amplitude=WIDTH, frequency=60.0)
    for method in ("implicit-euler", "esdirk3", "auto"):
        assert build(make(motion, method=method)).plan.dt <= 1.0 / (60.0 * STEPS) * (1.0 + 1e-9)
    longest = build(make(motion, method="adaptive")).plan.longest
    assert longest is not None
    assert longest <= 1.0 / (60.0 * FEW) * (1.0 + 1e-9)
    slow = Shake(axis=ALONG, amplitude=WIDTH, frequency=0.5)
    assert build(make(slow, method="esdirk3")).plan.dt == 1.0 / 60.0


@pytest.mark.parametrize(
    ("make", "path"), [(on_table, "obstacle[0]"), (held, "anchor[0]")], ids=["table", "anchor"]
)
@pytest.mark.parametrize("method", ["esdirk3", "adaptive"])
def test_a_swing_in_less_than_four_steps_is_refused(
    make: Callable[..., Scene], path: str, method: str
) -> None:
    turning = Orbit(center=(0.1, 0.0, 0.0), axis=ACROSS, frequency=-60.0)
    swinging = Shake(axis=ALONG, amplitude=WIDTH, frequency=60.0)
    for motion in (swinging, turning):
        with pytest.raises(SceneError) as caught:
            build(make(motion, method=method, time_step=1.0 / 180.0))
        (fault,) = caught.value.faults
        assert fault.path == f"{path}.motion.frequency"
        assert fault.value == f"{motion.frequency:g} Hz"
        assert "in 3 steps of 5.556 ms" in fault.rule
        assert "of at most 0.000416 s" in fault.rule


def test_a_swing_in_few_steps_is_told_of() -> None:
    (said,) = warned(shaken(60.0, time_step=1.0 / 600.0))
    assert said.startswith(
        "obstacle[0].motion.frequency: 60 Hz - obstacle 'obstacle0' swings in 16.67 ms"
    )
    assert "in 10 steps" in said
    assert "of at most 0.000416 s" in said
    (of_anchor,) = warned(
        held(Shake(axis=ALONG, amplitude=WIDTH, frequency=60.0), time_step=1.0 / 600.0)
    )
    assert of_anchor.startswith("anchor[0].motion.frequency: 60 Hz - anchor")
    assert warned(shaken(60.0, time_step=1.0 / 1200.0)) == []
    assert warned(shaken(60.0, method="adaptive", time_step=1.0 / 480.0)) == []
    assert len(warned(shaken(60.0, method="adaptive", time_step=1.0 / 400.0))) == 1


def test_a_sweep_counts_runs_with_few_steps_a_swing() -> None:
    assert "few steps a swing" in kinds(
        rw.simulate(shaken(60.0, time_step=1.0 / 600.0, duration=0.1))
    )
    assert "few steps a swing" not in kinds(rw.simulate(shaken(60.0, duration=0.1)))


def test_what_swings_by_a_table_of_places_or_angles_is_followed_as_well() -> None:
    times = np.linspace(0.0, 0.5, 501)
    motion = by_table(lambda t: WIDTH * np.sin(2.0 * math.pi * 60.0 * t), times)
    for scene in (on_table(motion), held(motion)):
        assert build(scene).plan.dt == pytest.approx(1.0 / (60.0 * STEPS), rel=0.06)
    (said,) = warned(on_table(motion, time_step=1.0 / 240.0))
    assert said.startswith("obstacle[0].motion: its table - ")
    angles = tuple(0.5 * np.sin(2.0 * math.pi * 60.0 * times))
    spin = Spin(times=tuple(times), angles=angles, interpolation="cubic")
    drum = Cylinder(start=(0, -1, -1), end=(0, 1, -1), radius=0.1, spin=spin)
    scene = on_table(motion).model_copy(update={"obstacles": (drum,)})
    assert swinging_step(scene, 0.5) == pytest.approx(1.0 / (60.0 * STEPS), rel=0.06)
    (said,) = warned(scene.replace(**{"run.time_step": 1.0 / 240.0}))
    assert said.startswith("obstacle[0].spin: its table - ")


def test_the_period_of_a_table_is_that_of_what_swings_in_it() -> None:
    def found(
        place: Callable[[Any], Any], count: int, end: float, until: float = math.inf
    ) -> float:
        return period_of(cubic_rows(by_table(place, np.linspace(0.0, end, count))), until)

    for rows in (61, 241, 2001):
        assert found(lambda t: np.sin(2.0 * math.pi * 5.0 * t), rows, 2.0) == pytest.approx(
            0.2, rel=0.06
        )
    # A shake in the middle of a long way, or one that the run does not see.
    both = lambda t: t + np.where(t > 5.0, 0.02 * np.sin(2.0 * math.pi * 20.0 * t), 0.0)  # noqa: E731
    assert 0.03 < found(both, 2001, 10.0) < 0.06
    assert found(both, 2001, 10.0, until=4.0) > 1.0
    # What gains speed evenly needs no steps; a way from rest to rest is half a swing and more.
    assert found(lambda t: t * t, 41, 1.0) > 10.0
    assert 1.0 < found(lambda t: t**3 * (10.0 - 15.0 * t + 6.0 * t * t), 41, 1.0) < 2.0
    corners = by_table(lambda t: np.abs(np.sin(40.0 * t)), np.linspace(0.0, 1.0, 101), "linear")
    assert period_of(cubic_rows(corners), math.inf) == math.inf  # steps are cut at each


def test_what_takes_no_steps_is_not_refused_for_them() -> None:
    shake = Shake(axis=ALONG, amplitude=WIDTH, frequency=30.0)
    still, scene = (
        held(Shake(axis=ALONG, amplitude=WIDTH, frequency=0.1)),
        held(shake, time_step=1.0 / 60.0),
    )
    assert np.array_equal(rw.equilibrium(scene).positions, rw.equilibrium(still).positions)
    assert np.array_equal(rw.modes(scene).frequencies, rw.modes(still).frequencies)
    for stepping in (rw.simulate, rw.Simulation, check):
        with pytest.raises(SceneError, match="they see another motion"):
            stepping(scene)


def test_an_anchor_counts_while_it_holds() -> None:
    """What an anchor would make after it let go asks for no steps: a table's quick end, or all of a shake."""
    times = np.concatenate([np.linspace(0.0, 0.4, 41), 0.4 + 1e-4 * np.arange(1, 501)])
    noise = by_table(
        lambda t: np.where(t > 0.4, 1e-4 * np.sin(3e4 * t), 1.0 - np.cos(2.0 * t)), times
    )
    scene = held(noise)

    def until(time: float | None, motion: Motion = noise) -> Scene:
        return scene.replace(anchors=[Anchor(node=0, motion=motion, release_time=time)])

    assert swinging_step(until(None), 0.5) < 2e-5
    assert swinging_step(until(0.45), 0.5) < 2e-5
    assert swinging_step(until(0.4), 0.5) > 5e-4
    shake = Shake(axis=ALONG, amplitude=WIDTH, frequency=500.0)
    assert swinging_step(until(1e-3, shake), 0.5) == pytest.approx(1.0 / STEPS / 500.0)
    assert swinging_step(until(0.0, shake), 0.5) == math.inf
    assert build(until(0.4)).plan.dt > 1e-4
    assert warned(until(0.4)) == []
    assert warned(until(0.45).replace(run=scene.run.replace(time_step=1e-3))) != []


def past() -> Scene:
    """A rope past which a ball flies that jumps over nodes."""
    ball = Sphere(
        center=(5.0, 0, 0), radius=0.1, motion=Velocity(velocity=(900.0, 0, 0), start=0.1)
    )
    return held(Fixed(), time_step=1.0 / 60.0).replace(obstacles=[ball])


def turned() -> Scene:
    """A rope beside a drum that makes a turn in a step."""
    far = Cylinder(start=(5.0, 0, 0), end=(5.0, 1, 0), radius=0.1, spin=Spin(rate=2.0e3))
    return held(Fixed(), time_step=1.0 / 60.0).replace(obstacles=[far])


def let_go() -> Scene:
    """A rope whose anchor lets go within what has come over it by then."""
    ball = Sphere(center=(0, 0, 5.0), radius=0.3, motion=Velocity(velocity=(0, 0, -10.0)))
    made = held(Fixed(), time_step=1e-3)
    return made.replace(anchors=[Anchor(node=0, release_time=0.48)], obstacles=[ball])


def wound() -> Scene:
    """A rope that a winch winds by more than a segment a step."""
    made = held(Fixed(), time_step=1.0 / 60.0)
    return made.replace(winches=[Winch(end="start", speed=9.0, start=0.1)])


@pytest.mark.parametrize(
    ("made", "rule"),
    [
        (past, "would jump over nodes"),
        (turned, "would point backwards"),
        (let_go, "lets go"),
        (wound, "may wind a fifth"),
    ],
)
def test_what_steps_are_refused_for_is_no_matter_to_a_rest(
    made: Callable[[], Scene], rule: str
) -> None:
    """A shape of rest, its modes, and a sweep of rests are not refused for how long steps are."""
    scene = made()
    plain = scene.replace(
        obstacles=[], winches=[], anchors=[a.replace(release_time=None) for a in scene.anchors]
    )
    rest = rw.equilibrium(plain).positions[:, -11:]  # of what is wound, too, without its drum
    assert np.allclose(rw.equilibrium(scene).positions[:, -11:], rest, rtol=0.0, atol=1e-9)
    assert rw.modes(scene).frequencies == pytest.approx(rw.modes(plain).frequencies, rel=1e-6)
    kept = rw.sweep(scene, {"rope.length": [1.0, 1.1]}, keep=["sag"], what="rest", progress=False)
    assert list(kept.status.values) == ["at rest", "at rest"]
    with pytest.raises(SceneError, match=rule):
        build(scene)


@pytest.mark.parametrize("width", [1e-2, 1e-5, 1e-9])
def test_a_short_burst_in_a_long_quiet_table_is_looked_at_alone(width: float) -> None:
    """As many samples as the burst's steps make of the whole table were asked for, beyond all memory.

    Two strokes of a triangle and their rounded ends: their period is of four to five rows, whatever a row is.
    """
    times = (0.0, 50.0, *(50.0 + width * np.arange(1, 5)), 100.0)
    places = [(width * one, 0.0, 0.0) for one in (0, 0, 1, 0, 1, 0, 0)]
    burst = Table(times=times, positions=places, interpolation="cubic")
    assert 4.0 * width < period_of(cubic_rows(burst), math.inf) < 5.0 * width


def test_contacts_that_brake_farther_ahead_than_a_body_swings_are_told_of() -> None:
    """A plane that never comes nearer than 0.6 m does not throw a rope, with the compliance asked for."""

    def told(scene: Scene) -> list[str]:
        return [text for text in check(scene, measure=False).warnings if "ahead" in text]

    far = Shake(axis=ACROSS, amplitude=0.5, frequency=500.0)
    (said,) = told(on_table(far, low=1.1, duration=0.1))
    assert said.startswith("obstacle[0].motion.frequency: 500 Hz - ")
    firm = float(said.split("at most ")[1].split(" ")[0])
    scene = on_table(far, low=1.1, duration=0.1, compliance=firm)
    assert told(scene) == []
    heights = rw.simulate(scene).positions[-1, :, 2]
    assert heights == pytest.approx(0.005 - 0.5 * g * 0.1**2, abs=1e-4)
    assert told(shaken(60.0)) == []  # along itself it comes at nothing
    assert told(shaken(12.0, ACROSS)) == []
