"""Obstacles moved and turned from Python, while a simulation runs."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.scene import Box, Cylinder, Material, Plane, Scene, Straight
from ropewalk.scene.motions import Velocity
from ropewalk.words.safe_side import rounded_down

WAY, BEGIN, END = np.array([0.3, 0.0, 0.2]), 0.1, 0.3
STEP = 1.0 / 240.0


def on_a_table(method: str = "implicit-euler", ropes: int = 1, **more: Any) -> Scene:
    """Ropes that lie on a table beside each other, above a drum far below."""
    made_of = Material(EA=1e3, mass_per_length=0.1, axial_damping=1.0)
    lying = [
        rw.Rope(
            name=f"rope{k}",
            segments=8,
            length=0.6,
            diameter=0.02,
            made_of=made_of,
            shape=Straight(start=(-0.3, 0.1 * k, 0.1), end=(0.3, 0.1 * k, 0.1)),
        )
        for k in range(ropes)
    ]
    table = Box(
        name="table", center=(0, 0, 0), half_sizes=(0.6, 0.4, 0.09), edge_radius=0.02, friction=0.5,
        **more,
    )  # fmt: skip
    drum = Cylinder(name="drum", start=(0, -1, -5), end=(0, 1, -5), radius=0.5)
    pulley = Cylinder(
        name="pulley", start=(0, -1, -9), end=(0, 1, -9), radius=0.5, spin={"free": True, "inertia": 1.0}
    )  # fmt: skip
    bodies = [table, drum, pulley] if ropes == 1 else [table, drum]
    run = rw.RunSettings(method=method, time_step=STEP, duration=0.5)
    return Scene(ropes=lying, obstacles=bodies, run=run)


def steps(simulation: rw.Simulation, seconds: float) -> None:
    simulation.advance_steps(round(seconds / simulation.plan.dt))


def led(method: str, ropes: int = 1) -> rw.Simulation:
    """A table that a hand lifts and draws aside."""
    simulation = rw.Simulation(on_a_table(method, ropes))
    steps(simulation, BEGIN)
    simulation.obstacles["table"].move_to((END - BEGIN) * WAY, END - BEGIN)
    steps(simulation, 0.2 + END - BEGIN)
    return simulation


@pytest.mark.parametrize(("method", "ropes"), [("implicit-euler", 1), ("implicit-euler", 2)])
def test_a_hand_moves_it_as_the_scene_would(method: str, ropes: int) -> None:
    """The same motion by hand and in the scene: the same places, works and forces, in every island."""
    motion = Velocity(velocity=tuple(WAY), start=BEGIN, stop=END)
    told = rw.Simulation(on_a_table(method, ropes, motion=motion))
    steps(told, 0.2 + END)
    hand, still = led(method, ropes), rw.Simulation(on_a_table(method, ropes))
    steps(still, 0.2 + END)
    assert np.abs(hand.positions - told.positions).max() < 1e-10
    works = [one.arrays.work.node.obstacle.sum() for one in (hand, told)]
    assert works[0] == pytest.approx(works[1], rel=1e-9)
    lifted = 0.06 * ropes * 9.81 * 0.04
    assert works[0] == pytest.approx(lifted, rel=0.2)  # and what friction drew along
    assert hand.obstacles["table"].position == pytest.approx(0.2 * WAY, abs=1e-12)
    assert hand.obstacles["table"].velocity == pytest.approx(np.zeros(3))
    # The twin: where nobody moves the table, the rope stays.
    assert np.abs(hand.positions - still.positions).max() > 0.03


def test_velocity_and_rate_hold_until_told_otherwise() -> None:
    simulation = rw.Simulation(on_a_table())
    table, drum = simulation.obstacles["table"], simulation.obstacles["drum"]
    table.velocity, drum.rate = (0.0, 0.0, 0.1), 2.0
    steps(simulation, 0.2)
    assert table.position == pytest.approx([0.0, 0.0, 0.02])
    assert (drum.angle, drum.rate) == pytest.approx((0.4, 2.0))
    table.velocity = (0.0, 0.0, 0.0)
    drum.turn_to(0.0, 0.1)
    steps(simulation, 0.2)
    assert table.position == pytest.approx([0.0, 0.0, 0.02])
    assert (drum.angle, drum.rate) == pytest.approx((0.0, 0.0), abs=1e-12)


@pytest.mark.parametrize("parts", [1.0, 10.37, 33.3])
def test_it_arrives_with_the_step_that_is_as_long(parts: float) -> None:
    """Cut anew into equal steps, shorter than those that went before, as an anchor does."""
    simulation = rw.Simulation(on_a_table())
    steps(simulation, 0.05)
    table, drum, seconds = (*map(simulation.obstacles.get, ("table", "drum")), parts * STEP)
    assert table is not None
    assert drum is not None
    table.move_to((0.0, 0.0, 0.002), seconds)
    drum.turn_to(0.3, seconds)
    simulation.step(seconds)
    assert table.position == pytest.approx([0.0, 0.0, 0.002], abs=1e-12)
    assert drum.angle == pytest.approx(0.3, abs=1e-12)
    simulation.step(0.37 * STEP)
    assert table.velocity == pytest.approx(np.zeros(3))
    assert (drum.angle, drum.rate) == pytest.approx((0.3, 0.0), abs=1e-12)


@pytest.mark.parametrize("parts", [10.37, 33.3])
def test_a_stop_within_a_step_gives_no_other_work(parts: float) -> None:
    works = []
    for count in (parts, np.ceil(parts)):
        simulation = rw.Simulation(on_a_table())
        simulation.obstacles["table"].move_to((0.0, 0.0, 0.02), count * STEP)
        steps(simulation, 60 * STEP)
        assert simulation.obstacles["table"].position == pytest.approx([0.0, 0.0, 0.02], abs=1e-12)
        works.append(simulation.arrays.work.node.obstacle.sum())
    assert works[0] == pytest.approx(works[1], rel=1e-6)


def test_going_back_takes_the_hand_off() -> None:
    simulation = led("implicit-euler")
    moment = simulation.state
    steps(simulation, 0.1)
    after = simulation.positions.copy()
    simulation.reset()
    assert simulation.obstacles["table"].position == pytest.approx(np.zeros(3))
    simulation.restore(moment)
    steps(simulation, 0.1)
    assert (simulation.positions == after).all()


def test_what_cannot_be_is_refused() -> None:
    bodies = rw.Simulation(on_a_table()).obstacles
    with pytest.raises(ValueError, match="jump over nodes; at most"):
        bodies["table"].velocity = (100.0, 0.0, 0.0)
    with pytest.raises(ValueError, match="three finite numbers"):
        bodies["table"].velocity = (np.nan, 0.0, 0.0)
    with pytest.raises(ValueError, match="positive number of seconds"):
        bodies["table"].move_to((0.0, 0.0, 0.0), -1.0)
    with pytest.raises(ValueError, match="turns freely"):
        bodies["pulley"].rate = 1.0


REACH = (
    np.linalg.norm((0.58, 0.38, 0.07)) + 0.02
)  # of the table: a corner of its core, and the rounding
LATE = {"rate": 6.0, "start": 0.2, "stop": 0.3}


@pytest.mark.parametrize(
    "spin", [LATE, {"times": (0.0, 0.2, 0.3), "angles": (0.0, 0.0, 0.6)}], ids=["rate", "table"]
)
def test_a_hand_leaves_room_for_a_spin_that_begins_later(spin: dict[str, Any]) -> None:
    """What moves and turns its edges must not go faster than both together may, once the spin begins."""
    simulation = rw.Simulation(on_a_table(spin=spin))
    table, alone = simulation.obstacles["table"], rw.Simulation(on_a_table()).obstacles["table"]
    assert table.rate == 0.0
    assert table.fastest == pytest.approx(alone.fastest - 6.0 * REACH)
    with pytest.raises(ValueError, match="jump over nodes; at most"):
        table.velocity = (0.9 * alone.fastest, 0.0, 0.0)
    table.velocity = (table.fastest, 0.0, 0.0)
    steps(simulation, 0.25)
    assert table.rate == pytest.approx(6.0)
    steps(simulation, 0.1)
    assert table.fastest == pytest.approx(alone.fastest)  # over: it is no longer in the way


def test_a_hand_leaves_room_for_a_motion_that_begins_later() -> None:
    simulation = rw.Simulation(
        on_a_table(motion=Velocity(velocity=(5.0, 0, 0), start=0.2, stop=0.3))
    )
    table, alone = simulation.obstacles["table"], rw.Simulation(on_a_table()).obstacles["table"]
    assert table.fastest_turn == pytest.approx(alone.fastest_turn - 5.0 / REACH)
    with pytest.raises(ValueError, match="rad/s"):
        table.rate = alone.fastest_turn
    steps(simulation, 0.35)
    assert table.fastest_turn == pytest.approx(alone.fastest_turn)


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf, "fast", None])
def test_what_is_no_rate_is_refused(value: Any) -> None:
    drum = rw.Simulation(on_a_table()).obstacles["drum"]
    with pytest.raises(ValueError, match=r"^rate: .* must be a finite number \[rad/s\]"):
        drum.rate = value
    assert drum.rate == 0.0


def test_what_is_round_turns_by_half_in_a_step_at_most() -> None:
    """As in a scene, which is refused beyond it: friction would point backwards."""
    simulation = rw.Simulation(on_a_table())
    drum, most = simulation.obstacles["drum"], np.pi / STEP
    assert drum.fastest_turn == pytest.approx(most)
    for rate in (1.01 * most, -1.01 * most, 1e300):
        with pytest.raises(
            ValueError, match=f"by more than half; at most {rounded_down(most, 4)} rad/s"
        ):
            drum.rate = rate
    with pytest.raises(ValueError, match="turn by more than half"):
        drum.turn_to(5.0, STEP)
    drum.rate = -0.99 * most
    assert drum.rate == pytest.approx(-0.99 * most)


def test_adaptive_moves_a_body_as_fast_as_its_longest_step_lets_it() -> None:
    """Not as the interval of frames does: its steps may be longer, and shorter, than that."""
    scene = on_a_table()
    found = []
    for longest in (0.02, 0.005):
        run = scene.run.replace(method="adaptive", time_step=longest, frame_rate=100.0)
        simulation = rw.Simulation(scene.replace(run=run))
        found.append(simulation.obstacles["drum"].fastest * longest)
        with pytest.raises(
            ValueError, match=rf"in steps of {longest:g} s it would jump over nodes"
        ):
            simulation.obstacles["drum"].velocity = (1e4, 0.0, 0.0)
    assert found == pytest.approx([0.51, 0.51])


def test_a_disc_is_moved_in_its_own_plane_as_fast_as_in_the_scene() -> None:
    """Its radius is to go there, not its half thickness: at 3 m/s the hand was refused."""
    disc = Cylinder(name="disc", start=(0.5, -0.01, -1), end=(0.5, 0.01, -1), radius=0.2)
    run = rw.RunSettings(method="implicit-euler", time_step=1 / 60, duration=0.1)
    scene = on_a_table().replace(obstacles=[disc], run=run)
    lifted = disc.replace(motion=Velocity(velocity=(0, 0, 3.0)))
    rw.Simulation(scene.replace(obstacles=[lifted]))
    simulation = rw.Simulation(scene)
    body = simulation.obstacles["disc"]
    assert body.fastest == pytest.approx((0.01 + 0.01) * 60)
    assert body.fastest_along((0, 0, 3)) == pytest.approx((0.2 + 0.01) * 60)
    for far, rule in (((0, 0.13, 0), "at most 1.2 m/s"), ((0, 0, 1.3), "at most 12.6 m/s")):
        with pytest.raises(ValueError, match=rule):
            body.move_to(body.position + far, 0.1)
    body.move_to((0.5, 0, -0.7), 0.1)
    simulation.step(0.1)
    np.testing.assert_allclose(body.position, (0.5, 0, -0.7), atol=1e-9)


def test_a_plane_is_moved_as_fast_as_one_likes() -> None:
    """Nothing is jumped over: what is behind it is within."""
    scene = on_a_table().replace(obstacles=[Plane(name="floor", point=(0, 0, -1))])
    floor = rw.Simulation(scene).obstacles["floor"]
    assert floor.fastest == floor.fastest_along((1, 0, 0)) == float("inf")
