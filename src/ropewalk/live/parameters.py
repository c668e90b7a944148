"""What can be changed while a simulation runs: names, units, ranges, and how each one is set.

A change goes through the scene's own validated models, so that every fault has the same words as in a file.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, get_args

from ropewalk.live import coulomb
from ropewalk.live.segments import most_segments, resegment, with_rope
from ropewalk.live.stiffness import (
    axial_stiffness,
    made_of,
    of_rope,
    set_axial_stiffness,
    set_spring_constant,
    spring_constant,
)
from ropewalk.methods.names import Method
from ropewalk.scene import Air, Fault, Ground, Scene, SceneError, Springs
from ropewalk.scene.limits import HUGE, TINY
from ropewalk.scene.rubbing import MOST_FRICTION

NUMBER, WHOLE, VECTOR, CHOICE, FLAG = "number", "whole", "vector", "choice", "flag"
ROPE, WORLD, AIR, GROUND, METHOD = "Rope", "World", "Air", "NeHe's ground", "Method"
TOUCH = "Contact"

BARRED = "is another law than contact in this scene; a firm floor is an obstacle of kind plane"
LONGEST_BASE = 50  # letters of a rope's name with which those of its pieces begin
_LARGEST = 1e300  # a whole number may be larger than any floating-point one

Get = Callable[[Scene, int], Any]
Put = Callable[[Scene, int, Any], Scene]


@dataclass(frozen=True)
class Parameter:
    """One thing to change. `get` and `put` take the rope's index, 0 where it is the whole scene's."""

    name: str
    label: str
    group: str
    unit: str
    kind: str
    help: str
    get: Get
    put: Put
    minimum: float | None = None
    maximum: float | None = None
    factor: float = 0.0  # of the slider's ends around the default; 0: linear
    low: float | None = None  # of a linear slider
    high: float | None = None
    choices: Callable[[], list[dict[str, str]]] | None = None
    bars: Callable[[Scene], str] | None = None  # why a scene has no such number

    def barred(self, loaded: Scene) -> str:
        """Return why it is not there for a scene; empty where it is."""
        if self.bars:
            return self.bars(loaded)
        firm = loaded.obstacles or loaded.contact
        return BARRED if self.group == GROUND and firm and loaded.ground is None else ""

    @property
    def per_rope(self) -> bool:
        """Whether ropes may differ in it."""
        return self.group == ROPE

    def apply(self, scene: Scene, value: Any, rope: str | None = None) -> Scene:
        """Return the scene with the value set, for one rope or all.

        Raises SceneError with the allowed range.
        """
        value = self.checked(value)
        for index in self.ropes(scene, rope):
            scene = self.put(scene, index, value)
        return scene

    def ropes(self, scene: Scene, rope: str | None) -> list[int]:
        """Return the indices of the ropes meant. Raises SceneError for an unknown name."""
        if not self.per_rope:
            return [0]
        names = [one.name for one in scene.ropes]
        if rope is None:
            return list(range(len(names)))
        if rope not in names:
            raise refusal("rope", rope, f"no such rope; there is {', '.join(names)}")
        return [names.index(rope)]

    def checked(self, value: Any) -> Any:
        """Return the value in the type that the scene wants. Raises SceneError."""
        if self.kind == VECTOR:
            numbers = value if isinstance(value, (list, tuple)) and len(value) == 3 else None
            if numbers is None or not all(_is_number(one) for one in numbers):
                raise refusal(self.name, value, f"must be three finite numbers [{self.unit}]")
            return tuple(self._in_range(float(one), value) for one in numbers)
        if self.kind == FLAG:
            if not isinstance(value, bool):
                raise refusal(self.name, value, "must be true or false")
            return value
        if self.kind == CHOICE:
            allowed = [choice["value"] for choice in self.choices()] if self.choices else []
            if value not in allowed:
                rule = "must be one of " + ", ".join(f'"{one}"' for one in allowed)
                raise refusal(self.name, value, rule)
            return value
        if not _is_number(value) or (self.kind == WHOLE and value != int(value)):
            what = "a whole number" if self.kind == WHOLE else "a finite number"
            raise refusal(self.name, value, f"must be {what}{self._range()}")
        return self._in_range(int(value) if self.kind == WHOLE else float(value), value)

    def _in_range(self, number: Any, given: Any) -> Any:
        low, high = self.minimum, self.maximum
        if low is not None and 0.0 <= low <= TINY and number < low and number <= 0.0:
            raise refusal(self.name, given, "must be positive" if low else "must not be negative")
        if (low is not None and number < low) or (high is not None and number > high):
            raise refusal(self.name, given, f"must be{self._range()}")
        return number

    def _range(self) -> str:
        unit = f" {self.unit}" if self.unit not in ("", "1") else ""
        low, high = self.minimum, self.maximum
        return f" from {low:g} to {high:g}{unit}" if low is not None and high is not None else ""

    def slider(self, default: Any) -> tuple[float | None, float | None, str]:
        """Return the sensible range about a default, and its scale."""
        if self.kind == VECTOR:
            size = max((abs(one) for one in default), default=0.0)
            reach = max(2.0 * size, self.high or 1.0)
            return -reach, reach, "linear"
        if self.kind not in (NUMBER, WHOLE):
            return None, None, "linear"
        low, high = self.minimum or 0.0, self.maximum or HUGE
        if default == math.inf:  # of rigid links, which nothing changes
            default = None
        if self.factor and isinstance(default, (int, float)) and default > 0.0:
            ends = max(default / self.factor, low), min(default * self.factor, high)
            return float(ends[0]), float(ends[1]), "log"
        reach = max(2.0 * abs(default or 0.0), self.high or 1.0)
        return (self.low if self.low is not None else max(low, 0.0)), min(reach, high), "linear"


def refusal(path: str, value: Any, rule: str) -> SceneError:
    """Return the error for one value that cannot be taken."""
    return SceneError([Fault(path, value, rule)])


def _is_number(value: Any) -> bool:
    number = isinstance(value, (int, float)) and not isinstance(value, bool)
    return number and abs(value) < _LARGEST


def _set_friction(scene: Scene, index: int, value: float) -> Scene:
    rope = scene.ropes[index]
    if isinstance(rope.made_of, Springs):
        return made_of(scene, index, spring_friction=value)
    return made_of(scene, index, axial_damping=value * rope.segment_length)


def _set_mass(scene: Scene, index: int, value: float) -> Scene:
    rope = scene.ropes[index]
    if isinstance(rope.made_of, Springs):
        return made_of(scene, index, node_mass=value / rope.nodes)
    return made_of(scene, index, mass_per_length=value / rope.length_unstretched)


def _set_length(scene: Scene, index: int, value: float) -> Scene:
    rope = scene.ropes[index]
    if isinstance(rope.made_of, Springs):
        return made_of(scene, index, segment_length=value / rope.segments)
    return with_rope(scene, index, rope.replace(length=value))


def _rope_value(name: str) -> Get:
    return lambda scene, index: getattr(scene.ropes[index], name)


def _stuff(name: str) -> Get:
    return lambda scene, index: getattr(scene.ropes[index].made_of, name)


def _set_stuff(name: str) -> Put:
    return lambda scene, index, value: made_of(scene, index, **{name: value})


def _set_rope(name: str) -> Put:
    def put(scene: Scene, index: int, value: Any) -> Scene:
        return with_rope(scene, index, scene.ropes[index].replace(**{name: value}))

    return put


def _air(name: str) -> tuple[Get, Put]:
    def put(scene: Scene, _: int, value: Any) -> Scene:
        return scene.replace(air=(scene.air or Air()).replace(**{name: value}))

    return (lambda scene, _: getattr(scene.air or Air(), name)), put


def _ground(name: str) -> tuple[Get, Put]:
    def put(scene: Scene, _: int, value: Any) -> Scene:
        return scene.replace(ground=(scene.ground or Ground()).replace(**{name: value}))

    return (lambda scene, _: getattr(scene.ground or Ground(), name)), put


def _set_ground(scene: Scene, _: int, value: bool) -> Scene:
    return scene.replace(ground=(scene.ground or Ground()) if value else None)


def _run(name: str) -> tuple[Get, Put]:
    def put(scene: Scene, _: int, value: Any) -> Scene:
        return scene.replace(run=scene.run.replace(**{name: value}))

    return (lambda scene, _: getattr(scene.run, name)), put


def _set_step(scene: Scene, _: int, value: float) -> Scene:
    return scene.replace(run=scene.run.replace(time_step=value, steps="exact"))


def _get_count(scene: Scene, _: int) -> int:
    step = scene.run.time_step
    return max(1, round(scene.run.frame_interval / step)) if isinstance(step, float) else 1


def _set_count(scene: Scene, index: int, value: int) -> Scene:
    return _set_step(scene, index, scene.run.frame_interval / value)


def _forms() -> list[dict[str, str]]:
    return [
        {"value": "vector", "label": "vector: against all relative motion"},
        {"value": "axial", "label": "axial: only along the segment"},
    ]


def _methods() -> list[dict[str, str]]:
    from ropewalk.methods.registry import METHODS

    known = get_args(Method)
    return [
        {"value": method.name, "label": method.name, "help": method.summary}
        for method in METHODS.values()
        if method.name in known
    ]


def _positive(factor: float, **more: Any) -> dict[str, Any]:
    return {"minimum": TINY, "maximum": HUGE, "factor": factor} | more


def _from_zero(high: float, **more: Any) -> dict[str, Any]:
    return {"minimum": 0.0, "maximum": HUGE, "high": high, "low": 0.0} | more


def _anything(low: float, high: float) -> dict[str, Any]:
    return {"minimum": -HUGE, "maximum": HUGE, "low": low, "high": high}


_TABLE = (
    Parameter(
        "spring_constant", "Spring constant", ROPE, "N/m", NUMBER, "Stiffness of each segment",
        of_rope(spring_constant), set_spring_constant, **_positive(100.0),
    ),
    Parameter(
        "EA", "Axial stiffness EA", ROPE, "N", NUMBER, "Tension per strain, however many segments it has",
        of_rope(axial_stiffness), set_axial_stiffness, **_positive(100.0),
    ),
    Parameter(
        "spring_friction", "Damping", ROPE, "N s/m", NUMBER,
        "In each segment: slows its two ends against each other",
        _rope_value("segment_friction"), _set_friction, **_from_zero(1.0),
    ),
    Parameter(
        "friction_form", "Damping's form", ROPE, "", CHOICE,
        "Vector damping also damps turning; axial damping keeps angular momentum",
        _stuff("friction"), _set_stuff("friction"), choices=_forms,
    ),
    Parameter(
        "mass", "Mass", ROPE, "kg", NUMBER, "Mass of the rope, without loads",
        _rope_value("own_mass"), _set_mass, **_positive(20.0),
    ),
    Parameter(
        "length", "Length", ROPE, "m", NUMBER,
        "Unstretched length. Springs keep their mass, a material its mass per length",
        _rope_value("length_unstretched"), _set_length, **_positive(3.0),
    ),
    Parameter(
        "segments", "Segments", ROPE, "1", WHOLE,
        "How finely the rope is cut; it stays the same rope: same length, mass and EA",
        _rope_value("segments"), resegment, minimum=1, maximum=most_segments(), factor=8.0,
    ),
    Parameter(
        "diameter", "Diameter", ROPE, "m", NUMBER,
        "How thick it is: contact with bodies and ropes, and drag by the air's density, go by it",
        _rope_value("diameter"), _set_rope("diameter"), **_positive(20.0),
    ),
    Parameter(
        "tension_only", "Goes slack", ROPE, "", FLAG,
        "A segment shorter than its rest length goes slack instead of pushing",
        _stuff("tension_only"), _set_stuff("tension_only"),
    ),
    Parameter(
        "obstacle_friction", "Friction μ on obstacles", TOUCH, "1", NUMBER,
        "Coulomb's coefficient of ropes on all obstacles: they hold up to μ times what presses them",
        coulomb.of_obstacles, coulomb.set_of_obstacles, bars=coulomb.bar_obstacles,
        minimum=0.0, maximum=MOST_FRICTION, high=1.0, low=0.0,
    ),
    Parameter(
        "contact_friction", "Friction μ of ropes", TOUCH, "1", NUMBER,
        "Coulomb's coefficient of rope on rope: they hold up to μ times what presses them together",
        coulomb.of_contact, coulomb.set_of_contact, bars=coulomb.bar_contact,
        minimum=0.0, maximum=MOST_FRICTION, high=1.0, low=0.0,
    ),
    Parameter(
        "gravity", "Gravity", WORLD, "m/s^2", VECTOR, "Up is against it",
        lambda scene, _: tuple(scene.gravity),
        lambda scene, _, value: scene.replace(gravity=value), **_anything(-20.0, 20.0),
    ),
    Parameter(
        "air_drag", "Drag, linear", AIR, "N s/m", NUMBER, "Force per speed on every node",
        *_air("node_drag"), **_from_zero(0.1),
    ),
    Parameter(
        "air_drag_quadratic", "Drag, quadratic", AIR, "N s^2/m^2", NUMBER,
        "Force per square of the speed on every node",
        *_air("node_drag_quadratic"), **_from_zero(0.1),
    ),
    Parameter(
        "air_density", "Density of the air", AIR, "kg/m^3", NUMBER,
        "For drag on the segments by the rope's diameter; 1.2 at sea level, 1000 is water",
        *_air("density"), **_from_zero(2.0),
    ),
    Parameter(
        "wind", "Wind", AIR, "m/s", VECTOR, "Velocity of the air; it needs a drag to be felt",
        *_air("wind"), **_anything(-20.0, 20.0),
    ),
    Parameter(
        "ground", "Yielding ground", GROUND, "", FLAG,
        "The floor of NeHe's lesson 40: it pushes like a spring, and its friction does not know the load",
        lambda scene, _: scene.ground is not None, _set_ground,
    ),
    Parameter(
        "ground_height", "Height", GROUND, "m", NUMBER, "How high it is, measured upwards from zero",
        *_ground("height"), **_anything(-20.0, 20.0),
    ),
    Parameter(
        "ground_repulsion", "Repulsion", GROUND, "N/m", NUMBER, "Force per depth on a node below",
        *_ground("repulsion"), **_positive(100.0),
    ),
    Parameter(
        "ground_friction", "Friction", GROUND, "N s/m", NUMBER, "Against sliding, for each node",
        *_ground("friction"), **_from_zero(1.0),
    ),
    Parameter(
        "ground_absorption", "Absorption", GROUND, "N s/m", NUMBER, "Friction on the way in",
        *_ground("absorption"), **_from_zero(5.0),
    ),
    Parameter(
        "method", "Method", METHOD, "", CHOICE, "How each step is computed",
        *_run("method"), choices=_methods,
    ),
    Parameter(
        "time_step", "Time step", METHOD, "s", NUMBER, "Length of a step",
        lambda scene, _: scene.run.time_step, _set_step,
        minimum=1e-9, maximum=1.0, factor=30.0,
    ),
    Parameter(
        "steps_per_frame", "Steps per frame", METHOD, "1", WHOLE,
        "So many steps for each picture of a run; this sets the time step",
        _get_count, _set_count, minimum=1, maximum=1_000_000, factor=30.0,
    ),
)  # fmt: skip

PARAMETERS = {parameter.name: parameter for parameter in _TABLE}


def named(name: str) -> Parameter:
    """Return a parameter. Raises SceneError for an unknown name."""
    if name not in PARAMETERS:
        from ropewalk.words.nearest import nearest

        raise refusal(name, name, f"no such parameter; {nearest(name, list(PARAMETERS))}")
    return PARAMETERS[name]


def initial(loaded: Scene, changes: Mapping[tuple[str, str | None], Any]) -> Scene:
    """Return a scene as loaded, with changed constants.

    Raises SceneError when they do not fit its shape at time zero.
    """
    for (name, rope), value in changes.items():
        loaded = named(name).apply(loaded, value, rope)
    return loaded
