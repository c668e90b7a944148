"""What corners of ropes that slide over round bodies add to modes.

A rope that slides by u over a round surface takes its last node along it; from there it leaves in a
straight line, by an angle e off the surface, half a segment's at most. With the tension T its pull along the
surface is T cos e, less than T by T e^2 / 2, and e goes as u / R, R the radius: as if a spring of T sin e / R
held that node along the surface, or pushed it on; less (T / R)^2 / k, for what presses the node changes with
e, too, and its contact of the stiffness k yields. A smooth rope leaves where e = 0, however far it has slid.
To first order omega^2 of a mode is more by the sum of that times what the nodes move, as of wheels
(`turning.Turns`).
"""

from __future__ import annotations

import math

import numpy as np

from ropewalk.core.arrays import Floats, Ints
from ropewalk.laws.contact_frame import PUSH
from ropewalk.laws.hardening import squeezed
from ropewalk.laws.obstacle_places import surface_near
from ropewalk.laws.polygon import angle_of
from ropewalk.lowering import Model
from ropewalk.vibration.linear import Linear
from ropewalk.vibration.solve import Complex

_NOTHING = 1e-6  # of the largest omega^2: less is rounding [1]
_TOLD = 0.08  # of omega^2, as 4 % of a frequency: what may be off without a word [1]


def slid_notes(
    values: Complex, flat: Complex, linear: Linear, model: Model, x: Floats, tension: Floats
) -> tuple[str, ...]:
    """Return a sentence for every body over whose corners a rope slides in some mode, for that with most.

    Args:
        values: eigenvalues (m,) [1/s].
        flat: shapes (m, u) of those.
        linear: what they are of.
        model: with the contacts at rest, where friction is left out what slips.
        x, tension: places (3, n) [m] and tensions (s,) [N] there.
    """
    table, grip = model.system.node.obstacle, model.state.memory.obstacle.grip
    square = values.imag**2 - values.real**2  # -Re(l^2): of what grows below 0
    moved = (linear.mass * np.abs(flat) ** 2).sum(axis=1)
    found = []
    for row in range(len(table.kind)):
        if model.scene.obstacles[row].name in model.layout.pulleys:
            continue  # it turns with its rope, or is held and has it held; see `turning`
        added, pressed = np.zeros(len(values)), np.flatnonzero(grip[row, PUSH] > 0.0)
        for node, way, spring in _ends(model, row, x, tension, pressed):
            place = linear.follows[node]
            if place >= 0:
                added += spring * np.abs(flat[:, 3 * place : 3 * place + 3] @ way) ** 2 / moved
        added[np.abs(added) < _NOTHING * float(np.abs(square).max(initial=0.0))] = 0.0
        size = np.maximum(np.abs(square), np.abs(square - added))
        share = np.divide(np.abs(added), size, out=np.zeros_like(size), where=size > 0.0)
        mode = int(np.argmax(share)) if share.size else 0
        if share.size and share[mode] > _TOLD:
            name = model.scene.obstacles[row].name
            found.append(_words(name, mode, float(square[mode]), float(square[mode] - added[mode])))
    return tuple(found)


def _ends(
    model: Model, row: int, x: Floats, tension: Floats, nodes: Ints
) -> list[tuple[int, Floats, float]]:
    """Return the nodes at which ropes leave a round body, their way along it (3,), their springs [N/m]."""
    table, live = model.system.node.obstacle, model.state.stiffness > 0.0
    found = []
    breaks = np.flatnonzero(np.diff(nodes) > 2)
    firsts, lasts = np.append(0, breaks + 1), np.append(breaks, nodes.size - 1)
    for k, step in [*((k, -1) for k in firsts), *((k, 1) for k in lasts)] if nodes.size else []:
        node = int(nodes[k])
        segment = node - 1 if step < 0 else node
        if not (0 <= segment < live.size and live[segment] and tension[segment] > 0.0):
            continue
        gap, *normal, ax, ay, az, ca, cb = surface_near(table, row, x[:, node])
        out = x[:, node + step] - x[:, node]
        size = float(np.linalg.norm(out))
        round_ = angle_of(x, segment, (ax, ay, az), ca, cb) / size  # 1/R along the rope [1/m]
        level = float(out @ np.array(normal)) / size
        along = out - size * level * np.array(normal)
        flat = float(np.linalg.norm(along))
        if round_ > 0.0 and flat > 0.0:
            pull = float(tension[segment]) * round_
            depth = float(table.thickness[node]) - gap
            yields = pull**2 / squeezed(table, row, node, depth)[1]
            found.append((node, along / flat, pull * level - yields))
    return found


def _words(name: str, mode: int, square: float, smooth: float) -> str:
    """Say what a mode of omega^2 `square` were without corners, `smooth` [1/s^2]."""
    return (
        f"in mode {mode + 1} a rope slides over {name!r}, where its segments make bumps: with them the mode "
        f"{_rate(square)}, without them it {_rate(smooth)}, to first order"
    )


def _rate(square: float) -> str:
    if square < 0.0:
        return f"grows, x e in {1.0 / math.sqrt(-square):.3g} s"
    return f"is at {math.sqrt(square) / (2.0 * math.pi):.3g} Hz"
