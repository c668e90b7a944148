"""The scene: everything that a run needs to know."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar, cast

from pydantic import Field, TypeAdapter, ValidationError, field_validator, model_validator

from ropewalk.scene.anchor import Anchor
from ropewalk.scene.base import Many, Model, Text, Vector, Whole, listed, refuse, vector
from ropewalk.scene.checks import obstacle_faults, scene_faults
from ropewalk.scene.environment import Air, Ground, Limiter
from ropewalk.scene.faults import Fault, SceneError
from ropewalk.scene.joint import Joint
from ropewalk.scene.obstacles import Obstacle
from ropewalk.scene.paths import root_of_paths
from ropewalk.scene.rope import Rope, Springs
from ropewalk.scene.rope_contact import Contact, contact_faults
from ropewalk.scene.rubbing import pair_faults
from ropewalk.scene.run_settings import RunSettings
from ropewalk.scene.slide import Slide, slide_faults
from ropewalk.scene.winch import Winch

if TYPE_CHECKING:
    from ropewalk.live.view import View

SCHEMA_VERSION = 1
_VIEW = "ropewalk.live.view"  # a layer above this one, so it is looked up when it is needed
_P = TypeVar("_P", bound=Model)


@root_of_paths
class Scene(Model):
    """Ropes, what holds them, what surrounds them, and how to run them. All SI."""

    schema_version: Whole = Field(default=SCHEMA_VERSION, description="Version of this format")
    name: Text = Field(default="scene", min_length=1, max_length=200, description="Title")
    description: Text = Field(default="", max_length=2000, description="What it shows")
    gravity: Vector = vector(
        "Gravity; up is minus gravity (z without it)", "m/s^2", default=(0, 0, -9.81)
    )
    run: RunSettings = Field(default=RunSettings(), description="How to run it")
    ropes: Many[Rope] = listed("Ropes, one or more", "rope", "ropes", default=())
    anchors: Many[Anchor] = listed("Anchors, at most one per node", "anchor", "anchors", default=())
    air: Air | None = Field(default=None, description="Air drag; none without it")
    ground: Ground | None = Field(default=None, description="Ground; none without it")
    obstacles: Many[Obstacle] = listed(
        "Bodies that ropes touch, with friction", "obstacle", "obstacles", default=()
    )
    contact: Contact | None = Field(
        default=None, description="Contact of ropes with each other and themselves; none without it"
    )
    limiter: Limiter | None = Field(default=None, description="Stretch limiter; none without it")
    winches: Many[Winch] = listed(
        "Winches, at most one per rope end", "winch", "winches", default=()
    )
    joints: Many[Joint] = listed(
        "Joints: nodes that are tied to each other", "joint", "joints", default=()
    )
    slides: Many[Slide] = listed(
        "Slides: nodes that run along other ropes", "slide", "slides", default=()
    )

    @property
    def up(self) -> tuple[float, float, float]:
        """Unit vector [1] against gravity; z where there is no gravity."""
        size = math.hypot(*self.gravity)
        if size == 0.0:
            return (0.0, 0.0, 1.0)
        x, y, z = (0.0 - part / size for part in self.gravity)
        return (x, y, z)

    @property
    def parts(self) -> bool:
        """Whether any of its ropes can part."""
        return any(rope.made_of.parts for rope in self.ropes)

    @property
    def lengths_change(self) -> bool:
        """Whether unstretched lengths change in time: by a winch, or as ropes part."""
        return bool(self.winches) or self.parts

    def rope_named(self, name: str) -> Rope:
        """The rope of that name.

        Raises:
            KeyError: when there is none.
        """
        return self.ropes[self.rope_index(name)]

    def rope_index(self, name: str) -> int:
        """The place of the rope of that name among the ropes, from 0.

        Raises:
            KeyError: when there is none.
        """
        for index, rope in enumerate(self.ropes):
            if rope.name == name:
                return index
        names = ", ".join(rope.name for rope in self.ropes)
        raise KeyError(f"no rope {name!r}; there is {names}")

    def anchor_named(self, name: str) -> Anchor:
        """The anchor of that name.

        Raises:
            KeyError: when there is none.
        """
        for anchor in self.anchors:
            if anchor.name == name:
                return anchor
        there = ", ".join(anchor.name for anchor in self.anchors) or "none"
        raise KeyError(f"no anchor {name!r}; there is {there}")

    def joint_named(self, name: str) -> Joint:
        """The joint of that name.

        Raises:
            KeyError: when there is none.
        """
        for joint in self.joints:
            if joint.name == name:
                return joint
        there = ", ".join(joint.name for joint in self.joints) or "none"
        raise KeyError(f"no joint {name!r}; there is {there}")

    def anchor_node(self, anchor: Anchor) -> int:
        """The node that an anchor of this scene holds, counted from 0 within its rope."""
        return self.rope_named(anchor.rope).node_index(anchor.node)

    def table(self) -> dict[str, Any]:
        """The scene as nested dicts and lists with TOML keys, defaults and obvious names left out."""
        table = super().table()
        if len(self.ropes) == 1:
            for part in (*table.get("anchor", ()), *table.get("winch", ())):
                del part["rope"]
        return table

    def as_said(self) -> dict[str, Any]:
        """See `Model.as_said`: without the method, where none is said."""
        table = self.table()
        if "method" not in self.run.model_fields_set:
            table.get("run", {}).pop("method", None)
        return table

    def view(
        self,
        *,
        folder: str | Path | None = None,
        open_browser: bool = True,
        playing: bool = True,
        port: int | None = None,
    ) -> View:
        """Play the scene live in the browser, or here in a notebook, and return the view.

        It plays by itself, as `ropewalk view` does.

        Args:
            folder: of a run to keep the session in.
            open_browser: open a browser at once (never in a notebook).
            playing: begin to play, or stand at time zero.
            port: of the server; by default one that is free.

        Raises:
            SceneError: when it cannot be planned.
            RunError: for the folder, and when the packages of ``ropewalk[view]`` are missing.
        """
        made = import_module(_VIEW).view_scene(
            self, folder=folder, open_browser=open_browser, playing=playing, port=port
        )
        return cast("View", made)

    @field_validator("schema_version")
    @classmethod
    def _check_version(cls, value: int) -> int:
        if value != SCHEMA_VERSION:
            rule = f"this version of ropewalk reads {SCHEMA_VERSION}"
            refuse([Fault("", value, rule)])
        return value

    @model_validator(mode="after")
    def _check(self) -> Scene:
        parts = self.ropes, self.anchors, self.winches
        refuse(
            [
                *scene_faults(self.gravity, *parts, self.limiter, self.joints),
                *_start_faults(self.run, self.ropes),
                *obstacle_faults(body.name for body in self.obstacles),
                *contact_faults(self.contact, self.ropes),
                *pair_faults(self.obstacles, self.contact, self.ropes),
                *slide_faults(self.slides, self.ropes, self.winches),
            ]
        )
        self._fill_in_names()
        self._fill_in_method()
        return self

    def _fill_in_method(self) -> None:
        """Give ropes of springs alone the method of their report where none is said."""
        if "method" in self.run.model_fields_set:
            return
        springs = all(isinstance(rope.made_of, Springs) for rope in self.ropes)
        method = (
            "semi-implicit-euler" if springs else "auto"
        )  # not said, so that `replace` asks anew
        if self.run.method != method:  # settings of another scene have it already
            run = self.run.model_copy()
            run.__dict__["method"] = method
            self.__dict__["run"] = run

    def _fill_in_names(self) -> None:
        """Give every part its name, and its rope's name where it has one."""
        rope = self.ropes[0].name
        anchors = tuple(
            _filled(anchor, name=f"anchor{i}", rope=rope) for i, anchor in enumerate(self.anchors)
        )
        winches = tuple(
            _filled(winch, name=f"winch{i}", rope=rope) for i, winch in enumerate(self.winches)
        )
        joints = tuple(_tied(joint, i, rope) for i, joint in enumerate(self.joints))
        obstacles = tuple(
            _filled(body, name=f"obstacle{i}") for i, body in enumerate(self.obstacles)
        )
        slides = tuple(
            _filled(slide, name=f"slide{i}", on=rope) for i, slide in enumerate(self.slides)
        )
        named = {"anchors": anchors, "winches": winches, "joints": joints, "obstacles": obstacles}
        self.__dict__.update(named | {"slides": slides})  # frozen for all else

    @classmethod
    def _more_faults(cls, data: Any, context: Any) -> list[Fault]:
        """Check across the parts that are right by themselves, when others are not."""
        if not isinstance(data, Mapping):
            return []
        ropes = [_part(Rope, item, context) for item in _items(data, "rope", "ropes")]
        anchors = [_part(Anchor, item, context) for item in _items(data, "anchor", "anchors")]
        winches = [_part(Winch, item, context) for item in _items(data, "winch", "winches")]
        joints = [_part(Joint, item, context) for item in _items(data, "joint", "joints")]
        slides = [_part(Slide, item, context) for item in _items(data, "slide", "slides")]
        bodies = [_body(item, context) for item in _items(data, "obstacle", "obstacles")]
        limiter = _part(Limiter, data.get("limiter"), context)
        contact = _part(Contact, data.get("contact"), context)
        return [
            *scene_faults(None, ropes, anchors, winches, limiter, joints),
            *obstacle_faults(None if body is None else body.name for body in bodies),
            *contact_faults(contact, ropes),
            *pair_faults(bodies, contact, ropes),
            *slide_faults(slides, ropes, winches),
        ]

    def __str__(self) -> str:
        run = self.run
        segments = sum(rope.segments for rope in self.ropes)
        ropes = f"{_count(len(self.ropes), 'rope')} of {_count(segments, 'segment')}"
        tied = f", {_count(len(self.joints), 'joint')}" if self.joints else ""
        tied += f", {_count(len(self.slides), 'slide')}" if self.slides else ""
        tied += f", {_count(len(self.obstacles), 'obstacle')}" if self.obstacles else ""
        how = f"{run.duration:g} s at {run.frame_rate:g} frames/s with {run.method}"
        return f"Scene {self.name!r}: {ropes}, {_count(len(self.anchors), 'anchor')}{tied}, {how}."

    __repr__ = __str__


