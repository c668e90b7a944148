"""Where ropes hang under their weight and constant forces along it: exact, and the start for all else.

Between two held nodes the closed form of the chain (`theory.chain`), beyond the outermost ones a tail
that hangs straight down. No ground, no air, no bending; what would have to push counts as slack.
"""

from __future__ import annotations

import itertools

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.lowering import Model, Span
from ropewalk.lowering.elastic_tables import put_under_tension
from ropewalk.scene import SceneError
from ropewalk.scene.faults import Fault
from ropewalk.theory.chain import hang

_ROUNDS = 6  # in which ropes with a curve get the secants of their tensions
_LITTLE = 1e-9  # of the largest tension, below which a curve is its tangent at rest [1]


def hung(model: Model) -> tuple[Floats, Floats]:
    """Return the places of the nodes [m], (3, n), and the tensions [N], (s,).

    Ropes that nothing holds stay where they are, without tension; those with a curve hang to a few digits.
    Raises SceneError for rigid links
    that do not reach from one held node to the next.
    """
    x, tension = _hung(model, model.state.stiffness)
    for _ in range(_ROUNDS if model.system.elastic.time.size else 0):
        x, tension = _hung(model, _secants(model, tension))
    return x, tension


def _secants(model: Model, tension: Floats) -> Floats:
    """Return the stiffness of a straight line through each segment's tension [N/m], (s,)."""
    found = model.state.stiffness.copy()
    stretch, soft = np.zeros_like(found), np.zeros_like(found)
    put_under_tension(model.system, model.state, tension, stretch, soft)
    np.divide(1.0, soft, out=found, where=soft > 0.0)
    pulled = np.abs(tension) > _LITTLE * np.abs(tension).max(initial=0.0)
    return np.divide(tension, stretch, out=found, where=pulled & (stretch != 0.0))


def _hung(model: Model, stiffness: Floats) -> tuple[Floats, Floats]:
    """Return the same for segments of given stiffnesses [N/m], (s,)."""
    x, tension = model.state.x.copy(), np.zeros(model.state.rest_length.size)
    for rope in model.layout.ropes:
        nodes = held_nodes(model, rope)
        if not nodes:
            continue
        if nodes[0] > rope.start:
            _tail(model, stiffness, x, tension, nodes[0], rope.start)
        for first, last in itertools.pairwise(nodes):
            try:
                _span(model, stiffness, x, tension, first, last)
            except (ValueError, ArithmeticError) as error:
                number = model.scene.rope_index(rope.name)
                names = _anchors_at(model, first, last)
                said = str(error)
                rule = (said.partition(" - ")[2] or said) + f" (from {names})"
                length = float(model.state.rest_length[first:last].sum())
                fault = Fault(f"rope[{number}].length", length, rule)
                raise SceneError([fault]) from None
        if nodes[-1] < rope.end:
            _tail(model, stiffness, x, tension, nodes[-1], rope.end)
    return x, tension


def held_nodes(model: Model, rope: Span) -> list[int]:
    """Return the nodes of a rope that an anchor holds, in order, as indices of the arrays."""
    held = model.state.anchor_node[model.state.held == 1].tolist()
    return sorted({node for node in held if rope.start <= node <= rope.end})


def upward(model: Model) -> tuple[Floats, float]:
    """Return the direction against gravity (3,), and gravity's size [m/s^2]."""
    size = float(np.linalg.norm(model.system.gravity))
    return np.array(model.scene.up), size


def _anchors_at(model: Model, *nodes: int) -> str:
    names = [
        name
        for name, node in zip(model.layout.anchor_names, model.state.anchor_node, strict=True)
        if node in nodes
    ]
    return " to ".join(f"anchor {name!r}" for name in names)


def _span(
    model: Model, stiffness: Floats, x: Floats, tension: Floats, first: int, last: int
) -> None:
    state, segments = model.state, slice(first, last)
    up, gravity = upward(model)
    ends = x[:, last] - x[:, first]
    rise = float(ends @ up)
    level = ends - rise * up
    across = float(np.linalg.norm(level))
    direction = level / across if across > 0.0 else np.zeros(3)
    weights = state.mass[first + 1 : last] * gravity
    if (lift := up @ state.forces.applied[:, first + 1 : last]).any():
        weights = weights - lift
        if weights.sum() < 0.0:  # it floats: as it would hang, upside down
            up, rise, weights = -up, -rise, -weights
        weights = np.maximum(weights, 1e-6 * float(np.abs(weights).max()))
    found = hang(weights, stiffness[segments], state.rest_length[segments], across, rise)
    steps = np.outer(direction, found.along) + np.outer(up, found.upward)
    path = np.cumsum(steps, axis=1)
    # What a million additions round off is shared by all segments, or the last one bears it alone.
    path += np.outer(ends - path[:, -1], np.arange(1, path.shape[1] + 1) / path.shape[1])
    x[:, first + 1 : last] = x[:, first, None] + path[:, :-1]
    pull = found.tension
    if last - first == 1 and model.system.slack_floor[first] == 0.0:
        pull = np.maximum(pull, 0.0)
    tension[segments] = pull


def _tail(model: Model, stiffness: Floats, x: Floats, tension: Floats, held: int, tip: int) -> None:
    """Hang what lies beyond a held node straight down; without weight it stays as it starts."""
    state = model.state
    up, gravity = upward(model)
    if gravity == 0.0 and not state.forces.applied.any():
        return
    step = 1 if tip > held else -1
    nodes = np.arange(held + step, tip + step, step)
    segments = nodes - 1 if step > 0 else nodes
    carried = np.cumsum(state.mass[nodes][::-1])[::-1] * gravity
    if state.forces.applied[:, nodes].any():
        beyond = np.outer(model.system.gravity, state.mass[nodes]) + state.forces.applied[:, nodes]
        pull = np.cumsum(beyond[:, ::-1], axis=1)[:, ::-1]
        carried = np.linalg.norm(pull, axis=0)
        way = np.where(carried > 0.0, pull / np.maximum(carried, 1e-300), -up[:, None])
        size = state.rest_length[segments] + carried / stiffness[segments]
        x[:, nodes] = x[:, held, None] + np.cumsum(way * size, axis=1)
    else:
        size = state.rest_length[segments] + carried / stiffness[segments]
        x[:, nodes] = x[:, held, None] - np.outer(up, np.cumsum(size))
    tension[segments] = carried
