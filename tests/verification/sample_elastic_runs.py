"""What `test_added_elastic_law` runs in a copy of the package that has the sample law; prints its numbers."""

from __future__ import annotations

import math
from functools import partial
from typing import Any

import numpy as np
import sample_scenes as base
from sample_scenes import K

from ropewalk.analysis.check import check
from ropewalk.scene import Anchor, Material, Rope, Scene, Winch
from ropewalk.scene.base import Many, Model, Number, listed, quantity
from ropewalk.simulation import Simulation


class Soft(Model):
    """The section of the sample law."""

    bend: Number = quantity("b", "1", default=4.0)
    arm: Number = quantity("a", "1", default=0.4)
    time: Number = quantity("tau", "s", default=0.03)
    reach: Number = quantity("No segment is strained by more", "1", default=1.0)


class Softened(Rope):
    """A rope with that section."""

    soft: Soft | None = Soft()


class Sample(Scene):
    """A scene of such ropes."""

    ropes: Many[Softened] = listed("Ropes", "rope", "ropes", default=())


rope = partial(base.rope, Softened)
one_segment = partial(base.one_segment, Softened)


def scene(method: str, dt: float, time: float = 0.1, **more: Any) -> Sample:
    """A scene of that rope."""
    return Sample(**({"ropes": [rope()], "run": base.settings(method, dt, time)} | more))


def moved(method: str, dt: float, **more: Any) -> dict[str, Any]:
    """Run one; return its numbers."""
    return base.moved(scene(method, dt, **more), "soft")


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
    """A segment that is drawn out for 0.1 s."""
    return moved(method, 1e-3, ropes=[one_segment()], anchors=base.pulled_ends())


def hanging() -> dict[str, Any]:
    """A mass on one segment, at rest, how it swings there, and how fast waves are."""
    hung = scene("esdirk3", 1e-3, ropes=[one_segment()], anchors=[Anchor(name="top", node=0)])
    told = check(hung.replace(gravity=(0, 0, -9.81)))
    waves = list(told.ropes[0].longitudinal)
    return base.hanging(hung) | {"waves": waves, "mass": float(told.ropes[0].own_mass)}


def bound() -> dict[str, Any]:
    """The largest step, and the speeds of small waves just below and above it."""
    kick = [{"node": 2, "velocity": (1e-6, 0, 0)}]
    stiff: dict[str, Any] = {"ropes": [rope(soft=Soft(time=1e3), kicks=kick)], "gravity": (0, 0, 0)}
    most = float(check(scene("verlet", 1e-4, **stiff)).stability.largest_step["verlet"])
    speeds = base.beside(most, 60, lambda dt, time: scene("verlet", dt, time, **stiff), "v")
    return {"most": most, "speeds": speeds, "k": K}


def wound(**more: Any) -> dict[str, Any]:
    """A rope that a winch pays out: its places, and what the books of motion miss [J]."""
    drum: dict[str, Any] = {"anchors": [Anchor(name="drum", node=0)], "ropes": [rope(**more)]}
    drum["winches"] = [Winch(rope="rope", end="start", speed=0.5, on_drum=0.5)]
    simulation = Simulation(scene("esdirk3", 1e-3, **drum))
    first = simulation.recording().recording
    out = simulation.advance_frames(1).recording
    stored = float(simulation.arrays.work.winch[1])  # what it took or gave of what is stored
    missed = float(out.energy[0, 0] - first.energy[0, 0]) - float(out.work[0].sum()) + stored
    return {"x": simulation.arrays.x.tolist(), "unbooked": missed}


def newton() -> list[float]:
    """Orders of convergence of Newton's method of a taut rope."""
    taut = base.taut(Softened, Material(EA=200.0, mass_per_length=0.2), 1.02, soft=Soft(bend=60.0))
    return base.orders(scene("implicit-euler", 0.05, 0.5, **taut))


def refused() -> dict[str, str]:
    """What is said of what cannot be."""
    stuff = {"EA": 100.0, "mass_per_length": 0.2, "relaxing_EA": 50.0, "relaxation_time": 0.1}
    both = rope(made_of={"kind": "material"} | stuff, length=1.0)
    asked: dict[str, dict[str, Any]] = {
        "two": {"ropes": [both]},
    }
    return {name: base.said_of(scene("verlet", 1e-3, **more)) for name, more in asked.items()}


def everything() -> dict[str, Any]:
    """All of it."""
    exact = moved("rk4", 1e-4)
    errors = {}
    for method in ("rk4", "heun", "verlet", "sdirk2", "bdf2", "esdirk3", "implicit-euler"):
        errors[method] = []
        for dt in (2e-3, 1e-3):
            x = np.array(moved(method, dt)["x"])
            errors[method].append(float(np.abs(x - np.array(exact["x"])).max()))
    return {
        "methods": base.every_method(moved),
        "exact": exact,
        "orders": {method: math.log2(a / b) for method, (a, b) in errors.items()},
        "without": moved("rk4", 1e-3, ropes=[rope(soft=None)]),
        "two": moved("esdirk3", 1e-3, ropes=[rope(), rope("other", 1.0, soft=None)]),
        "elastic": energetic(),
        "pulled": {
            method: pulled(method) for method in ("verlet", "rk4", "implicit-euler", "adaptive")
        },
        "newton": newton(),
        "hanging": hanging(),
        "bound": bound(),
        "wound": wound(),
        "wound without": wound(soft=None),
        "refused": refused(),
    }


if __name__ == "__main__":
    base.tell(newton, lambda method: moved(method, 1e-3, time=0.02), everything)
