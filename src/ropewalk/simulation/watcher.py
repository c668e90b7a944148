"""Whoever looks at a simulation while others move it on."""

from __future__ import annotations

from typing import Protocol

from ropewalk.core.peaks import Peaks
from ropewalk.methods.recording import Recording


class Watcher(Protocol):
    """Whoever is told the extremes of every call that moves a simulation on."""

    def take(self, peaks: Peaks) -> None:
        """Take those of the call just made."""

    def take_frames(self, frames: Recording) -> None:
        """Take those of frames just recorded."""
