"""Equal ropes side by side: each is recorded to the same bits as by itself."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from unittest import mock

import numpy as np
import pytest

from property.test_islands import alone, whole
from ropewalk.core.arrays import Floats
from ropewalk.core.jit import PLAIN
from ropewalk.engine import crews
from ropewalk.engine.crews import Crew, Mate, crews_of
from ropewalk.engine.islands import Islands
from ropewalk.methods.starts import USED
from ropewalk.record.simulate import simulate_in_memory
from ropewalk.scene import Anchor, Rope, RunSettings, Scene, Slack, Springs, Straight, Velocity
from ropewalk.simulation import Simulation

METHODS = ("sdirk2", "esdirk3", "implicit-euler", "implicit-midpoint")


def springs(rng: np.random.Generator, axial: bool = False) -> Springs:
    """Return springs of any stiffness, with and without friction."""
    return Springs(
        spring_constant=10.0 ** rng.uniform(2.0, 6.0),
        node_mass=10.0 ** rng.uniform(-2.5, -1.0),
        spring_friction=float(rng.choice([0.0, 10.0 ** rng.uniform(-2.0, 1.0)])),
        segment_length=0.1,
        friction="axial" if axial else "vector",
    )


def ropes_of(seed: int, ropes: int, segments: int, method: str, steps: int = 20) -> Scene:
    """Return equal ropes of all kinds of springs, places, anchors and motions, moved by hand-made anchors."""
    rng = np.random.default_rng(seed)
    made, anchors = [], []
    for k in range(ropes):
        name, y = f"rope{k}", float(k)
        length = 0.1 * segments
        taut = rng.uniform() < 0.3
        end = (length * rng.uniform(0.5, 0.97), y, 0.1 * length * rng.normal())
        shape = Straight(start=(0, y, 0), end=end) if taut else Slack(start=(0, y, 0), end=end)
        made.append(Rope(name=name, segments=segments, made_of=springs(rng), shape=shape))
        if rng.uniform() < 0.8:
            anchors.append(Anchor(name=f"first{k}", rope=name, node=0))
        if rng.uniform() < 0.5:
            more = {"release_time": rng.uniform(0.0, 0.3)} if rng.uniform() < 0.5 else {}
            begin = rng.uniform(0.0, 0.2)
            moved = Velocity(
                velocity=tuple(rng.normal(size=3)), start=begin, stop=begin + rng.uniform(0.01, 0.2)
            )
            more |= {"motion": moved} if rng.uniform() < 0.5 else {}
            anchors.append(Anchor(name=f"last{k}", rope=name, node=-1, **more))
    frame = int(rng.integers(1, 4))
    run = RunSettings(
        method=method,
        time_step=1.0 / 60.0,
        frame_rate=60.0 / frame,
        duration=steps // frame * frame / 60.0,
    )
    return Scene(ropes=made, anchors=anchors, run=run)


def by_themselves(mates: Sequence[Mate], ended: Floats) -> list[Crew]:
    return [Crew([k], False) for k in range(len(mates))]


@contextmanager
def each_by_itself() -> Iterator[None]:
    """Let every rope of a scene move by itself."""
    with mock.patch.object(crews, "crews_of", by_themselves):
        yield


def starts(simulation: Simulation) -> float:
    """Return how many stages were begun where they were found to end."""
    engine = simulation._engine
    assert isinstance(engine, Islands)
    return float(sum(one.scratch.starts.known[USED] for one in engine.engines))


def check(scene: Scene) -> float:
    """Compare all that is recorded and kept with ropes by themselves; return how many starts were of use."""
    together, apart = Simulation(scene), Simulation(scene)
    found = whole(together)
    with each_by_itself():
        expected = whole(apart)
    assert found.frames == expected.frames
    for name in found.recording._fields:
        here, there = getattr(found.recording, name), getattr(expected.recording, name)
        assert here.tobytes() == there.tobytes(), name
    assert together._engine.inner.tobytes() == apart._engine.inner.tobytes()
    assert starts(apart) == 0.0
    return starts(together)


@pytest.mark.skipif(PLAIN, reason="without the compiler ropes move by themselves")
@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("ropes", [5, 8, 9, 17])
def test_ropes_abreast_have_the_bits_of_ropes_by_themselves(ropes: int, method: str) -> None:
    """Twin: without starts that were of use nothing would have been compared."""
    used = 0.0
    for seed, segments in enumerate((2, 3, 4, 7, 10, 20, 50)):
        used += check(ropes_of(100 * ropes + seed, ropes, segments, method))
    assert used > 40.0 * ropes


@pytest.mark.skipif(PLAIN, reason="without the compiler ropes move by themselves")
def test_a_rope_abreast_has_the_bits_of_one_in_a_scene_of_its_own() -> None:
    for seed, segments in ((7, 12), (8, 13)):
        simulation = Simulation(ropes_of(seed, 5, segments, "sdirk2"))
        found = whole(simulation).recording
        for rope in simulation.scene.ropes:
            own = whole(alone(simulation, rope.name)).recording
            span = simulation.layout.span(rope.name)
            for name, last in (("x", span.last + 1), ("v", span.last + 1), ("tension", span.last)):
                here = getattr(found, name)[..., span.first : last]
                assert here.tobytes() == getattr(own, name).tobytes(), (rope.name, name)
        assert starts(simulation) > 20.0


@pytest.mark.skipif(PLAIN, reason="without the compiler ropes move by themselves")
def test_one_that_breaks_leaves_the_others_as_they_are() -> None:
    """The third of five is torn apart by its anchor. Twin: it is the only one."""
    rng = np.random.default_rng(3)
    soft = springs(rng).model_copy(update={"spring_constant": 1.0, "node_mass": 0.01})
    shapes = [Slack(start=(0, k, 0), end=(0.9, k, 0)) for k in range(5)]
    made = [
        Rope(name=f"rope{k}", segments=10, made_of=soft if k == 2 else springs(rng), shape=shape)
        for k, shape in enumerate(shapes)
    ]
    away = Velocity(velocity=(1e4, 0, 0), start=0.1)
    anchors = [Anchor(name=f"a{k}", rope=f"rope{k}", node=0) for k in range(5)]
    anchors.append(Anchor(name="away", rope="rope2", node=-1, motion=away))
    run = RunSettings(method="sdirk2", time_step=1.0 / 60.0, frame_rate=60, duration=0.5)
    scene = Scene(ropes=made, anchors=anchors, run=run)
    together = simulate_in_memory(scene)
    with each_by_itself():
        apart = simulate_in_memory(scene)
    assert together.ends == apart.ends
    assert len(together.ends) == 1
    assert together.frames == apart.frames == 31
    for name in ("positions", "velocities", "tension"):
        here, there = getattr(together, name), getattr(apart, name)  # NaN where it has ended
        assert np.asarray(here).tobytes() == np.asarray(there).tobytes(), name


@pytest.mark.skipif(PLAIN, reason="without the compiler ropes move by themselves")
def test_hands_and_pauses_change_no_bit() -> None:
    """A force by hand, an anchor taken in hand, and a state gone back to and changed."""

    def run() -> bytes:
        simulation = Simulation(ropes_of(11, 6, 9, "sdirk2"))
        simulation.advance_steps(5)
        middle = simulation.state
        simulation.advance_steps(1)
        simulation.restore(middle)
        simulation.velocities[3] += 0.1
        simulation.advance_steps(1)
        simulation.apply_force(2, (0.0, 0.3, 0.2), "rope1")
        simulation.advance_steps(4)
        simulation.anchors["first0"].velocity = (0.0, 0.5, 0.0)
        simulation.advance_steps(4)
        return simulation.positions.tobytes() + simulation.velocities.tobytes()

    together = run()
    with each_by_itself():
        assert run() == together


def test_who_moves_with_whom() -> None:
    """Equal ropes in eights, others by themselves, and none with one that has ended."""
    scene = ropes_of(5, 11, 6, "sdirk2")
    other = scene.ropes[3].replace(segments=7)
    scene = scene.replace(ropes=[*scene.ropes[:3], other, *scene.ropes[4:]])
    engine = Simulation(scene)._engine
    assert isinstance(engine, Islands)
    ended = np.zeros(11)
    ended[[0, 5]] = 1.0
    found = crews_of(engine._crews.mates, ended)
    if PLAIN:
        assert all(not crew.abreast and len(crew.numbers) == 1 for crew in found)
        return
    assert [crew.numbers for crew in found if crew.abreast] == [[1, 2, 4, 6, 7, 8, 9, 10]]
    assert sorted(crew.numbers for crew in found if not crew.abreast) == [[0], [3], [5]]
