"""Pieces of a run that is damaged in its middle: what comes before is served whole, the damage is told."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from ropewalk.live.replay_routes import _begun
from ropewalk.record.errors import RunError


def frames(first: int, damaged: int) -> Iterator[bytes]:
    """Frames of two bytes, one of which cannot be read."""
    for number in range(first, 6):
        if number == damaged:
            raise RunError("run", "frame 3 is damaged")
        yield bytes([number, number])


def test_a_piece_ends_before_the_frame_that_cannot_be_read() -> None:
    assert list(_begun(frames(0, damaged=3))) == [b"\0\0", b"\1\1", b"\2\2"]
    with pytest.raises(RunError, match="frame 3"):  # the next piece: it becomes an answer of 500
        _begun(frames(3, damaged=3))
    assert len(list(_begun(frames(0, damaged=9)))) == 6
