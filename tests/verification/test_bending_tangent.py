"""The tangent of bending against central differences of its forces, and the forces against the energy."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from matrices import stiffness_and_friction
from ropewalk.core.arrays import BENDING
from ropewalk.core.band import dense
from ropewalk.laws.bending_tangent import bending_tangent
from ropewalk.laws.clamps import bent_energy
from ropewalk.methods.loop import prepare
from ropewalk.scene import Anchor, Clamp, Material, Rope, Scene
from ropewalk.simulation import Simulation

N = 9
STEP = 1e-6
TURNING = {"turn_rate": 3.0, "turn_axis": (1, 2, 3)}
CLAMPS = [
    Anchor(node=0, clamp=Clamp(direction=(1, 0.2, 0), **TURNING)),
    Anchor(node=4, clamp=Clamp(direction=(1, 0.3, 0.1), **TURNING)),
    Anchor(node=-1, clamp=Clamp(direction=(1, -0.3, 0.1))),
]
ALONG = [
    Anchor(node=k, clamp=Clamp(direction=(1, 0, 0), turn_rate=0.5, turn_axis=(1, 2, 3)))
    for k in (0, 4, -1)
]
HELD = [Anchor(node=0)]
CURVED = {"curvature": (0.5, 0.3, 0.8)}
KINDS: dict[str, tuple[list[Anchor], dict[str, Any]]] = {
    "bending": (HELD, {}),
    "natural curvature": (HELD, CURVED),
    "clamps": (CLAMPS, {}),
    "friction": (HELD, {"bending_damping": 0.3}),
    "clamps along it, friction": (ALONG, {"bending_damping": 0.3}),
    "all": (CLAMPS, {"bending_damping": 0.3} | CURVED),
}


class Bent:
    """The bending forces of a rope with almost no stretch, as a function of place and velocity."""

    def __init__(self, kind: str) -> None:
        anchors, more = KINDS[kind]
        made_of = Material(EA=1e-9, mass_per_length=1.0, EI=0.7, **more)
        rope = Rope(segments=N - 1, length=2.0, made_of=made_of)
        self.simulation = Simulation(Scene(ropes=rope, anchors=anchors, gravity=(0, 0, 0)))
        self.system, self.state = self.simulation.system, self.simulation.arrays

    def segments(self) -> np.ndarray:
        """Elastic bending force and friction of the segments at the state [N], (3, n + 1)."""
        prepare(self.system, self.state)
        return self.state.forces.bending + self.state.forces.friction

    def force(self) -> np.ndarray:
        """Force of bending and its friction on the nodes [N], (3 n,), node by node."""
        return np.diff(self.segments(), axis=1).T.ravel()

    def differences(self, array: np.ndarray, step: float = STEP) -> np.ndarray:
        """-dF/d(array), dense, by central differences."""
        start, columns = array.copy(), []
        for i in range(array.size):
            place = i % 3, i // 3
            array[place] = start[place] + step
            up = self.force()
            array[place] = start[place] - step
            columns.append((self.force() - up) / (2.0 * step))
            array[...] = start
        return np.array(columns).T


def shapes() -> dict[str, np.ndarray]:
    """Straight, hardly bent, bent, strongly bent, tangled with folds and pressed segments, (3, n)."""
    rng = np.random.default_rng(3)
    straight = np.zeros((3, N))
    straight[0] = np.linspace(0.0, 2.0, N)
    angle = np.linspace(0.0, 2.5, N)
    arc = np.array([np.sin(angle), 0.1 * angle, np.cos(angle)]) * 2.0 / 2.5
    zigzag = straight * 0.6
    zigzag[2, ::2] = 0.2  # turns by 106 degrees
    return {
        "straight": straight,
        "hardly bent": straight + 1e-2 * rng.normal(size=(3, N)),
        "an arc": arc,
        "a zigzag": zigzag + 0.02 * rng.normal(size=(3, N)),
        "tangled": straight + 0.5 * rng.normal(size=(3, N)),
    }


def relative(found: np.ndarray, expected: np.ndarray) -> float:
    return float(np.abs(found - expected).max() / max(np.abs(expected).max(), 1e-3))


@pytest.mark.parametrize("shape", shapes())
@pytest.mark.parametrize("kind", KINDS)
def test_tangents_are_the_derivatives_of_the_forces(kind: str, shape: str) -> None:
    """Twins: the matrix of the shape next to it, and without the blocks beside the neighbours'."""
    bent = Bent(kind)
    bent.state.x[...] = shapes()[shape]
    bent.state.v[...] = np.random.default_rng(4).normal(size=(3, N))
    damped = bool(bent.state.bending_damping.any())
    stiffness, friction = stiffness_and_friction(bent.system, bent.state)
    by_speed = bent.differences(bent.state.v)
    assert relative(dense(friction), by_speed) < 1e-6
    if damped and shape == "straight":
        return  # the plane of bending jumps there
    by_place = bent.differences(bent.state.x)
    # rounding eps F / h, and h^2 F''' / 6, where the friction's F''' grows like F / (bend l)^3
    tolerance = 1e-6
    if damped:
        e = np.diff(bent.state.x, axis=1)
        e /= np.linalg.norm(e, axis=0)
        bend = np.linalg.norm(np.cross(e[:, :-1].T, e[:, 1:].T), axis=1)
        tolerance += (2.0 * STEP / (0.25 * bend.min())) ** 2  # a middle node bends by 2 h / l
    assert relative(dense(stiffness), by_place) < tolerance
    stiffness.upper2[...] = 0.0
    assert relative(dense(stiffness), by_place) > 1e-2
    bent.state.x[2, 3] += 1e-3
    other, _ = stiffness_and_friction(bent.system, bent.state)
    if shape != "straight" or kind == "natural curvature":
        assert relative(dense(other), by_place) > 1e-6
    if not damped:
        assert relative(dense(other), dense(other).T) < 1e-14


