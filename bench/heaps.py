"""Ropes on ropes: a crossing and a pile, here and in MuJoCo, and those of cosseratbench with its scores.

A rope falls across another that is held at both ends, and a cord falls onto a floor. MuJoCo (extra
`ropewalk[bench]`) gets the same ropes as chains of capsules, as in `bench.touch`; what is compared is how
deep ropes are in each other at worst, how far they creep once they should lie (NaN where a run became
unstable), and what a frame costs.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from functools import partial
from importlib.util import find_spec
from itertools import combinations
from typing import Any, NamedTuple

import numpy as np

import ropewalk as rw
from bench.row import Row
from bench.touch import GRAVITY, MUJOCO, STEP
from ropewalk.laws.pairs.distance import nearest
from ropewalk.laws.pairs.law import neighbours
from ropewalk.record.simulate import simulate_in_memory
from ropewalk.scene import Contact, Plane, Rope, Straight

FRICTION, UNTIL, LIES = 0.3, 3.0, 2.0  # [1], [s], [s] when all should lie
SPAN = "held"  # the name of the rope that is held at both ends


class Found(NamedTuple):
    """What a program made of a scene."""

    places: np.ndarray  # (frames, nodes, 3) [m], of all ropes side by side
    seconds: float  # of processor time


def _rope(name: str, segments: int, start: Any, end: Any, diameter: float) -> Rope:
    length = float(np.linalg.norm(np.subtract(end, start)))
    made_of = rw.Material(EA=2e3, mass_per_length=0.05, axial_damping=0.1)
    shape = Straight(start=start, end=end)
    return Rope(
        name=name,
        segments=segments,
        length=length,
        diameter=diameter,
        made_of=made_of,
        shape=shape,
    )


def crossing() -> rw.Scene:
    """Return a rope that falls by 3 cm across the middle of one that is held."""
    low = _rope(SPAN, 40, (-0.2, 0.0, 0.0), (0.2, 0.0, 0.0), 0.01)
    top = _rope("top", 41, (0.0, -0.2, 0.04), (0.0, 0.2, 0.04), 0.01)
    ends = [rw.Anchor(name=name, rope=SPAN, node=k) for name, k in (("a", 0), ("b", -1))]
    return _scene([low, top], [], ends)


def pile() -> rw.Scene:
    """Return a cord that stands nearly upright on a floor, and falls."""
    cord = _rope("cord", 60, (0.0, 0.0, 0.61), (0.003, 0.002, 0.01), 0.006)
    return _scene([cord], [Plane(friction=FRICTION)], [])


def _scene(ropes: list[Rope], bodies: list[Plane], anchors: list[rw.Anchor]) -> rw.Scene:
    run = rw.RunSettings(
        method="implicit-euler", time_step=0.25 * STEP, frame_rate=1.0 / STEP, duration=UNTIL
    )
    contact = Contact(friction=FRICTION)
    return rw.Scene(ropes=ropes, obstacles=bodies, anchors=anchors, contact=contact, run=run)


def in_ropewalk(scene: rw.Scene, _: float) -> Found:
    """Run it here, in the scene's own steps."""
    begun = time.process_time()
    result = simulate_in_memory(scene)
    assert result.status == "finished", result.diagnosis
    return Found(result.positions, time.process_time() - begun)


def in_mujoco(scene: rw.Scene, step: float, options: str) -> Found:
    """Run it as chains of capsules in steps of `step` [s]; NaN from where it becomes unstable."""
    import mujoco

    model = mujoco.MjModel.from_xml_string(as_mujoco(scene, options, step))
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    start = np.array(rw.Simulation(scene).positions)
    begun, frames = time.process_time(), []
    bad = mujoco.mjtWarning.mjWARN_BADQACC
    while data.time < UNTIL - 0.5 * step and data.warning[bad].number == 0:
        if len(frames) * STEP <= data.time:
            frames.append(_nodes(scene, start, data))
        mujoco.mj_step(model, data)
    missing = round(UNTIL / STEP) - len(frames)
    frames += [np.full_like(start, np.nan)] * missing
    return Found(np.array(frames), time.process_time() - begun)


def _nodes(scene: rw.Scene, start: np.ndarray, data: Any) -> np.ndarray:
    """Return the places of all nodes [m]; links are bodies that began unturned."""
    places, first, link = np.empty_like(start), 0, 1
    for rope in scene.ropes:
        n = rope.segments
        places[first : first + n] = data.xpos[link : link + n]
        along = start[first + n] - start[first + n - 1]
        turn = data.xmat[link + n - 1].reshape(3, 3)
        places[first + n] = data.xpos[link + n - 1] + turn @ along
        first, link = first + n + 1, link + n
    return places