def _start_faults(run: RunSettings, ropes: Sequence[Rope]) -> list[Fault]:
    """Velocities of a whole rope that starts at rest."""
    if run.start != "at-rest":
        return []
    rule = (
        'leave it out with run.start = "at-rest"; kicks and run.ring set a rope at rest in motion'
    )
    return [
        Fault(f"rope[{i}].shape.velocity", rope.shape.velocity, rule)
        for i, rope in enumerate(ropes)
        if any(rope.shape.velocity)
    ]


def _filled(part: _P, **defaults: str) -> _P:
    """A copy of a part with its empty names filled in."""
    empty = {key: value for key, value in defaults.items() if not getattr(part, key)}
    return part.model_copy(update=empty) if empty else part


def _tied(joint: Joint, number: int, rope: str) -> Joint:
    """A joint with its name and its ropes' names filled in."""
    points = tuple(_filled(tie, rope=rope) for tie in joint.points)
    return _filled(joint.model_copy(update={"points": points}), name=f"joint{number}")


def _part(kind: type[_P], item: Any, context: Any) -> _P | None:
    """A part of a faulty scene, or None when it is faulty itself."""
    try:
        return item if isinstance(item, kind) else kind.model_validate(item, context=context)
    except SceneError:
        return None


def _body(item: Any, context: Any) -> Obstacle | None:
    """An obstacle of a faulty scene, or None when it is faulty itself."""
    adapter: TypeAdapter[Obstacle] = TypeAdapter(Obstacle)
    try:
        return adapter.validate_python(item, context=context)
    except ValidationError:
        return None


def _items(data: Mapping[str, Any], toml: str, python: str) -> list[Any]:
    """The raw tables of a list in a faulty scene."""
    items = data.get(toml, data.get(python, ()))
    return list(items) if isinstance(items, (list, tuple)) else [items]


def _count(number: int, noun: str) -> str:
    """``1 segment``, ``2 segments``."""
    return f"{number} {noun}" + ("" if number == 1 else "s")
