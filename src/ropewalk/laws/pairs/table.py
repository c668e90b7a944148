"""What contacts of segments are made from, and what they remember.

A contact is a row: two segments i < j, the point of each where they touch, and the normal there. They stay
frozen while a step is solved; see `pair_memory` for when they are found anew.
"""

from __future__ import annotations

from typing import NamedTuple

from ropewalk.core.arrays import Floats, Ints
from ropewalk.core.jit import small

REACH = 1.1  # [1] pairs nearer than this, over the sum of their radii, are contacts
LAYER = 0.02  # [1] soft skin of a contact, over the same sum
STOP = 200.0  # [1] stiffness of one pressed through, over that of one pressed far
HARD = 0.3  # [1] damping ratio of contacts pressed beyond their skin
LEAN = 0.75  # [1] least square of the cosine between a segment and the plane of a contact, for its lever
DEEPEST = 0.9  # [1] least distance after a step over the same sum, but of what was nearer already
WRONG = 0.03  # [1] by which a frozen contact may err, over the same sum
# Columns of `Memory.grip`: normal, points of both segments, the friction spring's force [N] and the vector
# between the points [m] at the end of the last step, R_n then [N], the spring's stiffness [N/m], whether
# the row is to go, by how much more it counts as pressed than its points say [m], whether it was found
# on the way of the step in hand, the levers of both segments [1], see `apart`, and what of MORE is new in
# this step [m], the drag of what closes [N s/m], see `brake`, how deep statics has left it [m],
# MORE in the step that has led here [m], how fast it closed as the step began, where BRAKE goes with that
# within the step, else 0 [m/s], of what throws back, one over the mass that its points move as [1/kg], and
# the spring of one without friction [N/m], see `easing`; in a solve, what it held of what friction can an
# iteration ago [1], and whether there was one, see `laws.slip_course`.
(
    NORMAL,
    OWN,
    OTHER,
    SPRING,
    APART,
    PUSH,
    STIFF,
    GONE,
    MORE,
    FOUND,
    LEVER,
    EXTRA,
    BRAKE,
    LEFT,
    WAS,
    CLOSES,
    EASE,
    FOLLOW,
    AGO,
    COURSE,
) = (
    0,
    3,
    4,
    5,
    8,
    11,
    12,
    13,
    14,
    15,
    16,
    22,
    23,
    24,
    25,
    26,
    27,
    28,
    29,
    32,
)
NEW = -1.0  # in BRAKE: not known yet
NO_SOLVE, FIRST_LOOK, LATER = 0.0, 1.0, 2.0  # in COURSE
WIDTH = 33
# Places in `Memory.tally`.
CONTACTS, NEAR, ROUNDS, SEEN, REFUSED, FAULT, FIRST, SECOND, ASKED, SETTLES = range(10)
PASSED, FULL, CROWDED = 1, 2, 3  # faults
LIFTED = 3  # in `Memory.books`: what contacts have stored as their offsets grew [J]
# Columns of `Pairs.inside`: a segment near a node that slides, the slide, first and last segment of its line,
# so many segments of that on each side of the node that this one lies in, the node, and the line's node from
# which places count.
SEGMENT, SLIDE, FROM, TO, WITHIN, NODE, START = range(7)


class Pairs(NamedTuple):
    """Segments as contacts see them, one row each; (0,) without contact."""

    ratio: Floats  # (1,) damping ratio across; below 1 it throws back, see `laws.rebound` [1]
    friction: Floats  # (r, r) coefficients of friction of ropes on each other [1]
    skin: Floats  # (1,) how far lists of pairs look ahead [m]
    total: Floats  # (r,) mass of every rope with its loads [kg]
    lead: Ints  # (r,) the first rope of all that are bound to each other, but by contacts
    radius: Floats  # (s,) [m]
    lever: Floats  # (s,) largest lever: radius over length at rest, for the most lean [1]
    soft: Floats  # (s,) compliance of a contact that is pressed little [m/N]
    hard: Floats  # (s,) the same of one that is pressed far [m/N]
    stop: Floats  # (s,) the same of one that is pressed through
    mass: Floats  # (s,) of a node [kg]
    load: Floats  # (n,) what nodes carry beside their rope [kg]
    behind: Floats  # (n,) what rigid links push along with a node, or a joint does [kg]
    joined: Floats  # (n,) what joints tie to a node [kg]
    rope: Ints  # (s,) number of the rope, -1 between ropes
    skip: Ints  # (s,) so many segments beside it are its neighbours
    joint: Ints  # (s, 2) the joints near it, -1: none
    slides: Ints  # (s, c) the slides near it, as rows of `inside`, -1: none
    inside: Ints  # (p, 7) see SEGMENT


class Memory(NamedTuple):
    """What contacts remember of the last accepted step; the first rows count, sorted by segments."""

    pair: Ints  # (m, 2) segments
    grip: Floats  # (m, WIDTH), see NORMAL
    near: Ints  # (c, 2) pairs that may touch soon
    tally: Ints  # (10,), see CONTACTS
    place: Floats  # (3, n) [m]
    origin: Floats  # (3, n) where the nodes were when `near` was found [m]
    box: Floats  # (s, 6) working space of the search
    order: Ints  # (s,) segments as the leaves of `tree` have them
    tree: Floats  # (t, 6) boxes of many segments, see `boxes`
    rope: Ints  # (s,) as in `Pairs`, -1 as well where one has parted
    way: Floats  # (3, n) in the last step [m]
    books: (
        Floats  # (4,) works so far: what pressed, what rubbed, the method's share, and LIFTED [J]
    )
    inside: Ints  # (p, 2) first and last segment of the line that each row of `Pairs.inside` does not touch
    swept: Floats  # (k, 8) where segments have been, see `swept` ...
    hull: Floats  # (6, n) ... but for the least and greatest places of nodes since then [m]


