"""What `test_added_law` runs in a copy of the package that has the sample law; prints its numbers as JSON."""

from __future__ import annotations

from typing import Any

import numpy as np
import sample_scenes as base
from sample_scenes import N

from ropewalk.analysis.check import check
from ropewalk.laws.registry import NAMES
from ropewalk.lowering import build
from ropewalk.methods.recording import LAWS
from ropewalk.methods.registry import METHODS
from ropewalk.scene import Anchor, Material, Rope, Scene
from ropewalk.scene.base import Model, Number, Vector, quantity, vector
from ropewalk.statics import checked_shape
from ropewalk.vibration import modes

K = 40.0
POINT = (0.3, 0.1, 0.2)
STEPS = {
    "euler": 5e-5,
    "semi-implicit-euler": 1e-4,
    "verlet": 1e-4,
    "implicit-euler": 1e-4,
    "adaptive": 1e-2,
}


class Well(Model):
    """The section of the sample law."""

    point: Vector = vector("Where nodes are drawn to", "m", default=POINT)
    stiffness: Number = quantity("k", "N/m", default=K)
    stiffening: Number = quantity("s", "1/m^2", default=2.0)
    friction: Number = quantity("c", "N s/m", default=0.0)
    reach: Number = quantity("No node is farther", "m", default=1.5)


class Sample(Scene):
    """A scene with that section."""

    well: Well | None = None


def rope(name: str = "rope", y: float = 0.0) -> Rope:
    """A short rope of springs, one node kicked."""
    return base.rope(Rope, name, y, kicks=[{"node": 2, "velocity": (0, 1.0, 0.5)}])


def scene(method: str, dt: float, time: float = 0.1, **more: Any) -> Sample:
    """A scene of that rope."""
    run = base.settings(method, dt, time)
    return Sample(**({"ropes": [rope()], "well": Well(), "run": run} | more))


def moved(method: str, dt: float, **more: Any) -> dict[str, Any]:
    """Run one; return its numbers."""
    return base.moved(scene(method, dt, **more), "well")


def potential(x: np.ndarray) -> float:
    """U of all nodes [J]; written again."""
    square = ((x - np.array(POINT)[:, None]) ** 2).sum(axis=0)
    return float((K * (square / 2 + 2.0 * square**2 / 4)).sum())


def newton() -> list[float]:
    """Orders of convergence of Newton's method of a taut rope."""
    taut = base.taut(Rope, Material(EA=1e3, mass_per_length=0.2), 1.1)
    well = Well(stiffness=20.0, stiffening=8.0)
    return base.orders(scene("implicit-euler", 0.05, 0.5, well=well, **taut))


def held() -> dict[str, Any]:
    """A rope that nothing holds but the well: its shape of rest, and its modes without weight."""
    linear = Well(stiffening=0.0)
    rest = checked_shape(scene("verlet", 1e-3, well=linear))
    light = scene("verlet", 1e-3, well=linear, gravity=(0, 0, 0))
    found = modes(light, count=3 * N)
    return {
        "middle": rest.positions.mean(axis=0).tolist(),
        "frequencies": np.asarray(found.frequencies).tolist(),
    }


def bound() -> dict[str, Any]:
    """The largest step of a heavy well, and how far nodes get in steps just below and above it."""
    stiff = Well(stiffness=5e4, stiffening=0.0)
    said = check(scene("verlet", 1e-4, well=stiff, time=0.2)).stability
    most = float(said.largest_step["verlet"])
    far = base.beside(most, 200, lambda dt, time: scene("verlet", dt, time, well=stiff), "x")
    return {"most": most, "far": far}


def everything() -> dict[str, Any]:
    """All of it."""
    held_end = [Anchor(name="near", node=0)]
    model = build(scene("verlet", 1e-3))
    return {
        "names": NAMES,
        "laws": LAWS,
        "table": list(model.system.node.well._fields),
        "start": potential(model.state.x),
        **{method: moved(method, STEPS.get(method, 1e-3)) for method in METHODS},
        "coarse": {name: moved(name, 2.0 * STEPS[name]) for name in ("euler", "implicit-euler")},
        "without": moved("rk4", 1e-3, well=None),
        "anchored": moved("rk4", 1e-3, anchors=held_end),
        "two": moved("esdirk3", 1e-3, ropes=[rope(), rope("other", 1.0)]),
        "newton": newton(),
        "held": held(),
        "bound": bound(),
    }


if __name__ == "__main__":
    base.tell(newton, lambda method: moved(method, 1e-3, time=0.02), everything)
