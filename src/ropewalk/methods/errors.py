"""The energy error at every step, where a ledger is kept: energy that no law accounts for.

As `Result.energy_error`: the energies less the works of all laws without a potential, less both at the start.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from ropewalk.core.jit import apart, kernel, part
from ropewalk.core.peaks import GREATEST, LEAST
from ropewalk.core.ranges import rows
from ropewalk.laws.clamps import bent_energy
from ropewalk.laws.node_law import NodeLaw
from ropewalk.laws.nodes import fold
from ropewalk.laws.rare import has_bending
from ropewalk.laws.rotors import turning_error
from ropewalk.methods.carried import record_elastic
from ropewalk.methods.peaks import keep_step
from ropewalk.methods.scratch import LANES, SEEN, add_up, clear_lanes, total_of
from ropewalk.methods.wheel_ties import has_wheels


@part
def set_zero(system, state, look, ledger):
    """Note the energy from which errors count; without a ledger there are none."""
    state.peaks.error_zero[0] = np.nan
    if ledger:
        elastic = stretched(system, state, look)
        state.peaks.error_zero[0] = accounted_for(system, state, elastic, look.sums)


@part
def keep_step_error(system, state, look, t):
    """Look at the energy error of the state of time `t` [s]."""
    if state.peaks.error_zero[0] == state.peaks.error_zero[0]:
        elastic = stretched(system, state, look)
        keep_error(state.peaks, error_now(system, state, elastic, look.sums), t)


@part
def look_at_step(system, state, rubs, count, look, t):
    """Look at the end of a step, the `count`-th, at time `t` [s], where `watch` does not."""
    keep_step(system, state, rubs, count, t, look.sums)
    keep_step_error(system, state, look, t)


@part
def stretched(system, state, look):
    """Return the elastic energy of all segments [J]."""
    look.known[SEEN] = 0.0
    return record_elastic(system, state, look.sums, look.segments[0])


@kernel
def error_now(system, state, elastic, sums):
    """Return the energy error [J], NaN without a ledger; `elastic` is the segments' energy [J]."""
    zero = state.peaks.error_zero[0]
    return accounted_for(system, state, elastic, sums) - zero if zero == zero else np.nan


@kernel
def keep_error(peaks, error, t):
    """Hold an energy error [J], at time `t` [s], against the least and greatest; NaN is none."""
    kept = peaks.error
    if error < kept[LEAST, 0]:
        kept[LEAST, 0], kept[LEAST, 1] = error, t
    if error > kept[GREATEST, 0]:
        kept[GREATEST, 0], kept[GREATEST, 1] = error, t


@kernel
def accounted_for(system, state, elastic, sums):
    """Return all energy less the works of the laws without a potential [J]; `elastic` is the segments'."""
    work, mass, segments = state.work, state.mass, state.rest_length.shape[0]
    works = None if system.rare is None else work.node
    clear_lanes(sums, 1)
    for lo in range(0, mass.shape[0], LANES):
        hi = min(lo + LANES, mass.shape[0])
        _add_nodes(state.x, state.v, mass, system.gravity, works, work.applied, lo, hi, sums)
    for lo in range(0, segments, LANES):
        _take_friction(work.friction, lo, min(lo + LANES, segments), sums)
    total = elastic + total_of(sums, 0)
    total -= work.limiter[0] + work.limiter[1] + work.winch[0] + work.winch[1]
    if has_bending(system):
        total += bent_energy(system, state, state.x)
        total -= add_up(work.clamps, sums)
    for row in range(work.anchors.shape[0]):
        total -= work.anchors[row]
    if has_wheels(system):
        total += turning_error(system.node.obstacle, state.memory.obstacle.wheel)
    return total


@part
def _no_parts(works, lo, hi):
    return ()


def _cutting(law: NodeLaw, k: int, rest: Any) -> Any:
    @part
    def _cut(works, lo, hi):
        return (works[k][lo:hi], *rest(works, lo, hi))

    return _cut


@part
def _no_more(works, i, total):
    return total


def _summing(law: NodeLaw, k: int, rest: Any) -> Any:
    @part
    def _add(works, i, total):
        return rest(works, i, total + works[k][i])

    return _add


_parts, _sum = (
    fold(_cutting, _no_parts, "lower"),
    fold(_summing, _no_more, "lower"),
)  # works of laws of nodes


@apart
def _add_nodes(x, v, mass, gravity, works, applied, lo, hi, sums):
    x0, x1, x2 = rows(x, lo, hi)
    v0, v1, v2 = rows(v, lo, hi)
    mass, applied = mass[lo:hi], applied[lo:hi]
    own = None if works is None else _parts(works, lo, hi)
    gx, gy, gz = gravity[0], gravity[1], gravity[2]
    for i in range(mass.shape[0]):
        moving = 0.5 * (v0[i] * v0[i] + v1[i] * v1[i] + v2[i] * v2[i])
        done = (0.0 if own is None else _sum(own, i, 0.0)) + applied[i]
        sums[i] += mass[i] * (moving - (gx * x0[i] + gy * x1[i] + gz * x2[i])) - done


@apart
def _take_friction(friction, lo, hi, sums):
    friction = friction[lo:hi]
    for j in range(friction.shape[0]):
        sums[j] -= friction[j]
