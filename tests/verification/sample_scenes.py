"""What the scripts of the sample laws share: a short rope of springs, and what is asked of runs of it."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable
from hashlib import sha256
from typing import Any, TypeVar

import numpy as np

from ropewalk.lowering import build
from ropewalk.methods.recording import remembering, work_names
from ropewalk.methods.registry import METHODS
from ropewalk.methods.stage_report import HISTORY, ITERATIONS
from ropewalk.record.simulate import simulate_in_memory
from ropewalk.scene import Anchor, Rope, RunSettings, Scene, SceneError, Springs, Straight
from ropewalk.scene.motions import Velocity
from ropewalk.simulation import Simulation
from ropewalk.statics import checked_shape
from ropewalk.vibration import modes

N, MASS, K, L = 5, 0.05, 30.0, 0.25
STEPS = {"adaptive": 1e-2} | dict.fromkeys(("semi-implicit-euler", "euler", "verlet"), 1e-4)
Kind = TypeVar("Kind", bound=Rope)


def step_of(method: str) -> float:
    """Return a step that a method takes well [s]."""
    return STEPS.get(method, 1e-3)


def settings(method: str, dt: float, time: float) -> RunSettings:
    """Return settings of a run of one frame."""
    return RunSettings(
        duration=time, frame_rate=1.0 / time, time_step=dt, steps="exact", method=method
    )


def rope(kind: type[Kind], name: str = "rope", y: float = 0.0, **more: Any) -> Kind:
    """A short rope of springs, one node kicked."""
    made_of = Springs(spring_constant=K, node_mass=MASS, segment_length=L, spring_friction=0.02)
    shape = Straight(start=(0, y, 0), end=(1.0, y, 0))
    fields: dict[str, Any] = {"segments": N - 1, "made_of": made_of, "shape": shape}
    fields |= {"kicks": [{"node": 2, "velocity": (0.5, 3.0, 1.5)}]}
    return kind(name=name, **(fields | more))


def one_segment(kind: type[Kind], **more: Any) -> Kind:
    """A segment of springs at its length, hanging straight down, at rest."""
    return rope(kind, segments=1, shape=Straight(end=(0, 0, -L)), kicks=[], **more)


def pulled_ends() -> list[Anchor]:
    """Both ends of a segment are held, the lower one drawn away at 0.5 m/s."""
    away = Velocity(velocity=(0, 0, -0.5))
    return [Anchor(name="top", node=0), Anchor(name="end", node=1, motion=away)]


def moved(scene: Scene, law: str) -> dict[str, Any]:
    """Run a scene for a frame; return places, bits, tensions, and what the books miss [J]."""
    simulation = Simulation(scene)
    first = simulation.recording().recording
    out = simulation.advance_frames(1).recording
    state = simulation.arrays
    names = work_names(False, remembering(state))
    return {
        "x": state.x.tolist(),
        "bits": sha256(state.x.tobytes()).hexdigest()[:16],
        "unbooked": float(out.energy[0, 0] - first.energy[0, 0]) - float(out.work[0].sum()),
        "drawn": float(out.work[0, names.index(law)]) if law in names else 0.0,
        "work": float(out.work[0].sum()),
        "error": float(np.abs(out.error_range).max()),
        "names": names,
        "tension": out.tension[0].tolist(),
        "elastic": out.elastic_tension[0].tolist(),
        "highest": out.tension_high[0].tolist(),
        "touched": out.contact.shape[2],
    }


def orders(scene: Scene) -> list[float]:
    """Orders of convergence of Newton's method in ten steps of 0.05 s, as `test_implicit` takes them."""
    simulation = Simulation(scene)
    report, found = simulation._engine._scratch.stage.report, []  # type: ignore[union-attr]
    for _ in range(10):
        simulation.step(0.05)
        merits = report[HISTORY : HISTORY + int(report[ITERATIONS]) + 1]
        falls = np.log(merits[1:] / merits[:-1])
        kept = (falls[:-1] < -6.0) & (merits[2:] > 1e-21 * merits[0])
        found += list((falls[1:] / falls[:-1])[kept])
    return [float(order) for order in found]


def taut(kind: type[Kind], made_of: Any, length: float, **more: Any) -> dict[str, Any]:
    """A taut rope of a metre, for `orders`, and anchors that hold it, as fields of a scene."""
    shape = Straight(end=(length, 0, 0))
    made = kind(name="rope", segments=8, length=1.0, made_of=made_of, shape=shape, **more)
    return {"ropes": [made], "anchors": [Anchor(name="near", node=0), Anchor(name="far", node=-1)]}


def beside(
    most: float, steps: int, make: Callable[[float, float], Scene], what: str
) -> list[float]:
    """Return the largest number of an array after steps just below and above the largest stable one."""
    found = []
    for share in (0.98, 1.02):
        dt = share * most
        simulation = Simulation(make(dt, dt * steps))
        simulation.advance_steps(steps)
        found.append(float(np.abs(getattr(simulation.arrays, what)).max()))
    return found


def hanging(hung: Scene) -> dict[str, Any]:
    """A mass on one segment, at rest, and how it swings there."""
    rest, found = checked_shape(hung), modes(hung, count=3)
    out = simulate_in_memory(hung.replace(run=hung.run.replace(start="at-rest", duration=0.1)))
    return {
        "length": -float(rest.positions[1, 2]),
        "tension": float(rest.tension[0]),
        "elastic": float(rest.elastic_tension[0]),
        "frequencies": np.asarray(found.frequencies).tolist(),
        "stays": float(np.abs(out.positions - rest.positions).max()),
    }


def said_of(scene: Scene) -> str:
    """What is said of a scene that is refused."""
    try:
        build(scene)
    except SceneError as error:
        return str(error)
    return ""


def every_method(move: Callable[[str, float], dict[str, Any]]) -> dict[str, Any]:
    """Return what a run gives in every method."""
    return {method: move(method, step_of(method)) for method in METHODS}


def tell(
    newton: Callable[[], list[float]],
    small: Callable[[str], dict[str, Any]],
    everything: Callable[[], dict[str, Any]],
) -> None:
    """Print, as JSON, what the command line asks for; `small` is what kernels are held against, by method."""

    def bits() -> dict[str, str]:
        return {method: small(method)["bits"] for method in ("semi-implicit-euler", "esdirk3")}

    asked = {"newton": newton, "small": bits, "all": everything}[sys.argv[1]]
    print(json.dumps(asked()))