@pytest.mark.parametrize("kind", ["friction", "clamps along it, friction"])
def test_tangents_of_friction_are_its_derivatives_where_a_rope_is_nearly_straight(
    kind: str,
) -> None:
    """Bends of 1e-6 to 1e-5: part of the friction acts on the whole rate, part on that in its plane.

    But for what only turns the first part, some 1e-5 of the whole.
    """
    bent = Bent(kind)
    rng = np.random.default_rng(5)
    bent.state.x[...] = shapes()["straight"]
    bent.state.x[1:] += 6e-7 * rng.normal(size=(2, N))
    bent.state.v[...] = rng.normal(size=(3, N))
    stiffness, friction = stiffness_and_friction(bent.system, bent.state)
    assert relative(dense(friction), bent.differences(bent.state.v, 0.1)) < 1e-4
    assert relative(dense(stiffness), bent.differences(bent.state.x, 1e-10)) < 1e-4


@pytest.mark.parametrize("shape", shapes())
@pytest.mark.parametrize("kind", ["bending", "natural curvature", "clamps"])
def test_forces_are_minus_the_gradient_of_the_energy(kind: str, shape: str) -> None:
    """Twin: the energy of bending by the angle, EI angle^2 / 2l, whose forces differ."""
    bent = Bent(kind)
    x = bent.state.x
    x[...] = start = shapes()[shape]
    force = bent.force().reshape(N, 3).T
    for i in range(x.size):
        place = i % 3, i // 3
        x[place] = start[place] + STEP
        up = bent_energy(bent.system, bent.state, bent.state.x), by_angle(start, place, STEP)
        x[place] = start[place] - STEP
        down = bent_energy(bent.system, bent.state, bent.state.x), by_angle(start, place, -STEP)
        x[place] = start[place]
        slope = (down[0] - up[0]) / (2.0 * STEP)
        assert abs(slope - force[place]) < 1e-7 * max(np.abs(force).max(), 1.0)
    if shape == "a zigzag" and kind == "bending":
        assert abs((down[1] - up[1]) / (2.0 * STEP) - force[place]) > 1e-2


def by_angle(x: np.ndarray, place: tuple[int, int], step: float) -> float:
    """Energy of the bend by the angle itself [J]."""
    moved = x.copy()
    moved[place] += step
    e = np.diff(moved, axis=1)
    e = e / np.linalg.norm(e, axis=0)
    angle = np.arccos(np.clip((e[:, 1:] * e[:, :-1]).sum(axis=0), -1, 1))
    return float(0.5 * 0.7 / 0.25 * (angle**2).sum())


def test_bending_alone_adds_no_force_and_no_torque() -> None:
    """Friction too, for any motion. The twin: a natural curvature, whose axis is fixed in space, turns
    a rope that is not in its plane.
    """
    for kind, turns in (("bending", False), ("friction", False), ("natural curvature", True)):
        bent = Bent(kind)
        bent.state.x[...] = shapes()["tangled"]
        bent.state.v[...] = np.random.default_rng(4).normal(size=(3, N))
        force = bent.force().reshape(N, 3)
        size = np.abs(force).max()
        assert np.abs(force.sum(axis=0)).max() < 1e-12 * size
        torque = np.abs(np.cross(bent.state.x.T, force).sum(axis=0)).max()
        assert (torque > 1e-2 * size) if turns else (torque < 1e-12 * size)


