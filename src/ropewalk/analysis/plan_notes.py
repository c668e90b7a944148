"""What a plan makes of what the scene asks for: whole frames, late releases, drums that run empty."""

from __future__ import annotations

import math

from ropewalk.lowering import Model
from ropewalk.methods.registry import METHODS
from ropewalk.scene import Scene, Winch

_ROUNDING = 1e-9  # [1]
_LATE = 1e-3  # [s] a release that is less late than this is not told of


def plan_notes(model: Model) -> list[str]:
    """Return a sentence for everything that the run will do otherwise than the scene says."""
    scene = model.scene
    found = _whole_frames(model) + _late_releases(model)
    for row, winch in enumerate(scene.winches):
        found += _drum(scene, winch, float(model.system.winches.drum[row]))
        found += _load_at_drum(model, row)
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


def _late_releases(model: Model) -> list[str]:
    """Say of anchors that are to let go inside a step when they do, where steps are not cut there."""
    plan, found = model.plan, []
    if METHODS[plan.method].cuts:
        return []
    for anchor in model.scene.anchors:
        if anchor.release_time is None or anchor.release_time >= plan.duration:
            continue
        lets_go = math.ceil(anchor.release_time / plan.dt - 1e-6) * plan.dt
        if lets_go - anchor.release_time > _LATE:
            found.append(
                f"anchor {anchor.name!r}: release_time = {anchor.release_time:.6g} s lies inside a step of "
                f"{1e3 * plan.dt:.4g} ms; it lets go at {lets_go:.6g} s, where the next one begins. "
                "Other methods cut the step there"
            )
    return found


def _load_at_drum(model: Model, row: int) -> list[str]:
    """Say when a load comes to a drum that should still reel in; there it stops."""
    scene, winches = model.scene, model.system.winches
    winch, load = scene.winches[row], int(winches.load[row])
    if winch.speed >= 0.0 or load < 0:
        return []
    between = abs(load - int(model.state.winch_exit[row])) - 0.5
    way = between * float(winches.segment[row])
    least = scene.rope_named(winch.rope).length_unstretched - (winch.min_length or 0.0)
    comes = winch.start - way / winch.speed
    if way > least or comes >= min(winch.stop, scene.run.duration) * (1.0 - _ROUNDING):
        return []
    node = load - model.layout.span(winch.rope).start
    return [
        f"winch {winch.name!r}: the load at node {node} comes to the drum at {comes:.6g} s; from then on "
        "the winch stands"
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