def as_mujoco(scene: rw.Scene, options: str, step: float) -> str:
    """Return the scene's ropes, and its floor, as a model."""
    x, first, chains, ties = np.array(rw.Simulation(scene).positions), 0, "", ""
    touch = f'friction="{FRICTION} 0 0" condim="3"'
    for rope in scene.ropes:
        size, mass = 0.5 * rope.diameter, rope.own_mass / rope.segments
        for i in range(rope.segments):
            here, ahead = x[first + i], x[first + i + 1]
            place = here if i == 0 else here - x[first + i - 1]
            joint = '<joint type="ball" damping="1e-5" armature="1e-7"/>'
            if i == 0 and rope.name != SPAN:
                joint = "<freejoint/>"
            chains += (
                f'<body name="{rope.name}{i}" pos="{_text(place)}">{joint}<geom type="capsule" '
                f'size="{size}" fromto="0 0 0 {_text(ahead - here)}" mass="{mass}" {touch}/>'
            )
        chains += "</body>" * rope.segments
        last = first + rope.segments
        if rope.name == SPAN:
            name, end = f"{rope.name}{rope.segments - 1}", _text(x[last] - x[last - 1])
            ties = f'<equality><connect body1="{name}" anchor="{end}"/></equality>'
        first = last + 1
    floor = f'<geom type="plane" size="10 10 1" {touch}/>' if scene.obstacles else ""
    return (
        f'<mujoco><option timestep="{step}" gravity="0 0 {-GRAVITY}" '
        f'integrator="implicitfast" {options}/>'
        f"<worldbody>{floor}{chains}</worldbody>{ties}</mujoco>"
    )


def _text(values: Any) -> str:
    return " ".join(f"{float(value):.12g}" for value in values)


def overlap(scene: rw.Scene, x: np.ndarray) -> float:
    """Return how deep segments at x (nodes, 3) are in each other, or in the floor [1] of a diameter."""
    size = scene.ropes[0].diameter
    ends = np.cumsum([0] + [rope.segments + 1 for rope in scene.ropes])
    each = [(k, j) for k, rope in enumerate(scene.ropes) for j in range(rope.segments)]
    apart = neighbours(scene.ropes[0])
    places, closest = np.ascontiguousarray(x.T), size
    for (k, i), (m, j) in combinations(each, 2):
        if k != m or abs(i - j) > apart:
            distance = nearest(places, places, 0.0, int(ends[k]) + i, int(ends[m]) + j)[2]
            closest = min(closest, distance)
    floor = 0.5 * size - float(x[:, 2].min()) if scene.obstacles else 0.0
    return max(size - closest, floor) / size


def here_and_there() -> list[Row]:
    """A crossing and a pile, here and in MuJoCo, in steps [s] in which that stays stable."""
    programs: dict[str, Callable[[rw.Scene, float], Found]] = {"Ropewalk": in_ropewalk}
    if find_spec("mujoco") is not None:
        for name, options in MUJOCO.items():
            programs[name] = partial(in_mujoco, options=options)
    rows = []
    for case, (scene, step) in {"crossing": (crossing(), 2.5e-4), "pile": (pile(), 1e-3)}.items():
        in_ropewalk(scene.replace(run=scene.run.replace(duration=STEP)), STEP)  # compiles
        for name, run in programs.items():
            places, seconds = run(scene, step)
            lying = round(LIES / STEP)
            deepest = max(overlap(scene, x) for x in places[::2] if np.isfinite(x).all())
            crept = float(np.linalg.norm(places[-1] - places[lying], axis=1).max())
            said = f"{case}, {name}"
            rows.append(Row(f"{said}, deepest overlap", 100.0 * deepest, "% of a diameter", "< 10"))
            rows.append(Row(f"{said}, way from 2 s to 3 s", 1e3 * crept, "mm", "lies"))
            rows.append(Row(f"{said}, per frame of 1/60 s", 1e3 * seconds * STEP / UNTIL, "ms", ""))
    return rows


def ropes_on_ropes() -> list[Row]:
    """Crossing and pile of cosseratbench: its scores, and processor time per frame of 1/60 s."""
    if find_spec("cosseratbench") is None:
        return []
    from cosseratbench.registry import load_experiment

    from ropewalk.adapters.cosserat import RopewalkSolver

    rows = []
    for name in ("crossing", "pile"):
        experiment = load_experiment(name)
        scenario = experiment.scenario_for()
        counts = {"n_elements": experiment.n_elements, "n_frames": experiment.n_frames}
        begun = time.process_time()
        trajectory = RopewalkSolver().run(scenario, **counts)
        spent = time.process_time() - begun
        for score, metric in experiment.metrics.items():
            rows.append(Row(f"cosseratbench {name}, {score}", metric(scenario, trajectory), "", ""))
        each = 1e3 * spent / (60.0 * scenario.duration)
        rows.append(Row(f"cosseratbench {name}, per frame of 1/60 s", each, "ms", ""))
    return rows
