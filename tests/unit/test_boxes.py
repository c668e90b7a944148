"""Which boxes overlap: all pairs that do, each once, and no others."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

from ropewalk.core.arrays import Floats, Ints
from ropewalk.laws.pairs.boxes import LEAF, begin_of, grow_tree, next_leaf, overlap, room_for
from ropewalk.laws.pairs.search import list_near
from ropewalk.laws.pairs.table import NEAR
from ropewalk.lowering import build
from verification.tangles import tangle


def random_boxes(rng: np.random.Generator, count: int) -> Floats:
    """Boxes (count, 6) of sizes from a thousandth of the room to all of it, some in one place."""
    low = rng.uniform(size=(count, 3)).round(2)
    size = 10.0 ** rng.uniform(-3.0, 0.0, (count, 1)) * rng.uniform(size=(count, 3))
    return np.hstack([low, low + size])


def found(box: Floats, order: Ints, tree: Floats) -> list[tuple[int, int]]:
    """The pairs that a walk through the tree finds."""
    leaves, pairs = grow_tree(box, order, tree), []
    for leaf in range(leaves, 2 * leaves):
        own = order[begin_of(leaves, order, leaf) : begin_of(leaves, order, leaf + 1)]
        pairs += list(itertools.combinations(own, 2))
        other = next_leaf(tree, leaves, leaf, leaf)
        while other > 0:
            begin, end = (begin_of(leaves, order, k) for k in (other, other + 1))
            pairs += list(itertools.product(own, order[begin:end]))
            other = next_leaf(tree, leaves, leaf, other)
    return sorted((min(p, q), max(p, q)) for p, q in pairs if overlap(box, p, box, q))


def wanted(box: Floats) -> list[tuple[int, int]]:
    """The pairs of boxes that overlap, one by one."""
    low, high = box[:, None, :3], box[None, :, 3:]
    both = np.all(low <= high, axis=2)
    return [(int(p), int(q)) for p, q in np.argwhere(np.triu(both & both.T, 1))]


@pytest.mark.parametrize("count", [1, 2, LEAF, LEAF + 1, 2 * LEAF + 1, 100, 257])
def test_all_boxes_that_overlap_are_found_once(count: int) -> None:
    """The first time, and where they have gone elsewhere since they were put in order."""
    rng = np.random.default_rng(count)
    order, tree = np.arange(count), np.zeros((room_for(count), 6))
    for _ in range(4):
        box = random_boxes(rng, count)
        assert found(box, order, tree) == wanted(box)
        assert sorted(order) == list(range(count))


def test_boxes_in_one_place_end() -> None:
    """Nothing halves them."""
    box = np.tile([0.0, 0.0, 0.0, 1.0, 1.0, 1.0], (50, 1))
    assert len(found(box, np.arange(50), np.zeros((room_for(50), 6)))) == 50 * 49 // 2


def test_a_walk_that_gets_long_has_the_boxes_put_in_order_anew() -> None:
    """Boxes in a row that change places at random: as short as when they began, the walk after the next."""
    rng, count = np.random.default_rng(0), 512
    low = np.stack([np.arange(count), np.zeros(count), np.zeros(count)], axis=1).astype(float)
    box, order, tree = np.hstack([low, low + 1.5]), np.arange(count), np.zeros((128 * LEAF, 6))
    first = wanted(box)
    assert found(box, order, tree) == first
    short = tree[0, 1]
    mixed = box[rng.permutation(count)]
    assert found(mixed, order, tree) == wanted(mixed)
    assert tree[0, 1] > 10.0 * short
    assert found(mixed, order, tree) == wanted(mixed)
    assert tree[0, 1] < 1.2 * short


@pytest.mark.parametrize("waiting", [20.0, 100.0])
def test_rope_that_waits_on_a_drum_costs_next_to_nothing(waiting: float) -> None:
    """All of it lies in one place, and none of it meets any other."""
    from ropewalk.scene import Anchor, Contact, Material, Rope, Scene, Straight, Winch

    rope = Rope(
        segments=40,
        length=4.0,
        diameter=0.01,
        made_of=Material(EA=1e4, mass_per_length=0.1),
        shape=Straight(direction=(1, 0, 0)),
    )
    winch = Winch(rope="rope", end="start", speed=0.1, on_drum=waiting)
    model = build(Scene(ropes=[rope], anchors=[Anchor(node=0)], winches=[winch], contact=Contact()))
    state, memory = model.state, model.state.memory.contact
    assert list_near(state.x, state.x, model.system.node.contact, memory, state.tied)
    assert memory.box.shape[0] > 10.0 * waiting
    assert memory.tree[0, 1] < 2.0 * memory.box.shape[0]  # nodes of the tree that were met


@pytest.mark.parametrize("seed", [0, 2])
def test_the_list_has_all_pairs_of_ropes_that_come_near(seed: int) -> None:
    """And no segments beside each other, and none that has parted, however far that reaches."""
    model = build(tangle(seed, 1 + seed, False), drawn=False)
    table, state = model.system.node.contact, model.state
    memory = state.memory.contact
    y = state.x + 0.01 * np.random.default_rng(0).normal(size=state.x.shape)
    memory.rope[5] = -1
    assert list_near(state.x, y, table, memory, state.tied)
    listed = sorted(map(tuple, memory.near[: memory.tally[NEAR]].tolist()))
    assert all(5 not in pair for pair in listed)
    alone = [pair for pair in wanted(memory.box) if min(memory.rope[list(pair)]) >= 0]
    assert len(listed) > 30
    assert set(listed) <= set(alone)
    left = [pair for pair in set(alone) - set(listed) if table.rope[pair[0]] == table.rope[pair[1]]]
    assert len(left) == len(
        set(alone) - set(listed)
    )  # only those beside each other, or at a splice
    ends = 36 - 2 * int(table.skip[0])
    assert all(j - i <= table.skip[i] or j - i >= ends for i, j in left)
