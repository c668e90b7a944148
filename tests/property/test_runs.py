"""Random scenes: they end with a result or a clear error, and keep the laws of mechanics."""

from __future__ import annotations

import re

import numpy as np
import pytest
from hypothesis import HealthCheck, Phase, assume, given, settings
from hypothesis import strategies as st

from ropewalk.core.status import BROKEN, OK, UNSOLVED
from ropewalk.methods.recording import bends
from ropewalk.methods.registry import METHODS
from ropewalk.scene import Anchor, Load, Points, Rope, Scene, SceneError, Springs
from ropewalk.scene.at_nodes import Kick
from ropewalk.simulation import Broken, Simulation
from ropewalk.simulation.block import Block, join
from strategies import ALL_METHODS, axes, numbers, scenes, vectors

RELAXED = settings(
    max_examples=60,
    deadline=None,
    suppress_health_check=[HealthCheck.too_slow],
    phases=(Phase.explicit, Phase.reuse, Phase.generate),  # shrinking whole runs takes minutes
    derandomize=True,
)
MOST_STEPS = 20_000
# NaN: nothing has this extreme, or several ropes do
MISSING = ("extremes", "extreme_since", "extreme_until", "error_times")
SOLVING = tuple(name for name in ALL_METHODS if name == "auto" or METHODS[name].implicit)
STEADY = tuple(name for name, method in METHODS.items() if method.fixed)


def started(scene: Scene) -> Simulation | None:
    """A simulation of a random scene, or None where it is refused or too long for a test."""
    try:
        simulation = Simulation(scene)
    except SceneError:
        return None
    plan = simulation.plan
    return simulation if plan.steps <= MOST_STEPS else None


def whole(simulation: Simulation) -> Block:
    return join([simulation.recording(), *simulation.frames()])


def not_finite(block: Block) -> list[str]:
    """What is recorded with a number that is not finite."""
    named = zip(block.recording._fields, block.recording, strict=True)
    return [name for name, array in named if not (name in MISSING or np.isfinite(array).all())]


def ends_well(scene: Scene) -> None:
    """Every good frame is finite, in all that it holds; a run that breaks says so and stops there, and one
    that finds no solution says where.
    """
    simulation = started(scene)
    if simulation is None:
        return
    block = whole(simulation)
    assert block.status in (OK, BROKEN, UNSOLVED)
    assert not_finite(block) == []
    assert (np.diff(block.time) > 0.0).all()
    assert (block.status == UNSOLVED) == (simulation.failure != "")
    if block.status == OK:
        assert block.frames == simulation.plan.frames + 1
    else:
        assert block.frames <= simulation.plan.frames
    if block.status == UNSOLVED:
        assert re.match(
            r"\S+ (found no solution of step \d+|needs steps below)", simulation.failure
        )
        assert re.search(r" (node|segment) \d+ of rope .*\. (Try|Keep) ", simulation.failure)


@RELAXED
@given(scenes())
def test_a_random_scene_ends_with_a_result_or_an_error(scene: Scene) -> None:
    ends_well(scene)


@pytest.mark.slow
@settings(RELAXED, max_examples=300)
@given(scenes(methods=SOLVING))
def test_many_random_scenes_end_where_forces_are_solved_for(scene: Scene) -> None:
    ends_well(scene)


@RELAXED
@given(scenes())
def test_stepping_never_goes_on_with_nan(scene: Scene) -> None:
    """The stepwise form raises Broken, never anything else, and never goes on with NaN."""
    simulation = started(scene)
    assume(simulation is not None)
    assert simulation is not None
    for _ in range(min(3, simulation.plan.frames)):
        try:
            simulation.step()
        except Broken:
            assert simulation.failure == "" or np.isfinite(simulation.positions).all()
            return
        assert np.isfinite(simulation.positions).all()


@RELAXED
@given(scenes())
def test_works_add_up_to_the_kinetic_energy(scene: Scene) -> None:
    """The ledger closes to round-off for any scene, up to the last good frame: relative to the largest
    energy or work that went through it, times the number of steps.
    """
    simulation = started(scene)
    assume(simulation is not None)
    assert simulation is not None
    block = whole(simulation)
    kinetic, work = block.recording.energy[:, 0], block.recording.work
    jumps = block.recording.jump.sum(axis=1)
    # jumps of limiter and winch count as they are; what turns a clamp goes into the bends' energy
    laws = np.delete(work, (6, 7, 9) if bends(simulation.arrays) else (6, 7), axis=1)
    residual = kinetic - kinetic[0] - laws.sum(axis=1) - jumps
    # a stiff rope that starts squeezed holds far more than its nodes ever get: its rounding counts, too
    stored = np.abs(block.recording.energy[:, 2:]).sum(axis=1)
    size = np.maximum.accumulate(kinetic + stored + np.abs(work).sum(axis=1) + np.abs(jumps)) + 1e-3
    steps = simulation.plan.steps_per_frame * np.arange(block.frames) + 1.0
    assert (np.abs(residual) <= 1e-14 * size * steps + 1e-12 * size).all()
    # the twin: half of the weight's work left out is seen, where weight worked at all
    if np.abs(work[:, 2]).max() > 1e-3 * size[-1]:
        wrong = residual + 0.5 * work[:, 2]
        assert not (np.abs(wrong) <= 1e-14 * size * steps + 1e-12 * size).all()


