"""Ropes of the library that are stretched by more than their EA is right for."""

from __future__ import annotations

from ropewalk.scene.from_library import entry, origin
from ropewalk.scene.rope import Material, Springs


def straight_words(made_of: Springs | Material, strain: float) -> str:
    """Say so where a strain [1] lies beyond what a library rope's EA is right for; else "".

    It is the least of the range that counts: forces beyond are no longer the rope's.
    """
    about = origin(made_of) or {}
    if "EA" not in about.get("numbers", {}):
        return ""
    found, _ = entry(about["library"])
    known = found.numbers.get("straight_to")
    if known is None or not strain > (known.value if known.low is None else known.low):
        return ""
    doubt = "" if known.low is None else f", a guess: {_share(known.low)} to {_share(known.high)}"
    return f"beyond what the EA of {found.name} is right for ({_share(known.value)}{doubt}); {known.note}"


def _share(strain: float | None) -> str:
    return f"{100.0 * (strain or 0.0):.4g} %"
