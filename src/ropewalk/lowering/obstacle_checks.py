"""Scenes with obstacles that cannot be run: methods that ring, ropes inside a body, bodies too fast."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ropewalk.core.arrays import Floats, State, System
from ropewalk.laws.hardening import depth_under
from ropewalk.laws.obstacle import Obstacles, radius_of
from ropewalk.laws.obstacle_places import depths, drawn_places, moves, sweeping_speed, turning_rate
from ropewalk.laws.obstacle_rows import half_thickness
from ropewalk.laws.obstacle_way import LONG, leads_out, lies_across
from ropewalk.lowering.layout import Layout
from ropewalk.lowering.rebound_checks import rebound_faults
from ropewalk.methods.registry import METHODS
from ropewalk.scene import Scene, SceneError
from ropewalk.scene.faults import Fault
from ropewalk.scene.joint import tied_ropes
from ropewalk.scene.motions import Fixed, Shake, Table, Velocity
from ropewalk.scene.obstacles import Cylinder, Obstacle, is_free, thinnest, what_is_thin
from ropewalk.scene.rope import Rope
from ropewalk.words.safe_side import rounded_down

#: [rad] by which an obstacle turns in an automatic step at most.
_FAR = 0.5 * math.pi
_ALONG = 1e-9  # [1] of a way: what of it goes along an axis by rounding
DRAWN = 0.012  # [1] depth over the diameter that a drawn shape may begin with: chords of an arc
#: Length over half the thickness [1]: of what is shorter a node presses before the segment is across.
STAYS_OUT = 1.4
#: Methods that keep stiff modes ringing, so that no contact comes to rest.
RINGING = ("implicit-midpoint", "generalized-alpha")


def touches(method: str) -> bool:
    """Tell whether a method can work with obstacles."""
    return method not in RINGING


def refuse_obstacles(
    scene: Scene, system: System, state: State, layout: Layout, *, drawn: bool = True
) -> None:
    """Raise SceneError for a scene that cannot be run for its obstacles.

    With `drawn` off ropes get other places than those of the state.
    """
    if not scene.obstacles:
        return
    faults = []
    if not touches(scene.run.method):
        able = ", ".join(name for name in METHODS if touches(name))
        rule = (
            "cannot work with obstacles: it keeps stiff modes ringing, so that nothing comes to rest on "
            f"them; methods that can: {able}"
        )
        faults.append(Fault("run.method", scene.run.method, rule))
    faults += rebound_faults(scene, system, state)
    faults += _sharp(scene, system)
    faults += _buried(scene, system, state, layout) if drawn else []
    faults += [] if faults or not drawn else _speared(scene, system, state, layout)
    if faults:
        raise SceneError(faults)


def _sharp(scene: Scene, system: System) -> list[Fault]:
    """Return a fault for every body of sharp edges, where there is a rope without a diameter."""
    rule = (
        "its edges are sharp, and a rope has no diameter, so that forces would jump there: give ropes a "
        "diameter, or this a rounding (m)"
    )
    bare = float(system.node.obstacle.thickness.min(initial=math.inf)) <= 0.0
    return [
        Fault(f"obstacle[{row}].rounding", 0.0, rule)
        for row, body in enumerate(scene.obstacles)
        if bare and thinnest(body) <= 0.0
    ]


def step_past_nodes(scene: Scene, system: System, until: float) -> float:
    """Return an automatic step in which no obstacle moves past nodes, or turns far [s]; inf: none moves.

    Before the time `until` [s], here and below: what moves after the run is of no matter.
    """
    found = (
        0.9 * thin_along(system, row, body, _ways(body))[0] / speed
        for row, (body, speed) in enumerate(_speeds(scene, system, until))
        if speed > 0.0
    )
    rates = (turned_rate(system, row, body, until) for row, body in enumerate(scene.obstacles))
    turns = (_FAR / rate for rate in rates if rate > 0.0)
    return min(*found, *turns, math.inf, math.inf)


def turned_rate(system: System, row: int, body: Obstacle, until: float = math.inf) -> float:
    """Return the largest rate at which an obstacle is turned [rad/s]; of a free one that at the start."""
    table: Obstacles = system.node.obstacle
    if is_free(body):
        return abs(float(table.rate[table.wheel[row]]))
    return float(turning_rate(table, row, until))


def _speeds(scene: Scene, system: System, until: float) -> list[tuple[Obstacle, float]]:
    """Return every obstacle with the largest speed at which its surface leaves its place [m/s]."""
    table: Obstacles = system.node.obstacle
    return [(body, sweeping_speed(table, row, until)) for row, body in enumerate(scene.obstacles)]


def longest_kept_out(body: Obstacle, rope: Rope) -> float:
    """Return the length up to which a rope's segments cannot go through a body between their nodes [m]."""
    return STAYS_OUT * (half_thickness(body) + radius_of(rope))


