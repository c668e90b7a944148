"""Ropes that are tied: against the uncut rope, closed forms and the membrane, and what must be kept."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.api import simulate
from ropewalk.live import edits
from ropewalk.live.carry import carry_over
from ropewalk.live.segments import resegment
from ropewalk.lowering import build
from ropewalk.lowering.steps import predicted_step
from ropewalk.methods.registry import METHODS
from ropewalk.scene import Anchor, Material, Points, Rope, Scene, SceneError, Tie
from ropewalk.scene.toml_text import dumps, loads
from ropewalk.simulation import Simulation
from ropewalk.statics import static_shape
from ropewalk.vibration import modes
from verification.joined import cut, loop, net, random_scene, star, tie, uncut

EXPLICIT = [name for name, method in METHODS.items() if not method.implicit and method.fixed]
SOLVING = [name for name in METHODS if name not in EXPLICIT]
INF = math.inf


def together(simulation: Simulation) -> bool:
    """Tell whether all nodes of every joint are at one place, at one velocity, to the last bit."""
    joints, state = simulation.system.joints, simulation.arrays
    for first, last in zip(joints.first[:-1], joints.first[1:], strict=True):
        member = joints.member[first:last]
        for values in (state.x, state.v):
            if (values[:, member] != values[:, member[:1]]).any():
                return False
    return True


def final(scene: Scene, duration: float = 0.05) -> Simulation:
    """Step a scene."""
    simulation = Simulation(scene)
    simulation.step(duration)
    return simulation


# -- the cut rope -----------------------------------------------------------------------------


@pytest.mark.parametrize("method", METHODS)
def test_a_rope_that_is_cut_and_joined_moves_as_the_uncut_one(method: str) -> None:
    """To rounding; the anchor feels the same. The twin is not joined, and its parts fall apart."""
    whole, parts = final(uncut(method)), final(cut(method))
    there, here = whole.arrays, parts.arrays
    assert together(parts)
    assert np.abs(np.delete(here.x, 5, axis=1) - there.x).max() < 1e-12
    assert np.abs(np.delete(here.v, 5, axis=1) - there.v).max() < 1e-10
    assert np.abs(here.reaction - there.reaction).max() < 1e-9
    # the joint pulls with the tension of the rope and half of the inertia, on both with the same force
    assert np.abs(here.joint_force.sum(axis=0)).max() < 1e-13
    assert np.linalg.norm(here.joint_force[0]) > 0.1
    twin = final(cut(method).replace(joints=[]))
    assert np.abs(twin.arrays.x[:, 4] - twin.arrays.x[:, 5]).max() > 1e-4


@pytest.mark.parametrize("stiffness", [1e9, INF])
def test_stiff_and_rigid_ropes_are_joined_as_well(stiffness: float) -> None:
    """To 1e-10 of the uncut rope, in few iterations."""
    places = np.cumsum([(0, 0, 0)] + [(0.12, 0.0, 0.16 * (-1) ** i) for i in range(8)], axis=0)
    points = [tuple(float(c) for c in place) for place in places]
    whole, parts = uncut("esdirk3", EA=stiffness), cut("esdirk3", EA=stiffness)
    whole = whole.replace(ropes=[whole.ropes[0].replace(shape=Points(points=points))])
    first, second = parts.ropes
    parts = parts.replace(
        ropes=[
            first.replace(shape=Points(points=points[:5])),
            second.replace(shape=Points(points=points[4:])),
        ]
    )
    there, here = final(whole).arrays, final(parts).arrays
    assert np.abs(np.delete(here.x, 5, axis=1) - there.x).max() < 1e-10
    lengths = np.linalg.norm(np.diff(here.x, axis=1), axis=0)
    strain = 0.0 if stiffness == INF else 1e-6
    assert np.abs(np.delete(lengths, 4) / 0.2 - 1.0).max() < 1e-13 + strain


# -- stars ------------------------------------------------------------------------------------


def test_three_ropes_carry_a_load_as_the_triangle_of_forces_says() -> None:
    """T = W / (3 cos) in every leg of one segment, at the angle that it comes to."""
    scene = star("esdirk3", segments=1, EA=500.0)
    found = static_shape(scene)
    knot, top = found.positions[1], found.positions[0]
    cosine = (top - knot)[2] / np.linalg.norm(top - knot)
    weight = 9.81 * (0.5 + 3 * 0.1)
    assert found.tension[[0, 2, 4]] == pytest.approx(weight / (3.0 * cosine), rel=1e-12)
    assert found.reactions[:, 2] == pytest.approx(9.81 * 0.1 + weight / 3.0, rel=1e-12)
    assert (found.positions[[3, 5]] == knot).all()
    twin = static_shape(
        scene.replace(joints=[], ropes=[rope.replace(loads=[]) for rope in scene.ropes])
    )
    assert twin.tension[0] < 0.5 * found.tension[0]


@pytest.mark.parametrize("method", ["verlet", "esdirk3", "generalized-alpha"])
def test_a_star_swings_and_keeps_its_energy(method: str) -> None:
    """The books close to rounding, the error falls with the step; forces in the knot add up to nothing."""
    errors = []
    for step in (2e-3, 1e-3):
        scene = star(method).replace(**{"run.time_step": step})
        result = simulate(scene)
        scale = float(np.abs(result.energy["kinetic"]).max())
        assert np.abs(result.balance_residual).max() < 1e-13 * max(scale, 1.0)
        forces = result.joint_force("knot")
        assert forces.shape == (result.frames, 3, 3)
        assert np.abs(forces.sum(axis=1)).max() < 1e-12 * np.abs(forces).max()
        errors.append(float(np.abs(result.energy_error).max()) / scale)
    assert errors[1] < 0.3 * errors[0]
    assert errors[1] < 2e-4


def test_at_rest_a_star_stays_and_its_knot_is_held_by_what_hangs() -> None:
    """From its equilibrium nothing moves; without the joint the legs would swing apart."""
    scene = star("esdirk3").replace(**{"run.start": "at-rest"})
    simulation = Simulation(scene)
    before = simulation.arrays.x.copy()
    simulation.step(0.1)
    assert np.abs(simulation.arrays.x - before).max() < 1e-11


def test_an_anchor_on_a_joint_holds_all_that_it_ties_until_it_lets_go() -> None:
    """Its reaction is the sum of the joint's forces; then all fall together as one body would."""
    for method in ("semi-implicit-euler", "rk4", "esdirk3"):
        scene = star(method)
        held = Anchor(name="hand", rope="leg1", node=-1, release_time=0.05)
        scene = scene.replace(anchors=[held], **{"run.duration": 0.1})
        result = simulate(scene)
        forces, reaction = result.joint_force("knot").sum(axis=1), result.reactions[:, 0]
        hold = result.time <= 0.0501
        assert np.abs(forces[hold] - reaction[hold]).max() < 1e-12
        assert reaction[2, 2] > 4.0
        assert np.abs(forces[~hold]).max() < 1e-12
        knot = np.asarray(result.positions)[:, [6, 13, 20]]
        assert (knot == knot[:, :1]).all()
        assert (knot[hold] == knot[0]).all()
        assert knot[-1, 0, 2] < knot[0, 0, 2] - 1e-3
        momentum = np.asarray(result.momentum)[-1]
        fall = 9.81 * 1.1 * 0.05
        steps = 2e-2 if method == "semi-implicit-euler" else 1e-6
        change = momentum - np.asarray(result.momentum)[hold][-1]
        assert change[2] == pytest.approx(-fall, rel=steps)


