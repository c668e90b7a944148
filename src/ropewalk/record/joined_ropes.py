"""Which ropes have to do with each other."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterable

    from ropewalk.lowering import Layout
    from ropewalk.scene import Scene


def joined_ropes(scene: Scene, layout: Layout, names: Iterable[str]) -> set[str]:
    """Return these ropes and those that they are joined to: by joints, slides, pulleys, or as they touch."""
    joined = set(names)
    if joined and (scene.contact is not None or layout.pulleys):
        return {rope.name for rope in scene.ropes}
    ties = [{tie.rope for tie in one.points} for one in scene.joints]
    ties += [{one.rope, one.on} for one in scene.slides]
    for _ in scene.ropes if ties else ():
        joined |= set().union(*(tie for tie in ties if tie & joined))
    return joined
