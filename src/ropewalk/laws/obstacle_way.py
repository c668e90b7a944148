"""The way of a step past obstacles: no node goes through a solid, or ends on another side of it.

No step may end deeper in a solid than three quarters of its least half thickness (half the diameter counted
in), but where it was deeper: so what is pressed hard does not creep through by and by. How thick a mesh is
at a place is not known; there only the normals tell.

A way may cut the corner of a surface that a node slides round. It goes through where the normals at which it
comes in and goes out, or ends, are more than a right angle apart. What does not press yet and moves by less
than a body's thinnest cannot, and is not looked at: a node's way inside is longer than that then.

Nor may what pressed nothing and is outside of a body at the end have been in it by more than MISSED of the
rope's diameter: no force of the step has seen that it hit. And what hits must not go far round the surface in
that step: the force across it is that at the step's end.

Only nodes are pushed. So what is thinner than a segment is long could slip through between two of them: no
segment may come to lie across a body either, at the end of a step or on the way. It lies across where the
normals at which its line comes in and goes out are more than 135 degrees apart; a corner is cut by less.
Source: conservative advancement (Mirtich 1996), for one point and signed distances.
"""

from __future__ import annotations

import math

from ropewalk.core.jit import deferred, kernel, part, small
from ropewalk.laws.contact_frame import PUSH, STILL
from ropewalk.laws.obstacle_pose import body_of, drawn_place, pose_of
from ropewalk.laws.obstacle_shapes import MESH, PLANE, probe
from ropewalk.laws.wheel_rows import surface_now, surface_then

FINE, HALVE = 0, 2  # see `laws.couplings`
TRIES = 500
DEEPEST = 0.75  # [1] depth over the thinnest
STANDS = 1e-9  # [m] an anchor that goes less in a step stands; less deep it is on a surface
LEAST = 0.01  # [1] of the thinnest: the least part of a way that is gone at once
FACING = -0.7  # [1] cosine between the normals at both ends of what lies across a body
LONG = 2.0 * (1.0 - DEEPEST)  # [1] length over half the thickness of what may lie across
PAST = 2.0  # no cosine
MISSED = 0.1  # [1] diameters by which a way may dip into a body that no force of the step has seen
SWERVE = 0.99  # [1] least cosine between the normals where a way would hit and where the step ends
SHORT = 0.1  # [1] diameters: so short a way does not count as far round an edge
LOOKS = 12  # for where it dips deepest
APART = 0.3  # [1] of the half thickness: how far a segment moves from one look to the next


@kernel
def poses_at(obstacles, wheels, o, now):
    """Return how far obstacle o had moved and has, (3) [m], each with what `pose_of` gives."""
    x, y, z, _, _, _, angle, _ = surface_then(obstacles, wheels, o, now)
    then = (x, y, z), pose_of(obstacles, o, angle)
    x, y, z, _, _, _, angle, _ = surface_now(obstacles, wheels, o, now)
    return then, ((x, y, z), pose_of(obstacles, o, angle))


@small
def seen_from(body, at, x, y, z):
    """Return where a place is in the frame of a body that lies `at` what `poses_at` gives [m]."""
    moved, turn = at
    return drawn_place(body, turn, x - moved[0], y - moved[1], z - moved[2])


@small
def place_in(body, at, x, i):
    """Return where node i is in the frame of a body that lies `at` what `poses_at` gives [m]."""
    return seen_from(body, at, x[0, i], x[1, i], x[2, i])


@small
def between(p, q, share):
    """Return the place on the way from p to q [m]."""
    rest = 1.0 - share
    return rest * p[0] + share * q[0], rest * p[1] + share * q[1], rest * p[2] + share * q[2]


@kernel
def surface_near(obstacles, o, x, y, z):
    """Return distance [m] and normal of the surface of obstacle o near a place in the body's frame."""
    center, axis, size = obstacles.center[o], obstacles.axis[o], obstacles.size[o]
    gap, nx, ny, nz, _, _, _, _, _ = probe(obstacles.kind[o], center, axis, size, x, y, z)
    return gap, nx, ny, nz


