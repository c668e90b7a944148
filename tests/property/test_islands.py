"""Ropes that nothing ties together: each moves to the same bits alone and beside any other."""

from __future__ import annotations

import copy
import gc
import math
import pickle
import sys
from collections import Counter
from collections.abc import Callable
from dataclasses import replace
from types import FrameType

import numpy as np
import pytest
from hypothesis import HealthCheck, Phase, assume, given, settings

from ropewalk.core.arrays import flatten
from ropewalk.engine import islands
from ropewalk.engine.partition import partition
from ropewalk.lowering import build
from ropewalk.record.simulate import simulate_in_memory
from ropewalk.scene import (
    Anchor,
    Material,
    Plane,
    Rope,
    Scene,
    SceneError,
    Slack,
    Straight,
    Velocity,
)
from ropewalk.simulation import Simulation
from ropewalk.simulation.block import Block, join
from strategies import scenes

RELAXED = settings(
    max_examples=60,
    deadline=None,
    suppress_health_check=[HealthCheck.too_slow, HealthCheck.filter_too_much],
    phases=(Phase.explicit, Phase.reuse, Phase.generate),  # shrinking whole runs takes minutes
    derandomize=True,
)
MOST_STEPS = 5_000


def alone(simulation: Simulation, rope: str) -> Simulation:
    """A simulation of one rope of another's scene, with the same plan."""
    scene = simulation.scene
    part = scene.replace(
        ropes=[one for one in scene.ropes if one.name == rope],
        anchors=[anchor for anchor in scene.anchors if anchor.rope == rope],
        winches=[winch for winch in scene.winches if winch.rope == rope],
    )
    return Simulation(replace(build(part), plan=simulation.plan))


def whole(simulation: Simulation) -> Block:
    return join([simulation.recording(), *simulation.frames()])


def check_neighbours(scene: Scene) -> None:
    """Compare every rope of a scene with itself alone, to the last bit of all that is recorded of it."""
    try:
        simulation = Simulation(scene)
    except SceneError:
        return
    assume(simulation.plan.steps <= MOST_STEPS)
    together = whole(simulation)
    rows = {name: row for row, name in enumerate(simulation.layout.anchor_names)}
    ends = []
    for rope in scene.ropes:
        one = alone(simulation, rope.name)
        single = whole(one)
        ends.append(single.frames)
        span = simulation.layout.span(rope.name)
        found, own = together.recording, single.recording
        frames = min(single.frames, together.frames)
        nodes, segments = slice(span.first, span.last + 1), slice(span.first, span.last)
        held = [rows[name] for name in one.layout.anchor_names]
        for kind, places in (
            (("x", "v", "speed_high", "lowest", "highest"), nodes),
            (
                ("tension", "elastic_tension", "tension_low", "tension_high", "stretch_high"),
                segments,
            ),
            (("reaction", "reaction_high"), held),
        ):
            for name in kind:
                here, there = getattr(found, name)[:frames], getattr(own, name)[:frames]
                here = here[:, held] if places is held else here[..., places]
                assert np.array_equal(here, there), (rope.name, name)
    if len(simulation.scene.ropes) == len(partition(simulation.model)):
        assert together.frames == min(ends)  # the first that breaks ends the run of all
    else:  # ropes in one island have one verdict, by the energy of all
        assert together.frames >= min(ends)


@pytest.mark.slow
@RELAXED
@given(scenes(max_ropes=3, max_segments=5).filter(lambda scene: len(scene.ropes) > 1))
def test_a_rope_moves_to_the_same_bits_alone_and_beside_others(scene: Scene) -> None:
    assume(scene.run.ring is None)
    check_neighbours(scene)


@pytest.mark.slow
@settings(RELAXED, max_examples=200)
@given(scenes(max_ropes=4, max_segments=6).filter(lambda scene: len(scene.ropes) > 1))
def test_many_ropes_move_to_the_same_bits_alone_and_beside_others(scene: Scene) -> None:
    assume(scene.run.ring is None)
    check_neighbours(scene)


