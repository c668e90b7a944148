"""The stretch limiter where forces are solved for: bounds that hold in every stage, with true tensions."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from ropewalk.core.status import OK, UNSOLVED
from ropewalk.methods.recording import LAWS
from ropewalk.methods.registry import METHODS
from ropewalk.methods.stage_report import HISTORY, ITERATIONS
from ropewalk.scene import (
    Anchor,
    Ground,
    Hanging,
    Kick,
    Limiter,
    Material,
    Points,
    Rope,
    RunSettings,
    Scene,
    SceneError,
    Straight,
    Velocity,
)
from ropewalk.simulation import Simulation
from ropewalk.simulation.block import Block, join

ABLE = [name for name in METHODS if METHODS[name].implicit and METHODS[name].holds_links]
FRAME = 1.0 / 60.0
SOFT = Material(EA=20.0, mass_per_length=0.25, axial_damping=0.1)


def swing(method: str, step: float | str = FRAME, duration: float = 1.0, **more: Any) -> Scene:
    """A soft rope of 4 m that is dropped from the horizontal; at 1.02 of its length it goes no farther."""
    keys: dict[str, Any] = {
        "limiter": Limiter(min_stretch=0.9, max_stretch=1.02, passes=20),
        "ropes": Rope(segments=40, length=4.0, made_of=SOFT, shape=Straight(end=(4, 0, 0))),
        "anchors": Anchor(node=0),
    }
    settings = RunSettings(duration=duration, frame_rate=60.0, time_step=step, method=method)
    return Scene(run=settings, **keys | more)


def film(scene: Scene) -> Block:
    simulation = Simulation(scene)
    block = join([simulation.recording(), *simulation.frames()])
    assert block.status == OK, simulation.failure
    return block


def stretches(block: Block, length: float = 0.1) -> np.ndarray:
    """Length over unstretched length of all segments in all frames."""
    return np.asarray(np.sqrt((np.diff(block.recording.x, axis=2) ** 2).sum(axis=1)) / length)


def tip(scene: Scene) -> np.ndarray:
    return film(scene).recording.x[-1, :, -1]


@pytest.mark.parametrize("method", ABLE)
def test_equal_bounds_are_rigid_links(method: str) -> None:
    """With both bounds at 1 a soft rope moves as one of rigid links does, with the same tensions, to what the
    solver leaves. The twin: with bounds of 0.99 and 1.01 it does not.
    """
    rigid = Rope(
        segments=40,
        length=4.0,
        made_of=Material(EA=math.inf, mass_per_length=0.25),
        shape=Straight(end=(4, 0, 0)),
    )
    bare = Rope(
        segments=40,
        length=4.0,
        made_of=Material(EA=20.0, mass_per_length=0.25),
        shape=Straight(end=(4, 0, 0)),
    )
    linked = film(swing(method, ropes=rigid, limiter=None)).recording
    exact = Limiter(min_stretch=1.0, max_stretch=1.0)
    bound = film(swing(method, ropes=bare, limiter=exact)).recording
    assert np.abs(bound.x - linked.x).max() < 1e-8
    assert np.abs(bound.tension - linked.tension).max() < 1e-6 * linked.tension.max()
    loose = Limiter(min_stretch=0.99, max_stretch=1.01)
    other = film(swing(method, ropes=bare, limiter=loose)).recording
    assert np.abs(other.x - linked.x).max() > 1e-2


@pytest.mark.parametrize("method", ABLE)
def test_the_bounds_hold_and_the_ledger_closes(method: str) -> None:
    """Bounds hold to the solver's tolerance in every frame, are met from below and from above, and what stops
    there is booked: the limiter only takes energy. The twin: without it the rope stretches by more.
    """
    squeezed = Limiter(min_stretch=0.995, max_stretch=1.02)
    block = film(swing(method, step=FRAME if METHODS[method].fixed else "auto", limiter=squeezed))
    found = stretches(block)
    assert found.max() == pytest.approx(1.02, abs=1e-10)
    assert found.min() > 0.995 - 1e-10
    if method in ("bdf2", "esdirk3"):  # implicit-euler damps too much to be pressed
        assert found.min() == pytest.approx(0.995, abs=1e-10)
    energy, work = block.recording.energy, block.recording.work
    jumps = block.recording.jump.sum(axis=1)
    forces = [column for column, name in enumerate(LAWS) if name not in ("limiter", "winch")]
    done = work[:, forces].sum(axis=1) + work[:, len(LAWS) :].sum(axis=1) + jumps
    assert np.abs(energy[:, 0] - energy[0, 0] - done).max() < 1e-11
    taken = work[:, LAWS.index("limiter")]
    assert taken[-1] < -0.02
    assert np.abs(energy[:, 0] - energy[0, 0] - done + jumps).max() > 0.02  # not booked, it is seen
    free = film(swing(method, step=FRAME if METHODS[method].fixed else "auto", limiter=None))
    assert stretches(free).max() > 1.05


def test_small_explicit_steps_come_to_the_same_motion() -> None:
    """The explicit limiter acts after each step, an impulse that is inelastic: as its steps become shorter it
    comes to what esdirk3 finds with a 256th of the steps. The twin: other bounds are another motion.
    """
    exact = tip(swing("esdirk3", FRAME / 64))
    errors = [
        float(np.linalg.norm(tip(swing("semi-implicit-euler", FRAME / n)) - exact))
        for n in (64, 512, 4096)
    ]
    assert errors[1] < 0.5 * errors[0]
    assert errors[2] < 0.4 * errors[1]
    assert errors[2] < 5e-3
    # its own error after the impacts is of the size of theirs, and rounding moves it by some tenths
    assert np.linalg.norm(tip(swing("esdirk3", FRAME / 16)) - exact) < 1.5 * errors[2]
    other = Limiter(min_stretch=0.9, max_stretch=1.03, passes=20)
    assert np.linalg.norm(tip(swing("esdirk3", FRAME / 64, limiter=other)) - exact) > 2e-2


def test_the_adaptive_method_comes_to_it_with_the_tolerance() -> None:
    exact = tip(swing("esdirk3", FRAME / 256))
    errors = []
    for tolerance in (1e-4, 1e-6):
        scene = swing("adaptive", "auto")
        scene = scene.replace(run=scene.run.replace(tolerance=tolerance))
        errors.append(float(np.linalg.norm(tip(scene) - exact)))
    assert errors[0] < 2e-2
    assert errors[1] < 1e-3


def test_a_rope_rests_on_its_bounds_with_true_tensions() -> None:
    """0.6 kg on springs that are too soft: what hangs below each segment is its tension, of which the spring
    has EA (1.1 - 1) and the bound the rest; what weighs less is as long as its spring makes it.
    """
    soft = Material(EA=20.0, mass_per_length=0.1, axial_damping=1.0)
    scene = Scene(
        ropes=Rope(segments=6, length=6.0, made_of=soft, shape=Hanging()),
        anchors=Anchor(node=0),
        limiter=Limiter(min_stretch=0.9, max_stretch=1.1),
        run=RunSettings(duration=60.0, time_step=0.1, frame_rate=10.0, method="implicit-euler"),
    )
    last = film(scene).recording
    masses = 0.1 * np.array([1, 1, 1, 1, 1, 0.5])
    below = 9.81 * np.cumsum(masses[::-1])[::-1]
    assert last.tension[-1] == pytest.approx(below, rel=1e-8)
    lengths = -np.diff(last.x[-1, 2])
    assert lengths == pytest.approx(np.minimum(1.0 + below / 20.0, 1.1), rel=1e-9)
    assert (below > 2.0).sum() == 4  # the twin: four rest on the bound, two on their springs
    assert last.reaction[-1, 0, 2] == pytest.approx(0.6 * 9.81, rel=1e-8)


def newton_orders(drag: float = 0.0) -> tuple[list[float], int]:
    """Orders of convergence as `test_implicit` takes them, and how often a segment was at a bound.

    `drag` [N s/m] is put into the tangent alone.
    """
    bare = Material(EA=20.0, mass_per_length=0.25)
    rope = Rope(segments=40, length=4.0, made_of=bare, shape=Straight(end=(4, 0, 0)))
    simulation = Simulation(swing("implicit-euler", 0.1, ropes=rope))
    simulation.system.node.air.node_drag[...] = drag
    report, orders, at_bound = simulation._engine._scratch.stage.report, [], 0
    for _ in range(20):
        simulation.step(0.1)
        at_bound += int(simulation.arrays.forces.limiter.any(axis=0).sum())
        merits = report[HISTORY : HISTORY + int(report[ITERATIONS]) + 1]
        falls = np.log(merits[1:] / merits[:-1])
        kept = (falls[:-1] < -6.0) & (merits[2:] > 1e-21 * merits[0])
        orders += list((falls[1:] / falls[:-1])[kept])
    return orders, at_bound


def test_newton_converges_quadratically_at_the_bounds() -> None:
    """The tangent is exact: near the solution the merit's logarithm falls about twice as far each time. The
    twin: with a tangent that is wrong by a few percent it falls by the same.
    """
    orders, at_bound = newton_orders()
    assert at_bound > 100
    assert len(orders) >= 5
    assert np.mean(orders) > 1.6
    wrong, _ = newton_orders(0.05)
    assert len(wrong) >= 5
    assert np.mean(wrong) == pytest.approx(1.0, abs=0.15)


def test_a_start_beyond_the_bounds_is_brought_within() -> None:
    """Places only, as little as the masses allow: nothing is thrown back. The twin: explicit methods start as
    the scene draws it.
    """
    long = Rope(segments=40, length=4.0, made_of=SOFT, shape=Straight(end=(5, 0, 0)))
    simulation = Simulation(swing("bdf2", ropes=long))
    r = np.linalg.norm(np.diff(simulation.positions, axis=0), axis=1)
    assert r == pytest.approx(np.full(40, 0.102), rel=1e-12)
    assert not simulation.velocities.any()
    simulation.step()
    assert np.abs(simulation.velocities).max() < 1.0  # and no 1 m in a frame
    explicit = Simulation(swing("semi-implicit-euler", "auto", ropes=long))
    r = np.linalg.norm(np.diff(explicit.positions, axis=0), axis=1)
    assert r == pytest.approx(np.full(40, 0.125))


def folded(method: str, limiter: Limiter, step: float, **more: Any) -> Scene:
    """Twelve segments of 1/12 m folded onto each other, thrown about at some 3 m/s."""
    rng = np.random.default_rng(3)
    size = float(limiter.min_stretch + limiter.max_stretch) / 24.0
    along, aside = size * math.cos(0.1), size * math.sin(0.1)
    points = [(along * abs(i % 4 - 2), aside * i, 0.0) for i in range(13)]
    kicks = [Kick(node=i, velocity=tuple(3.0 * rng.normal(size=3))) for i in range(1, 13)]
    rope = Rope(
        segments=12,
        length=1.0,
        made_of=Material(mass_per_length=0.1, **more),
        shape=Points(points=points),
        kicks=kicks,
    )
    settings = RunSettings(
        duration=100 * step, frame_rate=1.0 / step, time_step=step, method=method
    )
    return Scene(run=settings, ropes=rope, anchors=Anchor(node=0), limiter=limiter)


@pytest.mark.parametrize("method", [name for name in ABLE if METHODS[name].fixed])
@pytest.mark.parametrize("tension_only", [False, True])
def test_bounds_never_make_energy(method: str, tension_only: bool) -> None:
    """From folded and thrown states, for EA from 1 to 1e12 N, also with bounds that leave out the natural
    length: every step has a solution, the bounds hold, and kinetic and elastic energy stay below the
    start's and a fall's.
    """
    bounds = [(0.98, 1.02), (0.9, 1.1), (0.5, 1.5), (1.0, 1.0), (1.05, 1.2), (0.7, 0.9)]
    for EA in (1.0, 1e4, 1e12):
        for low, high in bounds:
            for step in (1e-4, 1e-3, 3e-2):
                limiter = Limiter(min_stretch=low, max_stretch=high)
                made = folded(method, limiter, step, EA=EA, tension_only=tension_only)
                simulation = Simulation(made)
                first = simulation.recording().recording.energy[0]
                there = first[0] + first[2] + 2.0 * 0.1 * 9.81
                block = simulation.advance_frames(100)
                assert block.status == OK, simulation.failure
                energy = block.recording.energy
                most = float((energy[:, 0] + energy[:, 2]).max())
                assert most < 1.2 * there, (EA, low, high, step)
                # springs of 1e11 N against a bound leave the solver 1e-9 of a length (`stage.LOOSE`)
                found = stretches(block, 1.0 / 12.0)
                assert low - 1e-8 < found.min() <= found.max() < high + 1e-8


def test_a_rope_that_falls_on_the_ground_gains_nothing() -> None:
    """It was thrown up at kilometres per second by what its bounds gave."""
    rope = Rope(
        segments=20,
        length=4.0,
        made_of=SOFT.replace(tension_only=True),
        shape=Hanging(start=(0, 0, 3.0)),
    )
    limiter = Limiter(min_stretch=0.9, max_stretch=1.02)
    for method in ("esdirk3", "bdf2"):
        made = swing(method, 1.0 / 960.0, ropes=rope, limiter=limiter, anchors=())
        made = made.replace(ground=Ground(height=0.0, repulsion=1000.0))
        simulation = Simulation(made)
        block = join([simulation.recording(), *simulation.frames()])
        assert block.status == OK
        deep = np.minimum(block.recording.x[0, 2], 0.0)
        given = 0.5 * 1000.0 * float((deep**2).sum()) + 9.81 * 3.0
        assert block.recording.energy[:, 0].max() < given


def test_the_first_reaction_carries_the_whole_rope() -> None:
    """A chain that hangs on its bounds from the first frame on; with equal bounds it is known there."""
    rope = Rope(
        segments=6,
        length=6.0,
        made_of=Material(EA=20.0, mass_per_length=0.1),
        shape=Straight(end=(0.0, 0.0, -6.0)),
    )
    made = swing("esdirk3", ropes=rope, limiter=Limiter(min_stretch=1.0, max_stretch=1.0))
    first = Simulation(made).recording().recording
    assert first.reaction[0, 0] == pytest.approx([0.0, 0.0, 0.6 * 9.81])
    assert first.tension[0, 0] == pytest.approx(0.55 * 9.81)


def test_what_is_refused() -> None:
    for method in ("sdirk2", "implicit-midpoint", "generalized-alpha"):
        with pytest.raises(SceneError) as caught:
            Simulation(swing(method))
        assert f'run.method: "{method}" - cannot work with a stretch limiter' in str(caught.value)
        assert "implicit-euler, bdf2, esdirk3, adaptive" in str(caught.value)
    held = [Anchor(name="a", node=0), Anchor(name="b", node=-1)]
    span = Rope(segments=40, length=4.0, made_of=SOFT, shape=Straight(end=(4.2, 0, 0)))
    with pytest.raises(
        SceneError, match=r"anchors 'a' and 'b' are 4\.2 m apart, with 4\.08 m of rope"
    ):
        Simulation(swing("bdf2", ropes=span, anchors=held))
    Simulation(swing("semi-implicit-euler", "auto", ropes=span, anchors=held))  # the twin
    soft = Rope(segments=4, length=4.0, made_of=SOFT.replace(EA=5.0), shape=Hanging())
    rest = swing("bdf2", ropes=soft)
    rest = rest.replace(run=rest.run.replace(start="at-rest"))
    with pytest.raises(
        SceneError, match="at-rest.* segment 0 of rope 'rope' at 2.717 of its length"
    ):
        Simulation(rest)
    Simulation(rest.replace(limiter=Limiter(min_stretch=0.9, max_stretch=3.0)))


@pytest.mark.parametrize("method", ABLE)
def test_anchors_that_part_too_far_end_the_run_and_say_why(method: str) -> None:
    part = [
        Anchor(name="a", node=0),
        Anchor(name="b", node=-1, motion=Velocity(velocity=(0.2, 0.0, 0.0))),
    ]
    simulation = Simulation(swing(method, FRAME if METHODS[method].fixed else "auto", anchors=part))
    block = simulation.advance_frames(60)
    assert block.status == UNSOLVED
    assert 0.3 < simulation.time < 0.45
    assert "at the limiter's max_stretch" in simulation.failure
    assert "a larger max_stretch" in simulation.failure
    assert np.isfinite(block.recording.x).all()
