"""Contacts of pairs of segments, piece by piece: distances, forces and their derivatives, order."""

from __future__ import annotations

import numpy as np
import pytest

from matrices import dense_saddle
from ropewalk.core.arrays import Floats, Ints, State, System
from ropewalk.core.block_runs import eliminate_runs, find_runs, has_runs
from ropewalk.core.elimination import tied_network
from ropewalk.core.network import Network, eliminate, gather, solve_gathered
from ropewalk.core.ordering import ask_for, begin_groups, order_groups
from ropewalk.laws.pairs.distance import NEVER, comes_to, nearest, relative_way
from ropewalk.laws.pairs.force import depth_at, pair_energy, pair_forces, squeeze
from ropewalk.laws.pairs.pair_tangent import couple_pairs
from ropewalk.laws.pairs.search import list_near
from ropewalk.laws.pairs.table import (
    BRAKE,
    CLOSES,
    CONTACTS,
    LAYER,
    MORE,
    NEAR,
    PUSH,
    SPRING,
    STIFF,
    STOP,
    apart,
)
from ropewalk.lowering import build
from ropewalk.scene import Contact, Material, Points, Rope, RunSettings, Scene
from unit.test_saddle import random_saddle


def tangle(
    seed: int, ropes: int = 2, nodes: int = 6, friction: float = 0.3
) -> tuple[System, State]:
    """Ropes of random shape that lie through each other, as tables and state."""
    rng = np.random.default_rng(seed)
    made = []
    for k in range(ropes):
        points = np.cumsum(0.05 * rng.normal(size=(nodes, 3)), axis=0)
        length = float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum())
        made.append(
            Rope(
                name=f"r{k}",
                segments=nodes - 1,
                length=length,
                diameter=0.03,
                made_of=Material(EA=100.0, mass_per_length=0.1),
                shape=Points(points=points.tolist()),
            )
        )
    run = RunSettings(method="implicit-euler", time_step=0.01)
    model = build(Scene(ropes=made, contact=Contact(friction=friction), run=run), drawn=False)
    return model.system, model.state


def pressed_tangle(friction: float = 0.3, pull: float = 1.0) -> tuple[System, State]:
    """A tangle with contacts that are pressed and hold something."""
    for seed in range(200):
        system, state = tangle(seed, friction=friction)
        memory = state.memory.contact
        rows = int(memory.tally[CONTACTS])
        if rows < 3:
            continue
        rng = np.random.default_rng(seed)
        memory.grip[:rows, MORE] = 0.0  # as deep as they lie
        memory.grip[:rows, SPRING : SPRING + 3] = pull * rng.normal(size=(rows, 3))
        state.v[...] = 0.01 * rng.normal(size=state.v.shape)
        state.x[...] += 1e-5 * rng.normal(size=state.x.shape)
        return system, state
    raise AssertionError("no seed makes three contacts")


def forces_of(system: System, state: State, x: Floats, v: Floats) -> Floats:
    """The force on every node [N], (3, n)."""
    force = np.zeros_like(x)
    pair_forces(x, v, system.node.contact, state.memory.contact, force, 0, x.shape[1])
    return force


def network_of(state: State, pairs: int) -> Network:
    """An empty network with room for contacts."""
    joints = tangle(0)[0].joints
    return tied_network(joints, state.tied, state.stiffness > 0.0, False, pairs)


def dense(network: Network) -> Floats:
    """Its blocks as one matrix, node by node."""
    points = len(network.diagonal)
    matrix = np.zeros((3 * points, 3 * points))
    for p in range(points):
        matrix[3 * p : 3 * p + 3, 3 * p : 3 * p + 3] = network.diagonal[p].reshape(3, 3)
        for k in range(network.start[p], network.start[p + 1]):
            q = network.later[k]
            matrix[3 * p : 3 * p + 3, 3 * q : 3 * q + 3] = network.upper[k].reshape(3, 3)
            matrix[3 * q : 3 * q + 3, 3 * p : 3 * p + 3] = network.lower[k].reshape(3, 3)
    rows = (3 * network.number[:, None] + np.arange(3)).ravel()
    return matrix[np.ix_(rows, rows)]