@settings(RELAXED, max_examples=30)
@given(scenes(max_ropes=3, max_segments=4).filter(lambda scene: len(scene.ropes) > 1))
def test_a_recorded_rope_breaks_when_it_breaks_alone_and_ends_nobody_else(scene: Scene) -> None:
    assume(scene.run.ring is None)
    try:
        simulation = Simulation(scene)
    except SceneError:
        return
    assume(simulation.plan.steps <= MOST_STEPS)
    together = simulate_in_memory(build(scene))
    for rope in scene.ropes:
        single = simulate_in_memory(alone(simulation, rope.name).model)
        end = together.rope(rope.name).end
        frames = together.frames if end is None else end.frames
        assert single.frames == frames
        assert [one.time for one in single.ends] == ([] if end is None else [end.time])
        own = together.rope(rope.name)
        for name in ("positions", "velocities", "tension"):
            there = getattr(single.rope(), name)
            assert np.array_equal(getattr(own, name)[:frames], there), (rope.name, name)


@pytest.mark.slow
@RELAXED
@given(scenes(max_ropes=3, max_segments=4).filter(lambda scene: len(scene.ropes) > 1))
def test_threads_and_returns_change_no_bit(scene: Scene) -> None:
    """Islands side by side, and a run that was taken back half way, end where one thread alone ends."""
    try:
        simulation = Simulation(scene)
    except SceneError:
        return
    assume(simulation.plan.steps <= MOST_STEPS and simulation.plan.frames > 1)
    half = simulation.plan.frames // 2
    before = islands.threads, islands.LONG
    try:
        islands.threads = 1
        first = simulation.advance_frames(half)
        middle = simulation.state
        last = simulation.advance_frames(simulation.plan.frames - half)
        islands.threads, islands.LONG = 3, -1.0
        simulation.restore(middle)
        again = simulation.advance_frames(simulation.plan.frames - half)
    finally:
        islands.threads, islands.LONG = before
    assume(first.status == 0)
    assert again.status == last.status
    assert again.frames == last.frames
    for name, one, other in zip(
        last.recording._fields, last.recording, again.recording, strict=True
    ):
        assert np.array_equal(one[: last.frames], other[: last.frames], equal_nan=True), name


def test_ropes_share_an_island_where_nothing_can_set_them_apart() -> None:
    """The twin of the tests above: with one island for all of them they would compare too little."""
    ropes = [
        Rope(name=name, segments=3, length=1.0, made_of=Material(EA=1e3, mass_per_length=0.1),
             shape=Slack(start=(0, k, 0), end=(0.9, k, 0)))
        for k, name in enumerate("abcd")
    ]  # fmt: skip
    moved = Velocity(velocity=(0, 0, 1), start=0.1, stop=0.2)
    anchors = [
        Anchor(name="still", rope="a", node=0),
        Anchor(name="moved", rope="b", node=0, motion=moved),
        Anchor(name="let-go", rope="d", node=-1, release_time=0.1),
    ]
    for method, expected in (
        ("verlet", [[0, 2], [1], [3]]),
        ("sdirk2", [[0], [1], [2], [3]]),
        ("adaptive", [[0], [1], [2], [3]]),
    ):
        scene = Scene(ropes=ropes, anchors=anchors, run={"method": method, "time_step": 1e-3})
        assert partition(build(scene)) == expected


def test_faults_at_the_start_name_the_ropes_of_the_whole_scene() -> None:
    """All of them, though every rope starts by itself. The twin: what they are drawn as otherwise."""

    def drawn(*lengths: float) -> Scene:
        ropes = [
            Rope(name=f"line{k}", segments=4, length=1.0,
                 made_of=Material(EA=math.inf if k else 1e3, mass_per_length=0.1),
                 shape=Straight(start=(0, k, 0), end=(length, k, 0)))
            for k, length in enumerate(lengths)
        ]  # fmt: skip
        anchors = [Anchor(rope=rope.name, node=0) for rope in ropes]
        return Scene(ropes=ropes, anchors=anchors, run={"method": "bdf2", "time_step": 1e-3})

    with pytest.raises(SceneError) as caught:
        Simulation(drawn(0.8, 0.8, 1.0, 0.8))
    assert [fault.path for fault in caught.value.faults] == ["rope[1].shape", "rope[3].shape"]
    Simulation(drawn(0.8, 1.0, 1.0, 1.0))


