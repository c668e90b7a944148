"""What an anchor or a drum holds is where it is held: no obstacle pushes on it, whatever it stands in.

A stake at the height of a floor, a rope tied to a post: their middle is half a diameter inside the body. Its
push, EA / segment times that, went into the anchor's reaction and all that is made from it.
"""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.analysis.check import check
from ropewalk.laws.contact_books import ENTRIES
from ropewalk.laws.hardening import squeezed
from ropewalk.methods.verdict import energy_now
from ropewalk.record.moving_rows import axle_loads
from ropewalk.scene import (
    Anchor,
    Box,
    Cylinder,
    Ground,
    Load,
    Material,
    Plane,
    Rope,
    RunSettings,
    Scene,
    SceneError,
    Sphere,
    Spin,
    Straight,
    Velocity,
    Winch,
    save,
)
from ropewalk.simulation import Simulation
from ropewalk.statics import static_shape

g, D, RADIUS = 9.81, 0.01, 0.05
FLOOR = Plane(name="floor")


def stake(*bodies: Any, EA: float = 1e4, anchors: Any = None, **run: Any) -> Scene:
    """A rope from a stake at the height of a floor up to a hook, a little slack."""
    rope = Rope(
        segments=6,
        length=1.0,
        diameter=D,
        made_of=Material(EA=EA, mass_per_length=0.1, axial_damping=1.0),
        shape=Straight(start=(0, 0, 0), end=(0.8, 0, 0.55)),
    )
    settings = {"duration": 0.5, "frame_rate": 60.0, "time_step": 0.005, "method": "esdirk3"} | run
    return Scene(
        ropes=[rope],
        anchors=anchors or [Anchor(node=0), Anchor(node=-1)],
        obstacles=bodies,
        run=RunSettings(**settings),
    )


@pytest.mark.parametrize(
    ("method", "step"), [("verlet", 1e-4), ("implicit-euler", 5e-3), ("esdirk3", 5e-3)]
)
def test_a_stake_on_a_floor_bears_what_the_rope_pulls(method: str, step: float) -> None:
    """300 N of the floor's were in its reaction, of a rope that pulls with 12."""
    EA = 200.0 if method == "verlet" else 1e4
    with_floor, alone = (
        rw.simulate(stake(*bodies, EA=EA, method=method, time_step=step, duration=0.3))
        for bodies in ([FLOOR], [])
    )
    assert np.abs(alone.reactions[:, 0]).max() > 1.0
    np.testing.assert_allclose(with_floor.reactions, alone.reactions, rtol=1e-9, atol=1e-9)
    assert not with_floor.contact_force.any()
    assert not with_floor.to_pandas("contacts").size
    for name, work in with_floor.contact_work["floor"].items():
        assert not work.any(), name


def test_a_stake_on_a_floor_comes_to_rest() -> None:
    """It was refused, with a compliance to give that grew less with every one that was given."""
    with_floor, alone = (rw.equilibrium(stake(*bodies)) for bodies in ([FLOOR], []))
    np.testing.assert_allclose(with_floor.reactions, alone.reactions, rtol=1e-6, atol=1e-9)
    np.testing.assert_allclose(with_floor.positions, alone.positions, atol=1e-6)
    assert not with_floor.contact_force.any()
    started = rw.simulate(stake(FLOOR, start="at-rest", duration=0.1))
    np.testing.assert_allclose(started.reactions[-1], alone.reactions[0], atol=1e-5)
    assert not [one for one in check(stake(FLOOR)).warnings if "pressed" in one]


def test_a_stake_on_a_floor_leaves_the_rope_its_span() -> None:
    """Its sag was not told: the floor that it stands in counted as what it lies on. The twin lies on one."""
    with_floor, alone = (static_shape(stake(*bodies)).spans for bodies in ([FLOOR], []))
    assert [str(one) for one in with_floor] == [str(one) for one in alone]
    assert alone[0].sag > 0.1
    below = stake(Plane(name="floor", point=(0, 0, -0.1)))
    long = static_shape(below.replace(**{"rope.length": 1.3}))
    assert long.contacts.node.size
    assert not long.spans


