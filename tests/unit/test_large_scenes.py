"""What is done before a run costs no Python per segment: a million of them begin in seconds."""

from __future__ import annotations

import sys
from collections.abc import Callable
from types import FrameType
from typing import Any

from ropewalk.analysis.check import check
from ropewalk.lowering import build
from ropewalk.scene import Anchor, Material, Rope, RunSettings, Scene, Slack
from ropewalk.simulation import Simulation


def slack(segments: int) -> Scene:
    """1000 m of rope between two anchors 900 m apart."""
    made_of = Material(EA=1e7, mass_per_length=0.1, axial_damping=1.0)
    shape = Slack(end=(900.0, 0.0, 0.0))
    rope = Rope(segments=segments, length=1000.0, made_of=made_of, shape=shape)
    run = RunSettings(method="verlet", time_step=1e-8, duration=1e-7, frame_rate=1e7)
    return Scene(ropes=[rope], anchors=[Anchor(node=0), Anchor(node=-1)], run=run)


def calls(work: Callable[[], object]) -> int:
    """Return how many Python functions are called."""
    count = 0

    def note(frame: FrameType, event: str, argument: Any) -> None:
        nonlocal count
        count += event in ("call", "c_call")

    before = sys.getprofile()
    sys.setprofile(note)
    try:
        work()
    finally:
        sys.setprofile(before)
    return count


def test_twice_the_segments_take_no_more_calls() -> None:
    """Of reading, building, `check` and a simulation's begin; the twin is a loop over the segments."""

    def begin(segments: int) -> Callable[[], object]:
        def work() -> None:
            model = build(slack(segments))
            check(model, measure=False)
            Simulation(model)

        return work

    begin(110_000)()  # whatever is done once
    few, many = calls(begin(110_000)), calls(begin(220_000))
    assert many < 1.5 * few
    assert many < 110_000
    assert calls(lambda: [len("") for _ in range(220_000)]) > 220_000
