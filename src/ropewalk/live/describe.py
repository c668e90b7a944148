"""The messages that describe a session to a page: layout, parameters, presets."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import cache
from typing import Any

import numpy as np

from ropewalk.analysis.json_values import plain
from ropewalk.core.arrays import Floats
from ropewalk.live.changes import loaded_value, origin
from ropewalk.live.edits import CutEnd
from ropewalk.live.frame import HEADER, SCALARS
from ropewalk.live.gaps import gaps, told
from ropewalk.live.parameters import GROUND, PARAMETERS, ROPE, Parameter
from ropewalk.live.pictures import shape_of
from ropewalk.live.session import Session
from ropewalk.live.solids import joint_list, obstacle_list
from ropewalk.live.sources import START
from ropewalk.live.themes import menu, title
from ropewalk.live.track import RIGID_FIXED, WITH_LINKS, Track
from ropewalk.live.wound_ropes import WHILE_WOUND, WOUND_FIXED, is_wound
from ropewalk.lowering import Layout, Span
from ropewalk.record.margins import breaking_load
from ropewalk.scene import Air, Rope, Scene, SceneError, Springs
from ropewalk.scene.guess import guesses_of
from ropewalk.scene.presets import preset

FIRST_LEVEL = (
    "spring_friction",
    "mass",
    "length",
    "obstacle_friction",
    "contact_friction",
    "gravity",
)


def layout(session: Session) -> dict[str, Any]:
    """Return the `layout` message of a session as it is now."""
    place, variants = HEADER.size, []
    colors = _colors(session)
    for track in session.tracks:
        places, place = shape_of(track).places(place)
        variants.append(_variant(track, places._asdict(), colors))
    scene = session.scene
    center, radius = view_box(session.main.simulation.positions, scene)
    ground = None if scene.ground is None else {"height": scene.ground.height}
    return {
        "type": "layout",
        "layout": 0,
        "bytes": place,
        "scene": {
            "name": scene.name,
            "description": scene.description,
            "preset": session.preset,
        },
        "up": list(scene.up),
        "gravity": list(scene.gravity),
        "ground": ground,
        "view": {"center": center, "radius": radius},
        "obstacles": obstacles(session),
        "scalars": list(SCALARS),
        "variants": variants,
    }


def obstacles(session: Session) -> list[dict[str, Any]]:
    """Return the obstacles of a session, with the motions that hands have given them."""
    simulation = session.main.simulation
    return obstacle_list(session.scene, simulation.layout, simulation.bodies)


def written(layout: dict[str, Any]) -> Any:
    """Return what decides how frames are written and drawn, of a layout message."""
    return [
        (
            one["nodes"],
            len(one["anchors"]),
            [(rope["name"], rope["first"], rope["nodes"]) for rope in one["ropes"]],
            one["joints"],
        )
        for one in layout["variants"]
    ]


def view_box(positions: Floats, scene: Scene) -> tuple[list[float], float]:
    """Return middle and radius [m] of a view that shows ropes, also when they swing."""
    low, high = positions.min(axis=0), positions.max(axis=0)
    longest = max(rope.length_unstretched for rope in scene.ropes)
    radius = max(0.5 * float(np.linalg.norm(high - low)), 0.5 * longest, 1e-3)
    return [float(value) for value in 0.5 * (low + high)], radius


def _colors(session: Session) -> dict[str, int]:
    """A number for every rope, the same for both halves of a cut one."""
    ropes = session.main.scene.ropes
    return {rope.name: origin(session.loaded, rope.name) or 0 for rope in ropes}


def _variant(track: Track, offsets: dict[str, int], colors: dict[str, int]) -> dict[str, Any]:
    scene, where = track.scene, track.simulation.layout
    return {
        "label": track.label,
        "method": track.simulation.plan.method,
        "changes": plain(track.changes),
        "nodes": where.nodes,
        "ropes": rope_list(scene, where.ropes, colors),
        "anchors": anchor_list(scene, where),
        "loads": load_list(scene, where),
        "forces": force_list(scene, where),
        "joints": joint_list(scene, where),
        **told(track.parted, gaps(track.simulation)),
        "surfaces": list(where.surfaces),
        "offsets": offsets,
    }


def rope_list(scene: Scene, spans: Sequence[Span], colors: dict[str, int]) -> list[dict[str, Any]]:
    """Return the ropes of a layout message."""
    return [
        {
            "name": rope.name,
            "first": span.first,
            "nodes": span.nodes,
            "zero": span.start,
            "segments": rope.segments,
            "length": rope.length_unstretched,
            "breaking_load": breaking_load(rope),
            "least_load": None if mark is None else mark.low,
            "EA": plain(rope.segment_stiffness * rope.segment_length or None),
            "diameter": rope.diameter,
            "mass": rope.total_mass,
            "submerged_weight": rope.submerged_weight,
            "color": colors.get(rope.name, number),
        }
        for number, (rope, span) in enumerate(zip(scene.ropes, spans, strict=True))
        for mark in (guesses_of(rope.made_of).get("breaking_load"),)
    ]


def anchor_list(scene: Scene, where: Layout) -> list[dict[str, Any]]:
    """Return the anchors of a layout message."""
    return [
        {
            "name": anchor.name,
            "rope": anchor.rope,
            "node": scene.anchor_node(anchor),
            "index": where.node(scene.anchor_node(anchor), anchor.rope),
            "motion": anchor.motion.kind,
            "pinned": anchor.name.startswith(("pin", "tie")) and anchor.motion.kind == "hand",
        }
        for anchor in scene.anchors
    ]


def load_list(scene: Scene, where: Layout) -> list[dict[str, Any]]:
    """Return the loads of a layout message: what hangs on ropes, not what is their own."""
    return [
        {
            "rope": rope.name,
            "node": rope.node_index(load.node),
            "index": where.node(load.node, rope.name),
            "mass": load.mass,
        }
        for rope in scene.ropes
        for load in rope.loads
        if not isinstance(load, CutEnd)
    ]


def force_list(scene: Scene, where: Layout) -> list[dict[str, Any]]:
    """Return the constant forces of a layout message."""
    return [
        {"index": where.node(one.node, rope.name), "force": list(one.force)}
        for rope in scene.ropes
        for one in rope.forces
    ]


def parameters(session: Session) -> dict[str, Any]:
    """Return the `parameters` message."""
    there = [one for one in PARAMETERS.values() if not one.barred(session.loaded)]
    found = [_parameter(session, one) for one in there]
    return {"type": "parameters", "parameters": found}


def _first_level(scene: Scene) -> set[str]:
    """Return the parameters that everybody asks for, with the stiffness as the ropes have it."""
    springs = any(isinstance(rope.made_of, Springs) for rope in scene.ropes)
    return {"spring_constant" if springs else "EA", *FIRST_LEVEL}


def _parameter(session: Session, parameter: Parameter) -> dict[str, Any]:
    scene, loaded = session.scene, session.loaded
    values = {
        scene.ropes[i].name: plain(parameter.get(scene, i)) for i in parameter.ropes(scene, None)
    }
    distinct = {repr(value) for value in values.values()}
    value = next(iter(values.values())) if len(distinct) == 1 else None
    default = parameter.get(loaded, 0)
    low, high, scale = parameter.slider(default)
    why = ""
    if parameter.name in WOUND_FIXED and all(is_wound(scene, rope.name) for rope in scene.ropes):
        why = f"cannot be changed {WHILE_WOUND}"
    elif parameter.name in RIGID_FIXED and any(rope.rigid for rope in scene.ropes):
        why = f"cannot be changed {WITH_LINKS}"
    elif parameter.name == "EA" and value is None and len(distinct) == 1:
        why = "springs of no length have none"
    else:
        why = _idle(parameter, scene)
    about = {
        "name": parameter.name,
        "label": parameter.label,
        "group": parameter.group,
        "more": parameter.name not in _first_level(scene),
        "unit": parameter.unit,
        "kind": parameter.kind,
        "help": parameter.help,
        "value": value,
        "default": plain(default),
        "defaults": _defaults(parameter, loaded, values) if len(values) > 1 else None,
        "low": low,
        "high": high,
        "scale": scale,
        "minimum": parameter.minimum,
        "maximum": parameter.maximum,
        "choices": parameter.choices() if parameter.choices else None,
        "values": values if parameter.group == ROPE and len(values) > 1 else None,
        "enabled": not why,
        "why": why,
    }
    return about | {"value": plain(about["value"])}


def _defaults(parameter: Parameter, loaded: Scene, ropes: Iterable[str]) -> dict[str, Any]:
    """Return the value of each rope in the scene as loaded; None for a piece that has none there."""
    found: dict[str, Any] = {}
    for rope in ropes:
        try:
            found[rope] = plain(loaded_value(parameter, loaded, rope))
        except SceneError:
            found[rope] = None
    return found


def _loses_by_relaxing(rope: Rope) -> bool:
    return rope.relaxes and bool(rope.made_of.tension_only)


def _idle(parameter: Parameter, scene: Scene) -> str:
    """Return why a change would not be felt, or not taken; empty where it would."""
    if parameter.name == "spring_friction" and any(map(_loses_by_relaxing, scene.ropes)):
        return "a rope that relaxes and goes slack loses by its relaxation alone"
    if parameter.group == GROUND and parameter.name != "ground" and scene.ground is None:
        return "has no effect while the yielding ground is off"
    air = scene.air or Air()
    if parameter.name == "wind" and not air.drags:
        return "is not felt without air: give a drag or a density first"
    return ""


def presets(session: Session) -> dict[str, Any]:
    """Return the `presets` message."""
    found = []
    scene, name = session.start
    if name is None:
        found.append(_preset(START, scene, "The scene of this program"))
    return {"type": "presets", "presets": found + built_in()}


@cache
def built_in() -> list[dict[str, str]]:
    """Return the presets of the program; read once, which takes longer than a tick may."""
    return [_preset(one.name, preset(one.name), one.theme) for one in menu()]


def _preset(name: str, scene: Scene, theme: str) -> dict[str, str]:
    return {
        "name": name,
        "title": title(scene.name),
        "theme": theme,
        "sentence": scene.description,
        "picture": f"presets/{name}.svg",
    }
