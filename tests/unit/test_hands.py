"""Anchors and winches of a running simulation: what they tell, and how they are taken in hand."""

from __future__ import annotations

import math

import numpy as np
import pytest

from ropewalk.scene import Anchor, Material, Rope, RunSettings, Scene, Springs, Winch
from ropewalk.simulation import Simulation
from verification.setups import off

EA, MU = 500.0, 0.1
SEGMENT = 0.5


def wound(
    speed: float = 0.0, *, anchor: Anchor | None = None, duration: float = 1.0, **more
) -> Simulation:
    """A cord of 4 m that hangs from its winch, in steps of 1 ms."""
    cord = Material(EA=EA, mass_per_length=MU, axial_damping=2.0)
    return Simulation(
        Scene(
            ropes=[Rope(segments=8, length=4.0, made_of=cord, shape={"kind": "hanging"})],
            anchors=[anchor or Anchor(node=0)],
            winches=[Winch(name="hoist", end="start", speed=speed, **more)],
            run=RunSettings(
                duration=duration,
                frame_rate=100.0,
                time_step=1e-3,
                steps="exact",
                method="semi-implicit-euler",
            ),
        )
    )


def test_slips_of_names_are_told() -> None:
    simulation = wound()
    with pytest.raises(KeyError, match='no winch "hosit"; did you mean "hoist"'):
        simulation.winches["hosit"]
    with pytest.raises(KeyError, match='no anchor "left"; known: anchor0'):
        simulation.anchors["left"]
    with pytest.raises(KeyError, match='no obstacle "rock"; there is none'):
        simulation.obstacles["rock"]
    assert simulation.anchors.get("left") is None
    with pytest.raises(AttributeError):
        simulation.winches["hoist"].sped = 1.0
    with pytest.raises(AttributeError):
        simulation.anchors["anchor0"].postion = (0.0, 0.0, 1.0)


def test_a_winch_tells_how_it_is() -> None:
    """4 m out and 1.2 m on the drum, and rest tension of all that hangs below half a segment:
    (4 - 0.25) mu g; the twin pays out at 0.4 m/s for half a second.
    """
    still = wound(on_drum=1.2)
    winch = still.winches["hoist"]
    assert winch.length == pytest.approx(4.0, abs=1e-12)
    assert (winch.speed, winch.paid_out, winch.on_drum) == (0.0, 0.0, 1.2)
    assert winch.limits == (0.25, math.inf)
    assert winch.stopped_by == ""
    assert winch.tension == pytest.approx(0.0, abs=1e-12)  # at rest length to start with
    still.step(30.0)
    assert winch.tension == pytest.approx(3.75 * MU * 9.81, rel=1e-3)
    turning = wound(0.4)
    turning.step(0.5)
    assert turning.winches["hoist"].paid_out == pytest.approx(0.2, abs=1e-12)
    assert turning.winches["hoist"].length == pytest.approx(4.2, abs=1e-12)
    assert "turning at 0.4 m/s" in repr(turning.winches["hoist"])


def test_the_speed_of_a_winch_can_be_changed_while_it_turns() -> None:
    """L = L0 + sum of speed times time, to round-off (a merge's debt included); the scene's own
    interval no longer counts. The twin is the same run without a hand.
    """
    sim, twin = (wound(0.5, stop=0.2, on_drum=2.0, duration=2.0) for _ in range(2))
    winch = sim.winches["hoist"]
    for speed, seconds in [(0.8, 0.4), (0.0, 0.1), (-1.5, 0.7)]:
        winch.speed = speed
        assert winch.speed == speed
        sim.step(seconds)
    expected = 0.8 * 0.4 - 1.5 * 0.7
    assert winch.paid_out == pytest.approx(expected, abs=1e-12)
    assert winch.length == pytest.approx(4.0 + expected, abs=1e-11)
    twin.step(1.2)
    assert twin.winches["hoist"].paid_out == pytest.approx(0.1, abs=1e-12)