@pytest.mark.parametrize("method", ["sdirk2", "bdf2", "adaptive"])
def test_hands_on_one_rope_leave_the_others_as_they_are(method: str) -> None:
    """Forces, hands on anchors and a pause in between reach the rope that they are for, and no other."""

    def scene(names: str) -> Scene:
        ropes = [
            Rope(name=name, segments=4, length=1.0,
                 made_of=Material(EA=1e3, mass_per_length=0.1, axial_damping=0.5),
                 shape=Slack(start=(0, ord(name) - 97, 0), end=(0.9, ord(name) - 97, 0.1)))
            for name in names
        ]  # fmt: skip
        anchors = [Anchor(name=f"hold-{name}", rope=name, node=0) for name in names]
        run = {"method": method, "time_step": 0.01, "frame_rate": 50, "duration": 1.0}
        return Scene(ropes=ropes, anchors=anchors, run=run)

    def moved(names: str, touched: str) -> dict[str, np.ndarray]:
        simulation = Simulation(scene(names))
        for _ in range(3):
            simulation.step()
        if touched in names:
            simulation.apply_force(2, (0.0, 0.3, 0.2), touched)
            simulation.anchors[f"hold-{touched}"].velocity = (0.0, 0.5, 0.0)
        for _ in range(3):
            simulation.step()
        spans = {name: simulation.layout.span(name) for name in names}
        return {
            name: simulation.positions[span.first : span.last + 1].copy()
            for name, span in spans.items()
        }

    both, still = moved("ab", "a"), moved("ab", "-")
    assert np.array_equal(both["a"], moved("a", "a")["a"])
    assert not np.array_equal(both["a"], still["a"])
    assert np.array_equal(both["b"], still["b"])


def test_no_line_of_building_runs_more_often_for_a_rope_among_many() -> None:
    """No loop over all ropes within one over all ropes: lines run, not seconds, are counted."""

    def lines(count: int, act: Callable[[Scene], object]) -> Counter[tuple[str, int]]:
        ropes = [
            Rope(name=f"rope{k}", segments=2, length=1.0, shape=Slack(start=(0, k, 0), end=(0.9, k, 0)),
                 made_of=Material(EA=1e3, mass_per_length=0.1))
            for k in range(count)
        ]  # fmt: skip
        anchors = [Anchor(rope=rope.name, node=0) for rope in ropes]
        scene = Scene(ropes=ropes, anchors=anchors, run={"method": "sdirk2", "time_step": 0.01})
        seen: Counter[tuple[str, int]] = Counter()

        def look(frame: FrameType, event: str, _: object) -> Callable[..., object] | None:
            if event == "line":
                seen[frame.f_code.co_filename, frame.f_lineno] += 1
            return look if "ropewalk" in frame.f_code.co_filename else None

        before = sys.gettrace()
        sys.settrace(look)
        try:
            act(scene)
        finally:
            sys.settrace(before)
        return seen

    def steep(act: Callable[[Scene], object]) -> list[tuple[str, int]]:
        few, many = lines(10, act), lines(40, act)
        return [line for line, hits in many.items() if hits > 4.5 * few[line] + 40]

    def quadratic(scene: Scene) -> None:
        for rope in scene.ropes:
            scene.rope_index(rope.name)  # goes through all before it

    lines(2, lambda scene: Simulation(build(scene)))  # what is done once
    assert steep(lambda scene: Simulation(build(scene))) == []
    assert steep(quadratic)  # such a line is seen


def hung(method: str, ropes: int) -> Simulation:
    """Cords of four segments that swing from one end each."""
    made_of = Material(EA=1e3, mass_per_length=0.1)
    shapes = [Slack(start=(0, k, 0), end=(0.3, k, 0)) for k in range(ropes)]
    made = [
        Rope(name=f"rope{k}", segments=4, length=0.4, made_of=made_of, shape=shape)
        for k, shape in enumerate(shapes)
    ]
    anchors = [Anchor(name=f"end{k}", rope=f"rope{k}", node=0) for k in range(ropes)]
    return Simulation(Scene(ropes=made, anchors=anchors, run={"method": method, "time_step": 1e-3}))


def bits(simulation: Simulation) -> bytes:
    state = simulation.state
    return b"".join(part.tobytes() for part in (*flatten(state.state).values(), state.inner))


def test_an_island_keeps_how_it_began() -> None:
    """Breaks are explained from there."""
    simulation = hung("rk4", 2)
    begun = simulation.alone(0).model.state.x.copy()
    simulation.advance_frames(2)
    assert np.array_equal(simulation.alone(0).model.state.x, begun)
    assert not np.array_equal(simulation.alone(0).positions.T, begun)


