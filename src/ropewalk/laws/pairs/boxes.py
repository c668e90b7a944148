"""Which boxes overlap: a tree of them, halved again and again where they lie farthest apart.

Its nodes are numbered from 1, the halves of node k are 2 k and 2 k + 1, and all leaves lie equally deep. So
which boxes a node has follows from its number, and the tree is walked without a stack. Where each overlaps
few others that costs n log n, whatever axis they lie along; pairs that overlap are visited one by one.
Source: Ericson, Real-Time Collision Detection, 2005, ch. 6 (hierarchies of boxes, median cuts).
"""

from __future__ import annotations

import math

from ropewalk.core.jit import deferred, kernel, small

LEAF = 8  # most boxes of a leaf
# In row 0 of a tree: how many nodes its shortest walk has met since it was arranged, and its last one.
LEAST, LAST = 0, 1
LONGER = 1.5  # [1] a walk so much longer has it arranged anew


@small
def depth_for(count):
    """Return how deep the leaves of so many boxes lie."""
    depth = 0
    while count > LEAF << depth:
        depth += 1
    return depth


@small
def first_of(count, level, at):
    """Return where in the order the boxes of the node begin that is number `at` of its level."""
    return (at * count) >> level


@small
def begin_of(leaves, order, leaf):
    """Return where in the order the boxes of a leaf begin, of one more than there are: all end."""
    return ((leaf - leaves) * order.shape[0]) // leaves


@small
def room_for(count):
    """Return how many rows a tree of so many boxes has."""
    return 2 << depth_for(count)


@kernel
def longest_axis(box, order, first, last):
    """Return the axis along which the middles of some boxes lie farthest apart."""
    axis, most = 0, -1.0
    for k in range(3):
        low, high = math.inf, -math.inf
        for a in range(first, last):
            p = order[a]
            middle = box[p, k] + box[p, 3 + k]
            low, high = min(low, middle), max(high, middle)
        if high - low > most:
            axis, most = k, high - low
    return axis


@kernel
def halve(box, order, first, last, cut, axis):
    """Order some boxes so that those before `cut` lie before the others along an axis (Hoare's FIND)."""
    low, high = first, last - 1
    while low < high:
        p = order[cut]
        pivot = box[p, axis] + box[p, 3 + axis]
        a, b = low, high
        while a <= b:
            while box[order[a], axis] + box[order[a], 3 + axis] < pivot:
                a += 1
            while pivot < box[order[b], axis] + box[order[b], 3 + axis]:
                b -= 1
            if a <= b:
                order[a], order[b] = order[b], order[a]
                a, b = a + 1, b - 1
        if b < cut:
            low = a
        if cut < a:
            high = b


@kernel
def put_round(tree, node, box, p):
    """Widen a node's box by another."""
    for k in range(3):
        tree[node, k] = min(tree[node, k], box[p, k])
        tree[node, 3 + k] = max(tree[node, 3 + k], box[p, 3 + k])


@kernel
def arrange(box, order, depth):
    """Order boxes so that those of every node lie near each other."""
    count = order.shape[0]
    for level in range(depth):
        for at in range(1 << level):
            first, last = first_of(count, level, at), first_of(count, level, at + 1)
            cut = first_of(count, level + 1, 2 * at + 1)
            halve(box, order, first, last, cut, longest_axis(box, order, first, last))


@deferred("int64")
def grow_tree(box, order, tree):
    """Write the boxes of all nodes, for boxes (s, 6) of low corner and high one; return how many are leaves.

    They are put in order anew where the last walk has met far more nodes than the shortest with that order.
    """
    count = order.shape[0]
    depth = depth_for(count)
    leaves = 1 << depth
    if tree[0, LAST] >= LONGER * tree[0, LEAST]:
        arrange(box, order, depth)
        tree[0, LEAST] = math.inf
    else:
        tree[0, LEAST] = min(tree[0, LEAST], tree[0, LAST])
    tree[0, LAST] = 0.0
    for node in range(1, 2 * leaves):
        for k in range(3):
            tree[node, k], tree[node, 3 + k] = math.inf, -math.inf
    for at in range(leaves):
        for a in range(first_of(count, depth, at), first_of(count, depth, at + 1)):
            put_round(tree, leaves + at, box, order[a])
    for back in range(2, 2 * leaves):
        node = 2 * leaves + 1 - back
        put_round(tree, node >> 1, tree, node)
    return leaves


@small
def overlap(box, p, other, q):
    """Tell whether box p of some and box q of others overlap, were it in a point."""
    along = (box[p, 0] <= other[q, 3]) & (
        other[q, 0] <= box[p, 3]
    )  # without branches: none is foreseen
    aside = (box[p, 1] <= other[q, 4]) & (other[q, 1] <= box[p, 4])
    return along & aside & (box[p, 2] <= other[q, 5]) & (other[q, 2] <= box[p, 5])


@kernel
def next_leaf(tree, leaves, leaf, node):
    """Return the first leaf behind all that is below a node whose box overlaps that of `leaf`; 0: none."""
    node = _behind(node)
    while node > 0:
        tree[0, LAST] += 1.0
        if not overlap(tree, leaf, tree, node):
            node = _behind(node)
        elif node < leaves:
            node = 2 * node
        else:
            return node
    return 0


@small
def _behind(node):
    """Return the node behind all that is below a node; 0: there is none."""
    while node & 1:
        node >>= 1
    return node + 1 if node > 0 else 0