def test_what_nothing_holds_is_pushed_still() -> None:
    """The same rope, its lower end free, lies on the floor with that, which bears what of it is there."""
    floor = Plane(name="floor", point=(0, 0, -0.5 * D))
    loose = rw.simulate(stake(floor, anchors=[Anchor(node=-1)], duration=1.5))
    lies = loose.contact_force[-1, :, 2]
    assert lies[0] == pytest.approx(0.5 * 0.1 * g / 6.0, rel=1e-3)  # half a segment
    assert lies[1] == pytest.approx(0.1 * g / 6.0, rel=1e-3)
    assert loose.positions[-1, 0, 2] == pytest.approx(0.0, abs=0.01 * D)
    rest = rw.equilibrium(loose.scene)
    borne = rest.contact_force[0, :, 2].sum() + rest.reactions[0, 0, 2]
    assert borne == pytest.approx(0.1 * g, rel=1e-3)
    assert rest.contact_force[0, 0, 2] == pytest.approx(lies[0], rel=0.01)


@pytest.mark.parametrize(
    ("method", "step"), [("verlet", 1e-5), ("implicit-euler", 1e-3), ("esdirk3", 1e-3)]
)
def test_a_stake_that_lets_go_in_a_floor(method: str, step: float) -> None:
    """It begins to be pushed then. What the contact has stored is given by the body: no work, and no loss."""
    anchors = [Anchor(node=0, release_time=0.1), Anchor(node=-1)]
    scene = stake(FLOOR, anchors=anchors, EA=200.0, method=method, time_step=step, duration=0.3)
    run = rw.simulate(scene)
    assert run.facts.status == "finished"
    assert not run.contact_force[:7].any()
    assert run.positions[7, 0, 2] > 0.006
    assert run.positions[-1, 0, 2] > 0.0049
    assert np.abs(run.balance_residual).max() < 1e-9
    books, table = run.contact_work["floor"], Simulation(scene).system.node.obstacle
    assert set(books) == set(ENTRIES)
    np.testing.assert_allclose(sum(books.values()), run.work["obstacle"], atol=1e-12)
    stored = squeezed(table, 0, 0, 0.5 * D)[2]
    np.testing.assert_allclose(books["motor"][7:], stored, rtol=0.01)  # it has begun to fall
    assert (np.diff(books["normal"]) < 1e-9).all()
    assert books["normal"][7] > -stored
    assert (np.diff(books["friction"]) < 1e-9).all()


@pytest.mark.parametrize("depth", [1e-4, 1e-3])
def test_what_lets_go_on_a_belt_goes_along_with_it(depth: float) -> None:
    """Nothing depends on how fast all of it moves: the belt's way before the release is no slip."""
    runs = {}
    for u in (0.0, 1.0):
        along = Velocity(velocity=(u, 0, 0))
        start = (0.0, 0.0, 0.5 * D - depth)
        rope = Rope(
            segments=6,
            length=1.0,
            diameter=D,
            made_of=Material(EA=1e4, mass_per_length=0.1, axial_damping=1.0),
            shape=Straight(start=start, end=(0.8, 0, 0.55), velocity=(u, 0, 0)),
            loads=[Load(node=0, mass=0.5)],
        )
        runs[u] = rw.simulate(
            Scene(
                ropes=[rope],
                anchors=[
                    Anchor(node=0, motion=along, release_time=0.02),
                    Anchor(node=-1, motion=along),
                ],
                obstacles=[Plane(name="floor", friction=0.5, motion=along)],
                run=RunSettings(duration=0.05, frame_rate=200.0, time_step=0.005, method="esdirk3"),
            )
        )
    still, moving = runs[0.0], runs[1.0]
    over = moving.velocities - (1.0, 0.0, 0.0)
    np.testing.assert_allclose(over, still.velocities, atol=1e-7)
    rubbed = [run.contact_work["floor"]["friction"] for run in (still, moving)]
    np.testing.assert_allclose(rubbed[1], rubbed[0], atol=1e-7)
    assert (np.diff(rubbed[1]) < 1e-9).all()