def test_a_hand_at_the_winch_is_part_of_the_state() -> None:
    """From the same snapshot the same bits, speed and interval included; the twin forgets the hand."""
    sim = wound(0.5, on_drum=3.0, duration=2.0)
    sim.step(0.1)
    sim.winches["hoist"].speed = -0.7
    before = sim.state
    sim.step(0.3)
    there, debt = sim.positions.copy(), sim.arrays.winch_debt.copy()
    sim.winches["hoist"].speed = 0.9
    sim.step(0.2)
    sim.restore(before)
    assert sim.winches["hoist"].speed == -0.7
    sim.step(0.3)
    np.testing.assert_array_equal(sim.positions, there)
    np.testing.assert_array_equal(sim.arrays.winch_debt, debt)
    forgets = wound(0.5, on_drum=3.0, duration=2.0)
    forgets.restore(before._replace(winch_drive=forgets.state.winch_drive))
    forgets.step(0.3)
    assert off(forgets.positions, there) > 1e-3


def test_one_simulations_hand_leaves_the_others_alone() -> None:
    """Two simulations of one built model share its tables, but not what a hand changes."""
    first = wound(0.5)
    second = Simulation(first.model)
    first.winches["hoist"].speed = 0.1
    assert second.winches["hoist"].speed == 0.5


@pytest.mark.parametrize(
    ("speed", "more", "why", "length"),
    [
        (1.0, {"on_drum": 0.3}, "empty drum", 4.3),
        (1.0, {"max_length": 4.2}, "max_length", 4.2),
        (-1.0, {"min_length": 3.6}, "min_length", 3.6),
        (-4.0, {}, "last segment", 0.25),
    ],
)
def test_a_winch_says_what_stopped_it(speed: float, more: dict, why: str, length: float) -> None:
    """The limits to round-off; told the other way it turns again. Twin: not stopped before that."""
    sim = wound(speed, duration=3.0, **more)
    winch = sim.winches["hoist"]
    sim.step(0.01)
    assert winch.stopped_by == ""
    sim.step(2.0)
    assert winch.stopped_by == why
    assert f"stopped ({why})" in repr(winch)
    assert winch.length == pytest.approx(length, abs=1e-9)
    winch.speed = -0.1 * speed
    assert winch.stopped_by == ""
    sim.step(0.1)
    assert winch.length == pytest.approx(length - 0.01 * speed, abs=1e-9)


def test_a_drum_without_a_length_holds_what_the_run_pays_out() -> None:
    """0.5 m/s for 1 s are 0.5 m: one segment, and one to spare. Beyond the run the drum runs empty,
    and the winch says so. A rope that is only reeled in has nothing more on its drum.
    """
    sim = wound(0.5)
    assert sim.winches["hoist"].on_drum == pytest.approx(2 * SEGMENT)
    for _ in sim.frames():
        pass
    assert sim.winches["hoist"].stopped_by == ""
    sim.step(3.0)
    assert sim.winches["hoist"].stopped_by == "empty drum"
    assert sim.winches["hoist"].length == pytest.approx(5.0, abs=1e-9)
    reeling = wound(-0.5)
    reeling.step(0.5)
    assert reeling.winches["hoist"].on_drum == pytest.approx(0.25)
    reeling.winches["hoist"].speed = 1.0
    reeling.step(1.0)
    assert reeling.winches["hoist"].stopped_by == "empty drum"
    assert reeling.winches["hoist"].length == pytest.approx(4.0, abs=1e-9)


def test_faults_at_the_winch() -> None:
    sim = wound(0.1, anchor=Anchor(node=0, release_time=0.2))
    winch = sim.winches["hoist"]
    for value in (math.nan, math.inf, "fast", None):
        with pytest.raises(ValueError, match="speed: .* - must be a finite number"):
            winch.speed = value
    with pytest.raises(ValueError, match=r"must be at most 100 m/s, a fifth of a segment a step"):
        winch.speed = -101.0
    assert winch.speed == 0.1
    sim.step(0.3)
    assert winch.stopped_by == "released"
    with pytest.raises(ValueError, match="has let go; the winch turns no more"):
        winch.speed = 0.2


