"""Small pictures of scenes for the menu, as SVG: those of presets are shipped, from runs of theirs."""

from __future__ import annotations

from functools import lru_cache
from importlib.resources import files
from typing import Any

from ropewalk.live.shape_picture import document, draw, shot
from ropewalk.live.sources import START
from ropewalk.scene import Scene, SceneError
from ropewalk.scene.presets import names
from ropewalk.simulation import Simulation


def svg(name: str, broadcast: Any) -> str | None:
    """Return the picture of a preset, or of the scene that the program was started with."""
    if name == START:
        start = getattr(getattr(broadcast, "session", None), "start", None)
        return _at_rest(start[0]) if start else None
    return shipped(name) if name in names() else None


@lru_cache(maxsize=100)
def shipped(name: str) -> str:
    """Return the shipped picture of a preset; `python -m ropewalk.live.thumbnails` draws them anew."""
    return (files("ropewalk.live") / "thumbnails" / f"{name}.svg").read_text("utf-8")


def _at_rest(scene: Scene) -> str:
    """The scene at time zero: to run it would keep the menu waiting."""
    try:
        return draw([shot(Simulation(scene, ledger=False))], scene)
    except SceneError:
        return document("")