def test_nearest_points_against_many_samples() -> None:
    """Of random segments, of crossing ones, and of parallel ones."""
    rng = np.random.default_rng(1)
    share = np.linspace(0.0, 1.0, 201)
    for case in range(60):
        x = rng.normal(size=(3, 4))
        if case % 3 == 0:
            x[:, 3] = x[:, 2] + rng.normal() * (x[:, 1] - x[:, 0])
        s, t, distance = nearest(x, x, 0.0, 0, 2)
        a = x[:, [0]] + share * (x[:, [1]] - x[:, [0]])
        b = x[:, [2]] + share * (x[:, [3]] - x[:, [2]])
        least = np.linalg.norm(a[:, :, None] - b[:, None, :], axis=0).min()
        own = (1 - s) * x[:, 0] + s * x[:, 1] - (1 - t) * x[:, 2] - t * x[:, 3]
        assert distance == pytest.approx(float(np.linalg.norm(own)), abs=1e-12)
        assert distance <= least + 1e-9
        assert distance >= least - 0.02


def test_the_way_of_a_step_is_not_looked_at_too_late() -> None:
    """The first touch on the way, against ten thousand samples of it; never after it."""
    rng = np.random.default_rng(2)
    found = 0
    for _ in range(100):
        x = rng.normal(size=(3, 4))
        y = x + rng.normal(size=(3, 4))
        start, way = nearest(x, x, 0.0, 0, 2)[2], relative_way(x, y, 0, 2)
        if start < 0.3:
            continue
        shares = np.linspace(0.0, 1.0, 2001)
        apart = np.array([nearest(x, y, float(share), 0, 2)[2] for share in shares])
        hit = comes_to(x, y, 0, 2, 0.2, start, way)
        if apart.min() < 0.2:
            first = shares[int(np.argmax(apart < 0.2))]
            assert hit <= first
            assert hit > first - 0.02
            found += 1
        elif apart.min() > 0.21:
            assert hit == NEVER
    assert found > 10


def test_the_sweep_finds_every_near_pair() -> None:
    """All but neighbours, against every pair with every other."""
    system, state = tangle(3, ropes=3, nodes=9)
    table, memory = system.node.contact, state.memory.contact
    y = state.x + 0.02 * np.random.default_rng(3).normal(size=state.x.shape)
    assert list_near(state.x, y, table, memory, state.tied)
    listed = {(int(i), int(j)) for i, j in memory.near[: memory.tally[NEAR]]}
    reach, s = 1.1 * 0.03, len(table.rope)
    wanted = set()
    for i in range(s):
        for j in range(i + 1, s):
            if table.rope[i] < 0 or table.rope[j] < 0:
                continue
            if table.rope[i] == table.rope[j] and j - i <= table.skip[i]:
                continue
            least = min(nearest(state.x, y, share, i, j)[2] for share in (0.0, 0.5, 1.0))
            if least < reach:
                wanted.add((i, j))
    assert len(wanted) > 5
    assert wanted <= listed


def test_what_is_pressed_hardens_without_a_jump() -> None:
    """Force and energy are integrals of the slope; beyond the skin the slope is that of the segments."""
    soft, hard, layer = 100.0, 5000.0, 1e-3
    depth = np.linspace(-1e-3, 6e-3, 70001)
    force, slope, energy = (
        np.array(part)
        for part in zip(*(squeeze(d, soft, hard, STOP * hard, layer) for d in depth), strict=True)
    )
    middle = 0.5 * (slope[1:] + slope[:-1])
    assert np.diff(force) == pytest.approx(middle * np.diff(depth), rel=1e-3)
    inside = depth[:-1] >= 0.0
    work = 0.5 * (force[1:] + force[:-1]) * np.diff(depth)
    assert np.diff(energy)[inside] == pytest.approx(work[inside], rel=1e-5, abs=1e-12)
    assert slope[0] == soft
    assert slope[np.searchsorted(depth, 2.5e-3)] == pytest.approx(hard)
    assert slope[-1] == pytest.approx(STOP * hard)


def orders(network: Network, pairs: Ints, count: int) -> bool:
    """Whether a network with these pairs of segments alone coupled has room for its blocks."""
    begin_groups(network)
    assert ask_for(network, pairs, count) == 0
    return bool(order_groups(network))