@pytest.mark.parametrize("method", ["semi-implicit-euler", "bdf2", "adaptive"])
def test_a_joint_that_is_cut_lets_its_ropes_go_their_own_ways(method: str) -> None:
    """As ropes that were never tied do from there; in an island beside another rope, too."""
    scene = star(method)
    other = Rope(
        name="other", segments=2, length=1.0, made_of=Material(EA=100, mass_per_length=0.1)
    )
    scene = scene.replace(
        ropes=[other, *scene.ropes], anchors=[Anchor(rope="other", node=0), *scene.anchors]
    )
    simulation = Simulation(scene)
    simulation.step(0.02)
    simulation.cut_joint("knot")
    x, v = simulation.arrays.x.copy(), simulation.arrays.v.copy()
    simulation.step(0.03)
    found = simulation.arrays
    assert np.abs(found.x[:, 9] - found.x[:, 16]).max() > 1e-3
    assert (found.joint_force == 0.0).all()
    ropes = []
    for rope, span in zip(scene.ropes, simulation.layout.ropes, strict=True):
        nodes = range(span.first, span.last + 1)
        shape = Points(points=[tuple(float(c) for c in x[:, i]) for i in nodes])
        kicks = [
            {"node": i - span.first, "velocity": tuple(float(c) for c in v[:, i])} for i in nodes
        ]
        ropes.append(rope.replace(shape=shape, kicks=kicks))
    alone = final(scene.replace(ropes=ropes, joints=[]), 0.03).arrays
    assert np.abs(alone.x - found.x).max() < (1e-12 if METHODS[method].fixed else 1e-6)
    with pytest.raises(KeyError, match="no joint 'not'"):
        simulation.cut_joint("not")