def radius_with_rope(system: System, body: Obstacle) -> float:
    """Return a body's least radius, with half the diameter of the thinnest rope [m]."""
    return thinnest(body) + float(system.node.obstacle.thickness.min())


def thin_along(
    system: System, row: int, body: Obstacle, ways: ArrayLike | None
) -> tuple[float, str]:
    """Return how thin a body is along `ways` (w, 3) [m], and what that is.

    Half of the thinnest rope is counted in. A disc that moves in its own plane has its radius to go.
    None stands for any way.
    """
    turned = system.node.obstacle.sweeps[row]
    if isinstance(body, Cylinder) and not turned and ways is not None and _across(body, ways):
        return body.radius + radius_with_rope(system, body) - thinnest(body), "radius"
    return radius_with_rope(system, body), what_is_thin(body)


def _across(body: Cylinder, ways: ArrayLike) -> bool:
    """Tell whether all `ways` (w, 3) are across the axis of a cylinder."""
    axis = np.subtract(body.end, body.start)
    along = np.abs(np.asarray(ways) @ axis)
    return bool((along <= _ALONG * np.linalg.norm(ways, axis=1) * np.linalg.norm(axis)).all())


def _ways(body: Obstacle) -> ArrayLike | None:
    """Return the ways of a body's motion (w, 3); None of one that goes any way."""
    match motion := body.motion:
        case Fixed():
            return np.zeros((0, 3))
        case Velocity():
            return [motion.velocity]
        case Shake():
            return [motion.axis]
        case Table():
            ways: Floats = np.diff(motion.positions, axis=0)
            return ways
    return None


def refuse_fast(scene: Scene, system: System, step: float, until: float) -> None:
    """Raise SceneError for obstacles that move past nodes, or turn by more than half, within a step [s]."""
    faults = []
    for row, (body, speed) in enumerate(_speeds(scene, system, until)):
        radius, measure = thin_along(system, row, body, _ways(body))
        if speed * step > radius:
            rule = (
                f"is {1e3 * speed * step:.4g} mm in a step of {1e3 * step:.4g} ms, more than the "
                f"{measure} of {body.name!r} ({1e3 * radius:.4g} mm, the rope's half diameter "
                f"counted in): it would jump over nodes; take a run.time_step of at most "
                f"{rounded_down(radius / speed, 2)} s"
            )
            which = "motion" if moves(system.node.obstacle, row) else "spin"
            faults.append(Fault(f"obstacle[{row}].{which}", f"up to {speed:.4g} m/s", rule))
        rate = turned_rate(system, row, body, until)
        if rate * step > math.pi:
            rule = (
                f"is {math.degrees(rate * step):.4g} degrees in a step of {1e3 * step:.4g} ms: friction "
                "turns with the body, and would point backwards; take a run.time_step of at most "
                f"{rounded_down(math.pi / rate, 2)} s, better a tenth of that"
            )
            faults.append(Fault(f"obstacle[{row}].spin", f"up to {rate:.4g} rad/s", rule))
    if faults:
        raise SceneError(faults)


