"""Where numbers of ropes that are solved side by side lie: field by field, in one array.

A segment's numbers lie where those of its first node do. All distances are constants: a field's numbers are
addressed by the node alone.
"""

from __future__ import annotations

from ropewalk.core.jit import small
from ropewalk.core.lanes import WIDTH, load, store

MOST_STAGES = 4
# What a solve changes: places, velocities, tension, acceleration; and what is known of a stage.
X, V, T, A, X_KNOWN, V_KNOWN = 0, 3, 6, 7, 10, 13
# Equations and solution, as in `core.saddle`, and 1 / r of a segment.
FORCE, DIRECTION, MOVED, PULLED, OVER = 16, 19, 22, 25, 26
MISFIT, ON, COMPLIANCE, ACROSS, BEND, FACTOR = 27, 28, 29, 30, 31, 32
# What stays the same: of nodes, and of segments; WEIGHT and SLACK, its inverse, in a stage.
MASS, INVERSE, FREE, LENGTH, SOFT, ALIVE, DAMPING, LIGHT, WEIGHT, SLACK = range(41, 51)
# The state at the step's beginning, and velocities and accelerations of its stages, six numbers each.
X_BEGIN, V_BEGIN, STAGES = 51, 54, 57
FIELDS = STAGES + 6 * MOST_STAGES
MOST_NODES = 255
# From one field to the next: fields a power of two apart would share a few lines of the cache.
SPAN = (MOST_NODES + 4) * WIDTH


@small
def get(work, i, field):
    """Return a field of node `i`."""
    return load(work, i * WIDTH + field * SPAN)


@small
def put(work, i, field, value):
    """Write a field of node `i`."""
    store(work, i * WIDTH + field * SPAN, value)


@small
def get3(work, i, field):
    """Return three numbers of node `i`."""
    at = i * WIDTH + field * SPAN
    return load(work, at), load(work, at + SPAN), load(work, at + 2 * SPAN)


@small
def put3(work, i, field, value):
    """Write three numbers of node `i`."""
    at = i * WIDTH + field * SPAN
    store(work, at, value[0])
    store(work, at + SPAN, value[1])
    store(work, at + 2 * SPAN, value[2])
