"""What cannot throw back as the scene asks for: by the method, the contact or the body."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from ropewalk.core.arrays import Floats, State, System
from ropewalk.laws.pairs.table import LAYER
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
_LESS = 0.5  # [1] the same of ropes on ropes, over how deep their contacts are linear


def swings(system: System, row: int) -> Floats:
    """Return w = sqrt(k / m) of every node in an obstacle that throws back [rad/s], (n,)."""
    table = system.node.obstacle
    found: Floats = 2.0 * table.stiffness[row] / table.damping[row]
    return found


def rebound_faults(scene: Scene, system: System, state: State) -> Iterator[Fault]:
    """Yield a fault for every obstacle whose restitution cannot be honoured."""
    for row, body in enumerate(scene.obstacles):
        given, path = body.restitution, f"obstacle[{row}].restitution"
        if given == 0.0:
            continue
        yield from _by_method(scene.run.method, path, given)
        if is_free(body):
            rule = (
                "is of bodies that stand, or move as they are told: one that turns freely gives way; leave "
                "it out, or spin.free"
            )
            yield Fault(path, given, rule)
        if body.compliance is None:
            yield Fault(path, given, f"asks for a compliance {_advice(scene, system, state)}")


def contact_rebound_faults(scene: Scene, system: System, state: State) -> Iterator[Fault]:
    """Yield a fault where the restitution of ropes on ropes cannot be honoured."""
    contact, path = scene.contact, "contact.restitution"
    if contact is None or contact.restitution == 0.0:
        return
    yield from _by_method(scene.run.method, path, contact.restitution)
    if contact.compliance is None:
        told, deep = _WHY, _LESS * linear_to(system)
        speed, most = deepest_meeting(system, state, fastest(system, state))
        if speed > 0.0 and most > 0.0:
            told += (
                f"; with {rounded_down((deep / speed) ** 2 / most, 2)} segments that meet at {speed:.3g} m/s "
                f"as one of {most:.3g} kg go {1e3 * deep:.3g} mm into each other"
            )
        yield Fault(path, contact.restitution, f"asks for a compliance {told}")


def linear_to(system: System) -> float:
    """Return how deep contacts of ropes are as soft as their compliance says [m]."""
    table = system.node.contact
    return float(3.0 * LAYER * 2.0 * table.radius[table.rope >= 0].min())


def least_meeting(system: System, state: State) -> float:
    """Return the least mass [kg] as which two segments may meet, at their ends; 0 where none is free."""
    one, other = _ease(system, state)
    ends = float(np.sort(np.concatenate([one, other]))[-2:].sum())
    return 1.0 / ends if ends > 0.0 else 0.0


def deepest_meeting(system: System, state: State, speed: float) -> tuple[float, float]:
    """Return how fast [m/s], and as which mass [kg], segments meet in their middles that go deepest so.

    Of ropes whose fastest node has a speed: two come at each other with twice that, a held one stands. Zeros
    where none is free.
    """
    middles = np.sort(0.25 * sum(_ease(system, state)))
    moves = middles[middles > 0.0]
    met = [(2.0 * speed, float(1.0 / moves[:2].sum()))] if len(moves) > 1 else []
    if len(moves) and (len(moves) < len(middles) or not met):
        met.append((speed, float(1.0 / moves[0])))
    return max(met, key=lambda one: one[0] ** 2 * one[1], default=(0.0, 0.0))


def _ease(system: System, state: State) -> tuple[Floats, Floats]:
    """Return the inverse masses of all segments' first and second nodes, as they meet others, (s,) [1/kg]."""
    table, inverse = system.node.contact, state.inverse_mass
    ease, ropes = inverse / (1.0 + inverse * table.joined), np.flatnonzero(table.rope >= 0)
    return ease[ropes], ease[ropes + 1]


def _by_method(method: str, path: str, given: float) -> Iterator[Fault]:
    """Yield a fault where a method has no steps that follow a hit."""
    if method == "auto" or METHODS[method].fixed:
        rule = (
            f'asks for run.method = "adaptive", whose steps follow a hit and what it throws back; it is '
            f'"{method}", and steps of a fixed length take all of its speed: set that, or leave this out'
        )
        yield Fault(path, given, rule)


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
