"""The books of contacts: what surfaces give and take, motor, squeeze and friction apart.

Over an accepted step let N and Q be the mean forces of an obstacle on a node, what presses and what rubs, m
the way of the surface as it moves, D the node's way over it as it moves and turns, d = D + w, and G by how
much its gap has grown along the normal n. A body that is not round, whose turning moves the surface, adds its
angle times a x o to m, a its axle and o the mean of the node's places from it at both ends: torque times
angle, which the chord of the surface's way is of first order off. Then
    N . n G        what presses,        Q . D        what rubs,        N . m + Q . w        the motor
have done. The first two only take, but for what the contact stores, its squeeze, see `hardening`, and
|R|^2 / (2 k) of the friction spring: by implicit Euler friction in every step, pressing on flat bodies, for
both are convex, and on round ones but for what a step's chord lacks of its arc. The ledger's own work is
F . (v0 + v1) h / 2, F = N + Q (see `ledger`); what is left of it is the method's, which takes chords for arcs
and a mean speed for a way. With it the entries add up to the ledger's to rounding.
"""

from __future__ import annotations

from ropewalk.core.jit import deferred, small
from ropewalk.laws.contact_frame import carried, turn_of

# Rows of `Memory.books`: works so far [J], what is stored now [J], and the gap now [m].
MOTOR, PRESS, RUB, METHOD, PRESSED, RUBBED, GAP, BOOKS = range(8)
#: What is recorded of every surface [J]: work on the ropes; they add up to the law's.
ENTRIES = ("motor", "normal", "friction", "stored", "method")
# Rows of `Memory.slip`: n G, D and m [m]; and where D tells the velocity over the surface at a step's end,
# see `obstacle_lead`, 1 over its length [1/s], else 0, and when that is [s].
RISE, OVER, LED, OFTEN, WHEN, WAYS = 0, 3, 6, 9, 10, 11


@small
def put_apart(force, o, i, push, nx, ny, nz, sx, sy, sz):
    """Write what presses and what rubs into an obstacle's own rows of the force."""
    row = 3 + 6 * o
    force[row, i], force[row + 1, i], force[row + 2, i] = push * nx, push * ny, push * nz
    force[row + 3, i], force[row + 4, i], force[row + 5, i] = sx, sy, sz


@small
def note_way(obstacles, memory, o, i, now, then, angle, x, y, z, gap, n0, n1, n2):
    """Keep a node's way over an obstacle in the step that ends at x, y, z, in its frame, and its gap.

    `now` and `then` are what `surface_at` gives for the step's ends, `angle` by what it has turned between.
    """
    slip, place, hub, axle = memory.slip[o], memory.place, obstacles.hub[o], obstacles.axle[o]
    books = memory.books[o]
    turn = turn_of(angle)
    _, _, _, dx, dy, dz = carried(hub, axle, angle, then, memory.grip[o], place, i, x, y, z, turn)
    rise = gap - books[GAP, i]
    slip[RISE, i], slip[RISE + 1, i], slip[RISE + 2, i] = rise * n0, rise * n1, rise * n2
    slip[OVER, i], slip[OVER + 1, i], slip[OVER + 2, i] = dx, dy, dz
    for k in range(3):
        slip[LED + k, i] = now[k] - then[k]
    if angle != 0.0 and obstacles.sweeps[o]:  # what its turning leads along, too
        ox = 0.5 * (x + place[0, i] - then[0]) - hub[0]
        oy = 0.5 * (y + place[1, i] - then[1]) - hub[1]
        oz = 0.5 * (z + place[2, i] - then[2]) - hub[2]
        slip[LED, i] += angle * (axle[1] * oz - axle[2] * oy)
        slip[LED + 1, i] += angle * (axle[2] * ox - axle[0] * oz)
        slip[LED + 2, i] += angle * (axle[0] * oy - axle[1] * ox)
    books[GAP, i] = gap


@deferred()
def book_contacts(memory, force, middle, dt):
    """Book a step's works: of its mean forces, `middle` the mean of the speeds at its ends, (3, n)."""
    way = memory.way
    if force.shape[0] < 3 + 6 * memory.slip.shape[0]:
        return
    for o in range(memory.slip.shape[0]):
        books, slip, row = memory.books[o], memory.slip[o], 3 + 6 * o
        for i in range(way.shape[1]):
            press, rub, motor, whole = 0.0, 0.0, 0.0, 0.0
            for k in range(3):
                n, q = force[row + k, i], force[row + 3 + k, i]
                press += n * slip[RISE + k, i]
                rub += q * slip[OVER + k, i]
                motor += n * slip[LED + k, i] + q * (way[k, i] - slip[OVER + k, i])
                whole += (n + q) * (dt * middle[k, i])
            books[PRESS, i] += press
            books[RUB, i] += rub
            books[MOTOR, i] += motor
            books[METHOD, i] += whole - press - rub - motor


@deferred()
def record_books(books, out):
    """Write the entries of every obstacle, (k, 5) [J]; see ENTRIES."""
    for o in range(books.shape[0]):
        sums = out[o]
        for e in range(sums.shape[0]):
            sums[e] = 0.0
        for i in range(books.shape[2]):
            pressed, rubbed = books[o, PRESSED, i], books[o, RUBBED, i]
            sums[0] += books[o, MOTOR, i]
            sums[1] += books[o, PRESS, i] + pressed
            sums[2] += books[o, RUB, i] + rubbed
            sums[3] -= pressed + rubbed
            sums[4] += books[o, METHOD, i]
