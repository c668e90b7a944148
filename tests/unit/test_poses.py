"""Anchors and clamps driven by where they are to be; forces and tensions as arrays; reset."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.scene import Hand, Slack, Straight

METHODS = ("semi-implicit-euler", "rk4", "esdirk3", "adaptive")
TICK = 0.02  # [s]


def held(method: str = "semi-implicit-euler", **more: Any) -> rw.Scene:
    """A slack rope between a robot's hand and a post."""
    line = rw.Material(EA=more.pop("EA", 2000.0), mass_per_length=0.1, axial_damping=2.0)
    rope = rw.Rope(segments=12, length=1.2, made_of=line, shape=Slack(end=(1.0, 0.0, 0.0)))
    anchors = [rw.Anchor(name="hand", node=0, motion=Hand()), rw.Anchor(name="post", node=-1)]
    return rw.Scene(ropes=[rope], anchors=anchors, run={"method": method}, **more)


def clamped(method: str = "esdirk3") -> rw.Scene:
    """A springy rod in a robot's gripper."""
    rod = rw.Material(
        EA=1e4, mass_per_length=0.05, EI=0.02, axial_damping=1.0, bending_damping=1e-3
    )
    rope = rw.Rope(segments=10, length=0.5, made_of=rod, shape=Straight(end=(0.5, 0.0, 0.0)))
    clamp = rw.Clamp(direction=(1.0, 0.0, 0.0))
    anchor = rw.Anchor(name="hand", node=0, motion=Hand(), clamp=clamp)
    return rw.Scene(ropes=[rope], anchors=[anchor], run={"method": method})


def test_no_frames_keep_a_goal() -> None:
    """They divided its way by no time at all."""
    sim = rw.Simulation(held())
    goal = np.array([0.0, 0.0, 0.01])
    sim.anchors["hand"].move_to(goal)
    with np.errstate(all="raise"):
        sim.advance_frames(0)
    np.testing.assert_array_equal(sim.anchors["hand"].velocity, 0.0)
    sim.advance_frames(1)
    np.testing.assert_array_equal(sim.positions[0], goal)


def path(time: float) -> np.ndarray[Any, np.dtype[np.float64]]:
    return np.array([0.1 * np.sin(5.0 * time), 0.03 * time, 0.2 * (1.0 - np.cos(4.0 * time))])


@pytest.mark.parametrize("method", METHODS)
def test_an_anchor_is_where_it_was_told_to_be_to_the_last_bit(method: str) -> None:
    sim = rw.Simulation(held(method))
    hand = sim.anchors["hand"]
    for tick in range(1, 26):
        goal = path(tick * TICK) + 0.1  # no round number in binary
        before = hand.position
        hand.move_to(goal)
        sim.step(TICK)
        np.testing.assert_array_equal(hand.position, goal)
        np.testing.assert_array_equal(sim.positions[0], goal)
        np.testing.assert_allclose(sim.velocities[0], (goal - before) / TICK, rtol=1e-9, atol=1e-12)
        np.testing.assert_array_equal(hand.velocity, 0.0)
    there = hand.position
    sim.step(0.1)  # told nothing, it rests
    np.testing.assert_array_equal(hand.position, there)
    np.testing.assert_array_equal(sim.velocities[0], 0.0)


def test_a_hand_comes_to_the_origin_exactly() -> None:
    """What rounding may be was a share of the goal, which is nothing at the origin: -4.7e-17 m."""
    sim = rw.Simulation(held("verlet"))
    hand = sim.anchors["hand"]
    for k in range(1, 20):
        hand.move_to((0.1 * k, -0.07 * k, 0.03))
        sim.step(TICK)
        hand.move_to((0.0, 0.0, 0.0))
        sim.step(TICK)
        np.testing.assert_array_equal(hand.position, 0.0)


def test_a_pose_is_the_velocity_that_leads_there() -> None:
    """To rounding it is the same motion, books of the work included."""
    posed, pushed = rw.Simulation(held()), rw.Simulation(held())
    place = pushed.anchors["hand"].position
    for tick in range(1, 26):
        goal = path(tick * TICK)
        posed.anchors["hand"].move_to(goal)
        pushed.anchors["hand"].velocity = (goal - place) / TICK
        place = goal
        posed.step(TICK)
        pushed.step(TICK)
    np.testing.assert_allclose(posed.positions, pushed.positions, rtol=0.0, atol=1e-11)
    energy = posed.recording().recording
    work = np.asarray(energy.work[0])
    np.testing.assert_allclose(work, pushed.recording().recording.work[0], rtol=1e-8, atol=1e-9)
    assert work[-2] != 0.0  # the hand did work


