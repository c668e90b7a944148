"""Where ropes hang under their weight and constant forces along it: exact, and the start for all else.

Between two held nodes the closed form of the chain (`theory.chain`), beyond the outermost ones a tail
that hangs straight down. No ground, no air, no bending; what would have to push counts as slack.
"""

from __future__ import annotations

import itertools

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.lowering import Model, Span
from ropewalk.scene import SceneError
from ropewalk.scene.faults import Fault
from ropewalk.theory.chain import hang


def hung(model: Model) -> tuple[Floats, Floats]:
    """Return the places of the nodes [m], (3, n), and the tensions [N], (s,).

    Ropes that nothing holds stay where they are, without tension. Raises SceneError for rigid links
    that do not reach from one held node to the next.
    """
    x, tension = model.state.x.copy(), np.zeros(model.state.rest_length.size)
    for rope in model.layout.ropes:
        nodes = held_nodes(model, rope)
        if not nodes:
            continue
        if nodes[0] > rope.start:
            _tail(model, x, tension, nodes[0], rope.start)
        for first, last in itertools.pairwise(nodes):
            try:
                _span(model, x, tension, first, last)
            except (ValueError, ArithmeticError) as error:
                number = model.scene.rope_index(rope.name)
                names = _anchors_at(model, first, last)
                said = str(error)
                rule = (said.partition(" - ")[2] or said) + f" (from {names})"
                length = float(model.state.rest_length[first:last].sum())
                fault = Fault(f"rope[{number}].length", length, rule)
                raise SceneError([fault]) from None
        if nodes[-1] < rope.end:
            _tail(model, x, tension, nodes[-1], rope.end)
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


def _span(model: Model, x: Floats, tension: Floats, first: int, last: int) -> None:
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
    found = hang(weights, state.stiffness[segments], state.rest_length[segments], across, rise)
    steps = np.outer(direction, found.along) + np.outer(up, found.upward)
    path = np.cumsum(steps, axis=1)
    # What a million additions round off is shared by all segments, or the last one bears it alone.
    path += np.outer(ends - path[:, -1], np.arange(1, path.shape[1] + 1) / path.shape[1])
    x[:, first + 1 : last] = x[:, first, None] + path[:, :-1]
    pull = found.tension
    if last - first == 1 and model.system.slack_floor[first] == 0.0:
        pull = np.maximum(pull, 0.0)
    tension[segments] = pull


def _tail(model: Model, x: Floats, tension: Floats, held: int, tip: int) -> None:
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
        size = state.rest_length[segments] + carried / state.stiffness[segments]
        x[:, nodes] = x[:, held, None] + np.cumsum(way * size, axis=1)
    else:
        size = state.rest_length[segments] + carried / state.stiffness[segments]
        x[:, nodes] = x[:, held, None] - np.outer(up, np.cumsum(size))
    tension[segments] = carried
