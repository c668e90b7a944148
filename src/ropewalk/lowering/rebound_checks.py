"""Obstacles that cannot throw back what the scene asks for: by the method, the contact or the body."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from ropewalk.core.arrays import Floats, State, System
from ropewalk.lowering.chains import fastest
from ropewalk.methods.registry import METHODS
from ropewalk.scene import Scene
from ropewalk.scene.faults import Fault
from ropewalk.scene.obstacles import is_free
from ropewalk.words.safe_side import rounded_down

RESOLVED = (
    30.0  # [1] tolerances that a node is to go in: then what it leaves with is right to 0.005
)
_WHY = "(m/N): by default a contact hardens as it is pressed, and would throw back something else"
_GIVES = 0.1  # [1] diameters that it goes in with the compliance that is told


def swings(system: System, row: int) -> Floats:
    """Return w = sqrt(k / m) of every node in an obstacle that throws back [rad/s], (n,)."""
    table = system.node.obstacle
    found: Floats = 2.0 * table.stiffness[row] / table.damping[row]
    return found


def rebound_faults(scene: Scene, system: System, state: State) -> Iterator[Fault]:
    """Yield a fault for every obstacle whose restitution cannot be honoured."""
    method = scene.run.method
    for row, body in enumerate(scene.obstacles):
        given, path = body.restitution, f"obstacle[{row}].restitution"
        if given == 0.0:
            continue
        if method == "auto" or METHODS[method].fixed:
            rule = (
                f'asks for run.method = "adaptive", whose steps follow a hit and what it throws back; it is '
                f'"{method}", and steps of a fixed length take all of its speed: set that, or leave this out'
            )
            yield Fault(path, given, rule)
        if is_free(body):
            rule = (
                "is of bodies that stand, or move as they are told: one that turns freely gives way; leave "
                "it out, or spin.free"
            )
            yield Fault(path, given, rule)
        if body.compliance is None:
            yield Fault(path, given, f"asks for a compliance {_advice(scene, system, state)}")


def _advice(scene: Scene, system: System, state: State) -> str:
    """Return why, and which compliance would do."""
    table, speed = system.node.obstacle, fastest(system, state)
    if not speed > 0.0:
        return _WHY
    deep = max(_GIVES * float(table.diameter.min()), RESOLVED * scene.run.tolerance)
    mass = float(np.min(state.mass[state.mass > 0.0]))
    return (
        f"{_WHY}; with {rounded_down((deep / speed) ** 2 / mass, 2)} a node of {mass:.3g} kg that comes with "
        f"{speed:.3g} m/s goes {1e3 * deep:.3g} mm deep"
    )
