"""Ropes that nothing ties together: each moves to the same bits alone and beside any other."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import HealthCheck, Phase, assume, given, settings
from hypothesis import strategies as st

from ropewalk.engine import islands
from ropewalk.engine.partition import partition
from ropewalk.laws.slides.table import DRUM
from ropewalk.lowering import build
from ropewalk.record.simulate import simulate_in_memory
from ropewalk.scene import (
    Anchor,
    Joint,
    Kick,
    Material,
    Rope,
    Scene,
    SceneError,
    Slack,
    Slide,
    Straight,
    Velocity,
    Winch,
)
from ropewalk.scene.joint import tied_ropes
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


def alone(simulation: Simulation, *ropes: str) -> Simulation:
    """A simulation of one rope of another's scene, or of all that tie each other, with the same plan."""
    scene = simulation.scene
    part = scene.replace(
        ropes=[one for one in scene.ropes if one.name in ropes],
        anchors=[anchor for anchor in scene.anchors if anchor.rope in ropes],
        winches=[winch for winch in scene.winches if winch.rope in ropes],
        joints=[joint for joint in scene.joints if joint.points[0].rope in ropes],
        slides=[slide for slide in scene.slides if slide.rope in ropes],
    )
    return Simulation(replace(build(part), plan=simulation.plan))


@st.composite
def tied(draw: st.DrawFn, scene: Scene) -> Scene:
    """Such a scene with ropes that slide along some of its ropes, or hang in joints from them."""
    made_of = Material(EA=500.0, mass_per_length=0.05, axial_damping=0.2)
    ropes, joints, slides = list(scene.ropes), [], []
    try:
        model = build(scene)
    except SceneError:
        assume(False)
    for line, span in zip(scene.ropes, model.layout.ropes, strict=True):
        how = draw(st.sampled_from(["alone", "slide", "joint"]))
        if how == "alone" or (how == "slide" and line.segments < 2):
            continue
        start, speed = model.state.x[:, span.end].tolist(), model.state.v[:, span.end].tolist()
        drawn = Straight(start=start, direction=(0, 0, -1), velocity=speed)
        segments = draw(st.integers(1, 3))
        rider = Rope(
            name=f"{line.name}2", segments=segments, length=0.2, made_of=made_of, shape=drawn
        )
        ropes.insert(draw(st.integers(0, len(ropes))), rider)
        if how == "slide":
            at = draw(st.floats(0.2, 0.8)) * line.length_unstretched
            slides.append(Slide(rope=rider.name, on=line.name, at=at, friction=0.1))
        else:
            points = [{"rope": line.name, "node": -1}, {"rope": rider.name, "node": 0}]
            joints.append(Joint(points=points))
    assume(len(ropes) > len(scene.ropes))
    try:
        return scene.replace(ropes=ropes, joints=joints, slides=slides, limiter=None)
    except SceneError:  # as of a joint at a drum
        assume(False)


def whole(simulation: Simulation) -> Block:
    return join([simulation.recording(), *simulation.frames()])


def check_neighbours(scene: Scene) -> None:
    """Compare every rope, or group of tied ones, with itself alone, to the last bit of its records."""
    try:
        simulation = Simulation(scene)
    except SceneError:
        return
    assume(simulation.plan.steps <= MOST_STEPS)
    together = whole(simulation)
    rows = {name: row for row, name in enumerate(simulation.layout.anchor_names)}
    groups, ends = tied_ropes(scene.ropes, scene.joints, scene.slides), []
    for group in groups:
        names = [scene.ropes[i].name for i in group]
        one = alone(simulation, *names)
        single = whole(one)
        ends.append(single.frames)
        found, own = together.recording, single.recording
        frames = min(single.frames, together.frames)
        held = [rows[name] for name in one.layout.anchor_names]
        pairs = [(simulation.layout.span(name), one.layout.span(name)) for name in names]
        nodes = [(np.r_[a.first : a.last + 1], np.r_[b.first : b.last + 1]) for a, b in pairs]
        segments = [(np.r_[a.first : a.last], np.r_[b.first : b.last]) for a, b in pairs]
        for kind, places in (
            (("x", "v", "speed_high", "lowest", "highest"), nodes),
            (
                ("tension", "elastic_tension", "tension_low", "tension_high", "stretch_high"),
                segments,
            ),
        ):
            for name in kind:
                for here, there in places:
                    first = getattr(found, name)[:frames, ..., here]
                    assert np.array_equal(first, getattr(own, name)[:frames, ..., there]), name
        for name in ("reaction", "reaction_high"):
            first = getattr(found, name)[:frames, held]
            assert np.array_equal(first, getattr(own, name)[:frames]), name
    if len(groups) == len(partition(simulation.model)):
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


@pytest.mark.slow
@settings(RELAXED, max_examples=40)
@given(scenes(max_ropes=3, max_segments=5).flatmap(tied))
def test_ropes_that_slide_and_hang_in_joints_move_to_the_same_bits_beside_others(
    scene: Scene,
) -> None:
    assume(scene.run.ring is None)
    check_neighbours(scene)


@pytest.mark.parametrize("method", ["bdf2", "adaptive", "semi-implicit-euler"])
def test_what_slides_sets_no_pace_for_others(method: str) -> None:
    """Nor do winches on the rope that it slides along: places at drums count in the whole's arrays."""

    def drawn(beside: bool) -> Scene:
        stuff = {"made_of": Material(EA=1e4, mass_per_length=0.5), "diameter": 0.01}
        far = {"made_of": Material(EA=1e5, mass_per_length=0.5), "diameter": 0.01}
        kicks = [Kick(node=3, velocity=(0, 0, 20))]
        down = {"direction": (0, 0, -1)}
        ropes = [
            Rope(name="b", segments=6, length=3, shape=Straight(start=(0, 9, 0)), kicks=kicks, **far),
            Rope(name="c", segments=2, length=0.5, shape=Straight(start=(1.5, 9, 0), **down), **far),
            Rope(name="a", segments=8, length=3, shape=Slack(start=(0, 0, 0), end=(2.8, 0, 0)), **stuff),
            Rope(name="d", segments=2, length=0.5, shape=Straight(start=(1.5, 0, 0), **down), **stuff),
        ]  # fmt: skip
        slides = [Slide(rope="c", on="b", at=1.5), Slide(rope="d", on="a", at=1.4)]
        anchors = [Anchor(rope="b", node=0), Anchor(rope="a", node=0), Anchor(rope="a", node=-1)]
        there = "bcad" if beside else "ad"
        return Scene(
            ropes=[rope for rope in ropes if rope.name in there],
            slides=[slide for slide in slides if slide.on in there],
            anchors=[anchor for anchor in anchors if anchor.rope in there],
            winches=[Winch(rope="a", end="end", speed=0.3)],
            run={"method": method, "duration": 0.1, "frame_rate": 60, "time_step": 1 / 2400},
        )

    one, two = Simulation(drawn(False)), Simulation(drawn(True))
    assert partition(two.model) == [[0, 1], [2, 3]]
    single, both = whole(one).recording, whole(two).recording
    assert len(both.x) == len(single.x)
    for rope in "ad":
        here, there = two.layout.span(rope), one.layout.span(rope)
        assert np.array_equal(
            both.x[..., here.first : here.last + 1], single.x[..., there.first : there.last + 1]
        )
    assert two.arrays.memory.slide.ends[1, DRUM + 1] == two.arrays.winch_exit[0]
    assert np.array_equal(two.arrays.memory.slide.grip[1], one.arrays.memory.slide.grip[0])


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
