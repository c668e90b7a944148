"""Scenes that must move alike: turned, mirrored, shifted; in other units; from the other end; carried along.

Each relation is a map of scenes and one of what is recorded. Only what was given is mapped, and
what is no number by default: shapes become points first.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ropewalk.record.quantities import BY_NAME
from ropewalk.record.result import Result
from ropewalk.scene import Anchor, Points, RunSettings, Scene, Slide, Velocity, Winch
from ropewalk.scene.base import Model

Floats = NDArray[np.float64]
Record = dict[str, Floats]
Change = Callable[[Model, str, Any], Any]

# Vectors by model and field: places, arrows, and axes about which something turns right-handed.
PLACES = {
    *(("Points", "points"), ("Table", "positions"), ("Orbit", "center"), ("Plane", "point")),
    *(("Sphere", "center"), ("Torus", "center"), ("Spin", "pivot"), ("Spin", "center_of_mass")),
    *((kind, end) for kind in ("Cylinder", "Capsule", "HalfPipe") for end in ("start", "end")),
}
ARROWS = {
    *(("Points", "velocity"), ("Velocity", "velocity"), ("Kick", "velocity"), ("Force", "force")),
    *(("Air", "wind"), ("Scene", "gravity"), ("Clamp", "direction"), ("Plane", "normal")),
    *(("HalfPipe", "open_to"), ("Shake", "axis")),
}
AXES = {
    *(("Clamp", "turn_axis"), ("Orbit", "axis"), ("Spin", "axis"), ("Material", "curvature")),
    *(("Sphere", "axis"), ("Torus", "axis")),
}
#: Exponents of metre, second and kilogram in a unit.
POWERS = {
    "m": (1, 0, 0),
    "s": (0, 1, 0),
    "kg": (0, 0, 1),
    "N": (1, -2, 1),
    "J": (2, -2, 1),
    "Hz": (0, -1, 0),
    "rad": (0, 0, 0),
    "1": (0, 0, 0),
}
#: What has several units, or says where and when.
_MIXED = {"extreme_places", "extreme_since", "extreme_until", "energy_error_times", "rope_contacts"}
_OF_THE_FRAME = {  # depend on how fast all moves, or on where the origin is
    *("energy", "work", "jump", "contact_work", "energy_errors", "momentum", "angular_momentum"),
    *("greatest_speed", "greatest_height", "least_height"),
}


def given(model: Any, **changes: Any) -> Any:
    """Return the model with all that was given, and changes."""
    return type(model)(**{name: getattr(model, name) for name in model.model_fields_set} | changes)


def as_points(scene: Scene) -> Scene:
    """Return the scene with shapes as the points that they are, gravity and speeds given."""
    ropes = []
    for rope in scene.ropes:
        size = rope.segments, rope.length_unstretched, rope.segment_length
        places = rope.shape.places(*size, scene.up, rope.diameter)
        shape = Points(points=places.tolist(), velocity=rope.shape.velocity)
        ropes.append(given(rope, shape=shape))
    return Scene(**vars_of(scene) | {"ropes": ropes, "gravity": scene.gravity})


def vars_of(scene: Scene) -> dict[str, Any]:
    """Return all parts of a scene by name."""
    return {name: getattr(scene, name) for name in scene.model_fields_set}


def changed(model: Any, change: Change) -> Any:
    """Return the model with `change` of every value that was given, from the leaves up."""
    data = {}
    for name in model.model_fields_set:
        value = getattr(model, name)
        if isinstance(value, Model):
            data[name] = changed(value, change)
        elif isinstance(value, tuple) and value and isinstance(value[0], Model):
            data[name] = tuple(changed(item, change) for item in value)
        else:
            data[name] = change(model, name, value)
    return type(model)(**data)


def turned(scene: Scene, turn: Floats, shift: Floats) -> Scene:
    """Return the scene turned (mirrored where `turn` is a mirror's) and shifted [m]."""
    scene, sign = as_points(scene), round(float(np.linalg.det(turn)))
    rise = float(turn @ np.array(scene.up) @ shift)

    def change(model: Model, name: str, value: Any) -> Any:
        key = type(model).__name__, name
        if key in PLACES:
            return (np.array(value) @ turn.T + shift).tolist()
        if key in ARROWS or key in AXES:
            return ((sign if key in AXES else 1) * (np.array(value) @ turn.T)).tolist()
        return value + rise if key == ("Ground", "height") else value

    found: Scene = changed(scene, change)
    return found


def turned_record(record: Record, turn: Floats, shift: Floats, up: Sequence[float]) -> Record:
    """Return what must be recorded of a scene turned so."""
    sign, rise = round(float(np.linalg.det(turn))), float(turn @ np.array(up) @ shift)
    found = {}
    for name, values in record.items():
        if name == "positions":
            found[name] = values @ turn.T + shift
        elif name == "angular_momentum":
            found[name] = sign * (values @ turn.T) + np.cross(shift, record["momentum"] @ turn.T)
        elif BY_NAME[name].dims[-1] == "axis":
            found[name] = (sign if name == "moments" else 1) * (values @ turn.T)
        else:
            found[name] = values + rise if name.endswith("_height") else values
    return found


def factor(unit: str, sizes: Sequence[float]) -> float:
    """Return how much larger a number of this unit is where metre, second and kilogram are `sizes`."""
    powers, (over, *under) = np.zeros(3), unit.split("/")
    for sign, part in [(1, over), *((-1, part) for part in under)]:
        for word in part.split():
            base, _, power = word.partition("^")
            powers += sign * int(power or 1) * np.array(POWERS[base])
    return float(np.prod(np.array(sizes) ** powers))


def in_units(scene: Scene, sizes: Sequence[float]) -> Scene:
    """Return the scene with all lengths, times and masses so many times as large."""

    def change(model: Model, name: str, value: Any) -> Any:
        extra = type(model).model_fields[name].json_schema_extra
        unit = str(extra.get("unit", "1")) if isinstance(extra, dict) else "1"
        if unit == "1" or value is None or isinstance(value, str | int):
            return value
        return (factor(unit, sizes) * np.array(value)).tolist()

    found: Scene = changed(as_points(scene), change)
    run = found.run
    if "tolerance" not in run.model_fields_set:
        run = RunSettings(**run.model_dump() | {"tolerance": run.tolerance * sizes[0]})
    return Scene(**vars_of(found) | {"run": run})


def record_in_units(record: Record, sizes: Sequence[float]) -> Record:
    """Return what must be recorded in such units."""
    return {name: factor(BY_NAME[name].unit, sizes) * values for name, values in record.items()}


def from_the_other_end(scene: Scene, number: int) -> Scene:
    """Return the scene with a rope numbered from its other end."""
    scene = as_points(scene)
    rope = scene.ropes[number]

    def back(item: Any) -> Any:
        return given(item, node=rope.segments - item.node % rope.nodes)

    def swapped(part: Any) -> Any:
        if isinstance(part, Slide) and part.on == rope.name and part.at is not None:
            return given(part, at=rope.length_unstretched - part.at)
        if part.rope != rope.name:
            return part
        if isinstance(part, Winch):
            return given(part, end={"start": "end", "end": "start"}[part.end])
        if isinstance(part, Anchor) and part.clamp is not None:
            way = tuple(-x for x in part.clamp.direction)
            part = given(part, clamp=given(part.clamp, direction=way))
        return back(part)

    lists = {
        name: [back(item) for item in getattr(rope, name)] for name in ("loads", "kicks", "forces")
    }
    ropes = list(scene.ropes)
    ropes[number] = given(
        rope, shape=Points(points=rope.shape.points[::-1], velocity=rope.shape.velocity), **lists
    )
    joints = [given(one, points=[swapped(tie) for tie in one.points]) for one in scene.joints]
    parts = {
        name: [swapped(part) for part in getattr(scene, name)]
        for name in ("anchors", "slides", "winches")
    }
    return Scene(**vars_of(scene) | parts | {"ropes": ropes, "joints": joints})


def back_again(record: Record, first: int, last: int) -> Record:
    """Return what was recorded of such a scene, the rope's nodes `first` to `last` in their old order."""
    found = dict(record)
    for name, values in record.items():
        dims = BY_NAME[name].dims
        end = last + 1 if "node" in dims else last if "segment" in dims else first
        found[name] = values.copy()
        found[name][:, first:end] = values[:, first:end][:, ::-1]
    return found


def carried(scene: Scene, velocity: Floats) -> Scene:
    """Return the scene, anchors and obstacles at rest in it, led along at a velocity [m/s], with the air."""

    def change(model: Model, name: str, value: Any) -> Any:
        key = type(model).__name__, name
        moves = {("Points", "velocity"), ("Kick", "velocity"), ("Air", "wind")}
        return (np.array(value) + velocity).tolist() if key in moves else value

    led = Velocity(velocity=velocity.tolist())
    found = changed(as_points(scene), change)
    parts = {
        name: [given(one, motion=led) for one in getattr(found, name)]
        for name in ("anchors", "obstacles")
    }
    air = found.air and given(found.air, wind=tuple(np.array(scene.air.wind) + velocity))  # type: ignore[union-attr]
    return Scene(**vars_of(found) | parts | {"air": air})


def carried_record(record: Record, time: Floats, velocity: Floats) -> Record:
    """Return what must be recorded of a scene carried so, but what depends on the frame of reference."""
    found = {name: values for name, values in record.items() if name not in _OF_THE_FRAME}
    found["positions"] = record["positions"] + time[:, None, None] * velocity
    found["velocities"] = record["velocities"] + velocity
    return found


def recorded(result: Result) -> Record:
    """Return all that has one unit, by name."""
    names = (name for name in result.source.names if name not in _MIXED and name != "time")
    return {name: np.array(result.read(name)) for name in names if "," not in BY_NAME[name].unit}


def difference(wanted: Record, got: Record) -> dict[str, float]:
    """Return by name by how much they differ, over the largest number of that unit."""
    largest: dict[str, float] = {}
    for name, values in wanted.items():
        unit = BY_NAME[name].unit
        largest[unit] = max(largest.get(unit, 0.0), _largest(values))
    return {
        name: _largest(_apart(values, got[name])) / (largest[BY_NAME[name].unit] or 1.0)
        for name, values in wanted.items()
    }


def _apart(wanted: Floats, got: Floats) -> Floats:
    """Return how far numbers are apart; what is missing in one alone is infinitely far."""
    missing = np.isnan(wanted), np.isnan(got)
    far = np.where(missing[0] != missing[1], np.inf, np.abs(wanted - got))
    return np.where(missing[0] & missing[1], 0.0, far)


def _largest(values: Floats) -> float:
    return float(np.nan_to_num(np.abs(values), posinf=np.inf).max(initial=0.0))
