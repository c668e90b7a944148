"""How the forces of slides change: 3 x 3 blocks between the four nodes of each.

With a, a', a'' the nodes' shares in r, r', r'', c = grad u, D = g', w and R of `slide_force`,
t = r'/|r'|, and m, n two of the nodes:
    grad grad V = k (a_m a_n I - D c_m c_n^T)
    -d(R w c)   = w^2 (k + damping) c_m c_n^T - R U_mn                          where it sticks
                  mu k w R/|R| c_m (a_n r/|r|)^T - R U_mn                        where it slips
    U_mn = -((a_m a'_n + a'_m a_n) I + h_m c_n^T) / |r'| - w c_m (a'_n t + t.r'' c_n)^T / |r'|
    h_m = 2 a'_m r' + a_m r'' + a''_m r
How w c turns is left out of what spring and damping do, the way of the brake's force, and that of a drum,
which an anchor holds.
"""

from __future__ import annotations

from ropewalk.core.jit import deferred, kernel, small
from ropewalk.core.network import add_block, put_pair
from ropewalk.laws.slides.rail import look
from ropewalk.laws.slides.slide_force import cut, on_rope, rubbing
from ropewalk.laws.slides.stops import to_drum
from ropewalk.laws.slides.table import (
    APART,
    ASKED,
    BEND,
    GRADIENT,
    INSIDE,
    PER_PLACE,
    R1,
    R2,
    RATE,
    SHARE,
    SLOPE,
    STRETCHES,
    TURNS,
    R,
)


@small
def weights_of(x, v, table, memory, row, weight_x, weight_v):
    """Return the factors of a_m a_n I, of c_m c_n^T, of c_m (a_n r)^T and of U_mn [N/m, N m, N, N]."""
    sight, k = memory.sight, table.stiffness[row]
    across = weight_x * k
    if sight[row, INSIDE] == 0.0:
        return across, 0.0, 0.0, 0.0
    along, aside, turn = -weight_x * k * sight[row, SLOPE], 0.0, 0.0
    q, bound = rubbing(v, table, memory, row)
    held, w = cut(q, bound), sight[row, PER_PLACE]
    if bound > 0.0:
        turn = -weight_x * held
        if held == q:
            along += w * w * (weight_x * table.hold[row] + weight_v * table.damping[row])
        elif sight[row, APART] > 0.0:
            side = 1.0 if q > 0.0 else -1.0
            aside = -weight_x * side * table.friction[row] * k * w / sight[row, APART]
    return across, along, aside, turn


@small
def turned(sight, row, m, k):
    """Return component k of h_m."""
    found = (
        2.0 * sight[row, RATE + m] * sight[row, R1 + k] + sight[row, SHARE + m] * sight[row, R2 + k]
    )
    return found + sight[row, BEND + m] * sight[row, R + k]


@kernel
def entry(sight, row, m, n, i, k, weights):
    """Return one number of the block between nodes m and n: row i, column k."""
    across, along, aside, turn = weights
    cm, cn = sight[row, GRADIENT + 3 * m + i], sight[row, GRADIENT + 3 * n + k]
    found = along * cm * cn + aside * cm * sight[row, SHARE + n] * sight[row, R + k]
    if turn != 0.0:
        w, slope = sight[row, PER_PLACE], sight[row, SLOPE]
        speed = slope / w
        pull = sight[row, RATE + n] * sight[row, R1 + k] * sight[row, TURNS]
        pull += sight[row, STRETCHES] * cn
        found -= turn * (turned(sight, row, m, i) * cn / speed + w * cm * pull)
    if i == k:
        found += across * sight[row, SHARE + m] * sight[row, SHARE + n]
        if turn != 0.0:
            both = sight[row, SHARE + m] * sight[row, RATE + n]
            both += sight[row, RATE + m] * sight[row, SHARE + n]
            found -= turn * both / speed
    return found


@kernel
def block(sight, row, m, n, weights):
    """Return the block between nodes m and n, row by row."""
    return (
        entry(sight, row, m, n, 0, 0, weights),
        entry(sight, row, m, n, 0, 1, weights),
        entry(sight, row, m, n, 0, 2, weights),
        entry(sight, row, m, n, 1, 0, weights),
        entry(sight, row, m, n, 1, 1, weights),
        entry(sight, row, m, n, 1, 2, weights),
        entry(sight, row, m, n, 2, 0, weights),
        entry(sight, row, m, n, 2, 1, weights),
        entry(sight, row, m, n, 2, 2, weights),
    )


@kernel
def stop_block(x, table, memory, row, weight_x):
    """Return the block of the node that slides, of the stops at drums, row by row."""
    a, b, c, d, e, f = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    for side in range(2):
        drum, deep, p, q, r, apart = to_drum(x, table, memory, row, side)
        if drum >= 0:
            k = weight_x * table.stiffness[row]
            aside = -k * deep / apart
            along = k - aside
            a += along * p * p + aside
            b += along * p * q
            c += along * p * r
            d += along * q * q + aside
            e += along * q * r
            f += along * r * r + aside
    return a, b, c, b, d, e, c, e, f


@deferred()
def couple_slides(x, v, table, memory, weight_x, weight_v, network):
    """Add -(weight_x df/dx + weight_v df/dv) of all slides to the network's blocks."""
    number, sight, group, first = network.number, memory.sight, memory.group, memory.tally[ASKED]
    for row in range(table.node.shape[0]):
        if not on_rope(memory, row):
            continue
        look(x, table, memory, row)
        weights = weights_of(x, v, table, memory, row, weight_x, weight_v)
        stop = stop_block(x, table, memory, row, weight_x)
        add_block(network.diagonal, number[table.node[row]], stop)
        at = 0
        for m in range(4):
            p = number[group[row, m]]
            add_block(network.diagonal, p, block(sight, row, m, m, weights))
            for n in range(m + 1, 4):
                up, low = block(sight, row, m, n, weights), block(sight, row, n, m, weights)
                put_pair(
                    network, p, number[group[row, n]], network.room.spots[first + row, at], up, low
                )
                at += 1


@deferred("float64")
def along_slides(x, v, d, table, memory, weight_x, weight_v):
    """Return d . K d of the same matrix [N m], for a direction (3, n) [m]."""
    total = 0.0
    for row in range(table.node.shape[0]):
        if not on_rope(memory, row):
            continue
        look(x, table, memory, row)
        weights = weights_of(x, v, table, memory, row, weight_x, weight_v)
        stop, node = stop_block(x, table, memory, row, weight_x), table.node[row]
        for i in range(3):
            for k in range(3):
                total += d[i, node] * stop[3 * i + k] * d[k, node]
        for m in range(4):
            for n in range(4):
                for i in range(3):
                    for k in range(3):
                        one = entry(memory.sight, row, m, n, i, k, weights)
                        one *= d[i, memory.group[row, m]] * d[k, memory.group[row, n]]
                        total += one
    return total
