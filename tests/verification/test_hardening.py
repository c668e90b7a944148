"""Contacts that harden where they are pressed deep: slopes, stored energy, depth under a force, friction."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import pytest
from numpy.typing import NDArray

from ropewalk.core import arrays
from ropewalk.core.arrays import Floats
from ropewalk.laws.contact import contact_energy, contact_forces, remember_contacts
from ropewalk.laws.contact_frame import GRIP, PUSH, STIFF
from ropewalk.laws.contact_tangent import contact_tangent
from ropewalk.laws.hardening import SKIN, depth_under, squeezed, stored_under
from ropewalk.laws.obstacle import Memory, Obstacles
from ropewalk.laws.tangent import law_band
from ropewalk.lowering import build
from ropewalk.scene import Cylinder, Material, Plane, Points, Rope, Scene
from ropewalk.scene.obstacles import Obstacle

D, RADIUS, MU = 0.3, 0.5, 0.4
BODIES: dict[str, Obstacle] = {
    "plane": Plane(friction=MU),
    "cylinder": Cylinder(start=(-4, 0, 0), end=(4, 0, 0), radius=RADIUS, friction=MU),
}
#: Depths over the skin: in it, three where the slope rises, one beyond.
DEEP = np.array([0.5, 1.2, 1.5, 1.9, 4.0])
ZERO = np.zeros((3, 5))
NOW = np.array([0.35, 0.3])


class Pressed(NamedTuple):
    """Five nodes in contact with a body."""

    table: Obstacles
    memory: Memory
    links: Floats  # (4,) [N/m]

    def force(self, x: Floats, v: Floats = ZERO) -> Floats:
        found = np.zeros((3, 5))
        contact_forces(x, v, self.table, self.memory, NOW, found, 0, 5)
        return found

    def remember(self, x: Floats) -> None:
        remember_contacts(x, ZERO, self.table, self.memory, NOW, self.links)
        self.memory.grip[:, GRIP] = MU


def nodes_at(body: Obstacle) -> Pressed:
    """A soft, thick rope that is far away, with its table and memory."""
    rope = Rope(
        segments=4,
        length=4.0,
        made_of=Material(EA=2e4, mass_per_length=0.1),
        diameter=D,
        shape=Points(points=[(9.0, 9.0, 9.0 + i) for i in range(5)]),
    )
    model = build(Scene(ropes=[rope], obstacles=[body]))
    state = arrays.copy(model.state)
    found = Pressed(model.system.node.obstacle, state.memory.obstacle, state.stiffness)
    assert (found.table.hard > found.table.stiffness).all()
    return found


def places(name: str, depth: Floats, rng: np.random.Generator) -> Floats:
    """Places (3, 5) [m] of nodes that are pressed so deep into a body."""
    x = rng.uniform(-1.0, 1.0, (3, 5))
    if name == "plane":
        x[2] = 0.5 * D - depth
        return x
    angle = rng.uniform(0.0, 2.0 * np.pi, 5)
    x[1:] = (RADIUS + 0.5 * D - depth) * np.array([np.cos(angle), np.sin(angle)])
    return x


def slips(force: Floats, memory: Memory) -> NDArray[np.bool_]:
    """Tell of which nodes friction carries all it can, by the force on them (3, 5) [N] at rest."""
    push = memory.grip[0, PUSH]
    rub = np.sqrt(np.maximum((force**2).sum(axis=0) - push**2, 0.0))
    return np.asarray(rub > (1.0 - 1e-6) * MU * push)


@pytest.mark.parametrize("name", BODIES)
def test_tangents_are_the_derivatives_of_forces_that_harden(name: str) -> None:
    """Central differences, of what sticks and what slips, with the springs that the depth has left."""
    rng = np.random.default_rng(1)
    nodes, band, slid = nodes_at(BODIES[name]), law_band(5), 0
    for _ in range(20):
        x = places(name, DEEP * SKIN * D, rng)
        nodes.memory.grip[:, :GRIP] = 0.0
        nodes.remember(x)
        grip = nodes.memory.grip[0]
        assert (grip[STIFF, 1:] > 1.01 * nodes.table.stiffness[0, 1:]).all()
        grip[:GRIP] = MU * grip[PUSH] * rng.choice([0.2, 2.0], 5) * rng.normal(size=(3, 5))
        slid += int(slips(nodes.force(x), nodes.memory).sum())
        x += 1e-5 * rng.normal(size=(3, 5))
        v = 1e-2 * rng.normal(size=(3, 5))
        for weights, size in (((1.0, 0.0), 1e-7), ((0.0, 1.0), 1e-5)):
            band.diagonal[:] = 0.0
            contact_tangent(x, v, nodes.table, nodes.memory, NOW, *weights, band)
            for c in range(3):
                step = np.zeros((3, 5))
                step[c] = size
                dx, dv = weights[0] * step, weights[1] * step
                slope = nodes.force(x - dx, v - dv) - nodes.force(x + dx, v + dv)
                found = band.diagonal.reshape(5, 3, 3)[:, :, c].T
                assert np.abs(slope / (2.0 * size) - found).max() < 1e-5 * np.abs(found).max()
    assert 20 < slid < 80


@pytest.mark.parametrize("name", BODIES)
def test_what_is_stored_is_the_work_of_pressing(name: str) -> None:
    """So what has no friction and no speed gains nothing on the way in and out."""
    rng = np.random.default_rng(2)
    nodes = nodes_at(BODIES[name].replace(friction=0.0))
    nodes.memory.grip[:, GRIP] = 0.0
    x = places(name, DEEP * SKIN * D, rng)
    force = nodes.force(x)
    for c in range(3):
        for i in range(5):
            step = np.zeros((3, 5))
            step[c, i] = 1e-6
            ends = [
                contact_energy(x + s * step, nodes.table, nodes.memory, np.zeros(2))
                for s in (-1.0, 1.0)
            ]
            assert (ends[0] - ends[1]) / 2e-6 == pytest.approx(force[c, i], rel=1e-4, abs=1e-3)


@pytest.mark.parametrize("hard", [True, False])
def test_what_many_nodes_store_is_what_each_does(hard: bool) -> None:
    table = nodes_at(BODIES["cylinder"]).table
    assert (table.hard > 0.0).all()
    if not hard:
        table = table._replace(hard=np.zeros_like(table.hard))
    for share in (-9.0, -1.0, 0.3, 1.5, 2.5, 40.0):
        depth = np.full((1, 5), share * SKIN * D)
        found = stored_under(table, depth)
        alone = [[squeezed(table, 0, i, depth[0, i])[2] for i in range(5)]]
        assert found == pytest.approx(np.array(alone), rel=1e-12, abs=0.0)


@pytest.mark.parametrize("force", [1.0, 14.0, 20.0, 30.0, 45.0, 300.0])
def test_a_force_presses_in_as_deep_as_told(force: float) -> None:
    nodes = nodes_at(BODIES["plane"])
    depth = depth_under(nodes.table, force)[0]
    x = np.zeros((3, 5))
    x[2] = 0.5 * D - depth
    assert nodes.force(x)[2] == pytest.approx(np.full(5, force), rel=1e-9)


def test_loads_that_swing_get_nothing_out_of_friction() -> None:
    """Nodes are led round and round, pressed now deep and now in the skin: friction only takes."""
    rng = np.random.default_rng(3)
    nodes = nodes_at(BODIES["plane"])
    for _ in range(20):
        phase, size = rng.uniform(0.0, 2.0 * np.pi, (2, 5)), 10 ** rng.uniform(-4, -2, 5)
        deep = rng.uniform(1.0, 4.0, 5)
        given = np.zeros(5)
        for step in range(201):
            a = 2.0 * np.pi * step / 50.0
            x = np.zeros((3, 5))
            x[0], x[1] = size * np.cos(a + phase[0]), 0.3 * size * np.sin(2.0 * a)
            x[2] = 0.5 * D - SKIN * D * deep * (1.0 + 0.8 * np.cos(a + phase[1]))
            if step == 0:
                nodes.remember(x)
                nodes.memory.grip[:, :GRIP] = 0.0
                continue
            way = x - nodes.memory.place
            rub = nodes.force(x)
            rub[2] = 0.0
            nodes.remember(x)
            given += (rub * way).sum(axis=0)
            stored = 0.5 * (nodes.memory.grip[0, :GRIP] ** 2).sum(axis=0)
            stored /= nodes.memory.grip[0, STIFF]
            assert (given + stored <= 1e-12).all()
        assert (given < 0.0).all()


def test_a_contact_that_gets_softer_keeps_of_its_friction_spring_no_more_than_there_was() -> None:
    """No node moves over the surface, some slip by what presses them less: none stores more for it."""
    nodes = nodes_at(BODIES["plane"])
    x, y = np.zeros((3, 5)), np.zeros((3, 5))
    x[2], y[2] = 0.5 * D - 4.0 * SKIN * D, 0.5 * D - 2.0 * SKIN * D
    nodes.remember(x)
    grip, bound = nodes.memory.grip[0], MU * nodes.force(y)[2]
    grip[:GRIP] = 0.0
    grip[0] = bound * np.array([0.9, 0.999, 1.001, 1.05, 1.5])
    assert (grip[0] < MU * grip[PUSH]).all()
    before = 0.5 * grip[0] ** 2 / grip[STIFF]
    nodes.remember(y)
    assert (0.5 * grip[0] ** 2 / grip[STIFF] <= (1.0 + 1e-12) * before).all()
    assert grip[0, -1] == pytest.approx(bound[-1])
