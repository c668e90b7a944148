"""Rows and columns of what is kept of obstacles that turn freely, see `wheels`, and how they lie."""

from __future__ import annotations

from ropewalk.core.jit import kernel, small
from ropewalk.laws.contact_frame import surface_at

# Columns of `Memory.wheel`: angle [rad] and rate [rad/s] at the end of the last accepted step, the work that
# ropes and bearing have done on the wheel so far [J], the ropes' torque then and that of all [N m], by how
# much rate and angle changed in it; then those in hand: rate, torques of ropes and bearing, s (0: it does not
# give), number of nodes that it rubs on; and of the stage w^, d^ and c (0: implicit Euler), its weight, the
# others' mean torques of ropes and bearing; of the body's own weight the torque in hand, that at the end of
# the last step, nothing (older runs have a number there) and the work so far; from STAGES on the torques of
# all stages, after a step its mean ones, and from RATES on their rates.
ANGLE, RATE, ROPES, BEARING, TORQUE, PULL, GAIN, WAY, TRIAL, DRIVE, DRAG, TIE, COUNT = range(13)
KNOWN, LEAD, PART, SHARE, MEAN_DRIVE, MEAN_DRAG = range(13, 19)
WEIGH, WEIGHED, _, FALL, STAGES = range(19, 24)
MOST_STAGES = 8
RATES = STAGES + MOST_STAGES
WIDTH = RATES + MOST_STAGES
# Rows of `Memory.ties`, working space: nodes on the wheel, the normals and the most that friction carries
# there [N], u, z, and of the solver the solution for u, its tensions and what it keeps of the equations.
NODE, NORMAL, BOUND, COLUMN, ROW, MOVED, PULLED, KEPT, ROWS = 0, 1, 4, 5, 8, 11, 14, 15, 16
#: What is recorded of a wheel, and in which units.
RECORDED = (
    *("angle", "speed", "kinetic energy"),
    *("work of ropes", "work of bearing", "torque of ropes", "work of weight"),
)
UNITS = ("rad", "rad/s", "J", "J", "J", "N m", "J")


@small
def span_of(wheel, now):
    """Return c of the stage in hand, or how long ago the last accepted step was [s]."""
    return wheel[PART] if wheel[PART] > 0.0 else now[0] - now[1]


@kernel
def surface_then(obstacles, wheels, o, now):
    """Return what `surface_at` does for when the last accepted step ended, of a wheel as it turned then."""
    dx, dy, dz, vx, vy, vz, angle, rate = surface_at(obstacles, o, now[1])
    w = obstacles.wheel[o]
    if w >= 0:
        angle, rate = wheels[w, ANGLE], wheels[w, RATE]
    return dx, dy, dz, vx, vy, vz, angle, rate


@kernel
def surface_now(obstacles, wheels, o, now):
    """Return what `surface_at` does for the time in hand, of a wheel as it was found to turn."""
    dx, dy, dz, vx, vy, vz, angle, rate = surface_at(obstacles, o, now[0])
    w = obstacles.wheel[o]
    if w >= 0:
        rate = wheels[w, TRIAL]
        angle = wheels[w, ANGLE] + wheels[w, LEAD] + rate * span_of(wheels[w], now)
    return dx, dy, dz, vx, vy, vz, angle, rate
