"""Elimination of a network that fills in much, with runs of blocks in registers, to the same bits.

Where several later neighbours of a point follow each other among those of one of them, too, their blocks are
a run: as many times three numbers, from which a multiple of three rows is taken, WIDTH at a time. For that a
point's blocks lie as three rows, and those of its column, turned over, as three more. Runs are found once for
an order.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats, Ints
from ropewalk.core.blocks import (
    add,
    apply,
    load9,
    multiply,
    scale9,
    solve3,
    solve_left3,
    store9,
    transpose,
    triangles,
)
from ropewalk.core.jit import deferred, kernel, small
from ropewalk.core.lanes import WIDTH, load, pick, spread, store

MUCH = 3  # blocks for a point from which on this is quicker
ROOM = 4  # runs that there is room for, for a block


class Runs(NamedTuple):
    """The runs of an order, and rows that lie `span_of` them apart; all (0,) where couplings stay."""

    first: Ints  # (m + 1,) the first run of every point, and how many there are: 0 for none
    to: Ints  # (r,) the block that a run is taken from
    length: Ints  # (r,) its blocks
    above: Floats  # (3 b,) and room: upper blocks
    beside: Floats  # the same of lower ones, turned over
    turned: Floats  # (3 m,) and room: a pivot's inverse times its upper blocks
    low: Floats  # its lower blocks times its inverse, turned over
    places: Floats  # (WIDTH,) 0, 1, 2 and so on


def no_runs() -> Runs:
    """Return those of a network whose order stays."""
    whole, none = np.zeros(0, np.int64), np.zeros(0)
    return Runs(whole, whole, whole, none, none, none, none, none)


def make_runs(points: int, blocks: int) -> Runs:
    """Return room for the runs of a network of so many blocks at most."""
    first, to, length = (np.zeros(n, np.int64) for n in (points + 1, ROOM * blocks, ROOM * blocks))
    above, beside, turned, low = (
        np.zeros(3 * (3 * n + WIDTH)) for n in (blocks, blocks, points, points)
    )
    places = np.arange(WIDTH, dtype=float)
    return Runs(first, to, length, above, beside, turned, low, places)


@kernel
def find_runs(network):
    """Find the runs of an order that fills in much; there are none where there is no room for them."""
    start, later, runs = network.start, network.later, network.runs
    points, found = network.diagonal.shape[0], 0
    runs.first[points] = 0
    if start[points] < MUCH * points:
        return
    for p in range(points):
        runs.first[p], last = found, start[p + 1]
        for k in range(start[p], last):
            q, r = start[later[k]], k + 1
            while r < last:
                while later[q] < later[r]:
                    q += 1
                if found == runs.to.shape[0]:
                    return
                count = 1
                while r + count < last and later[q + count] == later[r + count]:
                    count += 1
                runs.to[found], runs.length[found] = q, count
                found, q, r = found + 1, q + count, r + count
    runs.first[points] = found


@small
def has_runs(network):
    """Tell whether runs of the order in hand were found."""
    first = network.runs.first
    return first.shape[0] > 0 and first[first.shape[0] - 1] > 0


@small
def span_of(rows):
    """Return how far apart three rows lie in an array."""
    return rows.shape[0] // 3


@small
def put_rows(rows, span, i, m):
    """Write block `i` as part of three rows."""
    for c in range(3):
        for k in range(3):
            rows[c * span + 3 * i + k] = m[3 * c + k]


@small
def get_rows(rows, span, i):
    """Return block `i`."""
    at, below, last = 3 * i, 3 * i + span, 3 * i + 2 * span
    return (
        rows[at], rows[at + 1], rows[at + 2],
        rows[below], rows[below + 1], rows[below + 2],
        rows[last], rows[last + 1], rows[last + 2],
    )  # fmt: skip


@small
def load3(rows, span, at):
    """Return WIDTH numbers of each of three rows."""
    return load(rows, at), load(rows, at + span), load(rows, at + 2 * span)


@small
def store3(rows, span, at, values):
    """Write WIDTH numbers of each of three rows."""
    store(rows, at, values[0])
    store(rows, at + span, values[1])
    store(rows, at + 2 * span, values[2])


@small
def less(m, rows, span, here, at):
    """Return three rows from `at` on, less m times those from `here` on."""
    u0, u1, u2 = load3(rows, span, here)
    t0, t1, t2 = load3(rows, span, at)
    return (
        t0 - (m[0] * u0 + m[1] * u1 + m[2] * u2),
        t1 - (m[3] * u0 + m[4] * u1 + m[5] * u2),
        t2 - (m[6] * u0 + m[7] * u1 + m[8] * u2),
    )


@small
def take_run(rows, span, to, source, count, m, places):
    """Take m times `count` blocks, block `source` the first, from as many of which `to` is the first."""
    at, here, end = 3 * to, 3 * source, 3 * (source + count)
    while here + WIDTH <= end:
        store3(rows, span, at, less(m, rows, span, here, at))
        here, at = here + WIDTH, at + WIDTH
    if here < end:  # what lies behind them stays
        left, (t0, t1, t2) = spread(float(end - here)), load3(rows, span, at)
        s0, s1, s2 = less(m, rows, span, here, at)
        kept = pick(places, left, s0, t0), pick(places, left, s1, t1), pick(places, left, s2, t2)
        store3(rows, span, at, kept)


@kernel
def begin_rows(network):
    """Write the blocks as rows."""
    above, beside = network.runs.above, network.runs.beside
    for q in range(network.start[network.diagonal.shape[0]]):
        put_rows(above, span_of(above), q, load9(network.upper, q))
        put_rows(beside, span_of(beside), q, transpose(load9(network.lower, q)))


@kernel
def turn_rows(runs, pivot, first, last):
    """Write a pivot's inverse, of factors `pivot`, times its blocks, `first` to `last` - 1."""
    above, beside, turned, low = runs.above, runs.beside, runs.turned, runs.low
    span, own = span_of(above), span_of(turned)
    for at in range(0, 3 * (last - first), WIDTH):
        store3(turned, own, at, solve3(pivot, load3(above, span, 3 * first + at)))
        store3(low, own, at, solve_left3(load3(beside, span, 3 * first + at), pivot))


