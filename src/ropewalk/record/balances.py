"""The two balances of a run, and what is said where its steps have not kept one.

Every law's work is booked at the velocity of mid-step, v + h a / 2, for which the change of the kinetic
energy is the sum of all works, whatever the method: what is left of that balance is round-off. The sum
of the energies also holds the potential energies, whose changes a method meets only up to its order:
what is left of this one is the method's error.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.laws.acting import section_of
from ropewalk.laws.parting import NAME as PARTING
from ropewalk.laws.registry import NODE_LAWS
from ropewalk.methods.recording import CONSERVATIVE
from ropewalk.methods.registry import METHODS
from ropewalk.scene import Material, Scene
from ropewalk.words.percents import percent

if TYPE_CHECKING:
    from ropewalk.lowering import Plan
    from ropewalk.record.result import Result

SLACK = 1e-10  # [1] a strain of less is rounding of places
MOST = 0.01  # [1] of weight times length
TURNED = 5.0  # [%] of the energy turned over: more than that is no ledger
_NOTHING = 1e-4  # [1] of weight times length: a rope that hardly moves turns over nothing
_ROUNDING = 1e-12  # [1] of stiffness times length
_WITH_JUMPS = ("limiter", "winch", "clamps", PARTING)


def energy_error(energy: Mapping[str, Floats], work: Mapping[str, Floats], ledger: bool) -> Floats:
    """Return total - total[0] - works of all laws without a potential [J], (frames,).

    NaN where frames recorded into a break are no longer finite.
    """
    total = energy["total"]
    if not ledger:
        return np.full(total.shape, np.nan)
    others = [w for name, w in work.items() if name not in CONSERVATIVE]
    with np.errstate(invalid="ignore", over="ignore"):
        done = sum(others, np.zeros(total.shape))
        error: Floats = total - total[0] - (done - done[0])
    return error


def balance_residual(
    energy: Mapping[str, Floats], work: Mapping[str, Floats], jump: Floats, ledger: bool
) -> Floats:
    """Return the change of the kinetic energy minus all works [J], (frames,).

    Limiter and winch change positions and masses too; only what they put into the kinetic energy
    (`jump`, (frames, 2)) counts here. Turning a clamp puts its work into the energy of bending, and a rope
    that parts loses what it had stored.
    NaN where frames recorded into a break are no longer finite.
    """
    kinetic = energy["kinetic"]
    if not ledger:
        return np.full(kinetic.shape, np.nan)
    others = [w for name, w in work.items() if name not in _WITH_JUMPS]
    with np.errstate(invalid="ignore", over="ignore"):
        done = sum(others, jump.sum(axis=1))
        residual: Floats = kinetic - kinetic[0] - (done - done[0])
    return residual


_OF_HANDS = (
    "of a live session: what kicks, throws, loads and changed constants put in or took, if there were any, "
    "is in it; the rest is of steps that are too long for the motion"
)


def lost_note(result: Result) -> str:
    """Say from when on the books of energy of frames before a break hold no numbers; "" where all do."""
    if not result.facts.ledger:
        return ""
    good = result.good_frames
    works = {name: work[:good] for name, work in result.work.items()}
    rows = np.stack([result.energy_error[:good], *result.energy_errors[:good].T, *works.values()])
    lost = ~np.isfinite(rows).all(axis=0)
    if not lost.any():
        return ""
    since = int(np.argmax(lost))
    names = [name for name, work in works.items() if not np.isfinite(work[since])]
    of = f" (work: {', '.join(names)})" if names else ""
    return (
        f"its books hold no numbers from t = {result.time[since]:.6g} s on{of}, and the errors here are "
        "those before it. That is a fault of Ropewalk: please report it"
    )


def energy_note(result: Result, error: Floats, share: float) -> str:
    """Say by how much the energy of a run is wrong, where it is by too much; else "".

    Args:
        result: the run, whoever chose its step and its method.
        error: of the energy at the frames to look at [J], (frames,).
        share: the largest error, of the energy turned over [%].

    An explicit run of an undamped rope may err by `MOST` of weight times length. Where there is friction,
    air, ground or a limiter, or no weight, or steps are implicit, by `TURNED` of the energy turned over: what
    those take hides a part of what steps make up.
    """
    scene, plan = result.scene, result.plan
    error = error[np.isfinite(error)]
    if result.facts.provenance.get("live"):
        return _OF_HANDS if share > TURNED else ""
    if plan.method not in METHODS or not error.size:
        return ""
    worst, scale = float(error[np.argmax(np.abs(error))]), weight_times_length(scene)
    if not METHODS[plan.method].implicit and not is_damped(scene) and scale > 0.0:
        return _made_up(plan, worst, scale) if abs(worst) > MOST * scale else ""
    if not share > TURNED or abs(worst) <= hardly_any(scene):
        return ""
    steps = f"steps of {1e3 * plan.dt:.3g} ms"
    if plan.tolerance is not None:
        steps = f"tolerance of {plan.tolerance:.3g} m"
    return (
        f"{abs(worst):.3g} J, {percent(share, 3)} of the energy turned over, are in no law's work: some of "
        f"the motion is too fast for {plan.method}'s {steps}. Do not trust works, nor forces and "
        f"places after it; take {shorter_steps(plan)}"
    )


def hardly_any(scene: Scene) -> float:
    """Return an energy [J] that is none: of a rope that hardly moves, or, without weight, of rounding."""
    if scale := weight_times_length(scene):
        return _NOTHING * scale
    ropes = (rope for rope in scene.ropes if not rope.rigid)
    return _ROUNDING * sum(
        rope.segment_stiffness * rope.segment_length * rope.length_unstretched for rope in ropes
    )


def shorter_steps(plan: Plan) -> str:
    """Return what makes the errors of a run's steps smaller, in the words of a scene."""
    if plan.tolerance is not None:
        return f"tolerance = {0.1 * plan.tolerance:.3g}"
    return f"time_step = {0.25 * plan.dt:.3g} s or less, or method = adaptive"


def _made_up(plan: Plan, worst: float, scale: float) -> str:
    did = "made up" if worst > 0.0 else "lost"
    return (
        f"{plan.method} {did} {abs(worst):.3g} J, {percent(100.0 * abs(worst) / scale)} of weight times "
        f"length, in a rope without friction: take time_step = {0.5 * plan.dt:.3g} s or less, "
        "method = adaptive, or give the rope the friction that it has"
    )


def weight_times_length(scene: Scene) -> float:
    """Return the weight of all ropes and loads times the longest rope's length [J]."""
    mass = sum(rope.total_mass for rope in scene.ropes)
    return math.hypot(*scene.gravity) * mass * max(rope.length_unstretched for rope in scene.ropes)


def energy_of_rounding(scene: Scene) -> float:
    """Return the energy of ropes that are stretched by rounding of their nodes' places [J]."""
    elastic = [rope for rope in scene.ropes if not rope.rigid]
    stored = (
        one.segment_stiffness * one.segment_length * one.length_unstretched for one in elastic
    )
    return 0.5 * SLACK**2 * sum(stored)


def is_damped(scene: Scene) -> bool:
    """Tell whether anything in a scene takes energy."""
    if scene.limiter or any(section_of(law, scene) for law in NODE_LAWS):
        return True
    rubs = any(rope.segment_friction > 0.0 for rope in scene.ropes)
    bends = (rope.made_of for rope in scene.ropes if isinstance(rope.made_of, Material))
    return rubs or any(made_of.bending_damping > 0.0 for made_of in bends)
