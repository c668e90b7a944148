"""What a plan makes of what the scene asks for: whole frames, drums that run empty."""

from __future__ import annotations

import math

from ropewalk.build import Model
from ropewalk.scene import Scene, Winch

_ROUNDING = 1e-9  # [1]


def plan_notes(model: Model) -> list[str]:
    """Return a sentence for everything that the run will do otherwise than the scene says."""
    scene = model.scene
    found = _whole_frames(model)
    for row, winch in enumerate(scene.winches):
        found += _drum(scene, winch, float(model.system.winches.drum[row]))
    return found


def _whole_frames(model: Model) -> list[str]:
    asked, plan = model.scene.run.duration, model.plan
    if abs(plan.duration - asked) <= _ROUNDING * asked:
        return []
    frames = f"{plan.frames} frame" + ("s" if plan.frames > 1 else "")
    return [
        f"run.duration: {asked:.10g} s is no whole number of frames; the run ends at "
        f"{plan.duration:.10g} s, after {frames} of {plan.frame_interval:.6g} s"
    ]


def _drum(scene: Scene, winch: Winch, drum: float) -> list[str]:
    """Say when a drum of known length runs empty while the winch should still pay out."""
    if winch.speed <= 0.0:
        return []
    room = math.inf if winch.max_length is None else winch.max_length
    room -= scene.rope_named(winch.rope).length_unstretched
    empty = winch.start + drum / winch.speed
    end = min(winch.stop, scene.run.duration)
    if drum >= room or empty >= end * (1.0 - _ROUNDING):
        return []
    return [
        f"winch {winch.name!r}: its drum of {drum:.6g} m is empty at {empty:.6g} s; from then on it "
        "stands"
    ]
