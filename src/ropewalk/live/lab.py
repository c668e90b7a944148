"""The lab: one HTML file in which ropes of springs run in the browser itself, to be changed and broken.

Nothing is fetched: program, style and scenes are in the file, under a policy that names them by their hashes.
"""

from __future__ import annotations

import html
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from ropewalk import __version__
from ropewalk.core.arrays import AXIAL, BENDING
from ropewalk.engine.start import started
from ropewalk.laws.acting import section_of
from ropewalk.laws.registry import NODE_LAWS
from ropewalk.live.lab_posts import posts_of, refused_posts
from ropewalk.live.share import HERE, as_data, in_script, policy
from ropewalk.lowering import Model, build
from ropewalk.motions.registry import CODES
from ropewalk.record.files import write, writing
from ropewalk.scene import Scene, SceneError
from ropewalk.scene.faults import NO_VALUE, Fault
from ropewalk.scene.presets import preset

PRESETS = ("r4", "r1", "r2", "r3", "r9")
METHODS = ("semi-implicit-euler", "verlet", "rk4")
_PAGE = """<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="{policy}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<meta name="generator" content="Ropewalk {version}">
<title>Rope lab – Ropewalk</title>
<link rel="icon" href="data:,">
<style>{style}</style>
</head>
<body>
{body}
<script type="application/json" id="scenes">{scenes}</script>
<script>{script}</script>
</body>
</html>
"""


def write_lab(path: Path, scenes: Sequence[Scene] = ()) -> Path:
    """Write the lab's page with these scenes, or the report's, and return its path.

    Raises SceneError for a scene with what the lab does not know, OSError when it cannot be written.
    """
    made = [lab_scene(scene) for scene in scenes or map(preset, PRESETS)]
    with writing(path):
        path.parent.mkdir(parents=True, exist_ok=True)
        write(path, page(made).encode())
    return path


def page(scenes: Sequence[dict[str, Any]]) -> str:
    """Return the page of scenes that `lab_scene` made."""
    script = in_script((HERE / "lab.js").read_text("utf-8"))
    style = (HERE / "lab.css").read_text("utf-8")
    return _PAGE.format(
        policy=policy(script, style),
        version=html.escape(__version__),
        style=style,
        body=(HERE / "lab.html").read_text("utf-8"),
        scenes=as_data(scenes),
        script=script,
    )


def lab_scene(scene: Scene) -> dict[str, Any]:
    """Return what the page's kernel needs of a scene, as plain values in SI units.

    Raises SceneError for laws and motions that the kernel does not have.
    """
    _refuse(refused_posts(scene))
    scene, instead = _stepped(scene)
    model = started(build(scene))
    _refuse(_refused(model))
    state, system, plan = model.state, model.system, model.plan
    joined = np.ones(model.layout.segments, dtype=bool)
    for span in model.layout.ropes[:-1]:
        joined[span.last] = False
    vector = np.where(joined, state.damping_vector, 0.0)
    axial = np.where(joined, state.damping_axial, 0.0) if system.flags[AXIAL] else 0.0 * vector
    about = f"{scene.description} Steps of {1e3 * plan.dt:.4g} ms." if scene.description else ""
    about = f"{about} {instead}".strip()
    return {
        "name": scene.name,
        "about": about,
        "up": list(scene.up),
        "gravity": system.gravity.tolist(),
        "step": plan.dt,
        "method": plan.method,
        "x": state.x.tolist(),
        "v": state.v.tolist(),
        "mass": state.mass.tolist(),
        "length": state.rest_length.tolist(),
        "stiffness": state.stiffness.tolist(),
        "vector": vector.tolist(),
        "axial": axial.tolist(),
        "slack": (system.slack_floor == 0.0).tolist(),
        "ropes": [[span.first, span.last] for span in model.layout.ropes],
        "anchors": [_anchor(model, row) for row in range(len(state.held))],
        **posts_of(model),
    }


def _refuse(found: Sequence[tuple[str, str]]) -> None:
    """Raise SceneError for paths and what the lab does not have there, if any."""
    if found:
        raise SceneError([Fault(path, NO_VALUE, f"the lab has no {what}") for path, what in found])


def _stepped(scene: Scene) -> tuple[Scene, str]:
    """Return the scene with a method that the lab has, and what is said where that is another."""
    method = build(scene).plan.method
    if method in METHODS:
        return scene, ""
    run = scene.run.replace(method=METHODS[0], time_step="auto", steps="divide")
    said = f"The lab has no {method}: {METHODS[0]} in stable steps stands in for it."
    return scene.replace(run=run), said


def _anchor(model: Model, row: int) -> dict[str, Any]:
    anchors, state = model.system.anchors, model.state
    p, moves = anchors.params[row], anchors.kind[row] == CODES["velocity"]
    release = float(anchors.release[row])
    largest = 1e300  # JSON has no infinity
    return {
        "node": int(state.anchor_node[row]),
        "origin": p[:3].tolist(),
        "velocity": p[3:6].tolist() if moves else [0.0, 0.0, 0.0],
        "start": float(p[6]) if moves else 0.0,
        "stop": min(float(p[7]), largest) if moves else 0.0,
        "release": release if np.isfinite(release) else None,
    }


def _refused(model: Model) -> list[tuple[str, str]]:
    """Return what of a scene the lab's kernel does not have, with its path."""
    scene, system = model.scene, model.system
    laws = [law.section for law in NODE_LAWS if section_of(law, scene)]
    found = [(name, name) for name in laws if name != "obstacles"]
    found += [("limiter", "limiter")] if scene.limiter else []
    found += [("winch", "winches")] if scene.winches else []
    found += [("joint", "joints")] if scene.joints else []
    found += [("rope.made_of.EI", "bending stiffness")] if system.flags[BENDING] else []
    found += [("rope.made_of.curve", "curves")] if any(r.curved for r in scene.ropes) else []
    found += (
        [("rope.made_of.relaxing_EA", "relaxation")] if any(r.relaxes for r in scene.ropes) else []
    )
    found += [("rope.force", "constant forces")] if model.state.forces.applied.any() else []
    found += [("rope.made_of", "rigid links")] if any(rope.rigid for rope in scene.ropes) else []
    for i, kind in enumerate(system.anchors.kind):
        if kind not in (CODES["fixed"], CODES["velocity"]):
            name = scene.anchors[i].motion.kind
            found.append((f"anchor[{i}].motion", f"motion of the kind {name!r}"))
        elif system.anchors.above_ground[i]:
            found.append((f"anchor[{i}].above_ground", "ground"))
    return found
