"""Scenes with laws of segments that cannot be run: a winch changes what such a law knows its segments by."""

from __future__ import annotations

from ropewalk.laws.registry import SEGMENT_LAWS
from ropewalk.scene import Scene, SceneError
from ropewalk.scene.faults import Fault


def refuse_winding(scene: Scene) -> None:
    """Raise SceneError for a winch on a rope with a law of segments."""
    faults = []
    for winch in scene.winches:
        rope = scene.rope_named(winch.rope)
        for law in SEGMENT_LAWS:
            if getattr(rope, law.section, None) is not None:
                rule = (
                    f"has {law.section}, with which a winch cannot wind it: leave out one of them"
                )
                faults.append(Fault("rope", rope.name, rule))
    if faults:
        raise SceneError(faults)