def test_friction_leaves_rigid_motion_alone_and_takes_energy_otherwise() -> None:
    """v = u + w x x. The twin: friction on the whole rate of the curvature binormal, which turns too."""
    bent, plain = Bent("friction"), Bent("bending")
    x = shapes()["tangled"]
    for spin in np.eye(3):
        for b in (bent, plain):
            b.state.x[...] = x
            b.state.v[...] = np.array([[1.0], [2.0], [3.0]]) + np.cross(spin, x.T).T
        rubbed = bent.force() - plain.force()
        assert np.abs(rubbed).max() < 1e-12
        e = np.diff(x, axis=1).T
        kb = np.cross(e[:-1], e[1:])
        assert np.abs(np.cross(spin, kb)).max() > 0.1  # the rate that does not rub
    rng = np.random.default_rng(6)
    for _ in range(20):
        v = rng.normal(size=(3, N))
        for b in (bent, plain):
            b.state.v[...] = v
        power = ((bent.force() - plain.force()).reshape(N, 3) * v.T).sum()
        assert power < 0.0


@pytest.mark.parametrize("kind", KINDS)
def test_coincident_and_folded_nodes_are_safe(kind: str) -> None:
    """Every number stays finite. A fold has no force; two nodes at one place are pushed apart."""
    bent = Bent(kind)
    x = np.zeros((3, N))
    for name in ("all at one place", "folded", "two at one place"):
        if name == "folded":
            x[0] = np.abs(np.linspace(-1.0, 1.0, N))
        if name == "two at one place":
            x[0] = np.linspace(0.0, 2.0, N)
            x[0, 3] = x[0, 2]
        bent.state.x[...] = x
        bent.state.v[...] = np.random.default_rng(4).normal(size=(3, N))
        assert np.isfinite(bent.force()).all()
        assert np.isfinite(bent_energy(bent.system, bent.state, bent.state.x))
        for band in stiffness_and_friction(bent.system, bent.state):
            assert np.isfinite(dense(band)).all()
        force = bent.force().reshape(N, 3)
        if kind == "bending" and name != "two at one place":
            assert np.abs(force).max() < 1e-12
        if kind == "bending" and name == "two at one place":
            assert force[2, 0] < -1.0
            assert force[3, 0] > 1.0


def test_a_fold_stores_fourteen_times_the_stiffness_and_opens() -> None:
    """U = 14 EI / l at 180 degrees, and from 179 degrees the rope opens. Twin: 2 tan(turn / 2) without
    a bound has a thousand times as much there.
    """
    bent = Bent("bending")
    for turn in (np.pi, np.radians(179.0)):
        x = np.zeros((3, N))
        x[0] = np.linspace(0.0, 2.0, N)
        after = x[0, 4:] - x[0, 4]
        x[0, 4:], x[2, 4:] = x[0, 4] + after * np.cos(turn), after * np.sin(turn)
        bent.state.x[...] = x
        stored = bent_energy(bent.system, bent.state, bent.state.x)
        if turn == np.pi:
            assert stored == pytest.approx(14.0 * 0.7 / 0.25, rel=1e-12)
    assert stored < 14.0 * 0.7 / 0.25
    assert 0.5 * 0.7 / 0.25 * 4.0 * np.tan(0.5 * turn) ** 2 > 1000.0 * stored
    force = bent.force().reshape(N, 3)
    assert force[5, 2] > 0.0  # away from the other half


def test_without_EI_nothing_is_there() -> None:
    """No arrays and no flag; and the tangent's kernel on its own overwrites what is there."""
    rope = Rope(segments=4, length=1.0, made_of=Material(EA=10.0, mass_per_length=1.0))
    plain = Simulation(Scene(ropes=rope))
    assert plain.system.flags[BENDING] == 0
    assert plain.arrays.forces.bending.size == plain.arrays.bending_stiffness.size == 0
    assert "bending" not in plain.layout.__dict__ or not plain.layout.bends
    bent = Bent("friction")
    bent.state.x[...] = shapes()["an arc"]
    bent.state.v[...] = 1.0 + shapes()["tangled"]
    one, other = stiffness_and_friction(bent.system, bent.state)
    expected = 2.0 * dense(other)
    s = bent.state
    tables = s.rest_length, s.bending_stiffness, s.bending_damping, bent.system.bending.natural
    bending_tangent(s.x, s.v, *tables, 0.0, 2.0, False, one)
    assert relative(dense(one), expected) < 1e-12
