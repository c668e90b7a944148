"""Counts and seeds that are given: whole numbers, or one clear sentence."""

from __future__ import annotations

from typing import Any

import numpy as np

from ropewalk.record.errors import InputError


def is_whole(value: Any, least: int | None = None) -> bool:
    """Tell whether a value is a whole number, from `least` on if that is given."""
    number = isinstance(value, (int, np.integer)) and not isinstance(value, bool)
    return number and (least is None or bool(value >= least))


def refuse_unless_whole(name: str, value: Any, least: int | None = None) -> None:
    """Refuse anything but a whole number, from `least` on if that is given. Raises InputError."""
    if not is_whole(value, least):
        beginning = "" if least is None else f" from {least} on"
        raise InputError(name, value, f"must be a whole number{beginning}")
