"""What `test_added_elastic_law` runs in a copy of the package that has the sample law; prints its numbers."""

from __future__ import annotations

import json
import math
import sys
from typing import Any

import numpy as np
import sample_segment_runs as base
from sample_segment_runs import Fibred, K, L, moved, scene

from ropewalk.analysis.check import check
from ropewalk.lowering import build
from ropewalk.methods.registry import METHODS
from ropewalk.record.simulate import simulate_in_memory
from ropewalk.scene import Anchor, Limiter, SceneError, Straight, Winch
from ropewalk.scene.base import Model, Number, quantity
from ropewalk.scene.motions import Velocity
from ropewalk.simulation import Simulation
from ropewalk.statics import checked_shape
from ropewalk.vibration import modes


class Soft(Model):
    """The section of the sample law."""

    bend: Number = quantity("b", "1", default=4.0)
    arm: Number = quantity("a", "1", default=0.4)
    time: Number = quantity("tau", "s", default=0.03)
    reach: Number = quantity("No segment is strained by more", "1", default=1.0)


class Softened(Fibred):
    """A rope with that section; of fibres its package knows nothing."""

    soft: Soft | None = None


def rope(name: str = "rope", y: float = 0.0, **more: Any) -> Softened:
    """A short rope of springs, one node kicked."""
    fields = base.rope(name, y).model_dump(
        exclude={"fibre", "made_of", "shape"}, exclude_unset=True
    )
    own = base.rope(name, y)
    fields |= {"made_of": own.made_of, "shape": own.shape, "soft": Soft()}
    return Softened(**(fields | more))


def one_segment(**more: Any) -> Softened:
    """A segment of springs at its length, hanging straight down, at rest."""
    return rope(segments=1, shape=Straight(end=(0, 0, -L)), kicks=[], **more)


def energetic() -> dict[str, Any]:
    """Without an arm: what is recorded as stored, and the work of the springs."""
    ropes = [rope(soft=Soft(arm=0.0))]
    simulation = Simulation(scene("rk4", 2e-4, ropes=ropes))
    first = simulation.recording().recording
    out = simulation.advance_frames(1).recording
    stored = [float(record.energy[0, 2]) for record in (first, out)]
    return {
        "x": simulation.arrays.x.tolist(),
        "stored": stored,
        "work": float(out.work[0, 0]),
    }


def pulled(method: str) -> dict[str, Any]:
    """A segment both ends of which are held, the lower one drawn away at 0.5 m/s for 0.1 s."""
    held = [Anchor(name="top", node=0)]
    held += [Anchor(name="end", node=1, motion=Velocity(velocity=(0, 0, -0.5)))]
    return moved(method, 1e-3, ropes=[one_segment()], anchors=held)


def hanging() -> dict[str, Any]:
    """A mass on one segment, at rest, and how it swings there."""
    top = [Anchor(name="top", node=0)]
    hung = scene("esdirk3", 1e-3, ropes=[one_segment()], anchors=top)
    rest, found = checked_shape(hung), modes(hung, count=3)
    out = simulate_in_memory(hung.replace(run=hung.run.replace(start="at-rest", duration=0.1)))
    told = check(hung.replace(gravity=(0, 0, -9.81)))
    return {
        "length": -float(rest.positions[1, 2]),
        "tension": float(rest.tension[0]),
        "frequencies": np.asarray(found.frequencies).tolist(),
        "stays": float(np.abs(out.positions - rest.positions).max()),
        "waves": list(told.ropes[0].longitudinal),
        "mass": float(told.ropes[0].own_mass),
    }


def bound() -> dict[str, Any]:
    """The largest step, and the speeds of small waves just below and above it."""
    kick = [{"node": 2, "velocity": (1e-6, 0, 0)}]
    stiff: dict[str, Any] = {"ropes": [rope(soft=Soft(time=1e3), kicks=kick)], "gravity": (0, 0, 0)}
    most = float(check(scene("verlet", 1e-4, **stiff)).stability.largest_step["verlet"])
    speeds = []
    for share in (0.98, 1.02):
        dt = share * most
        simulation = Simulation(scene("verlet", dt, dt * 60, **stiff))
        simulation.advance_steps(60)
        speeds.append(float(np.abs(simulation.arrays.v).max()))
    return {"most": most, "speeds": speeds, "k": K}


