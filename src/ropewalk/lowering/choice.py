"""`method = "auto"`: the cheapest method that is stable and accurate enough, and why.

Accuracy: a method of order p errs by about C l (h / tau)^p after the time tau = l / u, l the longest rope's
length and u the speed of a fall through it, or of what is thrown or moved; C was measured on a dropped rope
(`tests/unit/test_choice.py` does it again). The aim is `AIM` times `run.tolerance`, which is what steps to
that tolerance add up to there. Cost: force evaluations per second, a stage to solve counted as `STAGE_COST`
of them.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from ropewalk.core.arrays import State, System
from ropewalk.lowering.chains import speed_scale
from ropewalk.lowering.steps import step_cases, uncovered
from ropewalk.methods.registry import METHODS
from ropewalk.motions.rows import fastest_turn
from ropewalk.scene import Scene, SceneError
from ropewalk.scene.faults import Fault

#: Candidates and their C [1], the cheaper first where two cost the same.
ERROR = {"semi-implicit-euler": 0.4, "verlet": 2.0, "rk4": 20.0, "esdirk3": 5.0}
AIM = 100.0


class Candidate(NamedTuple):
    """A method at the longest step that is stable and accurate enough."""

    method: str
    step: float  # [s]
    bound: float  # longest stable step, less the scene's margin [s]
    cost: float  # force evaluations per simulated second [1/s]


def choose(
    scene: Scene, system: System, state: State, most: float, until: float = math.inf
) -> list[Candidate]:
    """Return the candidates, the cheapest first; no step is longer than `most` [s].

    Their steps suit what moves before the time `until` [s].

    Raises SceneError when none has a stable step.
    """
    found = candidates(scene, system, state, most, until)
    if not found:
        rule = "finds no method with a stable step here; give a method and a step yourself"
        raise SceneError([Fault("run.method", "auto", rule)])
    return sorted(found, key=lambda one: one.cost)


def candidates(
    scene: Scene, system: System, state: State, most: float, until: float = math.inf
) -> list[Candidate]:
    """Return every method that can run the scene, at its longest step; none longer than `most` [s]."""
    run = scene.run
    cases = step_cases(system, state, run.duration, until)
    found = []
    for name in ERROR:
        method = METHODS[name]
        if not method.holds_links and np.isinf(state.stiffness).any():
            continue
        if not bounds_stretch(scene, name):
            continue
        if uncovered(system, state, name, run.duration, until):
            continue
        bound = run.auto_fraction * min(cases.largest(name).values())
        accurate = accurate_step(name, scene, system, state, until)
        step = min(bound, accurate, run.frame_interval, most)
        if step > 0.0:
            twice = 2.0 if name == "verlet" and (scene.limiter or scene.winches) else 1.0
            found.append(Candidate(name, step, bound, twice * method.cost / step))
    return found


def bounds_stretch(scene: Scene, method: str) -> bool:
    """Tell whether a method can work with the scene's stretch limiter, if it has one.

    A segment at its bound is a rigid link. Explicit methods put it right after their steps.
    """
    made = METHODS[method]
    return scene.limiter is None or made.holds_links or not made.implicit


def accurate_step(
    name: str, scene: Scene, system: System, state: State, until: float = math.inf
) -> float:
    """Return the step at which a method errs by about the aim [s]."""
    length = max(rope.length_unstretched for rope in scene.ropes)
    speed = speed_scale(system, state, until, drums=False)  # of what is out, as the length is
    rate = max(speed / length if length > 0.0 else 0.0, fastest_turn(system.anchors))
    if rate == 0.0:
        return math.inf
    error = AIM * scene.run.tolerance / (ERROR[name] * max(length, AIM * scene.run.tolerance))
    return float(error ** (1.0 / METHODS[name].order) / rate)


def reason(scene: Scene, found: list[Candidate], dt: float) -> str:
    """Say in one sentence what decided for the first candidate, run in steps of `dt` [s]."""
    best, implicit = found[0], METHODS[found[0].method].implicit
    said = f"auto chose {best.method} ({'implicit' if implicit else 'explicit'}) at {_ms(dt)}"
    given = scene.run.time_step
    if best.step == given:
        said += f", the scene's time_step being {_ms(best.step)}"
    share = f"{scene.run.auto_fraction:g} of the bound"
    other = next((one for one in found if METHODS[one.method].implicit != implicit), None)
    if other is None and any(rope.rigid for rope in scene.ropes):
        return f"{said}: rigid links need a method that holds their lengths"
    if other is None and scene.limiter is not None:
        return f"{said}: no bound holds for explicit methods beside a stretch limiter"
    if other is None:
        return f"{said}: no other method has a stable step"
    times = other.cost / best.cost
    cost = f"{times:.2g} times as much" if times > 1.05 else "a little more"
    if times >= 10.0:
        cost = f"{times:.0f} times as much"
    if other.step == given:
        cost += f" at the scene's time_step of {_ms(other.step)},"
    why = f"stability allows {_allowed(best, share)}, and {other.method} would cost {cost}"
    if implicit:
        why = f"{other.method} is allowed {_allowed(other, share)} only and would cost {cost}"
    return f"{said}: {why} for an error of about {1e3 * AIM * scene.run.tolerance:.3g} mm"


def _allowed(one: Candidate, share: str) -> str:
    return _ms(one.bound) + ("" if math.isinf(one.bound) else f" ({share})")


def _ms(seconds: float) -> str:
    return "any step" if math.isinf(seconds) else f"{1e3 * seconds:.3g} ms"
