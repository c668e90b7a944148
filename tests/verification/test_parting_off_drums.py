"""What is left off a drum parts where no other segment of the rope is there to part."""

from __future__ import annotations

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.scene import Straight


@pytest.mark.parametrize("drums", [1, 2])
@pytest.mark.parametrize("speed", [0.0, -0.05, 0.05])
@pytest.mark.parametrize("method", ["semi-implicit-euler", "esdirk3"])
def test_what_is_all_that_is_left_off_a_drum_parts(method: str, speed: float, drums: int) -> None:
    """A rope of one segment between a drum and its end, or another drum, though a drum winds it."""
    made_of = rw.Material(
        EA=1e4, mass_per_length=0.1, axial_damping=2.0, breaking_load=100.0, parts=True
    )
    shape = Straight(start=(0, 0, 0), end=(0, 0, -2.0))
    flung = {"loads": [{"node": -1, "mass": 20.0}]} if drums == 1 else {}
    turns = {"speed": speed or -1.0, "start": 0.0 if speed else 1.0}
    apart = rw.Anchor(node=-1, motion={"kind": "velocity", "velocity": (0, 0, -0.4)})
    scene = rw.Scene(
        ropes=[rw.Rope(segments=1, length=1.99, made_of=made_of, shape=shape, **flung)],
        anchors=[rw.Anchor(node=0), apart][:drums],
        winches=[rw.Winch(end=end, **turns) for end in ("start", "end")[:drums]],
        run=rw.RunSettings(method=method, time_step=1e-3, duration=0.12, frame_rate=100.0),
    )
    result = rw.simulate(scene)
    (parting,) = result.partings
    assert 100.0 < parting.tension < 130.0
    after = result.time > parting.time
    assert after.any()
    assert not result.tension[after].any()
    assert np.isfinite(result.positions[after]).all()
    assert -result.work["parting"][-1] == pytest.approx(
        0.5 * parting.tension**2 * 1.99 / 1e4, rel=0.05
    )


@pytest.mark.parametrize("method", ["semi-implicit-euler", "esdirk3"])
def test_a_stub_between_a_drum_and_a_break_parts(method: str) -> None:
    """Two segments, 20 kg between them: the far one is pulled apart, then the one at the drum bears it all.

    Once the news of the first has come: a wave passes so heavy a node in 0.2 s.
    """
    made_of = rw.Material(
        EA=1e4, mass_per_length=0.1, axial_damping=2.0, breaking_load=100.0, parts=True
    )
    rope = rw.Rope(
        segments=2,
        length=2.0,
        made_of=made_of,
        shape=Straight(start=(0, 0, 0), end=(0, 0, -2.0)),
        loads=[{"node": 1, "mass": 20.0}],
    )
    apart = rw.Anchor(node=-1, motion={"kind": "velocity", "velocity": (0, 0, -0.4)})
    scene = rw.Scene(
        ropes=[rope],
        anchors=[rw.Anchor(node=0), apart],
        winches=[rw.Winch(end="start", speed=-1.0, start=1.0)],
        run=rw.RunSettings(method=method, time_step=1e-3, duration=0.4, frame_rate=100.0),
    )
    result = rw.simulate(scene)
    assert [one.segment for one in result.partings] == [1, 0]
    assert result.partings[0].tension < 110.0
    assert not result.tension[-1].any()


def test_a_winch_whose_last_segment_has_parted_books_no_work() -> None:
    """Two drums haul 5 kg by a rope of one segment each, of which one parts: its winch's work was NaN.

    The table then told the largest error of the time before, and not a word of the rest.
    """
    places = {"a": ((-0.6, 0, 0.8), -0.5, 60.0), "b": ((0.6, 0, 0.8), -0.3, None)}
    made_of = rw.Material(EA=2000.0, mass_per_length=0.2, axial_damping=2.0)
    scene = rw.Scene(
        ropes=[
            rw.Rope(
                name=name,
                segments=1,
                length=0.8,
                made_of=made_of.replace(breaking_load=load, parts=load is not None),
                shape=Straight(start=top, end=(0, 0, 0)),
                loads=[{"node": -1, "mass": 2.5}],
            )
            for name, (top, _, load) in places.items()
        ],
        joints=[rw.Joint(points=[{"rope": "a", "node": -1}, {"rope": "b", "node": -1}])],
        anchors=[rw.Anchor(rope=name, node=0) for name in places],
        winches=[
            rw.Winch(rope=name, end="start", speed=speed, **({"stop": 0.1} if name == "a" else {}))
            for name, (_, speed, _) in places.items()
        ],
        run=rw.RunSettings(method="esdirk3", time_step=1e-3, duration=0.2, frame_rate=100.0),
    )
    result = rw.simulate(scene)
    assert [(one.rope, one.segment) for one in result.partings] == [("a", 0)]
    assert np.isfinite(result.work["winch"]).all()
    assert np.isfinite(result.energy_errors).all()
    assert "about the energy" not in result.table
