"""Scenes that have two features at once, for the test that all pairs compose."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

from ropewalk.scene import (
    Air,
    Anchor,
    Clamp,
    Contact,
    Force,
    Ground,
    Joint,
    Kick,
    Limiter,
    Load,
    Material,
    Plane,
    Rope,
    RunSettings,
    Scene,
    Shake,
    Slack,
    Slide,
    Spin,
    Springs,
    Straight,
    TableCurve,
    Tie,
    Winch,
)

Parts = dict[str, dict[str, Any]]
SOFT = {"EA": 2000.0, "mass_per_length": 0.2, "axial_damping": 0.2, "friction": "vector"}
STEP = {"euler": 2.5e-5, "adaptive": "auto"}  # [s]; explicit Euler gains energy in longer ones


def _rigid(parts: Parts) -> None:
    parts["stuff"]["EA"] = math.inf


def _curve(parts: Parts) -> None:
    curve = TableCurve(strain=(0.0005, 0.001, 0.01), tension=(0.4, 1.5, 20.0))
    parts["stuff"]["curve"] = curve
    if parts["stuff"]["EA"] < math.inf:
        del parts["stuff"]["EA"]


def _relaxation(parts: Parts) -> None:
    parts["stuff"] |= {"relaxing_EA": 3000.0, "relaxation_time": 0.01}


def _winch(parts: Parts) -> None:
    parts["scene"]["winches"] = [Winch(rope="one", end="start", speed=0.1)]


def _hauling(parts: Parts) -> None:
    parts["scene"]["winches"] = [Winch(rope="one", end="start", speed=-0.5)]


def _limiter(parts: Parts) -> None:
    parts["scene"]["limiter"] = Limiter(max_stretch=1.0001)


def _bending(parts: Parts) -> None:
    parts["stuff"]["EI"] = 0.02


def _clamp(parts: Parts) -> None:
    _bending(parts)
    parts["held"]["clamp"] = Clamp(direction=(1, 0, 0))


def _air(parts: Parts) -> None:
    parts["scene"]["air"] = Air(node_drag=0.05)


def _ground(parts: Parts) -> None:
    parts["scene"]["ground"] = Ground(height=-0.18)


def _one_way(parts: Parts) -> None:
    parts["stuff"]["tension_only"] = True


def _axial(parts: Parts) -> None:
    parts["stuff"] |= {"axial_damping": 1.0, "friction": "axial"}


def _joint(parts: Parts) -> None:
    two = {
        "name": "two",
        "segments": 3,
        "length": 0.3,
        "diameter": 0.01,
        "made_of": Material(**SOFT),
    }
    hung = Straight(start=(0.9, 0, 0), direction=(0, 0, -1))
    parts["scene"].setdefault("ropes", []).append(Rope(**two, shape=hung))
    tied = [Tie(rope="one", node=-1), Tie(rope="two", node=0)]
    parts["scene"]["joints"] = [Joint(name="knot", points=tied)]


def _obstacle(parts: Parts) -> None:
    wall = Plane(point=(0, 0.006, 0), normal=(0, -1, 0), friction=0.3)
    parts["scene"]["obstacles"] = [wall]


def _contact(parts: Parts) -> None:
    line = {
        "name": "line",
        "segments": 5,
        "length": 0.5,
        "diameter": 0.01,
        "made_of": Material(**SOFT),
    }
    upright = Straight(start=(0.36, -0.0105, 0.0), direction=(0, 0, -1))
    parts["scene"].setdefault("ropes", []).append(Rope(**line, shape=upright))
    ends = [Anchor(name=f"line{node}", rope="line", node=node) for node in (0, -1)]
    parts["scene"].setdefault("anchors", []).extend(ends)
    parts["scene"]["contact"] = Contact(friction=0.2)


def _load(parts: Parts) -> None:
    parts["rope"]["loads"] = [Load(node=5, mass=0.3)]


def _kick(parts: Parts) -> None:
    parts["rope"]["kicks"].append(Kick(node=5, velocity=(0.0, 1.0, -2.0)))


def _force(parts: Parts) -> None:
    parts["rope"]["forces"] = [Force(node=5, force=(0.0, 1.0, 0.0))]


def _parting(parts: Parts) -> None:
    parts["stuff"] |= {"parts": True, "breaking_load": 0.8}


def _moved(parts: Parts) -> None:
    shake = Shake(axis=(0, 0, 1), amplitude=0.02, frequency=3.0)
    moved = Anchor(name="b", rope="one", node=9, motion=shake)
    parts["scene"].setdefault("anchors", []).append(moved)


def _slide(parts: Parts) -> None:
    hook = {"name": "hook", "segments": 2, "length": 0.2, "diameter": 0.01}
    hung = Straight(start=(0, 0, 0), direction=(0, 0, -1))
    one = Rope(**hook, made_of=Material(**SOFT), shape=hung, loads=[Load(node=-1, mass=0.2)])
    parts["scene"].setdefault("ropes", []).append(one)
    parts["scene"]["slides"] = [Slide(rope="hook", at=0.62, friction=0.1, brake=0.05)]


def _turning(parts: Parts) -> None:
    _obstacle(parts)
    (wall,) = parts["scene"]["obstacles"]
    shake = Shake(axis=(0, 1, 0), amplitude=0.004, frequency=4.0)
    parts["scene"]["obstacles"] = [wall.replace(spin=Spin(rate=3.0), motion=shake)]


def _curvature(parts: Parts) -> None:
    _bending(parts)
    parts["stuff"]["curvature"] = (0.0, 0.5, 0.0)


def _springs(parts: Parts) -> None:
    parts["springs"] = {
        "spring_constant": 2e4, "node_mass": 0.02, "segment_length": 0.1, "spring_friction": 2.0,
    }  # fmt: skip


#: Tried beside all others in one method only.
MORE: dict[str, Callable[[Parts], None]] = {
    "turning obstacle": _turning,
    "curvature": _curvature,
    "springs": _springs,
    "hauling winch": _hauling,
}
FEATURES: dict[str, Callable[[Parts], None]] = {
    "rigid links": _rigid,
    "winch": _winch,
    "limiter": _limiter,
    "curve": _curve,
    "relaxation": _relaxation,
    "bending": _bending,
    "clamp": _clamp,
    "air": _air,
    "ground": _ground,
    "tension only": _one_way,
    "axial friction": _axial,
    "joint": _joint,
    "obstacle": _obstacle,
    "contact": _contact,
    "load": _load,
    "kick": _kick,
    "force": _force,
    "moved anchor": _moved,
    "parting": _parting,
    "slide": _slide,
}


def scene_of(method: str, *features: str, implicit: bool) -> Scene:
    """A slack rope of ten segments, held at one end, whose other end is thrown back, with these features."""
    kicks = [Kick(node=8, velocity=(-3.0, 0.5, 1.0)), Kick(node=4, velocity=(0.0, -0.5, 0.0))]
    parts: Parts = {"stuff": dict(SOFT), "rope": {"kicks": kicks}, "held": {}, "scene": {}}
    for name, add in (FEATURES | MORE).items():
        if name in features:
            add(parts)
    if parts["stuff"].get("tension_only") and "relaxing_EA" in parts["stuff"]:
        parts["stuff"]["axial_damping"] = 0.0  # is refused beside both
    more, springs = parts["scene"], parts.get("springs")
    one = Rope(
        name="one",
        segments=10,
        length=None if springs else 1.0,
        diameter=0.01,
        made_of=Springs(**springs) if springs else Material(**parts["stuff"]),
        shape=Slack(start=(0, 0, 0), end=(0.9, 0, 0)),
        **parts["rope"],
    )
    held = Anchor(name="a", rope="one", node=0, **parts["held"])
    step = STEP.get(method, 5e-3 if implicit else 2.5e-4)
    run = RunSettings(method=method, duration=0.1, frame_rate=50.0, time_step=step)
    return Scene(
        ropes=[one, *more.pop("ropes", [])],
        anchors=[held, *more.pop("anchors", [])],
        run=run,
        **more,
    )