@st.composite
def plain_scenes(draw: st.DrawFn) -> Scene:
    """One stable rope in space, some nodes held, any method, without gravity or with it."""
    n = draw(st.integers(1, 6))
    steps = draw(st.lists(axes(), min_size=n, max_size=n))
    places = np.concatenate([[draw(vectors(2.0))], np.array(steps)])
    places = np.cumsum(places, axis=0)
    assume((np.linalg.norm(np.diff(places, axis=0), axis=1) > 0.3).all())
    speeds = draw(st.lists(vectors(2.0), min_size=n + 1, max_size=n + 1))
    held = draw(st.lists(st.integers(0, n), max_size=2, unique=True))
    friction = draw(st.sampled_from(["vector", "axial"]))
    rope = Rope(
        segments=n,
        made_of=Springs(
            spring_constant=50.0,
            node_mass=0.2,
            spring_friction=draw(numbers(0.0, 0.3)),
            segment_length=draw(numbers(0.3, 1.5)),
            friction=friction,
        ),
        shape=Points(points=places.tolist()),
        kicks=[Kick(node=i, velocity=v) for i, v in enumerate(speeds)],
        loads=draw(
            st.lists(st.builds(Load, node=st.integers(0, n), mass=numbers(0.1, 1)), max_size=2)
        ),
    )
    run = {
        "duration": 0.1,
        "frame_rate": 100.0,
        "time_step": 1e-3,
        "method": draw(st.sampled_from(STEADY)),
    }
    gravity = draw(vectors(10.0))
    return Scene(ropes=[rope], anchors=[Anchor(node=i) for i in held], gravity=gravity, run=run)


def moved(scene: Scene, turn: np.ndarray, shift: np.ndarray) -> Scene:
    """The same scene seen from elsewhere."""
    rope = scene.ropes[0]
    places = np.array(rope.shape.points) @ turn.T + shift
    kicks = [Kick(node=k.node, velocity=turn @ np.array(k.velocity)) for k in rope.kicks]
    return scene.replace(
        ropes=[rope.replace(shape=Points(points=places.tolist()), kicks=kicks)],
        gravity=tuple(turn @ np.array(scene.gravity)),
    )


def rotation(axis: tuple[float, float, float], angle: float) -> np.ndarray:
    """Rodrigues' formula."""
    x, y, z = np.array(axis) / np.linalg.norm(axis)
    W = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * W + (1 - np.cos(angle)) * W @ W


def end(scene: Scene) -> tuple[np.ndarray, np.ndarray]:
    simulation = Simulation(scene)
    block = whole(simulation)
    assume(block.status == OK)
    return simulation.positions.copy(), simulation.velocities.copy()


@RELAXED
@given(plain_scenes(), axes(), numbers(-3.0, 3.0), vectors(5.0))
def test_the_laws_know_no_place_and_no_direction(scene, axis, angle, shift) -> None:
    """Turned and shifted, a scene moves turned and shifted: rounding, times what 100 steps of a
    chain near folding can amplify. The twin: turned without its gravity.
    """
    turn, shift = rotation(axis, angle), np.array(shift)
    x, v = end(scene)
    there = moved(scene, turn, shift)
    xt, vt = end(there)
    assert np.abs(xt - (x @ turn.T + shift)).max() < 1e-7
    assert np.abs(vt - v @ turn.T).max() < 1e-5
    gravity = np.array(scene.gravity)
    if len(scene.anchors) == 0 and np.abs(turn @ gravity - gravity).max() > 0.1:
        xw, _ = end(there.replace(gravity=scene.gravity))
        assert np.abs(xw - xt).max() > 1e-5


@RELAXED
@given(plain_scenes())
def test_a_rope_has_no_direction(scene) -> None:
    """Numbered from its other end, the rope moves alike. The twin: only its speeds are swapped."""
    rope = scene.ropes[0]
    n = rope.segments
    back = rope.replace(
        shape=Points(points=rope.shape.points[::-1]),
        kicks=[Kick(node=n - k.node, velocity=k.velocity) for k in rope.kicks],
        loads=[Load(node=n - load.node, mass=load.mass) for load in rope.loads],
    )
    anchors = [Anchor(node=n - anchor.node) for anchor in scene.anchors]
    x, v = end(scene)
    xb, vb = end(scene.replace(ropes=[back], anchors=anchors))
    assert np.abs(xb[::-1] - x).max() < 1e-7
    assert np.abs(vb[::-1] - v).max() < 1e-5
    speeds = np.array([k.velocity for k in rope.kicks])
    if not scene.anchors and np.abs(speeds - speeds[::-1]).max() > 0.5:
        half = back.replace(kicks=[Kick(node=k.node, velocity=k.velocity) for k in rope.kicks])
        assert np.abs(end(scene.replace(ropes=[half], anchors=anchors))[0][::-1] - x).max() > 1e-7
