"""Ropes with bending stiffness at rest: a small Newton solver for the tests of closed forms."""

from __future__ import annotations

from typing import Any

import numpy as np

from matrices import stiffness_and_friction
from ropewalk.core import arrays
from ropewalk.core.band import dense
from ropewalk.lowering import build
from ropewalk.methods.loop import prepare
from ropewalk.scene import Anchor, Clamp, Material, Rope, RunSettings, Scene

X, Z = (1.0, 0.0, 0.0), (0.0, 0.0, 1.0)
NO_GRAVITY = (0.0, 0.0, 0.0)


class Rod:
    """A built scene, its forces and its stiffness matrix."""

    def __init__(self, scene: Scene) -> None:
        model = build(scene)
        self.system, self.state = model.system, arrays.copy(model.state)
        self.load = np.zeros_like(self.state.x)  # [N], (3, n)
        self.free = np.repeat(self.state.inverse_mass > 0.0, 3)
        self.mass = np.repeat(self.state.mass, 3)

    def force(self) -> np.ndarray:
        """Force on every node at rest [N], (3 n,), node by node; held nodes 0."""
        self.state.v[...] = 0.0
        prepare(self.system, self.state)
        return (self.state.acceleration * self.state.mass + self.load * self.free[::3]).T.ravel()

    def stiffness(self) -> np.ndarray:
        """-dF/dx of the free nodes [N/m], dense."""
        matrix = dense(stiffness_and_friction(self.system, self.state)[0])
        return matrix[np.ix_(self.free, self.free)]

    def settle(self, steps: int = 2000, *, reach: float = 0.3) -> np.ndarray:
        """Go to rest by Newton's method with bounded steps; return the positions (n, 3) [m].

        Ends when the step no longer gets smaller, at round-off. Rigid motions that nothing holds are left
        out (least squares).
        """
        segment = float(self.state.rest_length.max())
        last = np.inf
        for _ in range(steps):
            change = np.zeros(self.free.size)
            change[self.free] = solve(self.stiffness(), self.force()[self.free])
            size = float(np.abs(change).max())
            if size < 1e-9 * segment and size >= 0.5 * last:
                return self.state.x.T.copy()
            last = size
            self.state.x[...] += (change * min(1.0, reach * segment / size)).reshape(-1, 3).T
        raise AssertionError(f"not at rest: still moving by {last:.3g} m")

    def frequencies(self) -> np.ndarray:
        """Angular frequencies about the present place [rad/s], slowest first."""
        mass = self.mass[self.free]
        matrix = self.stiffness() / np.sqrt(mass[:, None] * mass)
        return np.sqrt(np.maximum(np.linalg.eigvalsh(matrix), 0.0))


def solve(matrix: np.ndarray, right: np.ndarray) -> np.ndarray:
    """Solve with a symmetric matrix without its null space."""
    values, vectors = np.linalg.eigh(matrix)
    kept = np.abs(values) > 1e-12 * np.abs(values).max()
    return np.asarray(vectors[:, kept] @ ((vectors[:, kept].T @ right) / values[kept]))


def rod(
    segments: int,
    *,
    EI: float = 1.0,
    EA: float = 1e6,
    length: float = 1.0,
    mass: float = 1.0,
    anchors: list[Anchor] | None = None,
    gravity: tuple[float, float, float] = NO_GRAVITY,
    run: RunSettings | None = None,
    shape: Any = None,
    **more: Any,
) -> Scene:
    """A straight rod along x, clamped at its start unless `anchors` say otherwise."""
    made_of = Material(EA=EA, mass_per_length=mass, EI=EI, **more)
    given = {} if shape is None else {"shape": shape}
    rope = Rope(segments=segments, length=length, made_of=made_of, **given)
    held = [clamped()] if anchors is None else anchors
    return Scene(
        ropes=rope,
        anchors=held,
        gravity=gravity,
        run=run or RunSettings(method="semi-implicit-euler"),
    )


def clamped(node: int = 0, direction: tuple[float, float, float] = X, **more: Any) -> Anchor:
    """An anchor that holds the direction, too."""
    return Anchor(node=node, clamp=Clamp(direction=direction), **more)


def order(errors: list[float]) -> float:
    """Order of convergence from the last two errors at n and 2 n segments."""
    return float(np.log2(abs(errors[-2] / errors[-1])))