def brake_within_skin(system: System, state: State, follows: float) -> int:
    """Give every contact a depth of half its skin, and a drag; return how many of them close.

    It goes with how fast they close, for `follows` [m/s] as it is, or, with 0, does not.
    """
    memory, table = state.memory.contact, system.node.contact
    closing = 0
    for row in range(int(memory.tally[CONTACTS])):
        i, j = memory.pair[row]
        size, grip = table.radius[i] + table.radius[j], memory.grip[row]
        depth = depth_at(state.x, memory, row, i, j, size)
        grip[MORE] += 0.5 * LAYER * size - depth
        grip[BRAKE], grip[CLOSES] = 50.0, follows
        rate = grip[:3] @ np.array(apart(state.v, memory.grip, row, i, j))
        closing += rate < 0.0
    return closing


@pytest.mark.parametrize("brakes", [None, 0.0, 0.1])
@pytest.mark.parametrize(("friction", "pull"), [(0.3, 3.0), (10.0, 0.01), (0.0, 0.0)])
def test_the_tangent_is_the_derivative(friction: float, pull: float, brakes: float | None) -> None:
    """Slipping, sticking and without friction, against central differences; in places and velocities.

    As deep as random ropes lie, and within the skin, with the drag of those that close: which rises with the
    depth, so that what sticks is not symmetric either, and may follow how fast they do.
    """
    system, state = pressed_tangle(friction, pull)
    assert brakes is None or brake_within_skin(system, state, brakes) > 0
    memory, n = state.memory.contact, state.x.shape[1]
    network = network_of(state, len(memory.pair))
    rows = int(memory.tally[CONTACTS])
    assert orders(network, memory.pair, rows)
    skew = False
    for weight_x, weight_v in ((1.0, 0.0), (0.0, 1.0)):
        for part in (network.diagonal, network.upper, network.lower):
            part[...] = 0.0
        couple_pairs(state.x, state.v, system.node.contact, memory, weight_x, weight_v, network)
        found, step = dense(network), 1e-7
        expected = np.zeros_like(found)
        for i in range(n):
            for k in range(3):
                ends = []
                for sign in (1.0, -1.0):
                    x, v = state.x.copy(), state.v.copy()
                    (x if weight_x else v)[k, i] += sign * step
                    ends.append(forces_of(system, state, x, v).T.ravel())
                expected[:, 3 * i + k] = -(ends[0] - ends[1]) / (2.0 * step)
        assert np.abs(expected).max() > 0.0
        assert np.abs(found - expected).max() < 1e-5 * np.abs(expected).max()
        skew = skew or np.abs(found - found.T).max() > 1e-3 * np.abs(found).max()
    assert skew == (friction == 0.3 or (brakes is not None and friction > 0.0))


def test_what_ropes_do_to_each_other_adds_up_to_nothing() -> None:
    """Momentum is conserved to rounding; the twin without the other side's share is not."""
    system, state = pressed_tangle()
    force = forces_of(system, state, state.x, state.v)
    size = np.abs(force).max()
    assert size > 0.0
    assert np.abs(force.sum(axis=1)).max() < 1e-14 * size * 100
    half = state.x.shape[1] // 2
    assert np.abs(force[:, :half].sum(axis=1)).max() > 1e-3 * size


def test_without_friction_the_force_is_what_the_energy_gives() -> None:
    """Central differences of the stored energy, at rest."""
    system, state = pressed_tangle(friction=0.0, pull=0.0)
    state.v[...] = 0.0
    memory, table = state.memory.contact, system.node.contact
    force = forces_of(system, state, state.x, state.v)
    for i in range(state.x.shape[1]):
        for k in range(3):
            ends = []
            for sign in (1.0, -1.0):
                x = state.x.copy()
                x[k, i] += sign * 1e-7
                ends.append(pair_energy(x, table, memory))
            slope = -(ends[0] - ends[1]) / 2e-7
            assert slope == pytest.approx(force[k, i], abs=1e-6 * np.abs(force).max() + 1e-9)


