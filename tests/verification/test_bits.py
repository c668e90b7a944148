"""The same scene gives the same bits, however it is cut up, recorded or repeated."""

from __future__ import annotations

import subprocess
import sys
from hashlib import sha256
from pathlib import Path

import numpy as np
import pytest

import ropewalk
from ropewalk.methods.recording import Recording
from ropewalk.scene import (
    Air,
    Anchor,
    Ground,
    Limiter,
    Material,
    Rope,
    RunSettings,
    Scene,
    Shake,
    Slack,
    Winch,
)
from ropewalk.simulation import Simulation
from ropewalk.simulation.block import join
from verification.feature_pairs import scene_of
from verification.setups import ALL, EXPLICIT


def everything(method: str, frame_rate: float = 100.0) -> Scene:
    """All laws at once; 30 steps of 1 ms to a third of a second at any dividing frame rate."""
    rope = Rope(
        name="rope",
        segments=10,
        length=2.0,
        made_of=Material(EA=60.0, mass_per_length=0.2, axial_damping=0.02),
        shape=Slack(start=(0, 0, 1), end=(1.4, 0, 1.2)),
        kicks=[{"node": 5, "velocity": (0.3, 2.0, 1.0)}],
    )
    other = rope.replace(name="b", shape={"kind": "straight", "start": (0, 1, 0.5)})
    shake = Shake(axis=(0, 1, 0), amplitude=0.1, frequency=4.0)
    return Scene(
        ropes=[rope, other],
        anchors=[
            Anchor(name="drum", rope="rope", node=0),
            Anchor(name="far", rope="rope", node=-1, motion=shake, release_time=0.2),
            Anchor(name="b", rope="b", node=4, motion={"kind": "hand"}),
        ],
        air=Air(node_drag=0.01, density=1.2, wind=(1, 0, 0)),
        ground=Ground(height=0.4),
        limiter=Limiter(min_stretch=0.5, max_stretch=1.2) if method in EXPLICIT else None,
        winches=[Winch(rope="rope", end="start", speed=1.0)],
        run=RunSettings(
            duration=0.3, frame_rate=frame_rate, time_step=1e-3, steps="exact", method=method
        ),
    )


def same(a: Recording, b: Recording) -> bool:
    return all(np.array_equal(p, q, equal_nan=True) for p, q in zip(a, b, strict=True))


def blocks(scene: Scene, sizes: list[int], **more) -> Recording:
    simulation = Simulation(scene, **more)
    return join([simulation.advance_frames(size) for size in sizes]).recording


BETWEEN = (
    *("tension_low", "tension_high", "stretch_high", "speed_high", "lowest", "highest"),
    *(
        "extremes",
        "extreme_places",
        "extreme_since",
        "extreme_until",
        "reaction_high",
        "moment_high",
        "error_range",
        "error_times",
    ),
)


@pytest.mark.parametrize("method", ALL)
def test_blocks_of_any_size(method: str) -> None:
    """advance_frames(1) n times, advance_frames(n), and anything between; all of the recording.

    The twin: a step 1 % shorter is seen in the first frame.
    """
    scene = everything(method)
    whole = blocks(scene, [30])
    assert same(whole, blocks(scene, [1] * 30))
    assert same(whole, blocks(scene, [7, 1, 20, 2]))
    run = scene.run.replace(time_step=0.99e-3)
    assert not same(whole, blocks(scene.replace(run=run), [30]))


def frames_alone(out: Recording) -> Recording:
    """A recording without what it says of the steps between frames."""
    return out._replace(**{name: np.zeros(0) for name in BETWEEN})


@pytest.mark.parametrize("method", ALL)
def test_recording_rates_and_the_ledger_change_nothing(method: str) -> None:
    """Claim C18: the same steps recorded at other rates, by step(), or without a ledger."""
    often = blocks(everything(method), [30])
    seldom = blocks(everything(method, 20.0), [6])
    assert same(frames_alone(Recording(*(a[4::5] for a in often))), frames_alone(seldom))
    bare = blocks(everything(method), [30], ledger=False)
    assert np.array_equal(often.x, bare.x)
    assert np.array_equal(often.v, bare.v)
    assert not bare.work[:, :6].any()
    silent = Simulation(everything(method))
    for _ in range(30):
        silent.step()
    assert np.array_equal(often.x[-1], silent.arrays.x)
    assert np.array_equal(often.v[-1], silent.arrays.v)
    # the twin: moved a quarter of a frame at a time the steps are others
    other = Simulation(everything(method))
    other.step(0.0015)
    other.step(0.0085)
    assert not np.array_equal(often.x[0], other.arrays.x)


