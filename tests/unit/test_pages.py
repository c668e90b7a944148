"""Frames in one piece of memory."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest

from ropewalk.methods.recording import LARGE, make_recording
from ropewalk.simulation import Simulation
from ropewalk.simulation.block import make_frames
from ropewalk.simulation.pages import LINE
from runs import hanging


@pytest.mark.parametrize(("frames", "one"), [(2, False), (60_000, True)])
def test_large_blocks_lie_in_one_piece(frames: int, one: bool) -> None:
    """Arrays of few pages each were taken page by page; nothing overlaps, and all are as they were."""
    state = Simulation(hanging(duration=0.2, frame_rate=20, segments=8)).arrays
    found, usual = make_frames(state, frames, False), make_recording(state, frames, False)
    assert [part.shape for part in found] == [part.shape for part in usual]
    large = [getattr(found, name) for name in LARGE]
    begins = sorted((part.__array_interface__["data"][0], part.nbytes) for part in large)
    assert all(a + size <= b for (a, size), (b, _) in pairwise(begins))
    gaps = [b - a - size for (a, size), (b, _) in pairwise(begins)]
    assert (max(gaps) < 8 * LINE and min(gaps) >= 0) == one
    owners = {id(part if part.base is None else part.base) for part in large if part.size}
    assert (len(owners) == 1) == one
    for part in large:
        part[...] = 1.0
    assert not any(np.any(part) for part in found[len(LARGE) :])
