"""The menu of scenes: by theme, those to look at first, the codes of reports and lessons last."""

from __future__ import annotations

import re
from typing import NamedTuple

from ropewalk.scene.presets import names

OTHERS = "More scenes"
_PLAY, _REAL, _RIGGING, _KNOTS, _LESSONS, _REPORT = (
    "Look and play",
    "Ropes at work",
    "Rigging",
    "Knots and hitches",
    "Ropes of game lessons",
    "The student report: why simulations break",
)
_THEMES: dict[str, tuple[str, ...]] = {
    _PLAY: ("skipping-rope", "whip", "wave-on-a-string", "hanging-rope", "falling-chain", "stairs"),
    _REAL: ("h3", "fishing-rod", "wire-arch", "net", "edge", "crossing", "pile"),
    _RIGGING: (
        *("climbing-fall", "zip-line", "zip-line-ride", "highline", "rescue-lower", "tow"),
        *("crane-snap", "hoist-stop", "guyed-mast", "suspension-cable", "power-line-in-wind"),
        *("three-leg-sling", "capstan", "bollard", "pulley"),
    ),
    _KNOTS: (
        *("overhand", "figure-eight", "reef", "granny", "bowline"),
        *("clove-hitch", "two-half-hitches", "prusik", "munter"),
    ),
    OTHERS: (),
    _LESSONS: ("n40", "h1", "h2", "n39-spring", "n39-gravity", "n39-constant-velocity"),
    _REPORT: ("r4", "r3", "r2", "r1", "r5", "r6", "r7", "r8", "r9"),
}
_CODE = re.compile(r"([A-Z]\d+): (.*)")


class Entry(NamedTuple):
    """A preset in the menu."""

    name: str
    theme: str


def menu() -> list[Entry]:
    """Return all presets in the order of the menu; those of no theme stand among the others."""
    themed = {name for listed in _THEMES.values() for name in listed}
    others = [name for name in names() if name not in themed]
    known = set(names())
    return [
        Entry(name, theme)
        for theme, listed in _THEMES.items()
        for name in (others if theme == OTHERS else listed)
        if name in known
    ]


def title(name: str) -> str:
    """Return a scene's name for the menu: its code, if it has one, behind the words."""
    found = _CODE.fullmatch(name)
    words = f"{found[2]} ({found[1]})" if found else name
    return words[:1].upper() + words[1:]
