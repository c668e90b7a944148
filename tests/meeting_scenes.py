"""Cords beside each other that may meet, and what islands of them have."""

from __future__ import annotations

import numpy as np

from ropewalk.engine.engine import Engine
from ropewalk.scene import (
    Anchor,
    Contact,
    Kick,
    Material,
    Points,
    Rope,
    RunSettings,
    Scene,
    Straight,
)
from ropewalk.simulation import Simulation
from ropewalk.simulation.block import Block, join

METHODS = (
    "implicit-euler",
    "sdirk2",
    "bdf2",
    "esdirk3",
    "adaptive",
    "semi-implicit-euler",
    "verlet",
)
FRAME = 1.0 / 60.0


def rope(name: str, y: float, kick: float = 0.0, segments: int = 6, **more: object) -> Rope:
    """A cord of 3 m along x, of which a node is kicked across, or all are thrown back."""
    stuff = Material(EA=1e4, mass_per_length=0.2, axial_damping=5.0)
    nodes = range(segments + 1) if kick < 0.0 else [segments // 2]
    kicks = [Kick(node=k, velocity=(0.0, kick, 0.0)) for k in nodes if kick]
    given = {
        "made_of": stuff,
        "diameter": 0.02,
        "length": 3.0,
        "segments": segments,
        "kicks": kicks,
    }
    return Rope(name=name, shape=Straight(start=(0.0, y, 0.0)), **(given | more))  # type: ignore[arg-type]


def scene(ropes: list[Rope], method: str, duration: float = 6 * FRAME) -> Scene:
    """All held by both ends that are not thrown; steps of a frame, or 1/400 of it."""
    step = FRAME if method not in ("semi-implicit-euler", "verlet") else FRAME / 400
    run = RunSettings(method=method, duration=duration, frame_rate=60.0, time_step=step)
    if method == "adaptive":
        run = run.replace(tolerance=1e-4, time_step="auto")
    anchors = [
        Anchor(name=f"{one.name}{k}", rope=one.name, node=k)
        for one in ropes
        if len(one.kicks) < 2
        for k in (0, -1)
    ]
    return Scene(
        ropes=ropes, anchors=anchors, contact=Contact(friction=0.2), run=run, gravity=(0, 0, -1e-3)
    )


def groups(simulation: Simulation) -> list[tuple[str, ...]]:
    engine = simulation._engine
    if isinstance(engine, Engine):
        return [tuple(one.name for one in simulation.scene.ropes)]
    return [tuple(one.name for one in share.scene.ropes) for share in engine.shares]


def whole(simulation: Simulation) -> Block:
    return join([simulation.recording(), *simulation.frames()])


def check_same(one: Simulation, first: Block, other: Simulation, second: Block, names: str) -> None:
    """All that is recorded of some ropes has the same bits in two runs, as long as both go on."""
    frames = min(first.frames, second.frames)
    for name in names:
        a, b = one.layout.span(name), other.layout.span(name)
        for kind, last in (("x", 1), ("v", 1), ("speed_high", 1), ("contact", 1), ("tension", 0)):
            here = getattr(first.recording, kind)[:frames, ..., a.first : a.last + last]
            there = getattr(second.recording, kind)[:frames, ..., b.first : b.last + last]
            if kind == "contact" and not here.shape[-1]:  # there is nothing to touch
                here = np.zeros_like(there)
            assert np.array_equal(here, there), (name, kind)


def crossing(y: float) -> Points:
    return Points(points=[(1.5, y, 0.25 * k - 0.75) for k in range(7)])
