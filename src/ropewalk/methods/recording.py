"""What one frame of a run holds, written inside the compiled loop."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from ropewalk.core.arrays import BENDING, Floats, State
from ropewalk.core.jit import kernel
from ropewalk.core.status import BROKEN, OK
from ropewalk.laws.clamps import bent_energy
from ropewalk.methods.scratch import put

ENERGIES = ("kinetic", "gravity", "elastic")
LAWS = ("elastic", "friction", "weight", "air", "ground", "applied", "limiter", "winch")
# What a system with bending stiffness has besides.
BENT_ENERGIES = ("bending",)
BENT_LAWS = ("bending", "clamps")
CONSERVATIVE = ("elastic", "weight", "bending")  # laws with a potential


class Recording(NamedTuple):
    """Buffers for `f` frames; a frame is written after its last step."""

    x: Floats  # (f, 3, n) [m]
    v: Floats  # (f, 3, n) [m/s]
    tension: Floats  # (f, s) elastic tension [N]
    rest_length: Floats  # (f, s) [m]; (f, 0) without a winch
    energy: Floats  # (f, 3 or 4) kinetic, gravity, elastic and, where there is any, bending [J]
    work: Floats  # (f, 8 or 10 + a) work by law, then by anchor [J]
    jump: Floats  # (f, 2) kinetic energy put in by limiter and winch [J]
    reaction: Floats  # (f, a, 3) [N]
    momentum: Floats  # (f, 3) [kg m/s]
    angular_momentum: Floats  # (f, 3) about the origin [kg m^2/s]
    moment: Floats  # (f, a, 3) of the clamps on the rope [N m]; (f, 0, 3) without a clamp


def make_recording(state: State, frames: int, with_lengths: bool) -> Recording:
    """Return buffers for `frames` frames of a rope system like `state`.

    The large ones are not cleared: memory that was used before then needs no touch but the recording's.
    """
    n, s, a = state.x.shape[1], state.rest_length.shape[0], state.held.shape[0]
    energies, laws = len(energy_names(bends(state))), len(work_names(bends(state)))
    shapes = ((3, n), (3, n), (s,), (s if with_lengths else 0,), (energies,), (laws + a,), (2,))
    shapes += ((a, 3), (3,), (3,), (state.moment.shape[0], 3))  # type: ignore[assignment]
    large = [np.empty((frames, *shape)) for shape in shapes[:3]]
    return Recording(*large, *(np.zeros((frames, *shape)) for shape in shapes[3:]))


def bends(state: State) -> bool:
    """Tell whether a state has bending stiffness."""
    return state.bending_stiffness.size > 0


def energy_names(bending: bool) -> tuple[str, ...]:
    """Return the columns of `energy`."""
    return ENERGIES + BENT_ENERGIES if bending else ENERGIES


def work_names(bending: bool) -> tuple[str, ...]:
    """Return the columns of `work` before those of the anchors."""
    return LAWS + BENT_LAWS if bending else LAWS


LARGEST = 1e154  # [m] the square of a longer one is infinite


@kernel
def add_up(values):
    """Sum an array in four lanes: faster than one chain of additions, and the same at every call."""
    a, b, c, d = 0.0, 0.0, 0.0, 0.0
    whole = values.shape[0] // 4 * 4
    for i in range(0, whole, 4):
        a += values[i]
        b += values[i + 1]
        c += values[i + 2]
        d += values[i + 3]
    for i in range(whole, values.shape[0]):
        a += values[i]
    return (a + b) + (c + d)


@kernel
def add_up_products(left, right):
    """Sum the products of two arrays, in four lanes, too."""
    a, b, c, d = 0.0, 0.0, 0.0, 0.0
    whole = left.shape[0] // 4 * 4
    for i in range(0, whole, 4):
        a += left[i] * right[i]
        b += left[i + 1] * right[i + 1]
        c += left[i + 2] * right[i + 2]
        d += left[i + 3] * right[i + 3]
    for i in range(whole, left.shape[0]):
        a += left[i] * right[i]
    return (a + b) + (c + d)


@kernel
def record_motion(x, v, mass, gravity, room, energy, momentum, angular):
    """Write kinetic and gravity energy, momentum, and angular momentum about the origin.

    `room` is a working array (3, n): it takes each node's momentum.
    """
    x0, x1, x2 = x[0], x[1], x[2]
    v0, v1, v2 = v[0], v[1], v[2]
    p0, p1, p2 = room[0], room[1], room[2]
    for i in range(mass.shape[0]):
        p0[i] = mass[i] * v0[i]
        p1[i] = mass[i] * v1[i]
        p2[i] = mass[i] * v2[i]
    momentum[0], momentum[1], momentum[2] = add_up(p0), add_up(p1), add_up(p2)
    double = add_up_products(p0, v0) + add_up_products(p1, v1) + add_up_products(p2, v2)
    energy[0] = 0.5 * double
    angular[0] = add_up_products(x1, p2) - add_up_products(x2, p1)
    angular[1] = add_up_products(x2, p0) - add_up_products(x0, p2)
    angular[2] = add_up_products(x0, p1) - add_up_products(x1, p0)
    energy[1] = -(
        gravity[0] * add_up_products(mass, x0)
        + gravity[1] * add_up_products(mass, x1)
        + gravity[2] * add_up_products(mass, x2)
    )


@kernel
def record_tension(x, rest_length, stiffness, floor, solved, stored, tension):
    """Write every segment's elastic tension [N] and energy [J], both (s,); see `laws.stretch`.

    A rigid link has the tension that was solved for, and stores nothing.
    """
    x0, x1, x2 = x[0], x[1], x[2]
    for j in range(rest_length.shape[0]):
        dx, dy, dz = x0[j + 1] - x0[j], x1[j + 1] - x1[j], x2[j + 1] - x2[j]
        e = math.sqrt(dx * dx + dy * dy + dz * dz) - rest_length[j]
        gives = stiffness[j] < np.inf
        pull = stiffness[j] * e if gives else solved[j]
        tension[j] = max(pull, floor[j])
        stored[j] = 0.5 * pull * e if gives and pull >= floor[j] else 0.0


@kernel
def record_frame(system, state, room, frame, out):
    """Write the state and all that follows from it as frame `frame`."""
    put(state.x, out.x[frame])
    put(state.v, out.v[frame])
    floor, stored = system.slack_floor, room[0, : state.rest_length.shape[0]]
    tension, energy = out.tension[frame], out.energy[frame]
    lengths, stiffness = state.rest_length, state.stiffness
    record_tension(state.x, lengths, stiffness, floor, state.tension, stored, tension)
    energy[2] = add_up(stored)
    for j in range(out.rest_length.shape[1]):
        out.rest_length[frame, j] = state.rest_length[j]
    work = state.work
    first = out.work.shape[1] - state.held.shape[0]  # of the anchors' columns
    if system.flags[BENDING] == 1:
        out.energy[frame, 3] = bent_energy(system, state)
        out.work[frame, 8] = add_up(work.bending)
        out.work[frame, 9] = add_up(work.clamps)
    for row in range(out.moment.shape[1]):
        for k in range(3):
            out.moment[frame, row, k] = state.moment[row, k] + state.moment[row, k + 3]
    out.work[frame, 0] = add_up(work.elastic)
    out.work[frame, 1] = add_up(work.friction)
    out.work[frame, 2] = add_up(work.weight)
    out.work[frame, 3] = add_up(work.air)
    out.work[frame, 4] = add_up(work.ground)
    out.work[frame, 5] = add_up(work.applied)
    out.work[frame, 6] = work.limiter[0] + work.limiter[1]
    out.work[frame, 7] = work.winch[0] + work.winch[1]
    out.jump[frame, 0] = work.limiter[0]
    out.jump[frame, 1] = work.winch[0]
    for row in range(state.held.shape[0]):
        out.work[frame, first + row] = work.anchors[row]
        for k in range(3):
            out.reaction[frame, row, k] = state.reaction[row, k]
    p, spin = out.momentum[frame], out.angular_momentum[frame]
    record_motion(state.x, state.v, state.mass, system.gravity, room, energy, p, spin)


@kernel
def check_state(state, break_stretch):
    """Return BROKEN when anything is not finite or a live segment is stretched beyond reason."""
    x0, x1, x2 = state.x[0], state.x[1], state.x[2]
    v0, v1, v2 = state.v[0], state.v[1], state.v[2]
    lengths, stiffness = state.rest_length, state.stiffness
    bad = 0
    for i in range(v0.shape[0]):
        speed = v0[i] + v1[i] + v2[i]
        bad += 0 if speed - speed == 0.0 else 1  # neither infinite nor NaN
    for j in range(lengths.shape[0]):
        dx, dy, dz = x0[j + 1] - x0[j], x1[j + 1] - x1[j], x2[j + 1] - x2[j]
        length = lengths[j]
        live = length > 0.0 and stiffness[j] > 0.0
        longest = break_stretch * length if live else LARGEST
        square = dx * dx + dy * dy + dz * dz
        bad += 0 if square <= longest * longest and length - length == 0.0 else 1
    return OK if bad == 0 else BROKEN
