"""What one frame of a run holds, written inside the compiled loop."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats, State
from ropewalk.core.jit import kernel
from ropewalk.core.status import BROKEN, OK
from ropewalk.laws.ledger import gravity_energy, kinetic_energy
from ropewalk.laws.stretch import elastic_energy, segment_tension

ENERGIES = ("kinetic", "gravity", "elastic")
LAWS = ("elastic", "friction", "weight", "air", "ground", "applied", "limiter", "winch")


class Recording(NamedTuple):
    """Buffers for `f` frames; a frame is written after its last step."""

    x: Floats  # (f, 3, n) [m]
    v: Floats  # (f, 3, n) [m/s]
    tension: Floats  # (f, s) elastic tension [N]
    rest_length: Floats  # (f, s) [m]; (f, 0) without a winch
    energy: Floats  # (f, 3) kinetic, gravity, elastic [J]
    work: Floats  # (f, 8 + a) work by law, then by anchor [J]
    jump: Floats  # (f, 2) kinetic energy put in by limiter and winch [J]
    reaction: Floats  # (f, a, 3) [N]
    momentum: Floats  # (f, 3) [kg m/s]
    angular_momentum: Floats  # (f, 3) about the origin [kg m^2/s]


def make_recording(state: State, frames: int, with_lengths: bool) -> Recording:
    """Return buffers for `frames` frames of a rope system like `state`."""
    n, s, a = state.x.shape[1], state.rest_length.shape[0], state.held.shape[0]
    shapes = ((3, n), (3, n), (s,), (s if with_lengths else 0,), (3,), (len(LAWS) + a,), (2,))
    shapes += ((a, 3), (3,), (3,))  # type: ignore[assignment]
    return Recording(*(np.zeros((frames, *shape)) for shape in shapes))


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
def record_momentum(state, momentum, angular):
    """Write momentum and angular momentum about the origin."""
    x, v, mass = state.x, state.v, state.mass
    for k in range(3):
        k1, k2 = (k + 1) % 3, (k + 2) % 3
        p, spin = 0.0, 0.0
        for i in range(mass.shape[0]):
            p += mass[i] * v[k, i]
            spin += mass[i] * (x[k1, i] * v[k2, i] - x[k2, i] * v[k1, i])
        momentum[k] = p
        angular[k] = spin


@kernel
def record_frame(system, state, frame, out):
    """Write the state and all that follows from it as frame `frame`."""
    n = state.mass.shape[0]
    for k in range(3):
        for i in range(n):
            out.x[frame, k, i] = state.x[k, i]
            out.v[frame, k, i] = state.v[k, i]
    floor = system.slack_floor
    segment_tension(state.x, state.rest_length, state.stiffness, floor, out.tension[frame])
    for j in range(out.rest_length.shape[1]):
        out.rest_length[frame, j] = state.rest_length[j]
    out.energy[frame, 0] = kinetic_energy(state.v, state.mass)
    out.energy[frame, 1] = gravity_energy(state.x, state.mass, system.gravity)
    out.energy[frame, 2] = elastic_energy(state.x, state.rest_length, state.stiffness, floor)
    work = state.work
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
        out.work[frame, 8 + row] = work.anchors[row]
        for k in range(3):
            out.reaction[frame, row, k] = state.reaction[row, k]
    record_momentum(state, out.momentum[frame], out.angular_momentum[frame])


@kernel
def check_state(state, break_stretch):
    """Return BROKEN when anything is not finite or a live segment is stretched beyond reason."""
    x, v = state.x, state.v
    for i in range(v.shape[1]):
        if not math.isfinite(v[0, i] + v[1, i] + v[2, i]):
            return BROKEN
    for j in range(state.rest_length.shape[0]):
        dx = x[0, j + 1] - x[0, j]
        dy = x[1, j + 1] - x[1, j]
        dz = x[2, j + 1] - x[2, j]
        r = math.sqrt(dx * dx + dy * dy + dz * dz)
        length = state.rest_length[j]
        if not math.isfinite(r) or not math.isfinite(length):
            return BROKEN
        if length > 0.0 and r > break_stretch * length and state.stiffness[j] > 0.0:
            return BROKEN
    return OK