@pytest.mark.parametrize("height", [0.005, -0.005])
def test_an_anchor_stands_on_either_side_of_a_bars_axis(height: float) -> None:
    """The segment that comes out of the bar is held in it: that nothing holds it there was the refusal."""
    rope = Rope(
        segments=4,
        length=0.6,
        diameter=D,
        made_of=Material(EA=1e4, mass_per_length=0.1, axial_damping=10.0),
        shape=Straight(start=(0, 0, height), direction=(1, 0, 0)),
        loads=[Load(node=-1, mass=0.1)],
    )
    bar = Cylinder(name="bar", start=(0, -1, 0), end=(0, 1, 0), radius=0.03)
    run = RunSettings(duration=0.5, frame_rate=60.0, time_step=0.005, method="esdirk3")
    scene = Scene(ropes=[rope], anchors=[Anchor(node=0)], obstacles=[bar], run=run)
    assert rw.simulate(scene).status == "finished"
    assert rw.equilibrium(scene).reactions[0, 0, 2] == pytest.approx(0.16 * g, rel=1e-6)


@pytest.mark.parametrize(("half", "edge"), [((0.2, 0.05, 0.05), 0.005), ((0.2, 0.2, 0.004), 0.002)])
def test_an_anchor_on_a_surface_stands_in_no_body(
    half: tuple[float, float, float], edge: float
) -> None:
    """Its gap is 1e-18 m or -1e-18: one rope of the two was let through what it stood on."""

    def hung(deep: float) -> Scene:
        rope = Rope(
            segments=4,
            length=0.6,
            diameter=D,
            made_of=Material(EA=1e4, mass_per_length=0.1, axial_damping=10.0),
            shape=Straight(start=(0, 0, half[2] - deep), direction=(0, 0, -1)),
        )
        box = Box(name="beam", center=(0, 0, 0), half_sizes=half, edge_radius=edge)
        run = RunSettings(duration=0.005, time_step=0.005, method="esdirk3")
        return Scene(ropes=[rope], anchors=[Anchor(node=0)], obstacles=[box], run=run)

    with pytest.raises(SceneError, match="segment 0.*goes through obstacle 'beam'"):
        Simulation(hung(0.0))
    assert rw.simulate(hung(0.001)).status == "finished"  # it stands in the beam


def tied(spin: Spin | None = None, **more: Any) -> Scene:
    """A kilogram on a rope that is tied to the side of a bar."""
    rope = Rope(
        segments=6,
        length=0.6,
        diameter=D,
        made_of=Material(EA=1e4, mass_per_length=0.1, axial_damping=10.0),
        shape=Straight(start=(RADIUS, 0, 0), end=(RADIUS, 0, -0.6)),
        loads=[Load(node=-1, mass=1.0)],
    )
    bar = Cylinder(name="bar", start=(0, -1, 0), end=(0, 1, 0), radius=RADIUS, spin=spin)
    settings = {"duration": 0.5, "frame_rate": 60.0, "time_step": 0.005, "method": "esdirk3"}
    common = {"ropes": [rope], "anchors": [Anchor(node=0)], "obstacles": [bar]}
    return Scene(**(common | {"run": RunSettings(**settings)} | more))


def test_a_rope_tied_to_a_bar_pulls_with_its_load() -> None:
    """300 N stood for the largest force of an anchor."""
    run = rw.simulate(tied())
    alone = rw.simulate(tied(obstacles=[]))
    size = np.linalg.norm(run.reactions, axis=2)
    assert 9.0 < size.max() < 22.0
    np.testing.assert_allclose(run.reactions, alone.reactions, atol=1e-9)


