"""Golden states: the last bits of small runs, one or more per law, by method, as an earlier commit left them.

`python -m golden.states` from the folder `tests` writes them anew; a commit that does so says why.
"""

from __future__ import annotations

import json
import platform
from hashlib import sha256
from pathlib import Path
from typing import Any

import llvmlite.binding as llvm
import numba
import numpy as np

from ropewalk.core.status import OK
from ropewalk.methods.registry import METHODS
from ropewalk.scene import (
    Air,
    Anchor,
    Clamp,
    Contact,
    Cylinder,
    Ground,
    Joint,
    Limiter,
    Material,
    Plane,
    Rope,
    RunSettings,
    Scene,
    SceneError,
    Shake,
    Slack,
    Slide,
    Springs,
    Straight,
    Tie,
    Winch,
)
from ropewalk.simulation import Simulation

FOLDER = Path(__file__).parent
ROUNDING = 1e-13  # [1] of the largest coordinate or speed: machines differ in sine and cosine
STEP, STEPS = 1e-3, 60
CURVE = [(0.02, 0.5), (0.05, 2.0), (0.2, 11.0)]  # strain and tension [1, N]
ARM = {"relaxing_EA": 40.0, "relaxation_time": 0.01}
SOLID = {"EA": 60.0, "axial_damping": 0.0} | ARM


def rope(**more: Any) -> Rope:
    """A slack rope of eight segments, one node kicked."""
    line = {"EA": 60.0, "mass_per_length": 0.2, "axial_damping": 0.02}
    line |= more.pop("line", {})
    line = {name: value for name, value in line.items() if value is not None}
    rest = {"segments": 8, "length": 2.0, "shape": Slack(start=(0, 0, 1), end=(1.7, 0, 1.2))}
    rest |= {"kicks": [{"node": 5, "velocity": (0.3, 2.0, 1.0)}], "made_of": Material(**line)}
    return Rope(name="rope", **(rest | more))


def springs() -> Rope:
    """The same of springs with friction along and across."""
    made_of = Springs(
        spring_constant=240.0, node_mass=0.05, segment_length=0.25, spring_friction=0.1
    )
    return rope(made_of=made_of, length=None)


def meetings() -> dict[str, dict[str, Any]]:
    """Return what laws of touching, sliding, tying and parting add, by law.

    Soft surfaces: hard ones make of rounding in sine and cosine more than other machines may differ by.
    """
    ends = [Anchor(name=f"end{node}", rope="rope", node=node) for node in (0, -1)]
    wide = rope(diameter=0.02)
    line = Material(EA=60.0, mass_per_length=0.2, axial_damping=0.02)
    short: dict[str, Any] = {"segments": 3, "length": 0.6, "made_of": line}
    across = Straight(start=(0.84, -0.3, 0.62), end=(0.86, 0.3, 0.62), velocity=(0.2, 0, 0.8))
    other = Rope(name="other", **short, diameter=0.02, shape=across)
    hung = Rope(name="other", **short, shape=Straight(start=(0, 0, 1), direction=(0, 0.6, -0.8)))
    drum = Cylinder(
        start=(0.88, -1, 0.53), end=(0.88, 1, 0.53), radius=0.1, spin={"rate": 5.0}, compliance=1e-3
    )
    plane = Plane(
        point=(0, 0, 0.615), motion={"kind": "velocity", "velocity": (0.1, 0, 0.5)}, compliance=1e-3
    )
    tied = Joint(points=[Tie(rope="rope", node=0), Tie(rope="other", node=0)])
    return {
        "obstacle": {"ropes": [wide], "obstacles": [drum, plane]},
        "contact": {"ropes": [wide, other], "anchors": ends, "contact": Contact(compliance=1e-3)},
        "slide": {
            "ropes": [rope(), hung],
            "anchors": ends,
            "slides": [Slide(rope="other", at=0.6, friction=0.2, brake=0.1, compliance=1e-3)],
        },
        "joint": {"ropes": [rope(), hung], "anchors": ends[1:], "joints": [tied]},
        "parting": {"ropes": [rope(line={"parts": True, "breaking_load": 2.0})]},
    }


