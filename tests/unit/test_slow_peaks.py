"""What comes slowly to its largest value is no peak of a step or two, however soon it ends."""

from __future__ import annotations

import ropewalk as rw
from ropewalk.record.note_kinds import kinds
from ropewalk.scene import (
    Anchor,
    Material,
    Plane,
    Rope,
    RunSettings,
    Scene,
    Straight,
    Velocity,
)

PULL, SPEED = "about the largest tension", "about the largest speed"
STUFF = Material(EA=1e4, mass_per_length=0.1, axial_damping=5.0)
RUN = RunSettings(method="implicit-euler", time_step=1 / 60, frame_rate=60.0, duration=1.0)


def test_a_rope_that_is_pulled_slowly_and_let_go_has_no_short_peak() -> None:
    """Of 500.25 N, which were right, it told "from 100 % of it one frame before to 0 % in the one after"."""
    rope = Rope(segments=10, length=1.0, made_of=STUFF, shape=Straight(direction=(1, 0, 0)))
    anchors = [
        Anchor(node=0),
        Anchor(node=10, motion=Velocity(velocity=(0.05, 0, 0)), release_time=1.0),
    ]
    run = RUN.replace(duration=1.2)
    result = rw.simulate(Scene(ropes=[rope], anchors=anchors, gravity=(0, 0, 0), run=run))
    assert "a step or two" not in result.table.get(PULL, "")


def test_a_rope_that_falls_on_a_floor_came_slowly_to_its_speed() -> None:
    rope = Rope(
        segments=10, length=1.0, diameter=0.01, made_of=STUFF,
        shape=Straight(start=(0, 0, 1.25), end=(1, 0, 1.25)),
    )  # fmt: skip
    result = rw.simulate(Scene(ropes=[rope], obstacles=[Plane(normal=(0, 0, 1))], run=RUN))
    assert SPEED not in result.table
    assert "speed may be too low" not in kinds(result)


def test_a_rope_at_rest_has_no_speed_to_speak_of() -> None:
    rope = Rope(segments=10, length=1.0, made_of=STUFF, shape=Straight(direction=(0, 0, -1)))
    scene = Scene(ropes=[rope], anchors=[Anchor(node=0)], run=RUN.replace(start="at-rest"))
    assert "speed may be too low" not in kinds(rw.simulate(scene))
