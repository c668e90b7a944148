"""Vibration: natural modes of a scene about a shape, from the exact tangents of all laws."""

from __future__ import annotations

from ropewalk.vibration.flexibility import NoModes
from ropewalk.vibration.modes import Modes, highest_frequency, modes

__all__ = ["Modes", "NoModes", "highest_frequency", "modes"]