def test_poses_converge_to_the_motion_they_are_taken_from() -> None:
    """A hand told its place at every tick follows its path; halved ticks err by a quarter or less."""

    def end(tick: float) -> np.ndarray[Any, Any]:
        scene = held("rk4").replace(**{"run.time_step": 2.5e-4})
        sim = rw.Simulation(scene)
        for k in range(1, round(0.4 / tick) + 1):
            sim.anchors["hand"].move_to(path(k * tick))
            sim.step(tick)
        return sim.positions.copy()

    exact = end(0.0005)
    errors = [float(np.abs(end(tick) - exact).max()) for tick in (0.02, 0.01, 0.005)]
    assert errors[1] < 0.6 * errors[0]
    assert errors[2] < 0.6 * errors[1]


def test_rigid_links_follow_a_pose() -> None:
    sim = rw.Simulation(held("esdirk3", EA=float("inf")))
    for tick in range(1, 11):
        sim.anchors["hand"].move_to(path(tick * TICK))
        sim.step(TICK)
    np.testing.assert_array_equal(sim.positions[0], path(10 * TICK))
    lengths = np.linalg.norm(np.diff(sim.positions, axis=0), axis=1)
    np.testing.assert_allclose(lengths, 0.1, rtol=1e-9)


@pytest.mark.parametrize("method", ["verlet", "esdirk3", "adaptive"])
def test_a_clamp_points_where_it_was_told_to(method: str) -> None:
    sim = rw.Simulation(clamped(method))
    hand = sim.anchors["hand"]
    np.testing.assert_array_equal(hand.direction, (1.0, 0.0, 0.0))
    for tick in range(1, 11):
        angle = 0.06 * tick
        goal = np.array([np.cos(angle), 0.0, np.sin(angle)])
        hand.turn_to(3.0 * goal)
        hand.move_to((0.0, 0.001 * tick, 0.0))
        sim.step(TICK)
        np.testing.assert_allclose(hand.direction, goal, rtol=0.0, atol=1e-15)
        np.testing.assert_array_equal(hand.position, (0.0, 0.001 * tick, 0.0))
        np.testing.assert_array_equal(hand.angular_velocity, 0.0)
    before = hand.direction
    sim.step(0.1)
    np.testing.assert_array_equal(hand.direction, before)
    assert np.linalg.norm(hand.moment) > 0.0


def test_a_turn_by_pose_is_a_turn_by_rate_and_the_scenes_own() -> None:
    """The same quarter turn three ways: told every tick, as an angular velocity, in the scene."""
    rate, ticks = 0.8, 20
    posed, spun = rw.Simulation(clamped()), rw.Simulation(clamped())
    turning = clamped().replace(
        **{"anchor.clamp.turn_axis": (0.0, -1.0, 0.0), "anchor.clamp.turn_rate": rate}
    )
    own = rw.Simulation(turning)
    spun.anchors["hand"].angular_velocity = (0.0, -rate, 0.0)
    for tick in range(1, ticks + 1):
        angle = rate * tick * TICK
        posed.anchors["hand"].turn_to((np.cos(angle), 0.0, np.sin(angle)))
        for sim in (posed, spun, own):
            sim.step(TICK)
    np.testing.assert_allclose(spun.positions, own.positions, rtol=0.0, atol=1e-12)
    np.testing.assert_allclose(posed.positions, own.positions, rtol=0.0, atol=1e-9)
    np.testing.assert_allclose(spun.anchors["hand"].angular_velocity, (0.0, -rate, 0.0))
    ledger = [float(sim.arrays.work.clamps[0]) for sim in (posed, spun, own)]
    np.testing.assert_allclose(ledger, ledger[2], rtol=1e-6)
    assert ledger[2] != 0.0


def test_snapshots_know_how_clamps_turn() -> None:
    sim = rw.Simulation(clamped())
    before = sim.state
    sim.anchors["hand"].angular_velocity = (0.0, 0.0, 2.0)
    sim.step(0.05)
    middle = sim.state
    sim.step(0.05)
    there = sim.positions.copy()
    sim.restore(before)
    sim.step(0.05)
    np.testing.assert_array_equal(sim.anchors["hand"].direction, (1.0, 0.0, 0.0))
    sim.restore(middle)
    sim.step(0.05)
    np.testing.assert_array_equal(sim.positions, there)


def test_the_last_word_counts() -> None:
    sim = rw.Simulation(held())
    hand = sim.anchors["hand"]
    hand.move_to((0.5, 0.0, 0.0))
    hand.move_to((0.0, 0.1, 0.0))
    sim.step(TICK)
    np.testing.assert_array_equal(hand.position, (0.0, 0.1, 0.0))
    hand.move_to((0.5, 0.0, 0.0))
    hand.velocity = (0.0, 0.0, 0.0)
    sim.step(TICK)
    np.testing.assert_array_equal(hand.position, (0.0, 0.1, 0.0))
    hand.move_to((0.5, 0.0, 0.0))
    sim.reset()
    sim.step(TICK)
    np.testing.assert_array_equal(hand.position, 0.0)


