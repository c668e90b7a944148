"""What one frame of a run holds, written inside the compiled loop."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats, State
from ropewalk.core.jit import apart, kernel, part, seldom
from ropewalk.core.ranges import rows
from ropewalk.laws.clamps import bent_energy
from ropewalk.laws.ledger import wound_energy
from ropewalk.laws.node_law import NodeLaw
from ropewalk.laws.nodes import fold, touch_nodes
from ropewalk.laws.parting import NAME as PARTING
from ropewalk.laws.rare import acts, has_bending, winds
from ropewalk.laws.registry import NODE_LAWS, SEGMENT_LAWS
from ropewalk.methods.carried import read_segments
from ropewalk.methods.peaks import record_peaks
from ropewalk.methods.scratch import (
    ENERGY,
    LANES,
    SEEN,
    SUMS,
    add_up,
    clear,
    clear_lanes,
    put,
    put_row,
    total_of,
)
from ropewalk.methods.surface_books import record_surfaces, record_turning, surface_shapes

ENERGIES = ("kinetic", "gravity", "elastic")
_EVER = tuple(law.name for law in NODE_LAWS if law.memory is None)
LAWS = ("elastic", "friction", "weight", *_EVER, "applied", "limiter", "winch")
# What a system with bending stiffness has besides.
BENT_ENERGIES = ("bending",)
BENT_LAWS = ("bending", "clamps")
_APART = {PARTING, *(law.name for law in SEGMENT_LAWS)}  # with a memory, but they touch nothing
CONSERVATIVE = ("elastic", "weight", "bending")  # laws with a potential


class Recording(NamedTuple):
    """Buffers for `f` frames; a frame is written after its last step."""

    x: Floats  # (f, 3, n) [m]
    v: Floats  # (f, 3, n) [m/s]
    tension: Floats  # (f, s) what the segment carries along itself, see `carried_tension` [N]
    elastic_tension: Floats  # (f, s) its spring's share [N]
    tension_low: (
        Floats  # (f, s) least tension of all steps since the frame before, both frames included
    )
    tension_high: Floats  # (f, s) greatest; these six (f, 0) where extremes are not wanted
    stretch_high: Floats  # (f, s) greatest stretch [1], 0 where there is no rope
    speed_high: Floats  # (f, n) greatest speed [m/s]
    lowest: Floats  # (f, n) least height along up [m]
    highest: Floats  # (f, n) greatest
    rest_length: Floats  # (f, s) [m]; (f, 0) where none changes
    energy: Floats  # (f, 3 or 4) kinetic, gravity, elastic and, where there is any, bending [J]
    work: Floats  # (f, 8 or more + a) work by law, see `work_names`, then by anchor [J]
    jump: Floats  # (f, 2) kinetic energy put in by limiter and winch, with friction at the drum [J]
    reaction: Floats  # (f, a, 3) [N]
    momentum: Floats  # (f, 3) [kg m/s]
    angular_momentum: Floats  # (f, 3) about the origin [kg m^2/s]
    moment: Floats  # (f, a, 3) of the clamps on the rope [N m]; (f, 0, 3) without a clamp
    extremes: (
        Floats  # (f, 8) since the frame before, over all ropes: see `core.peaks`; as wide as wanted
    )
    extreme_places: Floats  # (f, 8) their segments, nodes and anchors; -1: there is none
    extreme_since: Floats  # (f, 8) not before this time [s] ...
    extreme_until: Floats  # (f, 8) ... nor after this one
    reaction_high: Floats  # (f, a) greatest force of each anchor since the frame before [N]
    moment_high: Floats  # (f, a) greatest moment of each clamp [N m]; (f, 0) without a clamp
    contact: Floats  # (f, 3, n) force of what the nodes touch [N]; (f, 3, 0) where there is no such thing
    error_range: Floats  # (f, 2) least and greatest energy error since the frame before [J] ...
    error_times: Floats  # (f, 2) ... and when [s]; NaN without a ledger
    joint_force: Floats  # (f, p, 3) force of a joint on each of its nodes [N]
    books: Floats  # (f, k, 5) works of every obstacle, then of ropes on ropes, see `laws.contact_books` [J]
    wheel: Floats  # (f, w, 7) of obstacles that turn freely, see `wheel_rows.RECORDED`
    # (f, b) greatest force on every surface at the ends of steps since the frame before [N], when [s], and
    # the least in the three steps before that [N]; of ropes on ropes NaN; b as `books` has them, 0 where
    # extremes are not wanted
    pressed_high: Floats
    pressed_time: Floats
    pressed_before: Floats

    def part(self, start: int, stop: int) -> Recording:
        """Return the frames from `start` to `stop`, views."""
        if start == 0 and stop >= len(self.x):
            return self  # at the same addresses
        return Recording(*(array[start:stop] for array in self))


LARGE = Recording._fields[:10]  # by node or segment in every frame


def make_recording(
    state: State,
    frames: int,
    with_lengths: bool,
    empty: Callable[[tuple[int, ...]], Floats] = np.empty,
) -> Recording:
    """Return buffers for `frames` frames of a rope system like `state`.

    `empty` gives the LARGE ones; they need not be cleared: memory that was used before then needs no
    touch but the recording's.
    """
    n, s, a = state.x.shape[1], state.rest_length.shape[0], state.held.shape[0]
    more = remembering(state)
    energies, laws = len(energy_names(bends(state))), len(work_names(bends(state), more))
    peaks, clamps = state.peaks, state.moment.shape[0]
    wide = peaks.found.shape[1] if peaks.speed.size else 0
    shapes: list[tuple[int, ...]] = [(3, n), (3, n), (s,), (s,)]
    shapes += [peaks.stretch.shape] * 3 + [peaks.speed.shape] * 3
    shapes += [(s if with_lengths else 0,), (energies,), (laws + a,), (2,), (a, 3), (3,), (3,)]
    shapes += [(clamps, 3), *[(wide,)] * 4, peaks.reaction.shape, peaks.moment.shape]
    shapes += [
        (3, n if set(more) - _APART else 0),
        *[(peaks.error.shape[0],)] * 2,
        state.joint_force.shape,
        *surface_shapes(state),
        *[(peaks.pressed.shape[0],)] * 3,
    ]
    large = [empty((frames, *shape)) for shape in shapes[: len(LARGE)]]
    return Recording(*large, *(np.zeros((frames, *shape)) for shape in shapes[len(LARGE) :]))


def bends(state: State) -> bool:
    """Tell whether a state has bending stiffness."""
    return state.bending_stiffness.size > 0


def energy_names(bending: bool) -> tuple[str, ...]:
    """Return the columns of `energy`."""
    return ENERGIES + BENT_ENERGIES if bending else ENERGIES


def remembering(state: State) -> tuple[str, ...]:
    """Return the names of the laws with a memory that act: their works come after all others.

    Where ropes have been is kept of those that touch no others, too.
    """
    pairs = zip(NODE_LAWS, state.memory, strict=True)
    swept = state.memory.contact.swept
    return tuple(
        law.name for law, kept in pairs if any(np.size(part) for part in kept if part is not swept)
    )


def work_names(bending: bool, more: tuple[str, ...] = ()) -> tuple[str, ...]:
    """Return the columns of `work` before those of the anchors; `more` are laws with a memory."""
    return (LAWS + BENT_LAWS if bending else LAWS) + more


@kernel
def record_motion(x, v, mass, gravity, sums, energy, momentum, angular):
    """Write kinetic and gravity energy, momentum, and angular momentum about the origin."""
    clear_lanes(sums, SUMS)
    for lo in range(0, mass.shape[0], LANES):
        hi = min(lo + LANES, mass.shape[0])
        squares, lifts = _lanes(sums, 0), _lanes(sums, 1)
        px, py, pz = _lanes(sums, 2), _lanes(sums, 3), _lanes(sums, 4)
        lx, ly, lz = _lanes(sums, 5), _lanes(sums, 6), _lanes(sums, 7)
        _add_motion(x, v, mass, gravity, lo, hi, squares, lifts, px, py, pz, lx, ly, lz)
    energy[0] = 0.5 * total_of(sums, 0)
    energy[1] = -total_of(sums, 1)
    for k in range(3):
        momentum[k] = total_of(sums, 2 + k)
        angular[k] = total_of(sums, 5 + k)


@part
def _lanes(sums, which):
    return sums[which * LANES : (which + 1) * LANES]


@apart
def _add_motion(x, v, mass, gravity, lo, hi, squares, lifts, px, py, pz, lx, ly, lz):
    x0, x1, x2 = rows(x, lo, hi)
    v0, v1, v2 = rows(v, lo, hi)
    mass = mass[lo:hi]
    gx, gy, gz = gravity[0], gravity[1], gravity[2]
    for i in range(mass.shape[0]):
        m, a, b, c, p, q, r = mass[i], x0[i], x1[i], x2[i], v0[i], v1[i], v2[i]
        squares[i] += m * (p * p + q * q + r * r)
        lifts[i] += m * (gx * a + gy * b + gz * c)
        px[i] += m * p
        py[i] += m * q
        pz[i] += m * r
        lx[i] += m * (b * r - c * q)
        ly[i] += m * (c * p - a * r)
        lz[i] += m * (a * q - b * p)


@seldom
def record_frame(system, state, ledger, look, frame, out):
    """Write the state and all that follows from it as frame `frame`; works only with `ledger`."""
    put(state.x, out.x[frame])
    put(state.v, out.v[frame])
    energy, sums = out.energy[frame], look.sums
    if look.known[SEEN] == 0.0:
        read_segments(system, state, look)
    put_row(look.segments[0], out.elastic_tension[frame])
    put_row(look.segments[1], out.tension[frame])
    energy[2] = look.known[ENERGY]
    for j in range(out.rest_length.shape[1]):
        out.rest_length[frame, j] = state.rest_length[j]
    if has_bending(system):
        energy[3] = bent_energy(system, state, state.x)
    for row in range(out.moment.shape[1]):
        for k in range(3):
            out.moment[frame, row, k] = state.moment[row, k] + state.moment[row, k + 3]
    for row in range(state.held.shape[0]):
        for k in range(3):
            out.reaction[frame, row, k] = state.reaction[row, k]
    for row in range(out.joint_force.shape[1]):
        for k in range(3):
            out.joint_force[frame, row, k] = state.joint_force[row, k]
    p, spin = out.momentum[frame], out.angular_momentum[frame]
    record_motion(state.x, state.v, state.mass, system.gravity, sums, energy, p, spin)
    wound = 0.0
    if winds(system, state):
        wound = wound_energy(system, state)
        energy[1] += wound
    record_peaks(state.peaks, frame, out)
    record_turning(system, state, out.wheel[frame])
    if out.contact.shape[2] > 0:
        clear(out.contact[frame])
        touch_nodes(system, state, out.contact[frame])
    if ledger:
        record_works(system, state.work, sums, out.work[frame], out.jump[frame])
        out.work[frame, WINCH] += wound
        record_surfaces(system, state, out.books[frame])


ELASTIC, FRICTION, WEIGHT, APPLIED, LIMITER, WINCH, BENT, CLAMPS = (
    (*LAWS, *BENT_LAWS).index(name)
    for name in ("elastic", "friction", "weight", "applied", "limiter", "winch", *BENT_LAWS)
)


@part
def _no_works(system, works, sums, total, column):
    pass


def _recording(law: NodeLaw, k: int, rest: Any) -> Any:
    if law.name in LAWS:
        place = LAWS.index(law.name)

        @part
        def _record(system, works, sums, total, column):
            total[place] = add_up(works[k], sums)
            rest(system, works, sums, total, column)

    else:

        @part
        def _record(system, works, sums, total, column):
            following = column
            if acts(system, k):
                total[column] = add_up(works[k], sums)
                following = column + 1
            rest(system, works, sums, total, following)

    return _record


_record_node_works = fold(_recording, _no_works, "lower")


@kernel
def record_works(system, work, sums, total, jump):
    """Write the work done since the start [J], by law and then by anchor, and what came as a jump."""
    total[ELASTIC] = add_up(work.elastic, sums)
    total[FRICTION] = add_up(work.friction, sums)
    total[WEIGHT] = add_up(work.weight, sums)
    more = BENT if not has_bending(system) else CLAMPS + 1
    _record_node_works(system, work.node, sums, total, more)
    total[APPLIED] = add_up(work.applied, sums)
    total[LIMITER] = work.limiter[0] + work.limiter[1]
    total[WINCH] = work.winch[0] + work.winch[1]
    if has_bending(system):
        total[BENT] = add_up(work.bending, sums)
        total[CLAMPS] = add_up(work.clamps, sums)
    anchors = work.anchors.shape[0]
    for row in range(anchors):
        total[total.shape[0] - anchors + row] = work.anchors[row]
    jump[0], jump[1] = work.limiter[0], work.winch[0]
