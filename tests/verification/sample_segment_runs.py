"""What `test_added_segment_law` runs in a copy of the package that has the sample law; prints its numbers."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable
from hashlib import sha256
from typing import Any

import numpy as np

from ropewalk.analysis.check import check
from ropewalk.lowering import build
from ropewalk.methods.recording import remembering, work_names
from ropewalk.methods.registry import METHODS
from ropewalk.methods.stage import HISTORY, ITERATIONS
from ropewalk.record.simulate import simulate_in_memory
from ropewalk.scene import (
    Anchor,
    Material,
    Rope,
    RunSettings,
    Scene,
    SceneError,
    Springs,
    Straight,
    Winch,
)
from ropewalk.scene.base import Many, Model, Number, listed, quantity
from ropewalk.scene.motions import Velocity
from ropewalk.simulation import Simulation
from ropewalk.statics import checked_shape
from ropewalk.vibration import modes

N, MASS, K, L = 5, 0.05, 30.0, 0.25


class Fibre(Model):
    """The section of the sample law."""

    cubic: Number = quantity("a", "N/m^3", default=900.0)
    arm: Number = quantity("b", "N/m", default=20.0)
    time: Number = quantity("tau", "s", default=0.03)
    reach: Number = quantity("No segment is stretched by more", "m", default=0.2)


class Fibred(Rope):
    """A rope with that section."""

    fibre: Fibre | None = None


class Sample(Scene):
    """A scene of such ropes."""

    ropes: Many[Fibred] = listed("Ropes", "rope", "ropes", default=())


def rope(name: str = "rope", y: float = 0.0, **more: Any) -> Fibred:
    """A short rope of springs, one node kicked."""
    made_of = Springs(spring_constant=K, node_mass=MASS, segment_length=L, spring_friction=0.02)
    shape = Straight(start=(0, y, 0), end=(1.0, y, 0))
    fields: dict[str, Any] = {"segments": N - 1, "made_of": made_of, "shape": shape}
    fields |= {"fibre": Fibre(), "kicks": [{"node": 2, "velocity": (0.5, 3.0, 1.5)}]}
    return Fibred(name=name, **(fields | more))


def scene(method: str, dt: float, time: float = 0.1, **more: Any) -> Sample:
    """A scene of that rope."""
    run = RunSettings(
        duration=time, frame_rate=1.0 / time, time_step=dt, steps="exact", method=method
    )
    return Sample(**({"ropes": [rope()], "run": run} | more))


def moved(method: str, dt: float, **more: Any) -> dict[str, Any]:
    """Run one; return places, bits, and what the books miss [J]."""
    simulation = Simulation(scene(method, dt, **more))
    first = simulation.recording().recording
    out = simulation.advance_frames(1).recording
    state = simulation.arrays
    names = work_names(False, remembering(state))
    drawn = float(out.work[0, names.index("fibre")]) if "fibre" in names else 0.0
    return {
        "x": state.x.tolist(),
        "bits": sha256(state.x.tobytes()).hexdigest()[:16],
        "unbooked": float(out.energy[0, 0] - first.energy[0, 0]) - float(out.work[0].sum()),
        "drawn": drawn,
        "work": float(out.work[0].sum()),
        "names": names,
        "tension": out.tension[0].tolist(),
        "elastic": out.elastic_tension[0].tolist(),
        "highest": out.tension_high[0].tolist(),
        "touched": out.contact.shape[2],
    }


def newton() -> list[float]:
    """Orders of convergence of Newton's method of a taut rope with a stiff law."""
    return orders(lambda taut: Fibred(**(taut | {"fibre": Fibre(cubic=4e5, arm=800.0)})))


def orders(make: Callable[[dict[str, Any]], Fibred]) -> list[float]:
    """Orders of convergence of Newton's method, as `test_implicit` takes them, of a taut rope; see there."""
    soft = Material(EA=200.0, mass_per_length=0.2)
    taut = {"name": "rope", "segments": 8, "length": 1.0, "made_of": soft}
    taut |= {"shape": Straight(end=(1.02, 0, 0))}
    ends = [Anchor(name="near", node=0), Anchor(name="far", node=-1)]
    simulation = Simulation(scene("implicit-euler", 0.05, 0.5, ropes=[make(taut)], anchors=ends))
    report, found = simulation._engine._scratch.stage.report, []  # type: ignore[union-attr]
    for _ in range(10):
        simulation.step(0.05)
        merits = report[HISTORY : HISTORY + int(report[ITERATIONS]) + 1]
        falls = np.log(merits[1:] / merits[:-1])
        kept = (falls[:-1] < -6.0) & (merits[2:] > 1e-21 * merits[0])
        found += list((falls[1:] / falls[:-1])[kept])
    return [float(order) for order in found]