def test_live_edits_keep_joints() -> None:
    """A load, a pin and a cut rope carry over; what is tied stays tied, and segments stay as many."""
    scene = star("verlet")
    before = Simulation(scene)
    before.step(0.02)
    loaded = edits.load(edits.neutral(scene), before.layout, 3, 0.2)
    after = carry_over(before, loaded.scene, loaded.source)
    assert (after.arrays.x == before.arrays.x).all()
    after.step(0.02)
    assert together(after)
    cutting = edits.cut(loaded.scene, after.layout, 17)  # a segment of the last leg
    parts = carry_over(after, cutting.scene, cutting.source)
    assert [tie.rope for tie in parts.scene.joints[0].points] == ["leg0", "leg1", "leg2-2"]
    parts.step(0.02)
    assert together(parts)
    pinned = edits.pin(cutting.scene, parts.layout, 6, "pin1")
    held = carry_over(parts, pinned.scene, pinned.source)
    place = held.arrays.x[:, 6].copy()
    held.step(0.02)
    assert together(held)
    assert (held.arrays.x[:, 13] == place).all()
    with pytest.raises(SceneError, match="while joints tie the rope"):
        resegment(scene, 0, 12)


# -- loops --------------------------------------------------------------------------------------


@pytest.mark.parametrize("method", ["rk4", "verlet", "esdirk3"])
def test_a_closed_rope_spins_with_the_tension_that_keeps_it_round(method: str) -> None:
    """T = mu v^2, corrected for the polygon; it stays round, and keeps energy and momentum."""
    scene, tension = loop(method)
    result = simulate(scene)
    assert tension == pytest.approx(0.2 * (6.0 * 0.5) ** 2, rel=5e-3)
    assert np.asarray(result.tension) == pytest.approx(tension, rel=5e-5)
    places = np.asarray(result.positions)
    assert np.linalg.norm(places, axis=2) == pytest.approx(0.5, rel=1e-7)
    assert np.abs(result.momentum).max() < 1e-13
    spin = np.asarray(result.angular_momentum)[:, 2]
    assert np.ptp(spin) < 1e-7 * spin[0]
    turned = math.atan2(places[-1, 0, 1], places[-1, 0, 0])
    assert turned == pytest.approx(6.0 * 0.2, abs=1e-4)
    open_end = simulate(scene.replace(joints=[]))  # the twin: it flies apart
    assert np.ptp(np.linalg.norm(np.asarray(open_end.positions)[-1], axis=1)) > 1e-2


