"""Ropes that are thrown at each other, at random, at the frame rate."""

from __future__ import annotations

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.core.arrays import Floats
from ropewalk.laws.pairs.distance import nearest
from ropewalk.scene import (
    Anchor,
    Contact,
    Kick,
    Load,
    Material,
    Points,
    Rope,
    RunSettings,
    Scene,
    SceneError,
    Straight,
)

FRAME = 1.0 / 60.0
DEEPEST = 0.1 + 1e-9  # of a diameter


def line(middle: Floats, along: Floats, bend: float, segments: int) -> Points:
    """A line of 1 m through a point, a little bent."""
    along = along / np.linalg.norm(along)
    aside = np.cross(along, (0.3, 0.5, 0.8))
    place = np.linspace(-0.5, 0.5, segments + 1)[:, None]
    return Points(points=(middle + along * place + aside * bend * np.sin(3 * place)).tolist())


def meeting(seed: int, method: str) -> Scene:
    """Two ropes, thick or thin; one flies at the other, which may be held, at 20 to 50 m/s."""
    random = np.random.default_rng(seed)
    segments, thick = int(random.integers(6, 18)), float(random.uniform(0.006, 0.03))
    EA, speed = float(10 ** random.uniform(2.5, 6)), float(random.uniform(20, 50))
    mass = float(random.uniform(0.03, 0.2))
    stuff = Material(EA=EA, mass_per_length=mass, axial_damping=1e-3 * EA)
    flat = random.normal(size=3) * (1.0, 0.3, 1.0)
    away = np.array([random.uniform(-0.2, 0.2), random.uniform(2 * thick, 0.6) + 0.25, 0.0])
    shapes = (
        line(np.zeros(3), np.array([1.0, 0.0, 0.0]), 0.0, segments),
        line(away, flat, random.uniform(0, 0.1), segments),
    )
    thrown = [Kick(node=i, velocity=(0, -speed, 0)) for i in range(segments + 1)]
    ropes = [
        Rope(
            name=name,
            segments=segments,
            length=1.0,
            diameter=thick,
            made_of=stuff,
            shape=shape,
            kicks=kicks,
        )
        for name, shape, kicks in zip("ab", shapes, ([], thrown), strict=True)
    ]
    held = random.random() < 0.6
    run = RunSettings(method=method, duration=0.2, time_step=FRAME, frame_rate=60.0)
    return Scene(
        ropes=ropes,
        anchors=[Anchor(rope="a", node=node) for node in (0, -1)] if held else [],
        contact={"friction": float(random.uniform(0, 0.5))},
        gravity=(0, 0, 0),
        run=run,
    )


def check_meetings(seeds: range, method: str) -> None:
    """None ends early, is pressed deeper than a tenth of a diameter, or has energy that nobody gave it."""
    touched = 0
    for seed in seeds:
        result = rw.simulate(meeting(seed, method), on_failure="return")
        assert result.status == "finished", (seed, result.diagnosis)
        first, thick = result.scene.ropes[0], result.scene.ropes[0].diameter
        closest = np.inf
        for places in result.positions:
            x, n = np.ascontiguousarray(places.T), first.segments
            pairs = ((i, j) for i in range(n) for j in range(n + 1, 2 * n + 1))
            closest = min(closest, *(nearest(x, x, 0.0, i, j)[2] for i, j in pairs))
        assert closest > (1.0 - DEEPEST) * thick, seed
        touched += closest < thick
        energy, work = result.energy["total"], result.work["contact"]
        assert np.diff(energy).max() < 0.012 * energy[0], seed  # what contacts give back
        assert work.max() < 1e-9 * energy[0], seed
        assert energy.max() < (1.0 + 3e-3) * energy[0], seed  # methods err by 1.3e-3 in flight
    assert touched > len(seeds) / 4


@pytest.mark.parametrize("method", ["implicit-euler", "sdirk2", "bdf2", "esdirk3"])
def test_ropes_that_are_thrown_at_each_other_stop_each_other(method: str) -> None:
    """At 20 to 50 m/s in steps of a frame: up to 0.8 m in a step, with diameters from 6 mm on."""
    check_meetings(range(24), method)


@pytest.mark.slow
@pytest.mark.parametrize("method", ["implicit-euler", "sdirk2", "bdf2", "esdirk3"])
def test_many_ropes_that_are_thrown_at_each_other_stop_each_other(method: str) -> None:
    check_meetings(range(24, 224), method)


