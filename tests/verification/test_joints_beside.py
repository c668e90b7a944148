"""Joints beside winches, and beside a stretch limiter."""

from __future__ import annotations

import math

import numpy as np
import pytest

from ropewalk.api import simulate
from ropewalk.methods.registry import METHODS
from ropewalk.scene import Anchor, Limiter, Material, Points, Rope, RunSettings, Scene, Winch
from ropewalk.simulation import Simulation
from verification.joined import cut, run, star, tie, uncut
from verification.test_joints import together


@pytest.mark.parametrize("speed", [-0.5, 0.5])
@pytest.mark.parametrize("method", METHODS)
def test_a_winch_winds_a_tied_rope_as_the_uncut_one(method: str, speed: float) -> None:
    """Over a node that comes on to the drum, or goes off it, to rounding; energies, too."""
    steps = {"tolerance": 1e-4, "time_step": "auto"} if method == "adaptive" else {}
    if method == "euler":  # it gains energy in longer ones
        steps = {"time_step": 2e-5}
    ends, works, masses = [], [], []
    for scene, rope in ((uncut(method), "rope"), (cut(method), "first")):
        wound = scene.replace(
            winches=[Winch(rope=rope, end="start", speed=speed)],
            run=scene.run.replace(duration=0.5, **steps),
        )
        simulation = Simulation(wound, ledger=True)
        before = int(simulation.arrays.winch_exit[0])
        simulation.step(0.5)
        assert abs(simulation.arrays.winch_exit[0] - before) == 1
        ends.append(simulation.arrays.x[:, -5:].copy())
        works.append(simulation.arrays.work.winch.copy())
        masses.append(simulation.arrays.mass.sum())
    assert np.abs(ends[1] - ends[0]).max() < (1e-8 if method == "adaptive" else 1e-10)
    assert works[1] == pytest.approx(works[0], rel=1e-6)
    assert masses[1] == pytest.approx(masses[0], rel=1e-12)


@pytest.mark.parametrize("method", ["verlet", "esdirk3"])
def test_a_tied_node_stays_off_the_drum(method: str) -> None:
    """The winch stands with half a segment left to it, and says so; untied it winds on."""
    scene = cut(method)
    first, second = scene.ropes
    knot = tie("knot", ("first", 2), ("second", 0))
    shape = Points(points=[(0.36, 0.04 + 0.02 * i, 1.04 - 0.19 * i) for i in range(5)])
    made = scene.replace(
        ropes=[first, second.replace(shape=shape, kicks=[])],
        joints=[knot],
        winches=[Winch(rope="first", end="start", speed=-0.5)],
        run=scene.run.replace(duration=2.0),
    )
    simulation = Simulation(made)
    simulation.step(0.8)
    assert simulation.winches["winch0"].stopped_by == "held node"
    working = simulation.arrays.rest_length[simulation.arrays.winch_exit[0]]
    assert working == pytest.approx(0.1, abs=1e-9)
    assert together(simulation)
    simulation.cut_joint("knot")
    simulation.step(0.3)
    assert simulation.winches["winch0"].stopped_by == ""


@pytest.mark.parametrize("method", [name for name in METHODS if METHODS[name].holds_links])
def test_bounds_of_the_stretch_hold_in_a_net_of_ropes(method: str) -> None:
    """A load falls into three slack legs that give next to nothing; without the limiter they give a lot."""
    steps = {"tolerance": 1e-4, "time_step": "auto"} if method == "adaptive" else {}
    free = star(method, load=2.0)
    free = free.replace(run=free.run.replace(duration=1.0, **steps))
    bound = free.replace(limiter={"min_stretch": 0.5, "max_stretch": 1.01})
    most = {}
    for name, scene in (("free", free), ("bound", bound)):
        result = simulate(scene)
        assert result.status == "finished"
        lengths = np.linalg.norm(np.diff(result.positions, axis=1), axis=2)
        legs = [slice(7 * k, 7 * k + 6) for k in range(3)]
        nominal = 1.0 / 6.0
        most[name] = max(float(lengths[:, leg].max()) for leg in legs) / nominal
        scale = max(float(np.abs(values).max()) for values in result.energy.values())
        assert result.table["largest balance residual [J]"] < 1e-9 * scale
    assert most["free"] > 1.05
    assert most["bound"] < 1.01 + 1e-6


EXPLICIT = [name for name, method in METHODS.items() if not method.implicit]


@pytest.mark.parametrize("method", EXPLICIT)
def test_a_limited_rope_that_is_cut_and_joined_moves_as_the_uncut_one(method: str) -> None:
    """Bounds on both sides of a knot are put right in one order and stopped together, to rounding. The twin:
    without the limiter they move otherwise.
    """
    ends, pulls = [], []
    step = 2e-5 if method == "euler" else 1e-3  # it gains energy in longer ones
    for scene in (uncut(method), cut(method), uncut(method)):
        bound = None if ends[1:] else Limiter(min_stretch=0.9, max_stretch=1.02)
        settings = scene.run.replace(duration=0.5, time_step=step)
        simulation = Simulation(scene.replace(limiter=bound, run=settings), ledger=True)
        simulation.step(0.5)
        ends.append(simulation.arrays.x[:, -4:].copy())
        pulls.append(simulation.arrays.work.limiter.copy())
    assert np.abs(ends[1] - ends[0]).max() < 1e-9
    assert pulls[1] == pytest.approx(pulls[0], rel=1e-6)
    assert pulls[0][0] < -1e-3  # it has acted, and takes
    assert np.abs(ends[2] - ends[0]).max() > 1e-2