def one_segment(**more: Any) -> Fibred:
    """A segment of springs at its length, hanging straight down, at rest."""
    down = Straight(end=(0, 0, -L))
    return rope(segments=1, shape=down, kicks=[], **more)


def pulled(method: str) -> dict[str, Any]:
    """A segment both ends of which are held, the lower one drawn away at 0.5 m/s for 0.1 s."""
    held = [Anchor(name="top", node=0)]
    held += [Anchor(name="end", node=1, motion=Velocity(velocity=(0, 0, -0.5)))]
    kept = scene(method, 1e-3, ropes=[one_segment()], anchors=held)
    return moved(method, 1e-3, ropes=list(kept.ropes), anchors=held)


def hanging() -> dict[str, Any]:
    """A mass on one segment, at rest, and how it swings there."""
    hung = scene("esdirk3", 1e-3, ropes=[one_segment()], anchors=[Anchor(name="top", node=0)])
    rest, found = checked_shape(hung), modes(hung, count=3)
    run = hung.run.replace(start="at-rest", duration=0.1)
    out = simulate_in_memory(hung.replace(run=run))
    return {
        "length": -float(rest.positions[1, 2]),
        "tension": float(rest.tension[0]),
        "elastic": float(rest.elastic_tension[0]),
        "frequencies": np.asarray(found.frequencies).tolist(),
        "stays": float(np.abs(out.positions - rest.positions).max()),
    }


def bound() -> dict[str, Any]:
    """The largest step with a stiff arm that hardly gives, and the speeds just below and above it."""
    kick = [{"node": 2, "velocity": (0.01, 0, 0)}]
    stiff: dict[str, Any] = {"ropes": [rope(fibre=Fibre(cubic=0.0, arm=5e3, time=1e3), kicks=kick)]}
    stiff |= {"gravity": (0, 0, 0)}
    most = float(check(scene("verlet", 1e-4, **stiff)).stability.largest_step["verlet"])
    speeds = []
    for share in (0.98, 1.02):
        dt = share * most
        simulation = Simulation(scene("verlet", dt, dt * 60, **stiff))
        simulation.advance_steps(60)
        speeds.append(float(np.abs(simulation.arrays.v).max()))
    return {"most": most, "speeds": speeds}


def refused() -> str:
    """What is said of a winch."""
    end = [Anchor(name="drum", node=0)]
    try:
        build(
            scene("verlet", 1e-3, anchors=end, winches=[Winch(rope="rope", end="start", speed=0.1)])
        )
    except SceneError as error:
        return str(error)
    return ""


def small() -> dict[str, Any]:
    """What compiled kernels are held against."""
    return {
        method: moved(method, 1e-3, time=0.02)["bits"]
        for method in ("semi-implicit-euler", "esdirk3")
    }


def everything() -> dict[str, Any]:
    """All of it."""
    steps = {"adaptive": 1e-2} | dict.fromkeys(("semi-implicit-euler", "euler", "verlet"), 1e-4)
    elastic = [rope(fibre=Fibre(arm=0.0))]
    return {
        "methods": {method: moved(method, steps.get(method, 1e-3)) for method in METHODS},
        "elastic": moved("rk4", 1e-3, ropes=elastic),
        "without": moved("rk4", 1e-3, ropes=[rope(fibre=None)]),
        "two": moved("esdirk3", 1e-3, ropes=[rope(), rope("other", 1.0, fibre=None)]),
        "alone": moved("esdirk3", 1e-3),
        "pulled": {
            method: pulled(method) for method in ("verlet", "rk4", "implicit-euler", "adaptive")
        },
        "newton": newton(),
        "hanging": hanging(),
        "bound": bound(),
        "refused": refused(),
    }


if __name__ == "__main__":
    print(json.dumps({"newton": newton, "small": small, "all": everything}[sys.argv[1]]()))