@deferred()
def eliminate_runs(network):
    """Factor the blocks and solve, as `core.network.eliminate`; the blocks stay."""
    start, later, runs = network.start, network.later, network.runs
    diagonal, right, above, beside = network.diagonal, network.right, runs.above, runs.beside
    span, own, points = span_of(above), span_of(runs.turned), diagonal.shape[0]
    begin_rows(network)
    places = load(runs.places, 0)
    for p in range(points):
        if network.free[p] == 0.0:
            continue
        pivot = triangles(load9(diagonal, p))
        store9(diagonal, p, pivot)
        first, last, run = start[p], start[p + 1], runs.first[p]
        y = (right[p, 0], right[p, 1], right[p, 2])
        turn_rows(runs, pivot, first, last)
        for k in range(first, last):
            a, r = later[k], k + 1
            low = transpose(get_rows(runs.low, own, k - first))
            both = multiply(low, get_rows(above, span, k))
            store9(diagonal, a, add(load9(diagonal, a), scale9(-1.0, both)))
            less_right(right, a, apply(low, y))
            turned = transpose(get_rows(runs.turned, own, k - first))
            while r < last:
                to, count = runs.to[run], runs.length[run]
                take_run(above, span, to, r, count, low, places)
                take_run(beside, span, to, r, count, turned, places)
                r, run = r + count, run + 1
    come_back(network)


@small
def less_right(right, p, less):
    """Take a vector from the right side of a point."""
    for k in range(3):
        right[p, k] -= less[k]


@kernel
def come_back(network):
    """Solve for the points, the last first."""
    right, above, later = network.right, network.runs.above, network.later
    span, points = span_of(above), right.shape[0]
    for back in range(points):
        p = points - 1 - back
        if network.free[p] == 0.0:
            right[p, 0], right[p, 1], right[p, 2] = 0.0, 0.0, 0.0
            continue
        for k in range(network.start[p], network.start[p + 1]):
            a = later[k]
            z = (right[a, 0], right[a, 1], right[a, 2])
            less_right(right, p, apply(get_rows(above, span, k), z))
        y = solve3(load9(network.diagonal, p), (right[p, 0], right[p, 1], right[p, 2]))
        right[p, 0], right[p, 1], right[p, 2] = y
