"""The largest force of an anchor that starts at once may be its own node's momentum over a step: told."""

from __future__ import annotations

import pytest

import ropewalk as rw
from ropewalk.scene import Motion, Shake, Springs, Straight, Table, Velocity

ABOUT = "about the largest anchor force"
NODE, SPEED, STEP = 0.05, 2.0, 0.001  # [kg] [m/s] [s]


def led(motion: Motion, method: str = "semi-implicit-euler", step: float = STEP) -> rw.Result:
    """A soft chain hangs from an anchor that starts to move."""
    soft = Springs(spring_constant=20.0, node_mass=NODE, segment_length=0.5, spring_friction=0.1)
    rope = rw.Rope(segments=4, made_of=soft, shape=Straight(direction=(0, 0, -1)))
    run = {"method": method, "time_step": step, "duration": 1.0, "frame_rate": 50.0}
    anchor = rw.Anchor(node=0, motion=motion)
    return rw.simulate(rw.Scene(ropes=[rope], anchors=[anchor], run=run))


def test_a_jump_of_the_held_node_is_told() -> None:
    """m dv / h is told, and is what the force grows by: half the step, twice of it."""
    motion = Velocity(velocity=(SPEED, 0, 0), start=0.3)
    long, short = led(motion), led(motion, step=STEP / 2)
    largest = [one.table["largest anchor force [N]"] for one in (long, short)]
    own = NODE * SPEED / STEP
    assert largest == pytest.approx([own, 2 * own], rel=0.02)
    said = long.table[ABOUT]
    assert f"{NODE:.4g} kg" in said
    assert f"{SPEED:.4g} m/s" in said
    assert "grows as steps get shorter" in said


def test_a_corner_of_a_table_is_one() -> None:
    """It turns from 2 m/s to -2 m/s, so that the node takes 4; a cubic has none but at its ends."""
    corner = {"times": [0.2, 0.5, 0.8], "positions": [(0, 0, 0), (0.6, 0, 0), (0, 0, 0)]}
    assert "by 4 m/s" in led(Table(**corner)).table[ABOUT]


@pytest.mark.parametrize(
    ("motion", "method"),
    [
        (Velocity(velocity=(SPEED, 0, 0), start=0.3), "verlet"),  # cut there: no such force
        (Velocity(velocity=(0.01, 0, 0), start=0.3), "semi-implicit-euler"),
        (Shake(axis=(1, 0, 0), amplitude=0.1, frequency=0.5), "semi-implicit-euler"),
    ],
)
def test_nothing_is_said_of_others(motion: Motion, method: str) -> None:
    """The twins: a method that cuts its steps there, a slow start, a smooth one."""
    assert "at once" not in led(motion, method).table.get(ABOUT, "")


def pulled(step: float, spring: float, friction: float, start: float, stop: float) -> rw.Result:
    """A chain between two anchors, of which the upper one goes up by 2 m/s."""
    made_of = Springs(
        spring_constant=spring, node_mass=NODE, segment_length=0.5, spring_friction=friction
    )
    rope = rw.Rope(segments=4, made_of=made_of, shape=Straight(direction=(0, 0, -1)))
    up = Velocity(velocity=(0, 0, SPEED), start=start, stop=stop)
    anchors = [rw.Anchor(name="top", node=0, motion=up), rw.Anchor(name="low", node=-1)]
    run = {"method": "semi-implicit-euler", "time_step": step, "duration": 0.2, "frame_rate": 50.0}
    return rw.simulate(rw.Scene(ropes=[rope], anchors=anchors, run=run))


def test_what_moves_from_the_start_does_not_jump() -> None:
    """Its force is friction c v and a weight, the same in steps half as long: it was called an impulse."""
    long, short = (pulled(step, 20.0, 10.0, 0.0, 1.0).table for step in (1e-3, 5e-4))
    assert long["largest anchor force [N]"] == pytest.approx(short["largest anchor force [N]"])
    assert "at once" not in long.get(ABOUT, "") + short.get(ABOUT, "")


def test_what_a_rope_bears_is_not_called_an_impulse() -> None:
    """A stop against the pull: 160 N are the rope's. In steps so short that it is more it is one."""
    real, more = (pulled(step, 2000.0, 20.0, 0.0, 0.15).table for step in (5e-4, 2.5e-4))
    assert real["largest anchor force [N]"] == pytest.approx(real["largest tension [N]"], rel=0.02)
    assert "at once" not in real.get(ABOUT, "")
    assert more["largest anchor force [N]"] > 1.4 * more["largest tension [N]"]
    assert f"bear {more['largest tension [N]']:.4g} N then, at most" in more[ABOUT]
