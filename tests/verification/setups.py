"""Small scenes and exact schemes that the verification tests share."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ropewalk.core.status import OK
from ropewalk.methods.loop import prepare
from ropewalk.methods.recording import LAWS
from ropewalk.methods.registry import METHODS
from ropewalk.scene import Anchor, Points, Rope, RunSettings, Scene, Springs
from ropewalk.simulation import Simulation
from ropewalk.simulation.block import Block, join

ALL = tuple(name for name, method in METHODS.items() if method.fixed)
IMPLICIT = tuple(name for name in ALL if METHODS[name].implicit)
EXPLICIT = tuple(name for name in ALL if name not in IMPLICIT)
SYMPLECTIC = ("semi-implicit-euler", "verlet")
NO_GRAVITY = (0.0, 0.0, 0.0)
DOWN = (0.0, -9.81, 0.0)  # y is up
g = 9.81
FACTORIAL = (1.0, 1.0, 2.0, 6.0, 24.0)
RUNGE_KUTTA_STAGES = {"euler": 1, "heun": 2, "rk4": 4}
GAMMA = 1.0 - math.sqrt(0.5)  # of SDIRK2


def springs(k: float, m: float, length: float, c: float = 0.0, **more: Any) -> Springs:
    """Springs in the short symbols of the formulas."""
    return Springs(spring_constant=k, node_mass=m, segment_length=length, spring_friction=c, **more)


def chain(points: np.ndarray, made_of: Any, **more: Any) -> Rope:
    """A rope with its nodes at `points` (n, 3) [m]."""
    places = [tuple(float(c) for c in point) for point in points]
    return Rope(segments=len(places) - 1, made_of=made_of, shape=Points(points=places), **more)


def along_x(x: Sequence[float] | np.ndarray) -> np.ndarray:
    """Points on the x axis, (n, 3) [m]."""
    points = np.zeros((len(x), 3))
    points[:, 0] = x
    return points


def hold(*nodes: int) -> list[Anchor]:
    """Fixed anchors at nodes."""
    return [Anchor(node=node) for node in nodes]


def scene(
    rope: Rope | list[Rope],
    anchors: Sequence[Anchor] = (),
    *,
    dt: float,
    steps: int,
    method: str = "semi-implicit-euler",
    every: int = 1,
    gravity: Sequence[float] = NO_GRAVITY,
    **more: Any,
) -> Scene:
    """A scene of exactly `steps` steps of `dt` [s], with a frame after `every` steps."""
    run = RunSettings(
        duration=steps * dt,
        frame_rate=1.0 / (every * dt),
        time_step=dt,
        steps="exact",
        method=method,
    )
    return Scene(ropes=rope, anchors=list(anchors), gravity=gravity, run=run, **more)


@dataclass
class Film:
    """A whole run, the initial frame included; the first index is the frame."""

    block: Block
    simulation: Simulation

    @property
    def t(self) -> np.ndarray:
        return self.block.time

    @property
    def x(self) -> np.ndarray:
        """Positions (f, n, 3) [m]."""
        return self.block.recording.x.transpose(0, 2, 1)

    @property
    def v(self) -> np.ndarray:
        """Velocities (f, n, 3) [m/s]."""
        return self.block.recording.v.transpose(0, 2, 1)

    @property
    def total(self) -> np.ndarray:
        """Kinetic, gravity and elastic energy together (f,) [J]."""
        return self.block.recording.energy.sum(axis=1)

    def work(self, law: str) -> np.ndarray:
        """Accumulated work of a law, or of all anchors (f,) [J]."""
        work = self.block.recording.work
        return work[:, len(LAWS) :].sum(axis=1) if law == "anchors" else work[:, LAWS.index(law)]

    def residual(self, without: str = "") -> np.ndarray:
        """Kinetic energy gained minus all works (f,) [J]; `without` forgets one law, for twins."""
        kinetic = self.block.recording.energy[:, 0]
        laws = [*(name for name in LAWS if name not in ("limiter", "winch")), "anchors"]
        done = sum(self.work(law) for law in laws if law != without)
        jumps = self.block.recording.jump[:, [name != without for name in ("limiter", "winch")]]
        return kinetic - kinetic[0] - done - jumps.sum(axis=1)

    def energy_error(self) -> np.ndarray:
        """Energy gained minus the work of all that is not a potential (f,) [J]."""
        laws = ("friction", "air", "ground", "applied", "limiter", "winch", "anchors")
        return self.total - self.total[0] - sum(self.work(law) for law in laws)


def run(what: Scene | Simulation, *, ok: bool = True, keep_going: bool = False) -> Film:
    """Run a scene to its end, or until it breaks when `ok` is False, or on into the break."""
    simulation = what if isinstance(what, Simulation) else Simulation(what)
    blocks = [simulation.recording(), *simulation.frames(keep_going=keep_going)]
    assert not ok or keep_going or blocks[-1].status == OK, "the run broke"
    return Film(join(blocks), simulation)


def off(measured: Any, expected: Any) -> float:
    """Largest difference between two arrays; inf when something is not finite."""
    difference = np.abs(np.asarray(measured, float) - np.asarray(expected, float)).max()
    return float(difference) if np.isfinite(difference) else float("inf")


def step_matrix(method: str, a: float, b: float) -> np.ndarray:
    """One step of a mode x'' + (b/dt) x' + (a/dt^2) x = 0 on (x, v dt), Verlet: (x, v dt, f dt^2).

    From the definitions of the schemes: Runge-Kutta methods of order p with p stages multiply by the
    first p + 1 terms of exp(A dt) (Hairer, Norsett & Wanner, Solving ODEs II, IV.2).
    """
    if method == "semi-implicit-euler":
        kick = np.array([[1.0, 0.0], [-a, 1.0 - b]])
        return np.array([[1.0, 1.0], [0.0, 1.0]]) @ kick
    if method == "verlet":
        x1 = np.array([1.0, 1.0, 0.5])
        f1 = -a * x1 - b * np.array([0.0, 1.0, 1.0])
        return np.array([x1, np.array([0.0, 1.0, 0.5]) + 0.5 * f1, f1])
    A = np.array([[0.0, 1.0], [-a, -b]])
    if method in IMPLICIT:
        return implicit_step_matrix(method, A)
    powers = [np.linalg.matrix_power(A, p) for p in range(RUNGE_KUTTA_STAGES[method] + 1)]
    return sum(power / FACTORIAL[p] for p, power in enumerate(powers))


def implicit_step_matrix(method: str, A: np.ndarray) -> np.ndarray:
    """One step of an implicit method on (x, v dt) of x' = A x; BDF2 on two such pairs, the newer first,
    generalized-alpha (rho 0.8) with a dt^2 as well.

    Implicit Euler 1 / (1 - z), midpoint (1 + z/2) / (1 - z/2), SDIRK2 (1 + (1 - 2g) z) / (1 - g z)^2,
    ESDIRK3 from its table (Hairer & Wanner, IV.3); Chung & Hulbert 1993 by solving their equations.
    """
    one = np.eye(2)
    if method == "implicit-euler":
        return np.linalg.inv(one - A)
    if method == "implicit-midpoint":
        return np.linalg.solve(one - 0.5 * A, one + 0.5 * A)
    if method == "sdirk2":
        inverse = np.linalg.inv(one - GAMMA * A)
        return inverse @ inverse @ (one + (1.0 - 2.0 * GAMMA) * A)
    if method == "bdf2":
        inverse = np.linalg.inv(1.5 * one - A)
        return np.block([[2.0 * inverse, -0.5 * inverse], [one, np.zeros((2, 2))]])
    if method in ("esdirk3", "adaptive"):
        table = METHODS["esdirk3"].tableau
        whole = np.eye(8) - np.kron(table.A, A)
        stages = np.linalg.solve(whole, np.kron(np.ones((4, 1)), one))
        return one + np.kron(table.b, A) @ stages
    am, af, gamma, beta = 1.0 / 3.0, 4.0 / 9.0, 11.0 / 18.0, 25.0 / 81.0
    a, b = -A[1, 0], -A[1, 1]
    # unknowns x1, v1, w1; rows: position, velocity, balance
    left = np.array([[1.0, 0.0, -beta], [0.0, 1.0, -gamma], [a * (1 - af), b * (1 - af), 1 - am]])
    right = np.array([[1.0, 1.0, 0.5 - beta], [0.0, 1.0, 1.0 - gamma], [-a * af, -b * af, -am]])
    return np.linalg.solve(left, right)


def mode_history(method: str, a: float, b: float, steps: int, x: float = 1.0, u: float = 0.0):
    """The scheme's own amplitudes of a mode after 0..steps steps, from x and u = v dt."""
    matrix = step_matrix(method, a, b)
    with_force = method in ("verlet", "generalized-alpha")
    state = np.array([x, u, -a * x - b * u] if with_force else [x, u])
    history = [x]
    if method == "bdf2":  # its first step is SDIRK2's
        state = np.concatenate([step_matrix("sdirk2", a, b) @ state, state])
        history.append(state[0])
        steps -= 1
    for _ in range(steps):
        state = matrix @ state
        history.append(state[0])
    return np.array(history)


def forces_at(simulation: Simulation, x: np.ndarray, v: np.ndarray | None = None) -> np.ndarray:
    """Total force on every free node [N], (n, 3), at positions x and velocities v, both (n, 3)."""
    state = simulation.arrays
    state.x[...] = x.T
    state.v[...] = 0.0 if v is None else v.T
    prepare(simulation.system, state)
    return (state.acceleration * state.mass).T.copy()


def in_place_sweep(
    x: np.ndarray, v: np.ndarray, k: float, m: float, length: float, dt: float, steps: int
) -> tuple[np.ndarray, np.ndarray]:
    """A deliberately wrong scheme: each node moves at once after its own force, as a careless loop."""
    x, v = x.copy(), v.copy()
    for _ in range(steps):
        for i in range(len(x)):
            force = np.zeros(3)
            for j in (i - 1, i + 1):
                if 0 <= j < len(x):
                    d = x[j] - x[i]
                    r = np.linalg.norm(d)
                    force += k * (r - length) * d / r
            v[i] += dt * force / m
            x[i] += dt * v[i]
    return x, v