def test_blocks_of_frames_reach_a_pose_at_their_end() -> None:
    sim = rw.Simulation(held())
    sim.anchors["hand"].move_to((0.0, 0.0, 0.03))
    (block,) = sim.frames(3)
    heights = block.recording.x[:, 2, 0]
    np.testing.assert_allclose(heights, (0.01, 0.02, 0.03), rtol=1e-12)
    np.testing.assert_array_equal(sim.anchors["hand"].position, (0.0, 0.0, 0.03))


def test_a_ground_that_stops_an_anchor_keeps_it_up() -> None:
    ground = rw.Ground(height=-0.1)
    scene = held(ground=ground).replace(**{"anchor.hand.above_ground": True})
    sim = rw.Simulation(scene)
    sim.anchors["hand"].move_to((0.0, 0.0, -0.3))
    sim.step(TICK)
    np.testing.assert_allclose(sim.anchors["hand"].position, (0.0, 0.0, -0.1), atol=1e-12)


def test_wrong_poses_are_refused() -> None:
    sim, bare = rw.Simulation(clamped()), rw.Simulation(held())
    hand = sim.anchors["hand"]
    for wrong in ((1.0, 2.0), (0.0, 0.0, np.nan), "there", None):
        with pytest.raises(ValueError, match="position: .* three finite numbers"):
            hand.move_to(wrong)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="must not be zero"):
        hand.turn_to((0.0, 0.0, 0.0))
    with pytest.raises(ValueError, match="opposite .* two steps"):
        hand.turn_to((-1.0, 0.0, 0.0))
    with pytest.raises(ValueError, match="give it a clamp"):
        bare.anchors["hand"].turn_to((1.0, 0.0, 0.0))
    with pytest.raises(ValueError, match="give it a clamp"):
        bare.anchors["hand"].angular_velocity = (1.0, 0.0, 0.0)
    released = rw.Simulation(held().replace(**{"anchor.hand.release_time": 0.01}))
    released.anchors["hand"].move_to((0.0, 0.0, 0.1))
    released.step(TICK)
    with pytest.raises(ValueError, match="has let go"):
        released.anchors["hand"].move_to((0.0, 0.0, 0.0))


def test_forces_as_one_array_are_single_ones() -> None:
    one, all_at_once = rw.Simulation(held()), rw.Simulation(held())
    forces = np.zeros((13, 3))
    forces[5], forces[7] = (0.0, 2.0, 0.0), (1.0, 0.0, 3.0)
    for node in (5, 7):
        one.apply_force(node, forces[node])
    all_at_once.applied_forces = forces
    np.testing.assert_array_equal(all_at_once.applied_forces, forces)
    for sim in (one, all_at_once):
        sim.step(0.1)
    np.testing.assert_array_equal(one.positions, all_at_once.positions)
    free = rw.Simulation(held())
    free.step(0.1)
    assert np.abs(free.positions - one.positions).max() > 1e-3
    with pytest.raises(ValueError, match=r"must be \(13, 3\)"):
        one.applied_forces = np.zeros((3, 13))
    forces[4, 1] = np.inf
    with pytest.raises(ValueError, match=r"applied_forces\[4\]"):
        one.applied_forces = forces


def test_tension_and_reactions_are_those_of_a_result() -> None:
    scene = held().replace(**{"run.duration": 0.2})
    result, sim = rw.simulate(scene), rw.Simulation(scene)
    for _ in range(result.frames - 1):
        sim.step()
    np.testing.assert_array_equal(sim.tension, result.tension[-1])
    np.testing.assert_array_equal(sim.reactions, result.reactions[-1])
    assert sim.tension.shape == (12,)
    assert sim.tension.max() > 0.1


@pytest.mark.parametrize("method", ["verlet", "esdirk3", "adaptive"])
def test_reset_is_a_new_simulation(method: str) -> None:
    sim, new = rw.Simulation(held(method)), rw.Simulation(held(method))
    sim.anchors["hand"].move_to((0.0, 0.0, 0.2))
    sim.apply_force(5, (0.0, 1.0, 0.0))
    sim.step(0.3)
    sim.reset()
    assert sim.time == 0.0
    for one in (sim, new):
        one.step(0.3)
    np.testing.assert_array_equal(sim.positions, new.positions)
    np.testing.assert_array_equal(sim.tension, new.tension)