def said_of(**more: Any) -> str:
    """What is said of a scene that is refused."""
    try:
        build(scene("verlet", 1e-3, **more))
    except SceneError as error:
        return str(error)
    return ""


def wound(**more: Any) -> dict[str, Any]:
    """A rope that a winch pays out: its places, and what the books of motion miss [J]."""
    drum = {"anchors": [Anchor(name="drum", node=0)], "ropes": [rope(**more)]}
    drum["winches"] = [Winch(rope="rope", end="start", speed=0.5, on_drum=0.5)]  # type: ignore[list-item]
    simulation = Simulation(scene("esdirk3", 1e-3, **drum))
    first = simulation.recording().recording
    out = simulation.advance_frames(1).recording
    stored = float(simulation.arrays.work.winch[1])  # what it took or gave of what is stored
    missed = float(out.energy[0, 0] - first.energy[0, 0]) - float(out.work[0].sum()) + stored
    return {"x": simulation.arrays.x.tolist(), "unbooked": missed}


def newton() -> list[float]:
    """Orders of convergence of Newton's method, see `sample_segment_runs.newton`."""
    soft = Soft(bend=60.0)
    return base.orders(lambda taut: Softened(**(taut | {"soft": soft})))


def refused() -> dict[str, str]:
    """What is said of what cannot be."""
    wind = [Winch(rope="rope", end="start", speed=0.1)]
    stuff = {"EA": 100.0, "mass_per_length": 0.2, "relaxing_EA": 50.0, "relaxation_time": 0.1}
    both = rope(made_of={"kind": "material"} | stuff, length=1.0)
    return {
        "winch": said_of(ropes=[rope()], anchors=[Anchor(name="drum", node=0)], winches=wind),
        "limiter": said_of(ropes=[rope()], limiter=Limiter(max_stretch=1.5)),
        "two": said_of(ropes=[both]),
    }


def small() -> dict[str, Any]:
    """What compiled kernels are held against."""
    return {
        method: moved(method, 1e-3, time=0.02, ropes=[rope()])["bits"]
        for method in ("semi-implicit-euler", "esdirk3")
    }


def everything() -> dict[str, Any]:
    """All of it."""
    steps = {"adaptive": 1e-2} | dict.fromkeys(("semi-implicit-euler", "euler", "verlet"), 1e-4)
    own, plain = [rope()], [rope(soft=None)]
    two = [rope(), rope("other", 1.0, soft=None)]
    methods = {method: moved(method, steps.get(method, 1e-3), ropes=own) for method in METHODS}
    exact = moved("rk4", 1e-4, ropes=own)
    errors = {}
    for method in ("rk4", "heun", "verlet", "sdirk2", "bdf2", "esdirk3", "implicit-euler"):
        errors[method] = []
        for dt in (2e-3, 1e-3):
            x = np.array(moved(method, dt, ropes=own)["x"])
            errors[method].append(float(np.abs(x - np.array(exact["x"])).max()))
    return {
        "methods": methods,
        "exact": exact,
        "orders": {method: math.log2(a / b) for method, (a, b) in errors.items()},
        "without": moved("rk4", 1e-3, ropes=plain),
        "two": moved("esdirk3", 1e-3, ropes=two),
        "elastic": energetic(),
        "pulled": {
            method: pulled(method) for method in ("verlet", "rk4", "implicit-euler", "adaptive")
        },
        "newton": newton(),
        "hanging": hanging(),
        "bound": bound(),
        "wound": wound(soft=Soft(arm=0.0)),
        "wound without": wound(soft=None),
        "refused": refused(),
    }


if __name__ == "__main__":
    print(json.dumps({"newton": newton, "small": small, "all": everything}[sys.argv[1]]()))
