"""A sentence about a run whose nodes were so fast that one may have passed through an obstacle."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from ropewalk.laws.obstacle import radius_of, surface_speed
from ropewalk.record.extremes import Extreme
from ropewalk.record.obstacle_table import obstacle_table
from ropewalk.scene.obstacles import thinnest

if TYPE_CHECKING:
    from ropewalk.record.result import Result


def pass_note(result: Result, fastest: Extreme) -> str:
    """Say which obstacle a node may have passed through, at the largest speed of all; else ""."""
    scene, plan = result.scene, result.plan
    table = obstacle_table(scene, result.layout)
    step = plan.dt if plan.longest is None else result.facts.step_counts.get("longest", 0.0)
    if table is None or not math.isfinite(fastest.value):
        return ""
    thick = max(radius_of(rope) for rope in scene.ropes)
    for row, body in enumerate(scene.obstacles):
        radius = thinnest(body) + thick
        way = step * (fastest.value + surface_speed(table, row))
        if way > radius:
            return (
                f"a node that meets obstacle {body.name!r} at it goes {1e3 * way:.3g} mm in a step of "
                f"{1e3 * step:.3g} ms, more than its radius ({1e3 * radius:.3g} mm): look whether one has "
                f"passed through it, or take steps of at most {1e3 * step * radius / way:.2g} ms"
            )
    return ""
