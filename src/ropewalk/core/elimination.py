"""In which order the points of a network are eliminated, and which blocks that fills."""

from __future__ import annotations

from heapq import heapify, heappop, heappush

import numpy as np
from numpy.typing import NDArray

from ropewalk.core.arrays import Ints, Joints
from ropewalk.core.block_runs import make_runs, no_runs
from ropewalk.core.network import Network, Room, no_network, no_room
from ropewalk.core.ordering import ITSELF, NOWHERE, WORD


def tied_network(
    joints: Joints,
    tied: Ints,
    alive: NDArray[np.bool_],
    second: bool,
    groups: int = 0,
) -> Network:
    """Return the network of nodes that joints tie, (j,) those that do; an empty one without joints.

    `alive` (s,) tells which segments join two nodes of a rope; with `second` next-but-one nodes are coupled.
    Up to so many `groups` of four nodes may be coupled besides, and other ones from step to step.
    """
    if not joints.member.size and groups == 0:
        return no_network()
    number = points_of(joints, tied, alive.size + 1)
    far = alive[:-1] & alive[1:] if second else np.zeros(max(alive.size - 1, 0), bool)
    network = make_network(number, alive, far)
    return with_room(network, groups) if groups else network


def points_of(joints: Joints, tied: Ints, nodes: int) -> Ints:
    """Return the number of every node's point, (n,): the same for those that are tied to each other now."""
    lead = np.arange(nodes)
    for j in np.flatnonzero(tied):
        member = joints.member[joints.first[j] : joints.first[j + 1]]
        lead[member] = member[0]
    number: Ints = np.unique(lead, return_inverse=True)[1].astype(np.int64)
    return number


def make_network(number: Ints, near: NDArray[np.bool_], far: NDArray[np.bool_]) -> Network:
    """Return the network whose nodes are the points `number`, (n,); not yet in order.

    `near` (n - 1,) tells which nodes are coupled to the next one, `far` (n - 2,) to the next but one.
    """
    points = int(number.max()) + 1
    pairs = [np.stack((number[:-1], number[1:]))[:, near]]
    pairs.append(np.stack((number[:-2], number[2:]))[:, far])
    order, neighbours = least_degree(points, np.concatenate(pairs, axis=1).T)
    place = np.empty(points, np.int64)
    place[order] = np.arange(points)
    later = [np.sort(place[sorted(neighbours[p])]) for p in order]
    start = np.cumsum([0] + [len(row) for row in later])
    number = place[number]
    index = {
        (p, int(q)): int(start[p]) + k for p, row in enumerate(later) for k, q in enumerate(row)
    }

    def blocks(coupled: NDArray[np.bool_], ahead: int) -> Ints:
        found = np.full(coupled.size, NOWHERE, np.int64)
        for j in np.flatnonzero(coupled):
            p, q = sorted((int(number[j]), int(number[j + ahead])))
            found[j] = ITSELF if p == q else index[p, q]
        return found

    count = int(start[-1])
    return Network(
        number=number,
        start=start.astype(np.int64),
        later=np.concatenate(later).astype(np.int64),
        near=blocks(near, 1),
        far=blocks(far, 2),
        spot=np.zeros(points, np.int64),
        free=np.zeros(points),
        diagonal=np.zeros((points, 9)),
        upper=np.zeros((count, 9)),
        lower=np.zeros((count, 9)),
        right=np.zeros((points, 3)),
        room=no_room(),
        runs=no_runs(),
    )


#: Blocks that there is room for, where couplings come and go, for every point; or as many as there can be.
BLOCKS = 120


def with_room(network: Network, groups: int) -> Network:
    """Return the network with room for so many groups of four nodes that may be coupled."""
    points = network.diagonal.shape[0]
    blocks = max(min(points * (points - 1) // 2, BLOCKS * points), network.later.size)
    later = np.zeros(blocks, np.int64)
    later[: network.later.size] = network.later
    room = Room(
        point=network.number.copy(),
        asked=np.zeros((groups, 4), np.int64),
        asked_count=np.zeros(1, np.int64),
        known=np.zeros((groups, 4), np.int64),
        known_count=np.full(1, -1, np.int64),
        spots=np.zeros((groups, 6), np.int64),
        bits=np.zeros((points, -(-points // WORD)), np.int64),
        place=np.zeros(points, np.int64),
        degree=np.zeros(points, np.int64),
        before=np.zeros(points, np.int64),
        after=np.zeros(points, np.int64),
        head=np.zeros(points + 1, np.int64),
    )
    return network._replace(
        later=later,
        upper=np.zeros((blocks, 9)),
        lower=np.zeros((blocks, 9)),
        room=room,
        runs=make_runs(points, blocks),
    )


def least_degree(points: int, pairs: Ints) -> tuple[list[int], list[set[int]]]:
    """Return points in an order of least degree, and every point's neighbours when its turn comes.

    Always that of the fewest neighbours, of several the first: it takes O(d^2) for a point with d of them.
    """
    beside: list[set[int]] = [set() for _ in range(points)]
    for p, q in pairs.tolist():
        if p != q:
            beside[p].add(q)
            beside[q].add(p)
    waiting = [(len(beside[p]), p) for p in range(points)]
    heapify(waiting)
    order, done = list[int](), [False] * points
    while waiting:
        degree, p = heappop(waiting)
        if done[p] or degree != len(beside[p]):
            continue  # it was put in again since
        done[p] = True
        order.append(p)
        for q in beside[p]:
            beside[q] |= beside[p]
            beside[q] -= {p, q}
            heappush(waiting, (len(beside[q]), q))
    return order, beside