def test_adaptive_steps_are_no_frames_at_a_winch() -> None:
    """It winds a fifth of a segment at most in a step of its own, however long a frame is."""
    scene = wound(0.1).scene
    steps = RunSettings(method="adaptive", duration=0.5, frame_rate=10.0)
    sim = Simulation(scene.replace(run=steps))
    sim.winches["hoist"].speed = -2.0  # 0.2 m of segments of 0.5 m in a frame
    sim.step(0.5)
    assert sim.winches["hoist"].length == pytest.approx(3.0, abs=1e-9)


def test_an_anchor_that_let_go_follows_its_node() -> None:
    """Free fall of one node: x = -g dt^2 s (s + 1) / 2 since the release. The twin still holds."""
    rope = Rope(segments=1, made_of=Springs(spring_constant=0.5, node_mass=1.0, segment_length=1.0))

    def after(release: float | None) -> Simulation:
        anchor = Anchor(name="hook", node=0, release_time=release)
        run = RunSettings(
            duration=1.0,
            frame_rate=100.0,
            time_step=1e-2,
            steps="exact",
            method="semi-implicit-euler",
        )
        sim = Simulation(Scene(ropes=[rope], anchors=[anchor, Anchor(name="far", node=1)], run=run))
        sim.step(0.3)
        return sim

    sim = after(0.1)
    hook = sim.anchors["hook"]
    assert not hook.holds
    np.testing.assert_array_equal(hook.position, sim.positions[0])
    np.testing.assert_array_equal(hook.velocity, sim.velocities[0])
    assert hook.position[2] == pytest.approx(-9.81e-4 * 20 * 21 / 2, rel=0.05)
    assert not hook.reaction.any()
    assert "released" in repr(hook)
    twin = after(None).anchors["hook"]
    assert twin.holds
    assert not twin.position.any()
    assert "released" not in repr(twin)


def test_frames_go_on_where_the_plan_stands() -> None:
    """After part of the plan only the rest is left; after all of it, nothing; a step of another
    length leaves part of a frame, which is made whole.
    """
    sim = wound()
    for part in (30, 25):
        assert sum(block.frames for block in sim.frames(part)) == part
    assert sum(block.frames for block in sim.frames()) == 45
    assert sim.time == sim.plan.duration
    assert list(sim.frames()) == []
    odd = wound()
    odd.step(0.0333)
    assert odd.frames_left == 97
    assert sum(block.frames for block in odd.frames()) == 97
    assert odd.time == pytest.approx(1.0033, abs=1e-12)


def test_a_duration_of_single_precision_leaves_the_clock_in_double() -> None:
    one, other = wound(), wound()
    one.step(np.float32(0.01))
    other.step(float(np.float32(0.01)))
    for simulation in (one, other):
        simulation.step(0.1)
    assert type(one.time) is float
    assert one.time == other.time
    np.testing.assert_array_equal(one.positions, other.positions)


def test_the_state_of_another_simulation_is_refused_before_anything_changes() -> None:
    simulation, twin = wound(), wound()
    simulation.step(0.1)
    twin.restore(simulation.state)
    np.testing.assert_array_equal(twin.positions, simulation.positions)
    other = Simulation(
        Scene(ropes=[Rope(segments=8, length=4.0, made_of=Material(EA=EA, mass_per_length=MU))],
              anchors=[Anchor(node=0)])
    )  # fmt: skip
    before = other.positions.copy()
    with pytest.raises(ValueError, match="9 nodes, 1 anchors and 0 winches"):
        other.restore(simulation.state)
    np.testing.assert_array_equal(other.positions, before)


def test_what_is_told_of_speed_and_step_of_a_winch_is_possible_to_the_last_bit() -> None:
    """Of 113.99999999999999 m/s "at most 114 m/s" was told, and 114 m/s refused; so it was of steps."""
    cord = wound().scene.replace(**{"rope.length": 8 * 0.57})
    winch = Simulation(cord).winches["hoist"]
    with pytest.raises(ValueError, match="must be at most 114 m/s"):
        winch.speed = 114.01
    winch.speed = -114.0
    assert winch.speed == -114.0
    fast = cord.replace(**{"winch.speed": 0.57 * 0.2 / 1e-3})
    assert Simulation(fast).plan.dt == 1e-3
