"""Running scenes for the claims and reading what happened."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.core.status import OK
from ropewalk.lowering import build
from ropewalk.scene import Scene
from ropewalk.scene.overrides import apply_overrides
from ropewalk.scene.presets import preset
from ropewalk.simulation import Simulation
from ropewalk.simulation.block import join
from ropewalk.statics import Statics, static_shape


@dataclass(frozen=True)
class Run:
    """A recorded run, with the initial frame."""

    scene: Scene
    dt: float  # [s]
    time: Floats  # (f,) [s]
    x: Floats  # (f, n, 3) [m]
    v: Floats  # (f, n, 3) [m/s]
    tension: Floats  # (f, s) [N]
    energy: Floats  # (f, 3) kinetic, gravity, elastic [J]
    mass: Floats  # (n,) [kg]
    rest: Floats  # (s,) [m]
    broke: bool

    @property
    def total(self) -> Floats:
        """Total energy [J], (f,)."""
        return np.asarray(self.energy.sum(axis=1))

    @property
    def stretch(self) -> Floats:
        """Length over rest length of every segment [1], (f, s)."""
        return np.asarray(np.linalg.norm(np.diff(self.x, axis=1), axis=2) / self.rest)

    @property
    def largest_stretch(self) -> float:
        """Largest length over rest length of any segment at any recorded time [1]."""
        return float(self.stretch.max())

    @property
    def speed(self) -> Floats:
        """Speed of every node [m/s], (f, n)."""
        return np.asarray(np.linalg.norm(self.v, axis=2))

    def at(self, time: float) -> int:
        """Return the frame nearest to a time [s]."""
        return int(np.abs(self.time - time).argmin())


def changed(scene: Scene | str, *overrides: str) -> Scene:
    """Return a preset or a scene with some values changed (`rope.segments=20`)."""
    return apply_overrides(preset(scene) if isinstance(scene, str) else scene, overrides)


def record(scene: Scene, *, keep_going: bool = False, verdict: bool = False) -> Run:
    """Run a scene to its end, or to its last good frame when it breaks.

    A run breaks when a spring is ten times its length; with `verdict` also when its energy is made up, as
    every run does that people start.
    """
    sim = Simulation(scene, ledger=False)
    block = join([sim.recording(), *sim.frames(keep_going=keep_going or not verdict)])
    broke = block.status != OK
    if not (keep_going or verdict):
        rest = sim.model.state.rest_length
        with np.errstate(over="ignore", invalid="ignore"):
            length = np.linalg.norm(np.diff(block.recording.x, axis=2), axis=1)
        sound = ((length <= sim.system.break_stretch * rest) | (rest == 0.0)).all(axis=1)
        broke = not sound.all()
        block = block.head(int(np.argmin(sound)) if broke else block.frames)
    out = block.recording
    return Run(
        scene=scene,
        dt=sim.plan.dt,
        time=block.time,
        x=np.ascontiguousarray(out.x.transpose(0, 2, 1)),
        v=np.ascontiguousarray(out.v.transpose(0, 2, 1)),
        tension=out.tension,
        energy=out.energy,
        mass=sim.model.state.mass.copy(),
        rest=sim.model.state.rest_length.copy(),
        broke=broke,
    )


def with_points(scene: Scene, points: Floats) -> Scene:
    """Return a scene of one rope whose nodes start at given places [m], (n, 3)."""
    table = scene.table()
    table["rope"][0]["shape"] = {"kind": "points", "points": points.tolist()}
    return Scene.model_validate(table)


def at_rest(scene: Scene) -> tuple[Scene, Statics]:
    """Return the scene started in its rest shape, and that shape."""
    statics = static_shape(scene)
    return with_points(scene, statics.positions), statics


def log_growth(scene: Scene, steps: int) -> float:
    """Return the measured logarithmic growth of a small zigzag per step [1]; inf when it breaks.

    A straight chain without weight, its free nodes pushed along it to and fro by a millionth of a
    segment. The first half of the steps is left out, in which other modes still ring.
    """
    model = build(scene)
    x = np.ascontiguousarray(model.state.x.T)
    free = np.ones(len(x), dtype=bool)
    free[list(model.layout.anchor_nodes)] = False
    zigzag = np.where(np.arange(len(x)) % 2 == 0, 1e-6, -1e-6) * free
    x[:, 0] += zigzag * float(model.state.rest_length.max())
    table = with_points(scene, x).table()
    table["gravity"] = [0.0, 0.0, 0.0]
    frames, dt = 64, model.plan.dt
    each = steps // frames
    table["run"] |= {"steps": "exact", "time_step": dt, "frame_rate": 1.0 / (each * dt)}
    table["run"]["duration"] = frames * each * dt
    run = record(Scene.model_validate(table))
    energy = run.total
    large = np.flatnonzero(energy > 1e6 * energy[0])  # grown out of the small: it saturates
    if large.size and math.isfinite(energy[large[0]]):
        return 0.5 * math.log(energy[large[0]] / energy[0]) / (int(large[0]) * each)
    if run.broke or not np.isfinite(energy).all():
        return math.inf
    half = slice(frames // 2, None)
    step = np.arange(len(energy)) * each
    return 0.5 * float(np.polyfit(step[half], np.log(energy[half]), 1)[0])


def bisect(grows: Callable[[float], bool], low: float, high: float, relative: float) -> float:
    """Return where a run begins to grow, between a value at which it does not and one at which."""
    if grows(low) or not grows(high):
        return math.nan
    while high - low > relative * high:
        middle = 0.5 * (low + high)
        low, high = (low, middle) if grows(middle) else (middle, high)
    return 0.5 * (low + high)
