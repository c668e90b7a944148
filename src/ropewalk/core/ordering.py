"""The order of elimination of a network whose couplings come and go, found inside a kernel.

As `elimination` does on the host: always a point of least degree, whose neighbours then become each other's.
The neighbours of a point are bits of a row, so that this takes O(points^2 / 60) for points of few neighbours.
Source: Duff, Erisman & Reid, Direct Methods for Sparse Matrices, ch. 7.
"""

from __future__ import annotations

import math

from ropewalk.core.block_runs import find_runs
from ropewalk.core.jit import deferred, kernel, small

NOWHERE, ITSELF = (
    -1,
    -2,
)  # in place of the index of a block: there is none, or it is on the diagonal
WORD = 60  # bits used of a number


@small
def set_bit(bits, p, q):
    """Set bit `q` of row `p`."""
    bits[p, q // WORD] |= 1 << (q % WORD)


@small
def clear_bit(bits, p, q):
    """Clear bit `q` of row `p`."""
    bits[p, q // WORD] &= ~(1 << (q % WORD))


@small
def lowest(word):
    """Return the place of the lowest bit of a positive number."""
    return math.frexp(float(word & -word))[1] - 1


@small
def bits_set(word):
    """Count the bits of a number of up to WORD bits."""
    word = word - ((word >> 1) & 0x555555555555555)
    word = (word & 0x333333333333333) + ((word >> 2) & 0x333333333333333)
    word = (word + (word >> 4)) & 0xF0F0F0F0F0F0F0F
    word = word + (word >> 8)
    word = word + (word >> 16)
    return (word + (word >> 32)) & 0x7F


@small
def member(group, row, a):
    """Return node `a` of the four that a group couples: those of two segments, (m, 2), or nodes, (m, 4)."""
    return group[row, a] if group.shape[1] == 4 else group[row, a // 2] + a % 2


@kernel
def begin_groups(network):
    """Begin a list of the groups of four nodes that are to be coupled."""
    network.room.asked_count[0] = 0


@deferred("int64")
def ask_for(network, group, count):
    """Add `count` groups to the list, (m, 2) or (m, 4); return the row of the first of them."""
    room = network.room
    first = room.asked_count[0]
    for row in range(count):
        for k in range(4):
            room.asked[first + row, k] = member(group, row, k)
    room.asked_count[0] = first + count
    return first


@kernel
def is_known(room):
    """Tell whether the order in hand is that of the groups asked for; note them otherwise."""
    count, known, asked = room.asked_count[0], room.known, room.asked
    same = room.known_count[0] == count
    for row in range(count):
        for k in range(4):
            same = same and known[row, k] == asked[row, k]
            known[row, k] = asked[row, k]
    room.known_count[0] = count
    return same


@small
def couple(bits, p, q):
    """Let two points be neighbours."""
    if p != q:
        set_bit(bits, p, q)
        set_bit(bits, q, p)


@kernel
def graph(network):
    """Write the neighbours of every point as bits."""
    room, bits, n = network.room, network.room.bits, network.number.shape[0]
    point = room.point
    for p in range(bits.shape[0]):
        for word in range(bits.shape[1]):
            bits[p, word] = 0
    for i in range(n - 1):
        if network.near[i] != NOWHERE:
            couple(bits, point[i], point[i + 1])
        if i < n - 2 and network.far[i] != NOWHERE:
            couple(bits, point[i], point[i + 2])
    for row in range(room.asked_count[0]):
        for a in range(4):
            for b in range(a + 1, 4):
                couple(bits, point[room.asked[row, a]], point[room.asked[row, b]])


@small
def take_out(room, p):
    """Take a point out of the list of those of its degree."""
    before, after = room.before[p], room.after[p]
    if before >= 0:
        room.after[before] = after
    else:
        room.head[room.degree[p]] = after
    if after >= 0:
        room.before[after] = before


@small
def put_in(room, p, degree):
    """Put a point at the head of the list of those of a degree."""
    first = room.head[degree]
    room.degree[p], room.before[p], room.after[p] = degree, -1, first
    if first >= 0:
        room.before[first] = p
    room.head[degree] = p


@small
def degree_of(bits, p):
    """Count the neighbours of a point."""
    total = 0
    for word in range(bits.shape[1]):
        total += bits_set(bits[p, word])
    return total


@kernel
def eliminate_points(network):
    """Write the order and every point's later neighbours; return whether there was room for them."""
    room, bits, later, start = network.room, network.room.bits, network.later, network.start
    points, filled, least = bits.shape[0], 0, 0
    for degree in range(points + 1):
        room.head[degree] = -1
    for back in range(points):
        p = points - 1 - back
        put_in(room, p, degree_of(bits, p))
    for turn in range(points):
        while room.head[least] < 0:
            least += 1
        p = room.head[least]
        take_out(room, p)
        room.place[p], start[turn] = turn, filled
        if filled + room.degree[p] > later.shape[0]:
            return False
        first = filled
        for word in range(bits.shape[1]):
            left = bits[p, word]
            while left != 0:
                later[filled] = WORD * word + lowest(left)
                left &= left - 1
                filled += 1
        for k in range(first, filled):
            q = later[k]
            take_out(room, q)
            for word in range(bits.shape[1]):
                bits[q, word] |= bits[p, word]
            clear_bit(bits, q, p)
            clear_bit(bits, q, q)
            degree = degree_of(bits, q)
            put_in(room, q, degree)
            least = min(least, degree)
    start[points] = filled
    return True


@kernel
def sort_later(network):
    """Turn points into places in the order, rising in every row."""
    later, start, place = network.later, network.start, network.room.place
    for turn in range(place.shape[0]):
        for k in range(start[turn], start[turn + 1]):
            value, at = place[later[k]], k
            while at > start[turn] and later[at - 1] > value:
                later[at] = later[at - 1]
                at -= 1
            later[at] = value


@kernel
def block_of(network, p, q):
    """Return the index of the block that couples two places in the order."""
    if p == q:
        return ITSELF
    first, second = min(p, q), max(p, q)
    low, high = network.start[first], network.start[first + 1]
    while low < high:
        middle = (low + high) // 2
        if network.later[middle] < second:
            low = middle + 1
        else:
            high = middle
    return low


@deferred("boolean")
def order_groups(network):
    """Find order and blocks of a network with the groups asked for coupled; return whether they fit."""
    room = network.room
    if is_known(room):
        return True
    graph(network)
    if not eliminate_points(network):
        room.known_count[0] = -1
        return False
    sort_later(network)
    find_runs(network)
    number, n = network.number, network.number.shape[0]
    for i in range(n):
        number[i] = room.place[room.point[i]]
    for i in range(n - 1):
        if network.near[i] != NOWHERE:
            network.near[i] = block_of(network, number[i], number[i + 1])
        if i < n - 2 and network.far[i] != NOWHERE:
            network.far[i] = block_of(network, number[i], number[i + 2])
    for row in range(room.asked_count[0]):
        at = 0
        for a in range(4):
            for b in range(a + 1, 4):
                p, q = room.asked[row, a], room.asked[row, b]
                room.spots[row, at] = block_of(network, number[p], number[q])
                at += 1
    return True
