"""The scene of now, as it is exported: it begins where the session stands, with the motions that are left."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from live.drive import do, slack_rope
from ropewalk.laws.obstacle_rows import axle_of, hub_of, place_of, turned_by
from ropewalk.live.as_it_stands import Standing
from ropewalk.live.session import Session
from ropewalk.scene import Anchor, Scene, Slide, Straight, dumps, loads
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
BOX = """
[[obstacle]]
name = "box"
kind = "box"
center = [0, 0, -70]
half_sizes = [0.6, 0.3, 0.1]
edge_radius = 0.02
spin = {}
{}
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


def trolley(at: float) -> Scene:
    """Return a line along which a trolley with a load runs down, from a place [m] of it."""
    scene: Scene = slack_rope(10)
    [line] = scene.ropes
    hung = line.replace(
        name="hung", segments=2, length=1.0, shape=Straight(start=(at, 0, 0), end=(at, 0, -1))
    )
    slide = Slide(name="trolley", rope="hung", node=0, on="line", at=at)
    return scene.replace(
        ropes=[line.replace(name="line", shape=Straight(start=(0, 0, 0), end=(8, 0, -6))), hung],
        anchors=[one.replace(rope="line") for one in scene.anchors],
        slides=[slide],
    )


def test_a_trolley_goes_on_where_it_is() -> None:
    """It was back where it began, its rope with it."""
    session = Session(trolley(2.0))
    do(session, "kick", node=11, velocity=[8.0, 0.0, -6.0])
    steps(session, 0.1)
    first = session.main.simulation.positions[11]
    begun = Session(trolley(2.0)).main.simulation.positions[11]
    again = exported(session)
    assert np.linalg.norm(first - begun) > 0.3
    line = session.scene.ropes[0]
    assert again.main.simulation.positions[11] == pytest.approx(
        first, abs=0.05 * line.segment_length
    )


@pytest.mark.parametrize("stop", [0.08, 0.6, 3.0])
def test_a_body_turns_on_at_its_rate(stop: float) -> None:
    """One that stopped within a second took all of it for what was left."""
    session = Session(
        loads(dumps(slack_rope(4)) + BOX.format(f"{{ rate = 2.0, stop = {stop} }}", ""))
    )
    steps(session, FOR)
    again = exported(session)
    for _ in range(3):
        first, other = (one.main.simulation.obstacles["box"] for one in (session, again))
        assert other.angle == pytest.approx(first.angle, abs=1e-9)
        assert other.rate == pytest.approx(first.rate, abs=1e-9)
        for one in (session, again):
            steps(one, 0.02)


@pytest.mark.parametrize(
    ("motion", "taken"),
    [
        ("velocity = [1, 0, 0]", {"angle": 0.1}),
        ("axis = [1, 0, 0], amplitude = 0.2, frequency = 2", {"angle": 0.1}),
        ("velocity = [1, 0, 0]", {"target": (0.1, 0.0, -70.0)}),
    ],
)
def test_of_a_body_that_a_hand_has_taken_the_rest_goes_on(
    motion: str, taken: dict[str, Any]
) -> None:
    """What the hand had not changed began anew, and one that it had turned had lost its pivot."""
    kind = "velocity" if "velocity" in motion else "shake"
    spin = "{ rate = 2.0, pivot = [0.5, 0, -70] }"
    text = BOX.format(spin, f'motion = {{ kind = "{kind}", {motion} }}')
    session = Session(loads(dumps(slack_rope(4)) + text))
    steps(session, FOR)
    do(session, "obstacle", obstacle="box", pace=0.1, **taken)
    steps(session, FOR)
    again = exported(session)
    apart = [hub_of(one) - place_of(one)[0] for one in again.scene.obstacles]
    assert apart == [pytest.approx([0.5, 0.0, 0.0], abs=1e-12)]
    for _ in range(2):
        first, other = (one.main.simulation.obstacles["box"] for one in (session, again))
        assert other.position == pytest.approx(first.position, abs=1e-9)
        assert other.angle == pytest.approx(first.angle, abs=1e-9)
        for one in (session, again):
            steps(one, FOR)


FREE = """
[[obstacle]]
name = "box"
kind = "box"
center = [0, 0, -70]
half_sizes = [0.6, 0.3, 0.1]
edge_radius = 0.02
axis = [0, 1, 1]
rotation = [0.3, 0, 0.2]
motion = { kind = "velocity", velocity = [1, 0, 0] }
spin = { free = true, inertia = 2, rate = 3, pivot = [0.5, 0, -70] }
[[obstacle]]
name = "arm"
kind = "capsule"
from = [0, 0, -80]
to = [1, 0, -80]
radius = 0.1
spin = { free = true, inertia = 2, rate = 3, pivot = [0.2, 0, -80], axis = [0, 1, 0], mass = 1 }
[[obstacle]]
name = "wheel"
kind = "cylinder"
from = [0, -1, -90]
to = [0, 1, -90]
radius = 0.2
spin = { free = true, inertia = 2, rate = 3, mass = 1, center_of_mass = [0.1, 0, -90] }
"""


def marks(session: Session) -> list[np.ndarray[Any, Any]]:
    """Return where three points of each body are now, and its centre of mass [m]."""
    found = []
    for body, handle in zip(
        session.scene.obstacles, session.main.simulation.obstacles.values(), strict=True
    ):
        place, hub, reach = np.array(place_of(body)[0]), hub_of(body), np.eye(3)
        along = np.subtract(body.end, body.start) if body.kind != "box" else None
        reach = turned_by(body.rotation, reach) if along is None else along[None]
        mass = body.spin.center_of_mass or place
        points = np.vstack([place, place + reach, mass]) - hub
        moved = handle.position - place
        found.append(turned_by(handle.angle * axle_of(body), points) + hub + moved)
    return found


def test_what_turns_freely_goes_on_as_it_stands() -> None:
    """It began unturned: a beam that lay aslant was upright."""
    session = Session(loads(dumps(slack_rope(4)) + FREE))
    steps(session, 0.2)
    again = exported(session)
    assert all(one.angle > 0.5 for one in session.main.simulation.obstacles.values())
    for _ in range(2):
        for first, other in zip(marks(session), marks(again), strict=True):
            assert other == pytest.approx(first, abs=1e-6)
        for one in (session, again):
            steps(one, FOR)
