"""The stiffness of a rope as it is shown and changed live: per segment, or as EA.

Of a rope that relaxes it is what stays: that is what a change of it sets.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from ropewalk.live.segments import with_rope
from ropewalk.scene import Fault, Rope, Scene, SceneError, Springs


def made_of(scene: Scene, index: int, **changes: Any) -> Scene:
    """Return the scene with changes of what one rope is made of."""
    rope = scene.ropes[index]
    return with_rope(scene, index, rope.replace(made_of=rope.made_of.replace(**changes)))


def of_rope(get: Callable[[Rope], float | None]) -> Callable[[Scene, int], float | None]:
    """Return what gets a value of the rope with an index."""
    return lambda scene, index: get(scene.ropes[index])


def spring_constant(rope: Rope) -> float:
    """Return the spring constant of every segment [N/m]."""
    if isinstance(rope.made_of, Springs):
        return rope.made_of.spring_constant
    return rope.made_of.EA / rope.segment_length


def set_spring_constant(scene: Scene, index: int, value: float) -> Scene:
    """Return the scene with another spring constant of a rope [N/m]."""
    rope = scene.ropes[index]
    if isinstance(rope.made_of, Springs):
        return made_of(scene, index, spring_constant=value)
    return made_of(scene, index, EA=value * rope.segment_length)


def axial_stiffness(rope: Rope) -> float | None:
    """Return EA [N]; None of springs of no length."""
    if isinstance(rope.made_of, Springs):
        return rope.made_of.spring_constant * rope.segment_length or None
    return rope.made_of.EA


def set_axial_stiffness(scene: Scene, index: int, value: float) -> Scene:
    """Return the scene with another EA of a rope [N]. Raises SceneError for springs of no length."""
    rope = scene.ropes[index]
    if not isinstance(rope.made_of, Springs):
        return made_of(scene, index, EA=value)
    if rope.segment_length == 0.0:
        rule = "springs of no length have none; change spring_constant"
        raise SceneError([Fault("EA", value, rule)])
    return made_of(scene, index, spring_constant=value / rope.segment_length)