def laws() -> dict[str, dict[str, Any]]:
    """Return what each law adds to the scene, by law."""
    shaken = Anchor(name="far", node=-1, motion=Shake(axis=(0, 1, 0), amplitude=0.1, frequency=4))
    clamp = Clamp(direction=(1, 0, 0), turn_axis=(0, 1, 0), turn_rate=2.0)
    bent = rope(line={"EI": 0.02, "bending_damping": 1e-4})
    free = [Anchor(name="near", node=0)]
    curved_slack = rope(line={"EA": None, "curve": CURVE, "tension_only": True})
    relaxing = {"EA": None, "curve": CURVE, "axial_damping": 0.0, "tension_only": True} | ARM
    relaxing_slack = rope(line=relaxing)
    return {
        "stretch": {},
        "springs": {"ropes": [springs()]},
        "slack": {"ropes": [rope(line={"tension_only": True})], "anchors": free},
        "curve": {"ropes": [rope(line={"EA": None, "curve": CURVE})]},
        "curve-slack": {"ropes": [curved_slack], "anchors": free},
        "relaxing": {"ropes": [rope(line=SOLID)]},
        "relaxing-curve-slack": {"ropes": [relaxing_slack], "anchors": free},
        "rigid": {"ropes": [rope(line={"EA": float("inf")})]},
        "shaken": {"anchors": [*free, shaken]},
        "released": {"anchors": [Anchor(name="near", node=0, release_time=0.03)]},
        "air-linear": {"air": Air(node_drag=0.05, wind=(1, 0, 0))},
        "air-quadratic": {"air": Air(node_drag_quadratic=0.02, density=1.2, wind=(5, 0, 0))},
        "ground": {"ground": Ground(height=1.02), "anchors": free},
        "limiter": {"limiter": Limiter(min_stretch=0.95, max_stretch=1.03)},
        "bending": {"ropes": [bent], "anchors": free},
        "clamp": {"ropes": [bent], "anchors": [Anchor(name="near", node=0, clamp=clamp)]},
        "load": {"ropes": [rope(loads=[{"node": 4, "mass": 0.3}])]},
        "winch": {"winches": [Winch(name="drum", rope="rope", end="start", speed=2.0)]},
        "wound-bends": {
            "ropes": [bent],
            "anchors": [Anchor(name="near", node=0, clamp=clamp)],
            "winches": [Winch(name="drum", rope="rope", end="start", speed=2.0)],
        },
        "two": {"ropes": [rope(), rope().replace(name="other")], "anchors": free},
    } | meetings()


def scene(law: str, method: str) -> Scene:
    """Return the run of a law by a method. Raises SceneError where the two do not go together."""
    ends = [Anchor(name="near", node=0), Anchor(name="far", node=-1)]
    run = RunSettings(
        duration=STEP * STEPS, frame_rate=100.0, time_step=STEP, steps="exact", method=method
    )
    parts: dict[str, Any] = {"ropes": [rope()], "anchors": ends, "run": run} | laws()[law]
    for anchor in parts["anchors"]:
        if len(parts["ropes"]) > 1 and not anchor.rope:
            parts["anchors"] = [
                anchor.replace(rope=one.name, name=one.name) for one in parts["ropes"]
            ]
    return Scene(**parts)


def final(law: str, method: str, frames: int = 6) -> dict[str, Any]:
    """Run one for `frames` frames; return the bits' hash here and the numbers, or what was refused."""
    try:
        simulation = Simulation(scene(law, method))
    except SceneError as refused:
        return {"refused": refused.faults[0].path}
    if simulation.advance_frames(frames).status != OK:
        raise RuntimeError(f"{law} with {method} breaks")
    x, v = simulation.arrays.x, simulation.arrays.v
    bits = sha256(np.ascontiguousarray(x).tobytes() + np.ascontiguousarray(v).tobytes())
    return {"bits": {machine(): bits.hexdigest()[:16]}, "x": x.tolist(), "v": v.tolist()}


def machine() -> str:
    """Return what may change the last bits beside the code."""
    return f"{llvm.get_host_cpu_name()}, {' '.join(platform.libc_ver())}, numba {numba.__version__}"


def misfit(found: dict[str, Any], kept: dict[str, Any]) -> float:
    """Return the largest difference of places and speeds, over the largest of each [1]."""
    errors = [0.0]
    for name in ("x", "v"):
        a, b = np.array(found[name]), np.array(kept[name])
        errors.append(float(np.abs(a - b).max() / np.abs(b).max()))
    return max(errors)


def kept_with(kept: dict[str, Any] | None, found: dict[str, Any]) -> dict[str, Any]:
    """Return what to keep: where the numbers are what they were, other machines' bits stay beside these."""
    if not kept or kept.keys() != found.keys() or "refused" in found:
        return found
    if misfit(found, kept) > ROUNDING:
        return found
    return kept | {"bits": kept["bits"] | found["bits"]}


def path(method: str) -> Path:
    """Return the file of a method."""
    return FOLDER / f"{method}.json"


def main() -> None:
    """Write every method's file."""
    for method in METHODS:
        kept = json.loads(path(method).read_text("utf-8")) if path(method).exists() else {}
        found = {law: kept_with(kept.get(law), final(law, method)) for law in laws()}
        path(method).write_text(json.dumps(found, indent=0) + "\n", encoding="utf-8")
        print(method, {law: next(iter(found[law])) for law in laws()})


if __name__ == "__main__":
    main()
