"""What comes before a run's first step and after every frame, whatever the method."""

from __future__ import annotations

from ropewalk.core.jit import kernel
from ropewalk.laws.table import accelerate, evaluate
from ropewalk.methods.recording import check_state, record_frame


@kernel
def prepare(system, state):
    """Evaluate all forces and accelerations at the state itself (before a first step)."""
    evaluate(system, state, state.x, state.v, state.forces)
    accelerate(system, state, state.forces, state.acceleration)


@kernel
def close_frame(system, state, frame, out):
    """Record the frame where there is room for it; return the state's status."""
    if out.x.shape[0] > frame:
        record_frame(system, state, frame, out)
    return check_state(state, system.break_stretch)
