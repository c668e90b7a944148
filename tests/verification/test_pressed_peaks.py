"""The largest force on obstacles and axles is that of every step, whatever frames are recorded."""

from __future__ import annotations

import os
import signal
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.core.peaks import SQUARE
from ropewalk.engine.slices import Slices
from ropewalk.record.quantities import PRESSED

BODY, AXLE = "largest force on an obstacle", "largest load on the axle of a pulley"
STEP, SHORT = 1 / 9600, 1 / 96000  # [s] 160 of them a frame; of explicit methods


def across(spin: dict[str, Any] | None = None, ropes: int = 1, **run: Any) -> rw.Scene:
    """A rope, or several side by side, that falls across a bar at 5 m/s."""
    made_of = rw.Material(EA=1e4, mass_per_length=0.1, axial_damping=5.0)
    each = [
        rw.Rope(
            name=f"rope{k}", segments=24, length=1.2, diameter=0.01, made_of=made_of,
            shape={"kind": "straight", "start": (-0.6, k, 0.05 + 0.002 * k),
                   "end": (0.6, k, 0.05 + 0.002 * k), "velocity": (0, 0, -5.0)},
        )
        for k in range(ropes)
    ]  # fmt: skip
    bar = {"kind": "cylinder", "from": (0, -1, 0), "to": (0, 9, 0), "radius": 0.03, "friction": 0.3}
    own = {"duration": 0.05, "frame_rate": 60, "method": "esdirk3", "time_step": STEP}
    return rw.Scene(ropes=each, obstacles=[bar | ({"spin": spin} if spin else {})], run=own | run)


def told(scene: rw.Scene, title: str = BODY) -> tuple[float, str]:
    table = rw.simulate(scene).table
    return table[f"{title} [N]"], table[f"{title} at"]


@pytest.mark.parametrize(
    ("method", "step"),
    [
        ("esdirk3", STEP),
        ("implicit-euler", STEP),
        ("verlet", SHORT),
        ("semi-implicit-euler", SHORT),
    ],
)
@pytest.mark.parametrize(("spin", "title"), [(None, BODY), ({"free": True, "inertia": 1e-4}, AXLE)])
def test_the_largest_force_is_that_of_the_same_run_with_a_frame_for_every_step(
    method: str, step: float, spin: dict[str, Any] | None, title: str
) -> None:
    """By frames it was too low by a fifth to a half, without a word. The twin: nothing kept but frames."""
    scene = across(spin, method=method, time_step=step)
    few, when = told(scene, title)
    every, then = told(scene.replace(**{"run.frame_rate": 1 / step}), title)
    assert few == pytest.approx(every, rel=1e-12)
    assert when == then
    assert "recorded frames" not in when
    bare, seen = told(scene.replace(**{"run.extremes": False}), title)
    assert bare < 0.8 * few
    assert "of the recorded frames" in seen
    fine = scene.replace(**{"run.extremes": False, "run.frame_rate": 1 / step})
    assert told(fine, title)[0] == pytest.approx(few, rel=0.01)


def test_accepted_steps_of_the_adaptive_method_are_all_looked_at() -> None:
    """The twin: frames alone."""
    scene = across().replace(
        run={"duration": 0.05, "frame_rate": 60, "method": "adaptive", "tolerance": 1e-6}
    )
    fine = told(across(method="verlet", time_step=2e-6))[0]
    assert told(scene)[0] == pytest.approx(fine, rel=0.01)
    assert told(scene.replace(**{"run.extremes": False}))[0] < 0.8 * fine


def test_ropes_that_move_by_themselves_press_at_most_with_their_sum() -> None:
    """Each has its greatest at its own time. The twin: all in one frame for every step."""
    scene = across(ropes=3)
    most, when = told(scene)
    steps = scene.replace(**{"run.frame_rate": 1 / STEP})
    assert "at most: the greatest of each" in when
    true = told(steps.replace(**{"run.extremes": False}))[0]
    assert 0.99 * true < most < 3.0 * told(across())[0]
    assert told(steps)[0] == pytest.approx(true, rel=0.01)


def test_a_resumed_run_and_an_opened_folder_tell_the_same(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It stops within a frame, after the one with the largest force."""
    scene, calls = across(), list[int]()
    whole = rw.simulate(scene)

    def note(self: Slices, steps: int, seconds: float) -> None:
        self.most = 8
        calls.append(steps)
        if len(calls) == 25:
            os.kill(os.getpid(), signal.SIGINT)

    monkeypatch.setattr(Slices, "note", note)
    with pytest.raises(KeyboardInterrupt):
        rw.run(scene, tmp_path / "run")
    monkeypatch.undo()
    assert rw.Result.open(tmp_path / "run").status == "interrupted"
    rw.resume(tmp_path / "run")
    found = rw.Result.open(tmp_path / "run")
    for name in PRESSED:
        np.testing.assert_array_equal(found.read(name), whole.read(name))
    for row in (f"{BODY} [N]", f"{BODY} at"):
        assert found.table[row] == whole.table[row]


def test_a_simulation_that_is_restored_within_a_frame_has_seen_the_same() -> None:
    simulation = rw.Simulation(across())
    simulation.advance_steps(20)
    kept = simulation.state
    simulation.advance_steps(100)
    first = simulation.arrays.peaks.pressed.copy()
    simulation.restore(kept)
    simulation.advance_steps(100)
    again = simulation.arrays.peaks.pressed
    np.testing.assert_array_equal(first, again)
    assert again[0, SQUARE] > 100.0


def test_what_comes_within_few_steps_says_so_between_frames_too() -> None:
    """The twin: steps that resolve it."""
    coarse = rw.simulate(across(time_step=1 / 600)).table
    assert (
        "within 3 steps" in coarse[f"about the {BODY}"]
        or "largest tension" in coarse[f"about the {BODY}"]
    )
    fine = rw.simulate(
        across({"free": True, "inertia": 1e-4}, method="verlet", time_step=2e-6)
    ).table
    assert f"about the {AXLE}" not in fine
    axle = rw.simulate(across({"free": True, "inertia": 1e-4}, time_step=1 / 600)).table
    assert axle[f"about the {AXLE}"]