# -- nets ---------------------------------------------------------------------------------------


def test_a_net_sags_as_a_membrane_with_the_second_order() -> None:
    """-tension lap w = p on a square of side a: w = 0.0736713 p a^2 / tension in the middle.

    S. Timoshenko and J. Goodier, Theory of Elasticity, sec. 111 (torsion of a square bar, the same equation).
    """
    exact, sags = 0.0736713532 * 1e-3, []
    for cells in (4, 8, 20):
        found = static_shape(net(cells))
        assert found.solved
        sags.append(-float(found.positions[:, 2].min()))
    errors = [abs(sag / exact - 1.0) for sag in sags]
    assert errors[2] < 3e-3
    order = math.log(errors[0] / errors[2]) / math.log(20 / 4)
    assert 1.8 < order < 2.2, errors
    assert math.log(errors[0] / errors[1]) / math.log(2.0) == pytest.approx(2.0, abs=0.25)


def test_a_net_at_rest_stays_at_rest() -> None:
    """Through the solver of the implicit methods, with its fill."""
    scene = net(8).replace(**{"run.start": "at-rest"})
    simulation = Simulation(scene)
    before = simulation.arrays.x.copy()
    simulation.step(0.05)
    assert np.abs(simulation.arrays.x - before).max() < 1e-12
    assert together(simulation)


# -- what holds in any scene --------------------------------------------------------------------


@pytest.mark.parametrize("method", METHODS)
def test_random_ropes_stay_tied_and_their_books_close(method: str) -> None:
    """Seeds of trees with all that ropes can have; free ones keep their momentum."""
    for seed in range(6):
        scene = random_scene(seed, method)
        assert scene.joints, seed
        simulation = Simulation(scene)
        start = (simulation.arrays.v * simulation.arrays.mass).sum(axis=1)
        simulation.step(0.03)
        assert together(simulation), seed
        state = simulation.arrays
        if not scene.anchors:
            moved = (state.v * state.mass).sum(axis=1) - start
            assert np.abs(moved).max() < 1e-13, seed
        result = simulate(scene)
        scale = max(float(np.abs(result.energy["kinetic"]).max()), 1e-3)
        assert np.abs(result.balance_residual).max() < 1e-10 * scale, seed


def test_what_is_tied_has_the_same_bits_alone_and_beside_another_rope() -> None:
    """An island of joined ropes is left alone by what is not tied to it."""
    for method in ("verlet", "bdf2"):
        alone = star(method)
        other = Rope(
            name="other", segments=3, length=1.0, made_of=Material(EA=1e3, mass_per_length=1)
        )
        beside = alone.replace(
            ropes=[other, *alone.ropes],
            anchors=[Anchor(name="hook", rope="other", node=0), *alone.anchors],
        )
        one, two = final(alone).arrays, final(beside).arrays
        assert (one.x == two.x[:, 4:]).all()
        assert (one.joint_force == two.joint_force).all()


@pytest.mark.parametrize("method", ["semi-implicit-euler", "verlet", "rk4"])
def test_the_bound_of_the_ropes_apart_holds_for_joined_ones(method: str) -> None:
    """Rayleigh: what is tied moves in a subspace. At 0.98 of the bound nothing grows; far above it does."""
    scene = star(method, load=0.0, axial_damping=0.0)
    model = build(scene)
    step = 0.98 * predicted_step(model.system, model.state, method, 1.0)
    scene = scene.replace(**{"run.steps": "exact", "run.duration": 400 * step})
    calm = simulate(scene.replace(**{"run.time_step": step}))
    energy = np.asarray(calm.energy["total"])
    assert np.ptp(energy) < 0.3 * float(np.abs(calm.energy["kinetic"]).max())
    wild = Simulation(scene.replace(**{"run.time_step": 1.6 * step}))
    with pytest.raises(Exception, match="broke"):
        wild.step(800 * step)


