"""The equations of motion once more, written apart from the package's own laws.

The reference solution and scipy's methods rest on them, so that a wrong law of the package would show as
methods that converge to the wrong place. Laws as in docs/theory/laws.md: stretch (tension-only too), both
frictions, linear and quadratic drag in still air, the yielding ground; anchors at rest or with a velocity.
"""

from __future__ import annotations

import itertools
import math
from dataclasses import dataclass, field

import numba
import numpy as np
from numpy.typing import NDArray

from ropewalk.lowering import Model
from ropewalk.motions.registry import CODES
from ropewalk.scene import Scene

Floats = NDArray[np.float64]

# Per node x, y, z, vx, vy, vz: an equation for a velocity reaches from its own node's neighbour below,
# position x (11 places before vz) to the neighbour above, vz (8 places after vx).
LOWER_BAND, UPPER_BAND = 11, 8


@numba.njit(nogil=True, error_model="numpy")
def rates(t, y, segments, nodes, numbers):
    """Return dy/dt; y holds position and velocity node by node, (6 n,)."""
    n = nodes.shape[1]
    gravity, up = numbers[0:3], numbers[3:6]
    height, repulsion, slide, absorption = numbers[6], numbers[7], numbers[8], numbers[9]
    out = np.zeros_like(y)
    d, u, f = np.zeros(3), np.zeros(3), np.zeros(3)
    for j in range(n - 1):
        a, b = 6 * j, 6 * j + 6
        square, approach = 0.0, 0.0
        for k in range(3):
            d[k] = y[b + k] - y[a + k]
            u[k] = 0.5 * (y[b + 3 + k] + y[a + 3 + k])
            square += d[k] * d[k]
            approach += d[k] * (y[b + 3 + k] - y[a + 3 + k])
        if square == 0.0:
            continue
        r = math.sqrt(square)
        spring, rest, slack = (
            segments[0, j],
            segments[1, j],
            segments[2, j] == 1.0 and r < segments[1, j],
        )
        pull = 0.0 if slack else spring * (r - rest) / r + segments[4, j] * approach / square
        vector = 0.0 if slack else segments[3, j]
        along = (u[0] * d[0] + u[1] * d[1] + u[2] * d[2]) / square
        across = math.sqrt(
            max(0.0, u[0] * u[0] + u[1] * u[1] + u[2] * u[2] - along * along * square)
        )
        normal, tangent = (
            0.5 * segments[5, j] * r * across,
            0.5 * segments[6, j] * square * abs(along),
        )
        for k in range(3):
            f[k] = pull * d[k] + vector * (y[b + 3 + k] - y[a + 3 + k])
            drag = normal * (u[k] - along * d[k]) + tangent * along * d[k]
            out[a + 3 + k] += f[k] - drag
            out[b + 3 + k] -= f[k] + drag
    for i in range(n):
        q = 6 * i
        inverse, drag = nodes[0, i], nodes[1, i]
        depth = height - (y[q] * up[0] + y[q + 1] * up[1] + y[q + 2] * up[2])
        rise = y[q + 3] * up[0] + y[q + 4] * up[1] + y[q + 5] * up[2]
        for k in range(3):
            v = y[q + 3 + k]
            out[q + k] = v
            force = out[q + 3 + k] - drag * v
            if depth > 0.0:
                push = repulsion * depth - absorption * min(rise, 0.0)
                force += push * up[k] - slide * (v - rise * up[k])
            out[q + 3 + k] = force * inverse + gravity[k] if inverse > 0.0 else 0.0
    return out


@dataclass(frozen=True)
class Equations:
    """A scene as plain arrays, and the moments at which its right-hand side jumps in time."""

    segments: Floats  # (7, s) spring constant, rest length, tension-only, frictions, drags
    nodes: Floats  # (2, n) inverse mass (0: held), linear drag
    numbers: Floats  # (10,) gravity, up, height, repulsion, slide friction, absorption
    start: Floats  # (6 n,) at time zero
    moves: tuple[tuple[int, float, float, Floats], ...] = field(
        default=()
    )  # node, from, to, velocity

    @property
    def arguments(self) -> tuple[Floats, Floats, Floats]:
        """What `rates` takes after t and y."""
        return self.segments, self.nodes, self.numbers

    def pieces(self, duration: float) -> list[tuple[float, float]]:
        """Return the intervals [s] in which nothing jumps."""
        times = {t for _, begin, end, _ in self.moves for t in (begin, end) if 0.0 < t < duration}
        corners = [0.0, *sorted(times), duration]
        return list(itertools.pairwise(corners))

    def enter(self, y: Floats, t: float) -> Floats:
        """Return the state with the held nodes' velocities of the piece that begins at `t` [s]."""
        y = y.copy()
        for node, begin, end, velocity in self.moves:
            y[6 * node + 3 : 6 * node + 6] = velocity if begin <= t < end else 0.0
        return y

    def places(self, y: Floats) -> Floats:
        """Return the positions [m], (n, 3), of a state."""
        return y.reshape(-1, 6)[:, :3]


def equations(model: Model) -> Equations:
    """Return a built scene's equations.

    Raises ValueError for what is not written down here: winches, limiters, wind, quadratic drag of nodes,
    and anchors that are released or move otherwise than with a velocity.
    """
    scene, state, system = model.scene, model.state, model.system
    _refuse(scene, model)
    segments = np.stack(
        [
            state.stiffness,
            state.rest_length,
            (system.slack_floor == 0.0).astype(np.float64),
            state.damping_vector,
            state.damping_axial,
            system.node.air.normal,
            system.node.air.tangential,
        ]
    )
    nodes = np.stack([state.inverse_mass, system.node.air.node_drag])
    ground = system.node.ground
    height = ground.height if ground.active else -np.inf
    numbers = np.array(
        [*system.gravity, *ground.up, height, ground.repulsion, ground.friction, ground.absorption]
    )
    y = np.concatenate([state.x.T, state.v.T], axis=1)
    y[nodes[0] == 0.0, 3:] = 0.0
    moves = tuple(
        (int(node), float(p[6]), float(p[7]), p[3:6].copy())
        for node, kind, p in zip(
            state.anchor_node, system.anchors.kind, system.anchors.params, strict=True
        )
        if kind == CODES["velocity"]
    )
    return Equations(segments, nodes, numbers, y.ravel(), moves)


def _refuse(scene: Scene, model: Model) -> None:
    system = model.system
    others = set(system.anchors.kind) - {CODES[name] for name in ("fixed", "velocity", "hand")}
    if scene.winches or scene.limiter or others or np.isfinite(system.anchors.release).any():
        raise ValueError(f"{scene.name}: winches, limiters, releases and such motions are not here")
    if any(rope.bending_stiffness > 0.0 for rope in scene.ropes):
        raise ValueError(f"{scene.name}: bending is not here")
    if system.node.air.wind.any() or system.node.air.node_drag_quadratic.any():
        raise ValueError(f"{scene.name}: wind and quadratic drag of nodes are not here")