@pytest.mark.parametrize("method", ["semi-implicit-euler", "rk4"])
def test_bounds_in_a_star_that_flies_keep_momentum_and_make_up_no_energy(method: str) -> None:
    """Four ropes tied in a knot, whose free ends are flung apart: impulses are inner forces, and only take;
    those of the knot on its nodes add up to nothing.
    """
    scene = star(method, legs=4, load=0.3)
    rng = np.random.default_rng(5)
    ropes = [
        rope.replace(kicks=[{"node": 0, "velocity": tuple(4.0 * rng.normal(size=3))}])
        for rope in scene.ropes
    ]
    made = scene.replace(
        ropes=ropes,
        anchors=[],
        gravity=(0.0, 0.0, 0.0),
        limiter={"min_stretch": 0.5, "max_stretch": 1.02, "passes": 50},
        run=scene.run.replace(duration=1.0, time_step=2e-4),
    )
    simulation = Simulation(made, ledger=True)
    state, most, moved = simulation.arrays, 1.0, 0.0
    before = (state.mass * state.v).sum(axis=1)
    for _ in range(100):
        kinetic = float(state.work.limiter[0])
        simulation.step(0.01)
        assert state.work.limiter[0] <= kinetic + 1e-12
        lengths = np.linalg.norm(np.diff(state.x, axis=1), axis=0)
        inside = state.rest_length > 0.0
        most = max(most, float((lengths[inside] / state.rest_length[inside]).max()))
        moved = max(moved, float(np.abs(state.joint_force).max()))
        assert np.abs(state.joint_force.sum(axis=0)).max() < 1e-9 * max(moved, 1.0)
        assert together(simulation)
    assert state.work.limiter[0] < -0.1
    assert (state.mass * state.v).sum(axis=1) == pytest.approx(before, abs=1e-11)
    assert 1.015 < most < 1.021


def test_the_anchor_of_a_limited_star_carries_all_that_hangs() -> None:
    """A load on ropes that hang at their bounds by a knot and a rope to the anchor: its reaction is the
    weight, and the knot pulls every rope with what hangs below.
    """
    soft = Material(EA=5.0, mass_per_length=0.1, axial_damping=1.0)
    places = [((0, 0, 0), (0, 0, -0.5)), ((0, 0, -0.5), (0, 0, -1.0))]
    ropes = [
        Rope(
            name=name,
            segments=5,
            length=0.5,
            made_of=soft,
            shape=Points(points=list(np.linspace(*ends, 6).tolist())),
            loads=loads,
        )
        for name, ends, loads in zip("ab", places, ([], [{"node": -1, "mass": 2.0}]), strict=True)
    ]
    scene = Scene(
        ropes=ropes,
        anchors=[Anchor(rope="a", node=0)],
        joints=[tie("knot", ("a", -1), ("b", 0))],
        limiter={"min_stretch": 0.5, "max_stretch": 1.05, "passes": 50},
        run=run("semi-implicit-euler", duration=3.0, time_step=1e-4, frame_rate=100.0),
    )
    result = simulate(scene)
    assert result.positions[-1, -1, 2] == pytest.approx(-1.05, abs=2e-3)
    assert result.reactions[-1, 0] == pytest.approx([0, 0, 2.1 * 9.81], rel=1e-6, abs=1e-9)
    assert result.joint_force("knot")[-1, 1] == pytest.approx([0, 0, 2.05 * 9.81], rel=2e-2)
    assert result.joint_force("knot")[-1].sum(axis=0) == pytest.approx([0, 0, 0], abs=1e-9)


@pytest.mark.filterwarnings("error:divide by zero encountered in divide")
def test_rigid_links_tied_to_a_rope_that_waits_on_a_drum_start_in_silence() -> None:
    """Nodes on a drum have no mass, and no impulse of a start: one over it was warned of."""
    soft, rigid = (Material(EA=EA, mass_per_length=0.1) for EA in (1e4, math.inf))
    ropes = [
        Rope(name="wound", segments=2, length=1.0, made_of=soft,
             shape={"kind": "straight", "end": (0, 0, -1)}),
        Rope(name="links", segments=2, length=1.0, made_of=rigid,
             shape={"kind": "straight", "start": (0, 0, -1), "end": (0, 0, -2)},
             kicks=[{"node": -1, "velocity": (1.0, 0.0, -1.0)}]),
    ]  # fmt: skip
    knot = {"points": [{"rope": "wound", "node": -1}, {"rope": "links", "node": 0}]}
    simulation = Simulation(
        Scene(
            ropes=ropes, anchors=[Anchor(rope="wound", node=0)], joints=[knot],
            winches=[Winch(rope="wound", end="start", speed=0.1, on_drum=1.0)],
            run=RunSettings(method="bdf2", time_step=1e-3),
        )
    )  # fmt: skip
    rates = np.diff(simulation.arrays.v[2, -3:])
    assert np.abs(rates).max() < 1e-11  # the kick along the links is shared