def throw(seed: int) -> Scene:
    """Two or three short ropes above each other, some with loads, which fly at the lowest at 1 to 40 m/s."""
    random = np.random.default_rng([seed, 30])
    count = int(random.integers(2, 4))
    EA, damping = float(10 ** random.uniform(3, 5)), float(random.choice([0.0, 0.5]))
    stuff = Material(EA=EA, mass_per_length=0.05, axial_damping=damping)
    speed, ropes, anchors = float(10 ** random.uniform(0, 1.3)), [], []
    for k in range(count):
        segments = int(random.integers(1, 5))
        along = random.normal(size=3)
        along /= np.linalg.norm(along)
        middle = np.array([0, 0, 0.03 * k + random.uniform(0, 0.02)])
        middle += random.normal(size=3) * [0.02, 0.02, 0]
        along[2] *= 0.1
        half = 0.025 * segments * along / np.linalg.norm(along)
        velocity = np.array((0, 0, -speed * k)) + random.normal(size=3) * 0.2 * speed * (k > 0)
        heavy = random.random() < 0.3
        loads = [Load(node=0, mass=float(10 ** random.uniform(-2, 0)))] if heavy else []
        shape = Straight(
            start=tuple(middle - half), end=tuple(middle + half), velocity=tuple(velocity)
        )
        made = {"segments": segments, "length": 0.05 * segments, "diameter": 0.01}
        ropes.append(Rope(name=f"r{k}", made_of=stuff, shape=shape, loads=loads, **made))
        if k == 0 and random.random() < 0.5:
            anchors = [Anchor(rope="r0", node=node) for node in (0, -1)]
    run = RunSettings(method="adaptive", duration=0.15 / speed, frame_rate=400.0 * speed)
    friction = float(random.choice([0, 0.2, 0.5]))
    contact = Contact(friction=friction)
    return Scene(ropes=ropes, anchors=anchors, contact=contact, gravity=(0, 0, 0), run=run)


def test_what_turns_about_what_it_hits_gets_no_energy() -> None:
    """Of ropes that are thrown at random: a contact's points may be elsewhere after a step.

    It was pressed far deeper there than its plane had seen, and gave back what nobody had given: up to 0.31
    of the first energy (of seeds 151 and 210). Where its plane hid 3 % of a diameter and its offset as much,
    0.05 to 0.1 (of seeds 210, 354, 489 and 576), or the run ended (of 317).
    """
    run = 0
    for seed in (*range(140, 160), *range(180, 215), *range(236, 244), 317, 354, 489, 576):
        try:
            result = rw.simulate(throw(seed))
        except SceneError:  # drawn through each other
            continue
        run += 1
        energy, work = result.energy["total"], result.work["contact"]
        assert result.status == "finished", seed
        assert (energy - np.minimum.accumulate(energy)).max() < 0.04 * energy[0], seed
        assert work.max() < 1e-5 * energy[0], seed
        assert result.table["largest balance residual [J]"] < 1e-9 * energy[0], seed
    assert run > 60


@pytest.mark.parametrize("method", ["sdirk2", "rk4"])
@pytest.mark.parametrize("loads", [(1,), (0, 1, 2, 3)])
def test_loads_that_meet_stay_together(method: str, loads: tuple[int, ...]) -> None:
    """Half a kilogram a load on ropes of 15 g: what one brings they share. The contact's damper was that of
    the ropes alone; with `rk4` one load went on at 0.97 m/s and the other stayed behind at 0.03.
    """

    def rider(name: str, x: float, speed: float) -> Rope:
        return Rope(
            name=name,
            segments=3,
            length=0.3,
            diameter=0.02,
            made_of=Material(EA=1e4, mass_per_length=0.05, axial_damping=1.0),
            shape=Straight(start=(x, 0, 0), end=(x, 0, -0.3), velocity=(speed, 0, 0)),
            loads=[Load(node=node, mass=0.5) for node in loads],
        )

    result = rw.simulate(
        Scene(
            ropes=[rider("a", 0.0, 1.0), rider("b", 0.1, 0.0)],
            contact=Contact(friction=0.2),
            gravity=(0.0, 0.0, 0.0),
            run=RunSettings(
                method=method,
                time_step=1 / 60 if method == "sdirk2" else "auto",
                duration=0.3,
                frame_rate=60.0,
            ),
        )
    )
    mass = np.array([0.0025, 0.005, 0.005, 0.0025])
    mass[list(loads)] += 0.5
    slow, fast = (
        float(mass @ result.rope(name).velocities[-1, :, 0] / mass.sum()) for name in "ab"
    )
    assert slow + fast == pytest.approx(1.0, abs=1e-9)
    assert 0.0 <= fast - slow < (0.05 if method == "sdirk2" else 0.5)
