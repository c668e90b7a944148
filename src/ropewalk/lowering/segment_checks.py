"""Scenes with laws of segments that cannot be run.

Two elastic laws at once; or a winch and a law of segments, whose table knows them by nominal length.
"""

from __future__ import annotations

from collections.abc import Iterator

from ropewalk.laws.registry import ELASTIC_LAWS, SEGMENT_LAWS
from ropewalk.scene import Rope, Scene, SceneError
from ropewalk.scene.faults import NO_VALUE, Fault


def refuse_segments(scene: Scene) -> None:
    """Raise SceneError for two elastic laws of a rope, and a winch that does not know them."""
    faults = []
    for i, rope in enumerate(scene.ropes):
        said = _elastic(rope)
        if len(said) > 1:
            rule = (
                f"has {' and '.join(said)}, and its tension can obey one only: leave out the others"
            )
            faults.append(Fault(f"rope[{i}]", NO_VALUE, rule))
        if said and rope.rigid:
            rule = f"has {said[0]}, but links that do not stretch (inf): give it a finite stiffness"
            faults.append(Fault(f"rope[{i}]", NO_VALUE, rule))
    for i, winch in enumerate(scene.winches):
        rope = scene.rope_named(winch.rope)
        for name in _unwindable(rope):
            rule = f"has {name}, with which a winch cannot wind it: leave out one of them"
            faults.append(Fault(f"winch[{i}].rope", rope.name, rule))
    if faults:
        raise SceneError(faults)


def _elastic(rope: Rope) -> list[str]:
    """Return the elastic laws that a rope says something of."""
    return [law.name for law in ELASTIC_LAWS if law.says(rope) is not None]


def _unwindable(rope: Rope) -> Iterator[str]:
    """Yield the laws of a rope whose tables or memory know its segments by their nominal length."""
    for law in SEGMENT_LAWS:
        if getattr(rope, law.section, None) is not None:
            yield law.section