@small
def gap_at(obstacles, o, p):
    """Return how far a place in the body's frame is from the surface of obstacle o [m]."""
    return surface_near(obstacles, o, p[0], p[1], p[2])[0]


@kernel
def inward(obstacles, o, thickness, p, q):
    """Return whether a point from p to q comes to the surface of obstacle o, and the normal where it does."""
    thin = obstacles.thin[o] + thickness
    dx, dy, dz = q[0] - p[0], q[1] - p[1], q[2] - p[2]
    way, share = math.sqrt(dx * dx + dy * dy + dz * dz), 0.0
    nx, ny, nz = 0.0, 0.0, 0.0
    for _ in range(TRIES):
        x, y, z = p[0] + share * dx, p[1] + share * dy, p[2] + share * dz
        gap, nx, ny, nz = surface_near(obstacles, o, x, y, z)
        gap -= thickness
        if gap <= 0.0:
            return True, nx, ny, nz
        if share >= 1.0:
            return False, nx, ny, nz
        share = min(share + max(gap, LEAST * thin, way / TRIES) / way, 1.0)
    return True, nx, ny, nz  # in doubt it does


@kernel
def in_and_out(obstacles, o, thickness, p, q):
    """Return the cosine between the normals at which a way from p to q comes in and goes out, or ends.

    PAST where it comes to no surface. All in the frame of obstacle o.
    """
    enters, ax, ay, az = inward(obstacles, o, thickness, p, q)
    if not enters:
        return PAST
    _, bx, by, bz = inward(obstacles, o, thickness, q, p)
    return ax * bx + ay * by + az * bz


@kernel
def goes_through(obstacles, o, i, p, q):
    """Tell whether node i goes through obstacle o from p to q, in the body's frame."""
    thickness = obstacles.thickness[i]
    turned = in_and_out(obstacles, o, thickness, p, q)
    if turned == PAST or turned < 0.0:
        return turned < 0.0
    after = gap_at(obstacles, o, q) - thickness
    if obstacles.kind[o] == MESH or after > -DEEPEST * (obstacles.thin[o] + thickness):
        return False
    return after < gap_at(obstacles, o, p) - thickness


@kernel
def lies_across(obstacles, o, i, p, q):
    """Tell whether segment i, from p to q in the body's frame, lies across obstacle o."""
    thickness = obstacles.thickness[i]
    length = math.sqrt((q[0] - p[0]) ** 2 + (q[1] - p[1]) ** 2 + (q[2] - p[2]) ** 2)
    if not length > LONG * (obstacles.thin[o] + thickness):
        return False
    middle = (0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1]), 0.5 * (p[2] + q[2]))
    if gap_at(obstacles, o, middle) - thickness > 0.5 * length:
        return False
    return in_and_out(obstacles, o, thickness, p, q) < FACING


@kernel
def leads_out(obstacles, o, inverse_mass, a, p):
    """Tell whether a segment comes out of obstacle o, in which an anchor holds its end: from a to p nowhere.

    One that moves in the body may leave it on the other side, and one on its surface stands in none: rounding
    alone would tell whether its rope may go through.
    """
    way = abs(p[0] - a[0]) + abs(p[1] - a[1]) + abs(p[2] - a[2])
    return inverse_mass == 0.0 and way < STANDS and gap_at(obstacles, o, p) < -STANDS


@kernel
def sweeps_across(obstacles, o, i, a, b, p, q):
    """Tell whether segment i comes to lie across obstacle o, its ends going from a to p and from b to q."""
    way = 0.0
    for one, other in ((a, p), (b, q)):
        far = (other[0] - one[0]) ** 2 + (other[1] - one[1]) ** 2 + (other[2] - one[2]) ** 2
        way = max(way, math.sqrt(far))
    thin = obstacles.thin[o] + obstacles.thickness[i]
    looks = 1 + int(min(way / (APART * thin), TRIES))
    for look in range(1, looks + 1):
        s = look / looks
        one, other = between(a, p, s), between(b, q, s)
        if lies_across(obstacles, o, i, one, other):
            return not lies_across(obstacles, o, i, a, b)
    return False


