"""Ropes simulated step by step, and the blocks of frames that come of it."""

from __future__ import annotations

from ropewalk.simulation.simulation import Broken, Simulation
from ropewalk.simulation.snapshot import Snapshot

__all__ = ["Broken", "Simulation", "Snapshot"]
