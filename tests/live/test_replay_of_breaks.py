"""A replay of a run that broke ends in the single steps past its last good frame, marked as such."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest

import ropewalk as rw
import runs
from ropewalk.live.frame import BROKEN, END, HEADER
from ropewalk.live.packed_run import _about, record
from ropewalk.live.replay import ReplayBroadcast
from ropewalk.record.beyond import until_torn
from ropewalk.record.result import Result


@pytest.fixture(scope="module")
def broken() -> Iterator[Result]:
    return rw.simulate(runs.breaking(), on_failure="return")


def flags(broadcast: ReplayBroadcast) -> list[int]:
    return [
        HEADER.unpack_from(one)[3] for one in broadcast.frames_between(0, len(broadcast.times), 1)
    ]


def test_the_last_frames_are_steps_past_the_break(broken: Result) -> None:
    past = until_torn(broken)
    assert past is not None
    broadcast = ReplayBroadcast(broken, playing=False)
    told = [bool(flag & BROKEN) for flag in flags(broadcast)]
    assert told == [False] * broken.frames + [True] * len(past.time)
    assert flags(broadcast)[-1] & END
    np.testing.assert_array_equal(broadcast.times[broken.frames :], past.time)
    last = broadcast.parts[0].picture(broadcast.parts[0].frames - 1)
    np.testing.assert_array_equal(last.positions, past.positions[-1])
    assert not last.anchors[:, 3:9].any()  # no force is claimed there
    assert last.scalars["kinetic"] == broken.energy["kinetic"][-1]
    broke = broadcast.layout(0)["broke"]
    assert broke == {"time": broken.time[-1], "text": broken.diagnosis}


def test_a_sound_run_has_no_such_frames() -> None:
    broadcast = ReplayBroadcast(rw.simulate(runs.hanging(duration=0.2)), playing=False)
    assert not any(flag & BROKEN for flag in flags(broadcast))
    assert broadcast.layout(0)["broke"] is None


def test_an_anchor_that_has_let_go_is_not_shown_to_hold() -> None:
    scene = runs.hanging(duration=0.2)
    first, *others = scene.anchors
    let_go = scene.replace(anchors=[first.replace(release_time=0.1), *others])
    broadcast = ReplayBroadcast(rw.simulate(let_go), playing=False)
    (part,) = broadcast.parts
    holds = [bool(part.picture(frame).anchors[0, 9]) for frame in range(part.frames)]
    assert holds == [bool(time < 0.1) for time in broadcast.times]
    assert set(holds) == {True, False}
    told = [anchor["until"] for anchor in broadcast.layout(0)["variants"][0]["anchors"]]
    assert told == [0.1, *(one.release_time for one in others)]


def test_frames_recorded_into_a_break_are_marked_too() -> None:
    result = rw.simulate(runs.breaking(), on_failure="return", keep_going=True)
    told = [bool(flag & BROKEN) for flag in flags(ReplayBroadcast(result, playing=False))]
    assert told == [frame >= result.good_frames for frame in range(result.frames)]


def test_a_page_to_share_has_them_and_keeps_its_digits(broken: Result) -> None:
    past = until_torn(broken)
    assert past is not None
    page = record(broken)
    [part] = page.header["parts"]
    assert (part["frames"], part["good"]) == (broken.frames + len(past.time), broken.frames)
    assert page.header["single"] == len(past.time)
    assert "It broke" in page.header["about"]
    # The huge tensions past the break cost the others none of their digits.
    assert page.tension_error < np.ptp(broken.tension) / 4000
    assert past.tension is not None
    assert np.ptp(past.tension) > 2 * np.ptp(broken.tension)


@pytest.mark.parametrize(
    ("frames", "left_out", "single", "said"),
    [
        (1, 1, 1, ["1 frame, 0 s", "has 1 single step.", "The last frame, after it broke, lies"]),
        (9, 3, 2, ["9 frames, 8 s", "has 2 single steps.", "last 3 frames, after it broke, lie "]),
    ],
)
def test_one_is_not_several(frames: int, left_out: int, single: int, said: list[str]) -> None:
    times = np.arange(float(frames + single))
    text = _about(times, 60.0, left_out, {"positions": 1e-4, "tension": 1e-2}, single)
    assert all(one in text for one in said), text