@small
def friction_of(table, i, j):
    """Return the coefficient of friction of two segments [1]."""
    return table.friction[table.rope[i], table.rope[j]]


@small
def throws_back(table):
    """Tell whether contacts throw back what hits."""
    return table.ratio[0] < 1.0


@small
def rubs_by(table, grip, row, i, j):
    """Return the largest part of what presses that what holds across the normal can be [1]."""
    return 1.0 if grip[row, FOLLOW] > 0.0 else friction_of(table, i, j)


@small
def mass_at(table, i, s):
    """Return the mass that a contact meets at a point of a segment, its loads with it [kg].

    It is no more than what the point moves as, 1 / sum(c^2 / m), c its shares in the nodes of masses m.
    """
    near, far = table.mass[i] + table.load[i], table.mass[i] + table.load[i + 1]
    moves = 1.0 / ((1.0 - s) ** 2 / near + s**2 / far)
    return min((1.0 - s) * near + s * far, moves)


@small
def reduced(table, grip, row, i, j):
    """Return the mass that a contact's damper is for [kg].

    Of a load that meets what is lighter only half of that, as of two alike: steps allow for no more. What
    throws back has just what its points move as.
    """
    if throws_back(table) and grip[row, EASE] > 0.0:
        return 1.0 / grip[row, EASE]
    mass = table.mass[i] * table.mass[j] / (table.mass[i] + table.mass[j])
    if table.load[i] + table.load[i + 1] + table.load[j] + table.load[j + 1] > 0.0:
        mass = 0.5 * min(mass_at(table, i, grip[row, OWN]), mass_at(table, j, grip[row, OTHER]))
    return mass


@small
def spring_of(table, grip, row, i, j):
    """Return stiffness pressed little, far and through [N/m], damping [N s/m], and the sum of radii [m].

    The damping is that along the surfaces; across it is `ratio` times that.
    """
    soft, hard = (
        1.0 / (table.soft[i] + table.soft[j]),
        1.0 / (table.hard[i] + table.hard[j]),
    )
    stop = 1.0 / (table.stop[i] + table.stop[j])
    mass = reduced(table, grip, row, i, j)
    damping = 2.0 * max((soft * mass) ** 0.5, HARD * (grip[row, STIFF] * mass) ** 0.5)
    return soft, hard, stop, damping, table.radius[i] + table.radius[j]


@small
def depth_of(grip, row, u, size):
    """Return how deep a contact counts as pressed [m]; negative where it is open."""
    n0, n1, n2 = grip[row, NORMAL], grip[row, NORMAL + 1], grip[row, NORMAL + 2]
    return size + grip[row, MORE] - (n0 * u[0] + n1 * u[1] + n2 * u[2])


@small
def between(x, i, j, s, t):
    """Return the vector from a point of segment j to one of segment i."""
    a, b = 1.0 - s, 1.0 - t
    return (
        a * x[0, i] + s * x[0, i + 1] - (b * x[0, j] + t * x[0, j + 1]),
        a * x[1, i] + s * x[1, i + 1] - (b * x[1, j] + t * x[1, j + 1]),
        a * x[2, i] + s * x[2, i + 1] - (b * x[2, j] + t * x[2, j + 1]),
    )


@small
def apart(x, grip, row, i, j):
    """Return the vector between the points of segments i and j as friction sees it: between their surfaces.

    A segment that turns takes its surface along: u + a (n . e_i) + b (n . e_j), e the vectors along the
    segments and a, b the levers. Strands that lie along each other and turn together do not rub then. The
    force that belongs to it has a couple on each segment, which keeps the angular momentum.
    """
    u = between(x, i, j, grip[row, OWN], grip[row, OTHER])
    rise, other = 0.0, 0.0
    for k in range(3):
        rise += grip[row, NORMAL + k] * (x[k, i + 1] - x[k, i])
        other += grip[row, NORMAL + k] * (x[k, j + 1] - x[k, j])
    return (
        u[0] + grip[row, LEVER] * rise + grip[row, LEVER + 3] * other,
        u[1] + grip[row, LEVER + 1] * rise + grip[row, LEVER + 4] * other,
        u[2] + grip[row, LEVER + 2] * rise + grip[row, LEVER + 5] * other,
    )


@small
def lever_of(grip, row, a):
    """Return the lever of node a of the four, with its sign in `apart`."""
    at, sign = LEVER if a < 2 else LEVER + 3, -1.0 if a % 2 == 0 else 1.0
    return sign * grip[row, at], sign * grip[row, at + 1], sign * grip[row, at + 2]


@small
def share_of(grip, row, a):
    """Return what node a of the four has in u [1]."""
    s, t = grip[row, OWN], grip[row, OTHER]
    if a == 0:
        return 1.0 - s
    if a == 1:
        return s
    if a == 2:
        return t - 1.0
    return -t
