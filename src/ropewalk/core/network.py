"""Newton's equations of ropes that are tied to each other or to themselves, by sparse blocks.

As in `saddle`, but nodes of a joint share their displacement. The segments' tensions are condensed,
    T' = (d t . (z_(j+1) - z_j) + g) / e ,
which leaves 3 x 3 blocks on a graph whose points are the joints and the other nodes. It is eliminated point
by point, in an order of least degree that the host finds once (`core.elimination`): chains, which are most of
it, fill in nothing. There is no pivoting, and the values need not be symmetric. Held points are left out.

No compliance may be next to nothing here, as its inverse stands in the blocks. `soften` raises it to a part
of what the nodes' inertia gives, 1e-9: what a rigid link's length then lacks after an iteration is that part
of its misfit, and the next one makes it up (the method of multipliers).
Source: Duff, Erisman & Reid, Direct Methods for Sparse Matrices, ch. 7 (minimum degree); Nocedal & Wright,
Numerical Optimization, ch. 17 (multipliers).
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats, Ints
from ropewalk.core.block_runs import Runs, eliminate_runs, has_runs, no_runs
from ropewalk.core.blocks import (
    ZERO9,
    add,
    apply,
    load9,
    multiply,
    plus_line,
    scale9,
    solve3,
    solve9,
    solve_left9,
    store9,
    subtract,
    triangles,
)
from ropewalk.core.jit import deferred, kernel, small
from ropewalk.core.ordering import ITSELF, NOWHERE

SOFTEST = 1e-9  # [1] least compliance over that of the lighter node's inertia


class Room(NamedTuple):
    """What finding the order anew takes, where couplings come and go; see `ordering`."""

    point: Ints  # (n,) the point of every node, not in order; (0,) where couplings stay
    asked: Ints  # (c, 4) nodes that are to be coupled
    asked_count: Ints  # (1,)
    known: Ints  # (c, 4) those that are coupled in the order in hand
    known_count: Ints  # (1,) of them; -1: there is none yet
    spots: Ints  # (c, 6) blocks of their four nodes
    bits: Ints  # (m, w) neighbours
    place: Ints  # (m,) of every point in the order
    degree: Ints  # (m,)
    before: Ints  # (m,) the point before it of those of its degree, -1: none
    after: Ints  # (m,)
    head: Ints  # (m + 1,) the first point of every degree, -1: none


class Network(NamedTuple):
    """Pattern and blocks; m points, in the order of elimination."""

    number: Ints  # (n,) the point of every node; (0,) where nothing is tied
    start: Ints  # (m + 1,) where a point's later neighbours begin
    later: Ints  # (b,) their numbers, rising
    near: Ints  # (s,) the block of each segment's nodes, NOWHERE, or ITSELF
    far: Ints  # (n - 2,) the same of a node and the next but one
    spot: Ints  # (m,) working space
    free: Floats  # (m,) 1 for free points, 0 for held ones
    diagonal: Floats  # (m, 9)
    upper: Floats  # (b, 9) row of a point, column of its later neighbour
    lower: Floats  # (b, 9) row of the neighbour, column of the point
    right: Floats  # (m, 3)
    room: Room
    runs: Runs


def no_room() -> Room:
    """Return the room of a network whose order stays."""
    none, wide = np.zeros(0, np.int64), np.zeros((0, 0), np.int64)
    return Room(none, wide, none, wide, none, wide, wide, *(none,) * 5)


def no_network() -> Network:
    """Return that of ropes which nothing ties."""
    none = np.zeros(0, np.int64)
    blocks = (np.zeros((0, 9)),) * 3
    return Network(*(none,) * 6, np.zeros(0), *blocks, np.zeros((0, 3)), no_room(), no_runs())


@kernel
def soften(weight, carries, compliance):
    """Raise the compliance of what carries to what can be solved with; `weight` is of `Segments`, (s,)."""
    for j in range(weight.shape[0]):
        if carries[j] != 0.0:
            compliance[j] = max(compliance[j], SOFTEST / weight[j])


@small
def add_block(blocks, i, m):
    """Add to block `i`."""
    store9(blocks, i, add(load9(blocks, i), m))


@small
def put_pair(network, p, q, block, up, low):
    """Add what couples two points, `up` in row p and `low` in row q, at the index of their block."""
    if block == ITSELF:
        add_block(network.diagonal, p, add(up, low))
    elif block != NOWHERE:
        first, second = (up, low) if p < q else (low, up)
        add_block(network.upper, block, first)
        add_block(network.lower, block, second)


@deferred()
def gather(saddle, network):
    """Write blocks and right sides of the points from the equations of nodes and segments."""
    number, band, force, right = network.number, saddle.band, saddle.force, network.right
    for p in range(network.diagonal.shape[0]):
        store9(network.diagonal, p, ZERO9)
        for k in range(3):
            right[p, k] = 0.0
    for b in range(network.start[network.diagonal.shape[0]]):
        store9(network.upper, b, ZERO9)
        store9(network.lower, b, ZERO9)
    n, far = number.shape[0], band.upper2.shape[0] > 0
    for i in range(n):
        p, d, a = number[i], saddle.inertia[i], load9(band.diagonal, i)
        a = (a[0] + d, a[1], a[2], a[3], a[4] + d, a[5], a[6], a[7], a[8] + d)
        add_block(network.diagonal, p, a)
        network.free[p] = saddle.free[i]
        for k in range(3):
            right[p, k] += force[k, i]
    for j in range(n - 1):
        p, q = number[j], number[j + 1]
        across, along = saddle.across[j], saddle.along[j]
        over = 1.0 / saddle.compliance[j]
        stiff = along + over * saddle.carries[j]
        line = plus_line(ZERO9, 1.0, across, stiff, saddle.direction, j)
        add_block(network.diagonal, p, line)
        add_block(network.diagonal, q, line)
        up, low = subtract(load9(band.upper1, j), line), subtract(load9(band.lower1, j), line)
        put_pair(network, p, q, network.near[j], up, low)
        pull = over * saddle.misfit[j]
        for k in range(3):
            right[p, k] += pull * saddle.direction[k, j]
            right[q, k] -= pull * saddle.direction[k, j]
        if far and j < n - 2:
            q = number[j + 2]
            put_pair(network, p, q, network.far[j], load9(band.upper2, j), load9(band.lower2, j))


@kernel
def eliminate(network):
    """Factor the blocks, which become those of the factors, and solve; the solution is in `right`."""
    start, later, spot = network.start, network.later, network.spot
    diagonal, upper, lower, right = network.diagonal, network.upper, network.lower, network.right
    for p in range(diagonal.shape[0]):
        if network.free[p] == 0.0:
            continue
        pivot = triangles(load9(diagonal, p))
        store9(diagonal, p, pivot)
        first, last = start[p], start[p + 1]
        y = (right[p, 0], right[p, 1], right[p, 2])
        for k in range(first, last):
            a, up = later[k], load9(upper, k)
            low = solve_left9(load9(lower, k), pivot)
            add_block(diagonal, a, scale9(-1.0, multiply(low, up)))
            less = apply(low, y)
            for c in range(3):
                right[a, c] -= less[c]
            if k + 1 == last:
                continue
            turned = solve9(pivot, up)
            for q in range(start[a], start[a + 1]):
                spot[later[q]] = q
            for r in range(k + 1, last):
                q = spot[later[r]]
                add_block(upper, q, scale9(-1.0, multiply(low, load9(upper, r))))
                add_block(lower, q, scale9(-1.0, multiply(load9(lower, r), turned)))
    for back in range(diagonal.shape[0]):
        p = diagonal.shape[0] - 1 - back
        if network.free[p] == 0.0:
            right[p, 0], right[p, 1], right[p, 2] = 0.0, 0.0, 0.0
            continue
        y0, y1, y2 = right[p, 0], right[p, 1], right[p, 2]
        for k in range(start[p], start[p + 1]):
            a = later[k]
            less = apply(load9(upper, k), (right[a, 0], right[a, 1], right[a, 2]))
            y0, y1, y2 = y0 - less[0], y1 - less[1], y2 - less[2]
        y = solve3(load9(diagonal, p), (y0, y1, y2))
        for c in range(3):
            right[p, c] = y[c]


@kernel
def solve_network(saddle):
    """Solve the equations; the solution is in `moved` and `pulled`, not finite where there is none."""
    gather(saddle, saddle.network)
    solve_gathered(saddle)


@deferred()
def solve_gathered(saddle):
    """As `solve_network`, with blocks and right sides in the network."""
    network = saddle.network
    if has_runs(network):
        eliminate_runs(network)
    else:
        eliminate(network)
    number, z, direction = network.number, network.right, saddle.direction
    for i in range(number.shape[0]):
        for k in range(3):
            saddle.moved[k, i] = z[number[i], k]
    for j in range(number.shape[0] - 1):
        p, q, rate = number[j], number[j + 1], 0.0
        for k in range(3):
            rate += direction[k, j] * (z[q, k] - z[p, k])
        pull = saddle.carries[j] * rate + saddle.misfit[j]
        saddle.pulled[j] = pull / saddle.compliance[j]
