"""The plan of a run: frames, steps per frame, step length."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from ropewalk.core.arrays import State, System
from ropewalk.laws.winch import WINCH_SHARE
from ropewalk.lowering.choice import Candidate, bounds_stretch, choose, reason
from ropewalk.lowering.obstacle_checks import step_past_nodes
from ropewalk.lowering.steps import BEYOND, predicted_step, uncovered
from ropewalk.lowering.swings import LONGEST, swinging_step
from ropewalk.methods.controller import LONGEST_STEP, SHORTEST_STEP
from ropewalk.methods.registry import METHODS
from ropewalk.scene import RunSettings, Scene, SceneError
from ropewalk.scene.faults import Fault
from ropewalk.words.safe_side import rounded_down, within

# The rule of NeHe's lesson: whole number of steps whose length stays below the given one.
_ROUND_OFF = 1e-9  # [1] a frame this close to a whole number of steps counts as whole


@dataclass(frozen=True)
class Plan:
    """Frames and steps of a run; frame f is at t = f * steps_per_frame * dt."""

    method: str
    dt: float  # [s]
    steps_per_frame: int
    frames: int  # after the initial one
    tolerance: float | None = (
        None  # [m] of steps of varying length; `dt` is then the frame interval
    )
    longest: float | None = None  # [s] of such a step
    why: str = ""  # why the method was chosen, where it was not given

    @property
    def frame_interval(self) -> float:
        """Time between two frames [s]."""
        return self.steps_per_frame * self.dt

    @property
    def pace(self) -> str:
        """The steps in words."""
        if self.tolerance is None:
            return f"steps of {1e3 * self.dt:.4g} ms"
        return f"steps to a tolerance of {1e3 * self.tolerance:.4g} mm"

    @property
    def steps(self) -> int:
        """Number of steps of the whole run; of frames where the method chooses its own steps."""
        return self.frames * self.steps_per_frame

    @property
    def duration(self) -> float:
        """Simulated time of the whole run [s]."""
        return self.steps * self.dt


def make_plan(
    scene: Scene, system: System, state: State, until: float, *, stepped: bool = True
) -> Plan:
    """Return the plan of a scene's run, whose steps suit what moves before the time `until` [s].

    Raises SceneError when "auto" finds no stable step, a method cannot work with a stretch limiter, a winch
    is too fast for the step, or the plan has more than 2^53 steps; of the last two nothing with `stepped`
    off, where none is taken.
    """
    run = scene.run
    refuse_limiter(scene)
    if run.method == "adaptive":
        return _adaptive_plan(scene, system, until)
    method: str = run.method
    found: list[Candidate] = []
    if method == "auto":
        given = math.inf if run.time_step == "auto" else run.time_step
        most = min(given, _moving_step(scene, system, until))
        found = choose(scene, system, state, most, until)
        method, step = found[0].method, found[0].step
    elif run.time_step == "auto":
        step = min(auto_step(run, system, state, until), _moving_step(scene, system, until))
    else:
        step = run.time_step
    count, dt = divide(run.frame_interval, step, run.steps)
    if stepped and not within(0.0, dt, most := _winch_step(system)):
        fastest = int(np.argmax(np.abs(system.winches.speed) / system.winches.segment))
        rule = (
            f"must be at most {rounded_down(most, 4)}: in a step winch {scene.winches[fastest].name!r} may "
            "wind a fifth of a segment"
        )
        raise SceneError([Fault("run.time_step", dt, rule)])
    frames = max(1, round(run.duration / (count * dt)))
    if stepped and frames * count >= 2**53:
        rule = f"makes {frames * count:.2g} steps; take a longer one"
        raise SceneError([Fault("run.time_step", run.time_step, rule)])
    why = reason(scene, found, dt) if found else ""
    return Plan(method, dt, count, frames, why=why)


def refuse_limiter(scene: Scene) -> None:
    """Raise SceneError for a limiter with a method that cannot work with it."""
    name = scene.run.method
    if name == "auto" or bounds_stretch(scene, name):
        return
    able = ", ".join(one for one in METHODS if METHODS[one].holds_links)
    rule = (
        "cannot work with a stretch limiter: a segment at its bound is rigid; implicit methods that can: "
        f"{able}; so can all explicit ones"
    )
    raise SceneError([Fault("run.method", name, rule)])


def _adaptive_plan(scene: Scene, system: System, until: float) -> Plan:
    """Return the plan of a run that chooses its own steps, one "step" a frame."""
    run = scene.run
    frames = max(1, round(run.duration / run.frame_interval))
    swing = max(swinging_step(scene, until, LONGEST), SHORTEST_STEP)
    automatic = min(LONGEST_STEP, step_past_nodes(scene, system, until), swing)
    longest = automatic if run.time_step == "auto" else run.time_step
    return Plan(run.method, run.frame_interval, 1, frames, run.tolerance, longest)


def _moving_step(scene: Scene, system: System, until: float) -> float:
    """The longest step for what moves by itself before a time [s]: winches, anchors and obstacles [s]."""
    past = step_past_nodes(scene, system, until)
    return min(_winch_step(system), past, swinging_step(scene, until))


def _winch_step(system: System) -> float:
    """The step in which no winch winds more than a fifth of a segment [s]."""
    winches = system.winches
    if len(winches.speed) == 0:
        return math.inf
    with np.errstate(divide="ignore"):
        return float((WINCH_SHARE * winches.segment / np.abs(winches.speed)).min())


def auto_step(run: RunSettings, system: System, state: State, until: float = math.inf) -> float:
    """Return the stated fraction of the largest stable step, at most one frame [s].

    Of what moves by itself only that before the time `until` [s] counts.
    """
    bound = predicted_step(system, state, run.method, run.duration, until)
    if bound <= 0.0:
        rule = (
            f"no step of {run.method} is stable here: nothing damps some of the motion; "
            "take semi-implicit-euler, verlet or rk4, or give a step yourself"
        )
        raise SceneError([Fault("run.time_step", "auto", rule)])
    share = BEYOND if uncovered(system, state, run.method, run.duration, until) else 1.0
    return min(share * run.auto_fraction * bound, run.frame_interval)


def divide(interval: float, step: float, rule: str) -> tuple[int, float]:
    """Return steps per frame and step length [s] for a frame interval [s] and a wanted step [s]."""
    if rule == "exact":
        return max(1, round(interval / step)), step
    if rule == "nehe":
        count = int(interval / step) + 1
    else:
        count = max(1, math.ceil(interval / step * (1.0 - _ROUND_OFF)))
    return count, interval / count