def test_a_bar_that_turns_freely_bears_what_lies_on_it_alone() -> None:
    """Nothing does but what is held, which its anchor bears: 300 N stood for the load on its axle."""
    run = rw.simulate(tied(Spin(free=True, inertia=1e-3, rate=3.0)))
    assert axle_loads(run, range(run.frames)).max() < 1e-9
    motion = run.pulley("bar")
    np.testing.assert_allclose(motion.speed, 3.0, rtol=1e-12)  # nor is it braked


@pytest.mark.parametrize("method", ["verlet", "implicit-euler", "esdirk3"])
def test_rope_that_waits_on_a_drum_touches_nothing(method: str) -> None:
    """Six nodes of 300 N were in the tables, and a wrap of them. What comes off begins to, and what goes on
    ceases: no energy is made of that."""
    for speed in (0.2, -0.2):
        winch = Winch(end="start", speed=speed, on_drum=0.6)
        scene = tied(winches=[winch])
        step = 2e-5 if method == "verlet" else 5e-3
        scene = scene.replace(run=scene.run.replace(method=method, time_step=step))
        run, alone = rw.simulate(scene), rw.simulate(scene.replace(obstacles=[]))
        table = run.to_pandas("contacts")
        held = [span.spare_start for span in run.layout.ropes]
        assert held[0] > 0
        assert not (table["node"] < 0).any()
        assert (table["normal force [N]"] < 30.0).all()
        assert np.abs(run.reactions).max() < np.abs(alone.reactions).max() + 5.0
        assert np.abs(run.balance_residual).max() < 1e-8
        wraps = run.to_pandas("wraps")
        assert not (wraps["first node"] < 0).any()


@pytest.mark.parametrize("method", ["semi-implicit-euler", "implicit-euler", "esdirk3"])
def test_an_anchor_that_moves_through_a_floor_gives_nothing_to_it(method: str) -> None:
    """Its energy was that of a spring under the anchor: the anchor gave it, and had it back."""
    down = Velocity(velocity=(0.0, 0.0, -0.1))
    step = 1e-5 if method == "semi-implicit-euler" else 1e-3
    scene = stake(
        FLOOR, EA=200.0, method=method, time_step=step, duration=0.2,
        anchors=[Anchor(node=0, motion=down), Anchor(node=-1)],
    )  # fmt: skip
    simulation, alone = Simulation(scene), Simulation(scene.replace(obstacles=[]))
    for _ in range(10):
        for one in (simulation, alone):
            one.advance_frames(1)
        energies = [energy_now(one.system, one.arrays) for one in (simulation, alone)]
        assert energies[0] == pytest.approx(energies[1], rel=1e-9)
    assert math.isclose(simulation.arrays.x[2, 0], -0.1 * simulation.time, rel_tol=1e-9)


def let_go(
    body: Any, *, motion: Any = None, time: float = 0.1, height: float = 0.1, rise: float = 0.0
) -> Scene:
    """A rope along x whose start an anchor holds at (-0.5, 0, height) [m] and lets go."""
    rope = Rope(
        segments=10,
        length=1.0,
        diameter=D,
        made_of=Material(EA=1e4, mass_per_length=0.1, axial_damping=1.0),
        shape=Straight(start=(-0.5, 0, height), end=(0.5, 0, height + rise)),
    )
    moved = {"motion": motion} if motion else {}
    anchors = [Anchor(node=0, release_time=time, **moved), Anchor(node=-1)]
    run = RunSettings(duration=0.3, frame_rate=60.0, time_step=0.001, method="esdirk3")
    return Scene(ropes=[rope], anchors=anchors, obstacles=[body], run=run)