# -- modes, files, faults -----------------------------------------------------------------------


def test_modes_of_a_joined_rope_are_those_of_the_uncut_one() -> None:
    """The same frequencies, and shapes that do not tear at the joint."""
    anchors = [Anchor(rope="rope", node=0), Anchor(name="end", rope="rope", node=-1)]
    whole = modes(uncut("esdirk3").replace(anchors=anchors), count=6)
    tied = [Anchor(rope="first", node=0), Anchor(name="end", rope="second", node=-1)]
    parts = modes(cut("esdirk3").replace(anchors=tied), count=6)
    assert parts.frequencies == pytest.approx(whole.frequencies, rel=1e-9)
    assert (parts.shapes[:, 4] == parts.shapes[:, 5]).all()
    assert np.abs(parts.shapes[:, 4]).max() > 0.1


def test_forces_of_joints_are_kept_in_files_and_tables(tmp_path: Path) -> None:
    """A run folder and a table hold them; a scene comes back from its text."""
    scene = star("verlet")
    assert loads(dumps(scene)) == scene
    result = simulate(scene)
    saved = result.save(tmp_path / "run")
    assert (rw.Result.open(tmp_path / "run").joint_forces == result.joint_forces).all()
    result.export("csv", tmp_path / "csv")
    table = (tmp_path / "csv" / "joints.csv").read_text().splitlines()
    assert table[0] == "time [s],tie,fx [N],fy [N],fz [N]"
    assert table[1].split(",")[1] == "knot:leg0[6]"
    assert len(saved.to_pandas("joints")) == 3 * result.frames
    assert saved.datasets["joints"]["joint_forces"].dims == ("time", "tie", "axis")
    assert "joint_forces" not in saved.datasets["run"]
    assert saved.dataset["joint_forces"].shape == (result.frames, 3, 3)


def test_faults_of_joints_are_told_by_path() -> None:
    """Each with what is wrong and what to do."""
    scene = star("verlet")
    knot = scene.joints[0]

    def told(**changes: object) -> str:
        with pytest.raises(SceneError) as error:
            Simulation(scene.replace(**changes))
        return str(error.value)

    other = tie("more", ("leg0", -1), ("leg1", 0))
    assert "joint[1].points[0].node: -1 - is tied by joint[0] already" in told(joints=[knot, other])
    assert "no such rope" in told(joints=[tie("a", ("leg0", 0), ("leg", 0))])
    assert "must be from 0 to 6" in told(joints=[tie("a", ("leg0", 0), ("leg1", 9))])
    assert "is points[0] already" in told(joints=[tie("a", ("leg0", 3), ("leg0", 3))])
    assert "neighbour of points[0]" in told(joints=[tie("a", ("leg0", 3), ("leg0", 4))])
    assert "is the name of joint[0] already" in told(
        joints=[knot, tie("knot", ("leg0", 2), ("leg1", 2))]
    )
    assert "points" in told(joints=[{"points": [Tie(rope="leg0", node=1)]}])
    apart = told(joints=[tie("a", ("leg0", -1), ("leg1", 3))])
    assert 'joint[0].points[1]: "node 3 of leg1" - lies at' in apart
    assert "m from points[0] at (" in apart
    two = [
        *scene.anchors,
        Anchor(name="a", rope="leg0", node=-1),
        Anchor(name="b", rope="leg2", node=-1),
    ]
    assert "leave out one of the two" in told(anchors=two)
    winch = {"rope": "leg0", "end": "end", "speed": 0.1}
    drum = Anchor(name="drum", rope="leg0", node=-1)
    assert "joint[0].points[0].node: -1 - is where a winch's drum is" in told(
        winches=[winch], anchors=[*scene.anchors, drum]
    )
    kicked = [
        rope.replace(kicks=[{"node": -1, "velocity": (k, 0, 0)}])
        for k, rope in enumerate(scene.ropes)
    ]
    assert "begins with another velocity" in told(ropes=kicked)
