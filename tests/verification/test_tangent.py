"""Tangents of laws without a memory against central differences of their forces.

Those of obstacles, contact, slides and bending: `test_touch`, `unit/test_pairs`, `test_slide`,
`test_bending_tangent`.

A central difference of a smooth force errs by h^2/6 F''' and by rounding eps F / h: with h = 1e-6 and forces
of order 100 that is below 1e-6 of the largest entry.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from matrices import stiffness_and_friction
from ropewalk.core import arrays
from ropewalk.core.band import clear_band, dense
from ropewalk.laws.tangent import assemble_tangent, law_band
from ropewalk.methods.loop import prepare
from ropewalk.scene import Air, Anchor, Ground, Material, Rope, Scene, Springs, Straight, Winch

N = 6
STEP = 1e-6
LINE = Air(density=900.0, normal_coefficient=1.1, tangential_coefficient=0.4, wind=(1.0, -2.0, 0.5))


def rope(**more: Any) -> Rope:
    made_of = {"spring_constant": 120.0, "node_mass": 0.3, "segment_length": 0.7} | more
    return Rope(
        segments=N - 1,
        made_of=Springs(**made_of),
        diameter=0.02,
        shape=Straight(end=(4.0, 0.0, 0.0)),
    )


def curved(**more: Any) -> Rope:
    """Softer at first than farther on; stretched by 14 % at the start."""
    curve = [(0.05, 2.0), (0.1, 6.0), (0.3, 40.0)]
    made_of = Material(curve=curve, mass_per_length=0.4, **more)
    return Rope(segments=N - 1, length=3.5, made_of=made_of, shape=Straight(end=(4.0, 0.0, 0.0)))


def wound() -> dict[str, Any]:
    material = Material(EA=90.0, mass_per_length=0.4, axial_damping=2.0)
    return {
        "ropes": Rope(segments=N - 1, length=3.5, made_of=material),
        "anchors": [Anchor(node=0)],
        "winches": [Winch(end="start", speed=1.5)],
    }


LAWS: dict[str, dict[str, Any]] = {
    "springs": {"ropes": rope()},
    "no length": {"ropes": rope(segment_length=0.0)},
    "tension only": {"ropes": rope(tension_only=True, spring_friction=0.8)},
    "vector friction": {"ropes": rope(spring_friction=3.0)},
    "axial friction": {"ropes": rope(spring_friction=3.0, friction="axial")},
    "slack axial": {"ropes": rope(spring_friction=3.0, friction="axial", tension_only=True)},
    "linear drag": {"ropes": rope(), "air": Air(node_drag=0.7, wind=(1.0, 0.0, 2.0))},
    "node drag": {"ropes": rope(), "air": Air(node_drag_quadratic=0.7, wind=(1.0, 0.0, 2.0))},
    "line drag": {"ropes": rope(), "air": LINE},
    "ground": {"ropes": rope(), "ground": Ground(height=0.2)},
    "curve": {"ropes": curved()},
    "slack curve": {"ropes": curved(tension_only=True)},
    "winch": wound(),
    "all": wound()
    | {"air": LINE.replace(node_drag=0.3, node_drag_quadratic=0.2), "ground": Ground(height=0.1)},
}


class Case:
    """One scene's tables, and its forces as a function of positions and velocities."""

    def __init__(self, parts: dict[str, Any]) -> None:
        from ropewalk.lowering import build

        model = build(Scene(gravity=(0.1, 0.2, -9.0), **parts))
        self.system, self.state = model.system, arrays.copy(model.state)
        if len(self.state.winch_rate):
            self.state.winch_rate[:] = 1.5
        self.state.inverse_mass[:] = 1.0 / np.maximum(self.state.mass, 1e-3)

    def force(self, x: np.ndarray, v: np.ndarray) -> np.ndarray:
        """Total force on every node [N], (3 n,), node by node."""
        self.state.x[...], self.state.v[...] = x, v
        prepare(self.system, self.state)
        return (self.state.acceleration / self.state.inverse_mass).T.ravel()

    def differences(self, x: np.ndarray, v: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """-dF/dx and -dF/dv by central differences."""
        n = x.shape[1]
        found = []
        for which in (0, 1):
            columns = []
            for i in range(3 * n):
                shift = np.zeros((3, n))
                shift[i % 3, i // 3] = STEP
                up, down = [x, v], [x, v]
                up[which], down[which] = up[which] + shift, down[which] - shift
                columns.append((self.force(*down) - self.force(*up)) / (2.0 * STEP))
            found.append(np.array(columns).T)
        return found[0], found[1]


def states(n: int) -> list[tuple[np.ndarray, np.ndarray]]:
    """Stretched, tangled, folded and nearly touching nodes, at rest or fast."""
    rng = np.random.default_rng(5)
    straight = np.zeros((3, n))
    straight[0] = 0.9 * np.arange(n)
    folded = straight.copy()
    folded[0, n // 2 :] = folded[0, n // 2] - 0.9 * np.arange(n - n // 2) + 0.02
    near = rng.normal(size=(3, n))
    near[:, 2] = near[:, 3] + 1e-3
    speed = 4.0 * rng.normal(size=(3, n))
    return [
        (straight + 0.1 * rng.normal(size=(3, n)), speed),
        (rng.normal(size=(3, n)), speed),
        (folded, speed),
        (near, 0.1 * speed),
        (0.2 * rng.normal(size=(3, n)), 100.0 * speed),
    ]


def relative(matrix: np.ndarray, expected: np.ndarray) -> float:
    return float(np.abs(matrix - expected).max() / max(np.abs(expected).max(), 1e-3))


@pytest.mark.parametrize("name", LAWS)
def test_tangents_are_the_derivatives_of_the_forces(name: str) -> None:
    """Each law and all together. The twins: the transposed matrix of a law that is not symmetric, and
    the matrix of the state next to it.
    """
    case = Case(LAWS[name])
    skew = 0.0
    for x, v in states(case.state.x.shape[1]):
        by_place, by_speed = case.differences(x, v)
        stiffness, friction = stiffness_and_friction(case.system, case.state, x, v)
        # near segments: F''' grows with 1/r^3 and rounding with k L / r
        assert relative(dense(stiffness), by_place) < 2e-6
        assert relative(dense(friction), by_speed) < 2e-6
        other, _ = stiffness_and_friction(case.system, case.state, 1.01 * x + 1e-3 * v, 1.02 * v)
        if name != "no length":
            assert relative(dense(other), by_place) > 1e-4
        skew = max(skew, relative(dense(stiffness).T, by_place))
    if "axial" in name or name in ("line drag", "winch", "all"):
        assert skew > 1e-3
    else:
        assert skew < 1e-5


def test_the_weights_and_what_was_there_before() -> None:
    """The kernel writes weight_x K + weight_v C; nothing of before is left."""
    case = Case(LAWS["all"])
    x, v = states(case.state.x.shape[1])[0]
    stiffness, friction = stiffness_and_friction(case.system, case.state, x, v)
    band = law_band(x.shape[1])
    for _ in range(2):
        assemble_tangent(case.system, case.state, x, v, 0.3, 7.0, band)
    expected = 0.3 * dense(stiffness) + 7.0 * dense(friction)
    assert relative(dense(band), expected) < 1e-13
    clear_band(band)
    assert not dense(band).any()


def test_clamping_makes_a_tangled_rope_s_stiffness_definite() -> None:
    """T/r (I - t t^T) of compressed segments is what makes eigenvalues negative."""
    case = Case(LAWS["springs"])
    x, v = states(N)[4]
    smallest = []
    for clamp in (False, True):
        band = law_band(N)
        assemble_tangent(case.system, case.state, x, v, 1.0, 0.0, band, clamp)
        smallest.append(np.linalg.eigvalsh(dense(band))[0])
    assert smallest[0] < -10.0
    assert smallest[1] > -1e-10