def test_what_is_the_same_of_all_ropes_is_made_once() -> None:
    """Tables of the first rope are those of the second; anchors and flags each has for itself."""
    first, second, *_ = hung("sdirk2", 3)._engine.engines  # type: ignore[union-attr]
    one, other = flatten(first.system), flatten(second.system)
    own = {name for name, array in one.items() if np.size(array) and array is not other[name]}
    assert {name for name in own if not name.startswith("anchors.")} == {"acts", "flags", "gravity"}
    assert not np.array_equal(one["anchors.params"], other["anchors.params"])


def test_no_cycles_are_looked_for_while_ropes_are_built() -> None:
    """Every search went through all that was made so far."""
    model, searches = hung("sdirk2", 200).model, list[str]()

    def note(phase: str, _: object) -> None:
        searches.append(phase)

    gc.collect()
    gc.callbacks.append(note)
    try:
        Simulation(model)
    finally:
        gc.callbacks.remove(note)
    assert searches.count("start") <= 3  # else 44
    assert gc.isenabled()


@pytest.mark.parametrize("method", ["sdirk2", "adaptive", "verlet"])
@pytest.mark.parametrize("ropes", [1, 2])
def test_islands_go_back_to_time_zero(ropes: int, method: str) -> None:
    """A model keeps the start, whatever its simulation does. Twin: where it stands is not the start."""
    simulation = hung(method, ropes)
    start = bits(simulation)
    simulation.step(0.005)
    stands = bits(simulation)
    assert stands != start
    other = Simulation(simulation.model)
    assert bits(other) == start
    other.step(0.002)
    assert bits(simulation) == stands  # what the steps were looked at for, too
    simulation.reset()
    assert bits(simulation) == start


@pytest.mark.parametrize("ropes", [1, 2])
def test_a_force_on_an_island_takes_the_place_of_the_one_before(ropes: int) -> None:
    simulation = hung("sdirk2", ropes)
    for force in (2.0, 0.5):
        simulation.apply_force(3, (force, 0.0, 0.0), "rope0")
    assert simulation.applied_forces[3].tolist() == [0.5, 0.0, 0.0]
    assert simulation.applied_forces.sum() == 0.5


@pytest.mark.parametrize(
    "again", [copy.copy, copy.deepcopy, lambda one: pickle.loads(pickle.dumps(one))]
)
@pytest.mark.parametrize(("method", "ropes"), [("sdirk2", 1), ("sdirk2", 2), ("verlet", 2)])
def test_a_copy_goes_its_own_way_to_the_same_bits(
    method: str, ropes: int, again: Callable[[Simulation], Simulation]
) -> None:
    simulation = hung(method, ropes)
    simulation.step(0.003)
    simulation.anchors["end0"].move_to((0.0, 0.0, 0.1))
    stood = bits(simulation)
    other = again(simulation)
    assert bits(other) == stood
    other.step(0.002)
    assert bits(simulation) == stood
    assert bits(other) != stood
    simulation.step(0.002)
    assert bits(other) == bits(simulation)
    assert other.positions[0].tolist() == [0.0, 0.0, 0.1]


def on_floor(motion: Velocity, ropes: int = 2, friction: float = 0.3) -> Scene:
    """Ropes of 30 cm that lie beside each other on a floor that moves."""
    made_of = Material(EA=2000.0, mass_per_length=0.2, axial_damping=0.5)
    shapes = [Straight(start=(0, k, 0.006), end=(0.3, k, 0.006)) for k in range(ropes)]
    lying = [
        Rope(name=f"rope{k}", segments=3, length=0.3, diameter=0.01, made_of=made_of, shape=shape)
        for k, shape in enumerate(shapes)
    ]
    run = {"method": "esdirk3", "time_step": 5e-3, "frame_rate": 200.0}
    return Scene(ropes=lying, obstacles=[Plane(friction=friction, motion=motion)], run=run)


def test_a_frame_is_read_with_obstacles_where_they_are_now() -> None:
    """Of ropes on a floor that rises what contacts press was read with the floor of the start: 0 N."""
    simulation = Simulation(on_floor(Velocity(velocity=(0.0, 0.0, 0.5)), ropes=2))
    block = simulation.advance_frames(5)
    assert np.array_equal(simulation.recording().recording.contact[-1], block.recording.contact[-1])
    assert simulation.recording().recording.contact[-1, 2].min() > 0.05  # N