@pytest.mark.parametrize("method", ALL)
def test_restoring_a_state(method: str) -> None:
    """Back to a snapshot and on again: the same bits, after motions, forces, splits and releases."""
    simulation = Simulation(everything(method))
    simulation.advance_frames(10)
    snapshot = simulation.state
    first = simulation.advance_frames(15).recording
    simulation.anchors["b"].velocity = (1, 0, 0)
    simulation.apply_force(3, (0, 0, 5), rope="b")
    changed = simulation.advance_frames(3).recording
    simulation.restore(snapshot)
    assert simulation.time == pytest.approx(0.1)
    assert same(first, simulation.advance_frames(15).recording)
    assert not same(changed, simulation.advance_frames(3).recording)  # the twin
    # a snapshot also restarts another simulation of the same scene
    fresh = Simulation(everything(method))
    fresh.restore(snapshot)
    assert same(first, fresh.advance_frames(15).recording)


def test_two_ropes_are_what_each_is_alone() -> None:
    """The dead segment between ropes carries nothing: rope b alone gives the same bits."""
    scene = everything("semi-implicit-euler")
    both = Simulation(scene)
    both.advance_frames(30)
    alone = Simulation(
        scene.replace(ropes=[scene.ropes[1]], anchors=[scene.anchors[2]], winches=[])
    )
    alone.advance_frames(30)
    span = both.layout.span("b")
    assert np.array_equal(both.positions[span.first :], alone.positions)
    assert not np.array_equal(both.positions[span.first - 11 : span.first], alone.positions)


SCRIPT = """
from hashlib import sha256
from verification.test_bits import everything
from ropewalk.simulation import Simulation
simulation = Simulation(everything("{method}"))
simulation.advance_frames(30)
print(sha256(simulation.arrays.x.tobytes() + simulation.arrays.v.tobytes()).hexdigest())
"""


def test_another_process_gives_the_same_bits() -> None:
    """Kernels from the disk cache, another hash seed, another process."""
    simulation = Simulation(everything("semi-implicit-euler"))
    simulation.advance_frames(30)
    here = sha256(simulation.arrays.x.tobytes() + simulation.arrays.v.tobytes()).hexdigest()

    def elsewhere(method: str) -> str:
        paths = [str(Path(__file__).parents[1]), str(Path(ropewalk.__file__).parents[1])]
        code = f"import sys; sys.path[:0] = {paths!r}\n" + SCRIPT.format(method=method)
        done = subprocess.run(
            [sys.executable, "-c", code], capture_output=True, text=True, check=True
        )
        return done.stdout.strip()

    assert elsewhere("semi-implicit-euler") == here
    assert elsewhere("verlet") != here


def test_frames_stop_and_go_on_to_the_same_bits() -> None:
    """step(1/60) for a game's frame equals the recorder's frame of the plan (60 Hz, 2 ms: 9 steps)."""
    scene = everything("semi-implicit-euler")
    method = "semi-implicit-euler"
    run = RunSettings(duration=0.5, frame_rate=60.0, time_step=0.002, method=method)
    simulation = Simulation(scene.replace(run=run))
    assert simulation.plan.steps_per_frame == 9
    frames = simulation.advance_frames(30).recording
    stepped = Simulation(scene.replace(run=run))
    for frame in range(30):
        stepped.step(1 / 60)
        assert np.array_equal(frames.x[frame], stepped.arrays.x)
    assert stepped.time == pytest.approx(0.5, rel=1e-14)
    stepped.step(1 / 50)  # the twin: another frame length has other steps
    simulation.advance_frames(1)
    assert not np.array_equal(simulation.arrays.x, stepped.arrays.x)


@pytest.mark.parametrize("features", [("rigid links", "kick"), ("rigid links", "limiter")])
def test_restoring_links_of_tied_ropes_in_contact(features: tuple[str, ...]) -> None:
    """What keeps links at a step's end is eliminated in one order, whatever touched in the step before."""
    scene = scene_of("bdf2", "contact", "joint", *features, implicit=True)
    scene = scene.replace(run=scene.run.replace(duration=0.03, frame_rate=100.0))
    simulation, fresh = Simulation(scene), Simulation(scene)
    simulation.advance_frames(1)
    snapshot = simulation.state
    first = simulation.advance_frames(2).recording
    assert not same(first, fresh.advance_frames(2).recording)  # the twin
    for one in (simulation, fresh, Simulation(scene)):
        one.restore(snapshot)
        assert same(first, one.advance_frames(2).recording)
