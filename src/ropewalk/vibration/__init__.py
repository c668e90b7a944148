"""Vibration: natural modes of a scene about a shape, from the exact tangents of all laws."""

from __future__ import annotations

from ropewalk.vibration.modes import Modes, highest_frequency, modes
from ropewalk.vibration.solve import NoModes

__all__ = ["Modes", "NoModes", "highest_frequency", "modes"]
