"""Numbers of things in sentences."""

from __future__ import annotations


def counted(number: int, noun: str) -> str:
    """Return so many things: "1 step", "20 steps", for nouns whose plural is regular."""
    return f"{number} {noun}" if number == 1 else f"{number} {noun}s"
