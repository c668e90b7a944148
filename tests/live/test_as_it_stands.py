"""The scene of now, as it is exported: it begins where the session stands, with the motions that are left."""

from __future__ import annotations

import numpy as np
import pytest

from live.drive import do, slack_rope
from ropewalk.live.as_it_stands import Standing
from ropewalk.live.session import Session
from ropewalk.scene import Anchor, Scene, dumps, loads
from ropewalk.scene.motions import Orbit, Shake, Table, Velocity

FOR = 0.05  # s
BODIES = """
[[obstacle]]
name = "ball"
kind = "sphere"
center = [0, 0, -50]
radius = 0.1
motion = { kind = "velocity", velocity = [1, 0, 0], start = 0.02, stop = 0.08 }
[[obstacle]]
name = "pipe"
kind = "cylinder"
from = [0, -1, -60]
to = [0, 1, -60]
radius = 0.2
motion = { kind = "shake", axis = [0, 0, 1], amplitude = 0.3, frequency = 2, phase = 0.4 }
[[obstacle]]
name = "box"
kind = "box"
center = [0, 0, -70]
half_sizes = [0.6, 0.3, 0.1]
edge_radius = 0.02
motion = { kind = "orbit", center = [1, 0, -70], axis = [0, 0, 1], frequency = 0.5 }
spin = { rate = 2.0, start = 0.01 }
[[obstacle]]
name = "plate"
kind = "plane"
point = [0, 0, -90]
motion = { kind = "table", times = [0.01, 0.2], positions = [[0, 0, -90], [0, 0, -89]] }
[[obstacle]]
name = "led"
kind = "sphere"
center = [0, 0, -95]
radius = 0.1
"""


def steps(session: Session, seconds: float) -> None:
    session.advance(round(seconds / session.main.dt))


def exported(session: Session) -> Session:
    """Return a session of the file that a page gets."""
    return Session(loads(dumps(Standing.of(session).scene())))


MOTIONS = {
    "velocity": Velocity(velocity=(0.0, 1.0, 0.0), start=0.02, stop=0.07),
    "over": Velocity(velocity=(0.0, 1.0, 0.0), start=0.01, stop=0.03),
    "shake": Shake(axis=(0.0, 1.0, 0.0), amplitude=0.2, frequency=3.0, phase=0.3),
    "orbit": Orbit(center=(8.0, 0.5, 0.0), axis=(1.0, 0.0, 0.0), frequency=1.0),
    "table": Table(
        times=[0.0, 0.04, 0.1],
        positions=[(8.0, 0.0, 0.0), (8.0, 0.2, 0.0), (8.1, 0.2, 0.0)],
        interpolation="cubic",
    ),
}


@pytest.mark.parametrize("name", MOTIONS)
def test_an_anchor_goes_on_where_it_is(name: str) -> None:
    """Motions began anew: the node of one on a table jumped to where that begins."""
    scene: Scene = slack_rope(4)
    left, right = scene.anchors
    session = Session(scene.replace(anchors=[left, right.replace(motion=MOTIONS[name])]))
    steps(session, FOR)
    again = exported(session)
    for _ in range(2):
        first, other = session.main.simulation, again.main.simulation
        assert other.positions == pytest.approx(first.positions, abs=1e-9)
        assert other.velocities == pytest.approx(first.velocities, abs=1e-6)
        for one in (session, again):
            steps(one, FOR)


def test_an_anchor_that_has_let_go_is_not_there_and_others_let_go_in_time() -> None:
    """It held again."""
    scene: Scene = slack_rope(4)
    left, right = scene.anchors
    middle = Anchor(name="middle", node=2, release_time=0.3 * FOR)
    anchors = [left, right.replace(release_time=1.5 * FOR), middle]
    session = Session(scene.replace(anchors=anchors))
    steps(session, FOR)
    again = exported(session)
    assert [one.name for one in again.scene.anchors] == ["left", "right"]
    for one in (session, again):
        steps(one, FOR)
    first, other = session.main.simulation, again.main.simulation
    assert not other.anchors["right"].holds
    assert other.positions == pytest.approx(first.positions, abs=1e-9)


def test_an_anchor_that_a_hand_has_led_stays_there() -> None:
    scene: Scene = slack_rope(4)
    left, right = scene.anchors
    session = Session(scene.replace(anchors=[left, right.replace(motion=MOTIONS["shake"])]))
    do(session, "move", anchor="right", velocity=[0.0, 0.0, 2.0])
    steps(session, FOR)
    do(session, "move", anchor="right", velocity=[0.0, 0.0, 0.0])
    steps(session, FOR)
    again = exported(session)
    steps(again, FOR)
    now = session.main.simulation.anchors["right"].position
    assert now[2] == pytest.approx(2.0 * FOR)
    assert again.main.simulation.anchors["right"].position == pytest.approx(now, abs=1e-12)


def test_bodies_go_on_where_they_are() -> None:
    """One that a hand had led was back at its old place, those that move by themselves began anew."""
    scene: Scene = slack_rope(4)
    session = Session(loads(dumps(scene) + BODIES))
    do(session, "obstacle", obstacle="led", target=(0.5, 0.0, -95.0), pace=0.1)
    steps(session, FOR)
    assert session.main.simulation.obstacles["led"].position[0] == pytest.approx(0.5)
    again = exported(session)
    for seconds in (0.0, FOR, 2.0 * FOR):
        for one in (session, again):
            steps(one, seconds)
        for name, body in session.main.simulation.obstacles.items():
            other = again.main.simulation.obstacles[name]
            assert other.position == pytest.approx(body.position, abs=1e-9), name
            assert other.angle == pytest.approx(body.angle, abs=1e-9), name
    places = [one.position for one in session.main.simulation.obstacles.values()]
    assert np.isfinite(places).all()
