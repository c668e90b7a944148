"""An equilibrium as a result of one frame."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from ropewalk.core import arrays
from ropewalk.core.arrays import Floats, State, System
from ropewalk.core.deferred import clock
from ropewalk.core.peaks import HIGHEST, LEAST_TENSION, LOWEST, STRETCH, TENSION
from ropewalk.core.status import OK
from ropewalk.engine.start import load_wheels, set_joint_forces
from ropewalk.laws.clamps import start_clamps
from ropewalk.laws.obstacle_places import as_at_rest
from ropewalk.laws.wheel_rows import RATE
from ropewalk.lowering import Model, build
from ropewalk.lowering.elastic_tables import let_relax, stored_at_rest
from ropewalk.methods.loop import prepare
from ropewalk.methods.recording import ENERGIES, Recording, make_recording, record_frame
from ropewalk.methods.scratch import make_look
from ropewalk.methods.watch import begin_interval
from ropewalk.record.facts import AT_REST, Facts, provenance
from ropewalk.record.quantities import recorded
from ropewalk.record.result import Result
from ropewalk.record.source import Memory
from ropewalk.record.stood import STAND
from ropewalk.scene import Scene
from ropewalk.simulation.block import Block
from ropewalk.simulation.rope_contacts import on_obstacles, rope_contacts
from ropewalk.statics import Statics, checked_shape

_EVEN = 1e-10  # [1] share by which values differ that are even but for rounding


def rest_result(source: Scene | Model) -> Result:
    """Return the equilibrium of a scene as a result of one frame, status "at rest".

    Raises SceneError for a scene without a rest shape, NoRest when none is found.
    """
    return rest_and_result(source)[1]


def rest_and_result(source: Scene | Model) -> tuple[Statics, Result]:
    """Return the equilibrium of a scene, and the same as `rest_result` does. Raises as that."""
    model = source if isinstance(source, Model) else build(source, stepped=False)
    begun = clock()
    statics = checked_shape(model)
    return statics, as_result(model, statics, clock() - begun)


def as_result(model: Model, statics: Statics, seconds: float) -> Result:
    """Return the shape of rest of a model as a result of one frame; it took so many seconds [s]."""
    plan = replace(model.plan, frames=0)
    about = provenance(plan, ledger=True, keep_going=False)
    about["statics"] = {
        "residual": statics.residual,
        "gap": statics.gap,
        "steps": statics.steps,
        STAND: True,
    }
    facts = Facts(
        plan=plan,
        status=AT_REST,
        seconds=seconds,
        provenance=about,
    )
    block = _frame(model, statics)
    names = tuple(q.name for q in recorded(model.layout, model.scene))
    return Result(model.scene, model.layout, Memory([block], names), facts)


def _frame(model: Model, statics: Statics) -> Block:
    """Return the frame as a run would record it, with the tensions that were solved for."""
    system, state = as_at_rest(model.system), arrays.copy(model.state)
    state.x[...] = statics.positions.T
    state.v[...] = 0.0
    state.reaction[...] = statics.reactions
    let_relax(system, state)
    stored = stored_at_rest(system, state, statics.elastic_tension)
    if statics.memory is not None:
        arrays.assign(state.memory, statics.memory)
    if len(system.node.obstacle.inertia):
        state.memory.obstacle.wheel[:, RATE] = 0.0
    out = make_recording(state, 1, model.scene.lengths_change)
    prepare(system, state)
    _balance(system, state, statics.elastic_tension)
    start_clamps(system, state)
    state.clamp_spin[...] = 0.0
    look = make_look(state)
    begin_interval(system, state, look, 0.0, False)
    record_frame(system, state, True, look, 0, out)
    _put_tensions(out, state.stiffness > 0.0, statics.tension, model.scene.run.extremes)
    if model.scene.run.extremes:
        _put_places(out, state.stiffness > 0.0, state, system.up)
    out.elastic_tension[0] = statics.elastic_tension
    out.energy[0, ENERGIES.index("gravity")] -= model.gravity_zero
    out.energy[0, ENERGIES.index("elastic")] = stored
    return Block(np.zeros(1), out, OK, rope_contacts(state), on_obstacles(system, state))


def _balance(system: System, state: State, elastic: Floats) -> None:
    """Write what joints and the ropes on wheels carry, of forces that are evaluated: nothing moves.

    The state knows no tensions of rigid links; `elastic` are those of all segments [N], (s,).
    """
    links = np.flatnonzero(np.isinf(state.stiffness))
    along = state.x[:, links + 1] - state.x[:, links]
    state.forces.elastic[:, links + 1] = elastic[links] * along / np.linalg.norm(along, axis=0)
    state.acceleration[...] = 0.0
    set_joint_forces(system, state)
    load_wheels(system, state)


def _put_tensions(out: Recording, live: NDArray[np.bool_], tension: Floats, extremes: bool) -> None:
    """Write the tensions of rest [N], (s,), and their extremes; of rigid links the state knows none."""
    out.tension[0] = tension
    if not extremes or not live.any():
        return
    out.tension_low[0] = out.tension_high[0] = tension
    for which, size in ((TENSION, tension), (LEAST_TENSION, -tension)):
        sizes = np.where(live, size, -np.inf)
        out.extremes[0, which] = tension[np.argmax(sizes)]
        out.extreme_places[0, which] = first(sizes, float(np.abs(tension[live]).max()))


def _put_places(out: Recording, live: NDArray[np.bool_], state: State, up: Floats) -> None:
    """Write the places of the other extremes of a shape, the first of those that are even to rounding."""
    if not live.any():
        return
    stretch = np.full(len(live), -np.inf)
    along = np.linalg.norm(np.diff(state.x)[:, live], axis=0)
    stretch[live] = along / state.rest_length[live]
    there = np.append(live, False) | np.append(False, live)
    height = up @ state.x
    high, low = np.where(there, height, -np.inf), np.where(there, -height, -np.inf)
    size = float(np.abs(state.x[:, there]).max())
    out.extreme_places[0, STRETCH] = first(stretch, float(stretch.max()))
    out.extreme_places[0, [HIGHEST, LOWEST]] = first(high, size), first(low, size)


def first(values: Floats, size: float) -> int:
    """Return the first place of the largest value, to the rounding of numbers of this size."""
    return int(np.argmax(values >= values.max() - _EVEN * size))
