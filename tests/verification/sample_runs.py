"""What `test_added_law` runs in a copy of the package that has the sample law; prints its numbers as JSON."""

from __future__ import annotations

import json
import sys
from hashlib import sha256
from typing import Any

import numpy as np

from ropewalk.analysis.check import check
from ropewalk.laws.registry import NAMES
from ropewalk.lowering import build
from ropewalk.methods.recording import LAWS
from ropewalk.methods.stage import HISTORY, ITERATIONS
from ropewalk.scene import Anchor, Material, Rope, RunSettings, Scene, Springs, Straight
from ropewalk.scene.base import Model, Number, Vector, quantity, vector
from ropewalk.simulation import Simulation
from ropewalk.statics import checked_shape
from ropewalk.vibration import modes

N, MASS, K = 5, 0.05, 40.0
POINT = (0.3, 0.1, 0.2)


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


def scene(method: str, dt: float, time: float = 0.1, **more: Any) -> Sample:
    """A short rope of springs, one node kicked."""
    made_of = Springs(
        spring_constant=30.0, node_mass=MASS, segment_length=0.25, spring_friction=0.02
    )
    rope = Rope(
        name="rope",
        segments=N - 1,
        made_of=made_of,
        shape=Straight(end=(1.0, 0, 0)),
        kicks=[{"node": 2, "velocity": (0, 1.0, 0.5)}],
    )
    run = RunSettings(
        duration=time, frame_rate=1.0 / time, time_step=dt, steps="exact", method=method
    )
    return Sample(**({"ropes": [rope], "well": Well(), "run": run} | more))


def moved(method: str, dt: float, **more: Any) -> dict[str, Any]:
    """Run one; return places, bits, and what the books miss [J]."""
    simulation = Simulation(scene(method, dt, **more))
    first = simulation.recording().recording
    out = simulation.advance_frames(1).recording
    kinetic = float(out.energy[0, 0] - first.energy[0, 0])
    state = simulation.arrays
    drawn = float(out.work[0, LAWS.index("well")]) if "well" in LAWS else 0.0
    return {
        "x": state.x.tolist(),
        "bits": sha256(state.x.tobytes()).hexdigest()[:16],
        "unbooked": kinetic - float(out.work[0].sum()),
        "drawn": drawn,
        "error": float(np.abs(out.error_range).max()),
    }


def potential(x: np.ndarray) -> float:
    """U of all nodes [J]; written again."""
    square = ((x - np.array(POINT)[:, None]) ** 2).sum(axis=0)
    return float((K * (square / 2 + 2.0 * square**2 / 4)).sum())


def newton() -> list[float]:
    """Orders of convergence of Newton's method, as `test_implicit` takes them, of a taut rope."""
    stiff = Material(EA=1e3, mass_per_length=0.2)
    taut = Straight(end=(1.1, 0, 0))
    rope = Rope(name="rope", segments=8, length=1.0, made_of=stiff, shape=taut)
    ends = [Anchor(name="near", node=0), Anchor(name="far", node=-1)]
    well = Well(stiffness=20.0, stiffening=8.0)
    more: dict[str, Any] = {"ropes": [rope], "anchors": ends, "well": well}
    simulation = Simulation(scene("implicit-euler", 0.05, 0.5, **more))
    report, orders = simulation._engine._scratch.stage.report, []  # type: ignore[union-attr]
    for _ in range(10):
        simulation.step(0.05)
        merits = report[HISTORY : HISTORY + int(report[ITERATIONS]) + 1]
        falls = np.log(merits[1:] / merits[:-1])
        kept = (falls[:-1] < -6.0) & (merits[2:] > 1e-21 * merits[0])
        orders += list((falls[1:] / falls[:-1])[kept])
    return [float(order) for order in orders]


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
    stiff = {"well": Well(stiffness=5e4, stiffening=0.0), "time": 0.2}
    said = check(scene("verlet", 1e-4, **stiff)).stability
    most = float(said.largest_step["verlet"])
    far = []
    for share in (0.98, 1.02):
        simulation = Simulation(
            scene("verlet", share * most, share * most * 200, well=stiff["well"])
        )
        simulation.advance_steps(200)
        far.append(float(np.abs(simulation.arrays.x).max()))
    return {"most": most, "far": far}


def small() -> dict[str, Any]:
    """What compiled kernels are held against."""
    return {
        method: moved(method, 1e-3, time=0.02)["bits"]
        for method in ("semi-implicit-euler", "esdirk3")
    }


def everything() -> dict[str, Any]:
    """All of it."""
    two = scene("verlet", 1e-3).ropes
    other = two[0].replace(name="other", shape=Straight(start=(0, 1, 0), end=(1.0, 1, 0)))
    held_end = [Anchor(name="near", node=0)]
    model = build(scene("verlet", 1e-3))
    return {
        "names": NAMES,
        "laws": LAWS,
        "table": list(model.system.node.well._fields),
        "start": potential(model.state.x),
        "verlet": moved("verlet", 1e-4),
        "semi-implicit-euler": moved("semi-implicit-euler", 1e-4),
        "rk4": moved("rk4", 1e-3),
        "esdirk3": moved("esdirk3", 1e-3),
        "adaptive": moved("adaptive", 1e-2),
        "generalized-alpha": moved("generalized-alpha", 1e-3),
        "without": moved("rk4", 1e-3, well=None),
        "anchored": moved("rk4", 1e-3, anchors=held_end),
        "two": moved("esdirk3", 1e-3, ropes=[*two, other]),
        "newton": newton(),
        "held": held(),
        "bound": bound(),
    }


if __name__ == "__main__":
    print(json.dumps({"newton": newton, "small": small, "all": everything}[sys.argv[1]]()))
