"""The report's rope between two anchors, for checks: any field of it by name."""

from __future__ import annotations

from ropewalk.analysis.check import check
from ropewalk.scene import (
    Anchor,
    Material,
    Rope,
    RunSettings,
    Scene,
    Springs,
    Straight,
)


def scene(**changes: object) -> Scene:
    """The report's rope between two anchors; `changes` to springs, rope, run or scene by name."""
    springs: dict[str, object] = {
        "spring_constant": 1e4,
        "node_mass": 0.05,
        "spring_friction": 0.05,
        "segment_length": 1.0,
    }
    rope: dict[str, object] = {"segments": 20, "shape": Straight(start=(0, 0, 0))}
    run: dict[str, object] = {"time_step": 0.002}
    whole: dict[str, object] = {
        "gravity": (0, -9.81, 0),
        "anchors": (Anchor(node=0), Anchor(node=-1)),
    }
    for key, value in changes.items():
        for part in (springs, rope, run):
            fields = {id(springs): Springs, id(rope): Rope, id(run): RunSettings}[id(part)]
            if key in fields.model_fields:
                part[key] = value
                break
        else:
            whole[key] = value
    rope.setdefault("made_of", Springs(**springs))
    return Scene(
        run=RunSettings(**({"method": "semi-implicit-euler"} | run)), ropes=(Rope(**rope),), **whole
    )


def warnings(**changes: object) -> str:
    return "\n".join(check(scene(**changes), measure=False).warnings)


def material(**changes: object) -> Rope:
    fields = {"EA": 2e4, "mass_per_length": 0.06, "breaking_load": None}
    rope = {"segments": 10, "length": 10.0, "shape": Straight(start=(0, 0, 0))}
    for key, value in changes.items():
        (fields if key in fields else rope)[key] = value
    return Rope(**({"made_of": Material(**fields)} | rope))
