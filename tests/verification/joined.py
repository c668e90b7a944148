"""Scenes of ropes that are tied, for the tests of joints."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from ropewalk.scene import (
    Air,
    Anchor,
    Ground,
    Joint,
    Material,
    Points,
    Rope,
    RunSettings,
    Scene,
    Shake,
    Slack,
    Tie,
)

ROPE = {"EA": 60.0, "mass_per_length": 0.2, "axial_damping": 0.02}
KICK = {"velocity": (0.3, 2.0, 1.0)}


def run(method: str, **more: Any) -> RunSettings:
    """Settings of a short run."""
    settings = {"time_step": 1e-3, "duration": 0.05, "frame_rate": 100.0}
    return RunSettings(method=method, **(settings | more))


def tie(name: str, *points: tuple[str, int]) -> Joint:
    """A joint of (rope, node)."""
    return Joint(name=name, points=[Tie(rope=rope, node=node) for rope, node in points])


def curve() -> list[tuple[float, float, float]]:
    """Nine places on a bent line, near to segments of 0.2 m."""
    return [(0.18 * i, 0.02 * i, 1.0 + 0.01 * i * i) for i in range(9)]


def uncut(method: str, **line: Any) -> Scene:
    """A rope of eight segments, held at its start, one node kicked."""
    rope = Rope(
        name="rope",
        segments=8,
        length=1.6,
        made_of=Material(**(ROPE | line)),
        shape=Points(points=curve()),
        kicks=[{"node": 5} | KICK],
    )
    return Scene(ropes=[rope], anchors=[Anchor(rope="rope", node=0)], run=run(method))


def cut(method: str, **line: Any) -> Scene:
    """The same in two parts, joined end to end."""
    made_of = Material(**(ROPE | line))
    first = Rope(
        name="first", segments=4, length=0.8, made_of=made_of, shape=Points(points=curve()[:5])
    )
    second = first.replace(
        name="second", shape=Points(points=curve()[4:]), kicks=[{"node": 1} | KICK]
    )
    return Scene(
        ropes=[first, second],
        anchors=[Anchor(rope="first", node=0)],
        joints=[tie("knot", ("first", -1), ("second", 0))],
        run=run(method),
    )


def star(method: str, *, legs: int = 3, segments: int = 6, load: float = 0.5, **line: Any) -> Scene:
    """Ropes from a ring of anchors to a knot that carries a load."""
    ropes = []
    for k in range(legs):
        turn = 2.0 * math.pi * k / legs
        shape = Slack(start=(0.8 * math.cos(turn), 0.8 * math.sin(turn), 1.0), end=(0, 0, 0.5))
        loads = [{"node": -1, "mass": load}] if k == 0 and load else []
        made_of = Material(**({"EA": 200.0, "mass_per_length": 0.2} | line))
        ropes.append(
            Rope(
                name=f"leg{k}",
                segments=segments,
                length=1.0,
                made_of=made_of,
                shape=shape,
                loads=loads,
            )
        )
    return Scene(
        ropes=ropes,
        anchors=[Anchor(name=f"top{k}", rope=f"leg{k}", node=0) for k in range(legs)],
        joints=[tie("knot", *((f"leg{k}", -1) for k in range(legs)))],
        run=run(method, duration=0.1),
    )


def loop(method: str, nodes: int = 24, **more: Any) -> tuple[Scene, float]:
    """A closed rope of radius 0.5 m that spins at 6 rad/s without gravity, and its tension [N].

    m w^2 R = 2 T sin(pi / n) of its nodes, m their mass; with many of them T = mu v^2.
    """
    line, stiffness, rate, radius = 0.2, 1e3, 6.0, 0.5
    chord = 2.0 * radius * math.sin(math.pi / nodes)
    over = line * rate**2 * radius / (2.0 * math.sin(math.pi / nodes))  # T / L0
    length = (math.sqrt(stiffness**2 + 4.0 * over * stiffness * chord) - stiffness) / (2.0 * over)
    turns = 2.0 * np.pi * np.arange(nodes + 1) / nodes
    places = [(radius * math.cos(a), radius * math.sin(a), 0.0) for a in turns]
    speeds = [(-rate * y, rate * x, 0.0) for x, y, _ in places]
    rope = Rope(
        segments=nodes,
        length=length * nodes,
        made_of=Material(EA=stiffness, mass_per_length=line),
        shape=Points(points=places),
        kicks=[{"node": i, "velocity": speeds[i]} for i in range(nodes)],
    )
    knot = Joint(name="knot", points=[Tie(node=0), Tie(node=-1)])
    settings = run(method, **({"duration": 0.2} | more))
    return Scene(ropes=[rope], joints=[knot], gravity=(0, 0, 0), run=settings), over * length


def net(cells: int, tension: float = 1.0, pressure: float = 1e-3) -> Scene:
    """A square of 1 m of ropes, `cells` each way, held at its rim; tension [N/m], weight [N/m^2]."""
    h, stiffness = 1.0 / cells, 10.0
    pull = tension * h
    grid = np.arange(cells + 1) * h
    line = pressure * h / (2.0 * 9.81) * (1.0 + pull / stiffness)
    made_of = Material(EA=stiffness, mass_per_length=line)
    ropes, anchors = [], []
    for way in "xy":
        for k in range(1, cells):
            name = f"{way}{k}"
            flat = [(u, k * h, 0.0) if way == "x" else (k * h, u, 0.0) for u in grid]
            shape = Points(points=[tuple(float(c) for c in place) for place in flat])
            length = 1.0 / (1.0 + pull / stiffness)
            ropes.append(
                Rope(name=name, segments=cells, length=length, made_of=made_of, shape=shape)
            )
            anchors += [Anchor(rope=name, node=0), Anchor(rope=name, node=-1)]
    joints = [
        tie(f"k{i}-{j}", (f"x{j}", i), (f"y{i}", j))
        for i in range(1, cells)
        for j in range(1, cells)
    ]
    settings = run("implicit-euler", time_step=1e-2)
    return Scene(ropes=ropes, anchors=anchors, joints=joints, run=settings)


def random_scene(seed: int, method: str) -> Scene:
    """Two to four ropes, tied in a tree or a loop, by chance held, shaken, bent, in air, on ground."""
    random = np.random.default_rng(seed)
    places, ropes, joints = [np.array([0.0, 0.0, 1.0])], list[Rope](), list[list[tuple[str, int]]]()
    for k in range(int(random.integers(2, 5))):
        start = int(random.integers(len(places)))
        segments = int(random.integers(2, 6))
        steps = random.normal(size=(segments, 3))
        steps *= 0.2 / np.linalg.norm(steps, axis=1)[:, None]
        path = places[start] + np.vstack((np.zeros(3), np.cumsum(steps, axis=0)))
        line = {"EA": float(random.choice([20.0, 200.0])), "mass_per_length": 0.2}
        line |= {"axial_damping": float(random.choice([0.0, 0.05]))}
        line |= {"EI": float(random.choice([0.0, 0.002]))}
        line |= {"tension_only": bool(random.uniform() < 0.3)}
        shape = Points(points=[tuple(float(c) for c in place) for place in path])
        ropes.append(
            Rope(
                name=f"rope{k}",
                segments=segments,
                length=0.2 * segments,
                made_of=Material(**line),
                shape=shape,
                loads=[{"node": 1, "mass": 0.05}] if random.uniform() < 0.5 else [],
            )
        )
        if k == 0:
            joints = [[] for _ in range(segments + 1)]
            places = list(path)
            for node in range(segments + 1):
                joints[node].append((f"rope{k}", node))
        else:
            joints[start].append((f"rope{k}", 0))
            joints += [[(f"rope{k}", node)] for node in range(1, segments + 1)]
            places += list(path[1:])
    held = []
    if random.uniform() < 0.7:
        motion = {"kind": "shake", "axis": (0, 1, 0), "amplitude": 0.05, "frequency": 3.0}
        more = {"motion": Shake(**motion)} if random.uniform() < 0.5 else {}
        held.append(Anchor(rope="rope0", node=int(random.integers(2)), **more))
    return Scene(
        ropes=ropes,
        anchors=held,
        joints=[tie(f"joint{i}", *ends) for i, ends in enumerate(_tied(joints))],
        gravity=(0, 0, -9.81) if held else (0, 0, 0),
        air=Air(node_drag=0.02) if held and random.uniform() < 0.3 else None,
        ground=Ground(height=0.7) if held and random.uniform() < 0.3 else None,
        run=run(method, time_step=5e-4, duration=0.03, frame_rate=200.0),
    )


def _tied(joints: Sequence[list[tuple[str, int]]]) -> list[list[tuple[str, int]]]:
    return [ends for ends in joints if len(ends) > 1]
