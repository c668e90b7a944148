"""Rows of an export that leaves frames out: least and greatest are of what was rope."""

from __future__ import annotations

import numpy as np
import pytest

from ropewalk.live.recorded import Recorded
from sweeps.test_keep import hung


@pytest.mark.parametrize("values", [2_000_000, 50])
@pytest.mark.parametrize("speed", [0.0, -0.8, 0.8])
def test_what_is_no_rope_any_more_pulls_no_least_tension_down(
    speed: float, values: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Zeros stand for what has parted or lies on a drum; they came into the row."""
    monkeypatch.setattr("ropewalk.record.skipped._VALUES", values)
    result, every = hung(100.0, speed), 3
    low, high = result.least_tension, result.greatest_tension
    there = result.live | np.roll(result.live, 1, axis=0)
    there[0] = result.live[0]
    rows = result.to_pandas("segments", every=every)
    segments = result.layout.segments
    least = rows["least tension [N]"].to_numpy().reshape(-1, segments)
    greatest = rows["greatest tension [N]"].to_numpy().reshape(-1, segments)
    raised = 0
    for row, frame in enumerate(range(0, result.frames, every)):
        since = slice(max(frame - every + 1, 0), frame + 1)
        for j in range(segments):
            rope = there[since, j]
            assert least[row, j] == (low[since, j][rope].min() if rope.any() else 0.0)
            assert greatest[row, j] == (high[since, j][rope].max() if rope.any() else 0.0)
            raised += (least[row, j], greatest[row, j]) != (
                low[since, j].min(),
                high[since, j].max(),
            )
    assert raised or speed < 0.0  # rows in which a zero stood


@pytest.mark.parametrize("piece", [64, 4])
@pytest.mark.parametrize("speed", [0.0, -0.8, 0.8])
def test_frames_that_a_page_leaves_out_pull_nothing_down(
    speed: float, piece: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A segment that came off the drum in between had a least tension of 0 N in replays and pages."""
    monkeypatch.setattr("ropewalk.live.recorded._PIECE", piece)
    result, every = hung(100.0, speed), 3
    rows = result.to_pandas("segments", every=every)
    reader = Recorded(result)
    for name, column in (("least", "least tension [N]"), ("greatest", "greatest tension [N]")):
        expected = rows[column].to_numpy().reshape(-1, result.layout.segments)
        for row, frame in enumerate(range(0, result.frames, every)):
            seen = reader.picture(frame, frame - every).seen
            np.testing.assert_array_equal(getattr(seen, f"{name}_tension"), expected[row])
