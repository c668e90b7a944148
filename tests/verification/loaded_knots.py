"""Knots that are tied, drawn tight, let go of at their tails and loaded: what they bear, how far they slip.

Whether strands went through each other is looked at in every step, from their places alone (`heaps.passes`).
`knot_tables` makes the tables of the docs from this.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.scene import (
    Air,
    Anchor,
    Contact,
    Cylinder,
    Force,
    Knot,
    Material,
    Rope,
    RunSettings,
    Scene,
    Table,
    Torus,
)
from ropewalk.simulation import Broken, Simulation
from verification.heaps import passes

D = 0.01  # [m]
STEP = 1.0 / 240.0  # [s]
ENOUGH, TIGHT = 700.0, 50.0  # [N] load, and what draws tight
LOOSE = 10.0 * D  # [m] a tail that came so far in does not hold
SPEED = 0.1  # [m/s] at which the load's end goes away
HARD = 1e-5  # [m/N] by default some knots find no step without a pass beyond some hundred newtons
STUFF = {"EA": 1e4, "mass_per_length": 0.08, "axial_damping": 2.0}
DRAG = Air(node_drag=0.02)  # takes the whipping of ends that are let go


@dataclass
class Loaded:
    """What a knot came to under its load."""

    most: float = 0.0  # [N] at the end that is drawn, till the tail came in or the load was enough
    slid: float = 0.0  # [m] that the tail came in since it was let go, then
    passed: int = 0  # pairs of segments that went through each other
    end: str = "slips"  # holds, slips, or what the run broke by

    def __str__(self) -> str:
        """As a cell of the table."""
        if self.end == "slips" and self.most < 10.0:
            return "slips at once"
        way = f"{1e3 * self.slid:.0f} mm"
        return f"{self.end} {'at ' if self.end == 'slips' else ''}{self.most:.0f} N, {way}"


def line(shape: Knot, ends: float, stiffness: float = 0.0) -> Rope:
    """A rope in a knot, of segments of a diameter and ends of so many [m] together."""
    need = shape.tied(D).length + ends
    count = math.ceil(need / D)
    stuff = STUFF | ({"EI": stiffness} if stiffness else {})
    return Rope(
        segments=count, length=count * D, diameter=D, made_of=Material(**stuff), shape=shape
    )


def ends(rope: Rope) -> tuple[list[Floats], list[Floats]]:
    """Places [m] of both ends of such a rope, and the directions out from them."""
    x = np.array(
        rope.shape.places(rope.segments, rope.length_unstretched, rope.segment_length, (0, 0, 1), D)
    )
    return [x[0], x[-1]], [(x[k] - x[j]) / rope.segment_length for k, j in ((0, 1), (-1, -2))]


def drawn(rope: Rope, tight: float, seat: float, obstacle: Any, friction: float) -> Scene:
    """Both ends are drawn out so far [m] at the load's speed, and go on along the load by `seat`.

    Then the last one is let go, and the first one goes on. A tenth of a second of rest is between.
    """
    first, until = tight / SPEED, (tight + seat) / SPEED
    anchors = []
    for node, place, out in zip((0, -1), *ends(rope), strict=True):
        load = out if node == 0 else ends(rope)[1][0]
        ways = [0.0 * out, tight * out, tight * out + seat * load]
        ways += [ways[-1], ways[-1] + load] if node == 0 else [ways[-1]]
        times = [0.0, first, until + 0.001, until + 0.1, until + 0.1 + 1.0 / SPEED][: len(ways)]
        motion = Table(times=times, positions=[(place + way).tolist() for way in ways])
        anchors.append(Anchor(node=node, motion=motion, release_time=until + 0.1 if node else None))
    return Scene(
        gravity=(0, 0, 0),
        ropes=[rope],
        anchors=anchors,
        obstacles=[obstacle],
        contact=Contact(friction=friction, compliance=HARD if friction else None),
        run=RunSettings(method="implicit-euler", time_step=STEP, frame_rate=60),
        air=DRAG,
    )


def tightness(rope: Rope, obstacle: Any, friction: float) -> float:
    """How far both ends have to be drawn out [m] till they bear what draws the knot tight."""
    simulation = Simulation(drawn(rope, 1.0, 0.0, obstacle, friction))
    while simulation.time < 6.0:
        simulation.step(4.0 * STEP)
        tension = simulation.arrays.tension
        if min(tension[:3].mean(), tension[-3:].mean()) > TIGHT:
            break
    return simulation.time * SPEED


def stopper(knot: Any) -> tuple[Any, float, Any, float]:
    """A knot that is drawn against the hole of a ring, through which its rope just goes."""
    hole = Torus(
        center=(-11.5 * D, 1.0 * D if knot == "overhand" else 0.0, 0.0),
        axis=(1, 0, 0),
        radius=1.6 * D,
        bar_radius=0.8 * D,
        compliance=1e-5,
    )
    return Knot(knot=knot), 0.7, hole, 0.06


def bowline() -> tuple[Any, float, Any, float]:
    """Its loop about a post."""
    foot, top = (6.4 * D, 1.0 * D, -0.2), (6.4 * D, 1.0 * D, 0.2)
    return (
        Knot(knot="bowline"),
        0.7,
        Cylinder(start=foot, end=top, radius=1.1 * D, compliance=1e-5),
        0.0,
    )


def half_hitches() -> tuple[Any, float, Any, float]:
    """A round turn about a post and two half hitches about the own standing part."""
    shape = Knot(knot="two-half-hitches", post_radius=2.0 * D, first_end=0.187)
    return shape, 0.53, shape.post(1.0, compliance=1e-5), 0.0


def loaded(knot: str, friction: float, stiffness: float = 0.0) -> Scene:
    """The scene of a knot in the table, drawn tight."""
    shape, spare, obstacle, seat = LOADED[knot]()
    rope, obstacle = line(shape, spare, stiffness), obstacle.replace(friction=friction)
    return drawn(rope, tightness(rope, obstacle, friction), seat, obstacle, friction)


def follow(scene: Scene, seconds: float = 12.0) -> Loaded:
    """Load a knot till its tail has come in, or it bears enough, or so long."""
    simulation, found = Simulation(scene), Loaded()
    free = scene.anchors[1].release_time or 0.0
    nodes = simulation.arrays.x.shape[1]
    links = np.stack([np.arange(nodes - 1), np.arange(1, nodes)], axis=1)
    tail: Floats = np.zeros(3)
    for _ in range(round(seconds / STEP)):
        before = simulation.arrays.x.copy()
        try:
            simulation.step(STEP)
        except Broken as broken:
            found.end = "no step beyond" if "no solution" in str(broken) else "breaks at"
            break
        state = simulation.arrays
        found.passed += passes(before, state.x, links)
        if simulation.time < free + 0.05:
            tail = state.x[:, -1].copy()
            continue
        found.slid = float(np.linalg.norm(state.x[:, -1] - tail))
        if found.slid > LOOSE:
            break
        found.most = max(found.most, float(state.tension[:3].mean()))
        if found.most > ENOUGH:
            found.end = "holds"
            break
    return found


def ratio(scene: Scene, seconds: float = 1.5) -> tuple[float, int]:
    """What the drawn end bears over what the free one is held with, over the last half, and the passes."""
    simulation, held = Simulation(scene), float(np.linalg.norm(scene.ropes[0].forces[0].force))
    nodes = simulation.arrays.x.shape[1]
    links = np.stack([np.arange(nodes - 1), np.arange(1, nodes)], axis=1)
    passed, found = 0, []
    for _ in range(round(seconds / STEP)):
        before = simulation.arrays.x.copy()
        simulation.step(STEP)
        passed += passes(before, simulation.arrays.x, links)
        found.append(float(simulation.arrays.tension[:3].mean()) / held)
    return float(np.mean(found[len(found) // 2 :])), passed


def braked(knot: Any, friction: float, force: float, **sizes: Any) -> Scene:
    """A hitch that is held at its last end by a force [N] while the first one is drawn out."""
    shape = Knot(knot=knot, post_radius=2.0 * D, **sizes)
    rope = line(shape, 0.5)
    places, out = ends(rope)
    rope = rope.replace(forces=[Force(node=-1, force=(force * out[1]).tolist())])
    motion = Table(times=[0.0, 10.0], positions=[places[0].tolist(), (places[0] + out[0]).tolist()])
    post = shape.post(friction=friction, compliance=1e-5)
    return Scene(
        gravity=(0, 0, 0),
        ropes=[rope],
        anchors=[Anchor(node=0, motion=motion)],
        obstacles=[post],
        contact=Contact(friction=friction, compliance=HARD if friction else None),
        run=RunSettings(method="implicit-euler", time_step=STEP, frame_rate=60),
    )


LOADED = {
    "overhand, as a stopper": lambda: stopper("overhand"),
    "figure-eight, as a stopper": lambda: stopper("figure-eight"),
    "bowline, loop about a post": bowline,
    "round turn and two half hitches": half_hitches,
}