@kernel
def _may_reach(obstacles, o, i, a, b, p, q):
    """Tell whether segment i, its ends going from a to p and from b to q, is long and may meet obstacle o."""
    square, far = 0.0, 0.0
    for k in range(3):
        square += (q[k] - p[k]) ** 2
        far += (0.5 * (p[k] + q[k] - a[k] - b[k])) ** 2
    length, thickness = math.sqrt(square), obstacles.thickness[i]
    if not length > LONG * (obstacles.thin[o] + thickness):
        return False
    middle = (0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1]), 0.5 * (p[2] + q[2]))
    return gap_at(obstacles, o, middle) - thickness <= 0.5 * length + math.sqrt(far)


@deferred("int64")
def find_sweep(x, y, inverse_mass, stiffness, obstacles, wheels, through, now):
    """Note for a segment's first node which obstacle it comes to lie across from x to y, from -1 down.

    What is noted already stays. Return how many do; see `find_pass`.
    """
    count = 0
    for o in range(obstacles.kind.shape[0]):
        if obstacles.thin[o] == math.inf:
            continue
        body = body_of(obstacles, o)
        then, here = poses_at(obstacles, wheels, o, now)
        for i in range(x.shape[1] - 1):
            held = inverse_mass[i] == 0.0 and inverse_mass[i + 1] == 0.0
            if held or stiffness[i] == 0.0 or through[i] != 0:
                continue
            a, b = place_in(body, then, x, i), place_in(body, then, x, i + 1)
            p, q = place_in(body, here, y, i), place_in(body, here, y, i + 1)
            if leads_out(obstacles, o, inverse_mass[i], a, p) or leads_out(
                obstacles, o, inverse_mass[i + 1], b, q
            ):
                continue
            if _may_reach(obstacles, o, i, a, b, p, q) and sweeps_across(
                obstacles, o, i, a, b, p, q
            ):
                through[i] = -o - 1
                count += 1
    return count


@deferred("int64")
def find_pass(x, y, inverse_mass, obstacles, grip, wheels, through, now):
    """Note for every node that is not held which obstacle it goes through from x to y, from 1 on.

    What is noted already stays. `now` holds the times of y and of x [s], `grip` what presses at x. Return how
    many do.
    """
    count = 0
    for o in range(obstacles.kind.shape[0]):
        if obstacles.thin[o] == math.inf:
            continue
        body = body_of(obstacles, o)
        then, here = poses_at(obstacles, wheels, o, now)
        for i in range(x.shape[1]):
            p, q = place_in(body, then, x, i), place_in(body, here, y, i)
            square = (q[0] - p[0]) ** 2 + (q[1] - p[1]) ** 2 + (q[2] - p[2]) ** 2
            thin = obstacles.thin[o] + obstacles.thickness[i]
            if square < thin * thin and grip[o, PUSH, i] == 0.0:
                continue
            if not inverse_mass[i] > 0.0 or through[i] != 0:
                continue
            if goes_through(obstacles, o, i, p, q):
                through[i] = o + 1
                count += 1
    return count


@kernel
def dips(obstacles, o, i, p, q):
    """Tell whether node i hits obstacle o from p to q, outside of it, in the body's frame.

    Along a straight way the distance from a convex body has one minimum: it is between the points beside the
    lowest of three, where its thirds are looked at. Of a torus or a mesh one of several may be missed.
    """
    way = math.sqrt((q[0] - p[0]) ** 2 + (q[1] - p[1]) ** 2 + (q[2] - p[2]) ** 2)
    thickness, least = obstacles.thickness[i], -MISSED * obstacles.diameter[i]
    if way < -2.0 * least:  # too short to go so deep and out again
        return False
    before = gap_at(obstacles, o, p) - thickness
    if before <= 0.0 or before - way > least:
        return False
    after = gap_at(obstacles, o, q) - thickness
    if after <= 0.0 or 0.5 * (before + after - way) > least:
        return False
    low, high = 0.0, 1.0
    for _ in range(LOOKS):
        a, b = (2.0 * low + high) / 3.0, (low + 2.0 * high) / 3.0
        first = gap_at(obstacles, o, between(p, q, a)) - thickness
        other = gap_at(obstacles, o, between(p, q, b)) - thickness
        if min(first, other) < least:
            return True
        if first < other:
            high = b
        else:
            low = a
    return False


