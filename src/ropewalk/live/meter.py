"""The stability meter: how far every variant's step is from the largest stable one, now."""

from __future__ import annotations

import math
from typing import Any

from ropewalk.analysis.json_values import plain
from ropewalk.analysis.linear_theory import stiffest
from ropewalk.analysis.stability import (
    Stability,
    stability,
)
from ropewalk.engine.unsolved import RINGING
from ropewalk.live.stiffness import axial_stiffness, spring_constant
from ropewalk.lowering import Model
from ropewalk.lowering.link_lengths import has_links
from ropewalk.lowering.steps import step_cases
from ropewalk.methods.bound import meter
from ropewalk.methods.registry import METHODS
from ropewalk.words.safe_side import longest_step, rounded_down

GREEN = 0.9  # of the bound
_FRICTION = {"semi-implicit-euler": (2.0, "a + 2b"), "verlet": (4.0, "a + 4b")}


def measure(model: Model) -> dict[str, Any]:
    """Return one variant's part of the `stability` message.

    The theory is that of `analysis.stability`; only what a meter shows is computed.
    """
    plan = model.plan
    method, dt = plan.method, plan.dt
    if has_links(model.state):
        return _rigid(stability(model))
    found_cases = step_cases(model.system, model.state, plan.duration)
    cases, own = found_cases.chains, found_cases.largest(method)
    case = min(own, key=lambda name: own[name])
    bound = own[case]
    steps = {name: min(found_cases.largest(name).values()) for name in METHODS}
    scaled, unit = stiffest(found_cases, method, dt)
    factor = scaled * unit
    constant, material = _constants(model)
    stable = dt <= bound
    ratio = dt / bound if bound > 0.0 else math.inf
    value, words = None, None
    if method in _FRICTION:
        weight, words = _FRICTION[method]
        value = max(meter(chain, dt, weight) for chain in cases.values())
    found = {
        "method": method,
        "stable": stable,
        "breaks": not stable,
        "zone": "green" if ratio < GREEN else "amber" if stable else "red",
        "ratio": ratio,
        "step": dt,
        "bound": bound,
        "meter": value,
        "meter_limit": None if value is None else 4.0,
        "meter_name": words,
        "spring_factor": factor,
        "largest_spring_constant": None if constant is None else scaled * (unit * constant),
        "largest_axial_stiffness": None if material is None else scaled * (unit * material),
        "case": case,
        "steps": steps,
        "verdict": _verdict(method, dt, bound, stable),
        "remedies": _remedies(dt, bound, stable, steps),
    }
    return {key: plain(item) for key, item in found.items()}


def _rigid(found: Stability) -> dict[str, Any]:
    """Return the meter of rigid links, which have no frequency and no largest step."""
    names = {
        "method",
        "step",
        "meter",
        "case",
        "largest_spring_constant",
        "largest_axial_stiffness",
    }
    shown = {name: getattr(found, name) for name in names} | {
        "stable": True,
        "breaks": False,
        "zone": "green",
        "ratio": 0.0,
        "bound": math.inf,
        "meter": None,
        "meter_limit": None,
        "meter_name": None,
        "spring_factor": math.inf,
        "steps": found.largest_step,
        "verdict": _verdict(found.method, found.step, math.inf, True),
        "remedies": [],
    }
    return {key: plain(item) for key, item in shown.items()}


def _constants(model: Model) -> tuple[float | None, float | None]:
    """Return spring constant [N/m] and EA [N] that all ropes share, where they are all of the stiffness."""
    ropes = model.scene.ropes
    if any(rope.curved or rope.relaxes for rope in ropes):
        return None, None
    constants = {spring_constant(rope) for rope in ropes}
    materials = {axial_stiffness(rope) for rope in ropes}
    return (
        constants.pop() if len(constants) == 1 else None,
        materials.pop() if len(materials) == 1 else None,
    )


def _verdict(method: str, dt: float, bound: float, stable: bool) -> str:
    if math.isinf(bound):
        small = " for small motions" if method in RINGING else ""
        return f"stable{small}: {method} has no largest step here"
    if stable:
        return f"stable: {100.0 * dt / bound:.0f} % of the largest step of {longest_step(bound)}"
    if bound == 0.0:
        return f"unstable: {method} has no stable step here"
    return f"unstable: {dt / bound:.3g} times the largest step of {longest_step(bound)}"


def _remedies(dt: float, bound: float, stable: bool, steps: dict[str, float]) -> list[str]:
    if stable:
        return []
    found = [f"time step at most {rounded_down(bound)} s"] if bound > 0.0 else []
    better = [name for name, step in steps.items() if step >= dt]
    return found + ([f"method {' or '.join(better)}"] if better else [])