def _buried(scene: Scene, system: System, state: State, layout: Layout) -> list[Fault]:
    """Return a fault for every rope that starts deeper in an obstacle than it could press itself."""
    table: Obstacles = system.node.obstacle
    deep = depths(table, state.x)
    allowed = squeeze(scene, system, state, layout)
    deep[:, state.inverse_mass == 0.0] = (
        0.0  # an anchor may stand anywhere, with what is tied to it
    )
    faults = []
    for number, span in enumerate(layout.ropes):
        own = slice(span.start, span.end + 1)
        over = np.where(deep[:, own] > allowed[:, own], deep[:, own], 0.0)
        if not over.any():
            continue
        row, node = np.unravel_index(int(np.argmax(over)), over.shape)
        body = scene.obstacles[int(row)]
        rule = (
            f"starts {1e3 * over[row, node]:.4g} mm inside obstacle {body.name!r}, half its diameter "
            "counted in; move the rope or the obstacle"
        )
        faults.append(Fault(f"rope[{number}].shape", f"node {node}", rule))
    return faults


def _speared(scene: Scene, system: System, state: State, layout: Layout) -> list[Fault]:
    """Return a fault for every rope that is drawn with an obstacle between two of its nodes."""
    return [
        Fault(
            f"rope[{number}].shape",
            f"segment {segment}",
            f"goes through obstacle {scene.obstacles[row].name!r} between its two nodes, where nothing holds "
            "it; move the rope or the obstacle, or draw the rope round it with more segments",
        )
        for number, segment, row in through(
            system.node.obstacle, state.x, state.inverse_mass, layout
        )
    ]


def through(
    table: Obstacles, x: Floats, inverse_mass: Floats, layout: Layout
) -> Iterator[tuple[int, int, int]]:
    """Yield ropes at places (3, n) [m] that obstacles lie across: rope, its first such segment, obstacle.

    Not those that come out of a body in which an anchor holds them.
    """
    for number, span in enumerate(layout.ropes):
        ends = x[:, span.start : span.end + 1].T
        size = np.linalg.norm(np.diff(ends, axis=0), axis=1)
        for row in range(len(table.kind)):
            long = np.flatnonzero(size > LONG * (table.thin[row] + table.thickness[span.start]))
            if not long.size:
                continue
            places = drawn_places(table, row, ends)
            across = (
                k
                for k in long.tolist()
                if _crosses(table, row, span.start + k, inverse_mass, places[k : k + 2])
            )
            if (first := next(across, None)) is not None:
                yield number, first, row
                break


def _crosses(table: Obstacles, row: int, i: int, inverse_mass: Floats, places: Floats) -> bool:
    """Tell whether segment i lies across an obstacle, its ends at two places (2, 3) [m] as that is drawn."""
    a, b = tuple(places[0]), tuple(places[1])
    ends = zip(inverse_mass[i : i + 2], (a, b), strict=True)
    if any(leads_out(table, row, inert, end, end) for inert, end in ends):
        return False
    return bool(lies_across(table, row, i, a, b))


def loading_each_other(scene: Scene) -> list[list[int]]:
    """Return the numbers of ropes group by group, of which each may carry the weight of its whole group."""
    together = scene.contact is not None or len(scene.slides) > 0
    together |= any(map(is_free, scene.obstacles))
    if together:
        return [list(range(len(scene.ropes)))]
    return [list(group) for group in tied_ropes(scene.ropes, scene.joints)]


def squeeze(scene: Scene, system: System, state: State, layout: Layout) -> Floats:
    """Return how deep nodes can be pressed in by weight and the tensions at the start [m], (k, n).

    By those of their rope and of all that joints tie to it; of all ropes where some slide, ropes touch, or a
    body turns freely.
    """
    table: Obstacles = system.node.obstacle
    size = np.linalg.norm(np.diff(state.x, axis=1), axis=0)
    gives = np.isfinite(state.stiffness)
    pull = np.where(gives, state.stiffness, 0.0) * np.maximum(size - state.rest_length, 0.0)
    gravity = float(np.linalg.norm(system.gravity))
    force: Any = np.zeros(state.mass.size)  # of each node
    for group in loading_each_other(scene):
        spans = [layout.ropes[k] for k in group]
        weight = sum(float(state.mass[s.first : s.last + 1].sum()) for s in spans) * gravity
        most = max(float(pull[s.first : s.last].max(initial=0.0)) for s in spans)
        for s in spans:
            force[s.first : s.last + 1] = weight + 2.0 * most
    return np.maximum(depth_under(table, force), DRAWN * table.diameter) + 1e-9
