"""Anchors that let go inside an obstacle: what is held touches nothing, and what is let go is thrown out."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats, State, System
from ropewalk.laws.hardening import stored_under
from ropewalk.laws.obstacle import Obstacles
from ropewalk.laws.obstacle_places import depths
from ropewalk.lowering.obstacle_checks import DRAWN
from ropewalk.motions.registry import HAND
from ropewalk.motions.whereabouts import place_now
from ropewalk.scene import Scene, SceneError
from ropewalk.scene.faults import Fault


class Inside(NamedTuple):
    """An anchor that lets go inside an obstacle."""

    anchor: int
    obstacle: int
    depth: float  # [m], half the rope's diameter counted in
    speed: float  # [m/s] at which the contact throws the node out at most, on its own

    @property
    def path(self) -> str:
        """The path of what says when."""
        return f"anchor[{self.anchor}].release_time"


def releases_inside(scene: Scene, system: System, state: State, until: float) -> Iterator[Inside]:
    """Yield the anchors that let go before a time [s] deeper in an obstacle than a drawn rope may start.

    Each in the obstacle that it is deepest in. Not those that a hand moves, nor in what turns freely: where
    these will be is not known.
    """
    table: Obstacles = system.node.obstacle
    if not scene.obstacles:
        return
    known = ~((table.wheel >= 0) & (table.sweeps != 0))
    x = state.x.copy()
    for row, anchor in enumerate(scene.anchors):
        time = math.inf if anchor.release_time is None else anchor.release_time
        if time >= until or not math.isfinite(time) or system.anchors.kind[row] == HAND:
            continue
        node = int(state.anchor_node[row])
        x[:, node] = _place(system, row, time)
        deep = depths(table, x, time)
        at = np.where(known, deep[:, node], -math.inf)
        body = int(at.argmax())
        if at[body] > DRAWN * table.diameter[node]:
            stored = float(stored_under(table, deep)[body, node])
            speed = math.sqrt(2.0 * stored / float(state.mass[node]))
            yield Inside(row, body, float(at[body]), speed)


def _place(system: System, row: int, time: float) -> Floats:
    """Return where an anchor is at a time [s], (3,) [m], on the ground where that stops it."""
    x = np.array(place_now(system.anchors, row, time)[:3])
    ground = system.node.ground
    if system.anchors.above_ground[row] and ground.active:
        up = np.array(ground.up)
        x += max(0.0, float(ground.height - up @ x)) * up
    return x


def refuse_releases(scene: Scene, system: System, state: State, until: float) -> None:
    """Raise SceneError for anchors that let go where the middle of their rope is inside an obstacle."""
    thickness = system.node.obstacle.thickness
    faults = [
        Fault(
            one.path,
            scene.anchors[one.anchor].release_time,
            f"lets go {1e3 * one.depth:.4g} mm inside obstacle {scene.obstacles[one.obstacle].name!r}, half "
            "the rope's diameter counted in: what is held touches nothing, and would be thrown out then; let "
            "go outside, or move the anchor or the obstacle",
        )
        for one in releases_inside(scene, system, state, until)
        if one.depth > float(thickness[state.anchor_node[one.anchor]]) * (1.0 + 1e-9)
    ]
    if faults:
        raise SceneError(faults)