def test_a_network_with_contacts_solves_what_numpy_solves() -> None:
    """The order found in the kernel, again and again for other pairs, against a dense solver."""
    rng = np.random.default_rng(5)
    nodes = 80  # two words of bits
    for count in (0, 3, 12, 40, 3):
        saddle = random_saddle(nodes, count, blocks=True, second=True)
        saddle.compliance[:] = np.maximum(saddle.compliance, 1e-6)
        alive = np.ones(nodes - 1, bool)
        joints = tangle(0)[0].joints
        network = tied_network(joints, np.zeros(0, np.int64), alive, True, 64)
        pairs = np.zeros((64, 2), np.int64)
        pairs[:, 0] = rng.integers(0, 30, 64)
        pairs[:, 1] = pairs[:, 0] + rng.integers(2, 40, 64)
        assert orders(network, pairs, 64)  # of others before
        assert orders(network, pairs[:count].copy(), count)
        saddle = saddle._replace(network=network)
        matrix, right = dense_saddle(saddle)
        gather(saddle, network)
        for row in range(count):
            i, j = pairs[row]
            block, at = 10.0 * np.eye(3) + rng.normal(size=(3, 3)), 0
            for a in range(4):
                p = i + a if a < 2 else j + a - 2
                for b in range(a + 1, 4):
                    q = i + b if b < 2 else j + b - 2
                    spot = network.room.spots[row, at]
                    at += 1
                    first, second = sorted((int(network.number[p]), int(network.number[q])))
                    assert spot == -2 or network.later[spot] == second
                    if p == q:
                        continue
                    network.upper[spot] += block.ravel()
                    network.lower[spot] += block.ravel()
                    for one, other in ((p, q), (q, p)):
                        if saddle.free[one] == 1.0 and saddle.free[other] == 1.0:
                            matrix[3 * one : 3 * one + 3, 3 * other : 3 * other + 3] += block
                    assert first != second
        solve_gathered(saddle)
        found = np.concatenate([saddle.moved.T.ravel(), saddle.pulled])
        answer = np.linalg.solve(matrix, right)
        assert np.abs(found - answer).max() < 1e-7 * np.abs(answer).max(), count


def dense_network(seed: int) -> Network:
    """A network in which much fills in, in order, with random blocks and some held points."""
    nodes, rng = 70, np.random.default_rng(seed)
    joints = tangle(0)[0].joints
    network = tied_network(joints, np.zeros(0, np.int64), np.ones(nodes - 1, bool), False, 64)
    pairs = np.zeros((64, 2), np.int64)
    pairs[:, 0] = rng.integers(0, 40, 64)
    pairs[:, 1] = np.minimum(pairs[:, 0] + rng.integers(2, 50, 64), nodes - 2)
    assert orders(network, pairs, 64)
    for part in (network.diagonal, network.upper, network.lower, network.right):
        part[...] = rng.normal(size=part.shape)
    network.diagonal[:, ::4] += 30.0
    network.free[:] = rng.uniform(size=nodes) < 0.9
    return network


@pytest.mark.parametrize("seed", range(3))
def test_runs_of_blocks_are_eliminated_to_the_same_bits(seed: int) -> None:
    """As one block after another; and those of few blocks, or without room for them, are not."""
    network = dense_network(seed)
    runs = network.runs
    assert has_runs(network)
    assert (runs.length[: runs.first[-1]] > 2).any()  # longer ones than a register
    diagonal, right = network.diagonal.copy(), network.right.copy()
    eliminate_runs(network)
    found = network.right.copy()
    network.diagonal[:], network.right[:] = diagonal, right
    eliminate(network)
    assert np.isfinite(found).all()
    assert np.abs(found).max() > 0.0
    np.testing.assert_array_equal(found, network.right)
    network = network._replace(runs=runs._replace(to=runs.to[:5]))
    find_runs(network)
    assert not has_runs(network)
    assert orders(network, np.array([[3, 20]]), 1)
    assert not has_runs(network)


def test_no_room_is_told() -> None:
    """A network that fills beyond its room says so, and orders others afterwards."""
    nodes = 30
    joints = tangle(0)[0].joints
    network = tied_network(joints, np.zeros(0, np.int64), np.ones(nodes - 1, bool), False, 200)
    network = network._replace(later=network.later[:60])
    pairs = np.array([(i, j) for i in range(12) for j in range(i + 3, 28)], dtype=np.int64)[:200]
    assert not orders(network, pairs, len(pairs))
    assert orders(network, pairs, 2)


def test_a_hand_moved_contact_is_open_until_it_is_pressed() -> None:
    """What is listed carries nothing before a step has pressed it; no spring is softer than the skin."""
    system, state = pressed_tangle(pull=0.0)
    memory, table = state.memory.contact, system.node.contact
    rows = int(memory.tally[CONTACTS])
    assert (memory.grip[:rows, PUSH] == 0.0).all()
    for row in range(rows):
        i, j = memory.pair[row]
        assert memory.grip[row, STIFF] >= 1.0 / (table.soft[i] + table.soft[j]) * (1.0 - 1e-12)