def test_a_release_inside_a_body_is_refused() -> None:
    """It was thrown out at 34 m/s, with 48.9 J from nothing."""
    ball = Sphere(name="ball", center=(-0.55, 0, 0.1), radius=0.08)
    with pytest.raises(
        SceneError, match=r"anchor\[0\].release_time: 0.1 - lets go 35 mm inside"
    ) as said:
        Simulation(let_go(ball))
    assert "obstacle 'ball'" in str(said.value)
    assert "move the anchor or the obstacle" in str(said.value)
    assert rw.simulate(let_go(ball, time=0.3)).status == "finished"  # as the run ends


def test_where_anchor_and_body_are_at_the_release_decides() -> None:
    ball = Sphere(name="ball", center=(-0.55, 0, 0.1), radius=0.08)
    out = Velocity(velocity=(0.0, 0.0, 1.5))
    scene = let_go(ball, motion=out)
    assert rw.simulate(scene).status == "finished"  # 0.15 m higher by then
    with pytest.raises(SceneError, match="lets go"):
        Simulation(let_go(ball, motion=out, time=0.01))
    coming = ball.model_copy(update={"center": (-0.55, 0, -0.05), "motion": out})
    with pytest.raises(SceneError, match="lets go 35 mm inside"):
        Simulation(let_go(coming))
    assert rw.simulate(let_go(coming, time=0.01)).status == "finished"


def test_an_anchor_that_the_ground_stops_lets_go_there() -> None:
    """Without the ground it would be 0.3 m below what it stands on."""
    down = Velocity(velocity=(0.0, 0.0, -2.0))
    below = Plane(name="below", point=(0, 0, -0.3))
    scene = let_go(below, motion=down, time=0.25).replace(ground=Ground(height=0.0, repulsion=1e4))
    with pytest.raises(SceneError, match="lets go 105 mm inside obstacle 'below'"):
        Simulation(scene)
    stopped = scene.replace(**{"anchor[0].above_ground": True})
    with pytest.raises(SceneError, match="lets go 105 mm inside"):
        Simulation(stopped.replace(ground=None))
    result = rw.simulate(stopped)
    assert result.status == "finished"
    assert result.positions[:, 0, 2].min() == pytest.approx(0.0, abs=0.05)


def test_a_release_half_a_diameter_inside_is_told_of() -> None:
    """A stake at the height of a floor: what the contact gives it is no more than is told."""
    scene = let_go(FLOOR, height=0.0, rise=0.3)
    (said,) = (one for one in check(scene, measure=False).warnings if "lets go" in one)
    assert said.startswith("anchor[0].release_time: 0.1 s - it lets go 5 mm inside 'floor'")
    assert "hold it 5 mm farther out" in said
    most = float(said.split("up to ")[1].split(" ")[0])
    assert 1.0 < np.abs(rw.simulate(scene).velocities[:, 0, 2]).max() < most
    above = check(let_go(FLOOR, height=0.5 * D, rise=0.3), measure=False)
    assert not [one for one in above.warnings if "lets go" in one]


@pytest.mark.parametrize(
    ("do", "x", "path"),
    [
        *((do, 0.0, "rope[0].") for do in (rw.simulate, rw.check, rw.equilibrium, rw.modes)),
        *((do, -0.55, "anchor[0].release_time: 0.1 - ") for do in (rw.simulate, rw.check)),
    ],
)
def test_what_is_wrong_with_a_file_names_it(do: Any, x: float, path: str, tmp_path: Path) -> None:
    """That a rope starts inside an obstacle is found when the scene is built; that it is let go there, too,
    but not of a rest, which knows no time.
    """
    file = tmp_path / "ball.toml"
    save(let_go(Sphere(name="ball", center=(x, 0, 0.1), radius=0.08)), file)
    with pytest.raises(SceneError) as said:
        do(str(file))
    assert str(said.value).startswith(f"{file}: {path}")
    with pytest.raises(SceneError, match="ball.toml: "):
        rw.run(file, tmp_path / "run")
    assert not (tmp_path / "run").exists()
