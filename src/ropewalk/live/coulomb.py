"""Coefficients of friction as one number of a whole scene, where it has one."""

from __future__ import annotations

from ropewalk.scene import Scene

_OWN = "is each rope's own here: set it in the scene file, as friction of a rope or under pairs"


def bar_obstacles(scene: Scene) -> str:
    """Return why a scene has no one coefficient of ropes on obstacles; "" where it has."""
    if not scene.obstacles:
        return "there is no obstacle"
    if any(one.pairs for one in scene.obstacles) or any(rope.friction for rope in scene.ropes):
        return _OWN
    if len({one.friction for one in scene.obstacles}) > 1:
        return "is each obstacle's own here: set it in the scene file, as friction of the obstacle"
    return ""


def of_obstacles(scene: Scene, _: int) -> float:
    """Return the coefficient of ropes on obstacles [1]; 0 without any."""
    return float(scene.obstacles[0].friction) if scene.obstacles else 0.0


def set_of_obstacles(scene: Scene, _: int, value: float) -> Scene:
    """Return the scene with another coefficient [1] on all obstacles."""
    return scene.replace(obstacles=[one.replace(friction=value) for one in scene.obstacles])


def bar_contact(scene: Scene) -> str:
    """Return why a scene has no one coefficient of ropes on ropes; "" where it has."""
    if scene.contact is None:
        return "ropes do not touch each other in this scene"
    return _OWN if scene.contact.pairs or any(rope.friction for rope in scene.ropes) else ""


def of_contact(scene: Scene, _: int) -> float:
    """Return the coefficient of ropes on ropes [1]; 0 where they do not touch."""
    return 0.0 if scene.contact is None else float(scene.contact.friction)


def set_of_contact(scene: Scene, _: int, value: float) -> Scene:
    """Return the scene with another coefficient [1] of ropes on ropes."""
    if scene.contact is None:
        return scene
    return scene.replace(contact=scene.contact.replace(friction=value))
