"""What hands change in the whole comes to islands that may meet, though what is unchanged is not carried."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from ropewalk.core.arrays import flatten
from ropewalk.engine.exchange import Carried
from ropewalk.engine.meetings import Meetings
from ropewalk.laws.pairs.table import CONTACTS, PUSH
from ropewalk.scene import Contact, Kick, Material, Plane, Rope, RunSettings, Scene, Straight
from ropewalk.simulation import Simulation

FRAME = 1.0 / 60.0


def scene(method: str) -> Scene:
    """Six cords of two lengths above a plane; two of them lie across each other, two meet later on."""
    stuff = Material(EA=1e4, mass_per_length=0.2, axial_damping=5.0)
    at = [(0.0, 0.0, 0.02), (0.3, -0.4, 0.0405), (5.0, 0.0, 0.3), (5.0, 0.3, 0.3), (9.0, 0.0, 1.0)]
    ways = [(1.0, 0.0, 0.0), (0.0, 1.0, 0.0), *[(1.0, 0.0, 0.0)] * 3]
    ropes = [
        Rope(
            name=f"r{k}",
            made_of=stuff,
            diameter=0.02,
            length=1.0,
            segments=5 + k % 2,
            shape=Straight(start=start, direction=way),
            kicks=[Kick(node=j, velocity=(0.0, 2.0 if k == 2 else 0.0, 0.0)) for j in range(6)],
        )
        for k, (start, way) in enumerate(zip(at, ways, strict=True))
    ]
    run = RunSettings(method=method, duration=1.0, frame_rate=60.0, time_step=FRAME / 2)
    if method == "adaptive":
        run = run.replace(tolerance=1e-3, time_step="auto")
    ground = Plane(name="ground", friction=0.3)
    return Scene(ropes=ropes, run=run, contact=Contact(friction=0.3), obstacles=[ground])


def _throw(simulation: Simulation) -> None:
    simulation.arrays.v[2, -4:] += 0.5


def _push(simulation: Simulation) -> None:
    simulation.apply_force(2, (0.0, 0.0, 0.3), "r4")


def _let_be(simulation: Simulation) -> None:
    simulation.apply_force(2, (0.0, 0.0, 0.0), "r4")


def _book(simulation: Simulation) -> None:
    simulation.arrays.work.limiter[0] += 0.25


def _forget(simulation: Simulation) -> None:
    simulation.arrays.past[0] = 0.0


def _press(simulation: Simulation) -> None:
    memory = simulation.arrays.memory.contact
    assert memory.tally[CONTACTS] > 0
    memory.grip[: memory.tally[CONTACTS], PUSH] *= 0.5


HANDS: list[Callable[[Simulation], None]] = [_throw, _push, _book, _forget, _press, _let_be]


@pytest.mark.parametrize("method", ["implicit-euler", "bdf2", "adaptive"])
def test_what_is_carried_is_what_has_changed(method: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Beside a run that carries all in every call; the runs without a hand are others."""
    one, other, still = (Simulation(scene(method)) for _ in range(3))
    engine: Any = other._engine
    assert isinstance(engine, Meetings)
    assert len(engine.engines) == 4
    for hand in HANDS:
        for simulation in (one, other):
            hand(simulation)
        first, alone = one.advance_frames(2), still.advance_frames(2)
        with monkeypatch.context() as patch:
            patch.setattr(Carried, "is_told", lambda *_: False)
            engine._held = []
            second = other.advance_frames(2)
        for a, b in zip(first.recording, second.recording, strict=True):
            assert np.array_equal(a, b, equal_nan=True)
        there = flatten(other.state.state)
        for name, part in flatten(one.state.state).items():
            assert np.array_equal(part, there[name], equal_nan=True), name
        assert np.array_equal(one.state.inner, other.state.inner, equal_nan=True)
        assert not np.array_equal(first.recording.v, alone.recording.v)
    assert len(engine.engines) < 4
    assert one.arrays.work.limiter[0] == pytest.approx(0.25)