@deferred("int64")
def find_missed(x, y, inverse_mass, obstacles, grip, wheels, through, now):
    """Note which obstacle a node has hit from x to y, see `find_pass`, and no force has seen it."""
    count = 0
    for o in range(obstacles.kind.shape[0]):
        if obstacles.thin[o] == math.inf:
            continue
        body = body_of(obstacles, o)
        then, here = poses_at(obstacles, wheels, o, now)
        for i in range(x.shape[1]):
            if not inverse_mass[i] > 0.0 or through[i] != 0 or grip[o, PUSH, i] > 0.0:
                continue
            if dips(obstacles, o, i, place_in(body, then, x, i), place_in(body, here, y, i)):
                through[i] = o + 1
                count += 1
    return count


@small
def swerves(obstacles, o, i, p, f, q):
    """Tell whether node i, from p on the way to f, hits obstacle o and ends at q, far round it."""
    dx, dy, dz = f[0] - p[0], f[1] - p[1], f[2] - p[2]
    thickness, way = obstacles.thickness[i], math.sqrt(dx * dx + dy * dy + dz * dz)
    before = gap_at(obstacles, o, p) - thickness
    if before <= 0.0 or before > way or way < SHORT * obstacles.diameter[i]:
        return False
    enters, ax, ay, az = inward(obstacles, o, thickness, p, f)
    if not enters or ax * dx + ay * dy + az * dz > -STILL * obstacles.diameter[i]:
        return False
    _, bx, by, bz = surface_near(obstacles, o, q[0], q[1], q[2])
    return ax * bx + ay * by + az * bz < SWERVE


@deferred("int64")
def find_swerves(x, v, y, inverse_mass, obstacles, wheels, through, now):
    """Note which obstacle a node has hit from x to y, with v at x, and gone far round, see `find_pass`."""
    count, dt = 0, now[0] - now[1]
    for o in range(obstacles.kind.shape[0]):
        if obstacles.kind[o] == PLANE:
            continue
        body = body_of(obstacles, o)
        then, here = poses_at(obstacles, wheels, o, now)
        for i in range(x.shape[1]):
            if not inverse_mass[i] > 0.0 or through[i] != 0:
                continue
            fx, fy, fz = x[0, i] + dt * v[0, i], x[1, i] + dt * v[1, i], x[2, i] + dt * v[2, i]
            ahead = seen_from(body, here, fx, fy, fz)
            p, q = place_in(body, then, x, i), place_in(body, here, y, i)
            if swerves(obstacles, o, i, p, ahead, q):
                through[i] = o + 1
                count += 1
    return count


@part
def meet(obstacles, state, x):
    """Tell whether the way from the state to `x` may stand, see `obstacle_way`."""
    memory = state.memory.obstacle
    grip, wheels, through = memory.grip, memory.wheel, memory.through
    for i in range(through.shape[0]):
        through[i] = 0
    inert, now = state.inverse_mass, state.now
    many = find_pass(state.x, x, inert, obstacles, grip, wheels, through, now)
    many += find_sweep(state.x, x, inert, state.stiffness, obstacles, wheels, through, now)
    many += find_swerves(state.x, state.v, x, inert, obstacles, wheels, through, now)
    many += find_missed(state.x, x, inert, obstacles, grip, wheels, through, now)
    return HALVE if many > 0 else FINE


@part
def gone(obstacles, state):
    """Return how many nodes or segments have gone through an obstacle."""
    count = 0
    for which in state.memory.obstacle.fault:
        count += 1 if which != 0 else 0
    return count
