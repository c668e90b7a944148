"""Lessons: the scenes of the five lessons for a class, which run in the lab's page alone."""

from __future__ import annotations

from importlib.resources import files

from ropewalk.scene import Scene
from ropewalk.scene.toml_text import loads

#: In the order of the lessons.
NAMES = (
    "step-by-step",
    "pendulum",
    "far-swing",
    "swinging-rope",
    "pulse",
    "climbing-pulse",
    "chain-at-rest",
    "tone",
    "overtone",
    "guitar-string",
    "post",
    "post-hauled",
    "three-half-turns",
)


def lesson_text(name: str) -> str:
    """Return a lesson's scene as commented TOML; `name` is one of `NAMES`."""
    return files("ropewalk.lessons").joinpath("scenes", f"{name}.toml").read_text("utf-8")


def lesson_scene(name: str) -> Scene:
    """Return a lesson's scene; `name` is one of `NAMES`."""
    return loads(lesson_text(name), f"lesson {name}")


def lesson_scenes() -> list[Scene]:
    """Return the scenes of all lessons, in their order."""
    return [lesson_scene(name) for name in NAMES]
